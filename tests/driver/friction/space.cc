// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction in space: constant strain, states that do not depend on one direction against the same
// in the plane, and torsion, where slip turns.

#include <signorini/discretization/space/nodes.h>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
using Entries = std::vector<std::string>;

/** A level in space that is solved. */
struct SpaceLevel : SolvedBox {
  SpaceLevel(const std::string &text, const unsigned int level, const Entries &overrides = {})
    : SolvedBox(text, level, overrides)
    , m(found.contact.P.normal().size())
    , W(discretization.D.transpose_product(found.contact.U)) {
    W -= discretization.G;
  }

  /** Returns the tangential part of (P_n, P_t) or of W on a patch. */
  dealii::Tensor<1, 2> tangential(const dealii::Vector<double> &v, const unsigned int k) const {
    return dealii::Tensor<1, 2>({v[m + k], v[2 * m + k]});
  }
  double bound(const unsigned int k) const {
    return discretization.K.at(found.contact.P.values())[m + k].upper;
  }

  unsigned int m;
  dealii::Vector<double> W;
};

void check_residuals(Checks &checks, const LevelRecord &record) {
  checks.between("KKT residual", record.dual.kkt, 0., 1e-13);
  checks.between("balance of dissipation", *record.certificate.dissipation_balance, 0., 1e-11);
  checks.between("bipotential gap", record.certificate.complementarity, 0., 1e-11);
  checks.between("duality gap", record.certificate.duality_gap, 0., 1e-11);
  checks.between("forces", record.certificate.force_balance, 0., 1e-11);
  checks.between("moments", record.certificate.moment_balance, 0., 1e-11);
  checks.between("distance from the cone", record.certificate.sign, 0., 1e-15);
}

/** Slip is opposite to the traction, which reaches its bound there; nothing exceeds it. @return the
 * number of patches that slip. */
unsigned int check_law(Checks &checks, const SpaceLevel &level) {
  const dealii::Vector<double> P = level.found.contact.P.values();
  unsigned int n_slip = 0;
  const double slipped = 1e-8 * level.W.linfty_norm();
  for (unsigned int k = 0; k < level.m; ++k) {
    const auto q = level.tangential(P, k), w = level.tangential(level.W, k);
    checks.between("|P_t| <= s", q.norm(), 0., level.bound(k) * (1. + 1e-15));
    if (w.norm() < slipped)
      continue;
    ++n_slip;
    checks.near("|P_t| = s", q.norm(), level.bound(k), 1e-14 * level.bound(k));
    checks.near("slip against P_t", q * w, -level.bound(k) * w.norm(),
                1e-10 * level.bound(k) * w.norm());
  }
  return n_slip;
}

/** Constant strain: u = (0.05, 0.02, 0.125)(1-z), with a shift in an oblique direction; sticking
 * and slipping, exact on every partition. */
void test_patch(Checks &checks) {
  const std::string patch =
    "Geometry/Distortion = 0.2\nMaterial/Young's modulus = 2.5\nMaterial/Poisson's ratio = 0.25\n"
    "Boundary/Clamped = top\nBoundary/Contact = bottom\nContact/Gap = -0.125\n"
    "Boundary/Traction = left: 0.125; 0; 0.05 | right: -0.125; 0; -0.05 | "
    "front: 0; 0.125; 0.02 | back: 0; -0.125; -0.02\n"
    "Exact solution/Displacement = 0.05*(1-z); 0.02*(1-z); 0.125*(1-z)\n";
  const double q = std::hypot(0.05, 0.02);
  for (const auto &[law, bound, shift] :
       {std::tuple("coulomb", "coefficient=0.3", "0.05; 0.02; 7"),
        {"coulomb", "coefficient=sqrt(0.05^2+0.02^2)/0.375", "0.07; 0.028; 0"},
        {"tresca", "bound=sqrt(0.05^2+0.02^2)", "0.1; 0.04; 0"}})
    for (const std::string ratio : {"2", "4"}) {
      const SpaceLevel level(
        patch, 2,
        {std::string("Contact/Friction=") + law, std::string("Contact/Friction ") + bound,
         std::string("Contact/Foundation shift=") + shift, "Discretization/Patch ratio=" + ratio});
      const Displacement exact =
        interpolate_at_nodes(level.discretization.space, *level.scene.exact_displacement);
      checks.near("patch test: u", distance(level.found.contact.U, exact), 0., 1e-12);
      checks.near("patch test: T", level.found.record.tangential->tangential_force, q, 1e-12);
      const dealii::Vector<double> P = level.found.contact.P.values();
      for (unsigned int k = 0; k < level.m; ++k)
        checks.near("patch test: |P_n|, |P_t|", {P[k], level.tangential(P, k).norm()}, {-0.375, q},
                    1e-12);
    }
}

/** Between two rollers nothing depends on y: the same numbers as in the plane. */
void test_plane_strain(Checks &checks) {
  const std::string common = "Boundary/Contact = bottom\nContact/Gap = 0.05*(x-1.2)^2\n";
  const std::string plane = "Geometry/Upper right = 2, 1\nGeometry/Cells = 2, 1\n"
                            "Boundary/Displacement = top: 0.03*x-0.02; -0.05\n" +
                            common,
                    space = "Geometry/Upper right = 2, 0.5, 1\nGeometry/Cells = 4, 1, 2\n"
                            "Boundary/Rollers = front back\n"
                            "Boundary/Displacement = top: 0.03*x-0.02; 0; -0.05\n" +
                            common;
  for (const auto &[friction, shift_2d, shift_3d] :
       {std::tuple(Entries{"Contact/Friction=coulomb", "Contact/Friction coefficient=0.2+0.1*x"},
                   "0.01*x", "0.01*x; 0; 0"),
        {Entries{"Contact/Friction=tresca", "Contact/Friction bound=0.01"}, "-0.01",
         "-0.01; 0; 0"}}) {
    Entries in_plane = friction, in_space = friction;
    in_plane.push_back(std::string("Contact/Foundation shift=") + shift_2d);
    in_space.push_back(std::string("Contact/Foundation shift=") + shift_3d);
    const LevelSolution<2> expected = OneLevel(plane, 3, in_plane).solve();
    for (const char *const solver : {"active set", "psor"}) {
      Entries with_solver = in_space;
      with_solver.push_back(std::string("Solver/Contact solver=") + solver);
      const SpaceLevel level(space, 2, with_solver);
      const LevelRecord &found = level.found.record, &record = expected.record;
      // Per thickness of 1/2, as below.
      const double thickness = std::sqrt(0.5);
      checks.near("estimate of the mesh", *found.estimate->mesh / *record.estimate->mesh, thickness,
                  1e-6);
      checks.near("estimate of the pressure",
                  *found.estimate->pressure / *record.estimate->pressure, thickness, 1e-6);
      // In space stretches of contact are parts of patches.
      checks.near("the whole estimate", found.estimate->relative / record.estimate->relative, 1.,
                  0.03);
      // Per thickness of 1/2.
      checks.near("N, |T|, dissipation, energy, stick, slip",
                  {2. * found.contact.normal_force, 2. * found.tangential->tangential_force,
                   2. * found.tangential->dissipation, 2. * found.certificate.energy,
                   2. * found.tangential->stick_length, 2. * found.tangential->slip_length},
                  {record.contact.normal_force, std::abs(record.tangential->tangential_force),
                   record.tangential->dissipation, record.certificate.energy,
                   record.tangential->stick_length, record.tangential->slip_length},
                  1e-9);
      checks.that("all states", record.tangential->stick_length > 0. &&
                                  record.tangential->slip_length > 0. &&
                                  record.tangential->open_length > 0.);
    }
  }
}

/** The top of a cube turns by 0.1 about the vertical axis: the middle sticks, slip around it turns.
 */
const std::string torsion = "Boundary/Displacement = top: 0.1*(0.5-y); 0.1*(x-0.5); -0.05\n"
                            "Boundary/Contact = bottom\nContact/Friction = coulomb\n"
                            "Contact/Friction coefficient = 0.3\n";

void test_torsion(Checks &checks) {
  const SpaceLevel level(torsion, 3, {"Geometry/Upper right=1, 1, 0.5", "Geometry/Cells=2, 2, 1"});
  const LevelRecord &record = level.found.record;
  check_residuals(checks, record);
  const unsigned int n_slip = check_law(checks, level);
  checks.that("some patches slip, others stick", n_slip > 0 && n_slip < level.m);
  // Symmetry: a quarter of a turn about (1/2, 1/2) maps the patches on one another.
  const dealii::Vector<double> P = level.found.contact.P.values();
  const auto &multipliers = level.discretization.multipliers;
  const auto &surface = multipliers.surface();
  const auto centre = [&](const unsigned int k) { return surface.middle(surface.patches()[k]).x; };
  const auto in_space = [&](const unsigned int k) {
    const dealii::Tensor<1, 3> n({0., 0., -1.});
    const auto q = level.tangential(P, k);
    return q[0] * direction_of(Component::tangential, n) +
           q[1] * direction_of(Component::second_tangential, n);
  };
  const double size = P.linfty_norm();
  for (unsigned int k = 0; k < level.m; ++k)
    for (unsigned int l = 0; l < level.m; ++l) {
      const dealii::Point<3> x = centre(k);
      if (centre(l).distance(dealii::Point<3>(1. - x[1], x[0], x[2])) > 1e-10)
        continue;
      const auto q = in_space(k);
      checks.near("symmetry: P_n", P[l], P[k], 1e-11 * size);
      checks.near("symmetry: P_t", (in_space(l) - dealii::Tensor<1, 3>({-q[1], q[0], 0.})).norm(),
                  0., 1e-11 * size);
    }
  checks.near("no resultant", record.tangential->tangential_force, 0., 1e-12);
  const auto &moment = record.answer.contact_force.resultant;
  checks.that("friction resists the turn",
              moment.moment[2] - 0.5 * (moment.force[1] - moment.force[0]) < -1e-3);
}

/** A turn with a shift, an obstacle and two contact sides that meet: the methods agree. */
void test_methods(Checks &checks) {
  const Entries scene = {"Boundary/Contact=bottom right",
                         "Contact/Foundation shift=0.03*y; -0.02; 0.01",
                         "Contact/Gap=bottom: 0.1*((x-0.6)^2+(y-0.4)^2) | right: 0.06*z-0.01"};
  for (const Entries &friction : {Entries{},
                                  {"Contact/Friction=tresca", "Contact/Friction coefficient=",
                                   "Contact/Friction bound=0.01+0.01*x"}}) {
    Entries all = scene;
    all.insert(all.end(), friction.begin(), friction.end());
    const SpaceLevel newton(torsion, 3, all);
    check_residuals(checks, newton.found.record);
    check_law(checks, newton);
    checks.between("steps of Newton's method", newton.found.record.dual.iterations, 1, 15);
    all.push_back("Solver/Contact solver=psor");
    const SpaceLevel swept(torsion, 3, all);
    checks.near("projected SOR finds the same",
                distance(newton.found.contact.P.values(), swept.found.contact.P.values()), 0.,
                1e-8 * newton.found.contact.P.normal().linfty_norm());
  }
}

/** With a coefficient of five sets come back, and other starts find a solution; nested levels begin
 * with the states of their parents. */
void test_study(Checks &checks) {
  const auto study = [&](const Entries &entries) {
    return solve<3>("set Dimension = 3\nGeometry/Shape = box\n" + torsion, levels(2, 3, entries));
  };
  const StudyResult<3> found = study({"Contact/Foundation shift=0.02; 0.03*x; 0"});
  checks.that("certified", found.verdict.is_certified());
  checks.between("warm start", found.levels.back().dual.iterations, 1, 6);
  checks.that("large coefficient",
              study({"Contact/Friction coefficient=5*(1+0.5*sin(3*x))",
                     "Contact/Gap=0.3*((x-0.3)^2+(y-0.6)^2)", "Material/Poisson's ratio=0.45"})
                .levels.back()
                .dual.converged);
  const StudyResult<3> smooth = study({"Contact/Friction coefficient=0"}),
                       none = study({"Contact/Friction coefficient=", "Contact/Friction=none"});
  checks.near("f = 0", last(smooth, "contact_force_n"), last(none, "contact_force_n"), 1e-13);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {test_patch, test_plane_strain, test_torsion, test_methods, test_study});
}
