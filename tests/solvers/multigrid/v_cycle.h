// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/solvers/multigrid/stiffness_multigrid.h>

#include <cmath>
#include <string>

#include "one_level.h"
#include "random_numbers.h"
#include "study_helpers.h"
#include "tests.h"

/** Mesh, space and multigrid of a scene. */
template <int dim>
struct HeldBody
{
  HeldBody(Signorini::Scene<dim> given_scene,
           const unsigned int coarsest_level,
           const unsigned int level,
           const Signorini::StrainOperator strain = Signorini::StrainOperator::symmetric_gradient)
    : scene(std::move(given_scene))
    , mesh(scene.geometry, coarsest_level, level, MPI_COMM_WORLD)
    , space(mesh, scene, strain)
    , multigrid(space, scene)
  {
  }
  HeldBody(const HeldBody &) = delete;

  /** Numbers without pattern at free degrees of freedom. */
  dealii::Vector<double> random_vector(const unsigned int seed) const
  {
    dealii::Vector<double> values = RandomNumbers(seed).vector(space.dofs().n_dofs());
    space.constraints().set_zero(values);
    return values;
  }

  Signorini::Scene<dim> scene;
  Signorini::Mesh<dim> mesh;
  Signorini::DisplacementSpace<dim> space;
  Signorini::StiffnessMultigrid<dim> multigrid;
};

/** How many steps of conjugate gradients, preconditioned by the V-cycle, make the norm
 * (r.V r)^{1/2} of the residual 1e-8 of what it was. */
inline unsigned int conjugate_gradients(const Signorini::StiffnessOperator &A,
                                        dealii::Vector<double> &x,
                                        const dealii::Vector<double> &b)
{
  dealii::Vector<double> r(b), z(b), p(b), q(b);
  x = 0.;
  A.precondition(z, r);
  p = z;
  double rz = r * z;
  const double goal = 1e-16 * rz;
  unsigned int n_steps = 0;
  while (rz > goal && n_steps < 500)
  {
    ++n_steps;
    A.apply(q, p);
    const double alpha = rz / (p * q);
    x.add(alpha, p);
    r.add(-alpha, q);
    A.precondition(z, r);
    const double before = rz;
    rz = r * z;
    p.sadd(rz / before, 1., z);
  }
  return n_steps;
}
