// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/linear_system.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/solvers/stiffness/stiffness_multigrid.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <string>

#include "one_level.h"
#include "random_numbers.h"
#include "study_helpers.h"
#include "tests.h"

/** Mesh, space and multigrid of a scene. */
template <int dim>
struct HeldBody {
  HeldBody(Signorini::Scene<dim> given_scene, const unsigned int coarsest_level,
           const unsigned int level,
           const Signorini::StrainOperator strain = Signorini::StrainOperator::symmetric_gradient)
    : scene(std::move(given_scene))
    , mesh(scene.geometry, coarsest_level, level, ranks_for(scene, level))
    , space(mesh, scene, strain)
    , multigrid(space, scene) {}
  HeldBody(const HeldBody &) = delete;

  /** Numbers without pattern at free degrees of freedom. */
  Signorini::DualVector random_vector(const unsigned int seed) const {
    const dealii::Vector<double> values = RandomNumbers(seed).vector(space.dofs().n_dofs());
    Signorini::DualVector own = multigrid.make_vector();
    for (const auto i : own.locally_owned_elements())
      if (!space.constraints().is_constrained(i))
        own(i) = values[i];
    return own;
  }

  Signorini::Scene<dim> scene;
  Signorini::Mesh<dim> mesh;
  Signorini::DisplacementSpace<dim> space;
  Signorini::StiffnessMultigrid<dim> multigrid;
};

/** How many steps of conjugate gradients, preconditioned by the V-cycle, make the residual 1e-8 of
 * what it was; 500 if they fail. */
inline unsigned int conjugate_gradients(const Signorini::StiffnessOperator &A,
                                        Signorini::DualVector &x, const Signorini::DualVector &b) {
  struct VCycle {
    const Signorini::StiffnessOperator &A;
    void vmult(Signorini::DualVector &z, const Signorini::DualVector &r) const {
      A.precondition(z, r);
    }
  };
  dealii::SolverControl control(500, 1e-8 * b.l2_norm());
  x = 0.;
  try {
    dealii::SolverCG<Signorini::DualVector>(control).solve(A, x, b, VCycle{A});
  } catch (const dealii::SolverControl::NoConvergence &) {
  }
  return control.last_step();
}
