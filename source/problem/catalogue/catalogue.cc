// SPDX-License-Identifier: LGPL-2.1-or-later
// The list of scenes known by name; D3 and V3, the scenes in 3-D.

#include <signorini/problem/catalogue/catalogue.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "catalogue_scenes.h"
#include "manufactured.h"

namespace Signorini {
namespace {
/** The centre of the disc and its radius, which coincide with lines of no mesh. */
const double xc = 0.5707106781186547, yc = 0.4422649730810374, radius_of_d3 = 1. / numbers::E;

/** Returns W = (1 - r²/s²)_+ with the distance r from the axis of the disc. */
Jet<3> bump(const Jet<3> &x, const Jet<3> &y) {
  const Jet<3> dx = x - xc, dy = y - yc;
  return positive_part(1. - (dx * dx + dy * dy) / (radius_of_d3 * radius_of_d3));
}

/** Returns a = -0.05 (1 + x (1-x) + y (1-y)). */
Jet<3> foundation(const Jet<3> &x, const Jet<3> &y) {
  return -0.05 * (1. + x * (1. - x) + y * (1. - y));
}

/**
 * Returns smooth contact on a disc of the lower side of the unit cube, clamped at z = 1:
 *
 *     u = (-a_x B, -a_y B, a A + b B),   A = (1-z)² (1+2z),   B = z (1-z)²,   b = -0.3 W³.
 *
 * On z = 0: u = (0, 0, a) and sigma_3. = (0, 0, (lambda + 2 mu) b), so that p = (lambda + 2 mu) b
 * and u_n = -a, which is the gap where p < 0.
 */
Scene<3> contact_on_disc(const std::string &modulus, const VectorField<3> &log_gradient) {
  const auto material = isotropic<3>(modulus, "0.3");
  Scene<3> scene = contact_scene<3>(
    make_box({0., 0., 0.}, {1., 1., 1.}, {1, 1, 1}), material, "top", "bottom",
    [](const Point<3> &x) {
      const double beyond = std::max(0., std::hypot(x[0] - xc, x[1] - yc) - radius_of_d3);
      return -foundation(x[0], x[1]).value + 0.5 * beyond * beyond;
    },
    [material](const Point<3> &x) {
      return -0.3 * material->hooke(x)[2][2][2][2] * cube(bump(x[0], x[1])).value;
    });
  set_exact_solution<3>(
    scene,
    [](const std::array<Jet<3>, 3> &at) {
      const Jet<3> &x = at[0], &y = at[1], &z = at[2];
      const Jet<3> a_x = -0.05 * (1. - 2. * x), a_y = -0.05 * (1. - 2. * y);
      const Jet<3> A = (1. - z) * (1. - z) * (1. + 2. * z), B = z * (1. - z) * (1. - z);
      const Jet<3> b = -0.3 * cube(bump(x, y));
      return std::array<Jet<3>, 3>{-a_x * B, -a_y * B, foundation(x, y) * A + b * B};
    },
    log_gradient);
  return scene;
}

const std::string cube_on_disc =
  "Boundary  clamped at z = 1, contact at z = 0, traction sigma(u) n on the upright sides\n"
  "Load      body force -div sigma(u)\n"
  "Gap       -a + (r-s)_+^2/2, a = -0.05 (1 + x (1-x) + y (1-y)), s = 1/e,\n"
  "          r the distance from (0.5707106781186547, 0.4422649730810374)\n"
  "Exact u   (-a_x B, -a_y B, a A + b B), A = (1-z)^2 (1+2z), B = z (1-z)^2,\n"
  "          b = -0.3 (1 - r^2/s^2)_+^3\n";
} // namespace

template <>
const std::vector<CatalogueEntry<2>> &catalogue() {
  static const std::vector<CatalogueEntry<2>> sorted = []() {
    std::vector<CatalogueEntry<2>> entries = square_scenes();
    for (const auto &more : {westergaard_scenes(), round_scenes(), friction_scenes()})
      entries.insert(entries.end(), more.begin(), more.end());
    std::sort(entries.begin(), entries.end(),
              [](const auto &a, const auto &b) { return a.name < b.name; });
    return entries;
  }();
  return sorted;
}

template <>
const std::vector<CatalogueEntry<3>> &catalogue() {
  static const std::vector<CatalogueEntry<3>> entries = {
    {"D3", "in 3-D: smooth contact on a disc, exact solution known",
     "Body      the unit cube\n"
     "Material  E = 1, nu = 0.3\n" +
       cube_on_disc + "Exact p   (lambda + 2 mu) b\n",
     []() { return contact_on_disc("1", {}); }},
    {"V3", "in 3-D: the contact of D3 with a material that varies in space",
     "Body      the unit cube\n"
     "Material  E = 1 + x/2 + y z, nu = 0.3\n" +
       cube_on_disc + "Exact p   (lambda + 2 mu) b with lambda and mu at the point\n",
     []() {
       return contact_on_disc("1 + x/2 + y*z", [](const Point<3> &x) {
         return Tensor<1, 3>({0.5, x[2], x[1]}) / (1. + 0.5 * x[0] + x[1] * x[2]);
       });
     }}};
  return entries;
}

std::string describe_catalogue() {
  std::ostringstream text;
  text << std::left << std::setw(20) << "described"
       << "everything by the expressions of the parameter file\n";
  const auto list = [&](const auto &entries) {
    for (const auto &entry : entries)
      text << std::setw(20) << entry.name << entry.title << "\n";
  };
  list(catalogue<2>());
  list(catalogue<3>());
  return text.str();
}
} // namespace Signorini
