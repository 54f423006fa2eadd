// SPDX-License-Identifier: LGPL-2.1-or-later
// How many steps of conjugate gradients with one V-cycle each reduce the residual by 1e-8: flat in
// h.

#include <signorini/problem/geometry/shapes.h>

#include <deal.II/base/mpi.h>

#include <fstream>

#include "driver/box/box.h"
#include "v_cycle.h"

using namespace Signorini;

namespace {
/** The largest number of steps that is allowed for a body on a level. */
struct Case {
  std::string name, text;
  unsigned int coarsest, level, most;
};

struct CaseInSpace {
  std::string name;
  Scene<3> scene;
  unsigned int coarsest, level, most;
};

/** A row of the table multigrid_steps.csv. */
template <int dim>
void check(Checks &checks, std::ostream &table, const std::string &name, const unsigned int level,
           const HeldBody<dim> &body, const unsigned int most) {
  const DualVector b = body.random_vector(5);
  DualVector x(b);
  const unsigned int n_steps = conjugate_gradients(body.multigrid, x, b);
  checks.between(name + ", level " + std::to_string(level), n_steps, 1, most);
  table << '"' << name << "\"," << level << ',' << body.space.dofs().n_dofs() << ',' << n_steps
        << std::endl;
}

std::string modulus(const std::string &E) {
  return "Material/Young's modulus = " + E + "\n";
}

std::string cells_of(const std::string &width, const std::string &height) {
  return "Geometry/Upper right = " + width + ", " + height + "\n";
}

const std::string held = "Boundary/Clamped = top\nBoundary/Contact = bottom\n",
                  distorted = held + "Geometry/Distortion = 0.2\n",
                  pentagon = "Geometry/Shape = polygon\nBoundary/Contact = side0\n"
                             "Geometry/Vertices = 0,0; 2,0; 2.5,1; 1,2; -0.5,1\n"
                             "Boundary/Rollers = side1, side3\n";

std::vector<Case> plane_cases(const bool is_long) {
  std::vector<Case> cases = {
    {"square", held, 4, 4, 8},
    {"square", held, 6, 6, 8},
    {"square", held, 8, 8, 8},
    {"square, distorted on level 3", distorted, 3, 4, 11},
    {"square, distorted on level 3", distorted, 3, 7, 11},
    {"square, distorted on the last level", distorted, 6, 6, 11},
    {"half disc", named_scene("E3"), 2, 4, 15},
    {"half disc", named_scene("E3"), 2, 6, 15},
    {"island 1000 times as stiff", held + modulus("if((x-0.4)^2 + (y-0.6)^2 < 0.05, 1000, 1)"), 6,
     6, 17},
    {"nu = 0.45", held + "Material/Poisson's ratio = 0.45\n", 6, 6, 14},
    {"cells of 4 by 1", held + cells_of("4", "1"), 6, 6, 29},
    // Bending has so little energy that matrices in single precision are not positive definite.
    {"cells of 1 by 8", held + cells_of("1", "8"), 7, 7, 64},
    {"cells of 1 by 32", held + cells_of("1", "32"), 5, 5, 400},
    {"body of 1 by 20", held + cells_of("1", "20") + "Geometry/Cells = 1, 20\n", 4, 4, 20}};
  if (!is_long)
    return cases;
  for (const unsigned int level : {5U, 7U, 9U, 10U, 11U})
    cases.push_back({"square", held, level, level, 8});
  for (const char *width : {"2", "8", "16"})
    cases.push_back(
      {std::string("cells of ") + width + " by 1", held + cells_of(width, "1"), 6, 6, 100});
  const std::vector<Case> more = {
    {"square of 3 by 2 blocks", held + "Geometry/Cells = 3, 2\n", 6, 6, 11},
    {"nu = 0.49", held + "Material/Poisson's ratio = 0.49\n", 6, 6, 29},
    {"ring", named_scene("E1"), 2, 6, 12},
    {"pentagon with oblique rollers", pentagon, 2, 6, 15},
    {"modulus exp(6.9 x)", held + modulus("exp(6.9*x)"), 6, 6, 9},
    {"modulus 1 and 1000 on two halves", held + modulus("if(x<0.5, 1, 1000)"), 6, 6, 9}};
  cases.insert(cases.end(), more.begin(), more.end());
  return cases;
}

Scene<3> box(const dealii::Point<3> &upper, const std::vector<unsigned int> &cells,
             const double distortion = 0.) {
  Scene<3> scene = make_box_scene(scalar([](const auto &) { return 0.; }),
                                  field([](const dealii::Point<3> &) { return Vector3(); }), upper);
  scene.geometry = make_box({0., 0., 0.}, upper, cells);
  scene.geometry.distortion = distortion;
  return scene;
}

std::vector<CaseInSpace> cases_in_space(const bool is_long) {
  const Scene<3> cube = box({1., 1., 1.}, {1, 1, 1});
  std::vector<CaseInSpace> cases = {
    {"cube", cube, 3, 3, 8},
    {"cube", cube, 4, 4, 8},
    {"cube", cube, 5, 5, 8},
    // More than 5000 unknowns of coarse cells: cycles of algebraic multigrid instead of factors.
    {"cube of 12 by 12 by 12 blocks", box({1., 1., 1.}, {12, 12, 12}), 1, 1, 8},
    {"beam of 60 by 6 by 6 blocks", box({10., 1., 1.}, {60, 6, 6}), 1, 1, 8},
    {"cube, distorted on level 2", box({1., 1., 1.}, {1, 1, 1}, 0.2), 2, 4, 9}};
  if (is_long) {
    cases.push_back({"cube", cube, 6, 6, 8});
    cases.push_back({"cube", cube, 7, 7, 8});
    cases.push_back({"box of 2 by 3 by 1 blocks", box({1., 2., 1.}, {2, 3, 1}), 4, 4, 12});
  }
  return cases;
}

void steps(Checks &checks) {
  std::ofstream table("multigrid_steps.csv");
  table << "body,level,unknowns,steps\n";
  for (const Case &given : plane_cases(checks.is_long()))
    check(checks, table, given.name, given.level,
          HeldBody<2>(scene_of(given.text), given.coarsest, given.level), given.most);
  if (checks.is_long())
    check(checks, table, "nu = 0.4999, B-bar", 6,
          HeldBody<2>(scene_of(held + "Material/Poisson's ratio = 0.4999\n"), 6, 6,
                      StrainOperator::mean_dilatation),
          250);
  for (const CaseInSpace &given : cases_in_space(checks.is_long()))
    check(checks, table, given.name, given.level,
          HeldBody<3>(given.scene, given.coarsest, given.level), given.most);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {steps});
}
