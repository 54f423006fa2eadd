// SPDX-License-Identifier: LGPL-2.1-or-later
// Energies that are known lie in the brackets, and the bound is exact where it must be: patch
// tests, and twice the sum of the two energies where nothing touches.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/discretization/space/nodes.h>
#include <signorini/error_control/equilibration/law.h>
#include <signorini/error_control/reference/hidden_load.h>

#include <deal.II/base/function_lib.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "bounded.h"
#include "error_control/hp/graded.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
using Scenes = std::vector<std::pair<std::string, std::string>>;

/** sigma(u_h) = sigma(u) is in equilibrium. D1: lambda = mu = 1, eps = 1/8, J = 3/2 eps². */
void patch_tests(Checks &checks) {
  const std::string oblique =
    "Geometry/Shape = polygon\nGeometry/Vertices = 0,0; 2,0; 2.5,1; -0.5,1\n"
    "Material/Young's modulus = 8\nMaterial/Poisson's ratio = 0\nContact/Gap = 0\n"
    "Boundary/Displacement = side2: 0; -1/8\nBoundary/Contact = side0\n"
    "Boundary/Traction = side1: 0; 0.5/sqrt(1.25) | side3: 0; 0.5/sqrt(1.25)\n";
  // The area is 2.5, sigma_22 = -1; the tractions do the work -1/32 on each side.
  for (const auto &[text, energy] :
       {std::pair(named_scene("D1"), 1.5 / 64.), std::pair(oblique, 2.5 / 16. + 1. / 16.)})
    for (const unsigned int number : {2U, 3U}) {
      const ErrorBound bound = Bounded(text, number).bound;
      checks.about("patch test, J = " + std::to_string(energy));
      // The roots of the rounding of energies, and of the contact part.
      checks.near("bound", *bound.absolute, 0., 2e-7);
      checks.near("stress", *bound.mesh, 0., 2e-7);
      checks.near("energy, from below", *bound.energy_lower, energy, 1e-13);
      checks.near("energy, from above", *bound.energy_upper, energy, 1e-13);
    }
}

/** J(u_h) + J*(tau) = 1/2 bound² if nothing touches and all loads are balanced exactly. */
void energies(Checks &checks) {
  const std::string far = "Contact/Gap = 100\nLoad/Body force = 0.1+x-2*y; -0.5*x+0.3*y\n";
  const std::string rectangle =
    far + "Boundary/Displacement = top: 0.01; -0.02*x\n"
          "Boundary/Contact = bottom\nBoundary/Traction = right: 0.1; 0.2*y\n";
  const Scenes scenes = {
    {"rectangles", rectangle},
    {"orthotropic", rectangle +
                      "Material/Law = orthotropic\nMaterial/Orthotropic moduli = 10; 1; 0.4; 0.7\n"
                      "Material/Orientation = 30\n"},
    {"rotated squares", far +
                          "Geometry/Shape = polygon\nGeometry/Vertices = 0,0; 1,1; 0,2; -1,1\n"
                          "Boundary/Displacement = side1: 0.01; -0.02*x\nBoundary/Contact = side0\n"
                          "Boundary/Traction = side2: 0.1; 0.2*y\n"}};
  for (const auto &[name, text] : scenes) {
    const Bounded level(text, 3);
    const double J = level.solution.record.certificate.energy,
                 half = 0.5 * std::pow(*level.bound.absolute, 2);
    checks.about(name);
    checks.near("energies", J - *level.bound.energy_lower, half,
                1e-10 * half + 1e-13 * std::abs(J));
    checks.near("no oscillation", *level.bound.oscillation, 0., 1e-10);
    checks.near("the loads are balanced", *level.bound.algebra, 0., 1e-11);
  }
}

/** Long bodies bend most where stresses change least. Pure bending, ν = 0: J(u) = -L/24. */
void slender(Checks &checks) {
  for (const auto &[length, cells, number] :
       {std::tuple(30, "30, 1", 3U), std::tuple(30, "5, 1", 3U), std::tuple(100, "100, 1", 2U)}) {
    const Bounded level("Geometry/Upper right = " + std::to_string(length) +
                          ", 1\nGeometry/Cells = " + cells +
                          "\nMaterial/Young's modulus = 1\nMaterial/Poisson's ratio = 0\n"
                          "Boundary/Clamped = left\nBoundary/Contact = bottom\n"
                          "Boundary/Traction = right: y-0.5; 0\nContact/Gap = 1e7\n",
                        number);
    const double error = std::sqrt(2. * level.solution.record.certificate.energy + length / 12.);
    checks.about("slender, " + std::string(cells) + " cells");
    checks.that("there is a bound", level.bound.absolute.has_value());
    checks.between("bound / error", level.bound.absolute.value_or(0.) / error, 1. - 1e-6, 1.04);
    checks.between("lack of balance", level.bound.algebra.value_or(1.), 0., 1e-12);
  }
}

void prescribed(Checks &checks) {
  double last_lift = 0.;
  for (const unsigned int number : {2U, 3U, 4U, 5U}) {
    const ErrorBound bound = Bounded(prescribed_parabola, number).bound;
    checks.between("prescribed: energy", 0.04 / 3., *bound.energy_lower - 1e-15,
                   *bound.energy_upper + 1e-15);
    if (last_lift > 0.)
      checks.near("lift of the order 3/2", last_lift / *bound.oscillation, std::sqrt(8.), 0.01);
    last_lift = *bound.oscillation;
  }
}

/** There are brackets, and one number lies in those of all levels. */
void brackets(Checks &checks) {
  const Scenes scenes = {
    // p_H jumps inside of faces where g and u_h are linear.
    {"inclined plane", "Boundary/Contact = bottom\nBoundary/Displacement = top: 0; -0.05 - 0.02*x\n"
                       "Contact/Gap = 0.1*x - 0.03\nDiscretization/Patches = 3\n"},
    {"plate that turns",
     "Boundary/Contact = bottom\nBoundary/Plates = top: -0.1, 1 turning\n"
     "Load/Plate force = top: -0.05\nContact/Gap = 0.1*x\nDiscretization/Patches = 3\n"},
    // Pins hold the body while A is solved; nothing holds its contact nodes.
    {"in a corner", "Boundary/Contact = bottom left\nLoad/Body force = -0.02; -0.05\n"
                    "Contact/Gap = bottom: 0.001*x | left: 0.002*y\n"},
    {"in a box", "Boundary/Contact = bottom left right top\nLoad/Body force = 0.02*x; -0.05\n"
                 "Contact/Gap = bottom: 0.001*x | left: -0.002 | right: -0.003 | top: -0.01\n"}};
  for (const auto &[name, text] : scenes) {
    double lower = -1e300, upper = 1e300;
    for (const unsigned int number : {1U, 2U, 3U, 4U}) {
      const ErrorBound bound = Bounded(text, number).bound;
      lower = std::max(lower, bound.energy_lower.value_or(1e300));
      upper = std::min(upper, bound.energy_upper.value_or(-1e300));
    }
    checks.that(name + ": brackets meet", lower <= upper);
  }
}

/** Of a body force that jumps on a parabola: the error of the rules of cells is enclosed. */
void hidden_load(Checks &checks) {
  const double below = -0.1653, above = -0.1869, low = 0.3374, end = std::sqrt(1. - low);
  const OneLevel level("Boundary/Clamped = top\nBoundary/Contact = bottom\nContact/Gap = 1\n"
                       "Load/Body force = 0; y-x^2<0.3374 ? -0.1653 : -0.1869\n",
                       3);
  const double area = low * end + std::pow(end, 3) / 3. + 1. - end;
  double error = -(below * area + above * (1. - area));
  const Displacement U =
    interpolate_at_nodes<2>(level.space(), Functions::ConstantFunction<2>(0.3, 2));
  for (const auto &cell : level.space().dofs().active_cell_iterators()) {
    const PlaneRule rule = cut_rule(level.scene.kinks, corners_of(cell), 5);
    for (std::size_t q = 0; q < rule.points.size(); ++q)
      error += rule.weights[q] * level.scene.body_force->value(rule.points[q], 1);
  }
  checks.about("load that jumps on a parabola");
  checks.between("error of the integral", std::abs(error), 1e-11, HiddenLoad(level.scene).force());
  checks.between("its bound", HiddenLoad(level.scene).force(), 1e-6, 3e-5);
  checks.near("work on a translation", HiddenLoad(level.scene).work(level.space(), U),
              0.3 * HiddenLoad(level.scene).force(), 1e-12);
  const OneLevel smooth("Boundary/Clamped = top\nBoundary/Contact = bottom\nContact/Gap = 1\n"
                        "Load/Body force = 0; -sin(3*x)*y*y\n",
                        1);
  checks.near("bound of a smooth one", HiddenLoad(smooth.scene).force(), 0., 0.);
}

/** A force like the root of the distance r from a point, in which u = (r², 0): the bound of the
 * work is far below that of the force. */
void work_at_singular_point(Checks &checks) {
  const OneLevel level("Boundary/Clamped = top\nBoundary/Contact = bottom\nContact/Gap = 1\n"
                       "Load/Body force = ((x-0.7)^2+y^2)^0.25; 0\n",
                       6);
  const Displacement U = interpolate_at_nodes<2>(
    level.space(),
    VectorFunctionFromScalarFunctionObject<2>(
      [](const Point<2> &x) { return (x - Point<2>(0.7, 0.)).norm_square(); }, 0, 2));
  const HiddenLoad load(level.scene);
  checks.about("force like a root");
  checks.between("force", load.force(), 1e-9, 1e-6);
  checks.between("share of the work", load.work(level.space(), U) / load.force(), 0., 2e-3);
}

/** On graded meshes the width of brackets is rounding in the end: they are narrow, and those of two
 * meshes have numbers in common. */
void rounding(Checks &checks) {
  double lower = -HUGE_VAL, upper = HUGE_VAL;
  for (const std::string target : {"1e-6", "1e-7"}) {
    const StudyResult<2> found =
      solve("Boundary/Clamped = top\nBoundary/Contact = bottom\nContact/Gap = 0\n"
            "Load/Body force = 0.1*sin(3*x+y); -0.2*exp(x-y)\n",
            {"Discretization/Strategy=hp", "Discretization/Target error=" + target});
    const double from = last(found, "energy_lower"), to = last(found, "energy_upper");
    checks.about("brackets for " + target);
    checks.between("width", to - from, 0., 3e-12 * -from);
    checks.between("energy", last(found, "energy"), from, to);
    lower = std::max(lower, from);
    upper = std::min(upper, to);
  }
  checks.that("brackets meet", lower <= upper);
}

/** Poisson's ratio varies faster than boxes show. Neither law is the softer one: one is so under
 * shear, the other one under pressure. Meshes of all sizes bracket the same energy. */
void fine_pattern(Checks &checks) {
  const std::string text =
    "Boundary/Contact = bottom\nBoundary/Displacement = top: -0.024; -0.033\nContact/Gap = 0\n"
    "Material/Young's modulus = 1\n"
    "Material/Poisson's ratio = cos(24*pi*x)*cos(24*pi*y)<0 ? 0.45 : 0.3\n";
  const ErrorBound bound = Bounded(text, 5).bound;
  checks.about("fine pattern");
  // No displacement of finer elements has more energy.
  const OneLevel finer(text + "Output/Bound = false\n", 6);
  checks.that("brackets meet",
              bound.energy_lower.value() < finer.solve().record.certificate.energy);
  // Layers one behind the other are as stiff as the harmonic mean of their moduli, u_h as the
  // arithmetic one.
  const GradedLevel layers(
    "Boundary/Rollers = left\nBoundary/Contact = bottom\nBoundary/Displacement = right: 0.01; 0\n"
    "Contact/Gap = 0\nMaterial/Young's modulus = cos(6000*pi*x)<0 ? 100 : 1\n"
    "Material/Poisson's ratio = 0\nDiscretization/Target error = 1e-9\n",
    uniform_plan(2, 2));
  const ErrorBound of_layers = layers.solve().record.bound.value();
  const double harmonic = 200. / 101., arithmetic = 50.5;
  checks.that("energy of layers", of_layers.energy_lower.value() <= 0.5e-4 * harmonic);
  checks.that("error of layers",
              of_layers.absolute.value() >= 0.01 * std::sqrt(arithmetic - harmonic));
  const auto law = [](const double lambda, const double mu) {
    const SymmetricTensor<2, 2> I = unit_symmetric_tensor<2>();
    return Law(lambda * outer_product(I, I) + 2. * mu * identity_tensor<2>());
  };
  Law soft = law(1., 1.);
  soft.soften(law(9., 0.9));
  checks.near("pressure", soft.stiffness[0][0] + soft.stiffness[0][1], 4., 1e-14);
  checks.near("shear", soft.stiffness[2][2], 0.9, 1e-14);
}

/** No edge that may carry tractions stops the block along y: translations along y change
 * nothing. */
void translations(Checks &checks) {
  const auto mesh_part = [](const std::string &gap) {
    return *Bounded("Geometry/Upper right = 2, 1\nBoundary/Rollers = left\n"
                    "Boundary/Contact = bottom\nBoundary/Traction = top: 0; 0.1*(x-1)-0.001\n"
                    "Contact/Gap = " +
                      gap,
                    1)
              .bound.mesh;
  };
  for (const char *gap : {"0.001", "1"})
    checks.near("block that is moved", mesh_part(gap) / mesh_part("0"), 1., 1e-8);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {patch_tests, energies, slender, prescribed, brackets, hidden_load,
                    work_at_singular_point, rounding, fine_pattern, translations});
}
