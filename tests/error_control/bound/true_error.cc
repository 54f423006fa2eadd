// SPDX-License-Identifier: LGPL-2.1-or-later
// The bounds are not below the energy errors of u_h and pi^{2h} u_h in scenes with a known
// solution, and not much above them. The error is integrated from the exact gradient, with nothing
// of what the bound is computed from.

#include <deal.II/base/mpi.h>

#include <cmath>
#include <fstream>
#include <iomanip>

#include "driver/stress/stress.h"
#include "energy_errors.h"

using namespace Signorini;

namespace
{
/** Levels of a scene, and the largest ratios of bound and error that are allowed on levels 4 and 5,
 * for u_h and for pi^{2h} u_h; zero: any. Level 5 takes three quarters of the time: without such a
 * ratio, and without curved sides, level 4 is the last one. */
struct Case
{
  std::string name;
  std::string text;
  unsigned int coarsest;
  double effectivity, interpolated_part;
  unsigned int finest = effectivity > 0. ? 5 : 4;
};

/** A table in Markdown, in a file of the working directory. */
class Effectivities
{
public:
  explicit Effectivities(const std::string &name)
    : file_(name)
  {
    file_ << "| scene | level 1 | 2 | 3 | 4 | 5 |\n|---|---|---|---|---|---|\n";
  }
  void start(const Case &given)
  {
    file_ << "| " << given.name << " | ";
    for (unsigned int number = 1; number < given.coarsest; ++number)
      file_ << "| ";
  }
  void add(const double effectivity)
  {
    file_ << std::setprecision(3) << effectivity << " | ";
  }
  void end_row()
  {
    file_ << std::endl;
  }

private:
  std::ofstream file_;
};

/** Tables of bound / error. */
struct Tables
{
  Effectivities strain_of_u_h{"effectivities.md"}, interpolated_part{"effectivities_of_patches.md"};
};

void check(Checks &checks, Tables &tables, const Case &given)
{
  const std::string text = given.text + entry("Discretization", "Target error", "1e-9") +
                           entry("Output", "Inf-sup constant", "false");
  tables.strain_of_u_h.start(given);
  tables.interpolated_part.start(given);
  double lower = -1e300, upper = 1e300, coarser_geometry = 0.;
  for (unsigned int number = given.coarsest; number <= given.finest; ++number)
  {
    const OneLevel level(text, number);
    const LevelSolution<2> solution = level.solve();
    const std::string name = given.name + ", level " + std::to_string(number);
    const auto &bound = solution.record.bound;
    const Mesh<2> &mesh = level.space().mesh();
    const bool curved = mesh.is_curved();
    if (!bound || !bound->absolute || bound->guaranteed == curved ||
        bound->energy_lower.has_value() == curved || bound->energy_upper.has_value() == curved ||
        bound->post_absolute.has_value() != (!curved && mesh.has_parents()))
    {
      checks.that(name + " has all bounds, guaranteed unless sides are curved", false);
      continue;
    }
    const Errors errors = energy_errors(level, solution.U);
    const auto compare = [&](const std::string &field, const double ratio, const double largest) {
      // 1e-6: the quadrature of singular solutions.
      checks.between(name + field, ratio, 1. - 1e-6, number >= 4 && largest > 0. ? largest : 1e10);
    };
    compare(", bound / error", *bound->absolute / errors.strain_of_u_h, given.effectivity);
    tables.strain_of_u_h.add(*bound->absolute / errors.strain_of_u_h);
    if (bound->post_absolute)
    {
      compare(
        ", patches", *bound->post_absolute / errors.interpolated_part, given.interpolated_part);
      tables.interpolated_part.add(*bound->post_absolute / errors.interpolated_part);
    }
    // Zero on straight sides.
    if (coarser_geometry > 0.)
      checks.between(name + ", order of the geometric part",
                     std::log2(coarser_geometry / *bound->geometry),
                     1.3,
                     4.);
    coarser_geometry = *bound->geometry;
    lower = std::max(lower, bound->energy_lower.value_or(lower));
    upper = std::min(upper, bound->energy_upper.value_or(upper));
  }
  // J(u) is in all of the brackets; there are none on curved sides.
  if (coarser_geometry == 0.)
    checks.that(given.name + ", energies", lower <= upper + 1e-14 * std::abs(upper));
  tables.strain_of_u_h.end_row();
  tables.interpolated_part.end_row();
}

/** Scene A1, see prm/described_a1.prm, on a mesh of general quadrilaterals. */
std::string distorted_a1(const std::string &distortion)
{
  const std::string s11 =
    "10*max(0,xi-x)^3*(y^2-1/3) + 0.2*x^2*y - 0.4*x*y^2 - 0.2*x*y + 8*x/15 - 0.6*y^3 + 0.6*y";
  const std::string s12 =
    "10*max(0,xi-x)^2*(y-y^3) - 0.2*x^2*y - 0.4*x*y^2 + y^3/15 + 0.2*y^2 - y/15";
  return entry("Constants", "Values", "xi=1/sqrt(2)") +
         entry("Geometry", "Distortion", distortion) +
         "subsection Material\nset Young's modulus = 2.5\nset Poisson's ratio = 0.25\nend\n"
         "subsection Boundary\nset Clamped = top\nset Contact = bottom\nset Traction = left: -(" +
         s11 + "); -(" + s12 + ") | right: " + s11 + "; " + s12 + "\nend\n" +
         entry("Load",
               "Body force",
               "max(0,xi-x)^2*(60*y^2-20) + 0.2*x^2 + 0.4*x*y + 0.2*y^2 - 0.2*y - 7/15; "
               "-60*max(0,xi-x)^3*y + 20*max(0,xi-x)*(y-y^3) - 0.6*x^2 - 0.4*x*y + 0.6*x + y^2 "
               "- 0.2") +
         entry("Contact", "Gap", "-0.1*x*(1-x) + max(0,x-xi)^2") +
         "subsection Exact solution\n"
         "set Displacement = (0.2*x*y - 0.1*y + 0.1*x^2)*(1-y^2); "
         "(0.1*x*(1-x) - y*(10*max(0,xi-x)^3 + 0.2*x)/3)*(1-y^2)\n"
         "set Displacement gradient = (0.2*y + 0.2*x)*(1-y^2); "
         "(0.2*x - 0.1)*(1-y^2) - 2*y*(0.2*x*y - 0.1*y + 0.1*x^2); "
         "(0.1 - 0.2*x - y*(0.2 - 30*max(0,xi-x)^2)/3)*(1-y^2); "
         "-(10*max(0,xi-x)^3 + 0.2*x)/3*(1-3*y^2) - 0.2*y*x*(1-x)\n"
         "set Pressure = -10*max(0,xi-x)^3\nend\n" +
         entry("Discretization", "Kinks at x", "0.70710678118654752");
}

std::vector<Case> make_cases()
{
  std::vector<Case> cases;
  for (const char *scene : {"A1",
                            "A1L",
                            "A2",
                            "A3",
                            "B1",
                            "B1q",
                            "B1t",
                            "B2",
                            "B3",
                            "B4",
                            "C1",
                            "C2",
                            "C3",
                            "C4",
                            "O1",
                            "V1"})
  {
    // A side of C4 ends in the middle of the bottom's coarse face.
    const unsigned int coarsest = std::string(scene) == "C4" ? 2 : 1;
    cases.push_back({scene, named_scene(scene), coarsest, 1.5, 2.5});
  }
  for (const char *scene : {"A1", "B1", "A3"})
  {
    const auto with = [&](const std::string &name, const std::string &value) {
      return named_scene(scene) + entry("Discretization", name, value);
    };
    const std::string name = scene;
    cases.push_back({name + ", H = 4 h", with("Patch ratio", "4"), 2, 0., 0.});
    cases.push_back({name + ", H = 8 h", with("Patch ratio", "8"), 3, 0., 0.});
    cases.push_back({name + ", 4 patches", with("Patches", "4"), 3, 0., 0.});
    cases.push_back({name + ", 5 patches", with("Patches", "5"), 3, 0., 0.});
  }
  // Curved sides: an estimated bound. Most of E3's is the body force on general quadrilaterals.
  for (const char *scene : {"E1", "E2", "E3"})
    cases.push_back({scene, named_scene(scene), 3, std::string(scene) == "E3" ? 0. : 1.6, 0., 5});
  // Displacements are prescribed that are not linear on edges.
  for (const char *nu : {"0.3", "0.49", "0.4999"})
    for (const char *element : {"Q1", "Q1 B-bar"})
    {
      Family family;
      family.nu = nu;
      cases.push_back({std::string("nu = ") + nu + ", " + element,
                       text_of(family) + entry("Discretization", "Element", element),
                       1,
                       0.,
                       0.});
    }
  for (const char *contrast : {"3", "-3"})
  {
    Family along, across;
    along.contrast_x = across.contrast_y = contrast;
    cases.push_back({std::string("E grows along by 10^") + contrast, text_of(along), 1, 0., 0.});
    cases.push_back({std::string("E grows across by 10^") + contrast, text_of(across), 1, 0., 0.});
  }
  for (const char *distortion : {"0.2", "0.3"})
    cases.push_back(
      {std::string("A1, distorted by ") + distortion, distorted_a1(distortion), 2, 0., 0.});
  return cases;
}
} // namespace

int main(int argc, char **argv)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  Tables tables;
  for (const Case &given : make_cases())
    check(checks, tables, given);
  return checks.exit_code();
}
