// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/internal_forces.h>
#include <signorini/discretization/space/nodes.h>
#include <signorini/driver/level/level.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/scene/functions.h>
#include <signorini/verification/catalogue/catalogue.h>

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

#include "random_numbers.h"
#include "scene_text.h"

/** Returns the scene of a text (scene_text.h). */
inline Signorini::Scene<2> scene_of(const std::string &text) {
  return Signorini::make_scene<2>(Signorini::parse_parameters(parameter_file(text), "test"),
                                  Signorini::named_scenes());
}

/** Returns all ranks for a level that they can share, else each one alone. */
template <int dim>
MPI_Comm ranks_for(const Signorini::Scene<dim> &scene, const unsigned int level) {
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const bool can_share =
    scene.geometry.distortion == 0. && !scene.is_held_by_contact &&
    level > Signorini::level_of_subtrees(scene.geometry.n_coarse_cells, dim, n_ranks);
  return can_share ? MPI_COMM_WORLD : MPI_COMM_SELF;
}

/** A scene from the text of a parameter file or of its entries (scene_text.h) and overrides, and
 * its discretization on one level. */
struct OneLevel {
  OneLevel(const std::string &text, const unsigned int level,
           const std::vector<std::string> &overrides = {})
    : parameters(Signorini::parse_parameters(parameter_file(text), "test", overrides))
    , scene(Signorini::make_scene<2>(parameters, Signorini::named_scenes()))
    , discretization(parameters, scene, level, ranks_for(scene, level)) {}
  /** On the mesh of a plan. */
  OneLevel(const std::string &text, const Signorini::MeshPlan &plan)
    : parameters(Signorini::parse_parameters(parameter_file(text), "test"))
    , scene(Signorini::make_scene<2>(parameters, Signorini::named_scenes()))
    , discretization(parameters, scene, plan) {}
  OneLevel(const OneLevel &) = delete;

  const Signorini::DisplacementSpace<2> &space() const {
    return discretization.space;
  }
  const Signorini::MultiplierSpace<2> &multipliers() const {
    return discretization.multipliers;
  }
  /** The body displaced by U, and pressed by P. */
  Signorini::DisplacedBody<2> body(const Signorini::Displacement &U) const {
    return {space(), scene, U};
  }
  Signorini::BodyInContact<2> body(const Signorini::Displacement &U,
                                   const Signorini::Multiplier &P) const {
    return {body(U), multipliers(), P};
  }
  Signorini::SolverChoice solvers() const {
    return choose_solvers(parameters, scene, 0);
  }
  Signorini::LevelSolution<2> solve() const {
    const auto ignore = [](const std::string &) {};
    const Signorini::LevelProblem<2> problem = {parameters, scene, solvers()};
    auto solution =
      Signorini::solve_level(problem, discretization, Signorini::ContactStart(), ignore);
    if (parameters.discretization.target_error > 0.)
      Signorini::add_bound(parameters, discretization, ignore, solution);
    Signorini::release_unused(problem, solution);
    return solution;
  }

  /** Returns the distance to the interpolation on T^{2h}. */
  Signorini::ErrorEstimate estimate(const Signorini::Displacement &U) const {
    return estimate_error(body(U),
                          {internal_forces(body(U)).energy_norm, norm_of_rigid_motion(body(U))});
  }

  Signorini::Parameters parameters;
  Signorini::Scene<2> scene;
  Signorini::Discretization<2> discretization;
};

/** A level of a box in space that is solved, from entries and overrides. */
struct SolvedBox {
  SolvedBox(const std::string &text, const unsigned int level,
            const std::vector<std::string> &overrides = {})
    : parameters(Signorini::parse_parameters(
        parameter_file("set Dimension = 3\nGeometry/Shape = box\n" + text), "test", overrides))
    , scene(Signorini::make_scene<3>(parameters))
    , discretization(parameters, scene, level, ranks_for(scene, level))
    , found(Signorini::solve_level<3>({parameters, scene, choose_solvers(parameters, scene, level)},
                                      discretization, Signorini::ContactStart(),
                                      [](const std::string &) {})) {}
  SolvedBox(const SolvedBox &) = delete;

  Signorini::Parameters parameters;
  Signorini::Scene<3> scene;
  Signorini::Discretization<3> discretization;
  Signorini::LevelSolution<3> found;
};

/** A displacement as a function of x. */
using Field = Signorini::FieldFunction<2>::Field;

/** Returns the field's values at all nodes, on every rank. */
inline Signorini::Displacement nodal_values(const Signorini::DisplacementSpace<2> &space,
                                            const Field &field) {
  return interpolate_at_nodes(space, Signorini::FieldFunction<2>(field));
}

/** Returns random numbers in the rows of A, the same ones on any number of ranks. */
inline Signorini::Displacement random_rows(const Signorini::DisplacementSpace<2> &space,
                                           RandomNumbers &random) {
  Signorini::Displacement rows = space.zero();
  const auto values = random.vector(space.dofs().n_dofs());
  for (const auto i : space.locally_owned())
    rows(i) = values[i];
  rows.update_ghost_values();
  return rows;
}

/** Returns max |a_i - b_i|. */
template <typename First, typename Second>
double distance(const First &a, const Second &b) {
  First difference(a);
  difference -= b;
  return difference.size() == 0 ? 0. : difference.linfty_norm();
}
