// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/multiplier/multiplier_space.h>

namespace Signorini
{
/**
 * The value below which a pressure presses, -1e-12 max|P|: what a solver leaves of a zero is not
 * contact.
 */
double pressing_threshold(const dealii::Vector<double> &P);

/** What the contact pressure amounts to. */
struct ContactSummary
{
  /** Number of multipliers that press, P_k < pressing_threshold(P): with constants of patches. */
  unsigned int active = 0;
  /** Of constants the total length of the patches that press, in space their area; of polynomials
   * that of the pressed_intervals() (length^{dim-1}). */
  double length = 0.;
  /** -int p_H, positive in compression (force). */
  double normal_force = 0.;
  /** max(-P_k), positive in compression (force/area). */
  double max_pressure = 0.;

  static Columns<ContactSummary> columns();
};

template <int dim>
ContactSummary summarise_contact(const MultiplierSpace<dim> &space,
                                 const dealii::Vector<double> &P);

/**
 * A continuous pressure of second order from the means of p_H over the patches: piecewise linear
 * through the middles of the patches of a side, continued to its ends (around a closed side), and
 * nowhere positive. For a plane body, where a patch has two neighbours. Where patches have
 * polynomials, it is p_H itself, cut off at zero.
 */
class RecoveredPressure
{
public:
  RecoveredPressure(const MultiplierSpace<2> &space, const dealii::Vector<double> &P);

  /** The value at the point @p s of the side to which @p patch belongs; @p patch contains it. */
  double operator()(unsigned int patch, const dealii::Point<1> &s) const;

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

  const MultiplierSpace<2> &space_;
  const ContactSurface<2> &surface_;
  dealii::Vector<double> P_;
  /** By patch. */
  std::vector<double> means_;
};

/** A pressure with the patches that it belongs to, for another partition to start from. */
struct PatchPressure
{
  std::vector<Patch<2>> patches;
  dealii::Vector<double> P;
};

/**
 * P of another partition carried over to the patches of @p to: the mean of the piecewise constant
 * function on each patch (its L2-projection). In the plane, where patches are intervals.
 */
dealii::Vector<double> transfer_pressure(const PatchPressure &from,
                                         const std::vector<Patch<2>> &to);
} // namespace Signorini
