// SPDX-License-Identifier: LGPL-2.1-or-later
// A bar of length and modulus one that a rigid plate shortens by 1/10: u = -x/10 from the clamp,
// J(u) = 1/200, and every number of the bracket is known.

#include <signorini/bound/energy_bracket.h>

#include "tests.h"

using namespace Signorini;

int main()
{
  Checks checks;
  // A constant stress tau < 0 is in equilibrium: -J*(tau) = -tau²/2 - tau g' with the gap -1/10.
  const double exact = 0.1 * 0.1 / 2.;
  for (const double tau : {-0.08, -0.1, -0.13})
  {
    const double minus_dual = -tau * tau / 2. - tau * 0.1;
    // u_h = u: no contact term, no lift, and the whole error is that of tau.
    const double eta = std::abs(tau + 0.1);
    const Bracket bracket = energy_bracket({-minus_dual, -minus_dual}, eta, 0., 0.);
    const std::string name = "tau = " + std::to_string(tau);
    checks.between(name + ": below", exact - bracket.lower, -1e-15, 1.);
    checks.near(name + ": above, sharp", bracket.upper, exact, 1e-15);
    checks.near(name + ": stress", stress_error_bound(eta, 0., 0.), eta, 1e-15);
    // z = x has the energy one, and the force is -1/10.
    checks.near(name + ": force", contact_force_bound(eta, 1.), std::abs(-0.1 - tau), 1e-15);
  }
  // u_h = -0.12 x/1, p_H = -0.12, tau = -0.12: d = -0.02, nothing to lift, 2 T = 2 * 0.12 * 0.02.
  const double tau = -0.12, contact_term = tau * -0.02;
  const double dual = tau * tau / 2. + tau * 0.1;
  const Bracket bracket = energy_bracket({dual, dual}, 0., 0., contact_term);
  checks.between("open: below", exact - bracket.lower, 0., 1.);
  checks.between("open: above", bracket.upper - exact, 0., 1.);
  checks.between("open: stress", stress_error_bound(0., 0., contact_term), 0.02, 1.);
  return checks.exit_code();
}
