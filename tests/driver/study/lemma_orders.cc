// SPDX-License-Identifier: LGPL-2.1-or-later
// The orders of Lemmas 2, 3 and 5 and of the bounds (26), (27) and (30) on scene A1, H = 2 h.

#include <deal.II/base/mpi.h>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  auto overrides = levels(3, 6);
  overrides.emplace_back("Output/Lemmas=true");
  overrides.emplace_back("Output/Inf-sup constant=false");
  const StudyResult<2> result = solve(named_scene("A1"), overrides);
  struct Expectation
  {
    const char *name;
    const char *column;
    double low, high;
  };
  for (const Expectation &expected : {Expectation{"Lemma 2, L2", "lemma_2_l2", 0.95, 1.05},
                                      Expectation{"Lemma 2, dual norm", "lemma_2_dual", 1.45, 1.7},
                                      Expectation{"Lemma 3, H1", "lemma_3_h1", 0.95, 1.05},
                                      Expectation{"Lemma 3, trace", "lemma_3_trace", 1.48, 1.55},
                                      Expectation{"Lemma 5", "lemma_5", 1.9, 2.1},
                                      Expectation{"(26)", "bound_26", 1.7, 2.1},
                                      Expectation{"(27)", "bound_27", 1.9, 2.1},
                                      Expectation{"(30)", "bound_30", 1.9, 2.1}})
    checks.between(
      expected.name, slope(result.levels, expected.column), expected.low, expected.high);
  return checks.exit_code();
}
