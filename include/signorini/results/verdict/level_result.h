// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/postprocessing/fields/energies.h>
#include <signorini/postprocessing/fields/pressure_transfer.h>
#include <signorini/results/verdict/level_record.h>
#include <signorini/solvers/methods/level_operators.h>
#include <signorini/solvers/methods/solved.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace Signorini {
/** The solution of one level with its record. */
template <int dim>
struct LevelSolution {
  ContactSolution contact;
  /** The operators of the level, as long as it, its load cases or its files need them. */
  std::shared_ptr<const LevelOperators<dim>> operators;
  LevelRecord record;
  /** The size of u_h, and its energies. */
  EnergyScale scale;
  Energies energies;
  /** The parts of the bound; empty if record.bound is empty. */
  BoundFields bound_fields;
  /** The stress of the bound, see LocatedBound. */
  std::optional<ReferenceStress> reference;
  /** The scene after the motion of its plates. */
  Scene<dim> scene;

  /** Returns the level as others read it; the discretization and this object must outlive that. */
  Solved<dim> on(const Discretization<dim> &discretization) const {
    return {discretization, scene, contact};
  }
};

/** The result of a sequence for one of its meshes. The driver writes it, and releases it before the
 * next mesh. */
template <int dim>
struct LevelResult {
  std::shared_ptr<const Discretization<dim>> discretization;
  LevelSolution<dim> solution;
  /** Whether the mesh is the finest of the sequence. */
  bool is_last = false;
  /** Why no further mesh is worth its price, a clause; mostly empty. */
  std::string why_last;
  /** Why the result of an earlier mesh is given again, as the last one, a clause; mostly empty. */
  std::string why_again;

  /** On the last mesh, the errors of all nested levels by their numbers, where one graded run tells
   * them. */
  std::map<unsigned int, ErrorBound> errors;

  /** Returns the level as others read it; the result must outlive that. */
  Solved<dim> solved() const {
    return solution.on(*discretization);
  }
  PatchPressure<dim> pressure() const {
    return {discretization->surface.patches(), solution.contact.P.normal()};
  }
};
} // namespace Signorini
