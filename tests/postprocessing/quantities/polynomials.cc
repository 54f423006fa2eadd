// SPDX-License-Identifier: LGPL-2.1-or-later
// Peak pressure, contact zones and contact forces of pressures that are polynomials on patches, and
// those of scene B1 on graded meshes, where p = -(xi - x)_+^{1/2}, xi = 2^{-1/2}.

#include <signorini/postprocessing/fields/contact_intervals.h>
#include <signorini/postprocessing/quantities/contact_zones.h>
#include <signorini/postprocessing/quantities/peak_pressure.h>
#include <signorini/postprocessing/quantities/side_forces.h>

#include <cmath>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** A scene on a uniform mesh with n multipliers on every contact face. */
class Polynomials {
public:
  Polynomials(const std::string &text, const unsigned int level, const unsigned int n)
    : level_(text, level)
    , surface(mesh(), level_.scene,
              std::vector<unsigned int>(mesh().triangulation().n_active_cells(), n + 1))
    , multipliers(surface, std::vector<unsigned int>(surface.patches().size(), n)) {}

  /** The values of a function of the arc length at the nodes. */
  template <typename Function>
  Pressure values(const Function &p) const {
    Pressure P(multipliers.n_multipliers());
    for (unsigned int k = 0; k < P.size(); ++k)
      P[k] = p(multipliers.node(k)[0]);
    return P;
  }
  const Scene<2> &scene() const {
    return level_.scene;
  }

private:
  const Mesh<2> &mesh() const {
    return level_.discretization.mesh;
  }
  OneLevel level_;

public:
  const ContactSurface<2> surface;
  const MultiplierSpace<2> multipliers;
};

/** The unit square with contact at the bottom and so many faces along it. */
std::string square(const unsigned int faces) {
  return "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" +
         entry("Geometry", "Cells", std::to_string(faces) + ", 2");
}

void peak(Checks &checks) {
  const Polynomials coarse(square(3), 0, 5);
  const auto of = [](const Polynomials &where, const Pressure &P) {
    return *peak_pressure(where.multipliers, P);
  };
  // -p = x (1 - x)^3 has the maximum 27/256 at 1/4, on the face from 0 to 1/3.
  const PressureMaximum inner =
    of(coarse, coarse.values([](const double x) { return -x * std::pow(1. - x, 3); }));
  checks.near("a polynomial of degree four", inner.value, 27. / 256., 1e-15);
  checks.near("its place", inner.at.point[0], 0.25, 1e-7);
  const auto primitive = [](const double x) {
    return -std::pow(1. - x, 4) / 4. + std::pow(1. - x, 5) / 5.;
  };
  checks.near("mean of its patch", inner.mean, 3. * (primitive(1. / 3.) - primitive(0.)), 1e-15);
  const PressureMaximum end = of(coarse, coarse.values([](const double x) { return x - 2.; }));
  checks.near("peak at the end of a side", end.value, 2., 1e-14);
  checks.near("there", end.at.point[0], 0., 1e-15);
  // -p = 1 + t^2 (1 - t^2) on both faces, -1 <= t <= 1, with four equal peaks at t^2 = 1/2.
  const Polynomials swinging(square(2), 0, 8);
  const PressureMaximum first = of(swinging, swinging.values([](const double x) {
    const double t = 4. * x - (x < 0.5 ? 1. : 3.);
    return -(1. + t * t * (1. - t * t));
  }));
  checks.near("equal peaks", first.value, 1.25, 1e-14);
  checks.near("the first of them", first.at.point[0], 0.25 * (1. - std::sqrt(0.5)), 1e-7);
  checks.that("no pressure, no peak",
              !peak_pressure(coarse.multipliers, Pressure(coarse.multipliers.n_multipliers())));
}

/** Which nodes of a row press, as a text: "PPO". @return start, end and uncertainties. */
std::vector<double> intervals(const Polynomials &where, const std::string &pressing) {
  Pressure P(where.multipliers.n_multipliers());
  for (unsigned int k = 0; k < P.size(); ++k)
    P[k] = pressing.at(k) == 'P' ? -1. : 0.;
  std::vector<double> found;
  for (const PressedInterval &zone : pressed_intervals(where.multipliers, Multiplier(P).states()))
    found.insert(found.end(),
                 {zone.start.s, zone.start.uncertainty, zone.end.s, zone.end.uncertainty});
  return found;
}

void zones(Checks &checks) {
  // Gauss nodes of two faces: their middles, and (3/5)^{1/2} of half a face away from there.
  const Polynomials where(square(2), 0, 3);
  const double r = 0.25 * std::sqrt(0.6), inner = 0.5 * r, outer = 0.25 - r;
  // The middles of neighbours, and of the nodes around a lone one.
  const double a = 0.25 - inner, b = 0.25 + inner, c = 0.5, d = 0.75 - inner, e = 0.75 + inner,
               alternating = 0.5 * (0.25 + 0.75);
  for (const auto &[pressing, expected] : std::vector<std::pair<std::string, std::vector<double>>>{
         {"OOOOOO", {}},
         {"PPPPPP", {0., 0., 1., 0.}},
         {"PPPPOO", {0., 0., d, inner}},
         {"OPPOOP", {a, inner, c, outer, e, inner, 1., 0.}},
         // Alternating nodes are one end, less certain, or one short zone.
         {"PPOPOO", {0., 0., alternating, 0.25}},
         {"OOPOPO", {b, inner, e, inner}}})
    checks.near("zones " + pressing, intervals(where, pressing), expected, 1e-15);

  const Pressure P = where.values([](const double x) { return std::min(0., x - 0.6); });
  const auto of_answer = contact_zones(where.multipliers, P);
  const ContactSummary summary = summarise_contact(where.multipliers, P);
  checks.that("the answer has the same zones", of_answer.size() == 1 &&
                                                 of_answer[0].start.at.side == "bottom" &&
                                                 summary.active == 4);
  checks.near("lengths", {of_answer[0].length, of_answer[0].end.at.point[0], summary.length},
              {d, d, d}, 1e-15);
  checks.near("largest P", summary.max_pressure, 0.6 - (0.25 - r), 1e-15);
}

void zones_around(Checks &checks) {
  // Eight faces with two nodes each.
  const Polynomials ring("Scene/Name = E1\n", 0, 2);
  const double around = ring.scene().geometry.sides[1].length(), face = around / 8.,
               inner = 0.5 * face / std::sqrt(3.), outer = 0.5 * face - inner;
  for (const auto &[pressing, expected] : std::vector<std::pair<std::string, std::vector<double>>>{
         {"PPPOOOOOOOOOOOOP", {around - 0.5 * face, inner, around + 1.5 * face, inner}},
         {"OOOOPPPPPPPPPPPP", {2. * face, outer, around, outer}}})
    checks.near("zones across the seam", intervals(ring, pressing), expected, 1e-12);
  checks.that("two zones", intervals(ring, "PPPPOOOOPPPPOOOO").size() == 8);
  checks.that("open at one node", intervals(ring, "PPPOPPPPPPPPPPPP").size() == 4);
  checks.that("pressed at one node", intervals(ring, "OOOPOOOOOOOOOOOO").size() == 4);
  const auto all = contact_zones(ring.multipliers, ring.values([](double) { return -1.; }));
  checks.that("all around", all.size() == 1 && std::abs(all[0].length - around) < 1e-12);
  checks.near("from its start to its start", all[0].start.at.point.distance(all[0].end.at.point),
              0., 1e-12);
}

/** -p = 1 + 3 x²: the force 2 and the moment 1/2 + 3/4 about the origin. */
void forces(Checks &checks) {
  const Polynomials where(square(3), 0, 3);
  const Pressure P = where.values([](const double x) { return -1. - 3. * x * x; });
  const auto found = contact_force(where.multipliers, {0}, P);
  checks.near("force, moment, line of action, normal force",
              {found.resultant.force[1], found.resultant.moment[0], (*found.through)[0],
               summarise_contact(where.multipliers, P).normal_force},
              {2., 1.25, 0.625, 2.}, 1e-14);
}

void graded(Checks &checks) {
  const StudyResult<2> study =
    solve(named_scene("B1"), {"Discretization/Strategy=hp", "Discretization/Coarsest level=2"});
  const LevelRecord &last = study.levels.back();
  const double xi = std::sqrt(0.5), force = 2. / 3. * std::pow(xi, 1.5);
  checks.that("B1: polynomials", last.sizes.max_degree > 2);
  checks.near("B1: contact force", last.answer.contact_force.resultant.force[1], force, 1e-6);
  // int (xi - x)^{1/2} x = 4/15 xi^{5/2}.
  checks.near("B1: line of action", (*last.answer.contact_force.through)[0], 0.4 * xi, 1e-5);
  checks.near("B1: peak", last.answer.peak_pressure->value, std::sqrt(xi), 3e-5);
  checks.near("B1: its place", last.answer.peak_pressure->at.arc_length, 0., 1e-12);
  checks.that("B1: one zone", last.answer.zones.size() == 1);
  const ContactZone &zone = last.answer.zones[0];
  checks.that("B1: it starts with the side", zone.start.at.arc_length == 0.);
  checks.near("B1: and ends at xi", zone.end.at.arc_length, xi, zone.end.uncertainty);
  checks.between("B1: up to", zone.end.uncertainty, 0., 3e-3);
  checks.near("B1: contact length", last.contact.length, zone.length, 1e-15);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {peak, zones, zones_around, forces, graded});
}
