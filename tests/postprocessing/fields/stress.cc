// SPDX-License-Identifier: LGPL-2.1-or-later
// Von Mises and principal stresses of states that are known.

#include <signorini/postprocessing/fields/stress.h>

#include "tests.h"

using namespace Signorini;

namespace {
Stress3D stress(const double xx, const double yy, const double zz, const double xy) {
  Stress3D result;
  result[0][0] = xx;
  result[1][1] = yy;
  result[2][2] = zz;
  result[0][1] = xy;
  return result;
}

void von_mises_stress(Checks &checks) {
  // Uniaxial, hydrostatic, pure shear, across the plane, and uniaxial in plane strain, nu = 0.3:
  // sqrt(1 - nu + nu^2) of the stress.
  for (const auto &[state, expected] :
       {std::pair(stress(0., -2., 0., 0.), 2.), std::pair(stress(-3., -3., -3., 0.), 0.),
        std::pair(stress(0., 0., 0., 1.), std::sqrt(3.)), std::pair(stress(1., 0., 1., 0.), 1.),
        std::pair(stress(0., -1., -0.3, 0.), std::sqrt(0.79))})
    checks.near("von Mises", von_mises(state), expected, 1e-15);
  Stress3D out_of_plane;
  out_of_plane[0][2] = out_of_plane[1][2] = 1.;
  checks.near("shear out of the plane", von_mises(out_of_plane), std::sqrt(6.), 1e-15);
}

void principal(Checks &checks) {
  using Three = std::array<double, 3>;
  for (const auto &[state, expected] :
       {std::pair(stress(0., 0., 0., 1.), Three{{1., 0., -1.}}),
        std::pair(stress(3., -1., 0.5, 0.), Three{{3., 0.5, -1.}}),
        std::pair(stress(-1., -1., -2., 0.), Three{{-1., -1., -2.}}),
        std::pair(stress(2., 2., -4., 1.), Three{{3., 1., -4.}})})
    for (unsigned int i = 0; i < 3; ++i)
      checks.near("principal stresses", principal_stresses(state)[i], expected[i], 1e-15);
}
} // namespace

int main() {
  return run_tests({von_mises_stress, principal});
}
