// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/equilibration/cell_fit.h>
#include <signorini/error_control/stress/equilibrated_stress.h>

#include <string>
#include <vector>

namespace Signorini {
/** A condition row · x = value on the coefficients of edges, with the weight of its square and its
 * multiplier. */
struct TractionCondition {
  double norm() const {
    double square = 0.;
    for (const auto &entry : row)
      square += entry.second * entry.second;
    return std::sqrt(square);
  }

  std::vector<std::pair<unsigned int, double>> row;
  double value = 0., weight = 0., multiplier = 0.;
};

/**
 * The stress τ that is closest to σ(u_h), among those of degree q_K on cells (AiryCell) that are in
 * equilibrium: div τ + f_K = 0, continuous tractions, the projection of t on traction sides, no
 * shear on rollers and contact sides, and τ_n ≤ 0 on contact sides. Nothing is assumed of u_h.
 *
 * 1. Inside of the cells the best stress for given tractions follows cell by cell (CellFit).
 * 2. Tractions on edges minimise the sum of energies. The balances of cells, and of plates that a
 *    force drives, are conditions: an augmented Lagrangian with one Cholesky factor, whose steps
 *    bring what is lacking down to rounding.
 * 3. On contact faces that press everywhere τ_n is unknown. Where the result is positive (a
 *    coefficient of Bernstein is), and on all other contact faces, τ_n is p_H, with positive
 *    coefficients of Bernstein set to zero.
 * 4. The degrees q_K rise in cells where f - f_K counts for more than a tenth.
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
  static bool is_guaranteed() {
    return true;
  }
  /** Returns |||u_h|||. */
  double energy_norm() const {
    return Signorini::energy_norm(data_.space, data_.scene, data_.U);
  }
  /** Returns the normal tractions on the faces of the contact surface. */
  std::vector<FaceField> face_fields() const;
  /** Returns ∫ τ_n - ∫ p_H over Γ_c. */
  double change_of_force() const;

private:
  void give_tractions();
  void give_contact();
  /** Sets the coefficients of an edge to those of p_H, without positive coefficients of Bernstein.
   */
  void press_by_multipliers(std::size_t face);
  /** Minimises. @return whether the conditions hold. */
  bool minimise();
  /** Fixes the free contact edges whose traction pulls. @return whether there were any. */
  bool fix_pulling_edges();
  bool raise_degrees();
  Vector lacking_traces(std::size_t cell) const;
  double misfit(std::size_t cell) const;
  double oscillation(std::size_t cell) const;
  void add_plate_conditions();
  std::vector<PrescribedEdge> prescribed_edges() const;

  BoundData data_;
  TractionMesh mesh_;
  std::vector<Triangulation<2>::active_cell_iterator> cells_;
  PrescribedLift lift_;
  CellFitter fitter_;
  std::vector<CellFit> fits_;
  /** The norms |||z|||_K of the PrescribedLift. */
  std::vector<double> lift_norms_;
  /** The forces and moments on plates. */
  std::vector<TractionCondition> conditions_;
  /** The coefficients of all edges, and the norms of what given tractions leave. */
  Vector x_;
  std::vector<double> normal_rest_, shear_rest_;
  /** The edges of the faces of the contact surface. */
  std::vector<unsigned int> contact_edges_;
  double lacking_ = 0.;
  std::string failure_;
};
} // namespace Signorini
