// SPDX-License-Identifier: LGPL-2.1-or-later
// Lemma 1 on the unit cube, clamped at the top: beta on patches of 2 x 2 faces falls slowly to a
// limit, on single faces like h². The numbers were computed by an independent program.

#include <signorini/problem/geometry/shapes.h>
#include <signorini/verification/norms/cosine_norm.h>
#include <signorini/verification/norms/inf_sup.h>

#include "box.h"
#include "tests.h"

using namespace Signorini;

namespace {
double beta(const unsigned int n, const unsigned int ratio) {
  Scene<3> scene = make_box_scene(zero, nothing);
  scene.geometry = make_box({0., 0., 0.}, {1., 1., 1.}, {n / 2, n / 2, n / 2});
  for (const char *side : {"left", "right", "front", "back"})
    scene.boundary[scene.geometry.find_side(side)].role = Role::free;
  const Box box(scene, 1, ratio);
  return measure_inf_sup(box.space, box.multipliers, box.condensed_D, dual_gram_matrix(box.surface),
                         LinearSolver::condensed)
    .both;
}

/** The other program cuts the cosine series off, so that its numbers are larger by up to 3e-3. */
void test_inf_sup(Checks &checks) {
  for (const auto &[n, low] :
       {std::pair(4, 0.870), std::pair(6, 0.8315), std::pair(8, 0.7955), std::pair(12, 0.7665)})
    checks.between("2 x 2 faces, n = " + std::to_string(n), beta(n, 2), low, low + 0.003);
  for (const auto &[n, expected] : {std::pair(4, 0.31), std::pair(6, 0.15), std::pair(8, 0.09)})
    checks.near("single faces, n = " + std::to_string(n), beta(n, 1), expected, 6e-3);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_inf_sup});
}
