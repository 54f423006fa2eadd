// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/cycles/contact_iteration.h>

#include "stand_in.h"

/** What the iteration needs of a level, with StandIn for A. */
template <int dim>
struct Iterated
{
  Iterated(const Signorini::DisplacementSpace<dim> &space_,
           const Signorini::Scene<dim> &scene,
           const Signorini::MultiplierSpace<dim> &multipliers,
           const Signorini::Coupling &D,
           const Signorini::Coupling &condensed_D,
           const dealii::Vector<double> &G,
           const double e = 0.15)
    : space(space_)
    , system(assemble_linear_system(space, scene, 2))
    , A(space, system, e)
    , f(system.f)
    , gap(G)
    , model(make_boundary_model(multipliers))
    , contact{A, f, condensed_D, gap, *model}
  {
    gap -= D.transpose_product(space.prescribed(scene));
  }
  Iterated(const Iterated &) = delete;

  Signorini::ContactIterationResult
  solve(const Signorini::ContactIterationOptions &options = {}) const
  {
    return solve_contact_by_cycles(
      contact, dealii::Vector<double>(A.size()), dealii::Vector<double>(gap.size()), options);
  }
  /** U = T U_free + k. */
  Signorini::Displacement complete(const dealii::Vector<double> &U_free) const
  {
    Signorini::DistributedVector free = space.make_vector();
    for (unsigned int i = 0; i < U_free.size(); ++i)
      free(i) = U_free[i];
    return space.complete(free);
  }

  const Signorini::DisplacementSpace<dim> &space;
  Signorini::LinearSystem<dim> system;
  StandIn<dim> A;
  dealii::Vector<double> f;
  dealii::Vector<double> gap;
  std::shared_ptr<const Signorini::BoundaryModel> model;
  Signorini::ContactSystem contact;
};
