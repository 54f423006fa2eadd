// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/level/discretization.h>
#include <signorini/error_control/contact_term/contact_lift.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_solver.h>

#include <deal.II/base/mpi.h>

#include <memory>
#include <string>

/** One level of a scene with U, P and what they were computed from. */
struct SolvedLevel
{
  SolvedLevel(const std::string &text, const unsigned int number)
    : parameters(Signorini::parse_parameters(text, "test"))
    , scene(Signorini::make_scene<2>(parameters))
    , level(parameters, scene, number, MPI_COMM_WORLD)
    , system(Signorini::assemble_linear_system(level.space, scene, level.n_points))
    , inverse(Signorini::factorise(system.matrix,
                                   system.unit,
                                   parameters.solver.linear_solver,
                                   Signorini::contact_unknowns(level.condensed_D)))
  {
    using namespace Signorini;
    const FreeState free = solve_free_state(*inverse, level.space, system.f, level.D, level.G);
    P.reinit(level.multipliers.n_multipliers());
    if (!free.nothing_touches())
    {
      double seconds = 0.;
      const auto C = make_compliance(*inverse, level.condensed_D, seconds);
      P = Pressure(solve_dual_problem(C, free.F, {}, {}).P);
    }
    U = recover_displacement(*inverse, level.space, level.condensed_D, P, system.f);
  }
  SolvedLevel(const SolvedLevel &) = delete;

  Signorini::ContactLift lift(const bool dual) const
  {
    std::optional<Signorini::ContactLift::DualData> data;
    if (dual)
      data.emplace(Signorini::ContactLift::DualData{*inverse, level.condensed_D});
    return {level.space, scene, level.multipliers, U, P, data};
  }

  Signorini::Parameters parameters;
  Signorini::Scene<2> scene;
  Signorini::Discretization<2> level;
  Signorini::LinearSystem<2> system;
  std::unique_ptr<Signorini::StiffnessInverse> inverse;
  Signorini::Pressure P;
  Signorini::Displacement U;
};

/** The parameter file of a scene of the catalogue, or of a whole file's text. */
inline std::string named(const std::string &name)
{
  return "subsection Scene\nset Name = " + name + "\nend\n";
}

inline std::string described(const std::string &text)
{
  return "subsection Scene\nset Name = described\nend\n" + text;
}

inline std::string gap(const std::string &g)
{
  return "subsection Contact\nset Gap = " + g + "\nend\n";
}

/** The tip of an indenter between the nodes of coarse meshes, as far as its mean over patches is
 * an opening. */
inline const std::string missed =
  described("subsection Geometry\nset Lower left = -1, 0\nset Upper right = 1, 2\nend\n"
            "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" +
            gap("(x-0.0313)^2/(2*0.08)-0.003"));
