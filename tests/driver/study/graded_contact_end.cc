// SPDX-License-Identifier: LGPL-2.1-or-later
// Graded meshes at the end of a contact zone, where u ~ r^{3/2}: the error falls by the same factor
// from step to step wherever contact ends.

#include <signorini/verification/catalogue/catalogue.h>

#include <deal.II/base/numbers.h>

#include "graded_steps.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** f(x + shift). */
FunctionPointer<2> shifted(const FunctionPointer<2> &f, const dealii::Tensor<1, 2> &shift) {
  using Point = dealii::Point<2>;
  std::vector<std::function<double(const Point &)>> values;
  std::vector<std::function<dealii::Tensor<1, 2>(const Point &)>> gradients;
  for (unsigned int c = 0; f != nullptr && c < f->n_components; ++c) {
    values.emplace_back([=](const Point &x) { return f->value(x + shift, c); });
    gradients.emplace_back([=](const Point &x) { return f->gradient(x + shift, c); });
  }
  return f == nullptr ? nullptr
                      : std::make_shared<dealii::FunctionFromFunctionObjects<2>>(values, gradients);
}

/** B1 with contact on (0, xi): its field depends on x - xi, and its gap is zero. */
Scene<2> make_b1(const Parameters &parameters, const double xi, const bool is_known) {
  Scene<2> scene = make_scene<2>(parameters, named_scenes());
  const auto move = [shift = dealii::Point<2>(dealii::numbers::SQRT1_2 - xi, 0.)](
                      FunctionPointer<2> &function) { function = shifted(function, shift); };
  move(scene.exact_displacement);
  move(scene.body_force);
  for (BoundaryCondition<2> &condition : scene.boundary)
    move(condition.data);
  for (ContactCondition<2> &contact : scene.contacts) {
    move(contact.gap);
    move(contact.exact_pressure);
  }
  scene.kinks = is_known ? Kinks<2>(lines_at<2>({{{xi}, {}}})) : Kinks<2>();
  for (const ContactCondition<2> &contact : scene.contacts)
    scene.kinks.add_ends_on(scene.geometry.sides[contact.side]);
  return scene;
}

std::vector<GradedStep> solve_b1(const double xi, const bool is_known) {
  const Parameters parameters = parse_parameters(named_scene("B1"), "test", graded("3e-8"));
  return steps_of(run(parameters, make_b1(parameters, xi, is_known)).levels);
}

/** By how much the error falls in every step, until it is below 1e-7. */
void check_fall(Checks &checks, const std::vector<GradedStep> &steps) {
  for (std::size_t k = 1; k < steps.size(); ++k)
    if (steps[k - 1].error > 1e-7)
      checks.between("every step divides the error", steps[k - 1].error / steps[k].error, 8., 100.);
}

/** The program has to find the end, which is no node of any mesh; or it is a kink of the data: a
 * node of all meshes, whose cells are as narrow as it is near to other nodes. */
void check_b1(Checks &checks) {
  for (const bool is_known : {false, true}) {
    std::vector<std::vector<GradedStep>> runs;
    std::vector<double> unknowns;
    for (const double xi : checks.rows<double>({0.29, 0.38, 0.52, 0.63}, 2)) {
      checks.about((is_known ? "kink, xi = " : "xi = ") + std::to_string(xi));
      runs.push_back(solve_b1(xi, is_known));
      unknowns.push_back(unknowns_between(runs.back(), 1e-6));
      check_fall(checks, runs.back());
      if (is_known)
        checks.between("unknowns for 1e-6", unknowns.back(), 0., 12000.);
      else
        checks.between("error of step 5", runs.back().at(5).error, 0., 1e-7);
      for (std::size_t k = 0; k < std::min(runs[0].size(), runs.back().size()) && !is_known; ++k)
        if (std::min(runs[0][k].error, runs.back()[k].error) > 1e-8)
          checks.between("error over that of the first", runs.back()[k].error / runs[0][k].error,
                         0.5, 2.);
    }
    const auto [fewest, most] = std::minmax_element(unknowns.begin(), unknowns.end());
    if (is_known)
      checks.between("B1 with kinks, ratio of the unknowns", *most / *fewest, 1., 1.6);
  }
}

} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {check_b1});
}
