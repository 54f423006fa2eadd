// SPDX-License-Identifier: LGPL-2.1-or-later
// The energy of the difference of functions on two meshes, against integrals by hand.

#include <signorini/error_control/hp/step_examination.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

#include "graded.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace
{
/** lambda = mu = 1 on the unit square. */
const std::string square =
  "subsection Material\nset Young's modulus = 2.5\nset Poisson's ratio = 0.25\nend\n"
  "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

/** Meshes that are finer in different places. */
struct TwoMeshes
{
  explicit TwoMeshes(const std::string &text)
    : first(text, plan({0., 0.}, 4., 2.))
    , second(text, plan({1., 0.}, 3., 5.))
  {
  }
  static MeshPlan plan(const Point<2> &vertex, const double layers, const double rise)
  {
    MeshPlan plan = uniform_plan(2, 2);
    plan.base_size = 0.25;
    plan.singularities = {corner(vertex, layers),
                          end_of_contact({0.4, 0.}, 2, 0.4, 0.41, 6. - layers)};
    plan.rise = rise;
    return plan;
  }
  /** |||u - v|||, u on the first mesh and v on the second. */
  double distance(const Field &u, const Field &v) const
  {
    const Displacement U = nodal_values(first.space(), u), V = nodal_values(second.space(), v);
    return energy_distance({first.space(), U}, {second.space(), V}, first.scene);
  }
  double opposite(const Field &u, const Field &v) const
  {
    const Displacement U = nodal_values(first.space(), u), V = nodal_values(second.space(), v);
    return energy_distance({second.space(), V}, {first.space(), U}, first.scene);
  }

  GradedLevel first, second;
};

/** w = (x² + y, x y), eps = (2 x, (1 + y)/2, x): E eps : eps = (3 x)² + 2 (4 x² + x² + (1 + y)²/2),
 * whose mean over the unit square is 3 + 10/3 + 7/3. */
void polynomials(Checks &checks)
{
  const Field v = [](const Point<2> &x) { return Point<2>(x[0] * x[1], 0.3 - x[1] * x[1]); };
  const Field u = [&v](const Point<2> &x) {
    return v(x) + Point<2>(x[0] * x[0] + x[1], x[0] * x[1]);
  };
  const double exact = std::sqrt(3. + 10. / 3. + 7. / 3.);
  for (const auto &[name, text] : std::vector<std::pair<std::string, std::string>>{
         {"squares", square},
         {"distorted", "subsection Geometry\nset Distortion = 0.3\nend\n" + square}})
  {
    const TwoMeshes meshes(text);
    checks.that(name + ": hanging nodes",
                has_hanging_nodes(meshes.first.mesh()) && has_hanging_nodes(meshes.second.mesh()));
    checks.near(name + ": distance", meshes.distance(u, v), exact, 1e-12);
    checks.near(name + ": symmetric", meshes.opposite(u, v), exact, 1e-12);
    checks.near(name + ": the same function", meshes.distance(u, u), 0., 1e-12);
    checks.near(
      name + ": a rigid motion",
      meshes.distance(
        u, [&u](const Point<2> &x) { return u(x) + Point<2>(0.2 - 0.1 * x[1], 0.1 * x[0]); }),
      0.,
      1e-12);
  }
}

/** Interpolants of (x³, 0) with degree two on cells of the sizes h and h/2: what they miss of a
 * cell 0 < x < h is x (x - h/2) (x - h). */
void interpolants(Checks &checks)
{
  const Field u = [](const Point<2> &x) { return Point<2>(std::pow(x[0], 3), 0.); };
  const dealii::QGauss<1> gauss(4);
  const auto slope = [](const double x, const double h) {
    return 3. * x * x - 3. * h * x + 0.5 * h * h;
  };
  for (const unsigned int level : {0U, 2U, 3U})
  {
    const GradedLevel coarse(square, uniform_plan(level, 2));
    MeshPlan split = uniform_plan(level, 2);
    for (const auto &cell : coarse.mesh().triangulation().active_cell_iterators())
      split.demands[cell->id()].split = true;
    const GradedLevel fine(square, split);
    const double h = std::pow(0.5, level);
    double square_of_slope = 0.;
    for (unsigned int half = 0; half < 2; ++half)
      for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        const double x = 0.5 * h * gauss.point(q)[0];
        const double difference = slope(0.5 * h * half + x, h) - slope(x, 0.5 * h);
        square_of_slope += 0.5 * gauss.weight(q) * difference * difference;
      }
    const Displacement U = nodal_values(coarse.space(), u), V = nodal_values(fine.space(), u);
    checks.near("interpolants of x^3, h = " + std::to_string(h),
                energy_distance({coarse.space(), U}, {fine.space(), V}, coarse.scene),
                std::sqrt(3. * square_of_slope),
                1e-12);
  }
}

/** E = 1 + x with nu = 0: |||(x, 0)|||² = int 1 + x = 3/2. */
void variable_material(Checks &checks)
{
  const std::string text =
    "subsection Material\nset Young's modulus = 1 + x\nset Poisson's ratio = 0\nend\n"
    "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";
  const TwoMeshes meshes(text);
  checks.near("a variable modulus",
              meshes.distance([](const Point<2> &x) { return Point<2>(x[0], 0.); },
                              [](const Point<2> &) { return Point<2>(); }),
              std::sqrt(1.5),
              1e-12);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  polynomials(checks);
  interpolants(checks);
  variable_material(checks);
  return checks.exit_code();
}
