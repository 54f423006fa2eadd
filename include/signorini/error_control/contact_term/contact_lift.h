// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/error_control/contact_term/lift_field.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <memory>
#include <optional>
#include <string>

namespace Signorini
{
/** The method by which the w of a ContactBound was found. */
enum class LiftMethod
{
  /** The nodal values of a boundary layer, see layer_lift(). */
  layer,
  /** The solution of a small dual problem at the contact nodes, see dual_lift(). */
  dual,
  /** The same, with nodes raised so far that nothing is lacking inside of faces, see
   * raised_values(). */
  raised_dual
};

/** The contact part of the bound of the energy error, with its summands. */
struct ContactBound
{
  /** The energy |||w|||² (force x length per thickness). */
  double lift_energy = 0.;
  /** The integral ∫_{Γ_c} τ_n (ũ_n - g - w_n). It is not negative, up to rounding. */
  double contact_term = 0.;
  LiftMethod method = LiftMethod::layer;
  /** The terms 2 ∫_F τ_n (ũ_n - g - w_n) of the faces, in the order of ContactSurface::faces().
   */
  std::vector<double> face_terms;
  /** The part of |||w|||² of every active cell; zero for cells of other ranks. */
  dealii::Vector<double> cell_energies;
  /** The middle of the contact face where the face's term and the energy of its cell are largest.
   */
  SidePlace dominant_part;

  /** Returns c² = |||w|||² + 2 ∫ τ_n (ũ_n - g - w_n). */
  double square() const
  {
    return lift_energy + 2. * contact_term;
  }
};

/**
 * The contact part of the guaranteed bound of the energy error |||u - ũ|||, ũ = u_h or π^{2h} u_h,
 *
 *     c² = |||w|||² + 2 ∫_{Γ_c} τ_n (ũ_n - g - w_n)
 *
 * for a w in V (zero on clamped and prescribed sides, w_n = 0 on rollers) with w_n ≥ d := ũ_n - g
 * on Γ_c. The body is two-dimensional with straight sides.
 *
 * w = w_h + Σ_F r_F ψ_F n, see LiftField. w_h in V^h satisfies w_{h,n} ≥ d at contact nodes.
 * On a face, d is replaced by a piecewise quadratic q ≥ d (EdgeFunction); with its chord Iq, b = q
 * - Iq and the linear function e = w_{h,n} - Iq ≥ 0,
 *
 *     r_F ≥ b - e,   r_F = 0 at both ends.
 *
 * Where the face presses, r_F = max(b - e, min(b, 0)): w_n = q where w_h touches at both ends,
 * since -2 τ_n (w_n - d) counts; elsewhere r_F = max(b - e, 0). Both are piecewise quadratic,
 * with breaks at the zeros of b and b - e as well. Hence w_n = Iq + e + r_F ≥ q ≥ d, and c² ≥ 0.
 *
 * The bound is exact up to rounding, the sampling of g (see interpolate_from_above()) and, with
 * moduli that vary or cells that are no parallelograms, the quadrature of |||w|||².
 *
 * Of the w_h, the cheap layer and the solutions of one or two small dual problems, the one with the
 * smallest c² is kept. The layer is not enough in bending, where it has to be thin.
 *
 * There is none where a held node needs w_n > 0: where contact reaches a clamped side with g < 0,
 * or is pushed into the foundation there. A gap that jumps costs energy but does no harm, since w_n
 * ≥ d may be smooth.
 */
class ContactLift
{
public:
  /** The data of the dual problem: A⁻¹ and D. */
  struct DualData
  {
    const StiffnessInverse &inverse;
    const Coupling &condensed_D;
    /** The layer is kept without a dual problem if its c² is not above this value. */
    double enough = 0.;
  };

  /**
   * Computes the bound. All arguments but @p dual must outlive the object. Collective.
   * @param dual if it is empty, only the layer is tried.
   * @param fields see ContactTrace.
   * @throws InputError where g has no value.
   */
  ContactLift(const DisplacementSpace<2> &space,
              const Scene<2> &scene,
              const MultiplierSpace<2> &multipliers,
              const Displacement &U,
              const Pressure &P,
              const std::optional<DualData> &dual,
              const std::vector<FaceField> &fields = {});

  /** Returns the bound; none where no w exists or none was found, see no_bound(). */
  const std::optional<ContactBound> &bound() const
  {
    return bound_;
  }
  /** Returns the reason why there is no bound, one sentence with the place; empty if there is one.
   */
  const std::string &no_bound() const
  {
    return no_bound_;
  }
  /** Returns d along Γ_c, with its largest value and its place. Needs straight sides and degree
   * one. */
  const ContactTrace &trace() const
  {
    return *trace_;
  }
  /** Returns w. Needs bound(). */
  const LiftField &lift() const
  {
    return *lift_;
  }

private:
  void consider(Displacement w_h, LiftMethod method);
  ContactBound evaluate(const LiftField &lift, LiftMethod method) const;

  const DisplacementSpace<2> &space_;
  const Scene<2> &scene_;
  std::string no_bound_;
  std::unique_ptr<const ContactTrace> trace_;
  std::unique_ptr<const LiftField> lift_;
  std::optional<ContactBound> bound_;
};

/** Returns |||z||| of a z in V^h that is zero on essential boundaries and has z_n = 1 on Γ_c;
 * none where contact meets a side that holds the body. contact_force_bound() bounds the error of
 * the contact force with it. Collective. */
std::optional<double> norm_of_unit_lift(const DisplacementSpace<2> &space,
                                        const Scene<2> &scene,
                                        const ContactTrace &trace,
                                        const StiffnessInverse &inverse);
} // namespace Signorini
