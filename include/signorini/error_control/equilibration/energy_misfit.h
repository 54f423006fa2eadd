// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/arc_mapping.h>
#include <signorini/error_control/equilibration/equilibrated_stress.h>
#include <signorini/error_control/equilibration/prescribed_lift.h>
#include <signorini/error_control/equilibration/stress_bound.h>

#include <vector>

namespace Signorini {
/**
 * ‖σ(v) - τ‖ of a stress on a mesh of its own, by energies: with a translation c of each body and
 * div τ + f_K = 0
 *
 *     ‖σ(v) - τ‖² = |||v|||² - 2 ∫ f_K.(v - c) - 2 ∫_Γ τ n.(v - c) + ‖τ‖².
 *
 * v is u_h + z with the PrescribedLift: v = u_D where that is given. Cells with an arc have exact
 * arcs (ExactMaps).
 */
class EnergyMisfit {
public:
  /** Fits are compared with zero. */
  static constexpr bool compares = false;
  /** The works on v - c on a mesh of the stress. */
  struct Works {
    /** ∫ f_K.(v - c), and that of tractions given on arcs (force x length per thickness). */
    double load = 0.;
    /** The integrals of (v - c)_n and (v - c)_t times Legendre's polynomials, by coefficients of
     * edges on Γ; on shared edges those of Bv, with u_n and u_t of both bodies. */
    dealii::Vector<double> moments;
    /** The same of c, on shared edges. */
    dealii::Vector<double> translated;
  };

  /** Integrates the energies of v. Collective. */
  explicit EnergyMisfit(const BoundData &data);

  /** Returns the works of v. Collective. */
  Works works(const EquilibrationMesh &mesh, const EquilibratedStress &stress) const;
  static const dealii::Vector<double> &moments(const EquilibratedStress & /*stress*/,
                                               const Works &works) {
    return works.moments;
  }
  static double least(const CellFit & /*fit*/) {
    return 0.;
  }
  double expected(const EquilibratedStress &stress) const;
  /** Returns the size of f - f_K that counts beside ‖σ(u_h) - τ‖. Where f stands for f_K that is
   * less: its square is compared with 2 (Σ osc_K²)^{1/2} |||u_h|||. */
  double allowed_load(const EquilibratedStress &stress, const Works &works) const;
  StressBound bound(const EquilibratedStress &stress, const Works &works) const;

private:
  using Cell = DoFHandler<2>::active_cell_iterator;

  /** Returns whether every cell of u_h is a part of one cell of the stress. */
  bool is_aligned() const {
    return EquilibrationMesh::aligns(data_);
  }
  template <typename AnyCell>
  const Tensor<1, 2> &translation_of(const AnyCell &cell) const {
    return translations_[data_.scene.geometry.body_of(cell)];
  }
  void integrate_energies();
  /** The sum of the terms of ‖σ(v) - τ‖², which cancel, and its rounding. */
  struct Square {
    double value, rounding;
  };
  Square square(const EquilibratedStress &stress, const Works &works) const;
  /** Returns Σ osc_K² of body forces where f stands for f_K, otherwise zero. */
  double load_square(const EquilibratedStress &stress) const;
  /** Returns the bound 2 (Σ osc_K²)^{1/2} |||v||| of 2 ∫ (f - f_K).v. */
  double load_term(const EquilibratedStress &stress) const;
  /** Returns osc_K with the share of the cell in load_term(), in the order of active cells. */
  std::vector<double> oscillations_by_cell(const EquilibratedStress &stress) const;
  /** Returns ‖σ(v) - τ‖. */
  double distance(const EquilibratedStress &stress, const Works &works) const;
  /** Returns f_K, or where cells are not aligned f, at points of a cell of u_h. */
  std::vector<Tensor<1, 2>> force(const EquilibrationMesh &mesh, const EquilibratedStress &stress,
                                  const Cell &cell, const std::vector<Point<2>> &points) const;
  void add_load_works(const EquilibrationMesh &mesh, const EquilibratedStress &stress,
                      Works &works) const;
  void add_moments(const TractionSpace &space, Works &works) const;
  void add_pair_moments(const TractionSpace &space, Works &works) const;
  /** Returns bounds of J*(τ) + ∫ τ_n d, d = u_{h,n} - g. */
  Bracket complementary_energy(const EquilibratedStress &stress, const Works &works) const;

  const BoundData &data_;
  const ExactMaps maps_;
  /** The translation c of each body. Of two bodies that move apart, one c would do work on the
   * rounding of tractions. */
  std::vector<Tensor<1, 2>> translations_;
  /** z, |||v|||² and |||z|||. */
  PrescribedLift lift_;
  double strain_ = 0., lift_norm_ = 0.;
  /** The norms |||π^{2h} u_h - u_h|||_K by active cell; where cells have no parents |||u_h|||_K. */
  dealii::Vector<double> distances_;
};
} // namespace Signorini
