// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies of revolution against an independent program with the same rules, and its exact fields.

#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>

#include <fstream>
#include <functional>
#include <iomanip>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
using dealii::numbers::PI;
using Point = dealii::Point<2>;

std::string revolved_with(const std::string &poissons_ratio) {
  return "Material/Young's modulus = 1\nMaterial/Poisson's ratio = " + poissons_ratio +
         "\nMaterial/Plane state = axisymmetric\n";
}
const std::string revolved = revolved_with("0.3");

/** Numbers of one level: the normal force all around, the largest |P_k|, the number of patches that
 * press, and J. */
struct Row {
  unsigned int level;
  double force, pressure;
  unsigned int active;
  double energy;
};

struct Reference {
  std::string name, text;
  std::vector<Row> rows;
};

/** The seal in the seat of a cone; the gap is that of the ring at rest. */
std::string seal(const std::string &material) {
  return "Geometry/Shape = file\nGeometry/File = seal.msh\nBoundary/Rollers = top\n"
         "Boundary/Contact = right\nContact/Gap = 0.002+0.01*y^2-0.006/sqrt(1.09)\n" +
         material;
}

const std::vector<Reference> references = {
  {"sleeve on a shaft",
   revolved + "Geometry/Lower left = 1,0\nGeometry/Upper right = 2,1\nGeometry/Cells = 4,4\n"
              "Boundary/Rollers = top bottom\nBoundary/Contact = left\nContact/Gap = -0.01\n",
   {{0, 0.0332862040857, 0.005297663917, 2, 0.000166431020428},
    {3, 0.0329590998841, 0.00524560366641, 16, 0.00016479549942}}},
  {"cylinder on a paraboloid",
   revolved + "Geometry/Upper right = 1,1\nGeometry/Cells = 8,8\n"
              "Boundary/Displacement = top: 0; -0.02\nBoundary/Contact = bottom\n"
              "Contact/Gap = x^2/2\n",
   {{1, 0.00479460166435, 0.0976748230449, 1, 3.85815602678e-05},
    {3, 0.00468844087297, 0.101821104158, 5, 3.66459304725e-05}}},
  {"punch with a rounded edge",
   revolved + "Geometry/Upper right = 1,1\nGeometry/Cells = 8,8\nBoundary/Rollers = top\n"
              "Boundary/Contact = bottom\nContact/Gap = max(x-0.3,0)^2/0.2-0.02\n"
              "Discretization/Kinks at x = 0.3\n",
   {{0, 0.0126579994379, 0.0644666617665, 1, 0.000126579994379},
    {3, 0.0169674306802, 0.124840434744, 11, 0.000167409232224}}},
  {"cone seal",
   seal(revolved),
   {{0, 0.00858487297114, 0.00290010068193, 2, 1.43801264837e-05},
    {3, 0.0086859313685, 0.00271851831296, 12, 1.44478713834e-05}}},
  {"cone seal, nearly incompressible",
   seal(revolved_with("0.4999") + "Discretization/Element = Q1 B-bar\n"),
   {{1, 0.010675994479, 0.0035273068923, 3, 1.7699195617e-5},
    {2, 0.010639316893, 0.0033566150477, 6, 1.7697835743e-5}}},
  {"diaphragm on a stop",
   revolved + "Geometry/Upper right = 1,0.25\nGeometry/Cells = 16,4\nBoundary/Clamped = right\n"
              "Boundary/Traction = top: 0; -0.004\nBoundary/Contact = bottom\nContact/Gap = 0.02\n",
   {{0, 0.00233632767602, 0.0099214877575, 3, -9.05598906155e-05},
    {3, 0.0024398811991, 0.00821484460935, 22, -9.29319192445e-05}}},
  {"sphere on a ball, straight cells",
   revolved + "Geometry/Shape = file\nGeometry/File = sphere.msh\nBoundary/Rollers = bottom\n"
              "Boundary/Contact = left\nContact/Gap = -0.01\n",
   {{0, 0.0787160356949, 0.0125328813624, 16, 0.000393580178475}}}};

/** Writes the image of n x m cells of the unit square, with the names of its sides. */
void write_mesh(const std::string &file, const unsigned int n, const unsigned int m,
                const std::function<Point(double, double)> &map) {
  const auto node = [n](const unsigned int i, const unsigned int j) { return 1 + i + (n + 1) * j; };
  std::ofstream stream(file);
  stream << std::setprecision(17) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n5\n"
         << "1 1 \"bottom\"\n1 2 \"right\"\n1 3 \"top\"\n1 4 \"left\"\n2 5 \"body\"\n"
         << "$EndPhysicalNames\n$Nodes\n"
         << (n + 1) * (m + 1) << "\n";
  for (unsigned int j = 0; j <= m; ++j)
    for (unsigned int i = 0; i <= n; ++i)
      stream << node(i, j) << " " << map(double(i) / n, double(j) / m) << " 0\n";
  stream << "$EndNodes\n$Elements\n" << n * m + 2 * (n + m) << "\n";
  unsigned int number = 0;
  const auto line = [&](const unsigned int side, const unsigned int a, const unsigned int b) {
    stream << ++number << " 1 2 " << side << " " << side << " " << a << " " << b << "\n";
  };
  for (unsigned int i = 0; i < n; ++i) {
    line(1, node(i, 0), node(i + 1, 0));
    line(3, node(i, m), node(i + 1, m));
  }
  for (unsigned int j = 0; j < m; ++j) {
    line(2, node(n, j), node(n, j + 1));
    line(4, node(0, j), node(0, j + 1));
  }
  for (unsigned int j = 0; j < m; ++j)
    for (unsigned int i = 0; i < n; ++i)
      stream << ++number << " 3 2 5 5 " << node(i, j) << " " << node(i + 1, j) << " "
             << node(i + 1, j + 1) << " " << node(i, j + 1) << "\n";
  stream << "$EndElements\n";
}

void check_references(Checks &checks) {
  write_mesh("seal.msh", 4, 8,
             [](const double s, const double t) { return Point(1. + s * (0.5 + 0.3 * t), t); });
  // The axis is the side "top".
  write_mesh("sphere.msh", 16, 32, [](const double s, const double t) {
    return Point(t == 1. ? 0. : (1. + s) * std::cos(PI / 2. * t), (1. + s) * std::sin(PI / 2. * t));
  });
  for (const auto &[name, text, rows] : references)
    for (const Row &row : rows) {
      checks.about(name + ", level " + std::to_string(row.level));
      const StudyResult<2> result = solve(text, levels(row.level, row.level));
      constexpr double digits = 2e-10;
      checks.near("force", last(result, "contact_force_n") / row.force, 1., digits);
      checks.near("largest pressure", last(result, "max_pressure") / row.pressure, 1., digits);
      // Volumetric stresses are 5000 times the others in the body that is nearly incompressible.
      const bool cancels = text.find("0.4999") != std::string::npos;
      checks.near("energy", last(result, "energy") / row.energy, 1., cancels ? 1e-8 : digits);
      checks.near("active", last(result, "active"), row.active, 0.);
      checks.that("equations",
                  result.verdict.is_certified() || result.verdict.outcome == Outcome::not_resolved);
      const ErrorBound &bound = *result.levels.back().bound;
      checks.that("no bound", !bound.absolute && !bound.penetration &&
                                bound.missing.find("revolution") != std::string::npos);
    }
}

/** u = (a x, b y + c) has constant stresses, also around the axis: exact on every mesh. */
void check_patch_test(Checks &checks) {
  // lambda = 15/26, mu = 5/13; a = 0.02, b = -0.03.
  const std::string lambda = "(15/26)", mu = "(5/13)", dilatation = "(2*0.02-0.03)",
                    srr = lambda + "*" + dilatation + "+2*" + mu + "*0.02",
                    syy = lambda + "*" + dilatation + "-2*" + mu + "*0.03";
  const std::string text = "Boundary/Displacement = top: 0.02*x; -0.03*y+0.01\n"
                           "Boundary/Traction = right: " +
                           srr +
                           "; 0\n"
                           "Boundary/Contact = bottom\nContact/Gap = -0.01\n"
                           "Exact solution/Displacement = 0.02*x; -0.03*y+0.01\n"
                           "Exact solution/Pressure = " +
                           syy + "\n";
  for (const std::string element : {"Q1", "Q1 B-bar", "Q2"})
    for (const std::string distortion : {"0", "0.25"}) {
      checks.about(element + ", distortion " + distortion);
      const StudyResult<2> result = solve(
        revolved + text,
        levels(3, 3, {"Discretization/Element=" + element, "Geometry/Distortion=" + distortion}));
      for (const char *column : {"u_h1", "u_energy", "p_l2"})
        checks.near(column, last(result, column), 0., 1e-12);
    }
}

/** A thin ring far from its axis is a plane body: per circumference all forces agree. */
void check_far_ring(Checks &checks) {
  const auto block = [](const double radius, const std::string &state) {
    const std::string x = "(x-" + std::to_string(radius) + ")";
    return "Constants/Values = R=" + std::to_string(radius) +
           "\nGeometry/Lower left = " + std::to_string(radius) +
           ",0\nGeometry/Upper right = " + std::to_string(radius + 1.) +
           ",1\nMaterial/Plane state = " + state +
           "\nMaterial/Young's modulus = 1\nMaterial/Poisson's ratio = 0.3\n"
           "Boundary/Displacement = top: 0.01; -0.02\nBoundary/Contact = bottom\n"
           "Contact/Gap = (x-R)^2/10\nContact/Friction = coulomb\n"
           "Contact/Friction coefficient = 0.3\n";
  };
  constexpr double R = 1e4;
  const StudyResult<2> plane = solve(block(0., "strain"), levels(4, 4)),
                       ring = solve(block(R, "axisymmetric"), levels(4, 4));
  checks.about("ring far from the axis");
  const double circumference = 2. * PI * R;
  checks.near("force", last(ring, "contact_force_n") / circumference,
              last(plane, "contact_force_n"), 1e-6);
  checks.near("energy", last(ring, "energy") / circumference, last(plane, "energy"), 1e-7);
  const auto friction_of = [](const StudyResult<2> &result) {
    return result.levels.back().tangential->tangential_force;
  };
  checks.near("friction", friction_of(ring) / circumference, friction_of(plane), 1e-6);
  checks.between("share of friction", friction_of(plane) / last(plane, "contact_force_n"), 0.1,
                 0.3);
}

/** Graded meshes against closed forms: Lame's hollow sphere, Hertz' contact and Boussinesq's punch.
 */
void check_closed_forms(Checks &checks) {
  const std::string folder = SOURCE_DIR "/prm/revolution/";
  checks.about("closed forms");
  const StudyResult<2> sphere = solve_file(folder + "thick_sphere.prm");
  checks.near("hollow sphere, p", sphere.levels.back().answer.peak_pressure->mean, 0.0125, 1e-7);
  checks.near("hollow sphere, force", last(sphere, "contact_force_n"), 2. * PI * 0.0125, 1e-7);
  // A small zone on a paraboloid: the finite cylinder changes p_0 and a by a_0³ only.
  const double a = 0.1, E = 1. / 0.91, peak = 2. * E * a / PI;
  const StudyResult<2> hertz =
    solve(revolved + "Geometry/Upper right = 1,1\nBoundary/Plates = top: 0, -1\n"
                     "Boundary/Contact = bottom\nLoad/Plate force = top: 0.0014652014652\n"
                     "Contact/Gap = x^2/2\nDiscretization/Strategy = hp\n"
                     "Discretization/Target error = 1e-4\n");
  checks.near("Hertz, p_0", hertz.levels.back().answer.peak_pressure->value, peak, 1e-3 * peak);
  checks.near("Hertz, a", last(hertz, "contact_length"), a, 1e-3 * a);
  const StudyResult<2> punch = solve_file(folder + "flat_punch.prm");
  checks.near("punch, force", last(punch, "contact_force_n"), 10., 1e-8);
  const Answer &answer = punch.levels.back().answer;
  checks.near("punch, zone", answer.zones.front().length, 1., 1e-6);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {check_references, check_patch_test, check_far_ring, check_closed_forms});
}
