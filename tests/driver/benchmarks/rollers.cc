// SPDX-License-Identifier: LGPL-2.1-or-later
// Hertz' line contact by force, in several units, and on a mesh file. The differences from Hertz
// are of second order in a/R; along the normals of the body the formulas of doc/formulas.md to
// first order in p0/E come first.

#include <deal.II/base/numbers.h>

#include <cmath>

#include "benchmarks.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
struct Roller {
  double R, E, nu, force;
  bool along_normals = false;

  /** 4 P' R/(pi E*) = a^2. */
  double half_width() const {
    return std::sqrt(4. * force * R * (1. - nu * nu) / (PI * E));
  }
  double peak() const {
    return 2. * force / (PI * half_width());
  }
  /** beta p0 with beta = (1 - 2 nu)(1 + nu)/E, along the normals of the body. */
  double tilt() const {
    return along_normals ? (1. - 2. * nu) * (1. + nu) / E * peak() : 0.;
  }
};

constexpr double catalan = 0.915965594177219;

/** The relative differences less those of first order. */
struct Rest {
  double zone, peak, uncertainty;
};

Rest compare(Checks &checks, const std::string &name, const StudyResult<2> &result,
             const Roller &roller) {
  const LevelRecord &last = result.levels.back();
  checks.that(name + ", the accuracy is reached", result.verdict.outcome == Outcome::certified);
  checks.that(name + ", one zone", last.answer.zones.size() == 1);
  checks.near(name + ", force", last.answer.contact_force.resultant.force[1] / roller.force, 1.,
              1e-9);
  const ContactZone &zone = last.answer.zones.at(0);
  const double a = roller.half_width();
  const Rest rest = {zone.length / (2. * a) - 1. + 4. / (3. * PI) * roller.tilt(),
                     last.answer.peak_pressure->value / roller.peak() - 1. -
                       (2. * catalan - 1. / 3.) / PI * roller.tilt(),
                     zone.end.uncertainty / a};
  const double second_order = std::pow(a / roller.R, 2);
  checks.between(name + ", zone", rest.zone / second_order, -0.6 - rest.uncertainty / second_order,
                 0.);
  checks.between(name + ", peak", rest.peak / second_order, 0.3, 0.45);
  return rest;
}

Rest press(Checks &checks, const double nu, const double force, const bool along_normals = false) {
  const std::string F = std::to_string(force), ratio = std::to_string(nu),
                    direction = along_normals ? "body" : "foundation";
  return compare(
    checks, "nu " + ratio + ", force " + F + ", direction of the " + direction,
    run_benchmark("hertz_line", {"Load/Plate force=flat: " + F, "Material/Poisson's ratio=" + ratio,
                                 "Contact/Direction=" + direction}),
    {8., 200., nu, force, along_normals});
}

void test_scaling(Checks &checks) {
  for (const double force : checks.rows<double>({40., 10.}, 1)) {
    const Rest large = press(checks, 0.3, force), small = press(checks, 0.3, force / 16.);
    checks.near("order of what is left, in a/R", std::log(large.peak / small.peak) / std::log(4.),
                2., 0.05);
  }
  press(checks, 0., 10., true);
}

/** The published numbers of the benchmark, for a block of aluminium and for a rigid one. */
void test_nafems(Checks &checks) {
  const Roller rigid{50., 210000., 0.3, 35000.}, aluminium{50., 52500., 0.3, 35000.};
  checks.near("NAFEMS, half width", aluminium.half_width(), 6.21, 0.005);
  checks.near("NAFEMS, peak", aluminium.peak(), 3585.37, 0.01);
  checks.near("NAFEMS, half width on a rigid block", rigid.half_width(), 3.1073, 0.5e-4);
  checks.near("NAFEMS, peak on a rigid block", rigid.peak(), 7170.7, 0.05);
  compare(checks, "NAFEMS on a rigid block", run_benchmark("nafems_cgs1"), rigid);
  compare(checks, "NAFEMS with the common modulus",
          run_benchmark("nafems_cgs1", {"Material/Young's modulus=52500"}), aluminium);
}

void test_mesh_file(Checks &checks) {
  compare(checks, "mesh file", run_benchmark("hertz_mesh_file"), {1., 1., 0.3, 0.00625});
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_scaling, test_nafems, test_mesh_file});
}
