// SPDX-License-Identifier: LGPL-2.1-or-later
// The integrals of middle meshes against those of twelve points: loads that oscillate (A2), and a
// gap with a fractional power at the end of contact (B4).

#include <signorini/driver/study/study.h>
#include <signorini/problem/input/make_scene.h>

#include <deal.II/base/mpi.h>

#include "tests.h"

using namespace Signorini;

namespace
{
LevelRecord level_6(const std::string &scene, const std::vector<std::string> &overrides)
{
  std::ostream silence(nullptr);
  const Parameters parameters =
    parse_parameters("subsection Scene\nset Name = " + scene +
                       "\nend\nsubsection Discretization\nset Coarsest level = 6\n"
                       "set Finest level = 6\nend\n",
                     "test",
                     overrides);
  return run_study(parameters,
                   make_scene<2>(parameters),
                   MPI_COMM_WORLD,
                   {silence, "", [](const std::string &) {}})
    .levels.back();
}

void compare(const std::string &scene, Checks &checks)
{
  const LevelRecord usual = level_6(scene, {});
  const LevelRecord accurate = level_6(scene, {"Discretization/Quadrature points=12"});
  for (const std::string column : {"energy",
                                   "contact_force_n",
                                   "u_h1",
                                   "u_l2",
                                   "u_superclose_h1",
                                   "p_l2",
                                   "p_superclose_dual_spectral"})
  {
    const double expected = value(accurate, column).value();
    checks.near(
      scene + " " + column, value(usual, column).value(), expected, 5e-9 * std::abs(expected));
  }
}
} // namespace

int main(int argc, char **argv)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  compare("A2", checks);
  compare("B4", checks);
  return checks.exit_code();
}
