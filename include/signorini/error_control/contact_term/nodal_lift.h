// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/contact_term/contact_trace.h>
#include <signorini/solvers/contact/dual_problem.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <optional>
#include <vector>

namespace Signorini
{
/** The matrix C = Eᵀ A⁻¹ E with the columns E of those conditions at contact nodes that A⁻¹
 * lets move, and two problems with it. Where the factors hold C, these problems are solved with the
 * matrix. Otherwise the kernel of the half-space takes its place and is improved by products with
 * C, each of which costs a solve. The number of solves does not grow with that of contact nodes. */
class NodalCompliance
{
public:
  /** Selects the conditions and prepares C. All arguments must outlive the object. The constructor,
   * press() and solve() are collective. */
  NodalCompliance(const DisplacementSpace<2> &space,
                  const ContactTrace &trace,
                  const StiffnessInverse &inverse);

  /** Returns the numbers of the columns of E among ContactTrace::conditions(). There are none where
   * C is not explicit and has too many columns for a dense kernel. */
  const std::vector<unsigned int> &numbers() const
  {
    return numbers_;
  }
  /** Returns E. */
  const Coupling &columns() const
  {
    return E_;
  }
  /** Returns Q ≤ 0 with C Q - F ≤ 0 and Q.(C Q - F) = 0. */
  dealii::Vector<double> press(const dealii::Vector<double> &F,
                               const dealii::Vector<double> &start);
  /** Returns Q with C Q = F. */
  dealii::Vector<double> solve(const dealii::Vector<double> &F);

private:
  using Vector = dealii::Vector<double>;

  /** Solves a problem with C, where solve_with(M, F, Q) solves it with the matrix M instead: Q
   * moves towards the solution with M and F - (C - M) Q as far as C allows. Each step d costs the
   * solve for C d and changes M by the formula of Broyden, Fletcher, Goldfarb and Shanno, so that M
   * d = C d. */
  template <typename SolveWith>
  Vector iterate(const Vector &F, const SolveWith &solve_with);

  std::vector<unsigned int> numbers_;
  Coupling E_;
  double seconds_ = 0.;
  std::shared_ptr<const ComplianceOperator> C_;
  /** The matrix M, which is at first Ĉ for constant pressures around the nodes; empty where C is
   * explicit. */
  FullMatrix<double> model_;
};

/**
 * Returns a w_h in V^h, zero on essential boundaries, with w_{h,n} ≥ required at all conditions of
 * the trace: it has the nodal values of the layer ω(s) (1 - y/D)_+ n below each contact side, y
 * the distance from the side. ω is linear between contact nodes: it takes the required value at
 * nodes next to pressing faces, and its positive part elsewhere.
 *
 * On a strip with constant moduli, a layer of the depth D = (3 C_nn ∫ ω² / (C_nt ∫
 * ω'²))^{1/2} has the least bound of the energy; D is at most the shortest extent of the body.
 * At contact nodes themselves the conditions decide (a corner has two). There is no solve.
 */
Displacement layer_lift(const DisplacementSpace<2> &space,
                        const Scene<2> &scene,
                        const ContactTrace &trace);

/** Returns the required values of all conditions. */
dealii::Vector<double> required_values(const ContactTrace &trace);

/** Returns required values with which w_h alone removes penetration inside of faces that do not
 * press: both free ends of such a face get the largest d, if it is positive. Where contact was
 * missed, the wide w_h costs much less energy than a narrow one inside the face. Returns none if
 * the values are required_values(). */
std::optional<dealii::Vector<double>> raised_values(const ContactTrace &trace);

/**
 * Returns the w_h in V^h that minimises 1/2 a(w_h, w_h) - ∫ p_H w_{h,n} over w_{h,n} ≥ required:
 * with the matrix E of the conditions (w_n = Eᵀ w) and multipliers Q,
 *
 *     A w = D P - E Q,   Q ≤ 0,
 *     V = Eᵀ A⁻¹ E Q - (Eᵀ A⁻¹ D P - required) ≤ 0,   Qᵀ V = 0,
 *
 * solved like the dual problem of the scene. It takes one solve with a trailing factor, otherwise
 * two and one per contact node that is needed. Collective.
 */
Displacement dual_lift(const DisplacementSpace<2> &space,
                       const ContactTrace &trace,
                       const Coupling &condensed_D,
                       const StiffnessInverse &inverse,
                       const Pressure &P,
                       const dealii::Vector<double> &required);

/** Returns a z in V^h of small energy that is zero on essential boundaries and has z_n = 1 on
 * Γ_c; none where a contact node is held. Collective. */
std::optional<Displacement> unit_normal_lift(const DisplacementSpace<2> &space,
                                             const ContactTrace &trace,
                                             const StiffnessInverse &inverse);
} // namespace Signorini
