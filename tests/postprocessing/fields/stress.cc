// SPDX-License-Identifier: LGPL-2.1-or-later
// Von Mises and principal stresses of states that are known.

#include <signorini/postprocessing/fields/stress.h>

#include "tests.h"

using namespace Signorini;

namespace
{
Stress3D stress(const double xx, const double yy, const double zz, const double xy)
{
  Stress3D result;
  result[0][0] = xx;
  result[1][1] = yy;
  result[2][2] = zz;
  result[0][1] = xy;
  return result;
}

void principal(Checks &checks,
               const std::string &name,
               const Stress3D &state,
               const std::array<double, 3> &expected)
{
  for (unsigned int i = 0; i < 3; ++i)
    checks.near(
      name + " " + std::to_string(i + 1), principal_stresses(state)[i], expected[i], 1e-15);
}
} // namespace

int main()
{
  Checks checks;
  checks.near("uniaxial", von_mises(stress(0., -2., 0., 0.)), 2., 1e-15);
  checks.near("hydrostatic", von_mises(stress(-3., -3., -3., 0.)), 0., 1e-15);
  checks.near("pure shear", von_mises(stress(0., 0., 0., 1.)), std::sqrt(3.), 1e-15);
  checks.near("stress across the plane", von_mises(stress(1., 0., 1., 0.)), 1., 1e-15);
  // Uniaxial in plane strain, nu = 0.3: sqrt(1 - nu + nu^2) of the stress.
  checks.near("plane strain", von_mises(stress(0., -1., -0.3, 0.)), std::sqrt(0.79), 1e-15);
  Stress3D out_of_plane;
  out_of_plane[0][2] = out_of_plane[1][2] = 1.;
  checks.near("shear out of the plane", von_mises(out_of_plane), std::sqrt(6.), 1e-15);

  principal(checks, "pure shear", stress(0., 0., 0., 1.), {{1., 0., -1.}});
  principal(checks, "across between the others", stress(3., -1., 0.5, 0.), {{3., 0.5, -1.}});
  principal(checks, "all in compression", stress(-1., -1., -2., 0.), {{-1., -1., -2.}});
  principal(checks, "turned", stress(2., 2., -4., 1.), {{3., 1., -4.}});
  return checks.exit_code();
}
