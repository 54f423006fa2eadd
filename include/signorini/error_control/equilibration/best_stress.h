// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/equilibration/cell_fit.h>
#include <signorini/error_control/equilibration/field_integrals.h>
#include <signorini/error_control/equilibration/stress_bound.h>
#include <signorini/error_control/equilibration/traction_solver.h>
#include <signorini/error_control/loads/edge_function.h>
#include <signorini/postprocessing/fields/forces.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace Signorini {
/**
 * The stress τ that is closest to σ(u_h), among those of degree q_K on cells (AiryCell) that are in
 * equilibrium: div τ + f_K = 0, continuous tractions, the projection of t on traction sides, no
 * shear on rollers and contact sides, and τ_n ≤ 0 on contact sides. With friction |τ_t| ≤ s there,
 * with Coulomb's law s = f |τ_n|. Nothing is assumed of u_h.
 *
 * 1. The cells are those of u_h on graded meshes, else those of a StressMesh of its own.
 * 2. Inside of the cells the best stress for given tractions follows cell by cell (CellFit).
 * 3. Tractions on edges minimise the sum of energies; the balances of cells, and of plates that a
 * force drives, are conditions (minimise()).
 * 4. On contact edges that press everywhere τ_n is unknown. Where the result is positive (a
 * coefficient of Bernstein is), and on all other contact edges, τ_n is p_H, with positive
 * coefficients of Bernstein set to zero.
 * 5. With friction τ_t is unknown on edges that stick everywhere. Elsewhere, and where the result
 * exceeds a polynomial s_E ≤ s, it is q_H, with coefficients of Bernstein between those of -s_E and
 * s_E; on edges that slip it is -s_E or s_E. With Coulomb's law τ_n is known everywhere.
 * 6. Cells where f - f_K or t - t_h counts for more than a tenth are split, or their degree rises.
 */
class BestStress {
public:
  using Vector = dealii::Vector<double>;

  /** Returns the reason why there is no such stress, one sentence; empty if there is one. */
  static std::string objection(const BoundData &data);

  explicit BestStress(const BoundData &data);

  /** Returns the reason why no stress in equilibrium was found; empty if one was. */
  const std::string &failure() const {
    return failure_;
  }
  StressBound bound() const;
  /** Returns whether the bound is guaranteed: the body is a polygon. */
  bool is_guaranteed() const {
    return !data_.space.mesh().is_curved();
  }
  /** Returns |||u_h|||. */
  double energy_norm() const {
    return fields_ ? std::sqrt(fields_->u_h.strain)
                   : Signorini::energy_norm(data_.space, data_.scene, data_.U);
  }
  /** Returns the normal tractions on the faces of the contact surface, and what ũ is there: u_h, or
   * π^{2h} u_h if @p interpolated. */
  std::vector<FaceField> face_fields(bool interpolated = false) const;
  /** Returns ∫ τ_n - ∫ p_H over Γ_c. */
  double change_of_force() const;

private:
  /** Finds a mesh of the stress on which loads are likely to be resolved, and integrates u_h. */
  void set_up();
  /** Makes everything for the present mesh of the stress but the integrals of u_h. */
  void prepare_mesh();
  void give_tractions();
  void give_contact();
  void give_friction();
  /** Returns the coefficients of Legendre's polynomials of p_H or q_H on an edge. */
  std::vector<double> projection_of(const Pressure &P, unsigned int edge) const;
  /** Returns those of τ_n (component 0) or τ_t. */
  std::vector<double> coefficients(unsigned int edge, unsigned int component) const;
  void fix_edge(unsigned int edge, unsigned int component, const std::vector<double> &legendre);
  /** Sets the coefficients of an edge to those of p_H, without positive coefficients of Bernstein.
   */
  void press_by_multipliers(unsigned int edge);
  /** Sets those of τ_t to q_H, between the bounds of friction; where the edge slips, to one of
   * them.
   */
  void rub_by_multipliers(unsigned int edge);
  /** Returns s at the position @p s, or with Coulomb's law f |τ_n|. */
  double friction_bound(unsigned int edge, double s) const;
  /** Returns the coefficients of Bernstein of a polynomial that is close to this, and not above it
   * at samples. Notes the edge where it is far below. */
  std::vector<double> lower_friction_bound(unsigned int edge);
  bool is_within_friction(unsigned int edge) const;
  /** Fixes the free contact edges whose traction pulls, or exceeds the bound of friction. @return
   * whether there were any. */
  bool fix_pulling_edges();
  /** Splits cells whose loads are not resolved, or raises their degree.
   * @param total ‖σ(u_h) - τ‖, or about that.
   * @param by_degree whether degrees may rise.
   * @return whether there is a change. */
  bool resolve_loads(double total, bool by_degree);
  /** Splits cells along whose contact edge the polynomial s_E is far below s. @return whether there
   * were any. */
  bool resolve_friction();
  /** Returns ‖σ(u_h) - τ‖_K, or ‖τ‖_K on a mesh of its own. */
  double misfit(std::size_t cell) const;
  /** Returns the sum of the squares of that. */
  double misfit_square() const;
  /** Returns ‖σ(u_h) - τ‖. */
  double total_misfit() const;
  /** Returns ‖σ(v) - τ‖, on a mesh of its own. */
  double distance(const FieldIntegrals &v) const;
  double oscillation(std::size_t cell) const;
  double total_oscillation() const;
  /** Returns what total_misfit() will be, or less, before tractions are known: loads that count
   * beside it are resolved at once. */
  double likely_misfit() const;
  void fit_cells();
  void integrate_u();
  void add_plate_conditions();
  void add_own(StressBound &result) const;
  /** Returns bounds of J*(τ) + ∫ τ_n d on a mesh of its own, d = u_{h,n} - g. */
  Bracket complementary_energy() const;
  /** Returns an estimate of what a polygon in place of curved sides adds: shears turn on chords. */
  double geometry() const;

  BoundData data_;
  StressMesh stress_mesh_;
  CellFitter fitter_;
  PrescribedLift lift_;
  /** The norms |||z|||_K by cell of a graded mesh. */
  Vector lift_norms_;
  std::optional<TractionMesh> mesh_;
  std::vector<Triangulation<2>::active_cell_iterator> cells_;
  std::vector<CellFit> fits_;
  std::vector<CellId> fitted_;
  /** On a mesh of its own. */
  std::optional<FieldsOfLevel> fields_;
  /** The forces and moments on plates. */
  std::vector<TractionCondition> conditions_;
  /** The coefficients of all edges, and the norms of what given tractions leave. */
  Vector x_;
  std::array<std::vector<double>, 2> rests_;
  /** The edges by face of the contact surface. */
  std::vector<unsigned int> contact_edges_;
  /** With friction, by edge: how its patches slip, and the coefficients of Bernstein of s_E. */
  std::map<unsigned int, State> slips_;
  std::map<unsigned int, std::vector<double>> friction_bounds_;
  /** The edges on which s_E is far below s. */
  std::set<unsigned int> unresolved_friction_;
  double lacking_ = 0.;
  std::string failure_;
};
} // namespace Signorini
