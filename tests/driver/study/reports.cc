// SPDX-License-Identifier: LGPL-2.1-or-later
// Output/Report against closed forms: Lame's ring, constant stress, corners where stress grows, a
// slab of a given thickness.

#include <algorithm>
#include <cmath>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** A quarter of a ring of radii 1 and 2 under the pressure 1 inside, E = 1, nu = 0.3, plane strain.
 */
const std::string ring = "subsection Geometry\nset Shape = polygon\n"
                         "set Vertices = 1,0; 2,0; arc 0,0 ccw; 0,2; 0,1; arc 0,0 cw\nend\n"
                         "subsection Boundary\nset Rollers = side0 side2\nset Contact = side1\n"
                         "set Traction = side3: x; y\nend\nsubsection Contact\nset Gap = 10\nend\n";

/** Lame's solution. */
double radial(const double r) {
  return (1. - 4. / (r * r)) / 3.;
}
double hoop(const double r) {
  return (1. + 4. / (r * r)) / 3.;
}
double displacement(const double r) {
  return 1.3 / 3. * (0.4 * r + 4. / r);
}
double von_mises_at(const double r) {
  const double a = radial(r), b = hoop(r), c = 0.3 * (a + b);
  return std::sqrt(0.5 * ((a - b) * (a - b) + (b - c) * (b - c) + (c - a) * (c - a)));
}

double extreme(const ProbeReport &report, const ReportField field) {
  return report.extremes.at(static_cast<std::size_t>(field)).value;
}

void check_probe(Checks &checks, const ProbeReport &report, const double r,
                 const double tolerance) {
  checks.about(report.probe);
  checks.near("von Mises", extreme(report, ReportField::von_mises), von_mises_at(r), tolerance);
  checks.near("tension", extreme(report, ReportField::largest_principal), hoop(r), tolerance);
  checks.near("compression", extreme(report, ReportField::smallest_principal), radial(r),
              tolerance);
  checks.near("displacement", extreme(report, ReportField::displacement), displacement(r),
              tolerance);
  checks.near("points of growth", report.growth.size(), 0., 0.);
}

void check_ring(Checks &checks, const std::vector<std::string> &mesh, const double tolerance) {
  std::vector<std::string> overrides = mesh;
  overrides.push_back("Output/Report=side3 | 0.9,1.2 | 0.6,0.8 to 1.2,1.6 | 0,0 radius 1.0000001");
  const StudyResult<2> result = solve(ring, overrides);
  const std::vector<ProbeReport> &reports = result.levels.back().answer.reports;
  check_probe(checks, reports.at(0), 1., tolerance);
  check_probe(checks, reports.at(1), 1.5, tolerance);
  check_probe(checks, reports.at(3), 1., tolerance);
  checks.about("line");
  checks.near("points", reports.at(2).rows.size(), 101., 2.);
  for (const std::vector<double> &row : reports[2].rows) {
    const double r = 1. + row[0], c = 0.6, s = 0.8;
    checks.near("coordinates", dealii::Point<2>(row[1], row[2]), dealii::Point<2>(c * r, s * r),
                1e-12);
    checks.near("displacement", row[3] * c + row[4] * s, displacement(r), tolerance);
    checks.near("across", row[3] * s - row[4] * c, 0., tolerance);
    checks.near("xx", row[5], c * c * radial(r) + s * s * hoop(r), tolerance);
    checks.near("yy", row[6], s * s * radial(r) + c * c * hoop(r), tolerance);
    checks.near("zz", row[7], 0.2, tolerance);
    checks.near("xy", row[8], c * s * (radial(r) - hoop(r)), tolerance);
  }
  checks.about("");
}

/** Stress is constant in a block that is pulled: every point has the same one, on every mesh. */
void check_block(Checks &checks, const std::string &entries, const std::string &report) {
  const StudyResult<2> result = solve(
    "Geometry/Upper right = 2, 1\n" + entries +
      "Boundary/Rollers = left\nBoundary/Contact = bottom\nBoundary/Traction = right: 0.3; 0 | "
      "top: 0; -0.5\n",
    levels(1, 3, {"Output/Report=" + report, "Material/Plane state=stress"}));
  for (const ProbeReport &report : result.levels.back().answer.reports) {
    checks.about(report.probe);
    checks.near("tension", extreme(report, ReportField::largest_principal), 0.3, 1e-12);
    checks.near("compression", extreme(report, ReportField::smallest_principal), -0.5, 1e-12);
    checks.near("von Mises", extreme(report, ReportField::von_mises), 0.7, 1e-12);
  }
  checks.about("");
}

void check_space(Checks &checks) {
  const StudyResult<3> result =
    solve<3>("set Dimension = 3\nGeometry/Shape = box\nGeometry/Upper right = 1, 1, 1\n"
             "Boundary/Rollers = left front bottom\nBoundary/Contact = top\n"
             "Boundary/Traction = right: 0.3; 0; 0 | back: 0; -0.5; 0\nContact/Gap = 10\n",
             levels(1, 2, {"Output/Report=right | 0.5,0.5,0.3 | 0.5,0.5,0.5 radius 0.3"}));
  for (const ProbeReport &report : result.levels.back().answer.reports) {
    checks.about("space, " + report.probe);
    checks.near("tension", extreme(report, ReportField::largest_principal), 0.3, 1e-10);
    checks.near("compression", extreme(report, ReportField::smallest_principal), -0.5, 1e-10);
  }
  checks.about("");
}

/** At the re-entrant corner of an L stress grows like r^{0.5445 - 1}. */
void check_corner(Checks &checks) {
  const StudyResult<2> result =
    solve("Geometry/Shape = polygon\nGeometry/Vertices = 0,0; 2,0; 2,1; 1,1; 1,2; 0,2\n"
          "Boundary/Clamped = side4\nBoundary/Contact = side0\nContact/Gap = 10\n"
          "Load/Body force = 0; -0.01\n",
          {"Discretization/Strategy=hp", "Output/Report=side2 | 1,1 | 1,0.5 to 1,1"});
  for (const ProbeReport &report : result.levels.back().answer.reports) {
    checks.about("corner, " + report.probe);
    checks.near("points of growth", report.growth.size(), 1., 0.);
    checks.near("exponent", report.growth.at(0).exponent, 0.544483737, 1e-6);
    const AnswerVector &x = report.extremes.at(0).point;
    const double distance = x.distance(AnswerVector(dealii::Point<2>(1., 1.)));
    checks.that("left out", report.rows.size() == 1 ? distance == 0. : distance >= 0.1);
  }
  checks.about("");
}

/** Where contact sticks or slips, and where an interface ends, stresses grow from one level to the
 * next like h^{λ - 1} with the exponent that the answer names. */
void check_other_growth(Checks &checks) {
  const std::string scene = "Geometry/Upper right = 2, 1\nBoundary/Contact = bottom\n"
                            "Contact/Gap = 0\nMaterial/Poisson's ratio = 0.3\n";
  const std::string friction = "Contact/Friction = coulomb\nContact/Friction coefficient = ";
  struct Row {
    std::string name, settings;
    double exponent, position;
    bool is_pressure;
  };
  for (const Row &row : std::vector<Row>{
         {"sticks", friction + "5\nBoundary/Displacement = top: 0; -0.1\n", 0.71117, 0., true},
         {"slips", friction + "0.4\nBoundary/Displacement = top: 0.4; -0.2\n", 0.639, 2., true},
         {"interface",
          "Boundary/Displacement = top: 0; -0.1\nMaterial/Young's modulus = y<0.5 ? 1000 : 1\n",
          0.7122, 0., false}}) {
    const auto levels_of = solve(scene + row.settings, levels(5, 7, {"Output/Bound=false"})).levels;
    std::vector<double> values;
    for (const LevelRecord &level : levels_of)
      values.push_back(row.is_pressure ? level.answer.peak_pressure->value
                                       : level.answer.von_mises.value);
    const Answer &answer = levels_of.back().answer;
    const auto &growth =
      row.is_pressure ? answer.peak_pressure->grows_at : answer.von_mises.grows_at;
    checks.about(row.name);
    checks.that("growth is named", growth.has_value());
    checks.near("exponent", growth->exponent, row.exponent, 1e-3);
    checks.near("measured", 1. - std::log2(values[2] / values[1]), row.exponent, 0.03);
    if (row.position > 0.)
      checks.near("place", growth->ends[0][0], row.position, 1e-9);
  }
  checks.about("");
}

/** A slab of the thickness 10 under ten times the force has the same stress and ten times J. */
void check_thickness(Checks &checks) {
  const std::string scene =
    "Boundary/Contact = bottom\nBoundary/Plates = top: 0, -1 turning\n"
    "Contact/Foundation = parabola 0.4,0 normal 0,1 curvature 0.5\n"
    "Contact/Friction = tresca\nContact/Friction bound = 0.01\n"
    "Contact/Foundation shift = 0.01\nLoad cases/Cases = force 1 to 2 in 2 cases\n";
  const auto solve_for = [&](const double t) {
    const std::string factor = std::to_string(t) + "*";
    return solve(scene, levels(2, 4,
                               {"Geometry/Thickness=" + std::to_string(t),
                                "Load/Plate force=top: " + factor + "0.05",
                                "Load/Plate moment=top: " + factor + "0.001"}));
  };
  const LevelRecord thin = solve_for(1.).levels.back(), thick = solve_for(10.).levels.back();
  for (const char *column : {"energy", "contact_force_n", "tangential_force", "dissipation",
                             "plate_force", "plate_moment"})
    if (const std::optional<double> x = value(thin, column))
      checks.near(column, *value(thick, column) / *x, 10., 1e-8);
  for (const char *column : {"peak_pressure", "contact_length", "plate_travel", "plate_rotation",
                             "bound_relative", "largest_von_mises"})
    checks.near(column, *value(thick, column) / *value(thin, column), 1., 1e-8);
  checks.near("lower bound of J", thick.bound->energy_lower.value(),
              10. * thin.bound->energy_lower.value(), 1e-9);
  const auto force = [](const LevelRecord &level) { return level.answer.contact_force.resultant; };
  checks.near("force", force(thick).force.norm(), 10. * force(thin).force.norm(), 1e-9);
  checks.near("force on the plate", force(thick).force.at(1), 0.5, 1e-9);
  checks.near("moment", force(thick).moment.at(0), 10. * force(thin).moment.at(0), 1e-9);
}
} // namespace

int main(int argc, char *argv[]) {
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  check_ring(checks, {"Discretization/Strategy=hp", "Discretization/Target error=1e-6"}, 1e-4);
  check_ring(checks, levels(2, 5), 0.06);
  const std::string report = "right | 1,0.5 | 0.2,0.2 radius 0.3 | 0,0 to 2,1";
  check_block(checks, "", report);
  check_block(checks, "Discretization/Element = Q1 B-bar\n", report);
  check_block(checks, "Discretization/Element = Q2\n", report);
  check_space(checks);
  check_corner(checks);
  check_other_growth(checks);
  check_thickness(checks);
  return checks.exit_code();
}
