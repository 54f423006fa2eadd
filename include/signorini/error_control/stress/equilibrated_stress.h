// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/loads/bound_data.h>
#include <signorini/error_control/loads/cell_loads.h>
#include <signorini/error_control/loads/edge_function.h>
#include <signorini/error_control/loads/prescribed_lift.h>
#include <signorini/error_control/stress/cell_table.h>
#include <signorini/error_control/stress/edge_tractions.h>
#include <signorini/error_control/stress/star_solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** Two numbers between which a quantity lies. */
struct Bracket {
  double lower;
  double upper;
};

/**
 * Returns bounds of the energy of the exact solution,
 *
 *     -J*(τ) ≤ J(u) ≤ -J*(τ) + 1/2 (η + |||w|||)² + ∫_{Γ_c} τ_n (ũ_n - g - w_n).
 *
 * J(u_h) alone is no bound: u_h may penetrate.
 *
 * @param dual_energy bounds of J*(τ) of a stress in equilibrium
 * @param eta the sum of cells of ‖σ(ũ) - τ‖ and oscillation, in the norm of stresses
 * @param lift_norm |||w|||
 * @param contact_term ∫_{Γ_c} τ_n (ũ_n - g - w_n)
 */
inline Bracket energy_bracket(const Bracket &dual_energy, const double eta, const double lift_norm,
                              const double contact_term) {
  const double gap = 0.5 * (eta + lift_norm) * (eta + lift_norm) + contact_term;
  return {-dual_energy.upper, -dual_energy.lower + gap};
}

/**
 * Returns a bound of ‖σ(u) - τ‖ in the norm of stresses, by the identity behind the bound of
 * the energy error: with s = ‖σ(u) - τ‖,
 *
 *     |||u - ũ|||² + s² ≤ η² + 2 s |||w||| + 2 T,   T = ∫_{Γ_c} τ_n (ũ_n - g - w_n),
 *
 * so s ≤ |||w||| + (|||w|||² + η² + 2 T)^{1/2}.
 */
inline double stress_error_bound(const double eta, const double lift_norm,
                                 const double contact_term) {
  return lift_norm + std::sqrt(std::max(0., lift_norm * lift_norm + eta * eta + 2. * contact_term));
}

/**
 * Returns a bound of the error of the contact force: |∫_{Γ_c} (σ_n - τ_n)| <=
 * error_bound |||z|||, for z in V with z_n = 1 on Γ_c.
 *
 * @param error_bound a bound of ‖σ(u) - τ‖ (stress_error_bound()): the difference is ∫
 * (σ(u) - τ):ε(z). Or, with p_H in place of τ_n, for z in V^h and loads that were
 * integrated exactly without StrainOperator::mean_dilatation, a bound of |||u - u_h|||: then the
 * difference is also a(u - u_h, z).
 * @param lift_norm |||z|||, see norm_of_unit_lift().
 */
inline double contact_force_bound(const double error_bound, const double lift_norm) {
  return error_bound * lift_norm;
}

/** The bound of the error of a displacement by a stress in equilibrium. All values are energies
 * (force x length per thickness) or roots of energies. */
struct StressBound {
  /** The misfit ‖σ(u_h + z) - τ‖_{E⁻¹,K} of every cell, in the order of active cells. E is
   * Hooke's tensor. */
  std::vector<double> misfit;
  /** The oscillation osc_K: a stress of at most this norm balances, together with τ, the loads
   * themselves. */
  std::vector<double> oscillation;
  /** The sum over K of (misfit_K + osc_K)², with the part that curved sides add. */
  double square = 0.;
  /** The sum over K of (misfit_K - osc_K)², without negative differences; only for a BestStress. */
  double smallest_square = 0.;
  /** The sum over K of osc_K². */
  double oscillation_square = 0.;
  /** The sum over K of the squares of the part that curved sides add to osc_K, an estimate; zero
   * for straight sides. */
  double geometry_square = 0.;
  /** The norm |||z||| of the PrescribedLift, which makes up for prescribed displacements that are
   * not linear along edges and is zero elsewhere. The bound is for u_h + z; that for u_h is larger
   * by |||z|||. */
  double lift = 0.;
  /** The same sums for π^{2h} u_h. */
  struct Interpolated {
    /** The sum over K of (‖σ(π^{2h} u_h + z') - τ‖_{E⁻¹,K} + osc_K)², and |||z'|||; z'
     * makes up for u_D - π^{2h} u_h. */
    double square, lift;
  };
  std::optional<Interpolated> interpolated_part;
  /** Bounds of 1/2 ‖τ‖² - ∫_{Γ_D} τ n.(u_D - c) for the stress that balances the loads
   * themselves, with c the translation below. The bounds are 1/2 Σ_K (‖τ‖_{E⁻¹,K} ± osc_K)²
   * minus that work. This is the part of J*(τ) that no large translation enters. */
  Bracket complementary_energy = {0., 0.};
  /** The translation c, which is the displacement of a corner of the body, and the force
   * ∫_{Γ_D} τ n. */
  Tensor<1, 2> translation, support_force;
  /** The largest difference between a prescribed displacement and its interpolation on an edge,
   * relative to PrescribedLift's rest there. */
  double lift_misfit = 0.;
  /** The largest force at a vertex that the linear solver left unbalanced, relative to the largest
   * force that a cell exerts on a vertex. */
  double algebra = 0.;
};

/**
 * A stress τ with div τ + f_h = 0 on every cell, continuous tractions, τ n = t_h on traction
 * sides, τ n = p_h n on contact sides and without shear on rollers, close to σ(u_h). The
 * loads f_h, t_h and p_h are projections of f, t and p_H whose rest has neither force nor moment on
 * any cell or edge (CellLoad, GivenTractions).
 *
 * 1. The moments of tractions follow from the residuals of (u_h, p_H) around every vertex
 * (EdgeMoments).
 * 2. Inside of the cells the stress is that of composite quadrilaterals (CompositeCell).
 * 3. A few steps of conjugate gradients reduce ‖σ(u_h) - τ‖_{E⁻¹} (StarSolver). All
 * iterates are in equilibrium.
 *
 * With exact balance, there is for every cell a τ_r with ‖τ_r‖_{E⁻¹,K} ≤ osc_K such that
 * τ + τ_r balances f, t and p_H n themselves (OscillationConstants): then the inequality of
 * Prager and Synge holds with (misfit_K + osc_K)². This also covers patches that end inside a face.
 *
 * Hooke's tensor is sampled at quadrature points, and so are loads. All ranks compute the same
 * stress.
 */
class EquilibratedStress {
public:
  /** Returns the reason why there is no such stress, one sentence; empty if there is one. */
  static std::string objection(const BoundData &data);

  explicit EquilibratedStress(const BoundData &data);

  StressBound bound() const;

  /** Returns whether the bound is guaranteed: the body is a polygon. */
  bool is_guaranteed() const {
    return !mesh_.is_curved();
  }
  /** Returns |||u_h|||. */
  double energy_norm() const {
    return std::sqrt(std::max(0., energy_));
  }
  /** Returns what ũ, which is π^{2h} u_h if @p interpolated, and τ are on the faces of the contact
   * surface. */
  std::vector<FaceField> face_fields(bool interpolated = false) const;
  /** The stress always exists. */
  static std::string failure() {
    return {};
  }

private:
  using CornerValues = std::array<Tensor<1, 2>, 4>;

  unsigned int n_threads() const;
  CornerValues displacement(const EdgeCell &cell) const;
  /** Returns the displacement relative to corner 0: large translations have rounding errors, but no
   * strain. */
  CornerValues deformation(const EdgeCell &cell) const;
  /** Returns σ(u_h) at a point of [0,1]². */
  Tensor<2, 2> stress_of_u(const EdgeCell &cell, const CornerValues &u, const Point<2> &at) const;
  /** Returns R_K^i = ∫_K σ_h:grad φ_i - ∫_K f φ_i, with the quadrature of the system;
   * sets energy_. */
  std::vector<CornerForces> residuals();
  /** Returns the moments of the mean of σ_h n from both sides of edges. */
  std::vector<double> mean_tractions() const;
  /** Sets bubbles_. Needs Mesh::has_parents(). */
  void find_bubbles();
  /** Returns the numbers of a cell, see CellColumns. */
  CellVector data_of(unsigned int cell) const;
  /**
   * Integrates over a cell.
   * @param energies receives S, unless it is null.
   */
  CellIntegrals integrate(unsigned int cell, bool from_above, CellEnergies *energies) const;
  /** Updates the integrals of a cell after a change of the moments. */
  void update(const CellEnergies &energies, std::size_t cell, const std::vector<double> &change);
  void for_each_cell(const std::function<void(std::size_t)> &visit) const;
  /** Adds the couple that makes the loads of curved cells balance the residuals: V^h of curved
   * cells holds rotations up to the bulges only. */
  void balance_couples(const std::vector<CornerForces> &R);
  /** Returns the part that the polygon adds to osc_K: that of the couple, and that of the tractions
   * on an edge which is no chord. */
  double geometry(unsigned int cell, double min_eigenvalue) const;
  /** Returns osc_K. */
  double oscillation(unsigned int cell, double min_eigenvalue) const;
  /** Returns ∫_{Γ_D} τ n.(u_D - c) on the edges of a cell; adds ∫_{Γ_D} τ n to @p
   * force. */
  double support_work(unsigned int cell, const Tensor<1, 2> &c, Tensor<1, 2> &force) const;
  /**
   * Brings the moments closer to those of the best stress.
   * @return their change.
   */
  std::vector<double> improve(const CellEnergies &energies);
  /** The residual of the improvement: minus the gradient of half the square of the misfit. */
  struct Residual {
    std::vector<double> r;
    /** The squares of the misfits of u_h and of π^{2h} u_h; the last one is infinite where there
     * is none. */
    double square = 0., interpolated_square = 0.;
    /** The square of the norm of τ. */
    double energy = 0.;
  };
  Residual residual() const;
  /** The end of the steps of the improvement. */
  struct Steps {
    /** The edges that pull; if there are any, the moments must not be used. */
    std::vector<unsigned int> pulling;
    /** Whether the last step took less than the least share. */
    bool settled = false;
  };
  /**
   * Runs conjugate gradients, and on small meshes computes the best stress.
   * @return the edges among @p free that pull.
   */
  std::vector<unsigned int> iterate(Residual left, const StarSolver &solver,
                                    const CellEnergies &energies,
                                    const std::vector<unsigned int> &free);
  /** Takes steps of conjugate gradients; keeps @p left up to date. */
  Steps improve_step_by_step(Residual &left, const StarSolver &solver,
                             const std::vector<unsigned int> &free);

  BoundData data_;
  EdgeMesh mesh_;
  PrescribedLift lift_;
  CellTable table_;
  std::vector<CellLoad> loads_;
  /** The norms in L2(K) of the couples that curved cells need. */
  std::vector<double> couples_;
  GivenTractions given_;
  /** The coefficients of π^{2h} u_h - u_h, see CellFunctions, for edges and cells; empty where
   * there is no π^{2h} u_h. On held edges π^{2h} u_h is not u_D, either, and PrescribedLift makes
   * up for u_D - u_h: there they are held back. */
  struct Bubbles {
    std::vector<Tensor<1, 2>> edges, cells;
  };
  std::optional<Bubbles> bubbles_;
  std::vector<double> moments_;
  std::vector<CellIntegrals> integrals_;
  double energy_ = 0.;
  double algebra_ = 0.;
};
} // namespace Signorini
