// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes of prm/bodies whose sides are in several pairs: balances, closed forms, twins, and the
// force and peak of each zone.

#include <signorini/postprocessing/quantities/answer.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "graded_steps.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
const std::string scenes = SOURCE_DIR "/prm/bodies/";

StudyResult<2> solve_graded(const std::string &name, const std::string &target,
                            std::vector<std::string> more = {}, const std::string &folder = "") {
  more.insert(more.end(),
              {"Discretization/Strategy=hp", "Discretization/Target error=" + target,
               "Discretization/Coarsest level=" + std::string(name == "bearing.prm" ? "0" : "1"),
               "Output/VTU=none"});
  return solve_file(scenes + name, more, folder);
}

double vertical(const ContactForce &force) {
  return force.resultant.force[1];
}

/** Two walls and a ring: two zones with their own forces and peaks. By symmetry each half is one
 * roller on one wall, and steel walls are nearly rigid ones. */
void test_o_ring(Checks &checks) {
  const Answer answer = solve_graded("o_ring.prm", "1e-3").levels.back().answer;
  checks.that("two zones", answer.zones.size() == 2 && answer.zone_forces.size() == 2);
  checks.near("their forces",
              vertical(answer.zone_forces.at(0)) / vertical(answer.zone_forces.at(1)), -1., 1e-8);
  for (const ContactForce &zone : answer.zone_forces) {
    checks.that("a zone of the ring", zone.side == "ring.arc" && zone.peak.has_value());
    checks.near("  its peak lies on the axis", zone.peak->at.point[0], 0., 1e-2);
    checks.near("  and is that of all", zone.peak->value / answer.peak_pressure->value, 1., 2e-4);
    checks.near("  its line of action", (*zone.through)[0], 0., 1e-8);
  }
  checks.that("partners", answer.zone_forces[0].other == "lid.bottom" &&
                            answer.zone_forces[1].other == "seat.top");
  const StudyResult<2> rigid = solve(
    "Geometry/Shape = half disc\nMaterial/Young's modulus = 5\nMaterial/Poisson's ratio = 0.48\n"
    "Boundary/Contact = arc\nBoundary/Rollers = flat\n"
    "Contact/Foundation = plane 0,-0.95 normal 0,1\n",
    graded("1e-3"));
  checks.near("between rigid walls",
              std::abs(vertical(answer.zone_forces[1])) / last(rigid, "contact_force_n"), 1., 0.02);
}

/** Three rollers between two rings, each a disc in two pairs. The forces on the inner ring carry
 * the load, both on each roller cancel, and each peak is that of Hertz. */
void test_bearing(Checks &checks) {
  const Answer answer = solve_graded("bearing.prm", "1e-2").levels.back().answer;
  checks.that("six pairs", answer.contact_by_side.size() == 12);
  const double modulus = 210000. / (2. * 0.91);
  double load = 0.;
  for (std::size_t i = 0; i < answer.contact_by_side.size(); i += 2) {
    const ContactForce &on_ring = answer.contact_by_side[i];
    checks.about(on_ring.side + " with " + on_ring.other);
    const bool is_inner = on_ring.side == "inner.side0";
    const double N = on_ring.resultant.force.norm(),
                 R = 1. / (1. / 5. + (is_inner ? 1. / 20. : -1. / 30.));
    checks.near("Hertz", on_ring.peak->value / std::sqrt(N * modulus / (PI * R)), 1., 0.02);
    load += is_inner ? vertical(on_ring) : 0.;
    for (std::size_t j = 0; is_inner && j < answer.contact_by_side.size(); j += 2)
      if (const ContactForce &other = answer.contact_by_side[j];
          other.side == "outer.side2" && other.other == on_ring.other)
        checks.near("the roller is in balance", N / other.resultant.force.norm(), 1., 1e-3);
  }
  checks.about("");
  checks.near("the load", load, 1000., 1e-6);
  checks.near("left and right", answer.contact_by_side[0].resultant.force.norm(),
              answer.contact_by_side[4].resultant.force.norm(), 1.);
}

/** A foot on a table: '*' finds what names give. Flat and round parts carry the weight together. */
void test_foot(Checks &checks) {
  const auto forces = [](const std::string &contact) {
    std::vector<double> all;
    const Answer answer = solve_graded("foot_on_table.prm", "1e-2", {"Boundary/Contact=" + contact})
                            .levels.back()
                            .answer;
    for (std::size_t i = 0; i < answer.contact_by_side.size(); i += 2)
      all.push_back(vertical(answer.contact_by_side[i]));
    return all;
  };
  const std::vector<double> found = forces("table.top with *");
  checks.near("named", forces("table.top with foot.fillet0 foot.side0 foot.fillet1"), found, 1e-12);
  checks.that("three parts", found.size() == 3);
  checks.near("their sum", found[0] + found[1] + found[2], -0.01, 1e-9);
  checks.near("both fillets", found[0] / found[2], 1., 1e-3);
}

/** contacts.csv has a row for each contact and each zone. */
void test_table(Checks &checks) {
  std::filesystem::create_directories("results");
  solve_graded("o_ring.prm", "1e-2", {}, "results");
  std::ifstream file("results/contacts.csv");
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);)
    lines.push_back(line);
  checks.that("a head, two contacts, two zones", lines.size() == 5);
  for (const std::size_t row : {1, 3}) {
    const std::string other = row == 1 ? "lid.bottom" : "seat.top";
    checks.that("contact", lines.at(row).rfind("ring.arc," + other + ",,", 0) == 0);
    checks.that("its zone", lines.at(row + 1).rfind("ring.arc," + other + ",1,", 0) == 0);
    // One zone has the force of its contact.
    const auto force = [](const std::string &line) {
      std::istringstream fields(line);
      std::string field;
      for (unsigned int i = 0; i < 8; ++i)
        std::getline(fields, field, ',');
      return std::stod(field);
    };
    checks.near("its force", force(lines[row + 1]) / force(lines[row]), 1., 1e-12);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_o_ring, test_bearing, test_foot, test_table});
}
