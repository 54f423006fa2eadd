// SPDX-License-Identifier: LGPL-2.1-or-later
// A primal active set method that keeps forces in balance.

#include <signorini/qp/descent.h>
#include <signorini/qp/nonnegative_least_squares.h>
#include <signorini/qp/small_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
namespace
{
using Vector = dealii::Vector<double>;
using Matrix = dealii::FullMatrix<double>;

/** P <= 0 with B^T P = -b on few patches; nothing if K resists, where every P will do. */
std::optional<Vector> pressure_in_balance(const SeenMotions &motions, const unsigned int m)
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

/** Goes from P towards a pressure that pulls somewhere, to the first patch that ceases to press. */
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

/** The patch that penetrates most, measured by its own compliance; none within rounding. */
std::optional<unsigned int> deepest(const ComplianceOperator &C,
                                    const Vector &F,
                                    const SeenMotions &motions,
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
                                   const SeenMotions &motions,
                                   const unsigned int most_solves,
                                   unsigned int &n_solves)
{
  const Vector diagonal = C.diagonal();
  const std::optional<Vector> start = pressure_in_balance(motions, F.size());
  if (!start)
    return {};
  MotionState state = {*start, Vector(motions.size())};
  for (unsigned int step = 0; step < most_solves; ++step)
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
