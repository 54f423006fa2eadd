// SPDX-License-Identifier: LGPL-2.1-or-later
// How many digits of C = D^T A^{-1} D are lost: read from the factor against one refined solve per
// column.

#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include "stress.h"

using namespace Signorini;

namespace
{
/** max |C_ij - C'_ij| / max |C'_ij|. */
double distance(const dealii::FullMatrix<double> &C, const dealii::FullMatrix<double> &other)
{
  double largest = 0., size = 0.;
  for (unsigned int i = 0; i < C.m(); ++i)
    for (unsigned int j = 0; j < C.n(); ++j)
    {
      largest = std::max(largest, std::abs(C(i, j) - other(i, j)));
      size = std::max(size, std::abs(other(i, j)));
    }
  return largest / size;
}

struct Digits
{
  double condition_of_C, lost;
};

Digits
compare(Checks &checks, std::ofstream &table, const std::string &name, const std::string &text)
{
  const OneLevel level(text, 5);
  const LinearSystem<2> system = assemble_linear_system(level.space(), level.scene, 3);
  const Coupling &D = level.discretization.condensed_D;
  const auto condensed =
    factorise(system.matrix, system.unit, LinearSolver::condensed, contact_unknowns(D));
  const auto columns = factorise(system.matrix, system.unit, LinearSolver::amesos_klu);
  double seconds = 0.;
  const dealii::FullMatrix<double> C = make_compliance(*condensed, D, seconds)->dense();
  const dealii::FullMatrix<double> by_columns = make_compliance(*columns, D, seconds)->dense();
  const Digits digits = {condition_number(C), distance(C, by_columns)};
  table << "| " << name << " | " << std::setprecision(2) << digits.condition_of_C << " | "
        << digits.lost << " | " << columns->rounding_error() << " |\n";
  checks.near(name + ": both agree as far as the refinement of columns says",
              digits.lost,
              0.,
              std::max(1e-10, 100. * columns->rounding_error()));
  return digits;
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  std::ofstream table("digits_of_compliance.md");
  table << "| scene | cond(C) | condensed against columns | rounding of the columns "
           "|\n|---|---|---|---|\n";
  const std::string block = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";
  const Digits plain = compare(checks, table, "square", block);
  checks.near("square: all digits but four", plain.lost, 0., 1e-12);
  compare(checks, table, "H = h", block + entry("Discretization", "Patch ratio", "1"));
  for (const char *nu : {"0.4999", "0.499999", "0.49999999"})
    compare(checks,
            table,
            std::string("B-bar, ν = ") + nu,
            block + entry("Material", "Poisson's ratio", nu) +
              entry("Discretization", "Element", "Q1 B-bar"));
  for (const char *modulus : {"1e-8", "1e4", "1e6", "1e8"})
    compare(checks,
            table,
            std::string("bottom layer of E = ") + modulus,
            block +
              entry("Material", "Young's modulus", std::string("y < 0.25 ? ") + modulus + " : 1"));
  for (const char *height : {"0.01", "10", "100"})
    compare(checks,
            table,
            std::string("height ") + height,
            block + entry("Geometry", "Upper right", std::string("1, ") + height));
  return checks.exit_code();
}
