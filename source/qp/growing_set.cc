// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem on the patches that can touch.

#include <signorini/qp/growing_set.h>

#include <algorithm>

namespace Signorini
{
namespace
{
using Vector = dealii::Vector<double>;
using Indices = std::vector<unsigned int>;

Vector restrict_to(const Indices &K, const Vector &v)
{
  Vector part(K.size());
  for (unsigned int i = 0; i < K.size(); ++i)
    part[i] = v[K[i]];
  return part;
}

/** The indices outside of K that @p is_wanted chooses. */
template <typename Predicate>
Indices find_outside(const Indices &K, const unsigned int m, const Predicate &is_wanted)
{
  Indices found;
  for (unsigned int i = 0; i < m; ++i)
    if (!std::binary_search(K.begin(), K.end(), i) && is_wanted(i))
      found.push_back(i);
  return found;
}
} // namespace

QPResult solve_on_growing_set(const ComplianceOperator &C,
                              const Vector &F,
                              const Vector &start,
                              const QPSolver &solve)
{
  const unsigned int m = F.size();
  QPResult whole;
  whole.P = start.size() > 0 ? start : Vector(m);
  Indices K;
  const auto presses = [&](const unsigned int i) { return i < m && whole.P[i] < 0.; };
  // Ends of contact move by a patch or so; i - 1 wraps around at zero.
  Indices joining = find_outside(
    K, m, [&](const unsigned int i) { return presses(i) || presses(i - 1) || presses(i + 1); });
  const bool has_start = !joining.empty();
  if (!has_start)
    joining = find_outside(K, m, [&](const unsigned int i) { return F[i] < 0.; });
  whole.converged = joining.empty(); // then P = 0 it is
  for (bool first = true; !joining.empty(); first = false)
  {
    K.insert(K.end(), joining.begin(), joining.end());
    std::sort(K.begin(), K.end());
    const QPResult on_K = solve(BoundConstrainedQP(submatrix(C, K), restrict_to(K, F)),
                                first && !has_start ? Vector() : restrict_to(K, whole.P));
    whole.P = 0.;
    for (unsigned int i = 0; i < K.size(); ++i)
      whole.P[K[i]] = on_K.P[i];
    whole.iterations += on_K.iterations;
    whole.kkt_residual = on_K.kkt_residual;
    whole.converged = on_K.converged;
    whole.cycled = whole.cycled || on_K.cycled;
    whole.unique = on_K.unique;
    whole.active_set_failure = on_K.active_set_failure;
    const Vector C_P = C.apply(whole.P);
    joining = find_outside(K, m, [&](const unsigned int i) { return C_P[i] - F[i] > 0.; });
  }
  return whole;
}
} // namespace Signorini
