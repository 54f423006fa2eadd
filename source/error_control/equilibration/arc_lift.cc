// SPDX-License-Identifier: LGPL-2.1-or-later
// The lift of a traction on an arc into the curved triangle behind it.

#include <signorini/base/errors.h>
#include <signorini/error_control/equilibration/arc_lift.h>
#include <signorini/error_control/equilibration/cell_shape.h>
#include <signorini/error_control/equilibration/edge_polynomials.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini {
namespace {
/** The derivatives and the integrals from 0 of the polynomials that interpolate at Gauss' points in
 * [0,1], at these points (rows), and their values at 0 and 1. */
struct Interpolation {
  explicit Interpolation(const QGauss<1> &gauss)
    : derivatives(gauss.size())
    , integrals(gauss.size()) {
    const unsigned int n = gauss.size();
    for (unsigned int j = 0; j < n; ++j) {
      const auto basis = legendre(n, 2. * gauss.point(j)[0] - 1.);
      double at_start = 0., at_end = 0.;
      for (unsigned int k = 0; k < n; ++k) {
        // (2 k + 1) P_k at node j is the coefficient of P_k.
        const double coefficient = gauss.weight(j) * (2. * k + 1.) * basis[k];
        at_start += (k % 2 == 0 ? 1. : -1.) * coefficient;
        at_end += coefficient;
        for (unsigned int i = 0; i < n; ++i) {
          const double z = 2. * gauss.point(i)[0] - 1.;
          const auto P = legendre_jets(n, z);
          derivatives(i, j) += 2. * coefficient * P[k][1];
          integrals(i, j) +=
            coefficient * (k == 0 ? 0.5 * (z + 1.) : (P[k + 1][0] - P[k - 1][0]) / (4. * k + 2.));
        }
      }
      ends[0].push_back(at_start);
      ends[1].push_back(at_end);
    }
  }

  FullMatrix<double> derivatives, integrals;
  std::array<std::vector<double>, 2> ends;
};

/** Returns χ_0 and χ_1 with their first and second derivatives. */
std::array<std::array<double, 3>, 2> profiles(const double t, const double k) {
  const double b = std::pow(t, k), db = k * std::pow(t, k - 1.),
               ddb = k * (k - 1.) * std::pow(t, k - 2.), s = 1. - t;
  return {{{{b * (1. + k * s), db * (1. + k * s) - k * b, ddb * (1. + k * s) - 2. * k * db}},
           {{-b * s, b - db * s, 2. * db - ddb * s}}}};
}

/** Airy's function at the nodes: φ = A χ_0 + B χ_1, by A, B and their two derivatives. */
struct AiryTrace {
  std::array<double, 3> A, B;
};

/** Returns the stress of Airy's function at z + t p by its traces, with p' = γ' and p'' = γ''. */
Components stress_at(const double t, const AiryTrace &trace,
                     const std::array<std::array<double, 3>, 2> &profile, const Tensor<1, 2> &p,
                     const Tensor<1, 2> &d, const Tensor<1, 2> &dd) {
  const auto derivative = [&](const unsigned int in_a, const unsigned int in_t) {
    return trace.A[in_a] * profile[0][in_t] + trace.B[in_a] * profile[1][in_t];
  };
  // The second derivatives along p and γ' from those in t and a, by x_t = p, x_a = t γ'.
  const double det = cross(p, d), slope = derivative(1, 0) / t,
               bent = (derivative(0, 1) * cross(dd, d) + slope * cross(p, dd)) / det,
               pp = derivative(0, 2), pd = (derivative(1, 1) - slope) / t,
               dd_of = (derivative(2, 0) - t * bent) / (t * t);
  Components stress;
  for (unsigned int c = 0; c < 3; ++c) {
    const unsigned int i = c % 2, j = c > 0;
    stress[c] =
      (dd_of * p[i] * p[j] - pd * (p[i] * d[j] + d[i] * p[j]) + pp * d[i] * d[j]) / (det * det);
  }
  return stress;
}
} // namespace

bool ArcLift::is_seen(const Curve &arc) {
  constexpr double least_ratio = 0.2, largest_turn = numbers::PI / 3.;
  constexpr unsigned int n = 8;
  // The distances of tangents from the origin.
  double least = std::numeric_limits<double>::max(), largest = 0.;
  for (unsigned int i = 0; i <= n; ++i) {
    const double s = i * arc.length() / n,
                 distance = cross(arc.point(s) - Point<2>(), arc.tangent(s, 0.));
    least = std::min(least, distance);
    largest = std::max(largest, distance);
  }
  return least > least_ratio * largest &&
         (arc.is_flat() || arc.length() < largest_turn * arc.radius());
}

bool ArcLift::sees_arcs(const CellShape &cell) {
  const CellShape shape = cell.seen_from_crossing();
  for (unsigned int k = 0; k < 4; ++k)
    if (shape.centres[k] && !is_seen(shape.edge(k)))
      return false;
  return true;
}

ArcLift::ArcLift(const Curve &arc, const unsigned int degree) {
  const double turn = arc.is_flat() ? 0. : arc.length() / arc.radius();
  const Point<2> centre = arc.is_flat() ? Point<2>() : arc.centre_of_circle();
  const QGauss<1> angles(degree + 10), depths(degree + 5);
  const double length = arc.length();
  for (unsigned int i = 0; i < angles.size(); ++i) {
    const double s = angles.point(i)[0] * length;
    const Tensor<1, 2> t = arc.tangent(s, 0.);
    nodes_.push_back({angles.point(i)[0], arc.point(s), Tensor<1, 2>({t[1], -t[0]}), t,
                      angles.weight(i) * length});
  }
  if (!is_seen(arc))
    throw ComputationError("an arc turns too much in a cell of the mesh");
  for (const Node &node : nodes_)
    for (unsigned int q = 0; q < depths.size(); ++q) {
      const double t = depths.point(q)[0];
      points_.emplace_back(t * node.x,
                           t * depths.weight(q) * node.weight * cross(node.x, node.tangent));
    }
  const Interpolation through(angles);
  conditions_.reinit(n_conditions, 2 * nodes_.size());
  const std::array<Tensor<1, 2>, 2> ends = {{arc.start(), arc.end()}};
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (unsigned int c = 0; c < 2; ++c) {
      conditions_(c, 2 * i + c) = nodes_[i].weight;
      conditions_(2, 2 * i + c) = -nodes_[i].weight * cross_product_2d(nodes_[i].x)[c];
      for (unsigned int end = 0; end < 2; ++end)
        conditions_(3 + end, 2 * i + c) =
          through.ends[end][i] / ends[end].norm() * cross_product_2d(ends[end])[c];
    }
  // Column by column: r is 1 in one component at one node.
  const std::size_t n = nodes_.size();
  stresses_.reinit(3 * points_.size(), 2 * n);
  for (std::size_t column = 0; column < 2 * n; ++column) {
    const std::size_t j = column / 2;
    const Tensor<1, 2> turned =
      length * (column % 2 == 0 ? Tensor<1, 2>({0., 1.}) : Tensor<1, 2>({-1., 0.}));
    std::vector<Tensor<1, 2>> d(n), dd(n);
    std::vector<AiryTrace> traces(n);
    for (std::size_t i = 0; i < n; ++i) {
      d[i] = length * nodes_[i].tangent;
      dd[i] = -turn * turn * (nodes_[i].x - centre);
      const Tensor<1, 2> &p = nodes_[i].x, g = through.integrals(i, j) * turned,
                         dg = (i == j ? 1. : 0.) * turned, ddg = through.derivatives(i, j) * turned;
      traces[i].A = {{0., g * d[i], dg * d[i] + g * dd[i]}};
      traces[i].B = {{g * p, dg * p + g * d[i], ddg * p + 2. * (dg * d[i]) + g * dd[i]}};
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t m = 0; m < n; ++m)
        traces[i].A[0] += through.integrals(i, m) * traces[m].A[1];
      for (unsigned int q = 0; q < depths.size(); ++q) {
        const double t = depths.point(q)[0];
        const Components stress =
          stress_at(t, traces[i], profiles(t, degree + 3.), nodes_[i].x, d[i], dd[i]);
        for (unsigned int c = 0; c < 3; ++c)
          stresses_(3 * (i * depths.size() + q) + c, column) = stress[c];
      }
    }
  }
}
} // namespace Signorini
