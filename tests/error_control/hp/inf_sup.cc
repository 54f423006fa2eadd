// SPDX-License-Identifier: LGPL-2.1-or-later
// Lemma 1 for polynomials of degree p - 2 on every contact face of degree p, and the norm in it: a
// Gram matrix of polynomials on patches of different lengths against a series.

#include <signorini/verification/norms/cosine_norm.h>
#include <signorini/verification/norms/inf_sup.h>

#include <deal.II/base/quadrature_lib.h>

#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/legendre.hpp>

#include <algorithm>
#include <cmath>
#include <complex>

#include "cosine_kernel.h"
#include "graded.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;
using dealii::numbers::PI;

namespace {
const std::string square = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

double measure(const OneLevel &level) {
  return measure_inf_sup(level.space(), level.multipliers(), level.discretization.condensed_D,
                         cosine_kernel::gram_matrix(level.multipliers()), LinearSolver::automatic)
    .both;
}

/** beta depends neither on the mesh nor on the degree. An independent program in Python measured
 * 0.8727 for p = 2, ..., 8 and for the pair of the paper. */
void stability(Checks &checks) {
  for (const unsigned int n : {2U, 3U, 4U}) {
    checks.about("n = " + std::to_string(1U << n));
    checks.between("degree 1, pairs of faces", measure(OneLevel(square, n)), 0.85, 0.8735);
    for (unsigned int p = 2; p <= 8; p += n < 4 ? 1 : 3) {
      checks.between("degree " + std::to_string(p),
                     measure(GradedLevel(square, uniform_plan(n, p))), 0.87, 0.8735);
    }
  }
}

/** Cells of a size down to 2^-18 at a part of the contact side, and a jump of degrees. */
void graded_meshes(Checks &checks) {
  for (const double layers : {3., 6., 10., 16.}) {
    MeshPlan plan = uniform_plan(2, 2);
    plan.base_size = 0.25;
    plan.rise = 0.5 * layers;
    plan.singularities = {end_of_contact({0.3, 0.}, 2, 0.3, 0.3001, layers)};
    checks.between("graded, " + std::to_string(static_cast<int>(layers)) + " layers",
                   measure(GradedLevel(square, plan)), 0.85, 0.8735);
  }
}

/**
 * int psi_k e^{i omega s} for all k on a patch: with s = c + h t,
 *
 *     int_{-1}^{1} P_n(t) e^{i a t} dt = 2 i^n j_n(a),  a = omega h.
 */
std::vector<std::complex<double>> fourier(const MultiplierSpace<2> &space, const unsigned int patch,
                                          const double omega) {
  const Patch<2> &interval = space.surface().patches()[patch];
  const unsigned int n_unknowns = space.n_of(patch);
  const double h = 0.5 * (interval.upper[0] - interval.lower[0]), c = interval.centre()[0];
  const dealii::QGauss<1> gauss(n_unknowns);
  std::vector<std::complex<double>> sums(n_unknowns);
  std::complex<double> power = 1.;
  for (unsigned int n = 0; n < n_unknowns; ++n) {
    const std::complex<double> integral = 2. * power * boost::math::sph_bessel(n, omega * h);
    for (unsigned int k = 0; k < n_unknowns; ++k)
      sums[k] += (2. * n + 1.) * gauss.weight(k) *
                 boost::math::legendre_p(n, 2. * gauss.point(k)[0] - 1.) * integral;
    power *= std::complex<double>(0., 1.);
  }
  for (auto &sum : sums)
    sum *= h * std::polar(1., omega * c);
  return sums;
}

/** The Gram matrix of one open side by N modes. */
dealii::FullMatrix<double> series(const MultiplierSpace<2> &space, const unsigned int n_modes) {
  const unsigned int m = space.n_multipliers();
  const double length = space.surface().side(space.surface().patches()[0]).length();
  dealii::FullMatrix<double> gram(m, m);
  std::vector<double> q(m);
  for (unsigned int k = 0; k <= n_modes; ++k) {
    const double omega = k * PI / length;
    for (unsigned int patch = 0; patch < space.surface().patches().size(); ++patch) {
      const auto sums = fourier(space, patch, std::max(omega, 1e-12));
      for (unsigned int i = 0; i < sums.size(); ++i)
        q[space.first_of(patch) + i] = sums[i].real();
    }
    const double weight = (k == 0 ? 1. : 2.) / length / std::hypot(1., omega);
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int j = 0; j < m; ++j)
        gram(i, j) += weight * q[i] * q[j];
  }
  return gram;
}

/** Sides of the lengths 1 and 20. N modes leave about 1/N² of the jumps. */
void gram_matrices(Checks &checks) {
  for (const unsigned int length : {1U, 20U}) {
    MeshPlan plan = uniform_plan(1, 4);
    plan.base_size = 0.5 * length;
    plan.singularities = {end_of_contact({0.3, 0.}, 2, 0.3, 0.31, 3.)};
    plan.rise = 4.;
    const std::string size = std::to_string(length);
    const GradedLevel level(square + "Geometry/Upper right = " + size + ", " + size, plan);
    const auto gram = cosine_kernel::gram_matrix(level.multipliers());
    auto difference = series(level.multipliers(), 8192);
    difference.add(-1., gram);
    checks.near("polynomials against a series", difference.frobenius_norm() / gram.frobenius_norm(),
                0., 1e-6);
  }
}

/** Constants on patches of different lengths: the kernel against the series. */
void constants(Checks &checks) {
  for (const double layers : {3., 5.}) {
    MeshPlan plan = uniform_plan(2, 2);
    plan.singularities = {corner({0., 0.}, layers)};
    const GradedLevel graded(square, plan);
    checks.that("constants on graded patches: constants",
                graded.multipliers().is_piecewise_constant());
    auto by_kernel = cosine_kernel::gram_matrix(graded.multipliers());
    const double size = by_kernel.frobenius_norm();
    by_kernel.add(-1., dual_gram_matrix(graded.discretization.surface));
    checks.near("constants on graded patches, " + std::to_string(static_cast<int>(layers)) +
                  " layers",
                by_kernel.frobenius_norm() / size, 0., 1e-6);
  }
  // On the whole circle: cos(s) is orthogonal to 1, and |1|² = L.
  const GradedLevel ring("Scene/Name = E1\n", uniform_plan(1, 4));
  const auto gram = cosine_kernel::gram_matrix(ring.multipliers());
  const unsigned int m = ring.multipliers().n_multipliers();
  dealii::Vector<double> one(m), linear(m), image(m);
  one = 1.;
  gram.vmult(image, one);
  checks.near("circle: constant", image * one, 4. * PI, 1e-7);
  for (unsigned int k = 0; k < m; ++k)
    linear[k] = std::cos(ring.multipliers().node(k)[0] / 2.);
  gram.vmult(image, linear);
  checks.near("circle: orthogonal", image * one, 0., 1e-6);
  // The interpolant of degree two on 16 faces is 1e-4 away.
  checks.near("circle: cos(s/2)", image * linear, 2. * PI / std::hypot(1., 0.5), 1e-4);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {gram_matrices, constants, stability, graded_meshes});
}
