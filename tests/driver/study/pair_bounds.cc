// SPDX-License-Identifier: LGPL-2.1-or-later
// The guaranteed bound of pairs on graded meshes that do not match: never below the error, at most
// twice as large, with an interval of the energy on every mesh.

#include <signorini/driver/sequence/sequence.h>
#include <signorini/error_control/hp/step_examination.h>

#include <fstream>
#include <iomanip>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** Two blocks, and their energy by another program where it is known. */
struct BlockPair {
  std::string name, blocks, moduli, rest;
  std::optional<double> energy;
};

const std::string punch = "Geometry/Lower left = a: 0, 0 | b: 0, -1\n"
                          "Geometry/Upper right = a: 0.5, 0.5 | b: 1.5, 0\n",
                  halves = "Geometry/Lower left = a: 0, 0 | b: 0, -1\n"
                           "Geometry/Upper right = a: 1, 1 | b: 1, 0\n"
                           "Geometry/Cells = a: 2, 2 | b: 3, 3\n",
                  lowered = "Boundary/Rollers = a.left a.top b.left b.bottom\n"
                            "Contact/Gap = -0.02\n",
                  moved = "Boundary/Rollers = a.left b.left\nBoundary/Clamped = b.bottom\n"
                          "Boundary/Displacement = a.top: 0; -0.02\n",
                  parabola = moved + "Contact/Gap = 0.02*x^2\n";

const std::vector<BlockPair> pairs_of_blocks = {
  {"punch on a stiffer block", punch, "a: 1 | b: 10", lowered, 1.8983576180e-4},
  {"parabolic gap", halves, "a: 1 | b: 1", parabola, {}},
  // All layers of the smallest cells end in the rounding of the coordinates of a corner.
  {"block on a wider one",
   "Geometry/Lower left = a: 0.3, 1 | b: 0, 0\nGeometry/Upper right = a: 1.1, 1.6 | b: 2, 1\n"
   "Geometry/Cells = a: 3, 2 | b: 5, 2\n",
   "a: 3 | b: 1",
   "Boundary/Clamped = b.bottom\nBoundary/Traction = a.top: 0; -0.006\n",
   {}},
  {"punch", punch, "a: 1 | b: 1", lowered, 8.6309907219e-5},
  {"punch on a softer block", punch, "a: 1 | b: 0.1", lowered, 1.37707406e-5},
  {"parabolic gap, stiffer block", halves, "a: 1 | b: 10", parabola, {}},
  {"parabolic gap, softer block", halves, "a: 1 | b: 0.1", parabola, {}},
  {"block on a block", halves, "a: 1 | b: 3", moved, 1.7339031869e-4}};

/** A step with its bound. */
struct BoundedStep {
  std::shared_ptr<const Discretization<2>> discretization;
  Displacement U;
  ErrorBound bound;
  double scale;
};

/** Solves with the bound on every step. */
class BoundedSteps {
public:
  explicit BoundedSteps(const BlockPair &pair)
    : parameters_(parse_parameters(
        parameter_file("Geometry/Bodies = a b\nBoundary/Contact = a.bottom with b.top\n" +
                       pair.blocks + "Material/Poisson's ratio = 0.3\n" +
                       "Material/Young's modulus = " + pair.moduli + "\n" + pair.rest),
        "test",
        {"Discretization/Strategy=hp", "Discretization/Target error=1e-5", "Output/VTU=none"}))
    , scene_(make_scene<2>(parameters_, named_scenes())) {
    const Judge judge = judge_of(parameters_, scene_);
    const auto ignore = [](const std::string &) {};
    const auto bound = [&](const Discretization<2> &discretization, const Progress &,
                           LevelSolution<2> &solution) {
      add_bound(parameters_, discretization, ignore, solution);
    };
    const auto sequence = make_hp_sequence({parameters_, scene_, MPI_COMM_SELF, judge, bound});
    for (bool is_last = false; !is_last;) {
      const LevelResult<2> result = sequence->solve_next(ignore);
      is_last = result.is_last;
      if (result.why_again.empty())
        steps.push_back({result.discretization, result.solution.contact.U,
                         *result.solution.record.bound, result.solution.scale.norm});
    }
  }

  /** Returns the distance of a step to the last one. */
  double error(const BoundedStep &step) const {
    const auto body = [this](const BoundedStep &of) {
      return DisplacedBody<2>{of.discretization->space, scene_, of.U};
    };
    return energy_distance(body(step), body(steps.back()));
  }

  std::vector<BoundedStep> steps;

private:
  Parameters parameters_;
  Scene<2> scene_;
};

/** The error of the last step is at most its bound: that of another is its distance to the last
 * one, up to that. */
void bounds_of_steps(Checks &checks) {
  std::ofstream table("bound_pairs.csv");
  table << "scene,unknowns,error,bound,ratio,mesh,oscillation,contact\n" << std::setprecision(3);
  constexpr unsigned int n_rows = 3;
  constexpr double digits = 5e-9; // of energies by another program
  for (const BlockPair &pair : checks.rows(pairs_of_blocks, n_rows)) {
    checks.about(pair.name);
    const BoundedSteps run(pair);
    const double rest = run.steps.back().bound.absolute.value();
    for (const BoundedStep &step : run.steps) {
      const ErrorBound &bound = step.bound;
      checks.that("there is a bound", bound.absolute.has_value());
      checks.that("there is an interval", bound.energy_lower && bound.energy_upper);
      if (pair.energy)
        checks.that("the energy of another program lies in it",
                    *bound.energy_lower <= *pair.energy * (1. + digits) &&
                      *pair.energy * (1. - digits) <= *bound.energy_upper);
      if (&step == &run.steps.back())
        continue;
      const double error = run.error(step), ratio = *bound.absolute / error;
      checks.that("not below the error", *bound.absolute + rest >= error);
      constexpr double small = 1e-3;
      if (error < small * step.scale)
        checks.between("bound/error", ratio, 1. - rest / error, 2.);
      table << '"' << pair.name << "\"," << step.discretization->space.dofs().n_dofs() << ','
            << error / step.scale << ',' << *bound.relative << ',' << ratio << ','
            << *bound.mesh / step.scale << ',' << *bound.oscillation / step.scale << ','
            << *bound.contact / step.scale << '\n';
    }
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {bounds_of_steps});
}
