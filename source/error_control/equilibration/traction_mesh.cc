// SPDX-License-Identifier: LGPL-2.1-or-later
// The tractions on the edges of a mesh with hanging nodes, and what its cells see of them.

#include <signorini/error_control/equilibration/traction_mesh.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
std::vector<double> legendre_values(const unsigned int degree, const double s) {
  const double x = 2. * s - 1.;
  std::vector<double> values = {1., x};
  for (unsigned int n = 1; n < degree; ++n)
    values.push_back(((2. * n + 1.) * x * values[n] - n * values[n - 1]) / (n + 1.));
  values.resize(degree + 1);
  for (unsigned int n = 0; n <= degree; ++n)
    values[n] *= std::sqrt(2. * n + 1.);
  return values;
}

namespace {
/** Returns whether τ_nn and τ_nt are unknown on a side with this role. */
std::array<bool, 2> freedom_on(const Role role) {
  const bool is_held = role == Role::clamped || role == Role::displacement;
  return {{is_held || role == Role::roller, is_held}};
}

FullMatrix<double> make_restriction(const unsigned int degree, const double from, const double to) {
  FullMatrix<double> R(degree + 1, degree + 1);
  const QGauss<1> gauss(degree + 1);
  for (unsigned int q = 0; q < gauss.size(); ++q) {
    const double s = gauss.point(q)[0];
    const auto here = legendre_values(degree, s),
               there = legendre_values(degree, from + s * (to - from));
    for (unsigned int i = 0; i <= degree; ++i)
      for (unsigned int j = i; j <= degree; ++j)
        R(i, j) += gauss.weight(q) * here[i] * there[j];
  }
  return R;
}
} // namespace

TractionMesh::TractionMesh(const StressMesh &mesh, const Scene<2> &scene)
  : on_side_(scene.geometry.sides.size())
  , sides_(scene.geometry.sides) {
  constexpr std::array<unsigned int, 4> vertex_in_circle = {{0, 1, 3, 2}},
                                        face_in_circle = {{2, 1, 3, 0}};
  const Triangulation<2> &triangulation = mesh.triangulation();
  edge_of_line_.assign(triangulation.n_raw_lines(), none);
  unsigned int highest = 2;
  for (const auto &cell : triangulation.active_cell_iterators()) {
    TractionCell &here = cells_.emplace_back();
    for (unsigned int k = 0; k < 4; ++k)
      here.corners[k] = cell->vertex(vertex_in_circle[k]);
    const unsigned int degree = mesh.degree(cell);
    here.degree = mesh.inner_degree(cell);
    for (unsigned int k = 0; k < 4; ++k) {
      here.sides[k] = find_side(cell, face_in_circle[k], here.corners[k], scene);
      unsigned int &on_edge = edges_[here.sides[k].edge].degree;
      on_edge = std::max(on_edge, degree);
    }
  }
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

unsigned int TractionMesh::find_edge(const LineIterator &line, const Scene<2> &scene) {
  unsigned int &number = edge_of_line_[line->index()];
  if (number == none) {
    number = edges_.size();
    TractionEdge &edge = edges_.emplace_back();
    edge.start = line->vertex(0);
    edge.end = line->vertex(1);
    if (line->at_boundary()) {
      edge.side = line->boundary_id();
      edge.is_free = freedom_on(scene.boundary[edge.side].role);
      on_side_[edge.side].emplace(
        sides_[edge.side].arc_length(edge.start + 0.5 * (edge.end - edge.start)) -
          0.5 * edge.length(),
        number);
    }
  }
  return number;
}

unsigned int TractionMesh::edge_at(const Triangulation<2>::cell_iterator &cell,
                                   const unsigned int face_no) const {
  const auto face = cell->face(face_no);
  const unsigned int side = face->boundary_id();
  return std::prev(on_side_[side].upper_bound(sides_[side].arc_length(face->center())))->second;
}

TractionSide TractionMesh::find_side(const Triangulation<2>::active_cell_iterator &cell,
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
    return std::round(2. * whole.start.distance(x) / whole.length()) / 2.;
  };
  return {edge, position(reversed ? line->vertex(1) : line->vertex(0)),
          position(reversed ? line->vertex(0) : line->vertex(1))};
}

const FullMatrix<double> &TractionMesh::restriction(const TractionSide &side) const {
  return halves_[side.from + side.to < 1. ? (side.from < side.to ? 0 : 1)
                                          : (side.from < side.to ? 2 : 3)];
}

std::vector<unsigned int> TractionMesh::numbers(const TractionCell &cell) const {
  std::vector<unsigned int> numbers;
  for (const TractionSide &side : cell.sides)
    for (unsigned int c = 0; c < 2; ++c)
      for (unsigned int i = 0; i <= cell.degree; ++i) {
        const TractionEdge &edge = edges_[side.edge];
        numbers.push_back(i <= edge.degree ? edge.position(c, i) : none);
      }
  return numbers;
}

TractionMesh::Vector TractionMesh::traces(const TractionCell &cell, const Vector &x) const {
  Vector traces(n_traces(cell));
  unsigned int row = 0;
  for (const TractionSide &side : cell.sides)
    for (unsigned int c = 0; c < 2; ++c, row += cell.degree + 1) {
      const TractionEdge &edge = edges_[side.edge];
      for (unsigned int j = 0; j <= edge.degree; ++j) {
        const double value = x[edge.position(c, j)];
        if (!side.is_half())
          traces[row + j] = (side.from > side.to && j % 2 == 1 ? -1. : 1.) * value;
        else
          for (unsigned int i = 0; i <= j; ++i)
            traces[row + i] += restriction(side)(i, j) * value;
      }
    }
  return traces;
}

void TractionMesh::restrict_rows(const TractionCell &cell, FullMatrix<double> &M) const {
  const unsigned int n = cell.degree + 1;
  for (unsigned int block = 0; block < 8; ++block) {
    const TractionSide &side = cell.sides[block / 2];
    const unsigned int row = block * n;
    // Row j becomes the sum of R_ij times row i, i ≤ j: from the last one on.
    for (unsigned int j = n; j-- > 0;) {
      const bool is_half = side.is_half() && j <= edges_[side.edge].degree;
      const double factor =
        is_half ? restriction(side)(j, j) : (side.from > side.to && j % 2 == 1 ? -1. : 1.);
      for (unsigned int k = 0; k < M.n(); ++k)
        M(row + j, k) *= factor;
      for (unsigned int i = 0; i < j && is_half; ++i)
        M.add_row(row + j, restriction(side)(i, j), row + i);
    }
  }
}

FullMatrix<double> balance_rows(const CellShape &shape, const unsigned int degree) {
  FullMatrix<double> rows(3, 8 * (degree + 1));
  const Point<2> centre = shape.centre();
  for (unsigned int k = 0; k < 4; ++k) {
    const Point<2> &a = shape.corners[k], &b = shape.corners[(k + 1) % 4];
    const Tensor<1, 2> d = b - a, normal = cross_product_2d(d),
                       arm = 0.5 * (a - centre + (b - centre));
    const unsigned int shear = (2 * k + 1) * (degree + 1), n = 2 * k * (degree + 1);
    // A mean of one gives the force d or its normal; the slope of τ_nn a couple.
    for (unsigned int c = 0; c < 2; ++c) {
      rows(c, n) = normal[c];
      rows(c, shear) = d[c];
    }
    rows(2, n) = cross(arm, normal);
    rows(2, shear) = cross(arm, d);
    rows(2, n + 1) = -d.norm_square() / std::sqrt(12.);
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
