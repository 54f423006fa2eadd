// SPDX-License-Identifier: LGPL-2.1-or-later
// Graded meshes at the end of a contact zone, where u ~ r^{3/2}: the error falls by the same factor
// from step to step wherever contact ends, and in a nearly incompressible body, too.

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include "graded_steps.h"
#include "tests.h"

using namespace Signorini;

namespace
{
/** f(x + shift e_1). */
class Shifted : public dealii::Function<2>
{
public:
  Shifted(FunctionPointer<2> function, const double shift)
    : dealii::Function<2>(function->n_components)
    , function_(std::move(function))
    , shift_({shift, 0.})
  {
  }
  double value(const dealii::Point<2> &x, const unsigned int component) const override
  {
    return function_->value(x + shift_, component);
  }
  dealii::Tensor<1, 2> gradient(const dealii::Point<2> &x,
                                const unsigned int component) const override
  {
    return function_->gradient(x + shift_, component);
  }

private:
  FunctionPointer<2> function_;
  dealii::Tensor<1, 2> shift_;
};

/** B1 with contact on (0, xi): its field depends on x - xi, and its gap is zero. */
Scene<2> make_b1(const Parameters &parameters, const double xi, const bool is_known)
{
  Scene<2> scene = make_scene<2>(parameters);
  const double shift = dealii::numbers::SQRT1_2 - xi;
  const auto move = [shift](FunctionPointer<2> &function) {
    if (function != nullptr)
      function = std::make_shared<Shifted>(function, shift);
  };
  move(scene.exact_displacement);
  move(scene.body_force);
  for (BoundaryCondition<2> &condition : scene.boundary)
  {
    move(condition.data);
    move(condition.exact_pressure);
  }
  scene.kinks = is_known ? Kinks<2>(lines_at<2>({{{xi}, {}}})) : Kinks<2>();
  for (const unsigned int side : scene.contact_sides())
    scene.kinks.add_ends_on(scene.geometry.sides[side]);
  return scene;
}

std::vector<GradedStep> solve_b1(const double xi, const bool is_known)
{
  std::ostream silence(nullptr);
  const Parameters parameters = parse_parameters(named_scene("B1"), "test", graded("3e-8"));
  return steps_of(run_study(parameters,
                            make_b1(parameters, xi, is_known),
                            MPI_COMM_WORLD,
                            {silence, "", [](const std::string &) {}})
                    .levels);
}

/** By how much the error falls in the worst step, until it is below 1e-7. */
double slowest_fall(const std::vector<GradedStep> &steps)
{
  constexpr double enough = 1e-7;
  double slowest = INFINITY;
  for (std::size_t k = 1; k < steps.size(); ++k)
    if (steps[k - 1].error > enough)
      slowest = std::min(slowest, steps[k - 1].error / steps[k].error);
  return slowest;
}

/** The largest ratio, over the steps, of the errors at different xi. */
double largest_spread(const std::vector<std::vector<GradedStep>> &runs)
{
  double spread = 0.;
  for (std::size_t k = 0;; ++k)
  {
    double smallest = INFINITY, largest = 0.;
    for (const std::vector<GradedStep> &steps : runs)
    {
      if (steps.size() <= k || steps[k].error < 1e-8)
        return spread;
      smallest = std::min(smallest, steps[k].error);
      largest = std::max(largest, steps[k].error);
    }
    spread = std::max(spread, largest / smallest);
  }
}

const double ends_of_contact[] = {0.29, 0.38, 0.52, 0.63};

/** The program has to find the end, which is no node of any mesh. */
void check_unknown_ends(Checks &checks)
{
  std::vector<std::vector<GradedStep>> runs;
  for (const double xi : ends_of_contact)
  {
    runs.push_back(solve_b1(xi, false));
    const std::string name = "B1, xi = " + std::to_string(xi).substr(0, 4);
    checks.between(
      name + ", by which every step divides the error", slowest_fall(runs.back()), 8., 100.);
    checks.between(name + ", error of step 5", runs.back().at(5).error, 0., 1e-7);
  }
  checks.between("B1, largest over smallest error of a step", largest_spread(runs), 1., 2.);
}

/** The end is a kink of the data: a node of all meshes, whose cells are as narrow as it is near to
 * other nodes. */
void check_known_ends(Checks &checks)
{
  double fewest = INFINITY, most = 0.;
  for (const double xi : ends_of_contact)
  {
    const std::vector<GradedStep> steps = solve_b1(xi, true);
    checks.between("B1, kink at " + std::to_string(xi).substr(0, 4) +
                     ": a step divides the error by",
                   slowest_fall(steps),
                   8.,
                   100.);
    const double n_unknowns = unknowns_between(steps, 1e-6);
    fewest = std::min(fewest, n_unknowns);
    most = std::max(most, n_unknowns);
  }
  checks.between("B1 with kinks, unknowns for 1e-6", most, 0., 12000.);
  checks.between("B1 with kinks, ratio of these", most / fewest, 1., 1.6);
}

// The field of B1 without the cut-off, which is bounded as nu tends to 1/2: u and sigma of
// Westergaard's function Z = i (z-xi)^{1/2} with mu = 1, a = 1 - 2 nu, b = 2 - 2 nu,
//
//   2 u1 = a Re Zh - y Im Z,   2 u2 = b Im Zh - y Re Z,   Zh = int Z = 2 i/3 (z-xi)^{3/2}.
const std::string r2 = "((x-xi)^2+y^2)", theta = "atan2(y,x-xi)";
const std::string Re_Z = "(-" + r2 + "^0.25*sin(0.5*" + theta + "))";
const std::string Im_Z = "(" + r2 + "^0.25*cos(0.5*" + theta + "))";
const std::string Re_Zh = "(-2/3*" + r2 + "^0.75*sin(1.5*" + theta + "))";
const std::string Im_Zh = "(2/3*" + r2 + "^0.75*cos(1.5*" + theta + "))";
const std::string Re_dZ = "(0.5*" + r2 + "^(-0.25)*sin(0.5*" + theta + "))";
const std::string Im_dZ = "(0.5*" + r2 + "^(-0.25)*cos(0.5*" + theta + "))";

std::string incompressible_contact_end()
{
  const std::string u = "(a*" + Re_Zh + "-y*" + Im_Z + ")/2; (b*" + Im_Zh + "-y*" + Re_Z + ")/2";
  const std::string du = "(a*" + Re_Z + "-y*" + Im_dZ + ")/2; (-b*" + Im_Z + "-y*" + Re_dZ +
                         ")/2; (b*" + Im_Z + "-y*" + Re_dZ + ")/2; (a*" + Re_Z + "+y*" + Im_dZ +
                         ")/2";
  return "subsection Constants\n set Values = nu=0.3, xi=0.63, a=1-2*nu, b=2-2*nu\n end\n"
         "subsection Material\n set Young's modulus = 2*(1+nu)\n set Poisson's ratio = nu\n end\n"
         "subsection Boundary\n set Contact = bottom\n set Displacement = left: " +
         u + " | right: " + u + " | top: " + u +
         "\n end\n"
         "subsection Exact solution\n set Displacement = " +
         u + "\n set Displacement gradient = " + du + "\n end\n";
}

std::vector<GradedStep> solve_at(const std::string &nu)
{
  std::vector<std::string> overrides = graded("1e-7");
  overrides.push_back("Constants/nu=" + nu);
  return steps_of(solve(incompressible_contact_end(), overrides).levels);
}

/** No locking: K/mu is 2.2 and 5e5. */
void check_nearly_incompressible(Checks &checks)
{
  const std::vector<GradedStep> usual = solve_at("0.3"), nearly = solve_at("0.499999");
  checks.between(
    "nu = 0.499999, by which every step divides the error", slowest_fall(nearly), 8., 100.);
  for (std::size_t k = 3; k < std::min(usual.size(), nearly.size()); ++k)
    checks.between("nu = 0.499999, step " + std::to_string(k) + ", error over that of nu = 0.3",
                   nearly[k].error / usual[k].error,
                   0.,
                   10.);
  checks.between("nu = 0.499999, unknowns for 1e-6 over those of nu = 0.3",
                 unknowns_between(nearly, 1e-6) / unknowns_between(usual, 1e-6),
                 0.5,
                 2.5);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  check_unknown_ends(checks);
  check_known_ends(checks);
  check_nearly_incompressible(checks);
  return checks.exit_code();
}
