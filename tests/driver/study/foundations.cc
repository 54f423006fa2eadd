// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole studies with rigid things: the digits of the gap by an expression, and the line contact of
// Hertz on nested and on graded meshes.

#include <signorini/problem/scene/foundation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include "graded_steps.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace
{
const std::string block = "subsection Geometry\nset Lower left = -1, 0\nset Cells = 2, 1\nend\n"
                          "subsection Boundary\nset Contact = bottom\n"
                          "set Displacement = top: 0; -0.05\nend\n";

std::string contact(const std::string &name, const std::string &value)
{
  return "subsection Contact\nset " + name + " = " + value + "\nend\n";
}

/** Every number of both runs, but for seconds and memory. */
bool same_digits(const StudyResult<2> &a, const StudyResult<2> &b)
{
  bool same = a.levels.size() == b.levels.size();
  for (std::size_t i = 0; i < a.levels.size() && same; ++i)
    for (const char *column :
         {"energy", "kkt", "contact_force_n", "peak_pressure", "estimated_energy"})
      same = same && value(a.levels[i], column) == value(b.levels[i], column);
  return same;
}

void test_digits(Checks &checks)
{
  struct Pair
  {
    std::string name, expression, obstacle;
  };
  const std::vector<Pair> pairs = {{"parabola", "x^2/4", "parabola 0,0 normal 0,2 curvature -0.5"},
                                   {"plane", "-0.0625", "plane -7,0.0625 normal 0,1"},
                                   {"steps of planes",
                                    "min(0.125, 0.25)",
                                    "plane 0,-0.25 normal 0,1 | plane 0,-0.125 normal 0,3"}};
  for (const Pair &pair : pairs)
    for (const auto &overrides : {levels(2, 4), graded("1e-3")})
      checks.that(pair.name + ", strategy " + (overrides.size() > 2 ? "hp" : "nested"),
                  same_digits(solve(block + contact("Gap", pair.expression), overrides),
                              solve(block + contact("Foundation", pair.obstacle), overrides)));
}

double force_of(const StudyResult<2> &result)
{
  return result.levels.back().contact.normal_force;
}

/** A block that is lowered onto discs, and discs that are raised by as much into the block. */
void test_position(Checks &checks)
{
  const std::string discs = "circle -0.5,-0.5 radius 0.5 | circle 0.5,-0.5 radius 0.5";
  const auto overrides = levels(3, 5);
  const StudyResult<2> lowered = solve(block + contact("Foundation", discs), overrides);
  const StudyResult<2> raised = solve(block + contact("Foundation", discs),
                                      {overrides[0],
                                       overrides[1],
                                       "Boundary/Displacement=top: 0; 0",
                                       "Contact/Foundation position=0, 0.05"});
  checks.that("certified", raised.verdict.outcome == Outcome::certified);
  checks.near("lowered and raised", force_of(raised), force_of(lowered), 1e-12);
  const std::vector<ContactZone> &zones = raised.levels.back().answer.zones;
  checks.that("two zones", zones.size() == 2);
}

/** A disc of a hundredth of the block's size beside a large one, without kinks: graded meshes find
 * it, although gaps beside it are much larger than it. */
void test_small_disc(Checks &checks)
{
  const std::string small = "circle 0.53,-0.03 radius 0.02", large = "circle -0.5,-1 radius 1";
  const StudyResult<2> result =
    solve(block + contact("Foundation", small + " | " + large), graded("1e-3"));
  const std::vector<ContactZone> &zones = result.levels.back().answer.zones;
  checks.that("a small disc, the accuracy is reached",
              result.verdict.outcome == Outcome::accuracy_estimated);
  checks.that("a small disc is found", zones.size() == 2);
  // H is a third of the small zone.
  const StudyResult<2> nested =
    solve(block + contact("Foundation", small + " | " + large), levels(7, 7));
  checks.near("force with a small disc, against a nested level",
              force_of(result) / force_of(nested),
              1.,
              0.01);
}

/** A square on its tip, held by nothing but a groove of two planes: each side of the groove carries
 * (∓W/2, W/2) of the weight W = 2. */
void test_groove(Checks &checks)
{
  const StudyResult<2> result =
    solve("subsection Geometry\nset Shape = polygon\nset Vertices = 0,-1; 1,0; 0,1; -1,0\nend\n"
          "subsection Boundary\nset Contact = side0 side3\nend\n"
          "subsection Load\nset Body force = 0; -1\nend\n" +
            contact("Foundation", "plane 0,-1 normal -1,1 | plane 0,-1 normal 3,3"),
          levels(2, 4));
  checks.that("certified in a groove", result.verdict.outcome == Outcome::certified);
  double difference = 0.;
  const std::vector<SideForce> &forces = result.levels.back().answer.contact_by_side;
  for (unsigned int i = 0; i < 2; ++i)
    difference = std::max(
      difference,
      (forces.at(i).resultant.force - dealii::Tensor<1, 2>({i == 0 ? -1. : 1., 1.})).norm());
  checks.near("forces in a groove", difference, 0., 1e-9);
}

/** The half disc of scene E3 (R = 1, lambda = mu = 1, clamped at its diameter), pressed on the
 * plane y = travel - 1. */
StudyResult<2> press_half_disc(const double travel,
                               const std::string &obstacle,
                               const std::vector<std::string> &overrides)
{
  const Parameters parameters = parse_parameters(named_scene("E3"), "test", overrides);
  Scene<2> scene = make_scene<2>(parameters);
  scene.exact_displacement = nullptr;
  scene.body_force = nullptr;
  scene.kinks = Kinks<2>();
  const std::size_t arc = scene.geometry.find_side("arc");
  BoundaryCondition<2> &condition = scene.boundary[arc];
  condition.exact_pressure = nullptr;
  const dealii::Tensor<1, 2> up({0., 1.});
  condition.foundation = std::make_shared<Foundation>(
    std::vector<Obstacle>{obstacle == "plane" ? Obstacle::plane({0., -1.}, up)
                                              : Obstacle::circle({0., 1.}, 2., Body::inside)},
    20.);
  condition.data = foundation_gap(scene.geometry.sides[arc], condition.foundation, travel * up);
  std::ostream silence(nullptr);
  return run_study(parameters, scene, MPI_COMM_WORLD, {silence, "", [](const std::string &) {}});
}

/** Hertz: half the zone is b with b² = 4 F R_* /(pi E*), the peak 2 F/(pi b); here E* = 8/3, and
 * 1/R_* = 1 in contact with a plane and 1 - 1/2 in the hole. The law holds up to (b/R)² = 0.014;
 * nested levels know the zone up to a patch. */
void check_hertz(Checks &checks,
                 const std::string &name,
                 const StudyResult<2> &result,
                 const double R)
{
  const bool is_nested = name == "nested";
  const LevelRecord &last = result.levels.back();
  const double F = last.contact.normal_force;
  const double b = std::sqrt(4. * F * R / (PI * 8. / 3.));
  checks.between(name + ", half width", b, 0.11, 0.12);
  checks.near(name + ", contact zone over that of Hertz",
              last.contact.length / (2. * b),
              1.,
              is_nested ? last.sizes.H / b : 0.01);
  checks.near(name + ", peak over that of Hertz",
              last.answer.peak_pressure->value / (2. * F / (PI * b)),
              1.,
              0.014);
  checks.that(name + ", the equations hold",
              result.verdict.outcome ==
                (is_nested ? Outcome::equations_certified : Outcome::accuracy_estimated));
}

void test_hertz(Checks &checks)
{
  check_hertz(checks, "nested", press_half_disc(0.02, "plane", levels(3, 6)), 1.);
  check_hertz(checks, "hp", press_half_disc(0.02, "plane", graded("1e-3")), 1.);
  check_hertz(checks, "hp, hole", press_half_disc(0.01, "hole", graded("1e-3")), 2.);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  test_digits(checks);
  test_position(checks);
  test_small_disc(checks);
  test_groove(checks);
  test_hertz(checks);
  return checks.exit_code();
}
