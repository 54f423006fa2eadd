// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/arc_mapping.h>
#include <signorini/discretization/space/cell_field.h>
#include <signorini/error_control/bound/contact_trace.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** Functions on a face that a lift adds along n and along t. */
using Remainders = std::array<EdgeFunction, 2>;

/**
 * The lift w = w_h + Σ_F ψ_F (r_F n + r_F,t t): a function of V^h with homogeneous essential
 * conditions, and for each contact face F its deficit inside the face.
 *
 * r_F vanishes at both ends of F; in the cell at F, t runs along F and η from F (0) to the opposite
 * edge (1), and ψ_F = (1 - η/δ)_+ with δ ≤ 1. So w is continuous and vanishes on essential
 * boundaries like w_h, whatever the shape of the cell.
 *
 * δ is the least of 1 and D divided by the height of the cell, D = (3 C_nn ∫ r² / (C_nt ∫
 * r'²))^{1/2}, C_nn and C_nt the moduli of stretch along n and of shear at F: for r(t) (1 - y/D) n
 * on a strip the energy is at most 1/2 (C_nn ∫ r²/D + C_nt D/3 ∫ r'²) + mixed terms, least
 * for this D. Any δ is right.
 */
class LiftField {
public:
  using CellIterator = DoFHandler<2>::active_cell_iterator;

  /**
   * Stores the functions. Data and trace must outlive the object.
   * @param remainders r_F and r_F,t in the order of trace.faces(), zero at 0 and 1; empty: all are
   * zero.
   */
  LiftField(const BoundData &data, const ContactTrace &trace, Displacement w_h,
            std::vector<Remainders> remainders = {});

  const Displacement &w_h() const {
    return w_h_;
  }
  const std::vector<Remainders> &remainders() const {
    return remainders_;
  }
  /**
   * Returns ∫_K ε(w):E:ε(w) for every active cell K (force x length per thickness), and zero
   * for cells of other ranks.
   *
   * It is integrated by Gauss' formula on the parts of a cell on which w is a polynomial in
   * reference coordinates. This is exact on parallelograms with constant E. Elsewhere the parts are
   * also cut where kinks of the data cross edges of the cell. Where these do not run along its
   * edges, or data varies fast, the cell is cut into up to 24 equal parts per direction, too.
   */
  dealii::Vector<double> cell_energies() const;

private:
  /** The function r_F ψ_F n of a contact face, or that along t. */
  struct Column {
    unsigned int face, face_no, component;
    /** The number δ. */
    double depth;
  };

  /** Returns the positions at which pieces of w or of the material begin and end in reference
   * coordinate @p d, with those of @p n_equal parts. */
  std::vector<double> cuts(const CellIterator &cell, unsigned int d, unsigned int n_equal) const;
  /** Returns whether the law varies fast in a cell, or has a line there that does not run along the
   * cell's edges. */
  bool needs_equal_parts(const CellIterator &cell) const;
  /** Returns the energy on a cell. @param map_nodes the nodes of its map. */
  double energy(const CellIterator &cell, TabulatedRule &rule,
                const std::vector<Point<2>> &map_nodes) const;

  const BoundData &data_;
  const ContactTrace &trace_;
  const ExactMaps maps_;
  Displacement w_h_;
  std::vector<Remainders> remainders_;
  /** The columns by active cell index. */
  std::multimap<unsigned int, Column> columns_;
};

/** The contact part of the bound of the energy error, with its summands. */
struct ContactBound {
  /** The energy |||w|||² (force x length per thickness). */
  double lift_energy = 0.;
  /** The integral ∫_{Γ_c} τ_n (ũ_n - g - w_n), with friction that of s |v| + τ_t v, too. It is
   * not negative, up to rounding. */
  double contact_term = 0.;
  /** Twice the part of contact_term on the faces, in the order of ContactSurface::faces(). */
  std::vector<double> face_terms;
  /** The part of |||w|||² of every active cell; zero for cells of other ranks. */
  dealii::Vector<double> cell_energies;
  /** The middle of the contact face where the face's term, the work of the lift at its nodes and
   * the energy of its cell are largest together. */
  SidePoint dominant_part;

  /** Returns c² = |||w|||² + 2 contact_term. */
  double square() const {
    return lift_energy + 2. * contact_term;
  }
};

/**
 * The contact part of the guaranteed bound of the energy error |||u - ũ|||, ũ = u_h or π^{2h} u_h,
 *
 *     c² = |||w|||² + 2 ∫_{Γ_c} τ_n (ũ_n - g - w_n)
 *
 * for a w in V (zero on clamped and prescribed sides, w_n = 0 on rollers) with w_n ≥ d := ũ_n - g
 * on Γ_c. The body is two-dimensional.
 *
 * With friction the integrand is τ_n (ũ_n - g - w_n) + s |v| + τ_t v, v = ũ_t - g_t - w_t, where
 * |τ_t| ≤ s, the bound of Tresca's law; with Coulomb's it is f |τ_n|, and the error is that against
 * the solution with this bound. v is zero on faces that stick, up to the interpolation of g_t:
 * w_h,t = ũ_t - g_t at their nodes, and r_F,t is the rest.
 *
 * w = w_h + Σ_F r_F ψ_F n, see LiftField. w_h in V^h satisfies w_{h,n} ≥ d at contact nodes, see
 * nodal_lift(). On a face, d is replaced by a piecewise quadratic q ≥ d (EdgeFunction). Where the
 * face presses, r_F = q - (chord of q), so that w_n = q where w_h touches at both ends, since -2
 * τ_n (w_n - d) counts; elsewhere r_F ≥ (q - w_{h,n})_+. Hence w_n ≥ q ≥ d, and c² ≥ 0.
 *
 * The bound is exact up to rounding, the sampling of g (see interpolate_from_above()) and, with
 * moduli that vary or cells that are no parallelograms, the quadrature of |||w|||².
 *
 * There is none where a held node needs w_n > 0: where contact reaches a clamped side with g < 0,
 * or is pushed into the foundation there. A gap that jumps costs energy but does no harm, since w_n
 * ≥ d may be smooth.
 */
struct ContactLift {
  /**
   * Computes the bound. The data must outlive the object. Collective.
   * @param tractions see ContactTrace.
   * @throws InputError where g has no value.
   */
  explicit ContactLift(const BoundData &data, const std::vector<FaceTractions> &tractions);

  /** The penetration d along Γ_c, with its largest value and where that is. */
  ContactTrace trace;
  /** The bound; none where no w exists. */
  std::optional<ContactBound> bound;
  /** The reason why there is no bound, one sentence with the point; empty if there is one. */
  std::string no_bound;
};

/**
 * Returns a w_h in V^h, zero on essential boundaries, with w_{h,n} ≥ required at all conditions of
 * the trace. Where A⁻¹ is given by factors it minimises 1/2 a(w_h, w_h) - ∫ p_H w_{h,n}: u_h - w_h
 * is the solution of the scene with conditions at nodes instead of means. With the matrix E of the
 * conditions (w_n = Eᵀ w) and multipliers Q,
 *
 *     A w = D P - E Q,   Q ≤ 0,
 *     V = Eᵀ A⁻¹ E Q - (Eᵀ A⁻¹ D P - required) ≤ 0,   Qᵀ V = 0,
 *
 * solved like the dual problem of the scene.
 *
 * Where A⁻¹ iterates, each column of Eᵀ A⁻¹ E would cost a solve. There conjugate gradients lower
 * the energy among functions with w_{h,n} = required at a set of contact nodes, which are held in
 * both directions, and the signs of forces and slacks give the next set. A few steps for a few sets
 * bring the contact part within some hundredths of the least one on sides along an axis.
 *
 * There is none where two contact sides meet in a very sharp corner. Collective.
 */
std::optional<Displacement> nodal_lift(const BoundData &data, const ContactTrace &trace);

/** Returns |||z||| of a z in V^h that is zero on essential boundaries and has z_n = 1 on Γ_c, with
 * friction also z_t = 0; none where contact meets a side that does not allow that.
 * contact_force_bound() bounds the error of the contact force with it. Collective. */
std::optional<double> norm_of_unit_lift(const BoundData &data, const ContactTrace &trace);
} // namespace Signorini
