// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem with free motions: random problems and nearly rigid bodies fulfil all
// conditions, escapes follow Caratheodory's theorem; units.

#include <algorithm>
#include <cmath>
#include <vector>

#include "matrices.h"
#include "motion_problem.h"
#include "random_numbers.h"
#include "tests.h"

using namespace Signorini;
using Vector = dealii::Vector<double>;
using Matrix = dealii::FullMatrix<double>;

namespace {
/** b = K q - B^T P for some P <= 0, so that there is a solution. */
MotionProblem random_problem(const unsigned int m, const unsigned int k,
                             const unsigned int n_springs, RandomNumbers &random) {
  MotionProblem problem{
    random_matrix(m, random), random.vector(m), {Matrix(m, k), Matrix(k, k), Vector(k)}};
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j < k; ++j)
      problem.motions.B(i, j) = j == 0 ? 1.5 + random() : 2. * random();
  for (unsigned int s = 0; s < n_springs; ++s) {
    const Vector v = random.vector(k);
    for (unsigned int i = 0; i < k; ++i)
      for (unsigned int j = 0; j < k; ++j)
        problem.motions.K(i, j) += v[i] * v[j];
  }
  Vector P = random.vector(m);
  for (double &P_i : P)
    P_i = std::min(P_i, 0.);
  const Vector q = random.vector(k);
  for (unsigned int j = 0; j < k; ++j) {
    for (unsigned int i = 0; i < m; ++i)
      problem.motions.b[j] -= problem.motions.B(i, j) * P[i];
    for (unsigned int i = 0; i < k; ++i)
      problem.motions.b[j] += problem.motions.K(j, i) * q[i];
  }
  return problem;
}

/** The worst violation of all conditions. */
double violation(const MotionProblem &problem, const Vector &P, const Vector &q) {
  Vector W(problem.m());
  problem.C.vmult(W, P);
  double worst = 0.;
  for (unsigned int i = 0; i < problem.m(); ++i) {
    W[i] -= problem.F[i];
    for (unsigned int j = 0; j < problem.k(); ++j)
      W[i] += problem.motions.B(i, j) * q[j];
    worst = std::max({worst, P[i], W[i], std::abs(P[i] * W[i])});
  }
  for (unsigned int j = 0; j < problem.k(); ++j) {
    double r = -problem.motions.b[j];
    for (unsigned int i = 0; i < problem.m(); ++i)
      r -= problem.motions.B(i, j) * P[i];
    for (unsigned int i = 0; i < problem.k(); ++i)
      r += problem.motions.K(j, i) * q[i];
    worst = std::max(worst, std::abs(r));
  }
  return worst;
}

/** Up to three motions, as of a body in 2-D, and six, as in 3-D: a pressure and motions that
 * satisfy all conditions are the solution. */
void random_problems(Checks &checks) {
  RandomNumbers random(11);
  for (const unsigned int m : {1U, 2U, 5U, 8U, 20U})
    for (const unsigned int k : {1U, 2U, 3U, 6U})
      for (unsigned int springs = 0; springs <= std::min(k, 3U); ++springs)
        for (unsigned int repeat = 0; repeat < 4; ++repeat) {
          const MotionProblem problem = random_problem(m, k, springs, random);
          const MotionResult sets = solve(problem), sweeps = solve(problem, ContactSolver::psor),
                             warm = solve(problem, ContactSolver::active_set, random.vector(m));
          const double scale = std::pow(1. + sets.qp.P.linfty_norm() + sets.q.linfty_norm(), 2);
          for (const MotionResult *found : {&sets, &sweeps, &warm}) {
            checks.that("random problems: converged", found->qp.converged);
            checks.near(found == &sweeps ? "random problems: psor" : "random problems: active set",
                        violation(problem, found->qp.P, found->q) / scale, 0.,
                        found == &sweeps ? 1e-8 : 1e-11);
          }
        }
}

/** A nearly rigid disc on a plane: its motion closes gaps that are far larger than what its own
 * compliance can close. Patches lie around the disc of radius one above the plane y = -1, which is
 * tilted by a little. */
MotionProblem disc(const unsigned int m, const double softness, const double direction) {
  constexpr double tilt = 0.09;
  MotionProblem problem{Matrix(m, m), Vector(m), {Matrix(m, 2), Matrix(2, 2), Vector(2)}};
  const double pi = std::acos(-1.);
  for (unsigned int i = 0; i < m; ++i) {
    const double angle = 2. * pi * (i + 0.5) / m - pi;
    problem.motions.B(i, 0) = std::sin(angle);
    problem.motions.B(i, 1) = -std::cos(angle);
    // Along the normal to the plane; far away where it does not lead there.
    const double closing = std::cos(angle - tilt);
    problem.F[i] = closing > 0.1 ? (1.05 - closing) / closing : 10.;
    for (unsigned int j = 0; j < m; ++j)
      problem.C(i, j) = softness * std::exp(-0.5 * std::abs(double(i) - double(j)));
  }
  problem.motions.b[0] = std::sin(direction);
  problem.motions.b[1] = -std::cos(direction);
  return problem;
}

void nearly_rigid(Checks &checks) {
  for (const double softness : {1e-1, 1e-3, 1e-5, 1e-7})
    for (const double direction : {-0.3, 0.01, 0.25, 0.7})
      for (const bool is_far : {false, true}) {
        const MotionProblem problem = disc(24, softness, direction);
        Vector far(is_far ? 24 : 0);
        if (is_far)
          far[0] = far[1] = -1.;
        const MotionResult found = solve(problem, ContactSolver::active_set, far);
        checks.about("nearly rigid, softness " + std::to_string(softness) + ", direction " +
                     std::to_string(direction));
        checks.that("converges", found.qp.converged && found.qp.P.l2_norm() > 0.1);
        checks.near("conditions", violation(problem, found.qp.P, found.q), 0., 1e-10);
      }
}

/** Whether b is a nonnegative combination of k rows of B. */
bool is_in_cone(const FreeMotions &motions) {
  const unsigned int m = motions.B.m(), k = motions.b.size();
  for (unsigned int set = 0; set < (1U << m); ++set) {
    std::vector<unsigned int> rows;
    for (unsigned int i = 0; i < m; ++i)
      if (((set >> i) & 1U) == 1)
        rows.push_back(i);
    if (rows.size() != k)
      continue;
    Matrix system(k, k);
    Vector y(k);
    for (unsigned int i = 0; i < k; ++i)
      for (unsigned int j = 0; j < k; ++j)
        system(i, j) = motions.B(rows[j], i);
    system.gauss_jordan();
    system.vmult(y, motions.b);
    if (std::all_of(y.begin(), y.end(), [](const double value) { return value >= 0.; }))
      return true;
  }
  return false;
}

void escapes(Checks &checks) {
  RandomNumbers random(5);
  unsigned int right = 0, n_escapes = 0, all = 0;
  double opening = 0.;
  for (const unsigned int m : {4U, 7U})
    for (unsigned int k = 2; k <= 3; ++k)
      for (unsigned int repeat = 0; repeat < 50; ++repeat, ++all) {
        MotionProblem problem = random_problem(m, k, 0, random);
        problem.motions.b = random.vector(k);
        problem.motions.b[0] += 1.;
        const MotionResult found = solve(problem);
        right +=
          is_in_cone(problem.motions) == !found.escape && found.qp.converged != !!found.escape;
        if (!found.escape)
          continue;
        ++n_escapes;
        for (unsigned int i = 0; i < m; ++i) {
          double rate = 0.;
          for (unsigned int l = 0; l < k; ++l)
            rate += problem.motions.B(i, l) * (*found.escape)[l];
          opening = std::max(opening, rate);
        }
        right += problem.motions.b * *found.escape > 0. ? 0 : all + 1;
      }
  checks.near("escapes: found where there are any, and nowhere else", right, all, 0.);
  checks.near("escapes: none closes a patch", opening, 0., 1e-12);
  checks.between("escapes: both kinds occur", n_escapes, 0.1 * all, 0.9 * all);
}

} // namespace

int main() {
  return run_tests({random_problems, nearly_rigid, escapes});
}
