// SPDX-License-Identifier: LGPL-2.1-or-later
// What becomes of a contact pressure on a rectangle: recovery, transfer, norms, errors.

#include <signorini/postprocessing/errors/dual_norm_errors.h>
#include <signorini/postprocessing/errors/errors.h>
#include <signorini/postprocessing/fields/forces.h>
#include <signorini/postprocessing/norms/spectral_norm.h>

#include <algorithm>

#include "box.h"
#include "tests.h"

using namespace Signorini;
using Vector = dealii::Vector<double>;

namespace
{
const auto nothing = field([](const dealii::Point<3> &) { return Vector3(); });
const auto zero = scalar([](const auto &) { return 0.; });
constexpr double pi = dealii::numbers::PI;

/** The values of a function at the centres of the patches: of a product of linear functions these
 * are the means. */
Pressure at_centres(const Box &box, const std::function<double(const dealii::Point<2> &)> &p)
{
  Pressure P(box.surface.patches().size());
  for (unsigned int tau = 0; tau < P.size(); ++tau)
    P[tau] = p(box.surface.patches()[tau].centre());
  return P;
}

/** The largest difference between the recovered pressure and a function at points of all patches,
 * on their edges, too. */
double recovery_error(const Box &box,
                      const Pressure &P,
                      const std::function<double(const dealii::Point<2> &)> &p)
{
  const RecoveredPressure<3> recovered(box.multipliers, P);
  double error = 0.;
  for (unsigned int tau = 0; tau < P.size(); ++tau)
  {
    const Patch<3> &patch = box.surface.patches()[tau];
    for (const double x : {0., 0.3, 0.5, 1.})
      for (const double y : {0., 0.6, 1.})
      {
        const dealii::Point<2> s(patch.lower[0] + x * (patch.upper[0] - patch.lower[0]),
                                 patch.lower[1] + y * (patch.upper[1] - patch.lower[1]));
        error = std::max(error, std::abs(recovered(tau, s) - p(s)));
      }
  }
  return error;
}

void recovery(Checks &checks)
{
  const Scene<3> scene = make_box_scene(zero, nothing, {1., 2., 1.});
  const auto bilinear = [](const dealii::Point<2> &s) {
    return -(4. + s[0] - 1.5 * s[1] + 0.5 * s[0] * s[1]);
  };
  for (const unsigned int ratio : {1U, 2U, 4U})
  {
    const Box box(scene, 3, ratio);
    const std::string name = "H = " + std::to_string(ratio) + " h: ";
    checks.near(name + "a bilinear pressure is recovered",
                recovery_error(box, at_centres(box, bilinear), bilinear),
                0.,
                1e-14);
  }
  const Box box(scene, 3, 2);
  const auto pulling = [](const dealii::Point<2> &s) { return s[0] - 0.75; };
  checks.near("nowhere positive, but the line goes on to zero",
              recovery_error(box,
                             at_centres(box, pulling),
                             [&](const dealii::Point<2> &s) { return std::min(0., pulling(s)); }),
              0.,
              1e-14);
  const Box single(scene, 1, 2);
  Pressure one(1);
  one[0] = -3.;
  checks.near("a single patch: a constant",
              recovery_error(single, one, [](const auto &) { return -3.; }),
              0.,
              0.);
}

void transfer(Checks &checks)
{
  const Scene<3> scene = make_box_scene(zero, nothing, {1., 2., 1.});
  const auto linear = [](const dealii::Point<2> &s) { return -(1. + s[0] + 2. * s[1]); };
  const Box fine(scene, 3, 2), coarse(scene, 2, 2), next(scene, 4, 2);
  const Pressure P = at_centres(fine, linear);
  const auto move = [](const Box &from, const Pressure &p, const Box &to) {
    return transfer_pressure<3>({from.surface.patches(), p}, to.surface.patches());
  };
  const auto distance = [](Pressure a, const Pressure &b) {
    a -= b;
    return a.linfty_norm();
  };
  checks.near("to the same patches", distance(move(fine, P, fine), P), 0., 1e-15);
  checks.near("a linear pressure to patches twice as long: its means",
              distance(move(fine, P, coarse), at_centres(coarse, linear)),
              0.,
              1e-14);
  checks.near(
    "to finer ones and back", distance(move(next, move(fine, P, next), fine), P), 0., 1e-14);
  checks.near(
    "force",
    summarise_contact(next.multipliers, move(coarse, move(fine, P, coarse), next)).normal_force,
    7.,
    1e-13);
}

/** Matrices of values are Q(p, q) for column p and row q. */
void norms(Checks &checks)
{
  const double a = 1.3, b = 0.7;
  const RectangleNorm norm(std::array<double, 2>{{a, b}});
  RectangleNorm::Matrix ones(6, 4);
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 4; ++j)
      ones(i, j) = 1.;
  checks.near("norm of one: the root of the area",
              norm.distance(RectangleNorm::Matrix(), ones),
              std::sqrt(a * b),
              1e-14);
  // What depends on one coordinate has the norm on the edge.
  RectangleNorm::Matrix across(6, 4), along(4, 6);
  Vector steps(6);
  std::vector<double> ends_a, ends_b;
  for (unsigned int i = 0; i < 7; ++i)
  {
    ends_a.push_back(a * i / 6.);
    ends_b.push_back(b * i / 6.);
  }
  for (unsigned int i = 0; i < 6; ++i)
  {
    steps[i] = std::sin(1. + 3. * i);
    for (unsigned int j = 0; j < 4; ++j)
      across(i, j) = along(j, i) = steps[i];
  }
  const SpectralNorm::Modes none(8193);
  checks.near("steps along the first edge",
              norm.distance(RectangleNorm::Matrix(), across) /
                (std::sqrt(b) * SpectralNorm(a).distance(none, ends_a, steps)),
              1.,
              1e-6);
  checks.near("steps along the second edge",
              norm.distance(RectangleNorm::Matrix(), along) /
                (std::sqrt(a) * SpectralNorm(b).distance(none, ends_b, steps)),
              1.,
              1e-6);
  // cos(pi s/a) less these steps, on the rectangle and on the edge.
  RectangleNorm::Matrix f(RectangleNorm::n_modes, RectangleNorm::n_modes);
  f(1, 0) = std::sqrt(0.5 * a * b);
  SpectralNorm::Modes f_on_edge(8193);
  f_on_edge[1] = std::sqrt(0.5 * a);
  checks.near("distance of steps from a cosine",
              norm.distance(f, across) /
                (std::sqrt(b) * SpectralNorm(a).distance(f_on_edge, ends_a, steps)),
              1.,
              1e-6);
  // Two by two patches with the same value are a patch.
  using Ends = std::array<std::vector<unsigned int>, 2>;
  const auto coarse = norm.gram_matrix(Ends{{{0, 1, 2, 3}, {0, 1, 2}}}),
             fine = norm.gram_matrix(Ends{{{0, 1, 2, 3, 4, 5, 6}, {0, 1, 2, 3, 4}}});
  auto by_cells = norm.gram_matrix(Ends{{{0, 2, 4, 6}, {0, 2, 4}}});
  by_cells.add(-1., coarse);
  double difference = 0., largest = 0.;
  for (unsigned int k = 0; k < 6; ++k)
    for (unsigned int l = 0; l < 6; ++l)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          sum += fine(2 * (k % 3) + i % 2 + 6 * (2 * (k / 3) + i / 2),
                      2 * (l % 3) + j % 2 + 6 * (2 * (l / 3) + j / 2));
      difference = std::max(difference, std::abs(sum - coarse(k, l)));
      largest = std::max(largest, std::abs(coarse(k, l)));
    }
  checks.near("Gram matrices of nested patches", difference / largest, 0., 1e-5);
  checks.near("of patches of two by two cells", by_cells.linfty_norm() / largest, 0., 1e-5);
  // Patches of 2, 2 and 3 cells.
  const PatchGrid uneven = {0, {{{0., 0.2, 0.4, 0.7}, {0., 0.2}}}, {2, 0, 1}};
  checks.that("unequal patches: cells",
              equal_cells(uneven)[0] == std::vector<unsigned int>({0, 2, 4, 7}));
  Vector P(3);
  P[0] = 5.;
  P[1] = 6.;
  P[2] = 4.;
  const auto values = values_on(uneven, P);
  checks.that("their values",
              values.m() == 7 && values.n() == 1 && values(1, 0) == 4. && values(2, 0) == 5. &&
                values(6, 0) == 6.);
}

/** A scene with the pressure p at the bottom of 1 x 2. */
Scene<3> with_pressure(const std::function<double(const dealii::Point<3> &)> &p)
{
  Scene<3> scene = make_box_scene(zero, nothing, {1., 2., 1.});
  scene.boundary[scene.geometry.find_side("bottom")].exact_pressure = scalar(p);
  return scene;
}

void errors(Checks &checks)
{
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
  const Patch<3> &first = box.surface.patches()[0];
  checks.near(
    "its first value", means[0], factor * wave({first.centre()[0], first.centre()[1], 0.}), 1e-6);
  double before = 0.;
  for (const unsigned int level : {4U, 5U})
  {
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
    linear.multipliers,
    at_centres(linear, [](const dealii::Point<2> &s) { return -(1. + s[0] + 3. * s[1]); }),
    2);
  // H = 1/4 and 1/2; the variance of a linear function on a patch is slope² H²/12 per coordinate.
  checks.near("p - p_H in L2", found.l2, std::sqrt(2. * (1. / 16. + 9. / 4.) / 12.), 1e-13);
  checks.near("of the recovered pressure", found.post_l2, 0., 1e-13);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  recovery(checks);
  transfer(checks);
  norms(checks);
  errors(checks);
  return checks.exit_code();
}
