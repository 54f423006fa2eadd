// SPDX-License-Identifier: LGPL-2.1-or-later
// Blocks with friction against numbers of an independent program: forces, energies, dissipation,
// displacements; and all solvers against one another.

#include <signorini/discretization/space/internal_forces.h>
#include <signorini/discretization/space/nodes.h>

#include <map>
#include <tuple>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
using Entries = std::vector<std::string>;

/** SSNV128 of Code_Aster, with E = 1 and lengths relative to 40 mm. */
const std::string ssnv128 = "Material/Poisson's ratio = 0.2\nBoundary/Rollers = right\n"
                            "Boundary/Traction = left: 150/130000; 0 | top: 0; -50/130000\n"
                            "Boundary/Contact = bottom\nContact/Friction = coulomb\n"
                            "Contact/Friction coefficient = 1\n";
/** Hild's block, relative to E. */
const std::string hild = "Boundary/Clamped = left\nLoad/Body force = 0; -0.076518\n"
                         "Boundary/Contact = bottom\nContact/Friction = coulomb\n"
                         "Contact/Friction coefficient = 0.2\n";
const std::string long_block = "Geometry/Upper right = 2, 1\nGeometry/Cells = 2, 1\n"
                               "Boundary/Rollers = left\nBoundary/Traction = top: 0.02; -0.05\n"
                               "Boundary/Contact = bottom\nContact/Friction = coulomb\n"
                               "Contact/Friction coefficient = 0.3\n";

/** Returns U at a vertex of the mesh. */
dealii::Point<2> displacement_at(const OneLevel &level, const Displacement &U,
                                 const dealii::Point<2> &x) {
  dealii::Point<2> u;
  for (const auto &cell : level.space().dofs().active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      if (cell->vertex(v).distance(x) < 1e-12)
        for (unsigned int d = 0; d < 2; ++d)
          u[d] = U(cell->vertex_dof_index(v, d));
  return u;
}

struct Reference {
  std::string name, text;
  unsigned int level, iterations;
  double N, T, strain_energy, dissipation;
};

const std::vector<Reference> references = {{"SSNV128, n = 32", ssnv128, 5, 9, -3.8461538462e-04,
                                            -2.7073399674e-04, 5.2040880018e-07, 4.2381546598e-08},
                                           {"SSNV128, n = 128", ssnv128, 7, 14, -3.8461538462e-04,
                                            -2.7030216394e-04, 5.2046700536e-07, 4.2316490519e-08},
                                           {"Hild, n = 32", hild, 5, 3, -5.6537069252e-02,
                                            -8.0139940624e-04, 5.6799196428e-04, 2.3863039944e-06},
                                           {"Hild, n = 128", hild, 7, 5, -5.6452776395e-02,
                                            -8.4000041845e-04, 5.6849430126e-04, 2.5983036096e-06},
                                           {"long block", long_block, 4, 3, -1.0000000000e-01,
                                            -2.4942956723e-02, 3.3253299686e-03, 6.1876738404e-07}};

void test_references(Checks &checks) {
  for (const Reference &expected : references) {
    checks.about(expected.name);
    const OneLevel level(expected.text, expected.level);
    const LevelSolution<2> found = level.solve();
    const LevelRecord &record = found.record;
    const double E =
      0.5 *
      std::pow(
        internal_forces(DisplacedBody(level.space(), level.scene, found.contact.U)).energy_norm, 2);
    const auto digits = [&](const std::string &name, const double value, const double exact) {
      checks.near(name, value, exact, 2e-10 * std::abs(exact));
    };
    digits("N", -record.contact.normal_force, expected.N);
    digits("T", record.tangential->tangential_force, expected.T);
    digits("strain energy", E, expected.strain_energy);
    digits("dissipation", record.tangential->dissipation, expected.dissipation);
    checks.near("active sets", record.dual.iterations, expected.iterations, 0.);
    checks.between("KKT residual", record.dual.kkt, 0., 1e-13);
    checks.between("balance of dissipation", *record.certificate.dissipation_balance, 0., 1e-11);
    checks.between("bipotential gap", record.certificate.complementarity, 0., 1e-11);
    checks.between("duality gap", record.certificate.duality_gap, 0., 1e-11);
  }
}

void test_displacements(Checks &checks) {
  const auto at = [&](const std::string &text, const unsigned int n, const dealii::Point<2> &x,
                      const dealii::Point<2> &u) {
    const OneLevel level(text, n);
    checks.near("displacement of a corner", displacement_at(level, level.solve().contact.U, x), u,
                1e-10 * u.norm());
  };
  at(ssnv128, 5, {0., 0.}, {7.1465280843e-04, 1.5349198875e-05});
  at(hild, 5, {1., 1.}, {9.4919279254e-03, -3.3038809462e-02});
  at(long_block, 4, {2., 1.}, {9.2614425537e-02, -8.3802337906e-02});
  const OneLevel level(hild, 5);
  const Pressure P_t = level.solve().contact.P.tangential()[0];
  checks.near("first and last P_t of Hild's block", {P_t[0], P_t[P_t.size() - 1]},
              {0.00378063, -0.01908483}, 1e-8);
}

/** SSNV128 within 0.2 % of the published u_x in 1e-5 m, and its zones. */
void test_published(Checks &checks) {
  const OneLevel level(ssnv128, 7);
  const LevelSolution<2> found = level.solve();
  const std::vector<std::pair<double, double>> published = {
    {0., 2.86}, {1.25, 2.72}, {5., 2.28}, {7.5, 1.98}, {11.25, 1.54}};
  for (const auto &[x, u_x] : published)
    checks.near("SSNV128: published displacements",
                4000. * displacement_at(level, found.contact.U, {x / 40., 0.})[0] / u_x, 1., 3e-3);
  checks.near("SSNV128: open, slip and stick",
              {1. - found.record.tangential->slip_length - found.record.tangential->stick_length,
               found.record.tangential->slip_length, found.record.tangential->stick_length},
              {5. / 64., 43. / 64., 16. / 64.}, 1e-12);
}

/** Projected SOR finds the solution of the active set method; so do columns of C by linear solves,
 * and a warm start needs few sets. */
void test_solvers(Checks &checks) {
  for (const std::string &text : {hild, long_block}) {
    const LevelSolution<2> exact = OneLevel(text, 4).solve();
    for (const Entries &solver :
         {Entries{"Solver/Contact solver=psor"}, Entries{"Solver/Linear solver=amesos_klu"}}) {
      const LevelSolution<2> found = OneLevel(text, 4, solver).solve();
      checks.that("converged", found.contact.report.converged);
      checks.near("P_n", distance(found.contact.P.normal(), exact.contact.P.normal()), 0.,
                  1e-8 * exact.contact.P.normal().linfty_norm());
      checks.near("P_t", distance(found.contact.P.tangential()[0], exact.contact.P.tangential()[0]),
                  0., 1e-8 * exact.contact.P.normal().linfty_norm());
    }
  }
}

/** With f up to 7.5 sets come back from the first beginning, and others find a solution. */
void test_large_coefficient(Checks &checks) {
  const LevelSolution<2> found =
    OneLevel("Material/Poisson's ratio = 0.45\nBoundary/Clamped = left\n"
             "Boundary/Traction = top: 0.0198; -0.0391\nBoundary/Contact = bottom right\n"
             "Contact/Gap = 0.02*x*x\nContact/Friction = coulomb\n"
             "Contact/Friction coefficient = 5*(1+0.5*sin(3*x))\n"
             "Contact/Foundation shift = -0.0062\nLoad/Body force = -0.0167; -0.0289\n"
             "Discretization/Patch ratio = 3\n",
             3)
      .solve();
  checks.between("large f: KKT residual", found.record.dual.kkt, 0., 1e-13);
}

/** Constant strain: u = (0.05 (1-y), 0.125 (1-y)), sticking and slipping, exact on every partition.
 */
void test_patch(Checks &checks) {
  const std::string patch = "Material/Young's modulus = 2.5\nMaterial/Poisson's ratio = 0.25\n"
                            "Boundary/Clamped = top\nBoundary/Contact = bottom\n"
                            "Boundary/Traction = left: 0.125; 0.05 | right: -0.125; -0.05\n"
                            "Contact/Gap = -0.125\nContact/Friction = coulomb\n"
                            "Exact solution/Displacement = 0.05*(1-y); 0.125*(1-y)\n"
                            "Exact solution/Pressure = -0.375\n";
  for (const auto &[f, shift] : {std::pair("0.3", "0.05"), {"0.05/0.375", "0.07"}})
    for (const std::string partition : {"Patch ratio=2", "Patch ratio=3", "Patches=3"}) {
      const OneLevel level(patch, 3,
                           {std::string("Contact/Friction coefficient=") + f,
                            std::string("Contact/Foundation shift=") + shift,
                            "Discretization/" + partition, "Geometry/Distortion=0.2"});
      const LevelSolution<2> found = level.solve();
      const Displacement exact =
        interpolate_at_nodes(level.space(), *level.scene.exact_displacement);
      checks.near("patch test: u", distance(found.contact.U, exact), 0., 1e-13);
      for (unsigned int k = 0; k < found.contact.P.normal().size(); ++k)
        checks.near("patch test: P_n, P_t",
                    {found.contact.P.normal()[k], found.contact.P.tangential()[0][k]},
                    {-0.375, 0.05}, 1e-12);
    }
}

/** A block on an incline that contact alone holds, and the message if it does not. */
void test_free_bodies(Checks &checks) {
  const std::string incline = "Boundary/Contact = bottom\n"
                              "Load/Body force = 0.01*sin(alpha); -0.01*cos(alpha)\n";
  const auto block = [&](const std::string &tangent, const Entries &friction) {
    Entries all = {"Constants/Values=alpha = " + tangent};
    all.insert(all.end(), friction.begin(), friction.end());
    return OneLevel(incline, 3, all).solve();
  };
  const auto coulomb = [](const std::string &f) {
    return Entries{"Contact/Friction=coulomb", "Contact/Friction coefficient=" + f};
  };
  const auto tresca = [](const std::string &s) {
    return Entries{"Contact/Friction=tresca", "Contact/Friction bound=" + s};
  };
  const std::string shallow = "0.3805063771123649", steep = "0.7328151017865066";
  for (const Entries &friction : {coulomb("0.5"), tresca("0.004")}) {
    const LevelRecord record = block(shallow, friction).record;
    checks.near("block on an incline: T/N",
                record.tangential->tangential_force / record.contact.normal_force, -0.4, 1e-12);
    checks.between("block on an incline: KKT residual", record.dual.kkt, 0., 1e-13);
    checks.between("block on an incline: balance", record.certificate.motion_balance, 0., 1e-12);
  }
  checks.throws<InputError>(
    "Coulomb: it slides",
    "the body slides along (1, 0): friction carries at most 0.00278543, the loads pull with "
    "0.00371391",
    [&]() { block(shallow, coulomb("0.3")); });
  checks.throws<InputError>(
    "half as thick", "friction carries at most 0.00139272, the loads pull with 0.00185695", [&]() {
      Entries thin = coulomb("0.3");
      thin.emplace_back("Geometry/Thickness=0.5");
      block(shallow, thin);
    });
  checks.throws<InputError>("Tresca: it slides",
                            "friction carries at most 0.003, the loads pull with",
                            [&]() { block(shallow, tresca("0.003")); });
  // Interference presses it between rollers and foundation; where it slips, P_n resists nothing.
  const auto squeezed = [](const std::string &f, const std::string &solver) {
    return OneLevel("Boundary/Rollers = top\nBoundary/Contact = bottom\nLoad/Body force = 0.01; 0\n"
                    "Contact/Gap = -0.01\nContact/Friction = coulomb\n",
                    3, {"Contact/Friction coefficient=" + f, "Solver/Contact solver=" + solver})
      .solve();
  };
  for (const std::string solver : {"active set", "psor"}) {
    checks.throws<InputError>("squeezed, " + solver + ": it slides",
                              "the body slides along (1, 0): friction carries at most 0.0028",
                              [&]() { squeezed("0.3", solver); });
    checks.near("squeezed, " + solver + ": it sticks",
                squeezed("1.5", solver).record.tangential->tangential_force, -0.01, 1e-8);
  }
  // The cone of patches where f is large could carry the loads, but the body presses elsewhere.
  checks.throws<InputError>(
    "it slides off a wall", "the body slides along (-1, 0): friction carries at most 0.0677571",
    []() {
      OneLevel(
        "Geometry/Upper right = 2, 1\nGeometry/Cells = 2, 1\nBoundary/Contact = bottom right\n"
        "Boundary/Traction = top: -0.0199; -0.0311\nLoad/Body force = -0.0183; -0.0270\n"
        "Contact/Friction = coulomb\nDiscretization/Patch ratio = 3\n"
        "Contact/Friction coefficient = 0.5*(1+0.5*sin(3*x))\n",
        3)
        .solve();
    });
  checks.throws<InputError>("the mesh is too coarse", "forces in its middle only",
                            [&]() { block(steep, coulomb("1")); });
  checks.throws<InputError>("it tips", "(it tips over)", [&]() { block("0.84", coulomb("2")); });
}

/** Just above the limit of sliding, T = 0.6 for N = 3, all patches slip but one, of length 1/8. */
void test_limit_of_sliding(Checks &checks) {
  const auto block = [](const std::string &f, const std::string &solver = "active set") {
    return OneLevel(
             "Geometry/Upper right = 3, 1\nGeometry/Cells = 3, 1\nBoundary/Contact = bottom\n"
             "Boundary/Traction = top: 0.2; -1\nContact/Friction = coulomb\n",
             4, {"Contact/Friction coefficient=" + f, "Solver/Contact solver=" + solver})
      .solve()
      .record;
  };
  for (const std::string f : {"0.2001", "0.202", "0.205", "0.207"}) {
    const LevelRecord record = block(f);
    checks.about("limit of sliding, f = " + f);
    checks.near("T, N", {record.tangential->tangential_force, record.contact.normal_force},
                {-0.6, 3.}, 1e-10);
    checks.near("stick and slip", {record.tangential->stick_length, record.tangential->slip_length},
                {0.125, 2.875}, 1e-12);
    checks.between("linear systems", record.dual.iterations, 1., 100.);
    checks.between("KKT residual", record.dual.kkt, 0., 1e-12);
    checks.between("balance", record.certificate.motion_balance, 0., 1e-10);
  }
  const LevelRecord swept = block("0.205", "psor");
  checks.between("limit of sliding, psor: balance", swept.certificate.motion_balance, 0., 1e-8);
  checks.near("limit of sliding, psor: stick", swept.tangential->stick_length, 0.125, 1e-12);
  checks.throws<InputError>("below the limit of sliding",
                            "friction carries at most 0.5997, the loads pull with 0.6",
                            [&]() { block("0.1999"); });
  checks.near("at the limit of sliding", block("0.2").tangential->tangential_force, -0.6, 1e-9);
}

/**
 * A square that slips everywhere by 0.1 with the pressure one: beyond f_c two more solutions exist,
 * one with a sticking and one with an open patch. The degrees of all three add up to one.
 */
void test_three_solutions(Checks &checks) {
  const OneLevel level(
    "Boundary/Clamped = top\nBoundary/Contact = bottom\nContact/Friction = coulomb\n"
    "Contact/Friction coefficient = 2.5\nLoad/Body force = 0; -0.01\nOutput/Compliance = true\n",
    4);
  const auto C = level.solve().operators->C;
  const dealii::Vector<double> lengths = level.multipliers().integrals();
  const unsigned int m = lengths.size();
  const auto problem = [&](const double f, const dealii::Vector<double> &P) {
    dealii::Vector<double> coefficients(m), F = C->apply(P);
    coefficients = f;
    for (unsigned int k = 0; k < m; ++k)
      F[m + k] += 0.1 * lengths[k];
    return BoundConstrainedQP(
      C, F, AdmissibleSet::with_tangential_part(dealii::Vector<double>(m), coefficients));
  };
  dealii::Vector<double> slip(2 * m);
  for (unsigned int k = 0; k < 2 * m; ++k)
    slip[k] = k < m ? -1. : 1.;
  checks.near("f_c", *examine_regularity(problem(1., slip), slip)->critical_factor, 1.9686527283,
              1e-9);
  // All patches slip: one eigenvalue rules both.
  checks.near("rate of the fixed point",
              examine_regularity(problem(1., slip), slip)->fixed_point_rate, 1. / 1.9686527283,
              1e-9);
  for (unsigned int k = m; k < 2 * m; ++k)
    slip[k] = 2.5;
  const BoundConstrainedQP qp = problem(2.5, slip);
  // Starts: slip, with one patch that sticks, or one that is open.
  std::map<int, std::pair<double, bool>> found;
  for (unsigned int k = 0; k <= 2 * m; ++k) {
    dealii::Vector<double> start(slip);
    if (k < m)
      start[m + k] = 0.;
    else if (k < 2 * m)
      start[k - m] = start[k] = 0.;
    const QPResult result = solve_by_active_set(qp, start, {});
    if (!result.converged)
      continue;
    double N = 0.;
    for (unsigned int i = 0; i < m; ++i)
      N += result.P[i] * lengths[i];
    found[std::lround(1e6 * N)] = {N, examine_regularity(qp, result.P)->keeps_sign};
  }
  std::vector<double> forces;
  std::vector<bool> signs;
  for (const auto &[key, solution] : found) {
    forces.push_back(solution.first);
    signs.push_back(solution.second);
  }
  checks.near("three solutions", forces, {-1.0050553224, -1., -0.9613505066}, 1e-9);
  checks.that("their signs", signs == std::vector<bool>{true, false, true});
}

/** A bound that is never reached is no slip: its size has no part in the certificate. */
void test_glued(Checks &checks) {
  const auto glued = [](const std::string &s) {
    return OneLevel(
             "Boundary/Clamped = top\nBoundary/Contact = bottom\nLoad/Body force = 0.01; -0.02\n"
             "Contact/Friction = tresca\nContact/Friction bound = " +
               s + "\n",
             5)
      .solve();
  };
  const LevelSolution<2> one = glued("1");
  for (const std::string s : {"1e3", "1e6", "1e9"}) {
    checks.about("glued, s = " + s);
    const LevelSolution<2> found = glued(s);
    const Certificate &certificate = found.record.certificate;
    checks.near("P_t", distance(found.contact.P.tangential()[0], one.contact.P.tangential()[0]), 0.,
                1e-12);
    checks.near("dissipation", found.record.tangential->dissipation, 0., 0.);
    checks.between("balance of dissipation", *certificate.dissipation_balance, 0., 1e-11);
    checks.between("bipotential gap", certificate.complementarity, 0., 1e-11);
    checks.between("duality gap", certificate.duality_gap, 0., 1e-11);
    checks.between("slip where it sticks", certificate.penetration, 0., 1e-11);
  }
}

/** Loads that work in no free motion: rollers carry them, and friction holds the others, which need
 * no force.
 */
void test_loads_in_balance(Checks &checks) {
  const std::string held = "Boundary/Rollers = top\nBoundary/Traction = left: 0; 0.001*sin(3*y)\n"
                           "Boundary/Contact = bottom\nContact/Friction = coulomb\n"
                           "Load/Body force = 0; -0.001\nContact/Friction coefficient = ";
  for (const std::string f : {"0.5", "0.1"})
    for (const unsigned int level : {2, 4}) {
      const LevelSolution<2> found = OneLevel(held + f, level).solve();
      checks.near("loads on rollers: T", found.record.tangential->tangential_force, 0., 1e-15);
      checks.between("loads on rollers: KKT residual", found.record.dual.kkt, 0., 1e-12);
    }
  // It has not arrived, or it just touches.
  const std::string plate = "Boundary/Contact = bottom\nBoundary/Plates = top: 0, -1 turning\n"
                            "Contact/Gap = 0.1\nLoad/Plate travel = top: ";
  for (const std::string travel : {"0.05", "0.1"})
    for (const std::string friction :
         {"", "\nContact/Friction = coulomb\nContact/Friction coefficient = 0.3",
          "\nContact/Friction = tresca\nContact/Friction bound = 0.01"})
      checks.near("a plate that has not arrived",
                  OneLevel(plate + travel + friction, 3).solve().contact.P.normal().linfty_norm(),
                  0., 1e-14);
}

/** A wedge that friction could lock, but nothing presses: Newton's method finds no states. */
void test_departure(Checks &checks) {
  checks.throws<InputError>("a wedge that is pulled out of its slope", "it lifts off", []() {
    OneLevel("Geometry/Shape = polygon\n"
             "Geometry/Vertices = 0,0; 1,0; 1.2,1; 0,1\n"
             "Boundary/Rollers = side3\nBoundary/Contact = side1\n"
             "Boundary/Traction = side2: 0; 0.01\n"
             "Contact/Friction = coulomb\n"
             "Contact/Friction coefficient = 0.3\n",
             3)
      .solve();
  });
}

/** With f = 0 friction changes nothing. */
void test_no_friction(Checks &checks) {
  const LevelSolution<2>
    smooth = OneLevel(hild, 4, {"Contact/Friction coefficient=0"}).solve(),
    none = OneLevel(hild, 4, {"Contact/Friction=none", "Contact/Friction coefficient="}).solve();
  checks.near("f = 0", distance(smooth.contact.P.normal(), none.contact.P.normal()), 0., 1e-13);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {test_references, test_displacements, test_published, test_solvers, test_patch,
                    test_large_coefficient, test_free_bodies, test_limit_of_sliding, test_glued,
                    test_loads_in_balance, test_three_solutions, test_departure, test_no_friction});
}
