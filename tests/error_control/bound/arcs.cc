// SPDX-License-Identifier: LGPL-2.1-or-later
// The bound on bodies with circular arcs: the lift of a traction is in equilibrium, the least
// energy of stresses is that of an independent program, and energies that are known lie in the
// brackets.

#include <signorini/error_control/equilibration/arc_lift.h>
#include <signorini/error_control/equilibration/edge_polynomials.h>

#include <deal.II/lac/full_matrix.h>

#include <cmath>
#include <fstream>
#include <iomanip>

#include "bounded.h"
#include "error_control/hp/graded.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** Returns a traction at the nodes of a lift, of degree 6 in a, that fulfils its conditions. */
std::vector<Tensor<1, 2>> lifted_traction(const ArcLift &lift) {
  constexpr unsigned int n = 14;
  std::vector<std::vector<Tensor<1, 2>>> basis(n);
  FullMatrix<double> conditions(ArcLift::n_conditions, n);
  for (std::size_t i = 0; i < lift.nodes().size(); ++i) {
    const std::vector<double> L = legendre_values(6, lift.nodes()[i].position);
    for (unsigned int k = 0; k < n; ++k) {
      Tensor<1, 2> r;
      r[k % 2] = L[k / 2];
      basis[k].push_back(r);
      for (unsigned int c = 0; c < ArcLift::n_conditions; ++c)
        for (unsigned int d = 0; d < 2; ++d)
          conditions(c, k) += lift.conditions()(c, 2 * i + d) * r[d];
    }
  }
  // The part of a vector that is orthogonal to the rows.
  Vector<double> x(n), rest(ArcLift::n_conditions), multipliers(rest);
  for (unsigned int k = 0; k < n; ++k)
    x[k] = std::cos(3. * k + 1.);
  FullMatrix<double> gram(ArcLift::n_conditions);
  conditions.mTmult(gram, conditions);
  gram.gauss_jordan();
  for (unsigned int pass = 0; pass < 2; ++pass) {
    conditions.vmult(rest, x);
    gram.vmult(multipliers, rest);
    multipliers *= -1.;
    conditions.Tvmult_add(x, multipliers);
  }
  std::vector<Tensor<1, 2>> r(lift.nodes().size());
  for (unsigned int k = 0; k < n; ++k)
    for (std::size_t i = 0; i < r.size(); ++i)
      r[i] += x[k] * basis[k][i];
  return r;
}

/** int tau_L : grad v = int_arc r.v for all polynomials v: tau_L has no load and no other traction.
 */
void equilibrium(Checks &checks) {
  const auto arc = [](const double radius, const double turn, const bool is_convex) {
    // Seen from the origin, the chord from (0.5, -0.5) to (0.5, 0.5) or shorter.
    const double half = std::min(0.5, radius * std::sin(0.5 * turn)),
                 depth = std::sqrt(radius * radius - half * half);
    return Curve::between({0.5, -half}, {0.5, half},
                          Point<2>(0.5 + (is_convex ? -depth : depth), 0.));
  };
  const std::vector<std::pair<std::string, Curve>> arcs = {
    {"convex", arc(1.3, 0.8, true)},
    {"concave", arc(1.3, 0.6, false)},
    {"R = 3", arc(3., 0.3, true)},
    {"nearly straight", arc(1e6, 1., false)},
    {"straight", Curve({0.6, -0.4}, {0.4, 0.5})}};
  for (const auto &[name, curve] : arcs) {
    const ArcLift lift(curve, 6);
    const std::vector<Tensor<1, 2>> r = lifted_traction(lift);
    double largest = 0.;
    for (unsigned int i = 0; i < 5; ++i)
      for (unsigned int j = 0; i + j < 5; ++j)
        for (unsigned int c = 0; c < 2; ++c) {
          double inside = 0., on_arc = 0., size = 1e-300;
          for (std::size_t q = 0; q < lift.points().size(); ++q) {
            const auto &[x, weight] = lift.points()[q];
            Tensor<1, 3> stress;
            for (unsigned int s = 0; s < 3; ++s)
              for (unsigned int k = 0; k < 2 * r.size(); ++k)
                stress[s] += lift.stresses()(3 * q + s, k) * r[k / 2][k % 2];
            const double d_x = i == 0 ? 0. : i * std::pow(x[0], i - 1.) * std::pow(x[1], j),
                         d_y = j == 0 ? 0. : j * std::pow(x[0], i) * std::pow(x[1], j - 1.);
            inside += weight * (stress[c == 0 ? 0 : 2] * d_x + stress[c == 0 ? 2 : 1] * d_y);
            size += weight * stress.norm();
          }
          for (std::size_t k = 0; k < r.size(); ++k)
            on_arc += lift.nodes()[k].weight * r[k][c] * std::pow(lift.nodes()[k].x[0], i) *
                      std::pow(lift.nodes()[k].x[1], j);
          largest = std::max(largest, std::abs(inside - on_arc) / size);
        }
    checks.near(name + ": virtual work", largest, 0., 1e-11);
  }
}

/** A quarter of the ring 1 < r < 2 in two cells, from 0 to 45 and to 90 degrees. */
void write_ring() {
  const double s = std::sqrt(0.5);
  std::ofstream("ring.msh")
    << std::setprecision(17)
    << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n5\n1 1 \"y0\"\n"
       "1 2 \"outer\"\n1 3 \"x0\"\n1 4 \"inner\"\n2 5 \"body\"\n"
       "$EndPhysicalNames\n$Nodes\n6\n1 1 0 0\n2 2 0 0\n3 "
    << s << " " << s << " 0\n4 " << 2. * s << " " << 2. * s
    << " 0\n5 0 1 0\n6 0 2 0\n$EndNodes\n$Elements\n8\n1 1 2 1 1 1 2\n"
       "2 1 2 2 1 2 4\n3 1 2 2 1 4 6\n4 1 2 3 1 6 5\n5 1 2 4 1 5 3\n"
       "6 1 2 4 1 3 1\n7 3 2 5 1 1 2 4 3\n8 3 2 5 1 3 4 6 5\n$EndElements\n";
}

/** The least 1/2 |tau|² of stresses of degree 2 on two cells by an independent program (numpy),
 * with the exact tractions of Lame (pressure inside) and of Kirsch (tension along x), and the
 * energies themselves. */
void least_energies(Checks &checks) {
  write_ring();
  const std::string
    body = "Geometry/Shape = file\nGeometry/File = ring.msh\n"
           "Geometry/Arcs = inner outer\nMaterial/Young's modulus = 1\n"
           "Material/Poisson's ratio = 0.3\n",
    kirsch = "Constants/Values = S=1\nBoundary/Rollers = x0 y0\nBoundary/Contact = inner\n"
             "Contact/Gap = 10\n"
             "Boundary/Traction = outer: "
             "S*((1-(1.5*cos(2*atan2(y,x))+cos(4*atan2(y,x)))/4+1.5*cos(4*atan2(y,x))/16)*x/2"
             "+(-(0.5*sin(2*atan2(y,x))+sin(4*atan2(y,x)))/4+1.5*sin(4*atan2(y,x))/16)*y/2); "
             "S*((-(0.5*sin(2*atan2(y,x))+sin(4*atan2(y,x)))/4+1.5*sin(4*atan2(y,x))/16)*x/2"
             "+(-(0.5*cos(2*atan2(y,x))-cos(4*atan2(y,x)))/4-1.5*cos(4*atan2(y,x))/16)*y/2)\n";
  struct Row {
    std::string name, text;
    double least, exact;
  };
  for (const Row &row :
       {Row{"Lame",
            body + "Boundary/Rollers = x0 y0\nBoundary/Contact = outer\nContact/Gap = 10\n"
                   "Boundary/Traction = inner: x; y\n",
            2.998465974710, 2.9949849964223},
        Row{"Kirsch", body + kirsch, 3.011782433130, 3.0008345764934}})
    for (const unsigned int number : {0U, 1U, 3U}) {
      const Bounded level(row.text, number);
      checks.about(row.name + ", level " + std::to_string(number));
      checks.that("guaranteed", level.bound.absolute && level.bound.is_guaranteed());
      if (!level.bound.energy_lower)
        continue;
      if (number == 0)
        checks.near("least energy", *level.bound.energy_lower, -0.5 * row.least, 1e-10);
      checks.between("energy", -0.5 * row.exact, *level.bound.energy_lower,
                     *level.bound.energy_upper);
    }
}

/** The same for Lame's ring with stresses of higher degrees, on graded meshes. */
void degrees(Checks &checks) {
  write_ring();
  const std::string text =
    "Geometry/Shape = file\nGeometry/File = ring.msh\nGeometry/Arcs = inner outer\n"
    "Material/Young's modulus = 1\nMaterial/Poisson's ratio = 0.3\nBoundary/Rollers = x0 y0\n"
    "Boundary/Contact = outer\nContact/Gap = 10\nBoundary/Traction = inner: x; y\n"
    "Discretization/Target error = 1e-9\n";
  const std::vector<double> least = {2.995099902756, 2.994989380087, 2.994985156005, 2.994985001850,
                                     2.994984996622};
  for (unsigned int i = 0; i < least.size(); ++i) {
    const GradedLevel level(text, uniform_plan(0, 3 + i));
    const auto solution = level.solve();
    const ErrorBound &bound = solution.record.bound.value();
    checks.about("Lame, degree " + std::to_string(3 + i));
    checks.that("guaranteed", bound.is_guaranteed() && bound.energy_lower);
    if (bound.energy_lower)
      checks.near("least energy", *bound.energy_lower, -0.5 * least[i], 1e-10);
  }
}

/** A half disc on a plane that acts along its own normal, on nested and on graded meshes, or along
 * the body's: J by meshes that are finer. The bound is at most 1.3 times the error. */
void half_disc(Checks &checks) {
  const std::string text = "Geometry/Shape = half disc\nMaterial/Young's modulus = 1\n"
                           "Material/Poisson's ratio = 0.3\nBoundary/Clamped = flat\n"
                           "Boundary/Contact = arc\nContact/Foundation = plane 0,-1 normal 0,1\n"
                           "Contact/Foundation position = 0, 0.05\n";
  const std::vector<std::string> graded = {"Discretization/Strategy=hp",
                                           "Discretization/Target error=1e-4"},
                                 along_n = {graded[0], graded[1], "Contact/Direction=body"};
  constexpr double of_plane = 8.3653348020e-4, of_body = 8.370223349e-4;
  for (const auto &[overrides, J] :
       {std::pair{levels(2, 5), of_plane}, {graded, of_plane}, {along_n, of_body}}) {
    checks.about("half disc, " + overrides.back());
    const StudyResult<2> found = solve(text, overrides);
    checks.that("certified", found.verdict.outcome == Outcome::certified);
    checks.between("energy", J, last(found, "energy_lower") * (1. - 1e-9),
                   last(found, "energy_upper") * (1. + 1e-9));
    // The exact solution is at least so far away that the energies differ.
    if (overrides.front() == graded.front())
      checks.between("bound over error",
                     last(found, "bound_energy") / std::sqrt(2. * (last(found, "energy") - J)),
                     0.98, 1.3);
  }
}

/** Displacements that are prescribed on arcs, and on straight sides where they are no polynomials:
 * Lame's ring, turned and moved. */
void prescribed(Checks &checks) {
  write_ring();
  const std::string moduli = "Material/Young's modulus = 1\nMaterial/Poisson's ratio = 0.3\n"
                             "Contact/Gap = 10\nBoundary/Contact = outer\n";
  struct Row {
    std::string name, text;
    double energy;
  };
  const double energy = 0.5 * numbers::PI * 1.3 * (0.2 / 3. + 2. / 3.);
  for (const Row &row :
       {Row{"arc",
            moduli + "Geometry/Shape = ring\nBoundary/Displacement = inner: "
                     "0.3+1.3*(0.4/3+4/3)*x-0.1*y; -0.2+1.3*(0.4/3+4/3)*y+0.1*x\n",
            energy},
        Row{"straight sides",
            moduli + "Geometry/Shape = file\nGeometry/File = ring.msh\n"
                     "Geometry/Arcs = inner outer\nBoundary/Traction = inner: x; y\n"
                     "Boundary/Displacement = x0: 0; 1.3*(0.4/3*y+4/3/y) | "
                     "y0: 1.3*(0.4/3*x+4/3/x); 0\n",
            -energy}})
    for (const unsigned int number : {1U, 3U}) {
      const Bounded level(row.text, number);
      checks.about("prescribed on " + row.name + ", level " + std::to_string(number));
      checks.that("guaranteed", level.bound.is_guaranteed() && level.bound.energy_lower);
      if (!level.bound.energy_lower)
        continue;
      checks.between("energy", row.energy, *level.bound.energy_lower, *level.bound.energy_upper);
      checks.that("lift", *level.bound.oscillation > 0.);
    }
}

/** A clamped arc that ends in corners, where cells of a graded mesh are 1e-7 of the radius: J of a
 * function that does not penetrate is not below the bracket. */
void corners_of_arcs(Checks &checks) {
  checks.about("corners of an arc");
  write_ring();
  const StudyResult<2> found =
    solve("Geometry/Shape = file\nGeometry/File = ring.msh\nGeometry/Arcs = inner outer\n"
          "Material/Young's modulus = 1\nMaterial/Poisson's ratio = 0.3\n"
          "Boundary/Clamped = outer\nBoundary/Traction = inner: x; y\nBoundary/Contact = x0\n"
          "Contact/Gap = 10\n",
          {"Discretization/Strategy=hp", "Discretization/Target error=1e-4",
           "Discretization/Maximum degree=4"});
  checks.that("certified", found.verdict.outcome == Outcome::certified);
  const double J = last(found, "energy");
  checks.between("energy", J, last(found, "energy_lower"), last(found, "energy_upper") + 1e-11);
  checks.between("relative bound", last(found, "bound_relative"), 1e-6, 1e-4);
}

/** Curved bodies that graded meshes must split for their bound: a notch whose arc turns by 180
 * degrees in one coarse cell, a ring with cells that are thinner than their chords are deep, and a
 * sickle with cells whose angles are 9 degrees. */
void thin_bodies(Checks &checks) {
  struct Row {
    std::string name, target, text;
  };
  for (const Row &row :
       {Row{
          "notch", "0.02",
          "Geometry/Shape = polygon\nGeometry/Vertices = 0,0; 1,0; arc 1.3,0 cw; 1.6,0; 3,0; 3,1; "
          "0,1\nBoundary/Displacement = side4: 0;-0.01\nBoundary/Contact = side0 side2\n"
          "Contact/Gap = 0\n"},
        Row{"ring", "0.05",
            "Geometry/Shape = ring\nGeometry/Inner radius = 0.97\n"
            "Boundary/Traction = inner: 0.01*x; 0.01*y\nBoundary/Contact = outer\n"
            "Contact/Foundation = circle 0,0 radius 1.01 inside\n"},
        Row{"sickle", "0.2",
            "Geometry/Shape = polygon\nGeometry/Vertices = -1,0.2; -1,0; arc 0,0.225 ccw; 1,0; "
            "1,0.2; arc 0,0.5642857142857143 cw\nBoundary/Contact = side1\n"
            "Boundary/Displacement = side0: 0;-0.005 | side2: 0;-0.005\n"
            "Contact/Foundation = plane 0,-0.8 normal 0,1\n"}}) {
    checks.about(row.name);
    const StudyResult<2> found =
      solve(row.text, {"Discretization/Strategy=hp", "Discretization/Target error=" + row.target});
    checks.that("certified", found.verdict.outcome == Outcome::certified);
    checks.between("relative bound", last(found, "bound_relative"), 1e-6, std::stod(row.target));
  }
}

/** A smooth force in a curved body, written so that its enclosures are poor: boxes smaller than
 * cells show it, and the bound is guaranteed. J is that of the same force in plain words. */
void poor_formula(Checks &checks) {
  const std::string text = "Geometry/Shape = half disc\nBoundary/Clamped = flat\n"
                           "Boundary/Contact = arc\nContact/Gap = 1\n"
                           "Load/Body force = 0; -cos(2*x+y)",
                    one = "*(sin(5*x+3*y)^2+cos(5*x+3*y)^2)^9\n";
  const std::vector<std::string> hp = {"Discretization/Strategy=hp",
                                       "Discretization/Target error=1e-4"};
  const double J = last(solve(text + "\n", hp), "energy");
  for (const auto &overrides : {hp, levels(2, 2)}) {
    checks.about("force with poor enclosures, " + overrides.back());
    const StudyResult<2> found = solve(text + one, overrides);
    checks.that("certified", found.verdict.outcome == Outcome::certified);
    checks.between("energy", J, last(found, "energy_lower"), last(found, "energy_upper"));
  }
}

/** Smooth forces of which hardly anything is left in most of the body, or that turn fast: the first
 * mesh is as coarse as without them, and the bound reaches the usual aim. */
void narrow_and_fast_forces(Checks &checks) {
  const std::string text = "Geometry/Shape = half disc\nBoundary/Clamped = flat\n"
                           "Boundary/Contact = arc\nContact/Gap = 1\nLoad/Body force = 0; ",
                    narrow = "exp(-50*(x^2+(y+0.5)^2))\n",
                    fast = "sin(8*(x^2+(y+1)^2)+3*x)*exp(-0.5*(x-y-1)^2)\n";
  for (const std::string &force : {narrow, fast}) {
    checks.about("force " + force);
    const StudyResult<2> found = solve(text + force, {"Discretization/Strategy=hp"});
    checks.between("cells of the first mesh", value(found.levels.front(), "cells").value(), 64,
                   100);
    checks.that("a guaranteed bound", bound_of(found.levels.back()).value_or(1.) < 1e-3);
  }
}

/** A ring that a plate in its bore presses onto a plane, by a force and by the travel that it
 * makes: the bounds of J on coarse meshes contain those on finer ones, and J of the travel is that
 * of the force without its work. */
void moved_bore(Checks &checks) {
  const std::string text = "Geometry/Shape = ring\nBoundary/Plates = inner: 0, -1\n"
                           "Boundary/Contact = outer\nContact/Foundation = plane 0,-1 normal 0,1\n";
  const auto solve_to = [&](const std::string &load, const std::string &target) {
    return solve(text + load,
                 {"Discretization/Strategy=hp", "Discretization/Target error=" + target,
                  "Discretization/Coarsest level=1", "Discretization/Maximum degree=6"});
  };
  const std::string by_force = "Load/Plate force = inner: 0.02\n";
  const StudyResult<2> coarse = solve_to(by_force, "1e-2"), fine = solve_to(by_force, "1e-4");
  const double travel = last(fine, "plate_travel"), energy = last(fine, "energy");
  std::ostringstream by_travel;
  by_travel << std::setprecision(16) << "Load/Plate travel = inner: " << travel << "\n";
  const StudyResult<2> driven = solve_to(by_travel.str(), "1e-2");
  const std::array<std::pair<const StudyResult<2> *, double>, 3> expected = {
    {{&coarse, energy}, {&fine, energy}, {&driven, energy + 0.02 * travel}}};
  for (const auto &[found, J] : expected) {
    checks.about("moved bore");
    checks.that("certified", found->verdict.outcome == Outcome::certified);
    checks.between("energy", J, last(*found, "energy_lower") - 1e-8 * std::abs(J),
                   last(*found, "energy_upper") + 1e-8 * std::abs(J));
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {equilibrium, least_energies, degrees, half_disc, prescribed, corners_of_arcs,
                    thin_bodies, poor_formula, narrow_and_fast_forces, moved_bore});
}
