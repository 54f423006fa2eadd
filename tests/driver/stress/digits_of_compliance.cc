// SPDX-License-Identifier: LGPL-2.1-or-later
// How many digits of C = D^T A^{-1} D are lost: read from the factor against one refined solve per
// column.

#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include "stress.h"

using namespace Signorini;

namespace {
void test(Checks &checks) {
  std::ofstream table("digits_of_compliance.md");
  table << "| scene | cond(C) | condensed against columns | rounding of the columns "
           "|\n|---|---|---|---|\n";
  const auto modulus = [](const std::string &E) {
    return std::pair("bottom layer of E = " + E,
                     entry("Material", "Young's modulus", "y < 0.25 ? " + E + " : 1"));
  };
  const auto height = [](const std::string &h) {
    return std::pair("height " + h, entry("Geometry", "Upper right", "1, " + h));
  };
  const auto b_bar = [](const std::string &nu) {
    return std::pair("B-bar, ν = " + nu, entry("Material", "Poisson's ratio", nu) +
                                           entry("Discretization", "Element", "Q1 B-bar"));
  };
  for (const auto &[name, text] : std::vector<std::pair<std::string, std::string>>{
         {"square", ""},
         {"H = h", entry("Discretization", "Patch ratio", "1")},
         b_bar("0.4999"),
         b_bar("0.499999"),
         b_bar("0.49999999"),
         modulus("1e-8"),
         modulus("1e4"),
         modulus("1e6"),
         modulus("1e8"),
         height("0.01"),
         height("10"),
         height("100")}) {
    const OneLevel level(
      "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" + text, 5);
    const LinearSystem<2> system = assemble_linear_system(level.space(), level.scene, 3);
    const Coupling &D = level.discretization.condensed_D;
    const auto condensed =
      factorise(system.matrix, system.unit, LinearSolver::condensed, contact_unknowns(D));
    const auto columns = factorise(system.matrix, system.unit, LinearSolver::amesos_klu);
    double lost = 0., size = 0.;
    const dealii::FullMatrix<double> C = make_compliance(*condensed, D)->dense(),
                                     other = make_compliance(*columns, D)->dense();
    for (unsigned int i = 0; i < C.m(); ++i)
      for (unsigned int j = 0; j < C.n(); ++j) {
        lost = std::max(lost, std::abs(C(i, j) - other(i, j)));
        size = std::max(size, std::abs(other(i, j)));
      }
    table << "| " << name << " | " << std::setprecision(2) << condition_number(C) << " | "
          << lost / size << " | " << columns->rounding_error() << " |\n";
    checks.near(name + ": both agree as far as the refinement of columns says", lost / size, 0.,
                name == "square" ? 1e-12 : std::max(1e-10, 100. * columns->rounding_error()));
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test});
}
