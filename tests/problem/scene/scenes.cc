// SPDX-License-Identifier: LGPL-2.1-or-later
// Catalogue scenes and materials against numbers found elsewhere.

#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/strain.h>
#include <signorini/verification/catalogue/catalogue.h>

#include <cmath>

#include "contact_of.h"
#include "tests.h"

using namespace Signorini;

namespace {
using Point = dealii::Point<2>;
using Strain = dealii::SymmetricTensor<2, 2>;

const double xi = std::sqrt(0.5);

Scene<2> scene(const std::vector<std::string> &settings) {
  return make_scene<2>(parse_parameters("", "scenes.prm", settings), named_scenes());
}

const BoundaryCondition<2> &condition(const Scene<2> &scene, const std::string &side) {
  return scene.boundary.at(scene.geometry.find_side(side));
}

Strain tensor(const double e11, const double e22, const double e12) {
  Strain e;
  e[0][0] = e11;
  e[1][1] = e22;
  e[0][1] = e12;
  return e;
}

/** Where contact may end; the data are checked in catalogue.cc. */
void test_kinks(Checks &checks) {
  const Scene<2> a1 = scene({"Scene/Name=A1", "Discretization/Kinks at y=0.25"});
  const std::vector<KinkLine<2>> &lines = a1.kinks.lines();
  checks.that("A1 kinks and those of the parameters",
              lines.size() == 2 && std::abs(lines[0].position - xi) < 1e-15 &&
                lines[0].normal[0] == 1. && lines[1].position == 0.25 && lines[1].normal[1] == 1.);
  checks.that("A1 contact may end where a kink meets its side",
              a1.kinks.ends().size() == 1 && a1.kinks.ends()[0].distance(Point(xi, 0.)) < 1e-15);
}

void test_catalogue(Checks &checks) {
  const Scene<2> d1 = scene({"Scene/Name=D1"}), block = scene({"Scene/Name=block on parabola"});
  const Point x(0.3, 0.4), left(-0.6, 0.);
  checks.near("D1 p and g, block gap and displacement",
              {contact_of(d1, "bottom").exact_pressure->value(x),
               contact_of(d1, "bottom").gap->value(x), contact_of(block, "bottom").gap->value(left),
               condition(block, "top").data->value(x, 0),
               condition(block, "top").data->value(x, 1)},
              {-0.375, -0.125, 0.09, 0., -0.05}, 1e-16);
  checks.that("block is not known exactly",
              block.exact_displacement == nullptr && !block.has_exact_pressure());
  for (const CatalogueEntry<2> &entry : catalogue<2>()) {
    checks.about(entry.name);
    const Scene<2> found = scene({"Scene/Name=" + entry.name});
    checks.that("listed under its name",
                found.name == entry.name && found.title == entry.title &&
                  describe_catalogue().find(entry.name) != std::string::npos);
    for (const char *key : {"Body ", "Material ", "Boundary ", "Load ", "Gap ", "Exact u "})
      checks.that("described", found.description.find(key) != std::string::npos);
    checks.that("with p if that is known", (found.description.find("Exact p ") !=
                                            std::string::npos) == found.has_exact_pressure());
  }
}

/** Tests in tests/driver solve described scenes with exact solutions. */
void test_described(Checks &checks) {
  const Scene<2> sides = scene({"Boundary/Clamped=top", "Boundary/Contact=bottom, left",
                                "Contact/Gap=left: y>0.5||y<0.1 ? 1 : 2 | bottom: x^2",
                                "Exact solution/Pressure=x>0.5 ? 0 : -1"});
  checks.near("two gaps, one pressure for both",
              {contact_of(sides, "left").gap->value(Point(0., 0.3)),
               contact_of(sides, "bottom").gap->value(Point(0.3, 0.)),
               contact_of(sides, "left").exact_pressure->value(Point(0., 0.5)),
               contact_of(sides, "bottom").exact_pressure->value(Point(0.7, 0.))},
              {2., 0.09, -1., 0.}, 1e-16);
  checks.that("two contact sides", sides.contacts.size() == 2 && sides.contacts[0].side == 0 &&
                                     sides.contacts[1].side == 2 && sides.body_force == nullptr);
}

/** Stresses of known strains, worked out by hand; sigma_33 where it is given. */
void test_materials(Checks &checks) {
  struct Row {
    std::string settings;
    Point x;
    Strain strain, stress;
    bool is_constant;
    double across;
  };
  const Strain e = tensor(0.1, 0.2, 0.3), large = tensor(1., 2., 3.);
  const std::string orthotropic = "set Law = orthotropic\nset Orthotropic moduli = 4; 1.2; 0.5; "
                                  "0.6\nset Moduli across the plane = 0.7; 0.2\n",
                    turned = orthotropic + "set Orientation = 30\n";
  // C of moduli turned by 30 degrees, and strains along its axes.
  const double c = std::sqrt(0.75), s = 0.5, C16 = 0.8010734985006054, C26 = 0.4113620667976081;
  const Strain first = tensor(c * c, s * s, s * c), second = tensor(s * s, c * c, -s * c);
  for (const Row &row : std::vector<Row>{
         {"set Young's modulus = 2.5\nset Poisson's ratio = 0.25\n",
          {},
          e,
          tensor(0.5, 0.7, 0.6),
          true,
          0.3},
         {"set Plane state = stress\n",
          {},
          e,
          tensor(0.16 / 0.91, 0.23 / 0.91, 0.3 / 1.3),
          true,
          0.},
         {"set Young's modulus = 1+x\nset Poisson's ratio = 0.25*(1-y)\n",
          {0.5, 1.},
          e,
          tensor(0.15, 0.3, 0.45),
          false,
          0.},
         {turned, {}, tensor(1., 0., 0.), tensor(2.9625, 0.8375, C16), true, 0.575},
         {turned, {}, tensor(0., 1., 0.), tensor(0.8375, 1.5625, C26), true, 0.325},
         {turned, {}, tensor(0., 0., 1.), tensor(2. * C16, 2. * C26, 1.875), true, c / 2.},
         {turned, {}, first, 4. * first + 0.5 * second, true, 0.7},
         {turned, {}, second, 0.5 * first + 1.2 * second, true, 0.2},
         {orthotropic + "set Orientation = 90\n", {}, large, tensor(2.2, 8.5, 3.6), true, 1.6},
         {"set Law = general\nset Hooke tensor = 3+x; 1; 0.1; 4; 0.2; 1\nset Moduli across the "
          "plane = 0.5; 0.25+y; 0.1\n",
          {1., 0.},
          large,
          tensor(6.6, 10.2, 6.5),
          false,
          1.6}}) {
    checks.about(row.settings);
    const auto material =
      make_scene<2>(parse_parameters("subsection Material\n" + row.settings + "end\n", "test",
                                     {"Boundary/Clamped=top", "Boundary/Contact=bottom"}))
        .material;
    checks.near("stress", material->hooke(row.x) * row.strain, row.stress, 1e-14);
    const HookesLaw<2> law = {material->hooke(row.x), material->across(row.x)};
    checks.near("across the plane", law.stress_across({row.strain}), row.across, 1e-14);
    checks.that("is_constant", material->is_constant() == row.is_constant);
  }
}

/** "none" stands above the coefficient that the file gives, where it is said. */
void test_friction(Checks &checks) {
  const std::vector<std::string> settings = {
    "Boundary/Clamped=top", "Boundary/Contact=bottom", "Contact/Friction=Coulomb",
    "Contact/Friction coefficient=0.3", "Contact/Foundation shift=0.01"};
  std::vector<std::string> without = settings;
  without.emplace_back("Contact/Friction=none");
  checks.that("a capital", scene(settings).contact_law.name() == "coulomb");
  checks.that("none overrides", !scene(without).contact_law.has_tangential_part() &&
                                  scene(without).contacts[0].coefficient == nullptr);
}
} // namespace

int main() {
  return run_tests({test_kinks, test_catalogue, test_described, test_materials, test_friction});
}
