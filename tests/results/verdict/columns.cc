// SPDX-License-Identifier: LGPL-2.1-or-later
// The columns of a level: each declared once, at its position, and empty where nothing is known.

#include <signorini/base/columns.h>
#include <signorini/base/text.h>
#include <signorini/results/verdict/level_record.h>

#include <set>
#include <stdexcept>

#include "tests.h"

using namespace Signorini;

namespace {
void positions(Checks &checks) {
  std::vector<std::string> names;
  for (const Column<LevelRecord> &column : level_columns())
    names.push_back(column.name);
  checks.that("no name stands twice",
              std::set<std::string>(names.begin(), names.end()).size() == names.size());
  // Scripts read columns by their numbers: this line may grow at its end, nothing else.
  const std::string until_now =
    "level,cells,dofs,multipliers,h,H,active,qp_iterations,kkt,inf_sup,energy,contact_force_n,"
    "max_pressure,contact_length,u_h1,u_l2,u_superclose_h1,u_post_h1,p_l2,p_dual,p_dual_spectral,"
    "p_superclose_dual,p_superclose_dual_spectral,p_post_l2,endpoint_error,estimated_h1,"
    "effectivity,t_mesh,t_setup,t_assembly,t_factor,t_compliance,t_qp,t_recovery,t_postprocess,"
    "t_errors,t_output,t_total,cpu_total,peak_memory_mb,qp_increment_iterations,lemma_2_l2,"
    "lemma_2_dual,lemma_3_h1,lemma_5,bound_26,bound_27,bound_30,lemma_3_trace,u_post4_h1";
  checks.that("columns do not move", join(names, ",").compare(0, until_now.size(), until_now) == 0);
}

void values(Checks &checks) {
  LevelRecord record;
  record.sizes.dofs = 50;
  record.contact.normal_force = 2.;
  record.times.mesh = 1.;
  record.times.output = 0.5;
  checks.that("of a part that every record has", value(record, "dofs") == 50. &&
                                                   value(record, "contact_force_n") == 2. &&
                                                   value(record, "t_total") == 1.5);
  checks.that("empty without the part",
              !value(record, "u_h1") && !value(record, "effectivity") && !value(record, "inf_sup"));
  record.estimate = ErrorEstimate{0.3, 0.2, 0.1, 0.16, 0.12};
  checks.that("no effectivity without an error", !value(record, "effectivity"));
  record.displacement_errors = DisplacementErrors{0.4, 0.1, 0.2, {}, {}, 0.25};
  checks.that("of a part that is known",
              value(record, "u_h1") == 0.4 && value(record, "estimated_h1") == 0.3);
  checks.that("empty within a part that is known", !value(record, "u_post_h1"));
  checks.near("effectivity", *value(record, "effectivity"), 0.75, 1e-15);
  checks.near("effectivity in energy", *value(record, "effectivity_energy"), 0.8, 1e-15);
  record.displacement_errors->h1 = 0.;
  checks.that("no effectivity of an exact solution", !value(record, "effectivity"));
  checks.throws<std::invalid_argument>("no such column", "u_h2", [&]() { value(record, "u_h2"); });
}

} // namespace

int main() {
  return run_tests({positions, values});
}
