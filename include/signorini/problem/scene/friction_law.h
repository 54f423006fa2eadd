// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/options.h>

#include <deal.II/base/function.h>
#include <deal.II/base/point.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini {
template <int dim>
struct ContactCondition;
struct ContactParameters;
template <typename T>
struct Given;

/** A limit of the traction |q| along a contact side: a function of the contact, or this times |p|.
 */
template <int dim>
struct FrictionLimit {
  /** As in "friction coefficient". */
  const char *name;
  /** The function, among the data of the contact. */
  std::shared_ptr<const dealii::Function<dim>> ContactCondition<dim>::*data;
  bool follows_pressure;
  /** The entry that gives the function. */
  Given<std::string> ContactParameters::*entry;
};

/** The law of friction of the contact sides: the limits of |q|, of which the least counts. Contact
 * without friction has none, and no tangential part. */
template <int dim>
class FrictionLaw {
public:
  FrictionLaw(const Friction kind = Friction::none) // NOLINT(google-explicit-constructor)
    : kind_(kind) {}

  /** Returns whether there is a traction q along the contact sides. */
  bool has_tangential_part() const {
    return kind_ != Friction::none;
  }
  const std::vector<FrictionLimit<dim>> &limits() const;
  /** Returns the bound of |q| at a point of a contact side with the traction @p p along the
   * direction of contact; infinite without limits. */
  double bound(const ContactCondition<dim> &contact, const dealii::Point<dim> &x, double p) const;
  /** Returns the name, as in the parameter file. */
  std::string name() const {
    return to_text(kind_);
  }
  /** Returns whether an entry gives one of the limits; without an entry, whether there are any. */
  bool reads(Given<std::string> ContactParameters::*entry = nullptr) const;
  /** Returns the names of the laws that read an entry: "tresca or coulomb". */
  static std::string names(Given<std::string> ContactParameters::*entry = nullptr);

private:
  Friction kind_;
};
} // namespace Signorini
