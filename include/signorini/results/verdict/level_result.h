// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/discretization.h>
#include <signorini/discretization/space/internal_forces.h>
#include <signorini/postprocessing/fields/pressure_transfer.h>
#include <signorini/results/verdict/level_record.h>
#include <signorini/solvers/methods/solved.h>

#include <memory>
#include <string>

namespace Signorini {
/** The solution of one level with its record. */
template <int dim>
struct LevelSolution {
  ContactSolution<dim> contact;
  LevelRecord record;
  /** The size of u_h. */
  EnergyScale energy;
  /** The parts of the bound; empty if record.bound is empty. */
  BoundFields bound_fields;
  /** The scene after the motion of its plates. */
  Scene<dim> scene;
};

/** The result of a sequence for one of its meshes. The driver writes it, and releases it before the
 * next mesh. */
template <int dim>
struct LevelResult {
  std::shared_ptr<const Discretization<dim>> discretization;
  LevelSolution<dim> solution;
  /** Whether the mesh is the finest of the sequence. */
  bool is_last = false;
  /** Why the result of an earlier mesh is given again, as the last one, a clause; mostly empty. */
  std::string why_again;

  /** Returns the level as others read it; the result must outlive that. */
  Solved<dim> solved() const {
    return {*discretization, solution.scene, solution.contact};
  }
  PatchPressure<dim> pressure() const {
    return {discretization->surface.patches(), solution.contact.P.normal()};
  }
};
} // namespace Signorini
