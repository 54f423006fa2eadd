// SPDX-License-Identifier: LGPL-2.1-or-later
// The problem on the boundary that follows a V-cycle.

#include <signorini/contact_iteration/boundary_problem.h>
#include <signorini/qp/active_set.h>

namespace Signorini
{
namespace
{
using Vector = dealii::Vector<double>;
using Indices = ComplianceOperator::Indices;

Indices indices_of(const std::vector<bool> &active)
{
  Indices set;
  for (unsigned int i = 0; i < active.size(); ++i)
    if (active[i])
      set.push_back(i);
  return set;
}

/** d with (W + C^ d)_S = 0 and d = -P elsewhere. */
Vector change_on_set(const BoundaryModel &model, const Vector &W, const Vector &P, const Indices &S)
{
  Vector d(P), rhs(S.size());
  d *= -1.;
  for (const unsigned int i : S)
    d[i] = 0.;
  Vector V(W);
  if (d.l2_norm() > 0.)
    V += model.apply(d);
  for (unsigned int r = 0; r < S.size(); ++r)
    rhs[r] = -V[S[r]];
  const Vector d_S = model.solve(S, rhs);
  for (unsigned int r = 0; r < S.size(); ++r)
    d[S[r]] = d_S[r];
  return d;
}

/** By the method that cannot cycle. */
Vector solve_safely(const BoundaryModel &model, const Vector &W, const Vector &P)
{
  // Lives as long as the caller's model.
  const std::shared_ptr<const ComplianceOperator> C(&model, [](const ComplianceOperator *) {});
  Vector F = model.apply(P);
  F -= W;
  return solve_by_active_set(BoundConstrainedQP(C, F, Vector(F.size())), P, {1e-12, 1000}).P;
}
} // namespace

Vector solve_boundary_problem(const BoundaryModel &model, const Vector &W, const Vector &P)
{
  constexpr unsigned int most_steps = 30;
  const unsigned int m = P.size();
  std::vector<bool> active(m);
  for (unsigned int i = 0; i < m; ++i)
    active[i] = P[i] < 0. || W[i] > 0.;
  for (unsigned int k = 0; k < most_steps; ++k)
  {
    const Vector d = change_on_set(model, W, P, indices_of(active));
    Vector Q(P), V = model.apply(d);
    Q += d;
    V += W;
    std::vector<bool> next(m);
    for (unsigned int i = 0; i < m; ++i)
      next[i] = active[i] ? Q[i] < 0. : V[i] > 0.;
    if (next == active)
    {
      for (unsigned int i = 0; i < m; ++i)
        Q[i] = active[i] ? Q[i] : 0.;
      return Q;
    }
    active = next;
  }
  return solve_safely(model, W, P);
}
} // namespace Signorini
