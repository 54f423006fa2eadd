// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes are graded unless something asks for nested ones, and begin with enough cells.

#include <signorini/driver/runs/strategy.h>
#include <signorini/problem/input/make_scene.h>

#include "scene_text.h"
#include "tests.h"

using namespace Signorini;

namespace {
const std::string scene = "Boundary/Contact = bottom\nBoundary/Clamped = top\n";

StrategyDecision decide(const std::string &entries) {
  const Parameters given = parse_parameters(parameter_file(scene + entries), "test");
  return decide_strategy(given, make_scene<2>(given));
}

bool is(const StrategyDecision &decision, const std::vector<std::string> &overrides) {
  return decision.overrides == overrides;
}
} // namespace

int main(int argc, char *argv[]) {
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  const std::string hp = "Discretization/Strategy=hp", nested = "Discretization/Strategy=nested",
                    level = "Discretization/Coarsest level=";
  checks.that("nothing given", is(decide(""), {hp, level + "3"}));
  checks.that("a target alone",
              is(decide("Discretization/Target error = 1e-4"), {hp, level + "3"}));
  checks.that("many cells", is(decide("Geometry/Cells = 8, 3"), {hp, level + "0"}));
  checks.that("a stated strategy", is(decide("Discretization/Strategy = nested"), {}));
  checks.that("a stated strategy has no reason",
              decide("Discretization/Strategy = hp").sentence.empty());
  for (const std::string entry :
       {"Discretization/Finest level = 6", "Discretization/Coarsest level = 2"}) {
    checks.that(entry, is(decide(entry), {nested}));
    checks.that(entry + " needs no reason", decide(entry).sentence.empty());
  }
  checks.that("a stated level",
              is(decide("Discretization/Strategy = hp\nDiscretization/Coarsest level = 2"), {}));
  for (const std::string entry :
       {"Discretization/Element = Q2", "Discretization/Patch ratio = 4",
        "Discretization/Patches = 3", "Geometry/Distortion = 0.1",
        "Solver/Contact solver = multigrid", "Solver/Linear solver = multigrid",
        "Solver/Require stability = true", "Output/Inf-sup constant = true",
        "Output/Lemmas = true"}) {
    const StrategyDecision decision = decide(entry);
    checks.that(entry, is(decision, {nested}));
    checks.that(entry + " is the reason",
                decision.sentence ==
                  "nested, since " + entry.substr(0, entry.find(" =")) + " is given");
  }
  // The levels of pairs: the first one on which they face each other on some faces, and few
  // unknowns.
  const auto levels = [&](const std::string &cells, const std::string &more = "") {
    const Parameters given = parse_parameters(
      parameter_file("Geometry/Bodies = a b\nGeometry/Lower left = a: 0, 0 | b: 0, 1\n"
                     "Geometry/Upper right = a: 2, 1 | b: 1, 2\nGeometry/Cells = " +
                     cells +
                     "\nBoundary/Contact = a.top with b.bottom\nBoundary/Clamped = "
                     "a.bottom b.top\n" +
                     more),
      "test");
    return decide_strategy(given, make_scene<2>(given)).levels;
  };
  using Levels = std::array<unsigned int, 2>;
  checks.that("a pair of few cells", levels("1, 1") == Levels{{2, 6}});
  checks.that("a pair of many cells", levels("64, 32") == Levels{{0, 2}});
  checks.that("a pair of very many cells", levels("600, 300") == Levels{{0, 1}});
  checks.that("many cells, few on the pair", levels("2, 200") == Levels{{1, 4}});
  checks.that("a pair with stated levels",
              !levels("64, 32", "Discretization/Finest level = 3\n").has_value());
  const Parameters a1 = parse_parameters(parameter_file("Scene/Name = A1"), "test");
  checks.that("an exact solution", is(decide_strategy(a1, make_scene<2>(a1)), {nested}));
  const Parameters d3 = parse_parameters(parameter_file("Scene/Name = D3"), "test");
  checks.that("in space", is(decide_strategy(d3, make_scene<3>(d3)), {nested}));
  return checks.exit_code();
}
