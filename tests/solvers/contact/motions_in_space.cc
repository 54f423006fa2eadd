// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies in space that forces drive or that contact alone holds: statics, slabs against the same
// bodies in the plane, and loads that nothing balances.

#include <signorini/base/errors.h>
#include <signorini/postprocessing/quantities/case_solver.h>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
using Entries = std::vector<std::string>;

void check_certificate(Checks &checks, const LevelRecord &record) {
  checks.near("KKT residual", record.dual.kkt, 0., 1e-11);
  checks.near("balance of motions", record.certificate.motion_balance, 0., 1e-10);
  checks.near("balance of forces", record.certificate.force_balance, 0., 1e-10);
  checks.near("balance of moments", record.certificate.moment_balance, 0., 1e-10);
}

/** A block of own weight with a load that grows along x: contact carries both, force and moment.
 * Sliding and turning on the plane are not determined. */
void test_block(Checks &checks) {
  const std::string block = "Geometry/Upper right = 3, 2, 1\nGeometry/Cells = 3, 2, 1\n"
                            "Boundary/Contact = bottom\nBoundary/Traction = top: 0; 0; -0.2*x\n"
                            "Load/Body force = 0; 0; -1\nContact/Gap = 0\n";
  for (const std::string solver : {"automatic", "multigrid"}) {
    checks.about("block, " + solver);
    const SolvedBox level(block, 2, {"Solver/Linear solver=" + solver});
    const LevelRecord &record = level.found.record;
    const SideForce::Total &contact = record.answer.contact_force.resultant;
    checks.near("force", contact.force, {0., 0., 7.8}, 1e-10);
    checks.near("moment", contact.moment, {7.8, -12.6, 0.}, 1e-10);
    checks.that("undetermined",
                record.motions.undetermined ==
                  Entries{"the translation along (1, 0, 0)", "the translation along (0, 1, 0)",
                          "the rotation about the line through (1.5, 1, 0.5) along (0, 0, 1)"});
    check_certificate(checks, record);
  }
  checks.about("");
}

/** A plate that a force and moments drive: contact carries them. The load case is the same scene
 * with twice the loads. */
void test_plate(Checks &checks) {
  const auto text = [](const double factor) {
    const auto times = [factor](const double x) { return std::to_string(factor * x); };
    return "Geometry/Cells = 2, 2, 2\nBoundary/Contact = bottom\n"
           "Boundary/Plates = top: 0, 0, -2 turning\nLoad/Plate force = top: " +
           times(0.05) + "\nLoad/Plate moment = top: " + times(0.002) + ", " + times(-0.003) +
           ", 0\nContact/Gap = 0.1*((x-0.4)^2+(y-0.5)^2)\n";
  };
  const SolvedBox level(text(1.) + "Load cases/Cases = force 2\n", 2);
  const auto check_forces = [&](const SideForce::Total &contact, const double factor) {
    // About the middle of the plate.
    const dealii::Tensor<1, 3> F({contact.force[0], contact.force[1], contact.force[2]}),
      M = dealii::Tensor<1, 3>({contact.moment[0], contact.moment[1], contact.moment[2]}) -
          cross_product_3d(dealii::Tensor<1, 3>({0.5, 0.5, 1.}), F);
    checks.near("force of contact", contact.force, {0., 0., 0.05 * factor}, 1e-11);
    checks.near("its moment", {M[0], M[1], M[2]}, {-0.002 * factor, 0.003 * factor, 0.}, 1e-11);
  };
  const LevelRecord &record = level.found.record;
  check_forces(record.answer.contact_force.resultant, 1.);
  const PlateRecord &plate = record.motions.plates.at(0);
  checks.near("force on the plate", plate.force, 0.05, 1e-11);
  checks.near("moment on it", plate.moment, {0.002, -0.003, 0.}, 1e-11);
  checks.that("undetermined", record.motions.undetermined ==
                                Entries{"the rotation about the line through (0.5, 0.5, 0.5) "
                                        "along (0, 0, 1)"});
  check_certificate(checks, record);
  CaseSolver<3> solver(level.discretization, level.scene, *level.found.operators, {});
  const CaseResult found = solver.solve(level.scene.load_cases.at(0));
  check_forces(found.contact, 2.);
  const PlateRecord twice = SolvedBox(text(2.), 2).found.record.motions.plates.at(0);
  checks.near("load case: travel", found.plates.at(0).travel, twice.travel, 1e-10);
  checks.near("load case: rotation", found.plates.at(0).rotation, twice.rotation, 1e-10);
}

/** Slabs between rollers are bodies in plane strain, of which each layer carries its share. */
void test_slabs(Checks &checks) {
  struct Slab {
    std::string plane, space;
  };
  for (const auto &[plane, space] :
       {Slab{"Boundary/Traction = top: 0; -0.1*x\nLoad/Body force = 0; -0.01\n",
             "Boundary/Traction = top: 0; 0; -0.1*x\nLoad/Body force = 0; 0; -0.01\n"},
        Slab{"Boundary/Plates = top: 0, -1\nLoad/Plate force = top: 0.02\n",
             "Boundary/Plates = top: 0, 0, -1\nLoad/Plate force = top: 0.01\n"}}) {
    const std::string gap = "Boundary/Contact = bottom\nContact/Gap = 0.05*(x-0.4)^2\n";
    const OneLevel flat(gap + "Geometry/Cells = 2, 2\n" + plane, 2);
    const LevelSolution<2> expected = flat.solve();
    const SolvedBox slab(gap +
                           "Geometry/Upper right = 1, 0.5, 1\nGeometry/Cells = 2, 1, 2\n"
                           "Boundary/Rollers = front back\n" +
                           space,
                         2);
    const LevelRecord &record = slab.found.record;
    const auto &force = expected.record.answer.contact_force.resultant;
    const auto &found = record.answer.contact_force.resultant;
    checks.near("slab: force and moment", {found.force[0], found.force[2], found.moment[1]},
                {0.5 * force.force[0], 0.5 * force.force[1], -0.5 * force.moment[0]}, 1e-11);
    checks.near("slab: energy", record.certificate.energy, 0.5 * expected.record.certificate.energy,
                1e-11);
    checks.near("slab: pressure", record.contact.max_pressure, expected.record.contact.max_pressure,
                1e-9);
    if (!record.motions.plates.empty())
      checks.near("slab: travel", record.motions.plates[0].travel,
                  expected.record.motions.plates.at(0).travel, 1e-10);
    check_certificate(checks, record);
  }
}

void test_escapes(Checks &checks) {
  const std::string block =
    "Geometry/Cells = 2, 2, 2\nBoundary/Contact = bottom\nContact/Gap = 0\n";
  struct Escape {
    std::string loads, words;
  };
  const std::string weight = "Load/Body force = 0; 0; -1\n";
  for (const auto &[loads, words] :
       {Escape{"Load/Body force = 0; 0; 1\n", "along (0, 0, 1), and no pressure of the foundation "
                                              "balances them (it lifts off)"},
        {"Load/Body force = 0.1; 0; -1\n", "the loads drive the translation along (1, 0, 0)"},
        {weight + "Boundary/Traction = right: 0; 1; 0 | left: 0; -1; 0\n",
         "the loads drive the rotation about the line through (0.5, 0.5, 0.5) along (0, 0, 1)"},
        {weight + "Boundary/Traction = right: 0; 0; 9 | left: 0; 0; -9\n", "(it tips over)"},
        {"Boundary/Plates = top: 0, 0, -1\nLoad/Plate force = top: 0.1\n"
         "Load/Plate cross force = top: 0, 1, 1\n",
         "allowed: a vector at right angles to its direction (0, 0, -1)"},
        {"Boundary/Plates = top: 0, 0, -1 turning\nLoad/Plate force = top: 0.1\n"
         "Load/Plate moment = top: 0.1\n",
         "allowed: a vector x, y, z up to"},
        {"Boundary/Plates = top: 0, -1\nLoad/Plate force = top: 0.1\n",
         "allowed: a direction dx, dy, dz"}})
    checks.throws<InputError>(words, words, [&, &loads = loads]() { SolvedBox(block + loads, 1); });
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_block, test_plate, test_slabs, test_escapes});
}
