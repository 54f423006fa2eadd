// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes are graded unless something asks for nested ones, and begin with enough cells.

#include <signorini/driver/runs/strategy.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/verification/catalogue/catalogue.h>

#include "scene_text.h"
#include "tests.h"

using namespace Signorini;

namespace {
const std::string scene = "Boundary/Contact = bottom\nBoundary/Clamped = top\n";

/** The entries that a run decides: the strategy and the levels, and their reason. */
struct Decision {
  Strategy strategy;
  unsigned int coarsest, finest;
  std::string sentence;
};

template <int dim>
Decision decide(Parameters parameters) {
  const Scene<dim> scene = make_scene<dim>(parameters, named_scenes());
  const std::string sentence = decide_strategy(parameters, scene);
  const DiscretizationParameters &decided = parameters.discretization;
  return {decided.strategy, decided.coarsest_level, decided.finest_level, sentence};
}

Decision decide(const std::string &entries) {
  return decide<2>(parse_parameters(parameter_file(scene + entries), "test"));
}

bool is(const Decision &decision, const Strategy strategy, const unsigned int coarsest = 2) {
  return decision.strategy == strategy && decision.coarsest == coarsest;
}
} // namespace

int main(int argc, char *argv[]) {
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  const Strategy hp = Strategy::hp, nested = Strategy::nested;
  checks.that("nothing given", is(decide(""), hp, 3));
  checks.that("a target alone", is(decide("Discretization/Target error = 1e-4"), hp, 3));
  checks.that("many cells", is(decide("Geometry/Cells = 8, 3"), hp, 0));
  checks.that("a stated strategy", is(decide("Discretization/Strategy = nested"), nested));
  checks.that("a stated strategy has no reason",
              decide("Discretization/Strategy = hp").sentence.empty());
  for (const std::string entry :
       {"Discretization/Finest level = 6", "Discretization/Coarsest level = 2"}) {
    checks.that(entry, is(decide(entry), nested));
    checks.that(entry + " needs no reason", decide(entry).sentence.empty());
  }
  checks.that("a stated level",
              is(decide("Discretization/Strategy = hp\nDiscretization/Coarsest level = 2"), hp));
  for (const std::string entry :
       {"Discretization/Element = Q2", "Discretization/Patch ratio = 4",
        "Discretization/Patches = 3", "Geometry/Distortion = 0.1",
        "Solver/Contact solver = multigrid", "Solver/Linear solver = multigrid",
        "Solver/Require stability = true", "Output/Inf-sup constant = true",
        "Output/Lemmas = true"}) {
    const Decision decision = decide(entry);
    checks.that(entry, is(decision, nested));
    checks.that(entry + " is the reason",
                decision.sentence ==
                  "nested, since " + entry.substr(0, entry.find(" =")) + " is given");
  }
  // The echo has the decided values, so that it repeats the run.
  Parameters repeated = parse_parameters(parameter_file(scene), "test");
  decide_strategy(repeated, make_scene<2>(repeated, named_scenes()));
  checks.that("the echo repeats the decision",
              is(decide<2>(parse_parameters(repeated.echo, "echo")), hp, 3));
  solve_all_nested_levels(repeated);
  checks.that("and a change of it",
              parse_parameters(repeated.echo, "echo").discretization.strategy == nested);
  const std::string pair = "Geometry/Bodies = a b\nGeometry/Lower left = a: 0, 0 | b: 0, 1\n"
                           "Geometry/Upper right = a: 2, 1 | b: 1, 2\n"
                           "Boundary/Contact = a.top with b.bottom\n"
                           "Boundary/Clamped = a.bottom b.top\n";
  const auto of_pair = [&](const std::string &more) {
    return decide<2>(parse_parameters(parameter_file(pair + more), "test"));
  };
  checks.that("a pair", is(of_pair("Geometry/Cells = 4, 4\n"), hp, 0));
  checks.that("a pair with stated levels",
              is(of_pair("Discretization/Finest level = 3\n"), nested));
  checks.that("an exact solution",
              is(decide<2>(parse_parameters(parameter_file("Scene/Name = A1"), "test")), nested));
  checks.that("in space",
              is(decide<3>(parse_parameters(parameter_file("Scene/Name = D3"), "test")), nested));
  return checks.exit_code();
}
