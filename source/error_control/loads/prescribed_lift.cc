// SPDX-License-Identifier: LGPL-2.1-or-later
// The rest of the nodal interpolation of prescribed displacements.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/error_control/loads/prescribed_lift.h>
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

PrescribedLift::PrescribedLift(const BoundData &data, const std::size_t n_cells,
                               const std::vector<PrescribedEdge> &edges)
  : cells_(n_cells, false) {
  constexpr double allowed = 1e-3;
  constexpr unsigned int max_pieces = 32;
  const double scale = data.U.linfty_norm();
  for (const PrescribedEdge &edge : edges) {
    const Function<2> &prescribed = *data.scene.boundary[edge.side].data;
    const auto r = [&](const double s) {
      dealii::Vector<double> u(2);
      prescribed.vector_value(edge.start + s * (edge.end - edge.start), u);
      return Tensor<1, 2>({u[0], u[1]}) - edge.u_h(s);
    };
    const std::size_t n_scanned =
      is_constant(prescribed) ? 0 : std::min<std::size_t>(256, 20000 / edges.size());
    std::vector<Point<1>> scanned;
    if (n_scanned > 0)
      scanned = split_quadrature(QIterated<1>(QMidpoint<1>(), n_scanned),
                                 data.scene.kinks.cut(edge.start, edge.end))
                  .get_points();
    EdgeRest rest = {edge.k, {}};
    double size = 0., misfit = 0.;
    for (unsigned int n_pieces = 1; n_pieces <= max_pieces; n_pieces *= 2) {
      rest.pieces.assign(n_pieces, {});
      for (unsigned int piece = 0; piece < n_pieces; ++piece)
        for (const Point<1> &node : nodes()) {
          rest.pieces[piece].push_back(r((piece + node[0]) / n_pieces));
          size = std::max(size, rest.pieces[piece].back().norm());
        }
      misfit = 0.;
      for (const Point<1> &s : scanned) {
        const Tensor<1, 2> value = r(s[0]);
        size = std::max(size, value.norm());
        misfit = std::max(misfit, (rest.evaluate(s[0], false) - value).norm());
      }
      if (misfit <= allowed * size)
        break;
    }
    // A smaller rest is rounding.
    if (size > 1e-10 * scale)
      max_misfit_ = std::max(max_misfit_, misfit / size);
    if (size > 1e-13 * scale) {
      cells_[edge.cell] = true;
      rests_[edge.cell].push_back(std::move(rest));
    }
  }
}

std::vector<KinkLine<2>> PrescribedLift::lines(const unsigned int cell,
                                               const std::array<Point<2>, 4> &x) const {
  std::vector<KinkLine<2>> lines;
  for (const EdgeRest &rest : rests_.at(cell))
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

Tensor<1, 2> PrescribedLift::value(const unsigned int cell, const Point<2> &at) const {
  Tensor<1, 2> z;
  for (const EdgeRest &rest : rests_.at(cell)) {
    const auto [s, depth] = rest.coordinates(at);
    z += (1. - depth) * rest.evaluate(s, false);
  }
  return z;
}

Components PrescribedLift::strain(const unsigned int cell, const CellShape &shape,
                                  const Point<2> &at) const {
  const Tensor<2, 2> inverse = invert(shape.jacobian(CellFunctions(at)));
  Components e;
  for (const EdgeRest &rest : rests_.at(cell)) {
    const auto [s, depth] = rest.coordinates(at);
    const Tensor<2, 2> gradient = (rest.k < 2 ? 1. : -1.) * (1. - depth) *
                                    outer_product(rest.evaluate(s, true), inverse[rest.k % 2]) -
                                  (rest.k % 3 == 0 ? 1. : -1.) *
                                    outer_product(rest.evaluate(s, false), inverse[1 - rest.k % 2]);
    e += Components({gradient[0][0], gradient[1][1], gradient[0][1] + gradient[1][0]});
  }
  return e;
}
} // namespace Signorini
