// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/bound/contact_trace.h>
#include <signorini/qp/compliance_operator.h>
#include <signorini/stiffness_inverse/stiffness_inverse.h>

#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <vector>

namespace Signorini
{
/**
 * C = E^T A^{-1} E with the columns E of the conditions at contact nodes that A^{-1} lets move, and
 * two problems with it. Where factors hold C, they are solved with the matrix; otherwise with the
 * kernel of the half space in its place, which learns from products with C, each of them a solve.
 * Their number does not grow with that of contact nodes.
 */
class NodalCompliance
{
public:
  /** All must outlive the object. Collective, as are the solutions. */
  NodalCompliance(const DisplacementSpace<2> &space,
                  const ContactTrace &trace,
                  const StiffnessInverse &inverse);

  /** Which of ContactTrace::conditions() the columns of E are; none where C is not explicit and
   * there are too many for a dense kernel. */
  const std::vector<unsigned int> &numbers() const
  {
    return numbers_;
  }
  /** E. */
  const Coupling &columns() const
  {
    return E_;
  }
  /** Q <= 0 with C Q - F <= 0 and Q.(C Q - F) = 0. */
  dealii::Vector<double> press(const dealii::Vector<double> &F,
                               const dealii::Vector<double> &start);
  /** Q with C Q = F. */
  dealii::Vector<double> solve(const dealii::Vector<double> &F);

private:
  using Vector = dealii::Vector<double>;

  /**
   * The solution of a problem with C, where solve_with(M, F, Q) solves it with the matrix M
   * instead: Q moves towards that with M and F - (C - M) Q as far as C allows. Each step d shows C
   * d, a solve, and changes M by the formula of Broyden, Fletcher, Goldfarb and Shanno, so that M d
   * = C d.
   */
  template <typename SolveWith>
  Vector iterate(const Vector &F, const SolveWith &solve_with);

  std::vector<unsigned int> numbers_;
  Coupling E_;
  double seconds_ = 0.;
  std::shared_ptr<const ComplianceOperator> C_;
  /** M, at first C^ for constant pressures around the nodes; empty where C is explicit. */
  dealii::FullMatrix<double> model_;
};
} // namespace Signorini
