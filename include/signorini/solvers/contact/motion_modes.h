// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/problem/scene/free_motion.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <deal.II/lac/full_matrix.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** The virtual work on each of several motions (force times length per thickness over the unit of
 * q). */
struct MotionWork {
  dealii::Vector<double> value;
  /** The sum of the absolute values of the terms of the work, which gives the size of rounding
   * errors. */
  dealii::Vector<double> magnitude;
};

/** The displacements Z that free motions of plates and bodies cause. u = u_0 + Σ_j q_j z_j, where
 * u_0 vanishes on pins and moves plates by the given part of their motion. z_j moves the plates and
 * pins as free motion j does, and a(z_j, v) = 0 for all v in V^h that vanish there. A rigid motion
 * is its own z_j (on curved cells up to the part of a rotation that V^h lacks). */
template <int dim>
struct MotionModes {
  std::vector<FreeMotion<dim>> motions;
  /** The complete nodal values z_j. */
  std::vector<Displacement> Z;
  /** The forces (a(z_j, φ_i))_i; empty where they vanish: for rigid motions that V^h contains. */
  std::vector<DualVector> forces;
  /** The stiffness K_ij = a(z_i, z_j). */
  FullMatrix<double> K;
  /** The rigid motions that no contact resists, and their nodal values. Those that V^h lacks, and
   * so resists a little, are among the motions above; the others stay zero. */
  std::vector<FreeMotion<dim>> neutral;
  std::vector<Displacement> neutral_modes;

  /** The tolerance of the work of balanced loads on a neutral motion, relative to its terms: the
   * force on cells that approximate a curved body is not exactly that on the body. */
  double neutral_tolerance = 1e-9;

  std::size_t size() const {
    return motions.size();
  }
  /** Returns B = Dᵀ Z, m x k. */
  FullMatrix<double> couple(const Coupling &D) const;
  /**
   * Returns the work on z_j of the forces and moments on plates, and of the loads f_i (not
   * condensed) less a(z_j, u_0).
   * @param U_0 complete nodal values.
   */
  MotionWork work(const std::vector<Plate<dim>> &plates, const DualVector &loads,
                  const Displacement &U_0) const;
  /** Returns the number of the first neutral motion that the forces on plates and the loads f_i
   * drive, within rounding and the part of a rotation that curved cells lack; none if they are in
   * balance. */
  std::optional<unsigned int> driven_neutral(const std::vector<Plate<dim>> &plates,
                                             const DualVector &loads) const;
  /** Adds Σ_j q_j z_j to U. */
  void add_to(Displacement &U, const dealii::Vector<double> &q) const;
  /** Returns the motions of the plates with q, without the given part. */
  std::vector<PlateMotion<dim>> plate_motions(const std::vector<Plate<dim>> &plates,
                                              const dealii::Vector<double> &q) const;
  /** Returns the work of the forces on plates, which loads do not contain. */
  double work_of_plates(const std::vector<Plate<dim>> &plates,
                        const dealii::Vector<double> &q) const;
};

/** Computes the modes: one solve for each mode that strains the body. Collective. */
template <int dim>
MotionModes<dim> make_motion_modes(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                                   const StiffnessInverse &inverse);

/** Returns "it slides", "it tips over", "it lifts off" or, in space, "it turns": the motion of a
 * body that nothing stops. */
template <int dim>
std::string text_of_escape(const RigidMotion<dim> &motion, bool opens);

/** Returns the rigid motion of a body in a combination of modes. */
template <int dim>
RigidMotion<dim> rigid_part(const MotionModes<dim> &modes, const dealii::Vector<double> &v);

/** Returns whether the motion v leaves contact somewhere; otherwise it slides.
 * @param m the number of pressures, which are the first rows of B; those of friction follow. */
bool opens(const FullMatrix<double> &B, const dealii::Vector<double> &v, unsigned int m);
} // namespace Signorini
