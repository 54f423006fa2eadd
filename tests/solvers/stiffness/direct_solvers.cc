// SPDX-License-Identifier: LGPL-2.1-or-later
// The direct solvers: known answers, counted solves, singular matrices, and numbers of ranks.

#include <signorini/base/errors.h>
#include <signorini/discretization/space/linear_system.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/solvers/stiffness/condensed_inverse.h>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
bool one_rank() {
  return dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
}

std::vector<LinearSolver> solvers() {
  std::vector<LinearSolver> all = {LinearSolver::automatic, LinearSolver::amesos_klu,
                                   LinearSolver::amesos_mumps};
  if (one_rank())
    all.push_back(LinearSolver::condensed);
  return all;
}

struct System {
  System(Scene<2> given_scene, const unsigned int level)
    : scene(std::move(given_scene))
    , mesh(scene.geometry, level, level, ranks_for(scene, level))
    , space(mesh, scene)
    , A(std::move(assemble_linear_system(space, scene, 3).matrix)) {}

  DualVector random_vector(const unsigned int seed) const {
    RandomNumbers random(seed);
    return random_rows(space, random);
  }

  Scene<2> scene;
  Mesh<2> mesh;
  DisplacementSpace<2> space;
  dealii::TrilinosWrappers::SparseMatrix A;
};

const std::string clamped = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

/** The same body with nothing that holds it. */
Scene<2> loose() {
  Scene<2> scene = scene_of(clamped);
  for (auto &condition : scene.boundary)
    condition.role = Role::free;
  scene.contacts.clear();
  return scene;
}

/** Held against all motions but one. */
Scene<2> sliding() {
  Scene<2> scene = loose();
  scene.boundary[scene.geometry.find_side("left")].role = Role::roller;
  return scene;
}

void known_answers(Checks &checks) {
  const System system(scene_of(clamped), 3);
  const DualVector exact = system.random_vector(1);
  DualVector b = system.space.make_vector(), x = b;
  system.A.vmult(b, exact);
  for (const LinearSolver solver : solvers()) {
    checks.about(to_text(solver));
    const auto inverse = factorise(system.A, 4., solver);
    checks.that("no solve yet", inverse->n_solves() == 0);
    inverse->solve(x, b);
    x *= 4.;
    checks.near("known answer", relative_distance(x, exact), 0., 1e-12);
    inverse->solve(x, system.space.make_vector());
    checks.near("b = 0", x.linfty_norm(), 0., 0.);
    checks.that("solves are counted", inverse->n_solves() == 2);
    checks.between("residual", inverse->max_residual(), 1e-18, 1e-12);
  }
}

/** Whether two answers agree: bit by bit on one rank; on several ranks MUMPS adds contributions in
 * the order in which they arrive, and last digits differ. */
bool same(const DualVector &a, const DualVector &b, const double tolerance) {
  return relative_distance(a, b) <= (one_rank() ? 0. : tolerance);
}

/** Loads as smooth and as rough as they come, very large and very small ones. */
std::vector<DualVector> different_loads(const System &system) {
  std::vector<DualVector> loads;
  for (const unsigned int seed : {11U, 12U, 13U})
    loads.push_back(system.random_vector(seed));
  loads[1] *= 1e12;
  // A force at one node, and A times something rough: the answers differ by orders of magnitude.
  loads.push_back(system.space.make_vector());
  const auto middle = loads.back().size() / 2;
  if (system.space.locally_owned().is_element(middle))
    loads.back()(middle) = 1e-9;
  loads.back().compress(dealii::VectorOperation::insert);
  loads.push_back(system.space.make_vector());
  system.A.vmult(loads.back(), system.random_vector(14));
  return loads;
}

/** Earlier solves change no bit of an answer; several at once are several.
 * @param is_refined whether steps of refinement are needed. */
void without_history(Checks &checks, const std::string &body, const System &system,
                     const bool is_refined, const double tolerance) {
  const std::vector<DualVector> loads = different_loads(system);
  for (const LinearSolver solver : solvers()) {
    const std::string name = body + ", " + to_text(solver);
    const auto inverse = factorise(system.A, 1., solver);
    std::vector<DualVector> first;
    for (const DualVector &b : loads) {
      first.push_back(inverse->make_vector());
      inverse->solve(first.back(), b);
    }
    checks.that(name + (is_refined ? ": refined" : ": not refined"),
                (inverse->rounding_error() > 0.) == is_refined);
    bool unchanged = true;
    for (std::size_t k = loads.size(); k-- > 0;) {
      DualVector x = inverse->make_vector();
      x = 1e5;
      inverse->solve(x, loads[k]);
      unchanged = unchanged && same(x, first[k], tolerance);
    }
    checks.that(name + ": the same answer after other loads", unchanged);
    std::vector<DualVector> several(loads.size(), inverse->make_vector());
    const unsigned int n_solves = inverse->n_solves();
    inverse->solve(several, loads);
    double largest = 0.;
    for (std::size_t k = 0; k < loads.size(); ++k)
      largest = std::max(largest, relative_distance(several[k], first[k]));
    checks.near(name + ": several at once", largest, 0., tolerance);
    checks.that(name + ": each of several counts", inverse->n_solves() == n_solves + loads.size());
  }
}

/** A singular matrix is refused before any load. */
void singular(Checks &checks, const std::string &body, const System &system) {
  for (const LinearSolver solver : solvers())
    checks.throws<ComputationError>(body + ", " + to_text(solver), "singular",
                                    [&]() { factorise(system.A, 1., solver); });
}

/** The meaning of a value of Linear solver on these ranks. */
void choice(Checks &checks) {
  const System system(scene_of(clamped), 3);
  const auto automatic = factorise(system.A, 1., LinearSolver::automatic);
  checks.that("automatic is condensed on one rank only",
              (dynamic_cast<const CondensedInverse *>(automatic.get()) != nullptr) == one_rank());
  if (one_rank())
    return;
  checks.throws<dealii::ExceptionBase>("condensed is refused on several", "on one rank only",
                                       [&]() { factorise(system.A, 1., LinearSolver::condensed); });
}

} // namespace

int main(int argc, char **argv) {
  return run_tests(
    argc, argv, {[](Checks &checks) {
      known_answers(checks);
      choice(checks);
      without_history(checks, "square", System(scene_of(clamped), 3), false, 1e-13);
      // Ill-conditioned but regular.
      without_history(checks, "slender bar",
                      System(scene_of("Geometry/Upper right = 30, 1\nGeometry/Cells = 30, "
                                      "1\nBoundary/Clamped = left\nBoundary/Contact = bottom\n"),
                             1),
                      true, 1e-9);
      for (const unsigned int level : {0U, 1U, 3U, 5U}) {
        singular(checks, "loose body, level " + std::to_string(level), System(loose(), level));
        singular(checks, "sliding body, level " + std::to_string(level), System(sliding(), level));
      }
    }});
}
