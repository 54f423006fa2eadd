// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/multiplier/multiplier_space.h>
#include <signorini/problem/scene/rigid_motions.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <deal.II/lac/full_matrix.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** Virtual work on each of several motions (force times length per thickness over the unit of q).
 */
struct MotionWork
{
  dealii::Vector<double> value;
  /** The sum of the absolute values of its terms, for what is rounding. */
  dealii::Vector<double> magnitude;
};

/**
 * Z: the displacements that free motions of plates and bodies cause. u = u_0 + sum_j q_j z_j, where
 * u_0 vanishes on pins and moves plates by what is given of their motion. z_j moves the plates and
 * pins as free motion j does, and a(z_j, v) = 0 for all v in V^h that vanish there. A rigid motion
 * is its own z_j (on curved cells up to what V^h lacks of a rotation).
 */
template <int dim>
struct MotionModes
{
  std::vector<FreeMotion> motions;
  /** z_j, complete. */
  std::vector<NodalVector> Z;
  /** (a(z_j, phi_i))_i; empty where they vanish: for rigid motions that V^h contains. */
  std::vector<NodalVector> forces;
  /** K_ij = a(z_i, z_j). */
  dealii::FullMatrix<double> K;
  /** Rigid motions that contact does not see, and their nodal values. They stay zero. */
  std::vector<FreeMotion> unseen;
  std::vector<NodalVector> unseen_Z;

  /** How large the work of balanced loads on an unseen motion may be, relative to its terms: the
   * force on cells that approximate a curved body is not exactly that on the body. */
  double unseen_tolerance = 1e-9;

  std::size_t size() const
  {
    return motions.size();
  }
  /** B = D^T Z, m x k. */
  dealii::FullMatrix<double> couple(const Coupling &D) const;
  /**
   * Work on z_j: of what drives the plates, and of the loads f_i (not condensed) less a(z_j, u_0).
   * @param U_0 complete.
   */
  MotionWork work(const std::vector<Plate> &plates,
                  const NodalVector &loads,
                  const NodalVector &U_0) const;
  /** The number of the first unseen motion that the forces on plates and the loads f_i drive,
   * within rounding and what curved cells lack of a rotation; none if they are in balance. */
  std::optional<unsigned int> driven_unseen(const std::vector<Plate> &plates,
                                            const NodalVector &loads) const;
  /** U += sum_j q_j z_j. */
  void add_to(NodalVector &U, const dealii::Vector<double> &q) const;
  /** How the plates move with q, beside what is given. */
  std::vector<PlateMotion> plate_motions(const std::vector<Plate> &plates,
                                         const dealii::Vector<double> &q) const;
};

/** One solve for each mode that strains the body. Collective. */
template <int dim>
MotionModes<dim> make_motion_modes(const DisplacementSpace<dim> &space,
                                   const Scene<dim> &scene,
                                   const StiffnessInverse &inverse);

/** "it slides", "it tips over" or "it lifts off": what a body does that nothing stops. */
std::string word_for_escape(const RigidMotion &motion, bool opens);

/** The rigid motion of a body in a combination of modes. */
RigidMotion rigid_part(const MotionModes<2> &modes, const dealii::Vector<double> &v);

/** Whether the motion v leaves contact somewhere; otherwise it slides. */
bool opens(const dealii::FullMatrix<double> &B, const dealii::Vector<double> &v);
} // namespace Signorini
