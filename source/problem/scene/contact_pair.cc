// SPDX-License-Identifier: LGPL-2.1-or-later
// The laws of friction.

#include <signorini/base/instantiate.h>
#include <signorini/problem/scene/contact_pair.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini {
template <int dim>
std::vector<FrictionLimit<dim>> friction_limits(const Friction law) {
  switch (law) {
  case Friction::tresca:
    return {{"friction bound", &BoundaryCondition<dim>::friction, false}};
  case Friction::coulomb:
    return {{"friction coefficient", &BoundaryCondition<dim>::friction, true}};
  case Friction::none:
    break;
  }
  return {};
}

template <int dim>
double ContactPair<dim>::friction_bound(const Point<dim> &x, const double p) const {
  double bound = std::numeric_limits<double>::infinity();
  for (const FrictionLimit<dim> &limit : friction_limits<dim>(scene_.friction)) {
    const double given = (data().*limit.data)->value(x);
    bound = std::min(bound, limit.follows_pressure ? given * std::abs(p) : given);
  }
  return bound;
}

INSTANTIATE_FUNCTION(friction_limits);
template class ContactPair<2>;
template class ContactPair<3>;
} // namespace Signorini
