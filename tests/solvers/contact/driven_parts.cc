// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies that forces drive or that contact alone holds: closed forms, the same body driven by
// travel, shifted gaps, and loads that nothing balances.

#include <signorini/base/errors.h>

#include <iomanip>
#include <sstream>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** Own weight between rollers: p = -w for every E and nu, u = w ((1+nu)(1-2nu)/(E(1-nu)))
 * (y²/2 - y) - g. */
void test_column(Checks &checks) {
  const std::string text = "Constants/Values = E=7, nu=0.2, w=3\n"
                           "subsection Material\nset Young's modulus = E\nset Poisson's ratio = "
                           "nu\nend\n"
                           "Boundary/Rollers = left right\nBoundary/Contact = bottom\n"
                           "Load/Body force = 0; -w\n"
                           "Contact/Gap = 0.25\n";
  const OneLevel level(text, 3);
  const LevelSolution<2> solution = level.solve();
  for (const double p : solution.contact.P.normal())
    checks.near("column: p = -w", p, -3., 1e-10);
  // Nodal values of a problem in one dimension with a quadratic solution are exact.
  const double compliance = 3. * 1.2 * 0.6 / (7. * 0.8);
  const Displacement exact = nodal_values(level.space(), [&](const dealii::Point<2> &x) {
    return dealii::Tensor<1, 2>({0., compliance * (0.5 * x[1] * x[1] - x[1]) - 0.25});
  });
  // All of g is a mean over patches: the lowest node is where the mean says.
  checks.near("column: u", distance(solution.contact.U, exact), 0., 1e-10);
  checks.near("column: motion balance", solution.record.certificate.motion_balance, 0., 1e-10);
}

const std::string parabola = "0.5*(x-0.5)^2";

std::string pressed(const std::string &plate, const std::string &loads, const std::string &g) {
  return "Boundary/Contact = bottom\nBoundary/Plates = top: " + plate + "\n" + loads +
         "Contact/Gap = " + g;
}

std::string exactly(const double number) {
  std::ostringstream text;
  text << std::setprecision(17) << number;
  return text.str();
}

/** The travel that a force causes needs that force. */
void test_force_and_travel(Checks &checks) {
  const StudyResult<2> by_force =
    solve(pressed("0, -1", "Load/Plate force = top: 0.05\n", parabola));
  const PlateRecord &plate = by_force.levels.back().motions.plates.at(0);
  checks.near("force: the reaction is the force", plate.force, 0.05, 1e-12);
  const StudyResult<2> by_travel =
    solve(pressed("0, -1", "Load/Plate travel = top: " + exactly(plate.travel) + "\n", parabola));
  const PlateRecord &same = by_travel.levels.back().motions.plates.at(0);
  checks.near("travel: the force", same.force, 0.05, 1e-11);
  checks.near("force and travel: pressures",
              relative_distance(by_force.pressure.P, by_travel.pressure.P), 0., 1e-9);
  const double work = 0.05 * plate.travel;
  checks.near("force and travel: energies differ by the work",
              by_force.levels.back().certificate.energy,
              by_travel.levels.back().certificate.energy - work, 1e-12);
  const LevelRecord &finest = by_force.levels.back();
  checks.that("force: certified with a bound",
              by_force.verdict.outcome == Outcome::certified && finest.bound->energy_lower &&
                *finest.bound->energy_lower <= *finest.bound->energy_upper);
}

/** 0.5 (x - 0.4)² = 0.5 (x - 0.5)² + 0.1 (x - 0.5) + 0.005: the plate turns by -0.1 and travels by
 * 0.005 more, and nothing else changes. */
void test_turning(Checks &checks) {
  const std::string loads = "Load/Plate force = top: 0.05\n";
  const StudyResult<2> straight = solve(pressed("0, -1 turning", loads, parabola));
  const StudyResult<2> tilted = solve(pressed("0, -1 turning", loads, "0.5*(x-0.4)^2"));
  const PlateRecord &a = straight.levels.back().motions.plates.at(0);
  const PlateRecord &b = tilted.levels.back().motions.plates.at(0);
  checks.near("turning: symmetric", a.rotation[0], 0., 1e-10);
  checks.near("turning: rotation", b.rotation[0], -0.1, 1e-10);
  checks.near("turning: travel", b.travel - a.travel, 0.005, 1e-10);
  checks.near("turning: pressures", relative_distance(tilted.pressure.P, straight.pressure.P), 0.,
              1e-8);
}

/** A bar with nu = 0, clamped on the left and pulled on the right: travel = F l/(E A). */
void test_elastic_resistance(Checks &checks) {
  const StudyResult<2> result = solve(
    "subsection Geometry\nset Upper right = 3, 1\nset Cells = 3, 1\nend\nsubsection "
    "Material\nset Young's modulus = 5\nset Poisson's ratio = 0\nend\n"
    "Boundary/Clamped = left\nBoundary/Contact = bottom\nBoundary/Plates = right: 2, 0 turning\n"
    "Load/Plate force = right: 0.1\n"
    "Contact/Gap = 1\n",
    levels(1, 3));
  const PlateRecord &plate = result.levels.back().motions.plates.at(0);
  checks.near("bar: travel", plate.travel, 0.1 * 3. / 5., 1e-12);
  checks.near("bar: rotation", plate.rotation[0], 0., 1e-12);
  checks.near("bar: energy", result.levels.back().certificate.energy, -0.5 * 0.1 * 0.06, 1e-13);
}

/** A force with two components on a plate that moves in both: the direction of the plate only says
 * what they are called. */
void test_two_components(Checks &checks) {
  const std::string text =
    "subsection Geometry\nset Upper right = 3, 1\nset Cells = 3, 1\nend\n"
    "Boundary/Clamped = left\nBoundary/Contact = bottom\nContact/Gap = 0.01 + 0.4*(x-1.5)^2\n";
  const auto loads = [](const std::string &direction, const double force, const double across) {
    return "Boundary/Plates = right: " + direction +
           " turning\nLoad/Plate force = right: " + exactly(force) +
           "\nLoad/Plate cross force = right: " + exactly(across) + "\n";
  };
  const StudyResult<2> down = solve(text + loads("0, -1", 0.02, 0.01), levels(2, 5));
  const PlateRecord &plate = down.levels.back().motions.plates.at(0);
  checks.near("two components: reactions", {plate.force, plate.cross_force[0], plate.moment[0]},
              {0.02, 0.01, 0.}, 1e-12);
  // The direction (3, 4)/5 and across it (-4, 3)/5 for the force (0.01, -0.02).
  for (const auto &[direction, force, across] :
       {std::tuple("1, 0", 0.01, -0.02), {"3, 4", -0.01, -0.02}}) {
    const StudyResult<2> other = solve(text + loads(direction, force, across), levels(2, 5));
    const auto moved = [](const PlateRecord &record) {
      const AnswerVector &d = record.direction;
      return record.travel * dealii::Tensor<1, 2>({d[0], d[1]}) +
             record.drift[0] * dealii::Tensor<1, 2>({-d[1], d[0]});
    };
    checks.near(std::string("two components along ") + direction,
                (moved(other.levels.back().motions.plates.at(0)) - moved(plate)).norm(), 0., 1e-12);
    checks.near("two components: pressures", relative_distance(other.pressure.P, down.pressure.P),
                0., 1e-9);
  }
  const LevelRecord graded =
    solve(text + loads("0, -1", 0.02, 0.01),
          {"Discretization/Strategy=hp", "Discretization/Target error=1e-4"})
      .levels.back();
  const ErrorBound &bound = *down.levels.back().bound;
  checks.between("two components: energy of a finer run", graded.certificate.energy,
                 *bound.energy_lower, *bound.energy_upper);
  checks.near("two components: drift of a finer run", plate.drift[0],
              graded.motions.plates.at(0).drift[0], 2e-3 * plate.drift[0]);
}

/** Fretting by force: friction holds T up to f N, at every step of a cycle. */
void test_fretting_by_force(Checks &checks) {
  const std::string block = "Boundary/Contact = bottom\nBoundary/Plates = top: 0, -1\n"
                            "Contact/Friction = coulomb\nContact/Friction coefficient = 0.5\n"
                            "Load/Plate force = top: 0.02\nLoad/Plate cross force = top: T\n";
  const LevelRecord held = solve("Constants/Values = T=0.006\n" + block).levels.back();
  checks.near("fretting: friction carries the force", std::abs(held.tangential->tangential_force),
              0.006, 1e-10);
  checks.near("fretting: its share", held.tangential->carried_share, 0.6, 1e-8);
  checks.throws<InputError>("more than f N", "slides",
                            [&]() { solve("Constants/Values = T=0.0101\n" + block); });
}

/** The resultant of the pressure is that of the loads: F at the distance M/F from the middle. */
void test_moment(Checks &checks) {
  const std::string loads = "Load/Plate force = top: 2\nLoad/Plate moment = top: 0\n";
  const auto with_moment = [&](const std::string &moment, const std::string &coarsest = "2") {
    return solve(pressed("0, -1 turning", loads, "0"),
                 {"Load/Plate moment=top: " + moment, "Discretization/Coarsest level=" + coarsest});
  };
  checks.throws<InputError>("moment on a coarse mesh", "a finer coarsest level",
                            [&]() { with_moment("0.6"); });
  const LevelRecord record = with_moment("0.6", "4").levels.back();
  checks.near("moment: force", record.answer.contact_force.resultant.force[1], 2., 1e-10);
  // About (0.5, 0): the plate turns the body counter-clockwise, the foundation clockwise.
  const SideForce::Total &contact = record.answer.contact_force.resultant;
  checks.near("moment: contact moment", contact.moment[0] - 0.5 * contact.force[1], -0.6, 1e-10);
  checks.that("moment: part of the side has lifted",
              record.contact.active < record.sizes.multipliers);
  checks.throws<InputError>("moment beyond the edge", "it tips over",
                            [&]() { with_moment("1.1"); });
  checks.throws<InputError>("moment beyond the other edge", "it tips over",
                            [&]() { with_moment("-1.1"); });
}

/** A lever turns about the centre of its bore and presses on a stop: the moments balance there. */
void test_bore(Checks &checks) {
  for (const std::string hole : {"circle 0,0,4", "-3,-4; 3,-4; 3,4; -3,4"}) {
    const StudyResult<2> lever =
      solve("subsection Geometry\nset Shape = polygon\nset Vertices = -12,-6; 70,-6; 70,6; -12,6\n"
            "set Holes = " +
              hole +
              "\nend\nBoundary/Contact = side0\nBoundary/Plates = hole0: 0, -1 turning\n"
              "subsection Load\nset Plate travel = hole0: 0\nset Plate moment = hole0: -0.2\nend\n"
              "Contact/Foundation = circle 60,-16 radius 10\n",
            levels(1, 2));
    const LevelRecord &record = lever.levels.back();
    const SideForce::Total &contact = record.answer.contact_force.resultant;
    checks.about("a bore, " + hole);
    checks.near("its centre", record.motions.plates.at(0).centre.norm(), 0., 1e-14);
    // The edges of a round hole bend: there nodes turn rigidly, and not the edges between them.
    checks.near("moment of the contact", contact.moment[0], 0.2, 1e-3);
  }
  checks.about("");
}

void test_escapes(Checks &checks) {
  checks.throws<InputError>("upwards", "along (0, 1), and no pressure", [&]() {
    solve(pressed("0, -1", "Load/Plate force = top: -1\n", "0"));
  });
  const std::string block = "Boundary/Contact = bottom\nBoundary/Traction = right: T; 0\n"
                            "Load/Body force = 0; -1\n";
  checks.throws<InputError>("sideways", "the loads drive the translation along (1, 0) of the body",
                            [&]() { solve("Constants/Values = T=-0.01\n" + block); });
  const StudyResult<2> still = solve("Constants/Values = T=0\n" + block);
  const std::vector<std::string> &undetermined = still.levels.back().motions.undetermined;
  checks.that("at rest: sliding is undetermined, and said so",
              undetermined == std::vector<std::string>{"the translation along (1, 0)"} &&
                still.verdict.outcome == Outcome::certified);
  checks.throws<InputError>("no load", "no load presses it onto the foundation",
                            [&]() { solve("Boundary/Contact = bottom\n"); });
}

/** Lengths times 1e3 and moduli times 1e9: the same answer in other units. */
void test_units(Checks &checks) {
  const auto in_units = [](const std::string &L, const std::string &E, const std::string &solver) {
    return solve("subsection Geometry\nset Upper right = " + L + ", " + L + "\nend\n" +
                   entry("Constants", "Values", "L=" + L) +
                   entry("Material", "Young's modulus", E) +
                   "Boundary/Contact = bottom\nBoundary/Plates = top: 0, -1 turning\n"
                   "Load/Plate force = top: 1\nLoad/Plate moment = top: 0\n"
                   "Contact/Gap = 0.5*L*(x/L-0.4)^2\n",
                 {"Load/Plate force=top: " + std::to_string(0.05 * std::stod(L) * std::stod(E)),
                  "Solver/Contact solver=" + solver})
      .levels.back();
  };
  for (const std::string solver : {"active set", "psor"}) {
    checks.about("units, " + solver);
    const LevelRecord a = in_units("1", "1", solver), b = in_units("1e3", "1e9", solver);
    const PlateRecord &first = a.motions.plates.at(0), &second = b.motions.plates.at(0);
    checks.that("iterations", a.dual.iterations == b.dual.iterations);
    checks.near("travel", second.travel / first.travel, 1e3, 1e-6);
    checks.near("rotation", second.rotation[0] / first.rotation[0], 1., 1e-9);
  }
}

/** A cantilever whose tip a force presses onto a parabola: the exact energy lies between the bounds
 * of all meshes, small ones, too. */
void test_bounds(Checks &checks) {
  const std::string text =
    "subsection Geometry\nset Upper right = 3, 1\nset Cells = 3, 1\nend\n"
    "Boundary/Clamped = left\nBoundary/Contact = bottom\nBoundary/Plates = right: 0, -1 turning\n"
    "Load/Plate force = right: 0.02\n"
    "Contact/Gap = 0.01 + 0.4*(x-1.5)^2\n";
  const LevelRecord graded =
    solve(text, {"Discretization/Strategy=hp", "Discretization/Target error=1e-4"}).levels.back();
  for (const unsigned int level : {1, 2, 3, 4}) {
    const LevelRecord nested = solve(text, levels(level, level)).levels.back();
    checks.between("cantilever, level " + std::to_string(level) + ": energy",
                   graded.certificate.energy, *nested.bound->energy_lower,
                   *nested.bound->energy_upper);
    if (level == 4)
      checks.near("cantilever: travel",
                  nested.motions.plates.at(0).travel / graded.motions.plates.at(0).travel, 1.,
                  1e-2);
  }
}

/** A disc on a table, held by its weight alone: its force is pi R² w, and it may roll. */
void test_roller(Checks &checks) {
  const std::string text = "subsection Geometry\nset Shape = disc\nset Centre = 0, 1\nend\n"
                           "Boundary/Contact = arc\n"
                           "Load/Body force = 0; -0.01\n"
                           "Contact/Foundation = plane 0,0 normal 0,1\n";
  const double pi = std::acos(-1.);
  for (const bool is_graded : {false, true}) {
    checks.about(is_graded ? "roller, hp" : "roller");
    const StudyResult<2> result =
      solve(text, is_graded ? std::vector<std::string>{"Discretization/Strategy=hp",
                                                       "Discretization/Target error=1e-3"}
                            : levels(3, 5));
    const LevelRecord &finest = result.levels.back();
    const SideForce &contact = finest.answer.contact_force;
    checks.near("force / weight", contact.resultant.force[1] / (0.01 * pi), 1.,
                is_graded ? 1e-6 : 1e-2);
    checks.near("through its axis", (*contact.through)[0], 0., 1e-6);
    checks.near("symmetric zone",
                finest.answer.zones.at(0).start.at.point[0] +
                  finest.answer.zones.at(0).end.at.point[0],
                0., is_graded ? 1e-3 : 1e-7);
  }
}

/** A ring on a shaft that is larger by delta: Lame's p = delta E'/((b² + a²)/(b² - a²) + nu') for
 * a = 1, b = 2; a shaft beside the centre moves the ring there. */
void test_interference(Checks &checks) {
  const auto fit = [](const std::string &g) {
    return solve(
      "subsection Geometry\nset Shape = ring\nset Inner radius = 1\nset Radius = 2\nend\n"
      "subsection Material\nset Young's modulus = 1\nset Poisson's ratio = 0.3\n"
      "set Plane state = stress\nend\n"
      "Boundary/Contact = inner\nContact/Gap = " +
        g,
      levels(2, 3));
  };
  const StudyResult<2> ring = fit("-0.001");
  const double pressure = 0.001 / (5. / 3. + 0.3);
  for (const double p : ring.pressure.P)
    checks.near("interference: pressure", p, -pressure, 3e-3 * pressure);
  checks.that("interference: verdict", ring.verdict.is_certified());
  const StudyResult<2> moved = fit("-0.001 - 0.0005*x");
  checks.near("interference: beside the centre",
              relative_distance(moved.pressure.P, ring.pressure.P), 0., 1e-8);
  checks.throws<InputError>("interference that lifts the body off",
                            "leaves the translation along (0, 1) free", [&]() {
                              solve("Boundary/Contact = bottom\n"
                                    "Contact/Gap = -0.001\n");
                            });
}

/** A ring that rolls on one side, with its weight 0.01 pi (1 - 1/4): no load and no contact resists
 * its rotation, which bilinear elements on curved cells lack. No node may take a part of the loads
 * in its place. */
void test_rotation_of_a_ring(Checks &checks) {
  const double weight = 0.01 * 0.75 * std::acos(-1.);
  checks.about("ring that sticks");
  const double gap = 0.001;
  const StudyResult<2> sticking =
    solve("Geometry/Shape = ring\nBoundary/Rollers = inner\nBoundary/Contact = outer\n"
          "Load/Body force = 0; -0.01\nContact/Friction = tresca\nContact/Friction bound = 1e3\n" +
            entry("Contact", "Gap", std::to_string(gap)),
          levels(2, 3));
  checks.that("verdict", sticking.verdict.outcome == Outcome::equations_certified);
  const Answer &stuck = sticking.levels.back().answer;
  checks.near("weight",
              stuck.contact_force.resultant.force[1] + stuck.reactions.at(0).resultant.force[1],
              weight, 1e-3 * weight);
  for (const std::string rollers : {"inner", "outer"})
    for (const std::string centre : {"0, 0", "0.1, 0.2"}) {
      checks.about("ring, rollers " + rollers);
      const StudyResult<2> result =
        solve("Geometry/Shape = ring\n" + entry("Geometry", "Centre", centre) +
                entry("Boundary", "Rollers", rollers) +
                entry("Boundary", "Contact", rollers == "inner" ? "outer" : "inner") +
                "Load/Body force = 0; -0.01\nContact/Gap = 0.5\n",
              levels(2, 3));
      for (const LevelRecord &record : result.levels)
        checks.near("balance of forces", record.certificate.force_balance, 0., 1e-12);
      const LevelRecord &finest = result.levels.back();
      checks.near("reaction", finest.answer.reactions.at(0).resultant.force[1], weight,
                  1e-4 * weight);
      checks.that("undetermined", finest.motions.undetermined.size() == 1);
    }
}

/** Loads in balance on bodies without supports: a tension test on a table, sigma_xx = T, in
 * which the body grows into the table or shrinks, and pressure q in a ring, by Lame J = -pi q² a²
 * (a² (1 - 2 nu) + b²)(1 + nu) / (b² - a²). */
void test_loads_in_balance(Checks &checks) {
  for (const double T : {0.01, -0.01})
    for (const double nu : {0., 0.3}) {
      checks.about(T > 0. ? "tension" : "compression");
      const StudyResult<2> bar =
        solve("Boundary/Contact = bottom\nMaterial/Poisson's ratio = " + std::to_string(nu) +
                "\nBoundary/Traction = left: " + std::to_string(-T) +
                "; 0 | right: " + std::to_string(T) + "; 0\nContact/Gap = 0\n",
              levels(2, 3));
      checks.that("certified", bar.verdict.outcome == Outcome::certified);
      checks.near("no force", bar.levels.back().contact.normal_force, 0., nu > 0. ? 1e-15 : 0.);
      checks.near("energy", bar.levels.back().certificate.energy, -0.5e-4 * (1. - nu * nu), 1e-14);
    }
  checks.about("pressure in a ring");
  const StudyResult<2> ring =
    solve("Geometry/Shape = ring\nBoundary/Contact = outer\nContact/Gap = 0.5\n"
          "Boundary/Traction = inner: 0.02*x; 0.02*y\n",
          levels(3, 4));
  checks.that("certified", ring.verdict.is_certified());
  const double energy = -std::acos(-1.) * 1e-4 * 0.25 * (0.25 * 0.4 + 1.) * 1.3 / 0.75;
  checks.near("energy", ring.levels.back().certificate.energy / energy, 1., 2e-3);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {test_column, test_force_and_travel, test_turning, test_elastic_resistance,
                    test_two_components, test_fretting_by_force, test_moment, test_bore,
                    test_escapes, test_units, test_bounds, test_roller, test_interference,
                    test_rotation_of_a_ring, test_loads_in_balance});
}
