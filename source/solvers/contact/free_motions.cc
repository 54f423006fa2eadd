// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem with free motions as multipliers of balances, and the motions that escape.

#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/free_motions.h>

#include <deal.II/lac/householder.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
using Vector = dealii::Vector<double>;
using Matrix = FullMatrix<double>;
using Indices = ComplianceOperator::Indices;

/** Returns the norms of the columns of B; zero if below 1e-12 of the largest, as for normals (0, 1)
 * and motions along x. */
Vector column_norms(const Matrix &B) {
  Vector norms(B.n());
  for (unsigned int j = 0; j < B.n(); ++j)
    for (unsigned int i = 0; i < B.m(); ++i)
      norms[j] = std::hypot(norms[j], B(i, j));
  const double largest = *std::max_element(norms.begin(), norms.end());
  for (double &norm : norms)
    norm = norm > 1e-12 * largest ? norm : 0.;
  return norms;
}

/** Returns the unit of each motion: 1/|B_j|, or by its resistance, or as large as the others. */
Vector units_of(const FreeMotions &motions, const Vector &norms, const double stiffness) {
  const double largest = norms.linfty_norm();
  Vector units(norms.size());
  for (unsigned int j = 0; j < units.size(); ++j)
    if (norms[j] > 0.)
      units[j] = 1. / norms[j];
    else if (motions.K(j, j) > 1e-12 * stiffness * largest * largest)
      units[j] = std::sqrt(stiffness / motions.K(j, j));
    else
      units[j] = largest > 0. ? 1. / largest : 1.;
  return units;
}

/** Returns units_i v_i, where v is scaled so that the largest |v_i| is one. */
Vector with_units(Vector v, const Vector &units) {
  const double largest = v.linfty_norm();
  for (unsigned int i = 0; i < v.size(); ++i)
    v[i] = std::abs(v[i]) > 1e-10 * largest ? units[i] * v[i] / largest : 0.;
  return v;
}

/** The y ≥ 0 with the smallest |b - Σ y_i a_i|, and the remainder r = b - Σ y_i a_i. */
struct ConeProjection {
  Vector y, remainder;
};

/** Returns the y with the smallest |b - Σ y_i a_i| for i in S regardless of signs, zero elsewhere.
 */
Vector least_squares(const std::vector<Vector> &a, const Indices &S, const Vector &b) {
  Vector y(a.size()), y_S(S.size());
  if (S.empty())
    return y;
  Matrix A(b.size(), S.size());
  for (unsigned int i = 0; i < b.size(); ++i)
    for (unsigned int j = 0; j < S.size(); ++j)
      A(i, j) = a[S[j]][i];
  Householder<double>(A).least_squares(y_S, b);
  for (unsigned int j = 0; j < S.size(); ++j)
    y[S[j]] = y_S[j];
  return y;
}

/**
 * Projects b on the cone of the directions a_i, of norm one or zero. The remainder has a_i.r ≤ 0
 * and r.b = |r|². (C. L. Lawson, R. J. Hanson: Solving Least Squares Problems, 1974, chapter 23.)
 */
ConeProjection project_on_cone(const std::vector<Vector> &a, const Vector &b) {
  constexpr double rounding = 1e-13;
  Indices S;
  ConeProjection found = {Vector(a.size()), b};
  const double small = rounding * b.l2_norm();
  // |r| falls in each turn, so no set comes back; the bound is for rounding.
  for (unsigned int turn = 0; turn < 3 * a.size() + 10 && S.size() < b.size(); ++turn) {
    const auto rate = [&](const Vector &direction) { return direction * found.remainder; };
    const auto best =
      std::max_element(a.begin(), a.end(), [&](const Vector &first, const Vector &second) {
        return rate(first) < rate(second);
      });
    if (best == a.end() || rate(*best) <= small)
      break;
    S.push_back(best - a.begin());
    Vector y = found.y, wanted = least_squares(a, S, b);
    const auto is_negative = [&](const unsigned int i) { return wanted[i] <= 0.; };
    while (std::any_of(S.begin(), S.end(), is_negative)) {
      // To the first y_i that vanishes, which leaves the set.
      const auto part_to_zero = [&](const unsigned int i) {
        return !is_negative(i) ? 2. : y[i] > 0. ? y[i] / (y[i] - wanted[i]) : 0.;
      };
      const auto leaving =
        std::min_element(S.begin(), S.end(), [&](const unsigned int i, const unsigned int j) {
          return part_to_zero(i) < part_to_zero(j);
        });
      const double part = part_to_zero(*leaving);
      y.sadd(1. - part, part, wanted);
      y[*leaving] = 0.;
      S.erase(leaving);
      wanted = least_squares(a, S, b);
    }
    Vector next = b;
    for (const unsigned int i : S)
      next.add(-wanted[i], a[i]);
    if (next.l2_norm() >= found.remainder.l2_norm())
      break;
    found = {wanted, next};
  }
  return found;
}

/** A generator of the cone of admissible P: P_n = -1, with friction also P_t. */
struct Generator {
  unsigned int n, t;
  double P_t;
};

/** Returns the generators of {P ≤ 0}, or of Coulomb's cone: two edges per patch. */
std::vector<Generator> generators_of(const AdmissibleSet &K) {
  std::vector<Generator> generators;
  for (unsigned int i = 0, n = K.n_normal(); i < n; ++i)
    if (const double f = K.has_tangential_part() ? K.coefficient(n + i) : 0.; f > 0.)
      generators.insert(generators.end(), {{i, n + i, f}, {i, n + i, -f}});
    else
      generators.push_back({i, 0, 0.});
  return generators;
}

/** Finds P ≤ 0, with friction in Coulomb's cone, so that Π(b + Bᵀ P) = 0 for a projector Π.
 * @return the remainder of Π b. */
Vector balance(const Matrix &projector, const AdmissibleSet &K, Balances &balances) {
  const unsigned int n = balances.size();
  const std::vector<Generator> generators = generators_of(K);
  std::vector<Vector> directions(generators.size(), Vector(n));
  Vector norms(generators.size()), row(n), b(n);
  for (unsigned int i = 0; i < generators.size(); ++i) {
    const auto [P_n, P_t, share] = generators[i];
    for (unsigned int j = 0; j < n; ++j)
      row[j] = balances.B(P_n, j) - (share != 0. ? share * balances.B(P_t, j) : 0.);
    projector.vmult(directions[i], row);
    norms[i] = directions[i].l2_norm();
  }
  const double small = norms.size() > 0 ? 1e-12 * norms.linfty_norm() : 0.;
  for (unsigned int i = 0; i < directions.size(); ++i)
    directions[i] *= norms[i] > small ? 1. / norms[i] : 0.;
  projector.vmult(b, balances.b);
  const ConeProjection found = project_on_cone(directions, b);
  for (unsigned int i = 0; i < directions.size(); ++i)
    if (found.y[i] > 0.) {
      balances.P[generators[i].n] -= found.y[i] / norms[i];
      if (generators[i].P_t != 0.)
        balances.P[generators[i].t] += generators[i].P_t * found.y[i] / norms[i];
    }
  return found.remainder;
}

/** The same for intervals (Tresca's friction): P minimises |Π(b + Bᵀ P)|² with a small multiple of
 * |P|². */
Vector balance_in_intervals(const Matrix &projector, const AdmissibleSet &K, Balances &balances) {
  constexpr double small = 1e-12;
  const unsigned int m = balances.P.size();
  Matrix C(m, m);
  C.triple_product(projector, balances.B, balances.B, false, true);
  Vector F(m), left(balances.size()), rest(balances.b);
  projector.vmult(left, balances.b);
  // Where the stiffness resists all motions, contact has nothing to balance.
  if (C.trace() == 0.)
    return left;
  C.diagadd(small * C.trace());
  balances.B.vmult(F, left);
  F *= -1.;
  balances.P = solve_by_active_set({std::make_shared<const DenseCompliance>(C), F, K}, {}, {}).P;
  balances.B.Tvmult_add(rest, balances.P);
  projector.vmult(left, rest);
  return left;
}
} // namespace

ReducedMotions::ReducedMotions(const FreeMotions &motions, const AdmissibleSet &admissible,
                               const double stiffness) {
  const unsigned int k = motions.b.size(), m = admissible.size();
  const Vector norms = m > 0 ? column_norms(motions.B) : Vector(k);
  const Vector units = units_of(motions, norms, stiffness);
  // B, K and b without units.
  Matrix B(m, k), K(k, k);
  Vector b(motions.b), size_of_b(k);
  b.scale(units);
  if (motions.b_magnitude.size() > 0)
    size_of_b = motions.b_magnitude;
  size_of_b.scale(units);
  for (unsigned int j = 0; j < k; ++j) {
    for (unsigned int i = 0; i < m; ++i)
      B(i, j) = norms[j] > 0. ? motions.B(i, j) * units[j] : 0.;
    for (unsigned int i = 0; i < k; ++i)
      K(i, j) = 0.5 * (motions.K(i, j) + motions.K(j, i)) * units[i] * units[j];
  }
  const double noise = 1e-9 * std::max(b.l2_norm(), size_of_b.l2_norm());
  const Splitting by_K(K, 1e-14 * k * K.linfty_norm() + 1e-12 * stiffness);
  Matrix resistance = projector_on(by_K.rest, k);
  if (m > 0)
    B.Tmmult(resistance, B, true);
  const Splitting by_resistance(resistance, 1e-14);
  const Matrix &hidden = by_resistance.null, &seen = by_resistance.rest;
  T = seen;
  for (unsigned int i = 0; i < k; ++i)
    for (unsigned int j = 0; j < T.n(); ++j)
      T(i, j) *= units[i];
  Vector work(k);
  projector_on(hidden, k).vmult(work, b);
  if (work.l2_norm() > noise)
    escape = with_units(work, units);
  for (unsigned int j = 0; j < hidden.n() && !escape; ++j) {
    Vector v(k);
    for (unsigned int i = 0; i < k; ++i)
      v[i] = hidden(i, j);
    neutral.push_back(with_units(v, units));
  }
  const unsigned int n = seen.n();
  if (n == 0 || escape)
    return;
  balances = {Matrix(m, n), Matrix(n, n), Vector(n), Vector(m)};
  if (m > 0)
    B.mmult(balances.B, seen);
  seen.Tvmult(balances.b, b);
  const Matrix free = projector_on(by_K.null, k), resisted = projector_on(by_K.rest, k);
  Matrix projector(n, n), K_without_rounding(k, k);
  projector.triple_product(free, seen, seen, true);
  K_without_rounding.triple_product(K, resisted, resisted);
  balances.K.triple_product(K_without_rounding, seen, seen, true);
  const Vector left = admissible.has_tangential_part() && !admissible.moves()
                        ? balance_in_intervals(projector, admissible, balances)
                        : balance(projector, admissible, balances);
  if (left.l2_norm() > noise) {
    seen.vmult(work, left);
    escape = with_units(work, units);
  }
}

namespace {
/** Returns the sum of |B_i|²/C_ii, columns of B having norm one, as if all patches were like the
 * one that sees most of the motions: one column of C suffices. */
double contact_stiffness(const ComplianceOperator &C, const Matrix &B) {
  if (B.m() == 0)
    return 1.;
  const Vector norms = column_norms(B);
  double largest = 0.;
  unsigned int best = 0;
  for (unsigned int i = 0; i < B.m(); ++i) {
    double square = 0.;
    for (unsigned int j = 0; j < B.n(); ++j)
      square += norms[j] > 0. ? std::pow(B(i, j) / norms[j], 2) : 0.;
    if (square > largest) {
      largest = square;
      best = i;
    }
  }
  return std::max(largest, 1. / B.m()) * B.m() / C.columns({best})(best, 0);
}

/** Returns the pressure of a body on separate springs of the given stiffness (Winkler's bedding): a
 * start that costs no column of C. C_ii grows like the square of the length of a patch, as |B_i|²
 * does. */
Vector on_springs(const Vector &F, const Balances &balances, const double stiffness) {
  const unsigned int m = F.size();
  Matrix springs(m, m);
  double largest = 0.;
  for (unsigned int i = 0; i < m; ++i) {
    for (unsigned int j = 0; j < balances.size(); ++j)
      springs(i, i) += std::pow(balances.B(i, j), 2) * m / stiffness;
    largest = std::max(largest, springs(i, i));
  }
  for (unsigned int i = 0; i < m; ++i)
    springs(i, i) = largest > 0. ? std::max(springs(i, i), 0.01 * largest) : 1.;
  return solve_by_active_set(BoundConstrainedQP(springs, F, balances), {}, {}).P;
}

/**
 * Returns the steady sliding in the direction of the loads, if a single motion slides along the
 * patches that press: with the body far ahead of where it was, all of them slip, and the other
 * motions balance.
 * @param stiffness that of the contact patches, by contact_stiffness().
 * @param presses P of the patches along which it may slide.
 */
std::optional<Sliding> steady_sliding(const std::shared_ptr<const ComplianceOperator> &C,
                                      const Vector &F, const AdmissibleSet &K,
                                      const FreeMotions &motions, const double stiffness,
                                      const DualSolverOptions &options, const Vector &presses) {
  constexpr double far = 100.;
  const unsigned int k = motions.b.size(), m = F.size() / 2;
  Matrix closing(k, k);
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j < k; ++j)
      for (unsigned int l = 0; l < k && presses[i] < 0.; ++l)
        closing(j, l) += motions.B(i, j) * motions.B(i, l);
  const Splitting split_motions(closing, 1e-14 * closing.trace());
  const Matrix &others = split_motions.rest;
  if (split_motions.null.n() != 1)
    return {};
  Sliding sliding = {Vector(k), 0., 0.};
  for (unsigned int j = 0; j < k; ++j)
    sliding.v[j] = split_motions.null(j, 0);
  sliding.load = motions.b * sliding.v;
  sliding.v *= sliding.load < 0. ? -1. : 1.;
  sliding.load = std::abs(sliding.load);
  const unsigned int n = others.n();
  FreeMotions rest = {Matrix(2 * m, n), Matrix(n, n), Vector(n)};
  Vector slip(2 * m), moved(F);
  motions.B.vmult(slip, sliding.v);
  // Forces on plates press also where F, the closing by other loads, is zero.
  double closing_size = F.linfty_norm();
  const Vector norms = column_norms(motions.B);
  for (unsigned int j = 0; j < k; ++j)
    closing_size += norms[j] > 0. ? std::abs(motions.b[j]) / (norms[j] * stiffness) : 0.;
  moved.add(-far * closing_size / slip.linfty_norm(), slip);
  if (n > 0) {
    motions.B.mmult(rest.B, others);
    rest.K.triple_product(motions.K, others, others, true);
    others.Tvmult(rest.b, motions.b);
  }
  const MotionResult found = solve_dual_problem(C, moved, K, rest, {}, options);
  sliding.resistance = -(found.qp.P * slip);
  // Where a patch does not slip, the body turns about it.
  const double limit = K.at(found.qp.P).dissipation(slip);
  const bool slides = found.qp.converged && sliding.resistance > (1. - 1e-9) * limit;
  sliding.P = found.qp.P;
  return slides ? std::optional(sliding) : std::nullopt;
}

/** Returns the motion in which all patches open, if the loads drive one where there is no friction:
 * once it has begun, nothing touches. */
std::optional<Vector> departure(const FreeMotions &motions, const AdmissibleSet &K,
                                const double stiffness) {
  FreeMotions normal = motions;
  normal.B = Matrix(K.n_normal(), motions.B.n());
  for (unsigned int i = 0; i < normal.B.m(); ++i)
    for (unsigned int j = 0; j < normal.B.n(); ++j)
      normal.B(i, j) = motions.B(i, j);
  const std::optional<Vector> v =
    ReducedMotions(normal, AdmissibleSet::nonpositive(K.n_normal()), stiffness).escape;
  Vector closing(K.n_normal());
  if (v)
    normal.B.vmult(closing, *v);
  const double small = 1e-8 * closing.linfty_norm();
  return std::all_of(closing.begin(), closing.end(), [small](const double x) { return x < -small; })
           ? v
           : std::nullopt;
}
} // namespace

MotionResult solve_dual_problem(const std::shared_ptr<const ComplianceOperator> &C, const Vector &F,
                                const AdmissibleSet &K, const FreeMotions &motions,
                                const Vector &start, const DualSolverOptions &options) {
  const unsigned int m = F.size(), k = motions.b.size();
  MotionResult result;
  if (k == 0) {
    result.qp = solve_dual_problem(C, F, K, start, options);
    return result;
  }
  result.q.reinit(k);
  result.qp.P.reinit(m);
  const bool has_tangential_part = K.has_tangential_part();
  const bool nothing_happens = motions.b.all_zero() && FreeState{{}, F}.nothing_touches(K);
  const double stiffness = nothing_happens ? 1. : contact_stiffness(*C, motions.B);
  const ReducedMotions reduced(motions, K, stiffness);
  result.neutral = reduced.neutral;
  result.escape = reduced.escape;
  result.qp.converged = nothing_happens;
  const auto slides_along_all = [&]() {
    Vector all(m);
    all = -1.;
    return steady_sliding(C, F, K, motions, stiffness, options, all);
  };
  if (reduced.escape && has_tangential_part)
    result.sliding = slides_along_all();
  if (result.sliding && !result.sliding->lasts())
    result.sliding.reset();
  if (reduced.escape || nothing_happens)
    return result;
  const bool needs_start = start.size() == 0 && !C->is_explicit() && !has_tangential_part;
  // A problem that few systems or sweeps do not solve may be close to the limit of sliding.
  DualSolverOptions first = options;
  if (K.moves())
    first.maximum_iterations =
      std::min(options.maximum_iterations, options.method == ContactSolver::psor ? 2000U : 50U);
  result.qp =
    solve_dual_problem(C, F, K, needs_start ? on_springs(F, reduced.balances, stiffness) : start,
                       first, reduced.balances);
  if (!result.qp.converged && has_tangential_part) {
    std::optional<Sliding> sliding = slides_along_all();
    if (!sliding) {
      // Sweeps follow the body while it slides along some of its contact sides.
      const Vector drifting =
        solve_by_psor({C, F, K, reduced.balances}, {}, {options.tolerance, 2000, 1.}).P;
      sliding = steady_sliding(C, F, K, motions, stiffness, options, drifting);
    }
    if (sliding && sliding->lasts()) {
      result.sliding = sliding;
      result.escape = sliding->v;
    } else
      result.qp =
        solve_dual_problem(C, F, K, sliding ? sliding->P : result.qp.P, options, reduced.balances);
    if (!result.qp.converged && !result.escape)
      result.escape = departure(motions, K, stiffness);
  }
  if (reduced.balances.size() > 0)
    reduced.T.vmult(result.q, result.qp.z);
  return result;
}
} // namespace Signorini
