// SPDX-License-Identifier: LGPL-2.1-or-later
// c² beside errors that are known: orders, missed contact, scenes in which c² is the whole bound,
// the contact force; and where there is no bound, that is said.

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <functional>

#include "solved_level.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;
using dealii::Tensor;

namespace
{
/** The slope of log c² over the levels 4 to 7. */
double order(const std::string &name)
{
  double sum = 0.;
  const double weights[] = {-0.3, -0.1, 0.1, 0.3};
  for (unsigned int k = 0; k < 4; ++k)
    sum -= weights[k] * std::log2(SolvedLevel(named(name), 4 + k).lift(true).bound()->square());
  return sum;
}

void missed_contact(Checks &checks)
{
  // The energy that the tip alone needs hardly depends on the mesh.
  const double first = SolvedLevel(missed, 2).lift(true).bound()->square();
  for (const unsigned int number : {3, 4, 5})
  {
    const SolvedLevel s(missed, number);
    const ContactLift lift = s.lift(true);
    const std::string name = "missed contact, level " + std::to_string(number);
    checks.that(name + ": P = 0", s.P.linfty_norm() == 0.);
    checks.between(name + ": c²", lift.bound()->square() / first, 0.3, 1.01);
    checks.near(name + ": penetration", lift.trace().max_penetration(), 0.003, 1e-4);
    checks.near(
      name + ": place", lift.trace().place_of_largest().arc_length, 1.0313, std::pow(0.5, number));
  }
}

/** |||u_h - v|||² of a v with the same essential values. */
double distance_square(const SolvedLevel &s, const std::function<Tensor<1, 2>(Point<2>)> &v)
{
  DistributedVector difference = s.level.space.make_vector(), image = difference;
  for (const auto &cell : s.level.space.dofs().active_cell_iterators())
    for (const unsigned int k : cell->vertex_indices())
      for (unsigned int d = 0; d < 2; ++d)
      {
        const auto i = cell->vertex_dof_index(k, d);
        if (difference.in_local_range(i))
          difference(i) = s.U[i] - v(cell->vertex(k))[d];
      }
  difference.compress(dealii::VectorOperation::insert);
  s.system.matrix.vmult(image, difference);
  return s.system.unit * (difference * image);
}

/** Where u_h is linear, tau = sigma(u_h) is in equilibrium and c² is the whole bound: it is above
 * the distance from the solution on a mesh that sees everything, and not far above. */
void whole_bound(Checks &checks)
{
  // Level 2 sees nothing: u_h = 0.
  const double tip =
    distance_square(SolvedLevel(missed, 7), [](const Point<2> &) { return Tensor<1, 2>(); });
  const double c_square = SolvedLevel(missed, 2).lift(true).bound()->square();
  checks.between("whole bound, missed contact", c_square / tip, 1., 25.);

  // Waves with mean zero on every patch of level 3: u_h is a uniform compression.
  for (const char *height : {"0.0001", "0.001", "-0.001"})
  {
    const std::string waves =
      described("subsection Boundary\nset Rollers = left right\nset Contact = bottom\n"
                "set Displacement = top: 0; -0.01\nend\n" +
                gap(std::string(height) + "*cos(16*pi*x)"));
    const auto uniform = [](const Point<2> &x) {
      Tensor<1, 2> u;
      u[1] = -0.01 * x[1];
      return u;
    };
    const SolvedLevel coarse(waves, 3);
    const std::string name = std::string("whole bound, waves of ") + height;
    checks.near(name + ": u_h is linear", distance_square(coarse, uniform), 0., 1e-15);
    const double error = distance_square(SolvedLevel(waves, 7), uniform);
    checks.between(name, coarse.lift(true).bound()->square() / error, 1., 9.);
  }
}

void no_bound(Checks &checks)
{
  const auto reason = [](const std::string &text) {
    const ContactLift lift = SolvedLevel(text, 3).lift(true);
    return lift.bound() ? "there is a bound" : lift.no_bound();
  };
  const std::string held = described("subsection Boundary\nset Clamped = left\n"
                                     "set Contact = bottom\nset Traction = top: 0; -0.1\nend\n");
  checks.that("a gap that closes a clamp",
              reason(held + gap("-0.01+0.1*x")).find("on bottom at (0, 0)") != std::string::npos);
  checks.that("a foundation that touches a clamp",
              reason(held + gap("0.1*x")) == "there is a bound");
  checks.that("a steep gap at a clamp", reason(held + gap("-0.01*sqrt(x)")) == "there is a bound");
  const std::string pushed = described("subsection Boundary\nset Displacement = right: 0; -0.02\n"
                                       "set Contact = bottom\nset Clamped = left\nend\n");
  checks.that("a prescribed displacement into the foundation",
              reason(pushed + gap("0.01")).find("on bottom at (1, 0)") != std::string::npos);
  checks.that("curved sides", reason(named("E2")) == "there is a bound");
}

double error_square(const SolvedLevel &s)
{
  dealii::FEValues<2> values(s.level.mesh.mapping(),
                             s.level.space.element(),
                             dealii::QIterated<2>(dealii::QGauss<1>(4), 4),
                             dealii::update_gradients | dealii::update_quadrature_points |
                               dealii::update_JxW_values);
  double sum = 0.;
  std::vector<Tensor<2, 2>> found(values.n_quadrature_points);
  std::vector<std::vector<Tensor<1, 2>>> exact(values.n_quadrature_points,
                                               std::vector<Tensor<1, 2>>(2));
  for (const auto &cell : s.level.space.dofs().active_cell_iterators())
  {
    values.reinit(cell);
    values[dealii::FEValuesExtractors::Vector(0)].get_function_gradients(s.U.entries(), found);
    s.scene.exact_displacement->vector_gradient_list(values.get_quadrature_points(), exact);
    for (unsigned int q = 0; q < found.size(); ++q)
    {
      for (unsigned int c = 0; c < 2; ++c)
        found[q][c] -= exact[q][c];
      const auto strain = symmetrize(found[q]);
      sum +=
        strain * (s.scene.material->hooke(values.quadrature_point(q)) * strain) * values.JxW(q);
    }
  }
  return sum;
}

/** A1: int p = -10 xi^4/4; B1: -2/3 xi^{3/2}, xi = 1/sqrt(2). The lift is small beside the error.
 */
void known_solutions(Checks &checks)
{
  const std::pair<const char *, double> scenes[] = {{"A1", -0.625},
                                                    {"B1", -2. / 3. * std::pow(0.5, 0.75)}};
  for (const auto &scene : scenes)
  {
    const std::string name = scene.first;
    const SolvedLevel s(named(name), 5);
    const ContactLift lift = s.lift(true);
    const double error = error_square(s);
    checks.between(name + ": c² beside the error", lift.bound()->square() / error, 0., 0.1);
    const auto z = norm_of_unit_lift(s.level.space, s.scene, lift.trace(), *s.inverse);
    checks.that(name + ": z", z.has_value());
    double force = 0.;
    for (unsigned int k = 0; k < s.P.size(); ++k)
      force += s.P[k] * s.level.surface.patches()[k].measure;
    checks.between(
      name + ": force", std::abs(force - scene.second) / (std::sqrt(error) * z.value()), 0., 1.);
  }
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  missed_contact(checks);
  whole_bound(checks);
  no_bound(checks);
  known_solutions(checks);
  checks.between("A1: order of c²", order("A1"), 3., 5.);
  checks.between("A3: order of c²", order("A3"), 3., 5.);
  checks.between("B1: order of c²", order("B1"), 2., 7.);
  return checks.exit_code();
}
