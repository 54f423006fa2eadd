// SPDX-License-Identifier: LGPL-2.1-or-later
// What the nodal interpolation of prescribed displacements leaves out.

#include <signorini/bound/prescribed_lift.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using Vector2 = dealii::Tensor<1, 2>;

constexpr unsigned int n_nodes = 9;

/** Chebyshev's points with both ends of [0,1]. */
std::vector<dealii::Point<1>> nodes()
{
  std::vector<dealii::Point<1>> points;
  for (unsigned int i = 0; i < n_nodes; ++i)
    points.emplace_back(0.5 * (1. - std::cos(dealii::numbers::PI * i / (n_nodes - 1))));
  return points;
}

const std::vector<dealii::Polynomials::Polynomial<double>> &basis()
{
  static const auto polynomials = dealii::Polynomials::generate_complete_Lagrange_basis(nodes());
  return polynomials;
}

/** xi and eta at the corners. */
constexpr std::array<double, 4> corner_xi = {{-1., 1., 1., -1.}};
constexpr std::array<double, 4> corner_eta = {{-1., -1., 1., 1.}};

/** Position along edge k and depth behind it, or their gradients, from those of xi and eta. */
template <typename Number>
std::pair<Number, Number>
along_and_behind(const unsigned int k, const Number &xi, const Number &eta, const Number &one)
{
  switch (k)
  {
  case 0:
    return {0.5 * (one + xi), 0.5 * (one + eta)};
  case 1:
    return {0.5 * (one + eta), 0.5 * (one - xi)};
  case 2:
    return {0.5 * (one - xi), 0.5 * (one - eta)};
  default:
    return {0.5 * (one - eta), 0.5 * (one + xi)};
  }
}
} // namespace

PrescribedLift::PrescribedLift(const Scene<2> &scene, const EdgeMesh &mesh, const NodalVector &U)
  : cells_(mesh.cells().size(), false)
{
  const auto points = nodes();
  const double scale = U.linfty_norm();
  for (unsigned int c = 0; c < mesh.cells().size(); ++c)
    for (unsigned int k = 0; k < 4; ++k)
    {
      const EdgeCell &cell = mesh.cells()[c];
      const Edge &edge = mesh.edges()[cell.edges[k]];
      if (edge.side == Edge::no_side || scene.boundary[edge.side].role != Role::displacement)
        continue;
      const unsigned int next = (k + 1) % 4;
      EdgeRest rest = {k, Values(n_nodes)};
      double largest = 0.;
      for (unsigned int i = 0; i < n_nodes; ++i)
      {
        const double s = points[i][0];
        dealii::Vector<double> u(2);
        scene.boundary[edge.side].data->vector_value(
          cell.corners[k] + s * (cell.corners[next] - cell.corners[k]), u);
        for (unsigned int d = 0; d < 2; ++d)
          rest.values[i][d] = u[d] - (1. - s) * U[mesh.dofs()[cell.vertices[k]][d]] -
                              s * U[mesh.dofs()[cell.vertices[next]][d]];
        largest = std::max(largest, rest.values[i].norm());
      }
      if (scale > 0.)
        largest_jump_ = std::max(
          {largest_jump_, rest.values[0].norm() / scale, rest.values[n_nodes - 1].norm() / scale});
      if (largest > 1e-13 * scale)
      {
        cells_[c] = true;
        rests_[c].push_back(std::move(rest));
      }
    }
}

Vector2 PrescribedLift::evaluate(const Values &values, const double s, const bool derivative)
{
  Vector2 sum;
  std::vector<double> of_node(2);
  for (unsigned int i = 0; i < n_nodes; ++i)
  {
    basis()[i].value(s, of_node);
    sum += of_node[derivative ? 1 : 0] * values[i];
  }
  return sum;
}

Components PrescribedLift::strain(const unsigned int cell, const StressPoint &point) const
{
  Components e{};
  if (!cells_[cell])
    return e;
  Vector2 d_xi, d_eta;
  for (unsigned int c = 0; c < 4; ++c)
  {
    d_xi += corner_xi[c] * point.gradients[c];
    d_eta += corner_eta[c] * point.gradients[c];
  }
  for (const EdgeRest &rest : rests_.at(cell))
  {
    const auto at = along_and_behind(rest.k, point.reference[0], point.reference[1], 1.);
    const auto d = along_and_behind(rest.k, d_xi, d_eta, Vector2());
    const Vector2 r = evaluate(rest.values, at.first, false);
    const Vector2 dr = (1. - at.second) * evaluate(rest.values, at.first, true);
    e[0] += dr[0] * d.first[0] - r[0] * d.second[0];
    e[1] += dr[1] * d.first[1] - r[1] * d.second[1];
    e[2] += dr[0] * d.first[1] - r[0] * d.second[1] + dr[1] * d.first[0] - r[1] * d.second[0];
  }
  return e;
}

double PrescribedLift::work(const unsigned int cell, const CellMoments &moments) const
{
  if (!cells_[cell])
    return 0.;
  const dealii::QGauss<1> rule(6);
  double sum = 0.;
  for (const EdgeRest &rest : rests_.at(cell))
    for (unsigned int i = 0; i < rule.size(); ++i)
    {
      const double s = rule.point(i)[0];
      const Vector2 r = evaluate(rest.values, s, false);
      for (unsigned int d = 0; d < 2; ++d)
      {
        const double a = moments[4 * rest.k + d], b = moments[4 * rest.k + 2 + d];
        sum += rule.weight(i) * r[d] * ((4. * a - 2. * b) * (1. - s) + (4. * b - 2. * a) * s);
      }
    }
  return sum;
}
} // namespace Signorini
