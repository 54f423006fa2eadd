// SPDX-License-Identifier: LGPL-2.1-or-later
// The rest of the nodal interpolation of prescribed displacements.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/error_control/equilibration/law.h>
#include <signorini/error_control/equilibration/prescribed_lift.h>
#include <signorini/error_control/equilibration/triangle_parts.h>
#include <signorini/problem/scene/functions.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace Signorini {
namespace {
const std::vector<Point<1>> &nodes() {
  static const std::vector<Point<1>> points = QGaussLobattoChebyshev<1>(9).get_points();
  return points;
}
} // namespace

Tensor<1, 2> PrescribedLift::EdgeRest::evaluate(const double s, const bool derivative) const {
  static const auto basis = Polynomials::generate_complete_Lagrange_basis(nodes());
  const double position = s * pieces.size();
  const unsigned int piece = std::clamp<int>(position, 0, pieces.size() - 1);
  Tensor<1, 2> sum;
  std::vector<double> value_and_slope(2);
  for (unsigned int i = 0; i < basis.size(); ++i) {
    basis[i].value(position - piece, value_and_slope);
    sum +=
      (derivative ? pieces.size() * value_and_slope[1] : value_and_slope[0]) * pieces[piece][i];
  }
  return sum;
}

PrescribedLift::PrescribedLift(const BoundData &data) {
  const double scale = data.U.linfty_norm();
  std::vector<std::pair<DoFHandler<2>::active_cell_iterator, unsigned int>> edges;
  for (const auto &cell : data.space.dofs().active_cell_iterators())
    for (unsigned int k = 0; k < 4; ++k)
      if (const unsigned int face = face_in_circle[k];
          cell->at_boundary(face) &&
          data.scene.boundary[cell->face(face)->boundary_id()].role == Role::displacement)
        edges.emplace_back(cell, k);
  for (const auto &[cell, k] : edges) {
    EdgeRest rest = {k, {}};
    rest.interpolate(data, cell, face_in_circle[k],
                     std::min<std::size_t>(256, 20000 / edges.size()));
    // A smaller rest is rounding.
    if (rest.size > 1e-10 * scale)
      max_misfit_ = std::max(max_misfit_, rest.misfit / rest.size);
    if (rest.size > 1e-13 * scale)
      rests_[cell->active_cell_index()].push_back(std::move(rest));
  }
}

void PrescribedLift::EdgeRest::interpolate(const BoundData &data,
                                           const DoFHandler<2>::active_cell_iterator &cell,
                                           const unsigned int face, const std::size_t n_scanned) {
  constexpr double allowed = 1e-3;
  constexpr unsigned int max_pieces = 32;
  const auto line = cell->face(face);
  const Function<2> &prescribed = *data.scene.boundary[line->boundary_id()].data;
  const CellField u(cell, data.U);
  const Side<2> edge("", shape_of(cell, data.scene.geometry.sides).edge(k));
  const auto r = [&](const double s) {
    dealii::Vector<double> u_D(2);
    prescribed.vector_value(edge.point(s * edge.length()), u_D);
    // Sides 0 and 1 run along a reference coordinate, 2 and 3 backwards.
    return Tensor<1, 2>({u_D[0], u_D[1]}) - u.on_face(face, k < 2 ? s : 1. - s);
  };
  std::vector<Point<1>> scanned;
  if (n_scanned > 0 && !is_constant(prescribed)) {
    std::vector<double> cuts = data.scene.kinks.cut(edge, 0., edge.length());
    for (double &s : cuts)
      s /= edge.length();
    scanned = split_quadrature(QIterated<1>(QMidpoint<1>(), n_scanned), cuts).get_points();
  }
  for (unsigned int n_pieces = 1; n_pieces <= max_pieces; n_pieces *= 2) {
    pieces.assign(n_pieces, {});
    for (unsigned int piece = 0; piece < n_pieces; ++piece)
      for (const Point<1> &node : nodes()) {
        pieces[piece].push_back(r((piece + node[0]) / n_pieces));
        size = std::max(size, pieces[piece].back().norm());
      }
    misfit = 0.;
    for (const Point<1> &s : scanned) {
      const Tensor<1, 2> value = r(s[0]);
      size = std::max(size, value.norm());
      misfit = std::max(misfit, (evaluate(s[0], false) - value).norm());
    }
    if (misfit <= allowed * size)
      break;
  }
}

std::vector<KinkLine<2>> PrescribedLift::lines(const std::vector<EdgeRest> &rests,
                                               const CellShape &shape) {
  std::vector<KinkLine<2>> lines;
  const auto &x = shape.corners;
  for (const EdgeRest &rest : rests)
    for (unsigned int piece = 1; piece < rest.pieces.size(); ++piece) {
      const double s = static_cast<double>(piece) / rest.pieces.size();
      const unsigned int a = rest.k, b = (a + 1) % 4, c = (a + 2) % 4, d = (a + 3) % 4;
      // Lines of bilinear coordinates are straight.
      const Point<2> from = x[a] + s * (x[b] - x[a]), to = x[d] + s * (x[c] - x[d]);
      const Tensor<1, 2> along = (to - from) / from.distance(to), normal({along[1], -along[0]});
      lines.push_back({normal, normal * (from - Point<2>())});
    }
  return lines;
}

std::array<double, 2> PrescribedLift::EdgeRest::coordinates(const Point<2> &at) const {
  // The axes along edge k and behind it, with their directions.
  const double along = at[k % 2], behind = at[1 - k % 2];
  return {{k < 2 ? along : 1. - along, k % 3 == 0 ? behind : 1. - behind}};
}

void PrescribedLift::visit_cells(const BoundData &data, const ExactMaps &maps,
                                 const std::function<void(const LiftedCell &)> &visit) const {
  const Quadrature<2> rule = triangle_rule(16);
  CellEvaluator<2> u = evaluator_of(data, {{&data.U}}, maps);
  for (const auto &cell : data.space.dofs().active_cell_iterators()) {
    const auto found = rests_.find(cell->active_cell_index());
    if (found == rests_.end())
      continue;
    const CellShape shape(corners_of(cell));
    std::vector<Point<2>> points;
    std::vector<double> weights;
    for (const auto &parts :
         triangle_parts(shape, data.scene.law_kinks.with_lines(lines(found->second, shape))))
      for (const TrianglePart &part : parts)
        add_points(rule, part.corners, shape, points, weights);
    u.reinit_once(cell, Quadrature<2>(points, weights));
    LiftedCell lifted = {u, {}};
    for (unsigned int q = 0; q < u.size(); ++q) {
      Tensor<1, 2> z;
      // With respect to the reference coordinates: a row for each of these.
      Tensor<2, 2> derivatives;
      for (const EdgeRest &rest : found->second) {
        const auto [s, depth] = rest.coordinates(points[q]);
        const Tensor<1, 2> r = rest.evaluate(s, false);
        z += (1. - depth) * r;
        derivatives[rest.k % 2] += (rest.k < 2 ? 1. : -1.) * (1. - depth) * rest.evaluate(s, true);
        derivatives[1 - rest.k % 2] -= (rest.k % 3 == 0 ? 1. : -1.) * r;
      }
      const Law law(data.scene.material->hooke(u.points()[q]));
      const Components strain = components_of(strain_of(u.in_body(transpose(derivatives), q)));
      lifted.points.push_back({u.measure(q), z, strain, law.stiffness * strain});
    }
    visit(lifted);
  }
}
} // namespace Signorini
