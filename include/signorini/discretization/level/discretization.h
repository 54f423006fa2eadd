// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/discretization/mesh/mesh_plan.h>
#include <signorini/discretization/multiplier/multiplier_space.h>
#include <signorini/problem/parameters/parameters.h>

namespace Signorini
{
/** T^h, V^h, Gamma_c^H, Q^H, D and G of one level. */
template <int dim>
struct Discretization
{
  /** A nested level. Parameters and scene must outlive the object. @throws InputError for a
   * partition that makes no sense on this level. */
  Discretization(const Parameters &parameters,
                 const Scene<dim> &scene,
                 unsigned int level,
                 MPI_Comm communicator);
  /** A graded mesh: multipliers of degree p - 2 on every contact face of degree p. In the plane, on
   * one rank. @throws InputError for a multiplier that sees no free node. */
  Discretization(const Parameters &parameters, const Scene<dim> &scene, const MeshPlan &plan);
  Discretization(const Discretization &) = delete;
  Discretization &operator=(const Discretization &) = delete;

  /** Of the mesh and the setup. */
  StageTimes times;
  Mesh<dim> mesh;
  /** Gauss points per direction for loads; errors take one more. For degree one; higher degrees
   * take more. */
  unsigned int n_points;
  DisplacementSpace<dim> space;
  ContactSurface<dim> surface;
  MultiplierSpace<dim> multipliers;
  Coupling D;
  /** D seen from the unconstrained degrees of freedom. */
  Coupling condensed_D;
  /** How the gap is integrated on pieces of patches with constants. */
  unsigned int n_gap_points;
  Grading gap_grading;
  dealii::Vector<double> G;

  /** G for the gap of another scene with the same contact sides. */
  dealii::Vector<double> assemble_gap_of(const Scene<dim> &scene) const;
};

/** Whether patches of a single face have multipliers of a degree that is not inf-sup stable. */
template <int dim>
bool is_unstable(const Discretization<dim> &discretization)
{
  return !discretization.space.has_several_elements() &&
         discretization.space.element().degree == 1 && discretization.surface.has_unstable_patch();
}

/** The degree of every active cell. */
std::vector<unsigned int> degrees_of(const DisplacementSpace<2> &space);
} // namespace Signorini
