// SPDX-License-Identifier: LGPL-2.1-or-later
// A contact pressure on a rectangle: its recovery, transfer, norms, errors.

#include <signorini/postprocessing/fields/contact_intervals.h>
#include <signorini/postprocessing/fields/pressure_transfer.h>
#include <signorini/postprocessing/fields/recovered_pressure.h>
#include <signorini/verification/norms/cosine_norm.h>
#include <signorini/verification/norms/errors.h>
#include <signorini/verification/norms/exact_pressure.h>

#include <algorithm>

#include "box.h"
#include "tests.h"

using namespace Signorini;

namespace {
constexpr double pi = dealii::numbers::PI;

using Function2 = std::function<double(const dealii::Point<2> &)>;

/** The recovered pressure is a function at points of all patches, on their edges, too. */
void check_recovery(Checks &checks, const std::string &name, const Box &box, const Function2 &p,
                    const Function2 &expected) {
  const RecoveredPressure<3> recovered(box.multipliers, box.at_centres(p));
  for (unsigned int tau = 0; tau < box.surface.patches().size(); ++tau) {
    const Patch<3> &patch = box.surface.patches()[tau];
    for (const double x : {0., 0.3, 0.5, 1.})
      for (const double y : {0., 0.6, 1.}) {
        const dealii::Point<2> s(patch.lower[0] + x * (patch.upper[0] - patch.lower[0]),
                                 patch.lower[1] + y * (patch.upper[1] - patch.lower[1]));
        checks.near(name, recovered(tau, s), expected(box.at(tau, s)), 1e-14);
      }
  }
}

void recovery(Checks &checks) {
  const Scene<3> scene = make_box_scene(zero, nothing, {1., 2., 1.});
  const Function2 linear = [](const auto &s) { return -(4. + s[0] - 1.5 * s[1]); };
  const Function2 pulling = [](const auto &s) { return s[0] - 0.75; },
                  cut = [](const auto &s) { return std::min(0., s[0] - 0.75); },
                  constant = [](const auto &) { return -3.; };
  for (const unsigned int ratio : {1U, 2U, 4U})
    check_recovery(checks, "a linear pressure is recovered", Box(scene, 3, ratio), linear, linear);
  check_recovery(checks, "nowhere positive, but the line goes on to zero", Box(scene, 3, 2),
                 pulling, cut);
  check_recovery(checks, "a single patch: a constant", Box(scene, 1, 2), constant, constant);
}

void transfer(Checks &checks) {
  const Scene<3> scene = make_box_scene(zero, nothing, {1., 2., 1.});
  const Function2 linear = [](const auto &s) { return -(1. + s[0] + 2. * s[1]); };
  const Box fine(scene, 3, 2), coarse(scene, 2, 2), next(scene, 4, 2);
  const Pressure P = fine.at_centres(linear);
  const auto move = [](const Box &from, const Pressure &p, const Box &to) {
    return transfer_pressure<3>({from.surface.patches(), p}, to.surface.patches());
  };
  const auto same = [&](const std::string &name, Pressure a, const Pressure &b) {
    a -= b;
    checks.near(name, a.linfty_norm(), 0., 1e-14);
  };
  same("to the same patches", move(fine, P, fine), P);
  same("to patches twice as long: its means", move(fine, P, coarse), coarse.at_centres(linear));
  same("to finer ones and back", move(next, move(fine, P, next), fine), P);
  checks.near(
    "force",
    summarise_contact(next.multipliers, move(coarse, move(fine, P, coarse), next)).normal_force, 7.,
    1e-13);
}

/** Patches of 2, 2 and 3 cells; errors() and inf_sup.cc have the norms themselves. */
void unequal_patches(Checks &checks) {
  const PatchGrid uneven = {0, 0, {{{0., 0.2, 0.4, 0.7}, {0., 0.2}}}, {2, 0, 1}};
  checks.that("unequal patches: cells",
              equal_cells(uneven)[0] == std::vector<unsigned int>({0, 2, 4, 7}));
  const std::vector<double> P = {5., 6., 4.};
  const auto values = values_on(uneven, dealii::Vector<double>(P.begin(), P.end()));
  checks.near("their values",
              {values.m() * 1., values.n() * 1., values(1, 0), values(2, 0), values(6, 0)},
              {7., 1., 4., 5., 6.}, 0.);
}

/** A scene with the pressure p at the bottom of 1 x 2. */
Scene<3> with_pressure(const std::function<double(const dealii::Point<3> &)> &p) {
  Scene<3> scene = make_box_scene(zero, nothing, {1., 2., 1.});
  scene.contacts[0].exact_pressure = scalar(p);
  return scene;
}

void errors(Checks &checks) {
  const auto wave = [](const dealii::Point<3> &x) {
    return -std::cos(pi * x[0]) * std::cos(1.5 * pi * x[1]);
  };
  const Scene<3> waves = with_pressure(wave);
  const ExactPressure<3> exact(waves);
  const Box box(waves, 3, 2);
  const Pressure none(box.multipliers.n_multipliers());
  const double norm = std::sqrt(0.5 / std::sqrt(1. + 3.25 * pi * pi));
  const DualNormErrors all = exact.errors(box.multipliers, none);
  checks.near("-1/2 norm of cos(pi x) cos(3 pi y/2)", all.spectral, norm, 1e-9);
  checks.that("the double integral is not computed", !all.slobodeckij);
  const Pressure means(exact.project(box.multipliers));
  checks.near("R^H p", exact.errors(box.multipliers, means).superclose_spectral, 0., 1e-14);
  // sinc(pi H_x/2) sinc(3 pi H_y/4) at the centre of the patch.
  const double factor = std::sin(pi / 8.) / (pi / 8.) * std::sin(3. * pi / 8.) / (3. * pi / 8.);
  checks.near("its first value", means[0],
              factor * wave(box.surface.middle(box.surface.patches()[0]).x), 1e-6);
  double before = 0.;
  for (const unsigned int level : {4U, 5U}) {
    const Box refined(waves, level, 2);
    const double error =
      exact.errors(refined.multipliers, Pressure(exact.project(refined.multipliers))).spectral;
    if (level == 5)
      checks.between("order of p - R^H p", std::log2(before / error), 1.5, 1.7);
    before = error;
  }

  const Scene<3> slope =
    with_pressure([](const dealii::Point<3> &x) { return -(1. + x[0] + 3. * x[1]); });
  const Box linear(slope, 3, 2);
  const PressureErrors found = compute_pressure_errors(
    linear.multipliers, linear.at_centres([](const auto &s) { return -(1. + s[0] + 3. * s[1]); }),
    2);
  // H = 1/4 and 1/2; the variance of a linear function on a patch is slope² H²/12 per coordinate.
  checks.near("p - p_H in L2", found.l2, std::sqrt(2. * (1. / 16. + 9. / 4.) / 12.), 1e-13);
  checks.near("of the recovered pressure", found.post_l2, 0., 1e-13);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {recovery, transfer, unequal_patches, errors});
}
