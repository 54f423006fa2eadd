// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole studies against numbers of an independent implementation in another language (double
// precision, integrals to rounding), on one, two and three processes.

#include <signorini/driver/study/study.h>
#include <signorini/problem/input/make_scene.h>

#include <deal.II/base/mpi.h>

#include <sstream>

#include "tests.h"

using namespace Signorini;

namespace
{
struct Reference
{
  std::string name;
  std::string overrides;
  unsigned int level;
  unsigned int active;
  double contact_force;
  double energy;
  double max_pressure;
};

const std::vector<Reference> references = {
  {"quadrilateral", "", 3, 3, 0.13858240027660498, -0.005890348458949236, 0.2282780518280852},
  {"quadrilateral", "", 4, 6, 0.13839192367425984, -0.005925781477892526, 0.20266948649475497},
  {"pentagon", "", 3, 3, 0.04003223301365762, -0.0057536690077261395, 0.12753890606349427},
  {"pentagon", "", 4, 7, 0.04017614509343021, -0.005770977766959463, 0.12432245043818371},
  {"prescribed", "", 3, 3, 0.19337692547438123, 0.00127128827705591, 0.21051853341817103},
  {"prescribed", "", 4, 5, 0.19375090829099711, 0.0013847422957592973, 0.19149293342669613},
  {"a1", "", 4, 5, 0.624997097728132, -0.3288733998864932, 2.876448375675366},
  {"a1",
   "Discretization/Patches=7",
   4,
   4,
   0.6251670745768318,
   -0.3290949291164004,
   2.7803898504688527},
  {"two_sides", "", 4, 9, 2.23083963816478, -2.9371927226528616, 5.83514119178593}};

StudyResult<2> solve(const std::string &name, std::vector<std::string> overrides)
{
  std::ostream silence(nullptr);
  const Parameters parameters = read_parameters(SOURCE_DIR "/../runs/" + name + ".prm", overrides);
  return run_study(parameters,
                   make_scene<2>(parameters),
                   MPI_COMM_WORLD,
                   {silence, "", [](const std::string &) {}});
}

void compare(const Reference &reference, Checks &checks)
{
  std::vector<std::string> overrides = {"Discretization/Coarsest level=3",
                                        "Discretization/Finest level=" +
                                          std::to_string(reference.level)};
  if (!reference.overrides.empty())
    overrides.push_back(reference.overrides);
  const StudyResult<2> result = solve(reference.name, overrides);
  const LevelRecord &finest = result.levels.back();
  const std::string name =
    reference.name + " " + reference.overrides + " level " + std::to_string(reference.level);
  checks.that(name + " certified", result.verdict.equations_hold());
  checks.that(name + " active", finest.contact.active == reference.active);
  const auto close = [&](const std::string &what, const double value, const double expected) {
    checks.near(name + " " + what, value, expected, 2e-10 * std::abs(expected));
  };
  close("force", finest.contact.normal_force, reference.contact_force);
  close("energy", finest.certificate.energy, reference.energy);
  close("pressure", finest.contact.max_pressure, reference.max_pressure);
}

/** A1 on level 4. */
void compare_errors(Checks &checks)
{
  const LevelRecord finest = solve("a1", {"Discretization/Finest level=4"}).levels.back();
  const auto close = [&](const std::string &column, const double expected) {
    checks.near("a1 " + column, value(finest, column).value(), expected, 1e-9 * expected);
  };
  close("u_h1", 0.047825368086956775);
  close("u_l2", 0.0014764668602787931);
  close("u_superclose_h1", 0.020410892243168884);
  close("u_post_h1", 0.02148986853828931);
  close("p_l2", 0.21496795974362748);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);
  for (const Reference &reference : references)
    compare(reference, checks);
  compare_errors(checks);
  return checks.exit_code();
}
