// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides in several pairs: which contacts there are, on which parts of sides they lie, and their
// data.

#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/contact_pair.h>

#include <cmath>
#include <map>

#include "scene_text.h"
#include "tests.h"

using namespace Signorini;

namespace {
constexpr double PI = dealii::numbers::PI;

Scene<2> scene_with(const std::string &text) {
  return make_described_scene<2>(parse_parameters(parameter_file(text), "test", {}));
}

/** Returns the names of the contacts of a scene with the parts on which they lie. */
std::map<std::string, std::pair<double, double>> parts_of(const Scene<2> &scene) {
  std::map<std::string, std::pair<double, double>> parts;
  for (const ContactPair<2> &pair : contact_pairs(scene))
    parts[pair.name()] = {pair.data().from, pair.data().to};
  return parts;
}

/** Discs of radius 1 on the plate -5 < x < 5 with the top y = 0, at the given x. */
std::string discs_on_plate(const std::vector<double> &x, const std::string &contact) {
  std::string names = "plate", centres, separator;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::string name = "d" + std::to_string(i);
    names += " " + name;
    centres += separator + name + ": " + std::to_string(x[i]) + ", 1";
    separator = " | ";
  }
  return "Geometry/Bodies = " + names + "\nGeometry/Shape = plate: rectangle" +
         [&]() {
           std::string shapes;
           for (std::size_t i = 0; i < x.size(); ++i)
             shapes += " | d" + std::to_string(i) + ": disc";
           return shapes;
         }() +
         "\nGeometry/Lower left = plate: -5, -2\nGeometry/Upper right = plate: 5, 0\n"
         "Geometry/Centre = " +
         centres + "\nBoundary/Clamped = plate.bottom\nBoundary/Contact = " + contact + "\n";
}

/** Discs beside each other: normals that turn by 60 degrees, and between neighbours the middle. */
void test_beside(Checks &checks) {
  const double reach = std::sqrt(0.75);
  for (const char *const contact : {"plate.top with d0.arc d1.arc", "plate.top with *"}) {
    checks.about(contact);
    const auto apart = parts_of(scene_with(discs_on_plate({-2., 2.}, contact)));
    checks.that("two contacts", apart.size() == 2);
    const auto &[from, to] = apart.at("plate.top with d1.arc");
    const Scene<2> scene = scene_with(discs_on_plate({-2., 2.}, contact));
    const Side<2> &top = scene.geometry.sides[scene.geometry.find_side("plate.top")];
    checks.near("its part",
                {std::min(top.point(from)[0], top.point(to)[0]),
                 std::max(top.point(from)[0], top.point(to)[0])},
                {2. - reach, 2. + reach}, 1e-9);
  }
  // From the discs lines reach farther: tan(60 degrees) of the height 1; at 2.2 they meet at 1.1.
  const Scene<2> near =
    scene_with(discs_on_plate({0., 2.2}, "d0.arc with plate.top | d1.arc with plate.top"));
  for (const ContactPair<2> &pair : contact_pairs(near)) {
    const Side<2> &arc = near.geometry.sides[pair.side()];
    const double x = pair.side() == near.geometry.find_side("d0.arc") ? 0. : 2.2,
                 left = arc.point(pair.data().from)[0] - x,
                 right = arc.point(pair.data().to)[0] - x, middle = 1.1 / std::hypot(1.1, 1.);
    const bool is_first = x == 0.;
    checks.near("ends at the middle between the discs", is_first ? right : left,
                is_first ? middle : -middle, 1e-9);
    checks.near("its other end", is_first ? left : right, is_first ? -reach : reach, 1e-9);
  }
}

/** Two discs: the far side of one does not face the other, though its line meets it behind. */
void test_discs(Checks &checks) {
  const Scene<2> scene =
    scene_with("Geometry/Bodies = a b\nGeometry/Shape = disc\nGeometry/Centre = a: 0, 0 | b: 2, 0\n"
               "Boundary/Contact = a.arc with b.arc\nContact/Gap = -0.001\n");
  const ContactCondition<2> &contact = scene.contacts.at(0);
  checks.between("the half towards the other disc", contact.to - contact.from, 0.1, PI);
  checks.near("around (1, 0)", scene.geometry.sides[0].point(0.5 * (contact.from + contact.to))[0],
              1., 1e-9);
}

/** A bearing whose rollers are discs: each has two contacts, opposite to each other. */
void test_bearing(Checks &checks) {
  const std::string rings =
    "Geometry/Bodies = inner outer a b c\nGeometry/Shape = inner: ring | outer: ring | a: disc | "
    "b: "
    "disc | c: disc\nGeometry/Radius = inner: 4 | outer: 8 | a: 1 | b: 1 | c: 1\n"
    "Geometry/Inner radius = inner: 2 | outer: 6\nGeometry/Centre = inner: 0, 0 | outer: 0, 0 | "
    "a: 0, -5 | b: 5*cos(pi/6), 2.5 | c: -5*cos(pi/6), 2.5\nBoundary/Clamped = outer.outer\n";
  for (const char *const contact :
       {"inner.outer with a.arc b.arc c.arc | outer.inner with a.arc b.arc c.arc",
        "a.arc with inner.outer outer.inner | b.arc with inner.outer outer.inner | c.arc with "
        "outer.inner inner.outer"}) {
    const Scene<2> scene = scene_with(rings + "Boundary/Contact = " + contact +
                                      "\nBoundary/Displacement = inner.inner: "
                                      "0; -0.01\n");
    checks.that("six contacts", scene.contacts.size() == 6);
    for (const ContactPair<2> &pair : contact_pairs(scene)) {
      const Side<2> &first = scene.geometry.sides[pair.side()];
      const dealii::Point<2> middle = first.point(0.5 * (pair.data().from + pair.data().to));
      checks.about(pair.name());
      checks.near("its middle touches", pair.gap(middle), 0., 1e-9);
      checks.near("  at a race",
                  std::min(std::abs(middle.norm() - 4.), std::abs(middle.norm() - 6.)), 0., 1e-9);
    }
  }
}

/** Partners of '*': not those behind others, nor with another role, nor of the same body. */
void test_star(Checks &checks) {
  const std::string bodies =
    "Geometry/Bodies = table foot lid\nGeometry/Shape = table: rectangle | foot: polygon | lid: "
    "rectangle\nGeometry/Lower left = table: -2, -1 | lid: -0.4, 1\n"
    "Geometry/Upper right = table: 2, 0 | lid: 0.4, 2\n"
    "Geometry/Vertices = foot: -0.5,0 fillet 0.2; 0.5,0 fillet 0.2; 0.5,1; -0.5,1\n"
    "Boundary/Clamped = table.bottom\n";
  const auto all = parts_of(scene_with(bodies + "Boundary/Contact = table.top with *\n"));
  checks.that("a foot with fillets", all.size() == 3 &&
                                       all.count("table.top with foot.fillet0") == 1 &&
                                       all.count("table.top with foot.side0") == 1 &&
                                       all.count("table.top with foot.fillet1") == 1);
  const auto some = parts_of(scene_with(
    bodies + "Boundary/Contact = table.top with *\nBoundary/Traction = foot.fillet1: 0; 0\n"));
  checks.that("without a side with another role", some.size() == 2);
}

/** Data by pair: by the side for all, or for each. */
void test_data(Checks &checks) {
  const std::string contact = "plate.top with d0.arc d1.arc";
  const auto gaps = [&](const std::string &given) {
    const Scene<2> scene =
      scene_with(discs_on_plate({-2., 2.}, contact) + "Contact/Gap = " + given + "\n");
    std::map<std::string, double> found;
    for (const ContactPair<2> &pair : contact_pairs(scene))
      found[pair.other_name()] = pair.gap({pair.other_name() == "d0.arc" ? -2. : 2., 0.});
    return std::vector<double>{found.at("d0.arc"), found.at("d1.arc")};
  };
  checks.near("one for all", gaps("-0.1"), {-0.1, -0.1}, 1e-12);
  checks.near("one for a side", gaps("plate.top: -0.1"), {-0.1, -0.1}, 1e-12);
  checks.near("one for each", gaps("plate.top with d0.arc: -0.1 | plate.top with d1.arc: x - 2.2"),
              {-0.1, -0.2}, 1e-12);
  checks.near("nothing for one", gaps("plate.top with d0.arc: -0.1"), {-0.1, 0.}, 1e-12);
}
} // namespace

int main() {
  return run_tests({test_beside, test_discs, test_bearing, test_star, test_data});
}
