// SPDX-License-Identifier: LGPL-2.1-or-later
// A nearly rigid disc on a plane: its motion closes gaps that are far larger than what its own
// compliance can close. Against the only set of patches that satisfies all conditions.

#include <signorini/solvers/kinematics/bedding.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <cmath>

#include "random_numbers.h"
#include "tests.h"

using namespace Signorini;

namespace
{
using Vector = dealii::Vector<double>;
using Matrix = dealii::FullMatrix<double>;

/** Patches around a disc of radius one above the plane y = -1, tilted by a little. */
struct Disc
{
  Disc(const unsigned int m, const double softness, const double tilt, const double direction)
    : C(m, m)
    , F(m)
    , motions{Matrix(m, 2), Matrix(2, 2), Vector(2)}
  {
    const double pi = std::acos(-1.);
    for (unsigned int i = 0; i < m; ++i)
    {
      const double angle = 2. * pi * (i + 0.5) / m - pi;
      motions.B(i, 0) = std::sin(angle);
      motions.B(i, 1) = -std::cos(angle);
      // Along the normal to the plane; far away where it does not lead there.
      const double closing = std::cos(angle - tilt);
      F[i] = closing > 0.1 ? (1.05 - closing) / closing : 10.;
      for (unsigned int j = 0; j < m; ++j)
        C(i, j) = softness * std::exp(-0.5 * std::abs(double(i) - double(j)));
    }
    motions.b[0] = std::sin(direction);
    motions.b[1] = -std::cos(direction);
  }

  Matrix C;
  Vector F;
  FreeMotions motions;
};

/** The solution, by trying pairs, triples and quadruples of neighbours. */
Vector by_enumeration(const Disc &disc)
{
  const unsigned int m = disc.F.size();
  for (unsigned int n = 2; n <= 6; ++n)
    for (unsigned int first = 0; first + n <= m; ++first)
    {
      dealii::LAPACKFullMatrix<double> system(n + 2, n + 2);
      Vector x(n + 2);
      for (unsigned int r = 0; r < n; ++r)
      {
        for (unsigned int c = 0; c < n; ++c)
          system(r, c) = disc.C(first + r, first + c);
        for (unsigned int j = 0; j < 2; ++j)
          system(r, n + j) = system(n + j, r) = disc.motions.B(first + r, j);
        x[r] = disc.F[first + r];
      }
      for (unsigned int j = 0; j < 2; ++j)
        x[n + j] = -disc.motions.b[j];
      system.compute_lu_factorization();
      system.solve(x);
      Vector P(m), W(m);
      bool fits = true;
      for (unsigned int r = 0; r < n; ++r)
      {
        P[first + r] = x[r];
        fits = fits && x[r] <= 0.;
      }
      disc.C.vmult(W, P);
      W -= disc.F;
      for (unsigned int i = 0; i < m; ++i)
        fits = fits && W[i] + disc.motions.B(i, 0) * x[n] + disc.motions.B(i, 1) * x[n + 1] < 1e-10;
      if (fits)
        return P;
    }
  return Vector(m);
}

double distance(Vector a, const Vector &b)
{
  a -= b;
  return a.linfty_norm();
}
} // namespace

int main()
{
  Checks checks;
  for (const double softness : {1e-1, 1e-3, 1e-5})
    for (const double direction : {-0.3, 0.01, 0.25, 0.7})
    {
      const Disc disc(24, softness, 0.09, direction);
      const Vector exact = by_enumeration(disc);
      const std::string name = "softness " + std::to_string(softness).substr(0, 7) +
                               ", direction " + std::to_string(direction).substr(0, 5);
      checks.that(name + ": there is a solution", exact.l2_norm() > 0.);
      const auto C = std::make_shared<const DenseCompliance>(disc.C);
      const ReducedMotions seen(disc.motions, disc.F.size(), 1. / softness);
      unsigned int n_solves = 0;
      const auto state = descend(*C, disc.F, seen, 1000, n_solves);
      checks.that(name + ": descent ends", state && n_solves < 60);
      checks.near(name + ": descent", state ? distance(state->P, exact) : 1., 0., 1e-8);
      Vector far(disc.F.size());
      far[0] = far[1] = -1.;
      for (const Vector &start : {Vector(), far})
      {
        const MotionResult result = solve_dual_problem(C, disc.F, disc.motions, start, {});
        checks.that(name + ": converges", result.qp.converged);
        checks.near(name + ": pressure", distance(result.qp.P, exact), 0., 1e-7);
      }
    }
  return checks.exit_code();
}
