// SPDX-License-Identifier: LGPL-2.1-or-later
// Reactions, penetration and von Mises stress of displacements that are known in closed form.

#include <signorini/discretization/space/linear_system.h>
#include <signorini/postprocessing/fields/nodal_forces.h>
#include <signorini/postprocessing/quantities/answer.h>

#include <cmath>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
using Vector2 = dealii::Tensor<1, 2>;

namespace {
/** lambda = mu = 1 in plane strain. */
const std::string material =
  "subsection Material\nset Young's modulus = 2.5\nset Poisson's ratio = 0.25\nend\n";

/** With the contact pressure p everywhere. */
NodalForces forces_of(const OneLevel &level, const Displacement &U, const double p) {
  const LinearSystem<2> system = assemble_linear_system(level.space(), level.scene, 3);
  Pressure P(level.multipliers().n_multipliers());
  P.add(p);
  return nodal_forces(level.body(U, P), system.loads, level.discretization.D);
}

const SideForce &on(const std::vector<SideForce> &forces, const std::string &side) {
  for (const SideForce &force : forces)
    if (force.side == side)
      return force;
  throw std::runtime_error("no force on " + side);
}

Vector2 vector_of(const AnswerVector &force) {
  return Vector2({force[0], force[1]});
}

/** u = (0.1 x, -0.2 y) on [0,2] x [0,1]: sigma = diag(-0.1 + 0.2, -0.1 - 0.4). */
void rollers(Checks &checks) {
  const OneLevel level(material + "subsection Geometry\nset Lower left = 0, 0\nset Upper right = "
                                  "2, 1\nset Cells = 4, 2\nend\n"
                                  "subsection Boundary\nset Rollers = left bottom\n"
                                  "set Traction = right: 0.1; 0\nset Contact = top\n"
                                  "end\nsubsection Contact\nset Gap = 1\nend\n",
                       1);
  const Displacement U = nodal_values(level.space(), [](const dealii::Point<2> &x) {
    return Vector2({0.1 * x[0], -0.2 * x[1]});
  });
  // The top is pulled by sigma n = (0, -0.5); for the balance it counts as contact pressure.
  const auto found = reactions(level.space(), level.scene, forces_of(level, U, -0.5));
  checks.that("two rollers", found.size() == 2);
  checks.near("left roller", vector_of(on(found, "left").resultant.force), Vector2({-0.1, 0.}),
              1e-14);
  checks.near("bottom roller", vector_of(on(found, "bottom").resultant.force), Vector2({0., 1.}),
              1e-14);
  checks.near("moment of the left one", on(found, "left").resultant.moment[0], 0.05, 1e-14);
  checks.near("moment of the bottom one", on(found, "bottom").resultant.moment[0], 1., 1e-14);
  checks.near("line of action", on(found, "bottom").through->distance(dealii::Point<2>(1., 0.)), 0.,
              1e-13);
}

/** Two rollers with an angle of 60 degrees between them. sigma = 0.4 I pulls at each side along its
 * normal, so that all nodes are in balance. */
void inclined_rollers(Checks &checks) {
  const OneLevel level(material + "subsection Geometry\nset Shape = polygon\n"
                                  "set Vertices = 0,0; 2,0; 2,1; 0.57735026918962573,1\nend\n"
                                  "subsection Boundary\nset Rollers = side0 side3\n"
                                  "set Traction = side1: 0.4; 0\nset Contact = side2\n"
                                  "end\nsubsection Contact\nset Gap = 1\nend\n",
                       1);
  const Displacement U = nodal_values(level.space(), [](const dealii::Point<2> &x) {
    return Vector2({0.1 * x[0], 0.1 * x[1]});
  });
  const auto found = reactions(level.space(), level.scene, forces_of(level, U, 0.4));
  checks.that("two inclined rollers", found.size() == 2);
  checks.near("below", vector_of(on(found, "side0").resultant.force), Vector2({0., -0.8}), 1e-14);
  // Its length is 2/3^{1/2}, its normal (-3^{1/2}/2, 1/2).
  checks.near("inclined", vector_of(on(found, "side3").resultant.force),
              Vector2({-0.4, 0.4 / std::sqrt(3.)}), 1e-14);
}

/** Uniform stress between sides that hold all components: the corner is shared. */
void held_sides(Checks &checks) {
  for (const unsigned int cells : {8U, 16U}) {
    const OneLevel level(
      material + entry("Geometry", "Cells", std::to_string(cells) + ", " + std::to_string(cells)) +
        "subsection Boundary\nset Displacement = left: 0.1*x; 0 | top: 0.1*x; 0 | right: 0.1*x; 0\n"
        "set Contact = bottom\nend\nsubsection Contact\nset Gap = 1\nend\n",
      0);
    const Displacement U = nodal_values(level.space(), [](const dealii::Point<2> &x) {
      return Vector2({0.1 * x[0], 0.});
    });
    // sigma = diag(0.3, 0.1).
    const auto found = reactions(level.space(), level.scene, forces_of(level, U, 0.1));
    const double h = 1. / cells;
    const std::string name = std::to_string(cells) + " cells: ";
    Vector2 sum;
    for (const SideForce &force : found)
      sum += vector_of(force.resultant.force);
    checks.near(name + "all together", sum, Vector2({0., 0.1}), 1e-14);
    checks.near(name + "right side", vector_of(on(found, "right").resultant.force),
                Vector2({0.3, 0.}), 0.2 * h);
    checks.near(name + "top side", vector_of(on(found, "top").resultant.force), Vector2({0., 0.1}),
                0.2 * h);
  }
}

void penetration(Checks &checks) {
  const OneLevel level("Geometry/Cells = 2, 2\n"
                       "subsection Boundary\nset Clamped = top\nset Contact = bottom\n"
                       "end\nsubsection Contact\nset Gap = 0.01 + (x - 0.28125)^2\nend\n",
                       0);
  // u_n = -u_2 = 0.05 (1 - y): the deepest point is a sample between the nodes.
  const Displacement U = nodal_values(level.space(), [](const dealii::Point<2> &x) {
    return Vector2({0., -0.05 * (1. - x[1])});
  });
  const auto found = max_penetration(level.body(U), level.discretization.surface);
  checks.near("penetration", found->value, 0.04, 1e-15);
  checks.near("its place", found->at.point.distance({0.28125, 0.}), 0., 1e-14);
  const Displacement lifted = nodal_values(level.space(), [](const dealii::Point<2> &) {
    return Vector2({0., 0.5});
  });
  checks.near("an opening is negative",
              max_penetration(level.body(lifted), level.discretization.surface)->value, -0.51,
              1e-15);
}

void von_mises_stress(Checks &checks) {
  const std::string square = "subsection Boundary\nset Clamped = top\nset Contact = bottom\n"
                             "end\nsubsection Contact\nset Gap = 1\nend\n";
  const auto linear = [](const dealii::Point<2> &x) { return Vector2({0.1 * x[0], -0.2 * x[1]}); };
  for (const std::string element : {"Q1", "Q1 B-bar"}) {
    const OneLevel strain(material + square + entry("Discretization", "Element", element), 2);
    // sigma = (0.1, -0.5, -0.1): sqrt(((0.6)² + (0.4)² + (0.2)²)/2).
    const VonMises found = largest_von_mises(strain.body(nodal_values(strain.space(), linear)));
    checks.near("plane strain, " + element, found.value, std::sqrt(0.28), 1e-13);
    // The principal strains are 0.1 and -0.2.
    checks.near("strained share, " + element, found.strained_share, 1., 0.);
  }
  const OneLevel stress(
    "subsection Material\nset Young's modulus = 3.75\nset Poisson's ratio = 0.25\n"
    "set Plane state = stress\nend\n" +
      square,
    2);
  // E/(1 - nu²) = 4: sigma = (4 (0.1 - 0.05), 4 (-0.2 + 0.025), 0).
  checks.near("plane stress",
              largest_von_mises(stress.body(nodal_values(stress.space(), linear))).value,
              std::sqrt(0.67), 1e-13);
  // A uniform pressure on two materials: nodes of the interface belong to both.
  for (const std::string jump : {"y<=0.5", "y<0.5", "y>0.5", "y>=0.5"}) {
    const bool soft_below = jump[1] == '>';
    const OneLevel layers(square + entry("Material", "Young's modulus", jump + " ? 1000 : 1") +
                            entry("Material", "Poisson's ratio", "0"),
                          2);
    const double below = soft_below ? 1. : 1e-3, above = soft_below ? 1e-3 : 1.;
    const VonMises uniform =
      largest_von_mises(layers.body(nodal_values(layers.space(), [&](const dealii::Point<2> &x) {
        return Vector2(
          {0., -0.01 * (below * std::min(x[1], 0.5) + above * std::max(x[1] - 0.5, 0.))});
      })));
    checks.near("two materials, " + jump, uniform.value, 0.01, 1e-12);
  }
  // u = (0, x² / 2): sigma_12 = x, largest at the right, where the lowest point comes first.
  const OneLevel bending(material + square, 2);
  const VonMises found =
    largest_von_mises(bending.body(nodal_values(bending.space(), [](const dealii::Point<2> &x) {
      return Vector2({0., 0.5 * x[0] * x[0]});
    })));
  checks.near("quadratic displacement", found.value, std::sqrt(3.), 1e-13);
  checks.near("its place", found.point.distance({1., 0.}), 0., 1e-13);
  // x/2 is above 0.1 behind x = 0.2, in three of four columns of cells.
  checks.near("half of the shear is a principal strain", found.strained_share, 0.75, 1e-13);
  checks.near("half of it is a rotation", found.turned_share, 0.75, 1e-13);
  const VonMises turned =
    largest_von_mises(bending.body(nodal_values(bending.space(), [](const dealii::Point<2> &x) {
      return Vector2({-0.11 * x[1], 0.11 * x[0]});
    })));
  checks.near("a rotation", turned.turned_share, 1., 0.);
  checks.near("strains nothing", turned.strained_share + turned.value, 0., 1e-13);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {rollers, inclined_rollers, held_sides, penetration, von_mises_stress});
}
