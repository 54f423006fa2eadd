// SPDX-License-Identifier: LGPL-2.1-or-later
// The laws of friction.

#include <signorini/base/text.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/friction_law.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Signorini {
namespace {
/** Returns the limits of all laws. */
template <int dim>
const std::map<Friction, std::vector<FrictionLimit<dim>>> &all_laws() {
  using Contact = ContactCondition<dim>;
  using Entries = ContactParameters;
  static const FrictionLimit<dim> bound = {"friction bound", &Contact::bound, false,
                                           &Entries::friction_bound};
  static const FrictionLimit<dim> coefficient = {"friction coefficient", &Contact::coefficient,
                                                 true, &Entries::friction_coefficient};
  static const std::map<Friction, std::vector<FrictionLimit<dim>>> laws = {
    {Friction::none, {}}, {Friction::tresca, {bound}}, {Friction::coulomb, {coefficient}}};
  return laws;
}
} // namespace

template <int dim>
const std::vector<FrictionLimit<dim>> &FrictionLaw<dim>::limits() const {
  return all_laws<dim>().at(kind_);
}

template <int dim>
double FrictionLaw<dim>::bound(const ContactCondition<dim> &contact, const Point<dim> &x,
                               const double p) const {
  double bound = std::numeric_limits<double>::infinity();
  for (const FrictionLimit<dim> &limit : limits()) {
    const double given = (contact.*limit.data)->value(x);
    bound = std::min(bound, limit.follows_pressure ? given * std::abs(p) : given);
  }
  return bound;
}

template <int dim>
bool FrictionLaw<dim>::reads(Given<std::string> ContactParameters::*const entry) const {
  return std::any_of(limits().begin(), limits().end(), [&](const FrictionLimit<dim> &limit) {
    return entry == nullptr || limit.entry == entry;
  });
}

template <int dim>
std::string FrictionLaw<dim>::names(Given<std::string> ContactParameters::*const entry) {
  std::vector<std::string> names;
  for (const auto &[kind, limits] : all_laws<dim>())
    if (FrictionLaw(kind).reads(entry))
      names.push_back(to_text(kind));
  return join(names, " or ");
}

template class FrictionLaw<2>;
template class FrictionLaw<3>;
} // namespace Signorini
