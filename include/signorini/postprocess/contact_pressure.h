// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/multiplier/multiplier_space.h>

namespace Signorini
{
/**
 * The value below which a pressure presses, P_tau < -1e-12 max|P|: what a solver leaves of a zero
 * is not contact.
 */
double pressing_threshold(const dealii::Vector<double> &P);

/** What the contact pressure amounts to. */
struct ContactSummary
{
  /** Number of patches that press, P_tau < pressing_threshold(P). */
  unsigned int active = 0;
  /** Their total length (length). */
  double length = 0.;
  /** -sum P_tau |tau|, positive in compression (force). */
  double normal_force = 0.;
  /** max(-p_H), positive in compression (force/area). */
  double max_pressure = 0.;

  static Columns<ContactSummary> columns();
};

template <int dim>
ContactSummary summarise_contact(const MultiplierSpace<dim> &space,
                                 const dealii::Vector<double> &P);

/**
 * A continuous pressure of second order from the patch means: piecewise linear through the middles
 * of the patches of a side, continued to its ends (around a closed side), and nowhere positive.
 */
template <int dim>
class RecoveredPressure
{
public:
  RecoveredPressure(const MultiplierSpace<dim> &space, const dealii::Vector<double> &P);

  /** The value at arc length @p s of the side to which @p patch belongs; @p patch contains s. */
  double operator()(unsigned int patch, double s) const;

private:
  /** A patch next to another one, and its middle as seen from there. */
  struct Neighbour
  {
    unsigned int patch;
    double middle;
  };
  /** The patch before (step -1) or after (step 1) on the same side; the same patch if there is
   * none.
   */
  Neighbour neighbour(unsigned int patch, int step) const;

  const MultiplierSpace<dim> &space_;
  const dealii::Vector<double> &P_;
};

/**
 * P of another partition carried over to the patches of @p to: the mean of the piecewise constant
 * function on each patch (its L2-projection).
 */
dealii::Vector<double> transfer_pressure(const std::vector<Patch> &from,
                                         const dealii::Vector<double> &P,
                                         const std::vector<Patch> &to);
} // namespace Signorini
