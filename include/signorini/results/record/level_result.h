// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/level/discretization.h>
#include <signorini/results/record/level_record.h>

#include <memory>

namespace Signorini
{
/** The answer of one level: contact as it was found, and what is known about it. */
template <int dim>
struct LevelSolution : ContactState<dim>
{
  LevelRecord record;
  /** Empty where record.bound is. */
  BoundFields bound_fields;
  /** The scene with plates where they have moved to. */
  Scene<dim> scene;
};

/** What a sequence of meshes returns for one of them; the driver writes it, and lets it go before
 * the next. */
template <int dim>
struct LevelResult
{
  std::shared_ptr<const Discretization<dim>> discretization;
  LevelSolution<dim> solution;
  /** Whether the mesh is the finest of the sequence. */
  bool is_last = false;

  PatchPressure<dim> pressure() const
  {
    return {discretization->surface.patches(), solution.P};
  }
};
} // namespace Signorini
