// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/contact_iteration/contact_iteration.h>

#include <deal.II/lac/full_matrix.h>

#include <deque>

namespace Signorini
{
/** A step of the iteration from U and P. */
struct ContactStep
{
  /** r = f + D P - A U, z = V r. */
  NodalVector r, z;
  /** d = Q - P, t C^_1 d. */
  dealii::Vector<double> d, C_d;

  /** (z.V^{-1} z + d.t C^_1 d)^{1/2}. */
  double size() const;
};

/**
 * Anderson's acceleration: the next (U, P) is taken where the step, as the linear combination of
 * the last ones, is smallest in the norm of ContactStep::size(). Between changes of the set {P < 0}
 * the iteration is linear, and this is a restarted method of minimal residuals for it.
 *
 * Two differences are kept, in single precision: 24 bytes per degree of freedom. (Relative errors
 * of differences matter, which fall with the step.)
 */
class Acceleration
{
public:
  /** Goes from U and P by @p step, or farther. @param same_set whether the step leaves the set as
   * it is; otherwise nothing before counts. */
  void advance(NodalVector &U, dealii::Vector<double> &P, const ContactStep &step, bool same_set);
  /** Nothing before counts. */
  void forget();

private:
  using Floats = dealii::Vector<float>;

  /** What changed from one point to the next: the point, and the step there. */
  struct Difference
  {
    Floats U, z;
    dealii::Vector<double> P, d, C_d;
  };

  void remember(const ContactStep &step);
  /** The coefficients of the differences. */
  dealii::Vector<double> coefficients(const ContactStep &step) const;

  std::deque<Difference> differences_;
  /** products_[i][j]: those of differences of steps. */
  std::deque<std::deque<double>> products_;
  bool has_last_ = false;
  /** The last step, and where it led. */
  Floats last_r_, last_z_, last_increment_;
  dealii::Vector<double> last_d_, last_C_d_, last_P_increment_;
};
} // namespace Signorini
