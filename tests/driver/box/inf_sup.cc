// SPDX-License-Identifier: LGPL-2.1-or-later
// Lemma 1 on the unit cube, clamped at the top: beta on patches of 2 x 2 faces falls slowly to a
// limit, on single faces like h². The numbers were computed by an independent program.

#include <signorini/postprocessing/norms/spectral_norm.h>

#include "box.h"
#include "tests.h"

using namespace Signorini;

namespace
{
double beta(const unsigned int n, const unsigned int ratio)
{
  Scene<3> scene = make_box_scene(scalar([](const auto &) { return 0.; }),
                                  field([](const auto &) { return Vector3(); }));
  scene.geometry = make_box({0., 0., 0.}, {1., 1., 1.}, {n / 2, n / 2, n / 2});
  for (const char *side : {"left", "right", "front", "back"})
    scene.boundary[scene.geometry.find_side(side)].role = Role::free;
  const Box box(scene, 1, ratio);
  return measure_inf_sup(box.space, box.multipliers, box.condensed_D, LinearSolver::condensed);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  // The other program cuts the cosine series off, so that its numbers are larger by up to 3e-3.
  checks.between("2 x 2 faces, n = 4", beta(4, 2), 0.870, 0.8725);
  checks.between("2 x 2 faces, n = 6", beta(6, 2), 0.8315, 0.8345);
  checks.between("2 x 2 faces, n = 8", beta(8, 2), 0.7955, 0.7985);
  checks.between("2 x 2 faces, n = 12", beta(12, 2), 0.7665, 0.7695);
  checks.near("single faces, n = 4", beta(4, 1), 0.31, 6e-3);
  checks.near("single faces, n = 6", beta(6, 1), 0.15, 6e-3);
  checks.near("single faces, n = 8", beta(8, 1), 0.09, 6e-3);
  return checks.exit_code();
}
