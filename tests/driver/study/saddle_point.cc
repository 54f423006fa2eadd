// SPDX-License-Identifier: LGPL-2.1-or-later
// Projected SOR and active set on the dual problem give the solution of the mixed problem (5),
// which is solved here as a whole, without C: in every scene of the catalogue and in some described
// ones. Every sweep of projected SOR lowers the dual objective.

#include <signorini/problem/catalogue/catalogue.h>
#include <signorini/solvers/contact/projected_methods.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>

#include <algorithm>
#include <map>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
using Vector = dealii::Vector<double>;

namespace
{
/** The largest value of a quantity over all scenes, so that more scenes need no more lines. */
class LargestValues
{
public:
  void add(const std::string &quantity, const std::string &scene, const double value)
  {
    auto &largest = values_.emplace(quantity, std::make_pair(value, scene)).first->second;
    if (!(value <= largest.first))
      largest = {value, scene};
  }
  void check(Checks &checks, const std::string &quantity, const double bound) const
  {
    const auto &largest = values_.at(quantity);
    if (!(largest.first <= bound))
      std::cout << "in scene " << largest.second << ":\n";
    checks.between(quantity, largest.first, 0., bound);
  }

private:
  std::map<std::string, std::pair<double, std::string>> values_;
};

/** Solution of the mixed problem (5): displacements, pressures, and W = D^T U - G. */
struct MixedSolution
{
  Displacement U;
  Vector P, W;
  bool converged = false;
};

/**
 * The system in (U, P) as a whole, U of size n, P of size m:
 *
 *     A U - D P = f,   (D^T U)_i = G_i where patch i is active,   P_i = 0 elsewhere,
 *
 * factorised by UMFPACK for one active set after the other until P and W have the right signs.
 */
class MixedProblem
{
public:
  explicit MixedProblem(const OneLevel &level)
    : level_(level)
    , system_(assemble_linear_system(level.space(), level.scene, level.discretization.n_points))
    , n_(level.space().dofs().n_dofs())
    , m_(level.multipliers().n_multipliers())
  {
    dealii::DynamicSparsityPattern pattern(n_ + m_);
    for (const auto &entry : system_.matrix)
      pattern.add(entry.row(), entry.column());
    for (unsigned int i = 0; i < m_; ++i)
    {
      pattern.add(n_ + i, n_ + i);
      for (const auto &entry : level.discretization.condensed_D.column(i))
      {
        pattern.add(entry.first, n_ + i);
        pattern.add(n_ + i, entry.first);
      }
    }
    pattern_.copy_from(pattern);
    // W of the prescribed displacements alone.
    prescribed_ =
      level.discretization.D.transpose_product(level.space().complete(level.space().make_vector()));
    const Vector lengths = level.multipliers().integrals();
    for (unsigned int i = 0; i < m_; ++i)
      weights_.push_back(system_.matrix.linfty_norm() / (lengths[i] * lengths[i]));
  }

  MixedSolution solve() const
  {
    std::vector<bool> active(m_, true);
    MixedSolution solution;
    for (unsigned int step = 0; step < 50 && !solution.converged; ++step)
    {
      solution = solve_for(active);
      const double small = 1e-12 * std::max(solution.P.linfty_norm(), 1e-6);
      solution.converged = true;
      for (unsigned int i = 0; i < m_; ++i)
      {
        const double predicted = solution.P[i] - weights_[i] * solution.W[i];
        active[i] = predicted < 0.;
        solution.converged =
          solution.converged && std::abs(solution.P[i] - std::min(0., predicted)) <= small;
      }
    }
    // The system was solved for A/unit and f/unit, and so for P/unit.
    solution.P *= system_.unit;
    return solution;
  }

private:
  MixedSolution solve_for(const std::vector<bool> &active) const
  {
    dealii::SparseMatrix<double> matrix(pattern_);
    Vector x(n_ + m_);
    for (const auto &entry : system_.matrix)
      matrix.set(entry.row(), entry.column(), entry.value());
    for (unsigned int j = 0; j < n_; ++j)
      x[j] = system_.f(j) / system_.unit;
    for (unsigned int i = 0; i < m_; ++i)
    {
      for (const auto &entry : level_.discretization.condensed_D.column(i))
      {
        matrix.set(entry.first, n_ + i, -entry.second);
        if (active[i])
          matrix.set(n_ + i, entry.first, entry.second);
      }
      if (!active[i])
        matrix.set(n_ + i, n_ + i, 1.);
      x[n_ + i] = active[i] ? level_.discretization.G[i] - prescribed_[i] : 0.;
    }
    dealii::SparseDirectUMFPACK inverse;
    inverse.solve(matrix, x);
    MixedSolution solution;
    DistributedVector free_values = level_.space().make_vector();
    std::copy_n(x.begin(), n_, free_values.begin());
    solution.U = level_.space().complete(free_values);
    solution.P = Vector(x.begin() + n_, x.end());
    solution.W = level_.discretization.D.transpose_product(solution.U);
    solution.W -= level_.discretization.G;
    return solution;
  }

  const OneLevel &level_;
  LinearSystem<2> system_;
  unsigned int n_, m_;
  dealii::SparsityPattern pattern_;
  Vector prescribed_;
  /** Pressure per W that decides about a patch; any positive numbers give the same solution. */
  std::vector<double> weights_;
};

/**
 * A sweep lowers the objective by at least (1/omega - 1/2) sum C_ii (P_i^{k+1} - P_i^k)²: each of
 * its steps is part of the way, at most omega times, to the minimum along a coordinate.
 * @return by how much the worst of @p n_sweeps misses this, relative to the energies.
 */
double missing_decrease(const BoundConstrainedQP &qp,
                        const double relaxation,
                        const unsigned int n_sweeps)
{
  Vector P(qp.size());
  double worst = 0., energy = qp.energy(P);
  for (unsigned int sweep = 0; sweep < n_sweeps; ++sweep)
  {
    const Vector before = P;
    psor_sweep(qp, relaxation, P);
    double expected = 0.;
    for (unsigned int i = 0; i < P.size(); ++i)
      expected +=
        (1. / relaxation - 0.5) * qp.diagonal[i] * (P[i] - before[i]) * (P[i] - before[i]);
    const double next = qp.energy(P);
    worst = std::max(worst, (next - energy + expected) / std::abs(P * qp.F));
    energy = next;
  }
  return worst;
}

/** The first level with at least 600 unknowns. */
unsigned int choose_level(const std::string &text)
{
  unsigned int level = 2;
  while (level < 6 && OneLevel(text, level).space().dofs().n_dofs() < 600)
    ++level;
  return level;
}

/** @return the pressures of the mixed problem. */
Vector check_scene(LargestValues &largest, const std::string &name, const std::string &text)
{
  const unsigned int number = choose_level(text);
  const OneLevel exact(text, number);
  const MixedSolution mixed = MixedProblem(exact).solve();
  largest.add("the mixed problem is not solved", name, mixed.converged ? 0. : 1.);
  const double U_size = mixed.U.linfty_norm();
  const double P_size = mixed.P.linfty_norm();
  for (const std::string solver : {"psor", "active set"})
  {
    std::string with_solver = text;
    with_solver += entry("Solver", "Contact solver", solver);
    with_solver += entry("Solver", "Tolerance", "1e-12");
    with_solver += entry("Output", "Compliance", "true");
    const OneLevel level(with_solver, number);
    const LevelSolution<2> solution = level.solve();
    const double P_distance = distance(solution.P, mixed.P);
    largest.add(solver + ", U", name, distance(solution.U, mixed.U) / U_size);
    largest.add(solver + ", P", name, P_size > 0. ? P_distance / P_size : P_distance);
    if (solver == "psor" && solution.dual->C != nullptr)
      for (const char *relaxation : {"0.5", "1.1", "1.8"})
        largest.add(
          std::string("objective, relaxation ") + relaxation,
          name,
          missing_decrease(BoundConstrainedQP(solution.dual->C->dense(), solution.dual->F),
                           std::stod(relaxation),
                           300));
  }
  return mixed.P;
}

const std::map<std::string, std::string> described = {
  {"two contact sides",
   "subsection Boundary\nset Clamped = top\nset Contact = bottom left\nend\n" +
     entry("Load", "Body force", "-0.4; -0.5*x") +
     entry("Contact", "Gap", "bottom: 0.3*x^2 | left: 0.1*y")},
  {"patches aligned with nothing",
   "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" +
     entry("Load", "Body force", "0; -1") + entry("Contact", "Gap", "2*(x-0.4)^2") +
     entry("Discretization", "Patches", "11")},
  {"oblique rollers",
   "subsection Geometry\nset Shape = polygon\nset Vertices = 0,0; 2,0; 2.5,1.5; 1,2.5; "
   "-0.5,1\nend\n"
   "subsection Boundary\nset Contact = side0 side4\nset Rollers = side1 side2\nend\n" +
     entry("Load", "Body force", "-0.1; -0.3") +
     entry("Contact", "Gap", "side0: 0.4*(x-1)^2 | side4: 0.2*y")},
  {"prescribed displacement",
   "subsection Boundary\nset Displacement = top: 0.01*x; -0.05\nset Rollers = left\n"
   "set Contact = bottom\nend\n" +
     entry("Contact", "Gap", "0.01+0.06*(x-0.8)^2")},
  {"prescribed displacement of the contact corner",
   "subsection Boundary\nset Displacement = left: 0.01; -0.02*(1-y)\nset Contact = bottom\n"
   "set Traction = top: 0; -0.1\nend\n" +
     entry("Contact", "Gap", "0.3*x^2")}};
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  LargestValues largest;
  for (const CatalogueEntry<2> &scene : catalogue<2>())
    check_scene(largest, scene.name, entry("Scene", "Name", scene.name));
  for (const auto &scene : described)
  {
    const Vector P = check_scene(largest, scene.first, scene.second);
    const double threshold = -1e-6 * P.linfty_norm();
    const auto active =
      std::count_if(P.begin(), P.end(), [&](const double p) { return p < threshold; });
    checks.between(scene.first + ": some patches press, some do not", active, 1., P.size() - 1.);
  }
  largest.check(checks, "the mixed problem is not solved", 0.);
  for (const char *quantity : {"psor, U", "active set, U", "psor, P", "active set, P"})
    largest.check(checks, quantity, 1e-9);
  for (const char *relaxation : {"0.5", "1.1", "1.8"})
    largest.check(checks, std::string("objective, relaxation ") + relaxation, 1e-13);
  return checks.exit_code();
}
