// SPDX-License-Identifier: LGPL-2.1-or-later
// A body on separate springs.

#include <signorini/solvers/kinematics/bedding.h>
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

Vector pressure_at(const ReducedMotions &motions, const Vector &F, const Vector &c, const Vector &z)
{
  Vector P = times(motions.B, z);
  for (unsigned int i = 0; i < P.size(); ++i)
    P[i] = std::min(0., F[i] - P[i]) / c[i];
  return P;
}

double energy_at(const ReducedMotions &motions, const Vector &F, const Vector &c, const Vector &z)
{
  const Vector P = pressure_at(motions, F, c, z);
  double energy = 0.5 * (times(motions.K, z) * z) - motions.b * z;
  for (unsigned int i = 0; i < P.size(); ++i)
    energy += 0.5 * c[i] * P[i] * P[i];
  return energy;
}

/** Returns K + sum of B_i B_iᵀ/c_i, where springs that are open count only with the part @p open.
 */
Matrix
stiffness_at(const ReducedMotions &motions, const Vector &c, const Vector &P, const double open)
{
  Matrix H = motions.K;
  for (unsigned int r = 0; r < P.size(); ++r)
    for (unsigned int i = 0; i < H.m(); ++i)
      for (unsigned int j = 0; j < H.m(); ++j)
        H(i, j) += (P[r] < 0. ? 1. : open) / c[r] * motions.B(r, i) * motions.B(r, j);
  return H;
}
} // namespace

MotionState solve_on_bedding(const ReducedMotions &motions, const Vector &F, const Vector &c)
{
  // The first step assumes that all springs press.
  Vector load = F;
  for (unsigned int i = 0; i < F.size(); ++i)
    load[i] /= c[i];
  Vector z = transpose_times(motions.B, load);
  z += motions.b;
  z = SmallCholesky(stiffness_at(motions, c, load, 1.)).solve(z);
  Vector P = pressure_at(motions, F, c, z);
  for (unsigned int step = 0; step < 50; ++step)
  {
    const Vector missing = motions.imbalance(P, z);
    Vector direction = SmallCholesky(stiffness_at(motions, c, P, 1e-6)).solve(missing);
    const double slope = direction * missing, before = energy_at(motions, F, c, z);
    unsigned int halvings = 0;
    Vector next = z;
    for (next += direction; halvings < 40 && energy_at(motions, F, c, next) > before - 1e-4 * slope;
         ++halvings)
    {
      direction *= 0.5;
      next = z;
      next += direction;
    }
    if (halvings == 40)
      break;
    z = next;
    P = pressure_at(motions, F, c, z);
    if (missing.l2_norm() <= 1e-9 * std::max(motions.b.l2_norm(), P.l2_norm()))
      break;
  }
  return {P, z};
}

// The compliance of a body with motions against a stiffness.

StiffenedCompliance::StiffenedCompliance(std::shared_ptr<const ComplianceOperator> C,
                                         const Matrix &B,
                                         const SmallCholesky &Q)
  : C_(std::move(C))
  , V_(B.m(), B.n())
{
  Vector row(B.n());
  for (unsigned int i = 0; i < B.m(); ++i)
  {
    for (unsigned int j = 0; j < B.n(); ++j)
      row[j] = B(i, j);
    const Vector scaled = Q.forward(row);
    for (unsigned int j = 0; j < B.n(); ++j)
      V_(i, j) = scaled[j];
  }
}

double StiffenedCompliance::by_motion(const unsigned int i, const unsigned int j) const
{
  double sum = 0.;
  for (unsigned int l = 0; l < V_.n(); ++l)
    sum += V_(i, l) * V_(j, l);
  return sum;
}

unsigned int StiffenedCompliance::size() const
{
  return C_->size();
}

StiffenedCompliance::Vector StiffenedCompliance::apply(const Vector &P) const
{
  Vector product = C_->apply(P);
  product += times(V_, transpose_times(V_, P));
  return product;
}

StiffenedCompliance::Vector StiffenedCompliance::diagonal() const
{
  Vector diagonal = C_->diagonal();
  for (unsigned int i = 0; i < diagonal.size(); ++i)
    diagonal[i] += by_motion(i, i);
  return diagonal;
}

StiffenedCompliance::Matrix StiffenedCompliance::columns(const Indices &numbers) const
{
  Matrix columns = C_->columns(numbers);
  for (unsigned int i = 0; i < size(); ++i)
    for (unsigned int j = 0; j < numbers.size(); ++j)
      columns(i, j) += by_motion(i, numbers[j]);
  return columns;
}

const StiffenedCompliance::Matrix &StiffenedCompliance::dense() const
{
  if (dense_.m() == 0)
  {
    dense_ = C_->dense();
    for (unsigned int i = 0; i < size(); ++i)
      for (unsigned int j = 0; j < size(); ++j)
        dense_(i, j) += by_motion(i, j);
  }
  return dense_;
}

bool StiffenedCompliance::is_explicit() const
{
  return C_->is_explicit();
}

// A primal active set method that keeps forces in balance.

namespace
{
using Vector = dealii::Vector<double>;
using Matrix = FullMatrix<double>;

/** Returns P ≤ 0 with Bᵀ P = -b on few patches; nothing if K resists, where every P will do. */
std::optional<Vector> pressure_in_balance(const ReducedMotions &motions, const unsigned int m)
{
  Matrix directions(motions.size(), m);
  Vector norms(m);
  for (unsigned int i = 0; i < m; ++i)
  {
    for (unsigned int j = 0; j < motions.size(); ++j)
      norms[i] = std::hypot(norms[i], motions.B(i, j));
    for (unsigned int j = 0; j < motions.size(); ++j)
      directions(j, i) = norms[i] > 0. ? motions.B(i, j) / norms[i] : 0.;
  }
  const ConeProjection found = project_on_cone(directions, motions.b, 1e-13);
  if (found.columns.empty() || found.remainder.l2_norm() > 1e-9 * motions.b.l2_norm())
    return {};
  Vector P(m);
  for (unsigned int j = 0; j < found.columns.size(); ++j)
    P[found.columns[j]] = -found.weights[j] / norms[found.columns[j]];
  return P;
}

/** Moves P towards a pressure that pulls somewhere, to the first patch that ceases to press. */
void step_to_first_zero(const Vector &wanted, Vector &P)
{
  double part = 1.;
  unsigned int leaves = P.size();
  for (unsigned int i = 0; i < P.size(); ++i)
    if (P[i] < 0. && wanted[i] > 0.)
    {
      const double here = P[i] / (P[i] - wanted[i]);
      if (here <= part)
      {
        part = here;
        leaves = i;
      }
    }
  for (unsigned int i = 0; i < P.size(); ++i)
    if (P[i] < 0.)
      P[i] = std::min(P[i] + part * (wanted[i] - P[i]), -std::numeric_limits<double>::min());
  if (leaves < P.size())
    P[leaves] = 0.;
}

/** Returns the patch with the largest penetration, measured by its own compliance; none within
 * rounding. */
std::optional<unsigned int> deepest(const ComplianceOperator &C,
                                    const Vector &F,
                                    const ReducedMotions &motions,
                                    const Vector &diagonal,
                                    const MotionState &state)
{
  constexpr double rounding = 1e-13;
  const Vector motion = times(motions.B, state.z);
  Vector W = C.apply(state.P);
  W += motion;
  W -= F;
  const double small = rounding * std::max(F.linfty_norm(), motion.linfty_norm());
  std::optional<unsigned int> found;
  for (unsigned int i = 0; i < W.size(); ++i)
    if (state.P[i] == 0. && W[i] > small &&
        (!found || W[i] / diagonal[i] > W[*found] / diagonal[*found]))
      found = i;
  return found;
}
} // namespace

std::optional<MotionState> descend(const ComplianceOperator &C,
                                   const Vector &F,
                                   const ReducedMotions &motions,
                                   const unsigned int max_solves,
                                   unsigned int &n_solves)
{
  const Vector diagonal = C.diagonal();
  const std::optional<Vector> start = pressure_in_balance(motions, F.size());
  if (!start)
    return {};
  MotionState state = {*start, Vector(motions.size())};
  for (unsigned int step = 0; step < max_solves; ++step)
  {
    ++n_solves;
    const auto exact = solve_on_pressing(C, F, motions, state);
    if (!exact)
      return {};
    const Vector &wanted = exact->state.P;
    if (std::any_of(wanted.begin(), wanted.end(), [](const double p) { return p > 0.; }))
    {
      step_to_first_zero(wanted, state.P);
      continue;
    }
    state = exact->state;
    const auto joins = deepest(C, F, motions, diagonal, state);
    if (!joins)
      return state;
    state.P[*joins] = -std::numeric_limits<double>::min();
  }
  return {};
}
} // namespace Signorini
