// SPDX-License-Identifier: LGPL-2.1-or-later
// Polynomials of degree p - 2 on the faces of the softer body of a pair are stable on any two
// meshes: γ² = min q C_h q/q C_ref q, with C_ref from meshes whose cells are split once, of two
// degrees more.

#include <signorini/discretization/space/linear_system.h>
#include <signorini/solvers/contact/compliance.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>

#include "graded.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** Whole numbers and moduli at random. */
class Choice {
public:
  explicit Choice(const unsigned int seed)
    : random_(seed) {
    random_();
  }
  /** Returns a number between two others. */
  double between(const double low, const double high) {
    return low + 0.5 * (random_() + 1.) * (high - low);
  }
  unsigned int one_of(const unsigned int first, const unsigned int last) {
    return std::min(last, static_cast<unsigned int>(between(first, last + 1.)));
  }

private:
  RandomNumbers random_;
};

/** Two blocks of one width and their contact sides, which face each other everywhere. */
std::string random_blocks(Choice &choice) {
  const auto by_body = [](const auto &a, const auto &b) {
    return "a: " + std::to_string(a) + " | b: " + std::to_string(b) + "\n";
  };
  const auto cells = [&choice] { return choice.one_of(1, 6); };
  const unsigned int of_a = cells(), of_b = cells();
  constexpr double magnitudes = 3.;
  return "Geometry/Bodies = a b\nGeometry/Lower left = a: 0, 0 | b: 0, -1\n"
         "Geometry/Upper right = a: 1, 1 | b: 1, 0\nGeometry/Cells = a: " +
         std::to_string(of_a) + ", " + std::to_string((of_a + 1) / 2) +
         " | b: " + std::to_string(of_b) + ", " + std::to_string((of_b + 1) / 2) +
         "\nMaterial/Young's modulus = " +
         by_body(1., std::pow(10., choice.between(-magnitudes, magnitudes))) +
         "Material/Poisson's ratio = " +
         by_body(choice.between(0., 0.45), choice.between(0., 0.45)) + "Boundary/Contact = " +
         (choice.one_of(0, 1) == 0 ? "a.bottom with b.top" : "b.top with a.bottom") +
         "\nBoundary/Clamped = a.top b.bottom\n";
}

/** Each body has its own degree, and cells on the contact side that are split up to six times. */
MeshPlan random_plan(const Scene<2> &scene, Choice &choice) {
  MeshPlan plan = uniform_plan(0, 2);
  const std::array<unsigned int, 2> degrees = {{choice.one_of(2, 7), choice.one_of(2, 7)}};
  const Mesh<2> coarse = make_mesh(plan, scene);
  for (const auto &cell : coarse.triangulation().active_cell_iterators())
    plan.demands[cell->id()].degree = degrees[scene.geometry.body_of(cell)];
  const std::array<double, 2> towards = {{choice.between(0., 1.), choice.between(0., 1.)}};
  const std::array<unsigned int, 2> layers = {{choice.one_of(0, 6), choice.one_of(0, 6)}};
  for (unsigned int round = 0; round < 6; ++round) {
    const Mesh<2> mesh = make_mesh(plan, scene);
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (const unsigned int body = scene.geometry.body_of(cell); round < layers[body])
        for (const auto &face : cell->face_iterators())
          if (std::abs(face->center()[1]) < 1e-12 &&
              std::abs(face->center()[0] - towards[body]) <= 0.5 * face->measure())
            plan.demands[cell->id()].split = true;
  }
  return plan;
}

/** A plan whose cells are those of a mesh, split once, of two degrees more. */
MeshPlan finer(MeshPlan plan, const GradedLevel &level) {
  const std::vector<unsigned int> degrees = degrees_of(level.space());
  for (const auto &cell : level.mesh().triangulation().active_cell_iterators())
    plan.demands[cell->id()] = {true, degrees[cell->active_cell_index()] + 2};
  return plan;
}

dealii::FullMatrix<double> compliance(const GradedLevel &level) {
  const LinearSystem<2> system = assemble_linear_system(level.space(), level.scene, 3);
  const Coupling &D = level.discretization.condensed_D;
  const auto inverse =
    factorise(system.matrix, system.unit, LinearSolver::condensed, contact_unknowns(D));
  return make_compliance(*inverse, D)->dense();
}

/** Returns the values of all multipliers of one space at the nodes of a finer one. */
dealii::FullMatrix<double> transfer(const MultiplierSpace<2> &from, const MultiplierSpace<2> &to) {
  dealii::FullMatrix<double> T(to.n_multipliers(), from.n_multipliers());
  const auto &patches = from.surface().patches();
  for (unsigned int k = 0; k < T.m(); ++k) {
    const dealii::Point<1> s = to.node(k);
    unsigned int patch = 0;
    while (patches[patch].upper[0] < s[0])
      ++patch;
    for (unsigned int i = from.first_of(patch); i < from.first_of(patch + 1); ++i) {
      Pressure unit(T.n());
      unit[i] = 1.;
      T(k, i) = from.value(unit, patch, s);
    }
  }
  return T;
}

/** Returns γ. */
double stability(const std::string &text, const MeshPlan &plan) {
  const GradedLevel level(text, plan), reference(text, finer(plan, level));
  const auto T = transfer(level.multipliers(), reference.multipliers());
  const unsigned int m = T.n();
  dealii::FullMatrix<double> on_T(T.m(), m), of_reference(m, m);
  compliance(reference).mmult(on_T, T);
  T.Tmmult(of_reference, on_T);
  dealii::LAPACKFullMatrix<double> C(m), C_ref(m);
  C = compliance(level);
  C_ref = of_reference;
  std::vector<dealii::Vector<double>> none;
  C.compute_generalized_eigenvalues_symmetric(C_ref, none);
  double least = 1.;
  for (unsigned int i = 0; i < m; ++i)
    least = std::min(least, C.eigenvalue(i).real());
  return std::sqrt(std::max(0., least));
}

/** The carrier is the softer body, whichever is named first. γ is at most one, as C_h ≤ C_ref on
 * nested meshes. */
void random_pairs(Checks &checks) {
  std::vector<unsigned int> seeds(60);
  for (unsigned int i = 0; i < seeds.size(); ++i)
    seeds[i] = i + 1;
  constexpr unsigned int n_rows = 6;
  for (const unsigned int seed : checks.rows(seeds, n_rows)) {
    Choice choice(seed);
    const std::string text = random_blocks(choice);
    const MeshPlan plan = random_plan(scene_of(text + "Discretization/Strategy = hp\n"), choice);
    checks.between("gamma", stability(text, plan), 0.55, 1. + 1e-9);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {random_pairs});
}
