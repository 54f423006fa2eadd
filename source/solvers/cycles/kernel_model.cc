// SPDX-License-Identifier: LGPL-2.1-or-later
// Ĉ by the kernel of the half space.

#include <signorini/solvers/cycles/kernel_model.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
namespace
{
/** The distance in diameters beyond which patches act on each other as points. */
constexpr double far_away = 4.;

/** Returns ∫ -log(r/R) ds for r = (s² + z²)^{1/2}, from 0 to u. */
double log_primitive(const double u, const double z, const double radius)
{
  const double square = u * u + z * z;
  if (square == 0.)
    return 0.;
  const double angle = z > 0. ? z * std::atan(u / z) : 0.;
  return u - angle - 0.5 * u * std::log(square / (radius * radius));
}

/** Returns ∫∫ 1/r over [0, u] x [0, v] without terms that cancel. */
double inverse_distance_primitive(const double u, const double v, const double z)
{
  const double r = std::sqrt(u * u + v * v + z * z);
  double sum = 0.;
  if (u != 0.)
    sum += u * std::asinh(v / std::hypot(u, z));
  if (v != 0.)
    sum += v * std::asinh(u / std::hypot(v, z));
  if (z > 0.)
    sum -= z * std::atan(u * v / (z * r));
  return sum;
}

template <int dim>
double kernel_of(const double distance, const double radius)
{
  return dim == 2 ? -std::log(distance / radius) : 0.5 / distance;
}
} // namespace

template <int dim>
dealii::Point<dim> FlatPatch<dim>::centre() const
{
  dealii::Point<dim> x = corner;
  for (const auto &edge : edges)
    x += 0.5 * edge;
  return x;
}

template <int dim>
double FlatPatch<dim>::diameter() const
{
  dealii::Tensor<1, dim> diagonal;
  for (const auto &edge : edges)
    diagonal += edge;
  return diagonal.norm();
}

template <>
double patch_potential(const FlatPatch<2> &patch, const dealii::Point<2> &x, const double radius)
{
  const double length = patch.edges[0].norm();
  const dealii::Tensor<1, 2> from = x - patch.corner;
  const double s = from * patch.edges[0] / length;
  // Rounding must not make a line of no width.
  const double z = (from - s / length * patch.edges[0]).norm();
  const double off = z > 1e-12 * length ? z : 0.;
  return (log_primitive(length - s, off, radius) - log_primitive(-s, off, radius)) *
         (patch.measure / length);
}

template <>
double patch_potential(const FlatPatch<3> &patch,
                       const dealii::Point<3> &x,
                       const double /*radius*/)
{
  const dealii::Tensor<1, 3> from = x - patch.corner;
  std::array<double, 2> low, high;
  dealii::Tensor<1, 3> rest = from;
  double area = 1.;
  for (unsigned int d = 0; d < 2; ++d)
  {
    const double length = patch.edges[d].norm();
    const double s = from * patch.edges[d] / length;
    rest -= s / length * patch.edges[d];
    low[d] = -s;
    high[d] = length - s;
    area *= length;
  }
  const double z = rest.norm() > 1e-12 * patch.diameter() ? rest.norm() : 0.;
  const double integral = inverse_distance_primitive(high[0], high[1], z) -
                          inverse_distance_primitive(low[0], high[1], z) -
                          inverse_distance_primitive(high[0], low[1], z) +
                          inverse_distance_primitive(low[0], low[1], z);
  return 0.5 * integral * (patch.measure / area);
}

template <int dim>
double patch_interaction(const FlatPatch<dim> &a, const FlatPatch<dim> &b, const double radius)
{
  const double distance = a.centre().distance(b.centre());
  const double size = std::max(a.diameter(), b.diameter());
  if (distance > far_away * size)
    return a.measure * b.measure * kernel_of<dim>(distance, radius);
  static const dealii::QGauss<dim - 1> usual(2), near(4);
  const dealii::Quadrature<dim - 1> &rule = distance > 1.5 * size ? usual : near;
  const auto one_way = [&](const FlatPatch<dim> &outer, const FlatPatch<dim> &inner) {
    double sum = 0.;
    for (unsigned int q = 0; q < rule.size(); ++q)
    {
      dealii::Point<dim> x = outer.corner;
      for (unsigned int d = 0; d < dim - 1; ++d)
        x += rule.point(q)[d] * outer.edges[d];
      sum += rule.weight(q) * outer.measure * patch_potential(inner, x, radius);
    }
    return sum;
  };
  return 0.5 * (one_way(a, b) + one_way(b, a));
}

KernelModel::KernelModel(Matrix C)
  : BoundaryModel(std::numeric_limits<unsigned int>::max())
  , C_(std::move(C))
  , L_(C_.m(), C_.m())
{
  L_ = C_;
  L_.set_property(dealii::LAPACKSupport::symmetric);
  L_.compute_cholesky_factorization();
}

unsigned int KernelModel::size() const
{
  return C_.m();
}

KernelModel::Vector KernelModel::apply(const Vector &P) const
{
  Vector product(size());
  C_.vmult(product, P);
  return product;
}

KernelModel::Vector KernelModel::apply_inverse(const Vector &P) const
{
  Vector x(P);
  L_.solve(x);
  return x;
}

double KernelModel::entry(const unsigned int i, const unsigned int j) const
{
  return C_(i, j);
}

template struct FlatPatch<2>;
template struct FlatPatch<3>;
template double patch_interaction(const FlatPatch<2> &, const FlatPatch<2> &, double);
template double patch_interaction(const FlatPatch<3> &, const FlatPatch<3> &, double);
} // namespace Signorini
