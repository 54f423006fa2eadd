// SPDX-License-Identifier: LGPL-2.1-or-later
// Solves a scene and prints its contact force.

#include <signorini/driver/study/study.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/verification/catalogue/catalogue.h>

#include <iostream>

int main(int argc, char **argv) {
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Signorini::Parameters parameters = Signorini::read_parameters(argv[1]);
  const Signorini::StudyResult<2> result = Signorini::run_study(
    parameters, Signorini::make_scene<2>(parameters, Signorini::named_scenes()), MPI_COMM_WORLD,
    {std::cout, "", [](const std::string &) {}});
  std::cout << "force " << result.levels.back().contact.normal_force << std::endl;
  return result.verdict.is_certified() ? 0 : 2;
}
