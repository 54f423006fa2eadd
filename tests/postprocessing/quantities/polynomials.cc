// SPDX-License-Identifier: LGPL-2.1-or-later
// Peak pressure, contact zones and contact forces of pressures that are polynomials on patches, and
// those of scene B1 on graded meshes, where p = -(xi - x)_+^{1/2}, xi = 2^{-1/2}.

#include <signorini/postprocessing/fields/forces.h>
#include <signorini/postprocessing/quantities/contact_zones.h>
#include <signorini/postprocessing/quantities/peak_pressure.h>
#include <signorini/postprocessing/quantities/side_forces.h>

#include <cmath>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace
{
/** A scene on a uniform mesh with n multipliers on every contact face. */
class Polynomials
{
public:
  Polynomials(const std::string &text, const unsigned int level, const unsigned int n)
    : level_(text, level)
    , surface(mesh(),
              level_.scene,
              std::vector<unsigned int>(mesh().triangulation().n_active_cells(), n + 1))
    , multipliers(surface, std::vector<unsigned int>(surface.patches().size(), n))
  {
  }

  /** The values of a function of the arc length at the nodes. */
  template <typename Function>
  Pressure values(const Function &p) const
  {
    Pressure P(multipliers.n_multipliers());
    for (unsigned int k = 0; k < P.size(); ++k)
      P[k] = p(multipliers.node(k)[0]);
    return P;
  }
  const Scene<2> &scene() const
  {
    return level_.scene;
  }

private:
  const Mesh<2> &mesh() const
  {
    return level_.discretization.mesh;
  }
  OneLevel level_;

public:
  const ContactSurface<2> surface;
  const MultiplierSpace<2> multipliers;
};

/** The unit square with contact at the bottom and so many faces along it. */
std::string square(const unsigned int faces)
{
  return "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" +
         entry("Geometry", "Cells", std::to_string(faces) + ", 2");
}

void peak(Checks &checks)
{
  const Polynomials coarse(square(3), 0, 5);
  const auto of = [](const Polynomials &where, const Pressure &P) {
    return *peak_pressure(where.multipliers, P);
  };
  // -p = x (1 - x)^3 has the maximum 27/256 at 1/4, on the face from 0 to 1/3.
  const PressureMaximum inner =
    of(coarse, coarse.values([](const double x) { return -x * std::pow(1. - x, 3); }));
  checks.near("a polynomial of degree four", inner.value, 27. / 256., 1e-15);
  checks.near("its place", inner.place.point[0], 0.25, 1e-7);
  const auto primitive = [](const double x) {
    return -std::pow(1. - x, 4) / 4. + std::pow(1. - x, 5) / 5.;
  };
  checks.near("mean of its patch", inner.mean, 3. * (primitive(1. / 3.) - primitive(0.)), 1e-15);
  const PressureMaximum end = of(coarse, coarse.values([](const double x) { return x - 2.; }));
  checks.near("peak at the end of a side", end.value, 2., 1e-14);
  checks.near("there", end.place.point[0], 0., 1e-15);
  // -p = 1 + t^2 (1 - t^2) on both faces, -1 <= t <= 1, with four equal peaks at t^2 = 1/2.
  const Polynomials swinging(square(2), 0, 8);
  const PressureMaximum first = of(swinging, swinging.values([](const double x) {
    const double t = 4. * x - (x < 0.5 ? 1. : 3.);
    return -(1. + t * t * (1. - t * t));
  }));
  checks.near("equal peaks", first.value, 1.25, 1e-14);
  checks.near("the first of them", first.place.point[0], 0.25 * (1. - std::sqrt(0.5)), 1e-7);
  checks.that("no pressure, no peak",
              !peak_pressure(coarse.multipliers, Pressure(coarse.multipliers.n_multipliers())));
}

/** Which nodes of a row press, as a text: "PPO". */
std::vector<PressedInterval> intervals(const Polynomials &where, const std::string &pressing)
{
  Pressure P(where.multipliers.n_multipliers());
  for (unsigned int k = 0; k < P.size(); ++k)
    P[k] = pressing.at(k) == 'P' ? -1. : 0.;
  return pressed_intervals(where.multipliers, P);
}

void zones(Checks &checks)
{
  // Gauss nodes of two faces: their middles, and (3/5)^{1/2} of half a face away from there.
  const Polynomials where(square(2), 0, 3);
  const double r = 0.25 * std::sqrt(0.6);
  const double nodes[] = {0.25 - r, 0.25, 0.25 + r, 0.75 - r, 0.75, 0.75 + r};
  const auto middle = [&](const int i, const int j) { return 0.5 * (nodes[i] + nodes[j]); };
  checks.that("no zone", intervals(where, "OOOOOO").empty());
  auto found = intervals(where, "PPPPPP");
  checks.that("a whole side",
              found.size() == 1 && found[0].length() == 1. && found[0].end.uncertainty == 0.);
  found = intervals(where, "PPPPOO");
  checks.that("one zone", found.size() == 1 && found[0].start.s == 0.);
  checks.near("it ends in the middle of two nodes", found[0].end.s, middle(3, 4), 1e-15);
  checks.near("uncertainty", found[0].end.uncertainty, 0.5 * r, 1e-15);
  found = intervals(where, "OPPOOP");
  checks.that("two zones", found.size() == 2);
  checks.near("  the first", found[0].length(), middle(2, 3) - middle(0, 1), 1e-15);
  checks.near("  the second", found[1].length(), 1. - middle(4, 5), 1e-15);
  found = intervals(where, "PPOPOO");
  checks.that("alternating nodes are one end", found.size() == 1);
  checks.near("  in their middle", found[0].end.s, middle(1, 4), 1e-15);
  checks.near("  less certain", found[0].end.uncertainty, 0.5 * (nodes[4] - nodes[1]), 1e-15);
  found = intervals(where, "OOPOPO");
  checks.that("or one short zone", found.size() == 1);
  checks.near("  from", found[0].start.s, middle(1, 2), 1e-15);
  checks.near("  to", found[0].end.s, middle(4, 5), 1e-15);

  const Pressure P = where.values([](const double x) { return std::min(0., x - 0.6); });
  const auto of_answer = contact_zones(where.multipliers, P);
  const ContactSummary summary = summarise_contact(where.multipliers, P);
  checks.that("the answer has the same zones",
              of_answer.size() == 1 && of_answer[0].start.place.side == "bottom" &&
                of_answer[0].length == middle(3, 4));
  checks.near("its point", of_answer[0].end.place.point[0], middle(3, 4), 1e-15);
  checks.near("contact length", summary.length, middle(3, 4), 1e-15);
  checks.that("pressing multipliers", summary.active == 4);
  checks.near("largest P", summary.max_pressure, 0.6 - nodes[0], 1e-15);
}

void zones_around(Checks &checks)
{
  // Eight faces with two nodes each.
  const Polynomials ring(entry("Scene", "Name", "E1"), 0, 2);
  const double around = ring.scene().geometry.sides[1].length(), face = around / 8.;
  const double inner = face / std::sqrt(3.), outer = face - inner;
  auto found = intervals(ring, "PPPOOOOOOOOOOOOP");
  checks.that("a zone across the seam is one", found.size() == 1);
  checks.near("its start", found[0].start.s, around - 0.5 * face, 1e-12);
  checks.near("its end", found[0].end.s, around + 1.5 * face, 1e-12);
  checks.near("uncertainty", found[0].end.uncertainty, 0.5 * inner, 1e-12);
  found = intervals(ring, "OOOOPPPPPPPPPPPP");
  checks.that("a zone that ends at the seam", found.size() == 1);
  checks.near("its end", found[0].end.s, around, 1e-12);
  checks.near("between two faces", found[0].end.uncertainty, 0.5 * outer, 1e-12);
  checks.that("two zones", intervals(ring, "PPPPOOOOPPPPOOOO").size() == 2);
  checks.that("open at one node", intervals(ring, "PPPOPPPPPPPPPPPP").size() == 1);
  checks.that("pressed at one node", intervals(ring, "OOOPOOOOOOOOOOOO").size() == 1);
  const auto all = contact_zones(ring.multipliers, ring.values([](double) { return -1.; }));
  checks.that("all around", all.size() == 1 && std::abs(all[0].length - around) < 1e-12);
  checks.near("from its start to its start",
              all[0].start.place.point.distance(all[0].end.place.point),
              0.,
              1e-12);
}

/** -p = 1 + 3 x²: the force 2 and the moment 1/2 + 3/4 about the origin. */
void forces(Checks &checks)
{
  const Polynomials where(square(3), 0, 3);
  const Pressure P = where.values([](const double x) { return -1. - 3. * x * x; });
  const auto found = contact_force(where.multipliers, {2}, P);
  checks.near("force", found.resultant.force[1], 2., 1e-14);
  checks.near("moment", found.resultant.moment[0], 1.25, 1e-14);
  checks.near("line of action", (*found.through)[0], 0.625, 1e-14);
  checks.near("normal force", summarise_contact(where.multipliers, P).normal_force, 2., 1e-14);
}

void graded(Checks &checks)
{
  const StudyResult<2> study =
    solve(named_scene("B1"), {"Discretization/Strategy=hp", "Discretization/Coarsest level=2"});
  const LevelRecord &last = study.levels.back();
  const double xi = std::sqrt(0.5), force = 2. / 3. * std::pow(xi, 1.5);
  checks.that("B1: polynomials", last.sizes.max_degree > 2);
  checks.near("B1: contact force", last.answer.contact_force.resultant.force[1], force, 1e-6);
  // int (xi - x)^{1/2} x = 4/15 xi^{5/2}.
  checks.near("B1: line of action", (*last.answer.contact_force.through)[0], 0.4 * xi, 1e-5);
  checks.near("B1: peak", last.answer.peak_pressure->value, std::sqrt(xi), 3e-5);
  checks.near("B1: its place", last.answer.peak_pressure->place.arc_length, 0., 1e-12);
  checks.that("B1: one zone", last.answer.zones.size() == 1);
  const ContactZone &zone = last.answer.zones[0];
  checks.that("B1: it starts with the side", zone.start.place.arc_length == 0.);
  checks.near("B1: and ends at xi", zone.end.place.arc_length, xi, zone.end.uncertainty);
  checks.between("B1: up to", zone.end.uncertainty, 0., 2e-3);
  checks.near("B1: contact length", last.contact.length, zone.length, 1e-15);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  peak(checks);
  zones(checks);
  zones_around(checks);
  forces(checks);
  graded(checks);
  return checks.exit_code();
}
