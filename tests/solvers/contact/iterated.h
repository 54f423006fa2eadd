// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/internal_forces.h>
#include <signorini/discretization/space/linear_system.h>
#include <signorini/solvers/contact/contact_iteration.h>
#include <signorini/solvers/stiffness/stiffness_multigrid.h>

/** The data of a level for the iteration. */
template <int dim>
struct Iterated {
  Iterated(const Signorini::DisplacementSpace<dim> &space_, const Signorini::Scene<dim> &scene,
           const Signorini::MultiplierSpace<dim> &multipliers, const Signorini::Coupling &D,
           const Signorini::Coupling &condensed_D, const dealii::Vector<double> &G)
    : space(space_)
    , A(space, scene)
    , gap(G)
    , model(make_boundary_model(multipliers))
    , contact{A, f, condensed_D, gap, *model} {
    // f = T^T (loads - a(k, .)), and the gap that k leaves.
    const Signorini::Displacement k = space.prescribed(scene);
    Signorini::DualVector r = assemble_right_hand_side(space, scene, 2, k).loads;
    r -= Signorini::internal_forces(Signorini::DisplacedBody<dim>(space, scene, k)).forces;
    f = space.condense(r);
    gap -= D.transpose_product(k);
  }
  Iterated(const Iterated &) = delete;

  Signorini::ContactIterationResult
  solve(const Signorini::ContactIterationOptions &options = {}) const {
    return solve_contact_by_cycles(contact, A.make_vector(), dealii::Vector<double>(gap.size()),
                                   options);
  }
  /** U = T U_free + k. */
  Signorini::Displacement complete(const Signorini::DualVector &U_free) const {
    Signorini::Displacement free = space.zero();
    std::copy(U_free.begin(), U_free.end(), free.begin());
    return space.complete(free);
  }

  const Signorini::DisplacementSpace<dim> &space;
  Signorini::StiffnessMultigrid<dim> A;
  Signorini::DualVector f;
  dealii::Vector<double> gap;
  std::shared_ptr<const Signorini::BoundaryModel> model;
  Signorini::ContactSystem contact;
};
