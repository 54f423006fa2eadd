// SPDX-License-Identifier: LGPL-2.1-or-later
// The rest of the nodal interpolation of prescribed displacements.

#include <signorini/error_control/loads/prescribed_lift.h>
#include <signorini/problem/scene/functions.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using Vector2 = Tensor<1, 2>;

constexpr unsigned int n_nodes = 9;

/** Returns Chebyshev's points with both ends of [0,1]. */
std::vector<Point<1>> nodes()
{
  std::vector<Point<1>> points;
  for (unsigned int i = 0; i < n_nodes; ++i)
    points.emplace_back(0.5 * (1. - std::cos(numbers::PI * i / (n_nodes - 1))));
  return points;
}

const std::vector<Polynomials::Polynomial<double>> &basis()
{
  static const auto polynomials = Polynomials::generate_complete_Lagrange_basis(nodes());
  return polynomials;
}

/** The coordinates ξ and η at the corners. */
constexpr std::array<double, 4> corner_xi = {{-1., 1., 1., -1.}};
constexpr std::array<double, 4> corner_eta = {{-1., -1., 1., 1.}};

/** Returns the position along edge k and the depth behind it, or their gradients, from those of ξ
 * and η. */
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

PrescribedLift::EdgeRest::EdgeRest(const unsigned int k, const unsigned int n_pieces, const Rest &r)
  : k(k)
{
  const auto points = nodes();
  for (unsigned int piece = 0; piece < n_pieces; ++piece)
  {
    Values &values = pieces.emplace_back();
    for (const Point<1> &point : points)
      values.push_back(r((piece + point[0]) / n_pieces));
  }
}

double PrescribedLift::EdgeRest::largest() const
{
  double largest = 0.;
  for (const Values &values : pieces)
    for (const Vector2 &value : values)
      largest = std::max(largest, value.norm());
  return largest;
}

Vector2 PrescribedLift::EdgeRest::evaluate(const double s, const bool derivative) const
{
  const double position = s * pieces.size();
  const unsigned int piece = std::clamp<int>(position, 0, pieces.size() - 1);
  Vector2 sum;
  std::vector<double> node_data(2);
  for (unsigned int i = 0; i < n_nodes; ++i)
  {
    basis()[i].value(position - piece, node_data);
    sum += (derivative ? pieces.size() * node_data[1] : node_data[0]) * pieces[piece][i];
  }
  return sum;
}

PrescribedLift::EdgeRest PrescribedLift::interpolate(const unsigned int k,
                                                     const Rest &r,
                                                     const unsigned int n_scanned)
{
  constexpr double allowed = 1e-3;
  constexpr unsigned int max_pieces = 32;
  double size = 0.;
  std::vector<Vector2> scanned;
  for (unsigned int i = 0; i < n_scanned; ++i)
  {
    scanned.push_back(r((i + 0.5) / n_scanned));
    size = std::max(size, scanned.back().norm());
  }
  for (unsigned int n_pieces = 1;; n_pieces *= 2)
  {
    EdgeRest rest(k, n_pieces, r);
    size = std::max(size, rest.largest());
    double misfit = 0.;
    for (unsigned int i = 0; i < n_scanned; ++i)
      misfit = std::max(misfit, (rest.evaluate((i + 0.5) / n_scanned, false) - scanned[i]).norm());
    if (misfit > allowed * size && n_pieces < max_pieces)
      continue;
    // A smaller rest is rounding.
    if (size > 1e-10 * scale_)
      max_misfit_ = std::max(max_misfit_, misfit / size);
    return rest;
  }
}

PrescribedLift::PrescribedLift(const Scene<2> &scene, const EdgeMesh &mesh, const Displacement &U)
  : scale_(U.linfty_norm())
  , cells_(mesh.cells().size(), false)
{
  const auto is_prescribed = [&](const Edge &edge) {
    return edge.side != Edge::no_side && scene.boundary[edge.side].role == Role::displacement;
  };
  const std::size_t n_edges =
    std::count_if(mesh.edges().begin(), mesh.edges().end(), is_prescribed);
  for (unsigned int c = 0; c < mesh.cells().size(); ++c)
    for (unsigned int k = 0; k < 4; ++k)
    {
      const EdgeCell &cell = mesh.cells()[c];
      const Edge &edge = mesh.edges()[cell.edges[k]];
      if (!is_prescribed(edge))
        continue;
      const unsigned int next = (k + 1) % 4;
      const Function<2> &prescribed = *scene.boundary[edge.side].data;
      const Rest r = [&](const double s) {
        dealii::Vector<double> u(2);
        prescribed.vector_value(cell.corners[k] + s * (cell.corners[next] - cell.corners[k]), u);
        Vector2 rest;
        for (unsigned int d = 0; d < 2; ++d)
          rest[d] = u[d] - (1. - s) * U[mesh.dofs()[cell.vertices[k]][d]] -
                    s * U[mesh.dofs()[cell.vertices[next]][d]];
        return rest;
      };
      EdgeRest rest = interpolate(
        k, r, is_constant(prescribed) ? 0 : std::min<std::size_t>(256, 20000 / n_edges));
      if (rest.largest() > 1e-13 * scale_)
      {
        cells_[c] = true;
        rests_[c].push_back(std::move(rest));
      }
    }
}

std::vector<KinkLine<2>> PrescribedLift::lines(const unsigned int cell, const EdgeCell &place) const
{
  std::vector<KinkLine<2>> lines;
  if (!cells_[cell])
    return lines;
  const auto &x = place.corners;
  for (const EdgeRest &rest : rests_.at(cell))
    for (unsigned int piece = 1; piece < rest.pieces.size(); ++piece)
    {
      const double s = static_cast<double>(piece) / rest.pieces.size();
      const unsigned int a = rest.k, b = (a + 1) % 4, c = (a + 2) % 4, d = (a + 3) % 4;
      // Lines of bilinear coordinates are straight.
      const Point<2> from = x[a] + s * (x[b] - x[a]), to = x[d] + s * (x[c] - x[d]);
      const Vector2 along = (to - from) / from.distance(to), normal({along[1], -along[0]});
      lines.push_back({normal, normal * (from - Point<2>())});
    }
  return lines;
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
    const Vector2 r = rest.evaluate(at.first, false);
    const Vector2 dr = (1. - at.second) * rest.evaluate(at.first, true);
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
  const QGauss<1> rule(6);
  double sum = 0.;
  for (const EdgeRest &rest : rests_.at(cell))
    for (unsigned int piece = 0; piece < rest.pieces.size(); ++piece)
      for (unsigned int i = 0; i < rule.size(); ++i)
      {
        const double s = (piece + rule.point(i)[0]) / rest.pieces.size();
        const Vector2 r = rest.evaluate(s, false);
        for (unsigned int d = 0; d < 2; ++d)
        {
          const double a = moments[4 * rest.k + d], b = moments[4 * rest.k + 2 + d];
          sum += rule.weight(i) / rest.pieces.size() * r[d] *
                 ((4. * a - 2. * b) * (1. - s) + (4. * b - 2. * a) * s);
        }
      }
  return sum;
}
} // namespace Signorini
