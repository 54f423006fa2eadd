// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/postprocessing/quantities/answer_vector.h>
#include <signorini/postprocessing/quantities/singular_places.h>

namespace Signorini
{
/** A largest von Mises stress (force/area), and where it is. */
struct StressMaximum
{
  double value = 0.;
  AnswerVector point;
  /** The cell on which the value was found. */
  MeshAt mesh;
};

/** The largest von Mises stress. */
struct VonMises : StressMaximum
{
  /** The place where the exact value is infinite, if there is one: the value then depends only on
   * how fine the mesh is. */
  std::optional<GrowthPlace> grows_at;
  /** The largest stress away from all SingularPlace, where there are any. */
  std::optional<StressMaximum> away;
  /** The share of the body (area, volume) in cells with a principal strain above large_strain in
   * their middle. */
  double strained_share = 0.;
};

/** The limit of small strains: theories of small strains err by about as much as the strain. */
constexpr double large_strain = 0.1;

/**
 * Returns the largest stress of π^{2h} u_h, or of u_h on a mesh without T^{2h}, at the corners and
 * the middle of every cell. With mean dilatation the trace of the strain is mean_dilatations().
 * Points at which the material's data has no value are left out. Collective.
 * @param places away is taken outside of them.
 */
template <int dim>
VonMises largest_von_mises(const DisplacementSpace<dim> &space,
                           const Scene<dim> &scene,
                           const Displacement &U,
                           const std::vector<SingularPlace<dim>> &places = {});
} // namespace Signorini
