// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/discretization/mesh/mesh_plan.h>
#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/problem/parameters/parameters.h>

namespace Signorini {
/** The mesh T^h, the spaces V^h and Q^H, Γ_c^H, D, G and K of one level. With friction D = (D_n,
 * D_t) has dim·m columns, and G = (G_n, G_t), where G_t is the tangential motion of the foundation.
 */
template <int dim>
struct Discretization {
  /**
   * Makes a nested level. Parameters and scene must outlive the object.
   * @throws InputError for a partition that makes no sense on this level.
   */
  Discretization(const Parameters &parameters, const Scene<dim> &scene, unsigned int level,
                 MPI_Comm communicator);
  /**
   * Makes the discretization on a graded mesh: multipliers of degree p - 2 on every contact face of
   * degree p. For 2-D only, serial.
   * @throws InputError for a multiplier without a free node.
   */
  Discretization(const Parameters &parameters, const Scene<dim> &scene, const MeshPlan &plan);
  Discretization(const Discretization &) = delete;
  Discretization &operator=(const Discretization &) = delete;

  /** The times of the mesh and the setup. */
  StageTimes times;
  Mesh<dim> mesh;
  /** The number of Gauss points per direction for loads and degree one. Errors take one more, and
   * higher degrees take more. */
  unsigned int n_points;
  DisplacementSpace<dim> space;
  ContactSurface<dim> surface;
  MultiplierSpace<dim> multipliers;
  Coupling D;
  /** The coupling of the unconstrained degrees of freedom. */
  Coupling condensed_D;
  /** How the gap is integrated on pieces of patches with constants. */
  unsigned int n_gap_points;
  Grading gap_grading;
  dealii::Vector<double> G;
  /** The set of admissible multipliers. */
  AdmissibleSet K;

  /** Returns G for the gap of another scene with the same contact sides. */
  dealii::Vector<double> assemble_gap_of(const Scene<dim> &scene) const;

  /** Returns W = Dᵀ U - G. Collective. */
  dealii::Vector<double> gap_residual(const Displacement &U) const;

private:
  /** Returns ∫ g ψ_k for functions g of the contacts. */
  dealii::Vector<double> moments_of(const Scene<dim> &scene,
                                    FunctionPointer<dim> ContactCondition<dim>::*data,
                                    Component component = Component::normal) const;
  /** Computes D, condensed D, G and K. @throws InputError for a multiplier without a free node. */
  void assemble(const Parameters &parameters, const Scene<dim> &scene);
};

/** Returns whether patches of a single face have multipliers of a degree that is not inf-sup
 * stable. */
template <int dim>
bool is_unstable(const Discretization<dim> &discretization) {
  return !discretization.space.has_several_elements() &&
         discretization.space.element().degree == 1 && discretization.surface.has_unstable_patch();
}

/** Returns the degree of every active cell. */
std::vector<unsigned int> degrees_of(const DisplacementSpace<2> &space);
} // namespace Signorini
