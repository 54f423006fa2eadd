// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem with free motions against an enumeration of all active sets; escapes against
// Caratheodory's theorem; units, order of patches, columns on demand, singular compliances.

#include <signorini/qp/free_motions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <set>
#include <stdexcept>
#include <vector>

#include "random_numbers.h"
#include "tests.h"

using namespace Signorini;
using Vector = dealii::Vector<double>;
using Matrix = dealii::FullMatrix<double>;

namespace
{
struct Problem
{
  Matrix C;
  Vector F;
  FreeMotions motions;

  unsigned int m() const
  {
    return F.size();
  }
  unsigned int k() const
  {
    return motions.b.size();
  }
};

MotionResult solve(const Problem &problem,
                   const ContactSolver method = ContactSolver::active_set,
                   const Vector &start = Vector())
{
  DualSolverOptions options;
  options.method = method;
  return solve_dual_problem(
    std::make_shared<const DenseCompliance>(problem.C), problem.F, problem.motions, start, options);
}

/** M^T M + I for a random M. */
Matrix random_matrix(const unsigned int m, RandomNumbers &random)
{
  Matrix M(m, m), C(m, m);
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j < m; ++j)
      M(i, j) = random();
  M.Tmmult(C, M);
  for (unsigned int i = 0; i < m; ++i)
    C(i, i) += 1.;
  return C;
}

/** b = K q - B^T P for some P <= 0, so that there is a solution. */
Problem random_problem(const unsigned int m,
                       const unsigned int k,
                       const unsigned int n_springs,
                       RandomNumbers &random)
{
  Problem problem{
    random_matrix(m, random), random.vector(m), {Matrix(m, k), Matrix(k, k), Vector(k)}};
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j < k; ++j)
      problem.motions.B(i, j) = j == 0 ? 1.5 + random() : 2. * random();
  for (unsigned int s = 0; s < n_springs; ++s)
  {
    const Vector v = random.vector(k);
    for (unsigned int i = 0; i < k; ++i)
      for (unsigned int j = 0; j < k; ++j)
        problem.motions.K(i, j) += v[i] * v[j];
  }
  Vector P = random.vector(m);
  for (double &P_i : P)
    P_i = std::min(P_i, 0.);
  const Vector q = random.vector(k);
  for (unsigned int j = 0; j < k; ++j)
  {
    for (unsigned int i = 0; i < m; ++i)
      problem.motions.b[j] -= problem.motions.B(i, j) * P[i];
    for (unsigned int i = 0; i < k; ++i)
      problem.motions.b[j] += problem.motions.K(j, i) * q[i];
  }
  return problem;
}

/** The worst violation of all conditions. */
double violation(const Problem &problem, const Vector &P, const Vector &q)
{
  Vector W(problem.m());
  problem.C.vmult(W, P);
  double worst = 0.;
  for (unsigned int i = 0; i < problem.m(); ++i)
  {
    W[i] -= problem.F[i];
    for (unsigned int j = 0; j < problem.k(); ++j)
      W[i] += problem.motions.B(i, j) * q[j];
    worst = std::max({worst, P[i], W[i], std::abs(P[i] * W[i])});
  }
  for (unsigned int j = 0; j < problem.k(); ++j)
  {
    double r = -problem.motions.b[j];
    for (unsigned int i = 0; i < problem.m(); ++i)
      r -= problem.motions.B(i, j) * P[i];
    for (unsigned int i = 0; i < problem.k(); ++i)
      r += problem.motions.K(j, i) * q[i];
    worst = std::max(worst, std::abs(r));
  }
  return worst;
}

/** The saddle point system with the patches in the bits of @p set; false if it is singular. */
bool solve_on(const Problem &problem, const unsigned int set, Vector &P, Vector &q)
{
  const unsigned int m = problem.m(), k = problem.k();
  Matrix system(m + k, m + k);
  Vector rhs(m + k), x(m + k);
  for (unsigned int i = 0; i < m; ++i)
  {
    const bool active = ((set >> i) & 1U) == 1;
    rhs[i] = active ? problem.F[i] : 0.;
    for (unsigned int j = 0; j < m; ++j)
      system(i, j) = active ? problem.C(i, j) : (i == j ? 1. : 0.);
    for (unsigned int j = 0; j < k; ++j)
    {
      system(i, m + j) = active ? problem.motions.B(i, j) : 0.;
      system(m + j, i) = -problem.motions.B(i, j);
    }
  }
  for (unsigned int i = 0; i < k; ++i)
  {
    rhs[m + i] = problem.motions.b[i];
    for (unsigned int j = 0; j < k; ++j)
      system(m + i, m + j) = problem.motions.K(i, j);
  }
  try
  {
    system.gauss_jordan();
  }
  catch (const dealii::ExceptionBase &)
  {
    return false;
  }
  system.vmult(x, rhs);
  for (unsigned int i = 0; i < m; ++i)
    P[i] = x[i];
  for (unsigned int j = 0; j < k; ++j)
    q[j] = x[m + j];
  return true;
}

/** Tries all active sets with a regular system. @return the P with the smallest violation. */
Vector enumerate(const Problem &problem, double &smallest)
{
  Vector best(problem.m()), P(problem.m()), q(problem.k());
  smallest = std::numeric_limits<double>::max();
  for (unsigned int set = 0; set < (1U << problem.m()); ++set)
    if (solve_on(problem, set, P, q))
    {
      const double worst = violation(problem, P, q);
      if (worst < smallest)
      {
        smallest = worst;
        best = P;
      }
    }
  return best;
}

double difference(Vector a, const Vector &b)
{
  a -= b;
  return a.linfty_norm();
}

void against_enumeration(Checks &checks)
{
  RandomNumbers random(11);
  double worst_sets = 0., worst_sweeps = 0., worst_warm = 0., worst_violation = 0.;
  unsigned int all = 0, known = 0, converged = 0, outer = 0;
  for (const unsigned int m : {1U, 2U, 5U, 8U})
    for (unsigned int k = 1; k <= 3; ++k)
      for (unsigned int springs = 0; springs <= k; ++springs)
        for (unsigned int repeat = 0; repeat < 4; ++repeat, ++all)
        {
          const Problem problem = random_problem(m, k, springs, random);
          double smallest = 0.;
          const Vector P = enumerate(problem, smallest);
          const MotionResult sets = solve(problem), sweeps = solve(problem, ContactSolver::psor),
                             warm = solve(problem, ContactSolver::active_set, random.vector(m));
          const double scale = 1. + P.linfty_norm() + sets.q.linfty_norm();
          converged += sets.qp.converged && sweeps.qp.converged && warm.qp.converged;
          outer = std::max(outer, sets.outer_iterations);
          worst_violation =
            std::max(worst_violation, violation(problem, sets.qp.P, sets.q) / (scale * scale));
          if (smallest > 1e-9 * scale * scale)
            continue; // the patches that press leave a motion undetermined
          ++known;
          worst_sets = std::max(worst_sets, difference(sets.qp.P, P) / scale);
          worst_sweeps = std::max(worst_sweeps, difference(sweeps.qp.P, P) / scale);
          worst_warm = std::max(worst_warm, difference(warm.qp.P, P) / scale);
        }
  checks.near("random problems: converged", converged, all, 0.);
  checks.between("random problems: with a regular set", known, 0.5 * all, all);
  checks.near("random problems: conditions", worst_violation, 0., 1e-11);
  checks.near("random problems: active set", worst_sets, 0., 1e-9);
  checks.near("random problems: psor", worst_sweeps, 0., 1e-8);
  checks.near("random problems: from a random start", worst_warm, 0., 1e-9);
  checks.between("random problems: outer iterations", outer, 0, 6);
}

/** Whether b is a nonnegative combination of k rows of B. */
bool is_in_cone(const FreeMotions &motions)
{
  const unsigned int m = motions.B.m(), k = motions.b.size();
  for (unsigned int set = 0; set < (1U << m); ++set)
  {
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

void escapes(Checks &checks)
{
  RandomNumbers random(5);
  unsigned int right = 0, n_escapes = 0, all = 0;
  double opening = 0.;
  for (const unsigned int m : {4U, 7U})
    for (unsigned int k = 2; k <= 3; ++k)
      for (unsigned int repeat = 0; repeat < 50; ++repeat, ++all)
      {
        Problem problem = random_problem(m, k, 0, random);
        problem.motions.b = random.vector(k);
        problem.motions.b[0] += 1.;
        const MotionResult found = solve(problem);
        right +=
          is_in_cone(problem.motions) == !found.escape && found.qp.converged != !!found.escape;
        if (!found.escape)
          continue;
        ++n_escapes;
        for (unsigned int i = 0; i < m; ++i)
        {
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

/** Lengths times the given factor, forces times another one; rotations keep their unit. */
void units(Checks &checks)
{
  RandomNumbers random(3);
  for (const double length : {1e-9, 1., 1e9})
    for (const double force : {1e-9, 1e9})
    {
      const Problem problem = random_problem(8, 3, 1, random);
      Problem scaled = problem;
      scaled.C *= length / force;
      scaled.F *= length;
      for (unsigned int j = 0; j < 3; ++j)
      {
        const double unit = j == 2 ? length : 1.; // of a row of B: length per unit of q_j
        for (unsigned int i = 0; i < 8; ++i)
          scaled.motions.B(i, j) *= unit;
        for (unsigned int i = 0; i < 3; ++i)
          scaled.motions.K(i, j) *= force / length * unit * (i == 2 ? length : 1.);
        scaled.motions.b[j] *= force * unit;
      }
      const MotionResult found = solve(problem), again = solve(scaled),
                         sweeps = solve(scaled, ContactSolver::psor);
      Vector P = again.qp.P, P_sweeps = sweeps.qp.P;
      P /= force;
      P_sweeps /= force;
      Vector q = again.q;
      q[0] /= length;
      q[1] /= length;
      checks.near("units: P", difference(P, found.qp.P), 0., 1e-10);
      checks.near("units: P, psor", difference(P_sweeps, found.qp.P), 0., 1e-8);
      checks.near("units: q", difference(q, found.q), 0., 1e-9);
      checks.that("units: converged",
                  found.qp.converged && again.qp.converged && sweeps.qp.converged);
    }
}

/** int int -log|x - y| over pairs of m equal patches of [0, 1], as in random_problems.cc. */
Matrix half_plane(const unsigned int m)
{
  const auto antiderivative = [](const double t) {
    return t == 0. ? 0. : 0.75 * t * t - 0.5 * t * t * std::log(std::abs(t));
  };
  const double H = 1. / m;
  Matrix C(m, m);
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j < m; ++j)
    {
      const double d = H * (static_cast<double>(i) - j);
      C(i, j) = antiderivative(d + H) - 2. * antiderivative(d) + antiderivative(d - H);
    }
  return C;
}

/** A parabola, pressed by a force at the place e, that may rotate. */
Problem indenter(const unsigned int m, const double curvature, const double force, const double e)
{
  Problem problem{half_plane(m), Vector(m), {Matrix(m, 2), Matrix(2, 2), Vector(2)}};
  for (unsigned int i = 0; i < m; ++i)
  {
    const double x = (i + 0.5) / m - 0.5;
    problem.F[i] = curvature * x * x / m;
    problem.motions.B(i, 0) = 1. / m;
    problem.motions.B(i, 1) = x / m;
  }
  problem.motions.b[0] = force;
  problem.motions.b[1] = force * e;
  return problem;
}

/** Hands out columns, and counts them. */
class Columns final : public ComplianceOperator
{
public:
  explicit Columns(const Matrix &from)
    : from_(from)
  {
  }
  unsigned int size() const override
  {
    return from_.m();
  }
  Vector apply(const Vector &P) const override
  {
    Vector product(size());
    for (unsigned int j = 0; j < size(); ++j)
      if (P[j] != 0.)
      {
        asked.insert(j);
        for (unsigned int i = 0; i < size(); ++i)
          product[i] += from_(i, j) * P[j];
      }
    return product;
  }
  Vector diagonal() const override
  {
    throw std::logic_error("the whole diagonal costs all columns");
  }
  Matrix columns(const Indices &numbers) const override
  {
    Matrix found(size(), numbers.size());
    for (unsigned int k = 0; k < numbers.size(); ++k)
    {
      asked.insert(numbers[k]);
      for (unsigned int i = 0; i < size(); ++i)
        found(i, k) = from_(i, numbers[k]);
    }
    return found;
  }
  const Matrix &dense() const override
  {
    throw std::logic_error("all of C costs all columns");
  }
  bool is_explicit() const override
  {
    return false;
  }

  mutable std::set<unsigned int> asked;

private:
  const Matrix &from_;
};

void indenters(Checks &checks)
{
  for (const double e : {0., 0.1, 0.3})
    for (const double curvature : {0., 50., 2000.})
    {
      const unsigned int m = 128;
      const Problem problem = indenter(m, curvature, 1., e);
      const MotionResult found = solve(problem);
      // The same with the motions prescribed.
      Vector F = problem.F;
      for (unsigned int i = 0; i < m; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          F[i] -= problem.motions.B(i, j) * found.q[j];
      const auto C = std::make_shared<const DenseCompliance>(problem.C);
      const QPResult held = solve_dual_problem(C, F, Vector(), DualSolverOptions());
      checks.that("indenter: converged", found.qp.converged);
      checks.near("indenter: the held one has the same P",
                  difference(held.P, found.qp.P),
                  0.,
                  1e-9 * held.P.linfty_norm());
      checks.near("indenter: force", found.qp.P.mean_value(), -1., 1e-11);
      checks.between("indenter: linear solves", found.qp.iterations, 1., 2. * held.iterations + 6.);
      const auto columns = std::make_shared<const Columns>(problem.C);
      const MotionResult few =
        solve_dual_problem(columns, problem.F, problem.motions, Vector(), DualSolverOptions());
      checks.near("indenter: columns on demand",
                  difference(few.qp.P, found.qp.P),
                  0.,
                  1e-9 * held.P.linfty_norm());
      unsigned int pressing = 0;
      for (const double P_i : found.qp.P)
        pressing += P_i < 0. ? 1 : 0;
      checks.between("indenter: columns", columns->asked.size(), pressing, 1.5 * pressing + 10);
      const MotionResult warm = solve(problem, ContactSolver::active_set, found.qp.P);
      checks.that("indenter: its own start costs one solve",
                  warm.qp.iterations == 1 && warm.outer_iterations == 0);
      const MotionResult sweeps = solve(problem, ContactSolver::psor);
      checks.near(
        "indenter: psor", difference(sweeps.qp.P, found.qp.P), 0., 1e-7 * held.P.linfty_norm());
    }
}

void order_of_patches(Checks &checks)
{
  const unsigned int m = 40;
  const Problem problem = indenter(m, 20., 1., 0.1);
  std::vector<unsigned int> place(m);
  std::iota(place.begin(), place.end(), 0);
  RandomNumbers random(9);
  for (unsigned int i = m - 1; i > 0; --i)
    std::swap(place[i], place[static_cast<unsigned int>(0.5 * (random() + 1.) * i)]);
  Problem shuffled = problem;
  for (unsigned int i = 0; i < m; ++i)
  {
    shuffled.F[i] = problem.F[place[i]];
    for (unsigned int j = 0; j < 2; ++j)
      shuffled.motions.B(i, j) = problem.motions.B(place[i], j);
    for (unsigned int j = 0; j < m; ++j)
      shuffled.C(i, j) = problem.C(place[i], place[j]);
  }
  const MotionResult found = solve(problem), other = solve(shuffled);
  Vector P(m);
  for (unsigned int i = 0; i < m; ++i)
    P[place[i]] = other.qp.P[i];
  checks.near("order of patches", difference(P, found.qp.P), 0., 1e-9 * P.linfty_norm());
}

/** Two patches at each place: only the sum of their pressures is known. */
void singular_compliance(Checks &checks)
{
  const unsigned int m = 10;
  const Problem single = indenter(m, 10., 1., 0.05);
  Problem twice = indenter(2 * m, 0., 1., 0.05);
  for (unsigned int i = 0; i < 2 * m; ++i)
  {
    twice.F[i] = single.F[i / 2];
    for (unsigned int j = 0; j < 2; ++j)
      twice.motions.B(i, j) = single.motions.B(i / 2, j);
    for (unsigned int j = 0; j < 2 * m; ++j)
      twice.C(i, j) = single.C(i / 2, j / 2);
  }
  DualSolverOptions options;
  options.may_be_singular = true;
  const auto by = [&](const Problem &problem) {
    return solve_dual_problem(std::make_shared<const DenseCompliance>(problem.C),
                              problem.F,
                              problem.motions,
                              Vector(),
                              options);
  };
  const MotionResult found = by(twice), expected = by(single);
  Vector sums(m);
  for (unsigned int i = 0; i < 2 * m; ++i)
    sums[i / 2] += found.qp.P[i];
  checks.near("singular C: sums of P", difference(sums, expected.qp.P), 0., 1e-6);
  checks.near("singular C: q", difference(found.q, expected.q), 0., 1e-7);
  checks.that("singular C: converged, not unique, and it is said",
              found.qp.converged && !found.qp.unique && found.qp.active_set_failure);
  checks.that("regular C: unique",
              expected.qp.converged && expected.qp.unique && !expected.qp.active_set_failure);
}
} // namespace

int main()
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  against_enumeration(checks);
  escapes(checks);
  units(checks);
  indenters(checks);
  order_of_patches(checks);
  singular_compliance(checks);
  return checks.exit_code();
}
