// SPDX-License-Identifier: LGPL-2.1-or-later
// Two and three elastic bodies: values of an independent program, exact solutions, and limits.

#include <signorini/base/errors.h>
#include <signorini/results/output/contact_files.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/verification/verify.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "one_level.h"
#include "results/output/vtu_reader.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** The entries of two rectangles. */
std::string bodies(const std::string &lower, const std::string &upper, const std::string &cells,
                   const std::string &E, const std::string &nu) {
  return "Geometry/Bodies = a b\nGeometry/Lower left = " + lower +
         "\nGeometry/Upper right = " + upper + "\nGeometry/Cells = " + cells +
         "\nMaterial/Young's modulus = " + E + "\nMaterial/Poisson's ratio = " + nu + "\n";
}

const std::string pair = "Boundary/Contact = a.bottom with b.top\n";

/** A lowered block on a parabolic gap. */
const std::string pressed =
  bodies("a: -1, 0 | b: -1, -1.5", "a: 1, 1 | b: 1, 0", "a: 4, 2 | b: 3, 2", "a: 1 | b: 7", "0.3") +
  pair +
  "Boundary/Clamped = b.bottom\nBoundary/Displacement = a.top: 0; -0.05\nContact/Gap = x^2/4\n";

/** Pressures, of all patches that touch, and energies of a program that shares no code with this
 * one: Q1 on rectangles, D and G integrated exactly, one factor for each body. */
struct Reference {
  std::string name, text;
  unsigned int level;
  std::vector<double> P;
  double energy;
};

const std::vector<Reference> references = {
  {"block on block",
   pressed + "Discretization/Patches = 13\n",
   3,
   {-6.5252436856e-03, -7.7702071649e-02, -7.8513007731e-02, -7.7702071649e-02, -6.5252436856e-03},
   8.4601266052e-04},
  {"overlap, free to fall",
   bodies("a: 0, 0 | b: -1, -0.8", "a: 2, 1 | b: 1.3, 0", "a: 16, 8 | b: 24, 8", "a: 1 | b: 3",
          "a: 0.3 | b: 0.2") +
     pair +
     "Boundary/Clamped = b.bottom\nBoundary/Rollers = a.left\nBoundary/Traction = a.top: 0; -0.02\n"
     "Discretization/Patches = 5\n",
   0,
   {-1.3020521848e-02, -1.3137982355e-02, -2.0906906949e-02, -2.3810542355e-02, -8.2970200339e-02},
   -1.0182973796e-03},
  {"block on a beam, held by contact alone",
   bodies("a: 1.2, 0 | b: 0, -0.3", "a: 2.4, 0.5 | b: 3, 0", "a: 12, 5 | b: 40, 4", "1", "0.3") +
     pair +
     "Boundary/Clamped = b.left\nLoad/Body force = 0; y > 0 ? -2e-5 : 0\n"
     "Contact/Gap = 0.00004*(x-1.8)^2\nDiscretization/Patches = 6\n",
   0,
   {-3.6063396970e-05, -1.7873206061e-05, -6.0633969697e-06},
   -5.5433217546e-08},
  {"three in a row",
   "Geometry/Bodies = low mid top\n"
   "Geometry/Lower left = low: -2, -1.5 | mid: -1, -0.5 | top: -1.5, 0\n"
   "Geometry/Upper right = low: 2, -0.5 | mid: 1, 0 | top: 1.5, 1\n"
   "Geometry/Cells = low: 32, 8 | mid: 20, 5 | top: 22, 7\n"
   "Material/Young's modulus = low: 5 | mid: 1 | top: 2\n"
   "Material/Poisson's ratio = low: 0.25 | mid: 0.3 | top: 0.3\n"
   "Boundary/Contact = mid.bottom with low.top | top.bottom with mid.top\n"
   "Boundary/Clamped = low.bottom\nBoundary/Displacement = top.top: 0; -0.02\n"
   "Load/Body force = 0; y > -0.5 && y < 0 ? -0.001 : 0\n"
   "Contact/Gap = mid.bottom: 0.03*x^2 | top.bottom: 0.04*(x-0.1)^2\n"
   "Discretization/Patches = mid.bottom: 8 | top.bottom: 7\n",
   0,
   {-5.9162195038e-03, -2.1169547435e-02, -2.3008151269e-02, -1.3498971963e-02, -9.5274805720e-03,
    -2.3676659948e-02, -1.8939638379e-02},
   1.1532444141e-04},
  {"a stack that nothing but contact holds",
   bodies("a: 0, 0 | b: 0.3, 1", "a: 2, 1 | b: 1.1, 1.6", "a: 20, 10 | b: 12, 9", "a: 1 | b: 3",
          "a: 0.3 | b: 0.25") +
     "Boundary/Contact = a.bottom | b.bottom with a.top\n"
     "Boundary/Traction = b.left: 0.0006; 0 | b.right: -0.0006; 0\n"
     "Load/Body force = a: 0; -0.002 | b: 0; -0.006\n"
     "Contact/Gap = a.bottom: 0.0004*(x-0.8)^2 | b.bottom: 0\n"
     "Discretization/Patches = a.bottom: 10 | b.bottom: 5\n",
   0,
   {-3.2504566312e-03, -4.0336965102e-03, -4.4151339977e-03, -4.5879762500e-03, -4.4329618548e-03,
    -4.0150597148e-03, -3.4485908596e-03, -2.8129572237e-03, -2.2457875948e-03, -1.1573793632e-03,
    -4.8777502698e-03, -2.5848944921e-03, -3.0642654329e-03, -2.6057845786e-03, -4.8673052266e-03},
   -8.3505445530e-06}};

void test_references(Checks &checks) {
  for (const Reference &reference : references) {
    checks.about(reference.name);
    const LevelSolution<2> solution = OneLevel(reference.text, reference.level).solve();
    std::vector<double> pressing;
    for (const double p : solution.contact.P.normal())
      if (p < 0.)
        pressing.push_back(p);
    checks.that("patches that press", pressing.size() == reference.P.size());
    if (pressing.size() == reference.P.size())
      checks.near("P", pressing, reference.P, 1e-9 * std::abs(reference.P[0]));
    const Certificate &certificate = solution.record.certificate;
    checks.near("energy", certificate.energy, reference.energy, 1e-9 * std::abs(reference.energy));
    checks.near("balance of each body", certificate.force_balance + certificate.moment_balance, 0.,
                1e-11);
  }
}

/** A block that is lowered and dragged on another one. */
std::string dragged(const std::string &cells, const std::string &E, const std::string &friction) {
  return bodies("a: -1, 0 | b: -1.5, -1", "a: 1, 1 | b: 1.5, 0", cells, E, "a: 0.3 | b: 0.25") +
         pair +
         "Boundary/Clamped = b.bottom\nBoundary/Displacement = a.top: 0.02; -0.03\n"
         "Contact/Gap = 0.02*x^2\n" +
         friction;
}

const std::string by_tresca = "Contact/Friction = tresca\nContact/Friction bound = 0.006\n";

void test_friction(Checks &checks) {
  const std::string cells = "a: 16, 8 | b: 36, 9", six = "Discretization/Patches = 6\n";
  const LevelSolution<2> tresca =
    OneLevel(dragged(cells, "a: 1 | b: 4", by_tresca + six), 0).solve();
  const Pressure q = tresca.contact.P.tangential()[0];
  checks.near("Tresca: q", std::vector<double>(q.begin(), q.end()),
              {-9.6467707722e-04, -5.1209931991e-03, -6e-3, -6e-3, -6e-3, -6e-3}, 1e-11);
  checks.near("Tresca: T and work",
              {tresca.record.tangential->tangential_force, tresca.record.tangential->dissipation},
              {-1.0028556759e-02, 1.0499019187e-05}, 1e-11);
  const LevelSolution<2> coulomb =
    OneLevel(dragged(cells, "a: 1 | b: 4",
                     "Contact/Friction = coulomb\nContact/Friction coefficient = 0.3\n" + six),
             0)
      .solve();
  const auto &force = coulomb.record.answer.contact_by_side;
  checks.near("Coulomb: action and reaction", force.at(0).resultant.force[0],
              -force.at(1).resultant.force[0], 1e-15);
  checks.between("Coulomb: T/N", std::abs(force[0].resultant.force[0]), 1e-3,
                 0.3 * force[0].resultant.force[1] + 1e-12);
}

/** Uniform pressure passes through bodies whose meshes do not match, whatever the moduli. */
void test_patch(Checks &checks) {
  for (const std::string contrast : {"1e-6", "1", "1e6"})
    for (const std::string cells : {"a: 8, 3 | b: 6, 4", "a: 7, 2 | b: 11, 5"}) {
      const OneLevel level(bodies("a: 0, 0 | b: 0, -1", "a: 2, 1 | b: 2, 0", cells,
                                  "a: 1 | b: " + contrast, "a: 0.3 | b: 0.1") +
                             pair +
                             "Boundary/Rollers = b.bottom a.left b.left\n"
                             "Boundary/Traction = a.top: 0; -0.01\nContact/Gap = 0\n",
                           0);
      const LevelSolution<2> solution = level.solve();
      for (const double p : solution.contact.P.normal())
        checks.near("patch test, " + contrast + ", " + cells, p, -0.01, 1e-12);
    }
}

/** The first scene turned by a right angle, and a body whose slit closes: the same numbers, and
 * balance with a load that the slit alone carries further. */
void test_other_pairs(Checks &checks) {
  const LevelSolution<2> turned =
    OneLevel("Geometry/Bodies = a b\nGeometry/Lower left = a: 0, -1 | b: -1.5, -1\n"
             "Geometry/Upper right = a: 1, 1 | b: 0, 1\nGeometry/Cells = a: 2, 4 | b: 2, 3\n"
             "Material/Young's modulus = a: 1 | b: 7\nBoundary/Contact = a.left with b.right\n"
             "Boundary/Clamped = b.left\nBoundary/Displacement = a.right: -0.05; 0\n"
             "Contact/Gap = y^2/4\nDiscretization/Patches = 13\n",
             3)
      .solve();
  for (unsigned int k = 0; k < 5; ++k)
    checks.near("turned", turned.contact.P.normal()[4 + k], references[0].P[k], 1e-11);
  const StudyResult<2> slit =
    solve("Geometry/Shape = polygon\nGeometry/Mesh size = 0.2\n"
          "Geometry/Vertices = 0,0; 2,0; 2,0.45; 0.6,0.45; 0.6,0.5; 2,0.5; 2,1; 0,1\n"
          "Boundary/Contact = side2 with side4\nBoundary/Clamped = side0\n"
          "Boundary/Traction = side6: 0; -0.02\n",
          levels(1, 2));
  const LevelRecord &finest = slit.levels.back();
  checks.near("slit: force and moment balance",
              finest.certificate.force_balance + finest.certificate.moment_balance, 0., 1e-10);
  checks.that("slit: it closes", finest.contact.active > 0);
  checks.that("slit: the bound is guaranteed", finest.bound->is_guaranteed());
}

/** Writes two rectangles of 4 x 2 and 4 x 3 cells, the lower one @p distance below the upper one,
 * as a file of Gmsh; where they touch they share nodes. */
void write_parts(const std::string &file, const double distance) {
  std::vector<dealii::Point<2>> nodes;
  std::string lines, cells;
  unsigned int n = 0;
  const auto node = [&](const double x, const double y) {
    auto found = std::find(nodes.begin(), nodes.end(), dealii::Point<2>(x, y));
    if (found == nodes.end())
      found = nodes.insert(found, dealii::Point<2>(x, y));
    return " " + std::to_string(found - nodes.begin() + 1);
  };
  for (const int body : {1, 2})
    for (unsigned int i = 0; i < 4; ++i) {
      const double a = -1. + 0.5 * i, b = a + 0.5, low = body == 1 ? 0. : -1.5 - distance;
      const unsigned int n_rows = body + 1;
      for (unsigned int j = 0; j <= n_rows; ++j) {
        const double y = low + 0.5 * j;
        if (j == 0 || j == n_rows)
          lines += std::to_string(++n) + " 1 2 " +
                   (j == (body == 1 ? 0 : n_rows) ? "9 9"
                    : j == 0                      ? "7 7"
                                                  : "8 8") +
                   node(a, y) + node(b, y) + "\n";
        if (j < n_rows)
          cells += std::to_string(++n) + " 3 2 " + std::to_string(body) + " 1" + node(a, y) +
                   node(b, y) + node(b, y + 0.5) + node(a, y + 0.5) + "\n";
      }
    }
  std::ofstream out(file);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"a\"\n2 2 \"b\"\n"
         "$EndPhysicalNames\n$Nodes\n"
      << nodes.size() << "\n";
  for (unsigned int i = 0; i < nodes.size(); ++i)
    out << i + 1 << " " << nodes[i] << " 0\n";
  out << "$EndNodes\n$Elements\n" << n << "\n" << lines << cells << "$EndElements\n";
}

/** The parts of a file, touching or apart, have the numbers of the same bodies drawn as boxes. */
void test_parts_of_a_file(Checks &checks) {
  const std::string data = "Material/Young's modulus = a: 1 | b: 7\nContact/Gap = x^2/4\n";
  for (const std::string distance : {"0", "0.25"}) {
    write_parts("parts.msh", std::stod(distance));
    const auto numbers = [&](const std::string &drawing, const std::string &text) {
      const LevelSolution<2> solution =
        OneLevel("Geometry/Bodies = a b\n" + drawing + text + distance + "\n" + data, 3).solve();
      std::vector<double> P(solution.contact.P.normal().begin(), solution.contact.P.normal().end());
      std::sort(P.begin(), P.end());
      P.push_back(solution.record.certificate.energy);
      return P;
    };
    checks.near("P and energy",
                numbers("Geometry/Shape = file\nGeometry/File = parts.msh\n",
                        "Boundary/Contact = a.9 with b.9\nBoundary/Clamped = b.7\n"
                        "Boundary/Displacement = a.8: 0; -0.05-"),
                numbers("Geometry/Lower left = a: -1, 0 | b: -1, -1.5-" + distance +
                          "\nGeometry/Upper right = a: 1, 1 | b: 1, -" + distance +
                          "\nGeometry/Cells = a: 4, 2 | b: 4, 3\n",
                        pair + "Boundary/Clamped = b.bottom\nBoundary/Displacement = a.top: 0; "
                               "-0.05-"),
                1e-12);
  }
}

/** Energies lie between the numbers of all levels: free bodies, three in a row, friction, and a
 * carrier that is named last or that is held at an end of contact. */
void test_brackets(Checks &checks) {
  const auto without_patches = [](const std::string &text) {
    return text.substr(0, text.find("Discretization"));
  };
  const std::string held =
    bodies("a: 0, 0 | b: 0, -1", "a: 1, 1 | b: 2, 0", "a: 6, 6 | b: 14, 6", "a: 3 | b: 1", "0.3") +
    pair +
    "Boundary/Clamped = b.left b.bottom\nBoundary/Rollers = a.left\n"
    "Boundary/Traction = a.top: 0; -0.02\nContact/Gap = 0.001*sin(7*x)^2\n";
  for (const auto &[name, text, coarsest] :
       {std::tuple("lowered", pressed, 1), std::tuple("three", references[3].text, 0),
        std::tuple("stack", without_patches(references[4].text), 0), std::tuple("held", held, 0),
        std::tuple("Tresca", dragged("a: 8, 4 | b: 9, 3", "a: 40 | b: 4", by_tresca), 0)}) {
    checks.about(name);
    std::vector<Bracket> brackets;
    for (const int level : {coarsest, coarsest + 2}) {
      const LevelRecord finest =
        solve(without_patches(text), levels(coarsest, level)).levels.back();
      checks.that("there is a bound", finest.bound->absolute && finest.bound->is_guaranteed());
      brackets.push_back({*finest.bound->energy_lower, *finest.bound->energy_upper});
      if (level > coarsest)
        checks.between("bound / estimate", *finest.bound->relative / finest.estimate->relative, 0.9,
                       4.);
    }
    checks.between("lower bounds rise", brackets[1].lower, brackets[0].lower, brackets[0].upper);
    checks.between("upper bounds fall", brackets[1].upper, brackets[1].lower, brackets[0].upper);
  }
}

/** Two equal bodies share the closing, and the points of both sides lie across from each other. */
void test_both_sides(Checks &checks) {
  const OneLevel level(
    bodies("a: -1, 0.25 | b: -1, -1", "a: 1, 1.25 | b: 1, 0", "2, 1", "1", "0.3") + pair +
      "Boundary/Displacement = a.top: 0; -0.025 | b.bottom: 0; 0.025\n"
      "Contact/Gap = x^2/4 - 0.25\n",
    3);
  const LevelSolution<2> solution = level.solve();
  const TracedContact<2> contact =
    trace_contact(level.body(solution.contact.U, solution.contact.P));
  for (const ContactPiece<2> &piece : contact)
    for (const ContactPoint<2> &point : piece.rows) {
      const PointAcross<2> &other = point.across.value();
      checks.near("half of the closing", other.u_n, -0.5 * point.u_n, 1e-12);
      checks.near("the point across", other.x.distance({point.x[0], 0.}), 0., 1e-14);
    }
  // The curve of every piece is followed by that of the other side, its mirror image.
  std::ostringstream vtu;
  write_contact_vtu<2>(vtu, contact, {});
  const PointField u = read_vtu_field(vtu.str(), "displacement"),
                   side = read_vtu_field(vtu.str(), "side"),
                   opposite = read_vtu_field(vtu.str(), "opposite");
  checks.that("curves of both sides", u.size() == 4 * contact.size());
  for (std::size_t k = 0; k + 3 < u.size(); k += 4) {
    checks.near("mirrored curves", {u[k + 2][0], u[k + 2][1]}, {u[k][0], -u[k][1]}, 1e-7);
    checks.that("names of both sides", side[k] == opposite[k + 2] && side[k + 2] == opposite[k]);
  }
}

std::vector<double> pressures(const std::string &text, const unsigned int level) {
  const Pressure P = OneLevel(text, level).solve().contact.P.normal();
  return {P.begin(), P.end()};
}

/** Roles exchanged, a second body that hardly yields, and C as the sum of those of both bodies. */
void test_limits(Checks &checks) {
  const std::string thirteen = "Discretization/Patches = 13\n";
  std::string exchanged = pressed;
  exchanged.replace(exchanged.find(pair), pair.size(), "Boundary/Contact = b.top with a.bottom\n");
  checks.near("roles exchanged", pressures(exchanged + thirteen, 3),
              pressures(pressed + thirteen, 3), 1e-11);
  const std::string own = "Geometry/Lower left = -1, 0\nGeometry/Upper right = 1, 1\n"
                          "Geometry/Cells = 4, 2\nBoundary/Contact = bottom\n"
                          "Boundary/Displacement = top: 0; -0.05\nContact/Gap = x^2/4\n";
  const std::string base =
    "Geometry/Lower left = -1, -1.5\nGeometry/Upper right = 1, 0\n"
    "Geometry/Cells = 3, 2\nMaterial/Young's modulus = 7\n"
    "Boundary/Contact = top\nBoundary/Clamped = bottom\nContact/Gap = x^2/4 - 0.05\n";
  std::string hard = pressed;
  hard.replace(hard.find("b: 7"), 4, "b: 1e12");
  checks.near("a rigid second body", pressures(hard + thirteen, 3), pressures(own + thirteen, 3),
              1e-11);
  const auto compliance = [&](const std::string &text) {
    const OneLevel level(text + thirteen + "Output/Compliance = true\n", 3);
    const LevelSolution<2> solution = level.solve();
    dealii::Vector<double> P(13);
    for (unsigned int k = 0; k < 13; ++k)
      P[k] = std::sin(1. + k);
    const dealii::Vector<double> C_P = solution.operators->C->apply(P);
    return std::vector<double>(C_P.begin(), C_P.end());
  };
  std::vector<double> sum = compliance(own);
  const std::vector<double> other = compliance(base);
  for (unsigned int k = 0; k < 13; ++k)
    sum[k] += other[k];
  checks.near("C = C_1 + C_2", compliance(pressed), sum, 1e-12);
  const auto beta = [&](const std::string &text) {
    const OneLevel level(text + thirteen + "Output/Inf-sup constant = true\n", 3);
    LevelSolution<2> solution = level.solve();
    add_inf_sup<2>(
      level.parameters, level.discretization, [](const std::string &) {}, solution);
    return solution.record;
  };
  const LevelRecord both = beta(pressed);
  const double first = *beta(own).inf_sup, second = *beta(base).inf_sup;
  checks.near("beta of each side", {*both.inf_sup_first, *both.inf_sup_opposite}, {first, second},
              1e-10);
  checks.between("the theorem", *both.inf_sup, std::hypot(first, second), first + second);
}

/** Lamé: a hub of radii 1 and 2 on a shaft with a bore of 0.5, interference 0.01. */
void test_press_fit(Checks &checks) {
  const std::string fit = "Geometry/Bodies = hub shaft\nGeometry/Shape = ring\n"
                          "Geometry/Radius = hub: 2 | shaft: 1\n"
                          "Geometry/Inner radius = hub: 1 | shaft: 0.5\n"
                          "Material/Young's modulus = hub: 1 | shaft: 5\n"
                          "Boundary/Contact = shaft.outer with hub.inner\nContact/Gap = -0.01\n";
  const double nu = 0.3, a = 0.5, r = 1., b = 2.,
               u_hub = (1. + nu) * r * ((1. - 2. * nu) * r * r + b * b) / (b * b - r * r),
               u_shaft = (1. + nu) / 5. * r * ((1. - 2. * nu) * r * r + a * a) / (r * r - a * a),
               exact = -0.01 / (u_hub + u_shaft);
  std::vector<double> errors;
  for (const unsigned int level : {2, 3, 4}) {
    const std::vector<double> p = pressures(fit, level);
    errors.push_back(std::abs(p[0] - exact) / std::abs(exact));
    for (const double value : p)
      checks.near("press fit: uniform", value, p[0], 1e-11);
  }
  checks.between("press fit: order", std::log2(errors[1] / errors[2]), 1.8, 2.2);
  checks.between("press fit: error on level 4", errors[2], 0., 2e-3);
}

void test_refusals(Checks &checks) {
  const auto refuses = [&](const std::string &name, const std::string &text,
                           const std::string &sentence) {
    checks.throws<InputError>(name, sentence, [&]() { solve(text, levels(1, 2)); });
  };
  refuses("bodies that overlap",
          bodies("a: 0, -0.1 | b: 0, -1", "a: 1, 1 | b: 1, 0", "1, 1", "1", "0.3") + pair +
            "Boundary/Clamped = b.bottom a.top\n",
          "overlap by 0.1");
  refuses("sides that look away",
          bodies("a: 0, 0 | b: 0, -1", "a: 1, 1 | b: 1, 0", "1, 1", "1", "0.3") +
            "Boundary/Contact = a.left with b.top\nBoundary/Clamped = b.bottom a.top\n",
          "do not face each other");
  const std::string blocks = bodies("a: 0, 0 | b: 0, -1", "a: 1, 1 | b: 1, 0", "2, 2", "1", "0.3") +
                             "Boundary/Clamped = b.bottom\n";
  for (const auto &[names, found] : {std::pair("a a", "'a' twice"), {"a a.b", "'a.b', allowed"}})
    refuses("names of bodies", "Geometry/Bodies = " + std::string(names) + "\n", found);
  refuses("bodies in space", "set Dimension = 3\n" + blocks + pair, "'a b' with Dimension = 3");
  refuses("no second name", blocks + "Boundary/Contact = a.bottom with\n",
          "the name of a side, the word 'with'");
  refuses("a pair twice", blocks + pair.substr(0, pair.size() - 1) + " | b.top with a.bottom\n",
          "each pair once");
  // The upper block sees the lower one's top beside the small block between them.
  const auto three = [](const std::string &small) {
    return "Geometry/Bodies = a b c\nGeometry/Cells = 2, 2\nGeometry/Lower left = a: 0, -1 | b: " +
           small +
           " | c: 0, 1\nGeometry/Upper right = a: 2, 0 | b: 1.5, 0.5 | c: 2, 2\n"
           "Boundary/Contact = a.top with b.bottom c.bottom\nBoundary/Clamped = a.bottom\n";
  };
  refuses("one in the middle of the other", three("0.5, 0"), "lies in the middle");
  refuses("beside it, where only the free bodies are wrong", three("0, 0"), "of the body free");
  refuses("nothing for '*'", blocks + "Boundary/Contact = a.top with *\n",
          "no side of another body");
  refuses("a body that nothing presses", blocks + pair + "Boundary/Traction = a.top: 0; 0.01\n",
          "along (0, 1), of 'a'");
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {test_references, test_friction, test_patch, test_other_pairs,
                    test_parts_of_a_file, test_brackets, test_both_sides, test_limits,
                    test_press_fit, test_refusals});
}
