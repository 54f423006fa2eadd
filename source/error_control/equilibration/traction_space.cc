// SPDX-License-Identifier: LGPL-2.1-or-later
// The tractions on the edges of a mesh with hanging nodes, and their traces on its cells.

#include <signorini/discretization/mesh/arc_mapping.h>
#include <signorini/error_control/equilibration/arc_lift.h>
#include <signorini/error_control/equilibration/carrier.h>
#include <signorini/error_control/equilibration/edge_polynomials.h>
#include <signorini/error_control/equilibration/traction_space.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace Signorini {
namespace {
/** Returns whether τ_nn and τ_nt are unknown on a side with this role. */
std::array<bool, 2> freedom_on(const Role role) {
  const bool is_held = role == Role::clamped || role == Role::displacement;
  return {{is_held || role == Role::roller, is_held}};
}

FullMatrix<double> make_restriction(const unsigned int degree, const double from, const double to) {
  FullMatrix<double> R(degree + 1, degree + 1);
  for (unsigned int j = 0; j <= degree; ++j) {
    const std::vector<double> column =
      legendre_projection(degree, QGauss<1>(degree + 1), [&](const double s) {
        return legendre_values(degree, from + s * (to - from))[j];
      });
    for (unsigned int i = 0; i <= j; ++i)
      R(i, j) = column[i];
  }
  return R;
}

/** Returns the part of an edge that a shared one gives; none where they do not face each other. */
std::optional<SharedPart> part_of(const TractionEdge &edge, const unsigned int number,
                                  const TractionEdge &shared) {
  // Points that differ by the rounding of coordinates are the same, also on the smallest cells.
  const double rounding =
    1e-10 + 1e-15 * std::max(edge.line.start().norm(), edge.line.end().norm()) / edge.length();
  const auto position = [&](const double on_shared) {
    const double s = edge.position_of(shared.point(on_shared));
    return std::abs(s) < rounding ? 0. : std::abs(s - 1.) < rounding ? 1. : s;
  };
  double start = position(0.), end = position(1.), shared_from = 0., shared_to = 1.;
  if (start > end) {
    std::swap(start, end);
    std::swap(shared_from, shared_to);
  }
  const double from = std::max(0., start), to = std::min(1., end);
  if (to - from < rounding)
    return {};
  const auto on_shared = [&](const double s) {
    return shared_from + (s - start) / (end - start) * (shared_to - shared_from);
  };
  SharedPart part = {
    number,          from,          to,
    on_shared(from), on_shared(to), FullMatrix<double>(edge.degree + 1, shared.degree + 1)};
  const QGauss<1> gauss(std::max(edge.degree, shared.degree) + 1);
  for (unsigned int q = 0; q < gauss.size(); ++q) {
    const double r = gauss.point(q)[0];
    const std::vector<double> L = legendre_values(edge.degree, from + r * (to - from)),
                              M = legendre_values(shared.degree, on_shared(from + r * (to - from)));
    for (unsigned int i = 0; i < L.size(); ++i)
      for (unsigned int j = 0; j < M.size(); ++j)
        part.R(i, j) += gauss.weight(q) * (to - from) * L[i] * M[j];
  }
  return part;
}
} // namespace

TractionSpace::TractionSpace(const EquilibrationMesh &mesh, const Scene<2> &scene)
  : on_side_(scene.geometry.sides.size())
  , sides_(scene.geometry.sides)
  , is_paired_(sides_.size(), false) {
  const Triangulation<2> &triangulation = mesh.triangulation();
  edge_of_line_.assign(triangulation.n_raw_lines(), none);
  for (const auto &cell : triangulation.active_cell_iterators()) {
    cells_.push_back({shape_of(cell, sides_), {}});
    TractionCell &added = cells_.back();
    const unsigned int degree = mesh.degree(cell);
    added.degree = mesh.inner_degree(cell);
    for (unsigned int k = 0; k < 4; ++k) {
      added.sides[k] = find_side(cell, face_in_circle[k], added.shape.corners[k], scene);
      if (added.shape.centres[k])
        added.shape.directions[k] = edges_[added.sides[k].edge].direction;
      unsigned int &on_edge = edges_[added.sides[k].edge].degree;
      on_edge = std::max(on_edge, cell->at_boundary(face_in_circle[k]) ? mesh.boundary_degree(cell)
                                                                       : degree);
    }
  }
  parts_.resize(edges_.size());
  for (const ContactPair<2> &pair : contact_pairs(scene))
    if (const auto &other = pair.other_side()) {
      const unsigned int side = pair.side();
      is_paired_[side] = is_paired_[*other] = true;
      is_carrier(scene, side) ? add_shared_edges(side, *other) : add_shared_edges(*other, side);
    }
  number_coefficients();
}

void TractionSpace::number_coefficients() {
  unsigned int highest = 2;
  for (TractionEdge &edge : edges_) {
    edge.first = n_coefficients_;
    n_coefficients_ += edge.n_coefficients();
    highest = std::max(highest, edge.degree);
  }
  for (TractionCell &cell : cells_)
    for (const TractionSide &side : cell.sides)
      cell.degree = std::max(cell.degree, edges_[side.edge].degree);
  halves_ = {{make_restriction(highest, 0., 0.5), make_restriction(highest, 0.5, 0.),
              make_restriction(highest, 0.5, 1.), make_restriction(highest, 1., 0.5)}};
}

void TractionSpace::add_shared_edges(const unsigned int carrier, const unsigned int other) {
  const Side<2> &side = sides_[carrier];
  const double a = side.arc_length(sides_[other].start()), b = side.arc_length(sides_[other].end()),
               lower = std::max(0., std::min(a, b)),
               upper = std::min(side.length(), std::max(a, b)),
               // No piece of contact is shorter than ten of these.
    sliver = 1e-13 * (upper - lower);
  for (const auto &[start, number] : on_side_[carrier]) {
    const double length = edges_[number].length(), from = std::max(lower, start),
                 to = std::min(upper, start + length);
    if (to - from < std::max(1e-10 * length, sliver))
      continue;
    TractionEdge shared = edges_[number];
    shared.line = side.between(side.point(from), side.point(to));
    shared.is_shared = true;
    const auto add_part_of = [&](const unsigned int edge) {
      if (auto part = part_of(edges_[edge], edges_.size(), shared))
        parts_[edge].push_back(std::move(*part));
    };
    add_part_of(number);
    for (const auto &entry : on_side_[other])
      add_part_of(entry.second);
    edges_.push_back(shared);
    parts_.emplace_back();
  }
}

unsigned int TractionSpace::find_edge(const LineIterator &line, const Scene<2> &scene) {
  unsigned int &number = edge_of_line_[line->index()];
  if (number == none) {
    number = edges_.size();
    const Point<2> &a = line->vertex(0), &b = line->vertex(1);
    if (!line->at_boundary())
      edges_.push_back({Curve(a, b)});
    else {
      const unsigned int side = line->boundary_id();
      const Curve on_side = sides_[side].between(a, b);
      edges_.push_back({on_side, side, 1, 0, freedom_on(scene.boundary[side].role)});
      const double middle = sides_[side].arc_length(a + 0.5 * (b - a)),
                   inside = (0.5 - 1e-9) * on_side.length();
      const ContactDirections<2> directions = directions_on(scene, side);
      edges_.back().direction = directions.at(middle);
      edges_.back().mixes = directions.change_between(middle - inside, middle + inside);
      on_side_[side].emplace(middle - 0.5 * on_side.length(), number);
    }
  }
  return number;
}

unsigned int TractionSpace::edge_at(const Triangulation<2>::cell_iterator &cell,
                                    const unsigned int face_no) const {
  const auto face = cell->face(face_no);
  const unsigned int side = face->boundary_id();
  return std::prev(on_side_[side].upper_bound(sides_[side].arc_length(face->center())))->second;
}

unsigned int TractionSpace::contact_edge_at(const Triangulation<2>::cell_iterator &cell,
                                            const unsigned int face_no) const {
  const unsigned int edge = edge_at(cell, face_no);
  for (const SharedPart &part : parts_[edge])
    if (edges_[part.shared].side == edges_[edge].side)
      return part.shared;
  return is_paired_[edges_[edge].side] ? none : edge;
}

std::vector<unsigned int> TractionSpace::sources(const unsigned int edge) const {
  AssertIndexRange(edge, edges_.size());
  std::vector<unsigned int> numbers;
  for (const SharedPart &part : parts_[edge])
    numbers.push_back(part.shared);
  if (numbers.empty())
    numbers.push_back(edge);
  return numbers;
}

TractionSpace::Vector TractionSpace::gathered(Vector functional) const {
  for (const TractionEdge &edge : edges_)
    if (edge.is_shared)
      std::fill_n(functional.begin() + edge.first, edge.n_coefficients(), 0.);
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (const SharedPart &part : parts_[e])
      for (unsigned int c = 0; c < 2; ++c)
        for (unsigned int j = 0; j < part.R.n(); ++j)
          for (unsigned int i = 0; i < part.R.m(); ++i)
            functional[edges_[part.shared].position(c, j)] +=
              part.R(i, j) * functional[edges_[e].position(c, i)];
  return functional;
}

TractionSide TractionSpace::find_side(const Triangulation<2>::active_cell_iterator &cell,
                                      const unsigned int face_no, const Point<2> &from,
                                      const Scene<2> &scene) {
  const auto line = cell->face(face_no);
  const bool reversed = line->vertex(0).distance(from) > line->vertex(1).distance(from);
  if (cell->at_boundary(face_no) || !cell->neighbor_is_coarser(face_no))
    return {find_edge(line, scene), reversed ? 1. : 0., reversed ? 0. : 1.};
  const unsigned int face = cell->neighbor_of_coarser_neighbor(face_no).first,
                     edge = find_edge(cell->neighbor(face_no)->face(face), scene);
  const TractionEdge &whole = edges_[edge];
  const auto position = [&whole](const Point<2> &x) {
    return std::round(2. * whole.line.start().distance(x) / whole.length()) / 2.;
  };
  return {edge, position(reversed ? line->vertex(1) : line->vertex(0)),
          position(reversed ? line->vertex(0) : line->vertex(1))};
}

std::vector<TractionSpace::Entry> TractionSpace::entries(const TractionCell &cell) const {
  std::vector<Entry> entries;
  unsigned int row = 0;
  for (unsigned int k = 0; k < 4; ++k)
    for (unsigned int c = 0; c < 2; ++c, row += cell.degree + 1) {
      const TractionSide &side = cell.sides[k];
      const TractionEdge &edge = edges_[side.edge];
      const FullMatrix<double> &R =
        halves_[(side.from + side.to < 1. ? 0 : 2) + (side.is_reversed() ? 1 : 0)];
      const auto sign = [&side](const unsigned int i) {
        return side.is_reversed() && i % 2 == 1 ? -1. : 1.;
      };
      for (const SharedPart &part : parts_[side.edge])
        for (unsigned int i = 0; i < part.R.m(); ++i)
          for (unsigned int j = 0; j < part.R.n(); ++j)
            entries.push_back(
              {row + i, edges_[part.shared].position(c, j), sign(i) * part.R(i, j)});
      if (!parts_[side.edge].empty())
        continue;
      if (edge.direction && edge.line.is_flat()) {
        const Tensor<1, 2> along = cell.shape.corners[(k + 1) % 4] - cell.shape.corners[k],
                           t = along / along.norm(), axis = c == 0 ? cross_product_2d(t) : t;
        for (unsigned int d = 0; d < 2; ++d)
          for (unsigned int j = 0; j <= edge.degree; ++j)
            entries.push_back({row + j, edge.position(d, j), sign(j) * (axis * edge.axis(d, {}))});
        continue;
      }
      for (unsigned int j = 0; j <= edge.degree; ++j)
        if (!side.is_half())
          entries.push_back({row + j, edge.position(c, j), sign(j)});
        else
          for (unsigned int i = 0; i <= j; ++i)
            entries.push_back({row + i, edge.position(c, j), R(i, j)});
    }
  return entries;
}

TractionSpace::Vector TractionSpace::traces(const TractionCell &cell, const Vector &x) const {
  Vector traces(8 * (cell.degree + 1));
  for (const Entry &entry : entries(cell))
    traces[entry.trace] += entry.value * x[entry.coefficient];
  return traces;
}

std::vector<Tensor<1, 3>> resultants(const Curve &line, const double side,
                                     const unsigned int degree, const Point<2> &about,
                                     const std::optional<Tensor<1, 2>> &direction) {
  std::vector<Tensor<1, 3>> sums(2 * (degree + 1));
  const QGauss<1> gauss(degree + (line.is_flat() ? 2 : 10));
  for (unsigned int q = 0; q < gauss.size(); ++q) {
    const double s = gauss.point(q)[0], weight = gauss.weight(q) * line.length();
    const Tensor<1, 2> tangent = side * line.tangent(s * line.length(), 0.),
                       m = direction.value_or(Tensor<1, 2>({tangent[1], -tangent[0]})),
                       t = direction_of(Component::tangential, m),
                       arm = line.point(s * line.length()) - about;
    const std::vector<double> L = legendre_values(degree, s);
    for (unsigned int i = 0; i <= degree; ++i) {
      sums[i] += weight * L[i] * Tensor<1, 3>({m[0], m[1], cross(arm, m)});
      sums[degree + 1 + i] += weight * L[i] * Tensor<1, 3>({t[0], t[1], cross(arm, t)});
    }
  }
  return sums;
}

FullMatrix<double> balance_rows(const CellShape &shape, const unsigned int degree) {
  const auto n_arcs = std::count_if(shape.centres.begin(), shape.centres.end(),
                                    [](const auto &centre) { return centre.has_value(); });
  FullMatrix<double> rows(3, 8 * (degree + 1) + ArcLift::n_conditions * n_arcs);
  unsigned int trace = 0, condition = 8 * (degree + 1);
  for (unsigned int k = 0; k < 4; ++k) {
    for (const Tensor<1, 3> &sum :
         resultants(shape.edge(k), 1., degree, shape.crossing, shape.directions[k])) {
      for (unsigned int r = 0; r < 3; ++r)
        rows(r, trace) = sum[r];
      ++trace;
    }
    for (unsigned int r = 0; r < 3 && shape.centres[k]; ++r)
      rows(r, condition + r) = -1.;
    condition += shape.centres[k] ? ArcLift::n_conditions : 0;
  }
  for (unsigned int r = 0; r < 3; ++r) {
    for (unsigned int before = 0; before < r; ++before) {
      double product = 0.;
      for (unsigned int j = 0; j < rows.n(); ++j)
        product += rows(r, j) * rows(before, j);
      rows.add_row(r, -product, before);
    }
    double square = 0.;
    for (unsigned int j = 0; j < rows.n(); ++j)
      square += rows(r, j) * rows(r, j);
    for (unsigned int j = 0; j < rows.n(); ++j)
      rows(r, j) /= std::sqrt(square);
  }
  return rows;
}
} // namespace Signorini
