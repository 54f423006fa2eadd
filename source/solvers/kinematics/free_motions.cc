// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem with free motions, by proximal iteration; where that fails, by descent.

#include <signorini/solvers/kinematics/bedding.h>
#include <signorini/solvers/kinematics/free_motions.h>
#include <signorini/solvers/kinematics/pressing_patches.h>
#include <signorini/solvers/kinematics/seen_motions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
namespace
{
using Vector = dealii::Vector<double>;
using Matrix = FullMatrix<double>;
using Compliance = std::shared_ptr<const ComplianceOperator>;

/** The problem in the coordinates of ReducedMotions. */
struct MotionProblem
{
  Compliance C;
  const Vector &F;
  const ReducedMotions &motions;
  /** The diagonal of C, or an estimate where columns are expensive. */
  const Vector &diagonal;
  const DualSolverOptions &options;
};

/** The state of the proximal iteration. */
struct MotionSearch
{
  /** The start of the next inner problem. */
  MotionState state;
  /** The smallest residual so far, and its state. */
  double residual = std::numeric_limits<double>::max();
  MotionState best;
  /** The stiffness B_Aᵀ C_AA⁻¹ B_A of the patches that press, n x n. */
  Matrix stiffness;
  /** The result of the last inner problem; its iterations are those of all. */
  QPResult inner;
  unsigned int outer_iterations = 0;
};

/** Returns the norms |B_i|. */
Vector row_norms(const Matrix &B)
{
  Vector norms(B.m());
  for (unsigned int i = 0; i < B.m(); ++i)
    for (unsigned int j = 0; j < B.n(); ++j)
      norms[i] = std::hypot(norms[i], B(i, j));
  return norms;
}

/** Returns diag C; where columns are expensive, an estimate from one column: C_ii grows like the
 * square of the length of a patch, as |B_i|² does. */
Vector diagonal_guess(const ComplianceOperator &C, const Vector &F, const Vector &norms)
{
  if (C.is_explicit())
    return C.diagonal();
  const double large = 0.1 * norms.linfty_norm();
  unsigned int chosen = F.size();
  for (unsigned int i = 0; i < F.size(); ++i)
    if (norms[i] >= large && (chosen == F.size() || F[i] * norms[chosen] < F[chosen] * norms[i]))
      chosen = i;
  const double c = C.columns({chosen})(chosen, 0);
  Vector guess(F.size());
  for (unsigned int i = 0; i < F.size(); ++i)
    guess[i] = large > 0. ? c * std::pow(std::max(norms[i], large) / norms[chosen], 2) : c;
  return guess;
}

/** Returns W = C P + B z - F. */
Vector opening(const MotionProblem &problem, const MotionState &state)
{
  Vector W = problem.C->apply(state.P);
  W += times(problem.motions.B, state.z);
  W -= problem.F;
  return W;
}

/** Returns C_ii; for patches that do not press it is an estimate where columns are expensive. */
Vector diagonal_at(const MotionProblem &problem, const Vector &P)
{
  Vector diagonal = problem.diagonal;
  if (problem.C->is_explicit())
    return diagonal;
  const ComplianceOperator::Indices A = pressing_patches(P);
  const Matrix columns = problem.C->columns(A);
  for (unsigned int j = 0; j < A.size(); ++j)
    diagonal[A[j]] = columns(A[j], j);
  return diagonal;
}

/** Returns the residual, see solve_dual_problem() with free motions. */
double kkt_residual(const MotionProblem &problem, const MotionState &state)
{
  const Vector W = opening(problem, state);
  const Vector diagonal = diagonal_at(problem, state.P);
  double residual = problem.motions.imbalance(state.P, state.z).norm_sqr();
  double size_of_F = 0.;
  for (unsigned int i = 0; i < W.size(); ++i)
  {
    const double r = state.P[i] - std::min(0., state.P[i] - W[i] / diagonal[i]);
    residual += r * r;
    if (state.P[i] != 0. || W[i] > 0.)
      size_of_F += std::pow(problem.F[i] / diagonal[i], 2);
  }
  const double scale = std::max({state.P.norm_sqr(), size_of_F, problem.motions.b.norm_sqr()});
  return scale > 0. ? std::sqrt(residual / scale) : std::sqrt(residual);
}

/** Stores the state if it is the best one. */
void judge(const MotionProblem &problem, MotionState state, MotionSearch &search)
{
  for (double &P_i : state.P)
    P_i = std::min(P_i, 0.);
  const double residual = kkt_residual(problem, state);
  if (residual < search.residual)
  {
    search.residual = residual;
    search.best = state;
  }
}

/** Returns P - W/C_ii, cut off at zero: patches that pull leave the set, those with penetration
 * join it. */
Vector exchange(const MotionProblem &problem, const MotionState &state)
{
  const Vector W = opening(problem, state);
  const Vector diagonal = diagonal_at(problem, state.P);
  Vector P = state.P;
  for (unsigned int i = 0; i < P.size(); ++i)
    P[i] = std::min(0., P[i] - W[i] / diagonal[i]);
  return P;
}

/** Computes exactly on the patches that press; keeps the stiffness, and better motions. Then
 * patches are exchanged until @p attempts attempts have failed: inner problems compute W only up to
 * the rounding of large motions, in which small patches beside large ones have no sign. */
void solve_exactly(const MotionProblem &problem, const unsigned int attempts, MotionSearch &search)
{
  MotionState trial = search.state;
  for (unsigned int n_failed_attempts = 0; n_failed_attempts <= attempts;)
  {
    const ComplianceOperator::Indices A = pressing_patches(trial.P);
    const auto exact = solve_on_pressing(*problem.C, problem.F, problem.motions, trial);
    if (!exact)
      return;
    ++search.inner.iterations;
    search.stiffness = exact->stiffness;
    const double before = search.residual;
    judge(problem, exact->state, search);
    // Patches that cannot carry the load would throw the body far away.
    if (search.residual < before)
      search.state.z = exact->state.z;
    n_failed_attempts = search.residual < before ? 0 : n_failed_attempts + 1;
    trial.P = exchange(problem, exact->state);
    trial.z = exact->state.z;
    if (attempts == 0 || pressing_patches(trial.P) == A)
      return;
  }
}

/** Returns E: part of the stiffness of the contact; motions that it does not resist get some, too.
 */
Matrix proximal_stiffness(const Matrix &stiffness, const double part)
{
  double trace = 0.;
  for (unsigned int i = 0; i < stiffness.m(); ++i)
    trace += stiffness(i, i);
  Matrix E(stiffness.m(), stiffness.m());
  E.add(part, stiffness);
  for (unsigned int i = 0; i < E.m(); ++i)
    E(i, i) += part * 1e-4 * trace;
  return E;
}

/** Returns the options of the inner problem, with the iterations that are left. */
DualSolverOptions inner_options(const MotionProblem &problem,
                                const MotionSearch &search,
                                const bool by_sweeps)
{
  DualSolverOptions options = problem.options;
  options.may_be_singular = false;
  options.maximum_iterations -= std::min(options.maximum_iterations, search.inner.iterations);
  if (by_sweeps)
  {
    options.method = ContactSolver::psor;
    options.tolerance = std::max(0.1 * options.tolerance, std::min(1e-4, 1e-2 * search.residual));
  }
  else
    // Where C is singular, sweeps take over, which converge too slowly for this E.
    options.maximum_iterations =
      std::min(options.maximum_iterations, 10 * problem.F.size() + 1000U);
  return options;
}

/** Solves the dual problem with C + B (K + E)⁻¹ Bᵀ, and computes the motions that belong to its
 * pressure. */
void solve_inner(const MotionProblem &problem, MotionSearch &search)
{
  const ReducedMotions &motions = problem.motions;
  const std::optional<std::string> failure = search.inner.active_set_failure;
  const bool by_sweeps = problem.options.method == ContactSolver::psor || failure;
  Matrix Q = proximal_stiffness(search.stiffness, by_sweeps ? 0.3 : 1e-4);
  Q.add(1., motions.K);
  const SmallCholesky solver(Q);
  MotionState next = search.state;
  // z = z_old + Q⁻¹(b - K z_old + Bᵀ P).
  next.z += solver.solve(motions.imbalance(Vector(next.P.size()), next.z));
  Vector load = problem.F;
  load -= times(motions.B, next.z);
  const unsigned int before = search.inner.iterations;
  search.inner =
    solve_dual_problem(std::make_shared<const StiffenedCompliance>(problem.C, motions.B, solver),
                       load,
                       next.P,
                       inner_options(problem, search, by_sweeps));
  search.inner.iterations += before;
  ++search.outer_iterations;
  next.P = search.inner.P;
  next.z += solver.solve(transpose_times(motions.B, next.P));
  if (!search.inner.active_set_failure || search.inner.converged)
    search.state = next;
  if (failure)
    search.inner.active_set_failure = failure;
}

/** Returns whether P is the only solution: C with motions is regular on the patches that touch. */
bool is_only_solution(const MotionProblem &problem, const MotionState &state)
{
  const Vector W = opening(problem, state);
  const double zero =
    1e-9 * (problem.F.linfty_norm() + times(problem.motions.B, state.z).linfty_norm());
  ComplianceOperator::Indices touching;
  for (unsigned int i = 0; i < W.size(); ++i)
    if (state.P[i] < 0. || W[i] > -zero)
      touching.push_back(i);
  const unsigned int n = problem.motions.size();
  Matrix C_TT = submatrix(*problem.C, touching);
  double size = 0.;
  for (unsigned int i = 0; i < C_TT.m(); ++i)
    size = std::max(size, C_TT(i, i));
  // Two solutions differ by a P with C P = 0 and Bᵀ P = 0.
  for (unsigned int i = 0; i < C_TT.m(); ++i)
    for (unsigned int j = 0; j < C_TT.m(); ++j)
      for (unsigned int l = 0; l < n; ++l)
        C_TT(i, j) +=
          size * C_TT.m() * problem.motions.B(touching[i], l) * problem.motions.B(touching[j], l);
  Vector pressing(touching.size());
  std::fill(pressing.begin(), pressing.end(), -1.);
  return BoundConstrainedQP(C_TT, Vector(touching.size())).has_unique_solution(pressing);
}

/** Returns the start of the search: the given pressure, or that of separate springs. */
MotionSearch begin(const MotionProblem &problem, const Vector &start)
{
  MotionSearch search;
  const ReducedMotions &motions = problem.motions;
  search.state = solve_on_bedding(motions, problem.F, problem.diagonal);
  if (start.size() > 0 && !pressing_patches(start).empty())
    search.state.P = start;
  search.best = {Vector(problem.F.size()), Vector(motions.size())};
  search.stiffness.reinit(motions.size(), motions.size());
  for (unsigned int r = 0; r < problem.F.size(); ++r)
    for (unsigned int i = 0; i < motions.size(); ++i)
      for (unsigned int j = 0; j < motions.size(); ++j)
        search.stiffness(i, j) += motions.B(r, i) * motions.B(r, j) / problem.diagonal[r];
  judge(problem, search.best, search);
  solve_exactly(problem, 0, search);
  return search;
}

/** Iterates until the residual is that of rounding, or does not fall further. */
void iterate(const MotionProblem &problem, MotionSearch &search)
{
  const double tolerance = problem.options.tolerance;
  const double rounding = (problem.F.size() + 10) * std::numeric_limits<double>::epsilon();
  const double small = std::min(tolerance, std::max(1e-2 * tolerance, rounding));
  unsigned int n_failed_attempts = 0;
  while (search.residual > small && n_failed_attempts < (search.residual <= tolerance ? 1U : 20U) &&
         search.inner.iterations < problem.options.maximum_iterations)
  {
    const double before = search.residual;
    solve_inner(problem, search);
    judge(problem, search.state, search);
    solve_exactly(problem, n_failed_attempts > 0 ? 5 : 0, search);
    n_failed_attempts = search.residual < 0.5 * before ? 0 : n_failed_attempts + 1;
  }
}

std::string describe_failure(const MotionProblem &problem, const MotionSearch &search)
{
  const std::string method =
    problem.options.method == ContactSolver::psor ? "projected SOR" : "the active set method";
  return method + " did not bring pressures and free motions into balance within " +
         std::to_string(search.inner.iterations) + " iterations";
}

/** Returns the matrix with columns of norm one; zero columns stay. */
Matrix normalised(Matrix B)
{
  const Vector norms = column_norms(B);
  for (unsigned int i = 0; i < B.m(); ++i)
    for (unsigned int j = 0; j < B.n(); ++j)
      B(i, j) = norms[j] > 0. ? B(i, j) / norms[j] : 0.;
  return B;
}

/** Returns the sum of |B_i|²/C_ii; 1/C_ii where B is zero. */
double contact_stiffness(const Vector &norms, const Vector &diagonal)
{
  double sum = 0.;
  for (unsigned int i = 0; i < norms.size(); ++i)
    sum += norms[i] * norms[i] / diagonal[i];
  return sum > 0. ? sum : (diagonal.size() > 0 ? 1. / diagonal[0] : 1.);
}

bool is_zero(const Vector &v)
{
  return v.size() == 0 || v.all_zero();
}

/** Solves where there is at least one patch, and one motion that the patches or K resist. */
void solve_reduced(const MotionProblem &problem, const Vector &start, MotionResult &result)
{
  MotionSearch search = begin(problem, start);
  iterate(problem, search);
  if (search.residual > problem.options.tolerance && problem.options.method != ContactSolver::psor)
    if (const auto state = descend(*problem.C,
                                   problem.F,
                                   problem.motions,
                                   20 * problem.F.size() + 100,
                                   search.inner.iterations))
      judge(problem, *state, search);
  result.qp = search.inner;
  result.qp.P = search.best.P;
  result.qp.kkt_residual = search.residual;
  result.qp.converged = search.residual <= problem.options.tolerance;
  result.qp.unique = !problem.options.may_be_singular || is_only_solution(problem, search.best);
  result.q = problem.motions.original(search.best.z);
  result.outer_iterations = search.outer_iterations;
  if (!result.qp.converged)
    result.failure = describe_failure(problem, search);
}
} // namespace

MotionResult solve_dual_problem(const Compliance &C,
                                const Vector &F,
                                const FreeMotions &motions,
                                const Vector &start,
                                const DualSolverOptions &options)
{
  const unsigned int m = F.size();
  const bool nothing_happens =
    is_zero(motions.b) &&
    std::all_of(F.begin(), F.end(), [](const double F_i) { return F_i >= 0.; });
  const bool have_both = m > 0 && motions.b.size() > 0;
  check_sizes(motions, m);
  const Vector norms = have_both ? row_norms(normalised(motions.B)) : Vector(m);
  Vector diagonal(m);
  if (nothing_happens || !have_both)
    std::fill(diagonal.begin(), diagonal.end(), 1.);
  else
    diagonal = diagonal_guess(*C, F, norms);
  const ReducedMotions seen(motions, m, contact_stiffness(norms, diagonal));
  MotionResult result;
  result.unseen = seen.unseen;
  result.escape = seen.escape;
  result.q.reinit(motions.b.size());
  result.qp.P.reinit(m);
  if (seen.escape)
    return result;
  if (seen.size() == 0)
    result.qp = solve_dual_problem(C, F, start, options);
  else if (m == 0 || nothing_happens)
  {
    result.q = seen.original(is_zero(seen.b) ? seen.b : SmallCholesky(seen.K).solve(seen.b));
    result.qp.converged = true;
  }
  else
    solve_reduced({C, F, seen, diagonal, options}, start, result);
  return result;
}
} // namespace Signorini
