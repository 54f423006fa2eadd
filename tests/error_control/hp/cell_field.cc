// SPDX-License-Identifier: LGPL-2.1-or-later
// u_h on one cell: nodes, Lagrange's polynomials, and gradients of polynomials of all degrees.

#include <signorini/error_control/hp/indicators.h>

#include <algorithm>
#include <cmath>

#include "graded.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace
{
/** Values and derivatives of x^p from its values at the nodes, at nodes, inside and outside. */
void tables(Checks &checks)
{
  for (unsigned int degree = 1; degree <= 12; ++degree)
  {
    const std::vector<double> nodes = nodes_of_edge(degree);
    const std::vector<double> points = {0., 0.1, nodes[degree / 2], 0.77, 1., 1.1};
    const LineTable table = make_line_table(degree, points);
    double error = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      double value = 0., derivative = 0.;
      for (unsigned int i = 0; i <= degree; ++i)
      {
        value += table.values(q, i) * std::pow(nodes[i], degree);
        derivative += table.derivatives(q, i) * std::pow(nodes[i], degree);
      }
      error = std::max({error,
                        std::abs(value - std::pow(points[q], degree)),
                        std::abs(derivative - degree * std::pow(points[q], degree - 1.))});
    }
    checks.near("x^p, p = " + std::to_string(degree), error, 0., 1e-10);
  }
}

/** On cells of the sizes 1/4 and 1/8, ...: the gradient in reference coordinates is h times that of
 * u = (x^p y^{p-1}, x - y^p). */
void gradients(Checks &checks)
{
  const std::string square = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";
  for (unsigned int p = 2; p <= 9; ++p)
  {
    MeshPlan plan = uniform_plan(1, p);
    const GradedLevel level(square, plan);
    const Displacement U = nodal_values(level.space(), [p](const Point<2> &x) {
      return Point<2>(std::pow(x[0], p) * std::pow(x[1], p - 1.), x[0] - std::pow(x[1], p));
    });
    const std::vector<double> along_x = {0., 0.3, 0.9}, along_y = {0.2, 1.};
    const LineTable in_x = make_line_table(p, along_x), in_y = make_line_table(p, along_y);
    double error = 0.;
    for (const auto &cell : level.space().dofs().active_cell_iterators())
    {
      const CellField u(cell, U);
      const auto found = u.gradients(in_x, in_y);
      const Point<2> corner = cell->vertex(0);
      const double h = cell->vertex(1)[0] - corner[0];
      for (unsigned int j = 0; j < 2; ++j)
        for (unsigned int i = 0; i < 3; ++i)
        {
          const double x = corner[0] + h * along_x[i], y = corner[1] + h * along_y[j];
          const dealii::Tensor<2, 2> exact({{p * std::pow(x, p - 1.) * std::pow(y, p - 1.),
                                             (p - 1.) * std::pow(x, p) * std::pow(y, p - 2.)},
                                            {1., -(p * std::pow(y, p - 1.))}});
          error = std::max(error, (found[i + 3 * j] - h * exact).norm());
        }
      error = std::max(error, std::abs(u(1, p, 0) - (corner[0] + h - std::pow(corner[1], p))));
      error = std::max(error, u.degree() == p ? 0. : 1.);
    }
    checks.near("gradients, p = " + std::to_string(p), error, 0., 1e-10);
  }
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  tables(checks);
  gradients(checks);
  return checks.exit_code();
}
