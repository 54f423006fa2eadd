// SPDX-License-Identifier: LGPL-2.1-or-later
// C^ against C of the factorised body; a table of conditions.

#include <signorini/discretization/space/linear_system.h>
#include <signorini/solvers/contact/boundary_model.h>
#include <signorini/solvers/contact/compliance.h>

#include <fstream>
#include <iomanip>

#include "../../driver/box/box.h"
#include "one_level.h"
#include "spectrum.h"
#include "tests.h"

using namespace Signorini;

namespace {
template <int dim>
dealii::FullMatrix<double> compliance_of(const DisplacementSpace<dim> &space,
                                         const Scene<dim> &scene, const Coupling &condensed_D) {
  const LinearSystem<dim> system = assemble_linear_system(space, scene, 2);
  const auto inverse =
    factorise(system.matrix, system.unit, LinearSolver::condensed, contact_unknowns(condensed_D));
  return make_compliance(*inverse, condensed_D)->dense();
}

dealii::FullMatrix<double> dense(const BoundaryModel &model) {
  dealii::FullMatrix<double> C(model.size(), model.size());
  for (unsigned int i = 0; i < C.m(); ++i)
    for (unsigned int j = 0; j < C.n(); ++j)
      C(i, j) = model.entry(i, j);
  return C;
}

enum class Model { chosen, kernel };

/** The extreme eigenvalues of C^^{-1} C, and the number of patches. */
struct Measured {
  Spectrum eigenvalues;
  unsigned int n_patches;
};

Measured measure(const std::string &text, const unsigned int level, const Model model) {
  const OneLevel problem(text, level);
  const auto C = compliance_of(problem.space(), problem.scene, problem.discretization.condensed_D);
  const auto C_hat = model == Model::kernel ? make_kernel_model(problem.multipliers())
                                            : make_boundary_model(problem.multipliers());
  return {spectrum(dense(*C_hat), C), C_hat->size()};
}

Measured measure(const Scene<3> &scene, const unsigned int level, const Model model) {
  const Box box(scene, level, 2);
  const auto C = compliance_of(box.space, scene, box.condensed_D);
  const auto C_hat = model == Model::kernel ? make_kernel_model(box.multipliers)
                                            : make_boundary_model(box.multipliers);
  return {spectrum(dense(*C_hat), C), C_hat->size()};
}

/** Conditions on three levels: below a limit, and the last step's growth, which is that of a
 * logarithm where contact ends at a corner. */
template <typename Body>
void flat(Checks &checks, std::ostream &table, const std::string &name, const Body &text_or_scene,
          const unsigned int coarsest, const Model model, const double limit,
          const double growth = 1.2) {
  Spectrum before = {1., 1.};
  for (unsigned int level = coarsest; level < coarsest + 3; ++level) {
    const auto &[now, n_patches] = measure(text_or_scene, level, model);
    checks.between(name + ", level " + std::to_string(level), now.condition(), 1., limit);
    // The kernel has its moduli right: no factor of size is left.
    checks.between(name + ", largest", now.largest, 0.7, 4.);
    if (level == coarsest + 2)
      checks.between(name + ", growth of the last step", now.condition() / before.condition(), 0.8,
                     growth);
    before = now;
    table << '"' << name << "\"," << level << ',' << n_patches << ',' << std::setprecision(3)
          << now.condition() << '\n';
  }
}

void in_the_plane(Checks &checks, std::ostream &table) {
  const std::string held = "Boundary/Clamped = top\nBoundary/Contact = bottom\n";
  flat(checks, table, "square", held, 4, Model::chosen, 3.);
  flat(checks, table, "square, kernel", held, 4, Model::kernel, 4.4);
  flat(checks, table, "square, two sides",
       "Boundary/Clamped = top\nBoundary/Contact = bottom, right\n", 4, Model::chosen, 31., 1.3);
  flat(checks, table, "distorted square: kernel", held + "Geometry/Distortion = 0.2\n", 3,
       Model::chosen, 5.);
  flat(checks, table, "modulus that grows tenfold along the side",
       held + "Material/Young's modulus = 10^x\n", 4, Model::chosen, 5.);
  flat(checks, table, "half disc: kernel",
       "Geometry/Shape = half disc\nBoundary/Clamped = flat\nBoundary/Contact = arc\n", 3,
       Model::chosen, 7.5);
  flat(checks, table, "ring: kernel",
       "Geometry/Shape = ring\nBoundary/Clamped = outer\nBoundary/Contact = inner\n", 2,
       Model::chosen, 12.5);
}

void in_space(Checks &checks, std::ostream &table) {
  Scene<3> scene = make_box_scene(scalar([](const auto &) { return 0.; }),
                                  field([](const auto &) { return Vector3(); }));
  flat(checks, table, "box between rollers", scene, 2, Model::chosen, 2.);
  flat(checks, table, "box between rollers, kernel", scene, 2, Model::kernel, 4.2, 1.4);
  for (const char *side : {"left", "right", "front", "back"})
    scene.boundary[scene.geometry.find_side(side)].role = Role::free;
  flat(checks, table, "free box", scene, 2, Model::chosen, 3.7);
  const unsigned int left = scene.geometry.find_side("left");
  scene.boundary[left].role = Role::contact;
  scene.contacts.insert(scene.contacts.begin(), scene.contacts[0]);
  scene.contacts[0].side = left;
  flat(checks, table, "box, two sides", scene, 2, Model::chosen, 20., 1.4);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {[](Checks &checks) {
                     std::ofstream table("compliance_model.csv");
                     table << "body,level,patches,condition\n";
                     in_the_plane(checks, table);
                     in_space(checks, table);
                   }});
}
