// SPDX-License-Identifier: LGPL-2.1-or-later
// The rest of the nodal interpolation of prescribed displacements.

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

namespace {
/** Returns the edges of bilinear cells on sides with prescribed displacements. */
std::vector<PrescribedEdge> prescribed_edges(const BoundData &data, const EdgeMesh &mesh) {
  std::vector<PrescribedEdge> edges;
  for (unsigned int c = 0; c < mesh.cells().size(); ++c)
    for (unsigned int k = 0; k < 4; ++k) {
      const EdgeCell &cell = mesh.cells()[c];
      const unsigned int side = mesh.edges()[cell.edges[k]].side, next = (k + 1) % 4;
      if (side == Edge::no_side || data.scene.boundary[side].role != Role::displacement)
        continue;
      std::array<Tensor<1, 2>, 2> u;
      for (unsigned int d = 0; d < 2; ++d) {
        u[0][d] = data.U[mesh.dofs()[cell.vertices[k]][d]];
        u[1][d] = data.U[mesh.dofs()[cell.vertices[next]][d]];
      }
      edges.push_back({c, k, side, cell.corners[k], cell.corners[next],
                       [u](const double s) { return (1. - s) * u[0] + s * u[1]; }});
    }
  return edges;
}
} // namespace

PrescribedLift::PrescribedLift(const BoundData &data, const EdgeMesh &mesh)
  : PrescribedLift(data, mesh.cells().size(), prescribed_edges(data, mesh)) {}

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
      for (unsigned int i = 0; i < n_scanned; ++i) {
        const double s = (i + 0.5) / n_scanned;
        const Tensor<1, 2> value = r(s);
        size = std::max(size, value.norm());
        misfit = std::max(misfit, (rest.evaluate(s, false) - value).norm());
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

Components PrescribedLift::strain(const unsigned int cell, const CellShape &shape,
                                  const Point<2> &at) const {
  const Tensor<2, 2> inverse = invert(shape.jacobian(CellFunctions(at), false));
  Components e;
  for (const EdgeRest &rest : rests_.at(cell)) {
    // The axes along edge k and behind it, with their directions.
    const unsigned int along = rest.k % 2, behind = 1 - along;
    const bool forward = rest.k < 2, inward = rest.k % 3 == 0;
    const double s = forward ? at[along] : 1. - at[along];
    const double depth = inward ? at[behind] : 1. - at[behind];
    const Tensor<2, 2> gradient =
      (forward ? 1. : -1.) * (1. - depth) * outer_product(rest.evaluate(s, true), inverse[along]) -
      (inward ? 1. : -1.) * outer_product(rest.evaluate(s, false), inverse[behind]);
    e += Components({gradient[0][0], gradient[1][1], gradient[0][1] + gradient[1][0]});
  }
  return e;
}

double PrescribedLift::work(const unsigned int cell, const CellMoments &moments) const {
  if (!cells_[cell])
    return 0.;
  const QGauss<1> rule(6);
  double sum = 0.;
  for (const EdgeRest &rest : rests_.at(cell))
    for (unsigned int piece = 0; piece < rest.pieces.size(); ++piece)
      for (unsigned int i = 0; i < rule.size(); ++i) {
        const double s = (piece + rule.point(i)[0]) / rest.pieces.size();
        sum += rule.weight(i) / rest.pieces.size() *
               (rest.evaluate(s, false) * linear_traction(&moments[4 * rest.k], s));
      }
  return sum;
}
} // namespace Signorini
