// SPDX-License-Identifier: LGPL-2.1-or-later
// The stiffness matrix of one cell against exact integrals of products of linear functions.

#include <signorini/discretization/space/cell_stiffness.h>
#include <signorini/discretization/space/internal_forces.h>
#include <signorini/problem/input/make_scene.h>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;
using dealii::Tensor;

namespace {
constexpr double lambda = 2., mu = 3.;
/** E = mu (3 lambda + 2 mu)/(lambda + mu), nu = lambda/(2 (lambda + mu)). */
const std::string elastic = "subsection Material\nset Young's modulus = 7.2\n"
                            "set Poisson's ratio = 0.2\nend\n";

std::string rectangle(const std::string &upper_right, const std::string &material) {
  return "subsection Geometry\nset Upper right = " + upper_right +
         "\nend\nsubsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" + material;
}

std::string polygon(const std::string &vertices) {
  return "subsection Geometry\nset Shape = polygon\nset Vertices = " + vertices +
         "\nend\nsubsection Boundary\nset Clamped = side2\nset Contact = side0\nend\n" + elastic;
}

/** A mesh without contact faces, which the stiffness does not know of. */
struct Body {
  Body(const std::string &text, const unsigned int level,
       const StrainOperator strain_operator = StrainOperator::symmetric_gradient)
    : scene(scene_of(text))
    , mesh(scene.geometry, level, level, MPI_COMM_WORLD)
    , space(mesh, scene, strain_operator)
    , stiffness(space, scene)
    , unit(stiffness_unit(space, *scene.material)) {}

  dealii::FullMatrix<double> first_matrix() {
    dealii::FullMatrix<double> matrix = stiffness(mesh.triangulation().begin_active());
    matrix *= unit;
    return matrix;
  }
  /** a(u,u) on the first cell for the nodal interpolant of u. */
  double energy(const Field &u) {
    const auto cell = mesh.triangulation().begin_active();
    dealii::Vector<double> U(8);
    for (unsigned int i = 0; i < 8; ++i) {
      const auto component_and_vertex = space.element().system_to_component_index(i);
      U[i] = u(cell->vertex(component_and_vertex.second))[component_and_vertex.first];
    }
    return unit * stiffness(cell).matrix_norm_square(U);
  }

  Scene<2> scene;
  Mesh<2> mesh;
  DisplacementSpace<2> space;
  CellStiffness<2> stiffness;
  double unit;
};

/** a(u,u) of u = (A, B) on the rectangle [0,a] x [0,b], A = c_0 + c_1 x + c_2 y + c_3 x y and B in
 * the same way: all entries of the matrix contribute. */
double energy_on_rectangle(const dealii::Vector<double> &c, const double a, const double b) {
  double energy = 0.;
  const dealii::QGauss<2> gauss(2);
  for (unsigned int q = 0; q < gauss.size(); ++q) {
    const double x = a * gauss.point(q)[0], y = b * gauss.point(q)[1];
    const double e11 = c[1] + c[3] * y, e22 = c[6] + c[7] * x,
                 shear = c[2] + c[3] * x + c[5] + c[7] * y;
    energy +=
      a * b * gauss.weight(q) *
      (lambda * std::pow(e11 + e22, 2) + 2. * mu * (e11 * e11 + e22 * e22) + mu * shear * shear);
  }
  return energy;
}

double distance(const dealii::FullMatrix<double> &a, const dealii::FullMatrix<double> &b) {
  dealii::FullMatrix<double> difference(a);
  difference.add(-1., b);
  return difference.linfty_norm();
}

void rectangles(Checks &checks) {
  Body square(rectangle("1, 1", elastic), 0);
  const auto matrix = square.first_matrix();
  Body stretched(rectangle("3, 0.5", elastic), 0);
  RandomNumbers random(1);
  for (unsigned int trial = 0; trial < 36; ++trial) {
    const dealii::Vector<double> c = random.vector(8);
    const Field u = [&](const Point<2> &x) {
      return Point<2>(c[0] + c[1] * x[0] + c[2] * x[1] + c[3] * x[0] * x[1],
                      c[4] + c[5] * x[0] + c[6] * x[1] + c[7] * x[0] * x[1]);
    };
    checks.near("energies on a square and a rectangle", {square.energy(u), stretched.energy(u)},
                {energy_on_rectangle(c, 1., 1.), energy_on_rectangle(c, 3., 0.5)}, 1e-12);
  }
  Body tiny(rectangle("1e-6, 1e-6", elastic), 3);
  checks.near("independent of the size of the square", distance(matrix, tiny.first_matrix()), 0.,
              1e-13);
}

/** Rigid motions cost nothing, linear fields |K| sigma:eps, on every shape of cell. */
void shapes(Checks &checks) {
  const std::pair<const char *, const char *> vertices[] = {
    {"square", "0,0; 1,0; 1,1; 0,1"},
    {"parallelogram", "0,0; 2,1; 3,3; 1,2"},
    {"quadrilateral", "0,0; 2,-0.5; 2.5,1.5; -0.3,1"}};
  // The shoelace formula.
  const double areas[] = {1., 3., 3.6};
  for (unsigned int k = 0; k < 3; ++k) {
    Body body(polygon(vertices[k].second), 0);
    checks.about(vertices[k].first);
    const double scale = body.first_matrix().linfty_norm();
    const Field motions[] = {[](const Point<2> &) { return Point<2>(1., 0.); },
                             [](const Point<2> &) { return Point<2>(0., 1.); },
                             [](const Point<2> &x) { return Point<2>(-x[1], x[0]); }};
    double energy = 0.;
    for (const Field &motion : motions)
      energy = std::max(energy, body.energy(motion));
    checks.near("rigid motions", energy, 0., 1e-13 * scale);
    // eps = ((0.3, 0.1), (0.1, -0.2)): tr = 0.1, eps:eps = 0.15.
    const double linear = body.energy([](const Point<2> &x) {
      return Point<2>(0.3 * x[0] + 0.4 * x[1], -0.2 * x[0] - 0.2 * x[1]);
    });
    checks.near("linear field", linear, areas[k] * (lambda * 0.01 + 2. * mu * 0.15), 1e-12);
  }
}

/** Cells of several shapes in turn: the matrix is that of a fresh integration. */
void congruent_cells(Checks &checks) {
  for (const char *vertices : {"0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1", "0,0; 2,1; 3,3; 1,2"}) {
    Body body(polygon(vertices), 2);
    double largest = 0.;
    for (const auto &cell : body.mesh.triangulation().active_cell_iterators()) {
      CellStiffness<2> fresh(body.space, body.scene);
      largest = std::max(largest, distance(body.stiffness(cell), fresh(cell)));
    }
    checks.near("congruent cells share the right matrix", largest, 0., 1e-12);
  }
}

/** nu = 0: a(u,u) = int E eps:eps. */
void varying_modulus(Checks &checks) {
  const auto material = [](const std::string &modulus) {
    return "subsection Material\nset Young's modulus = " + modulus +
           "\nset Poisson's ratio = 0\nend\n";
  };
  Body body(rectangle("1, 1", material("1 + x")), 0);
  const double stretch = body.energy([](const Point<2> &x) { return Point<2>(x[0], 0.); });
  checks.near("E = 1 + x, u = (x, 0)", stretch, 1.5, 1e-14);
  // eps11 = y, eps12 = x/2: int (1 + x)(y^2 + x^2/2) = 1/2 + 7/24.
  const double twist = body.energy([](const Point<2> &x) { return Point<2>(x[0] * x[1], 0.); });
  checks.near("E = 1 + x, u = (x y, 0)", twist, 19. / 24., 1e-14);
  Body kinked(
    rectangle("1, 1", material("1 + max(x - 0.3, 0)") + "Discretization/Kinks at x = 0.3\n"), 0);
  // int_0.3^1 (x - 0.3) = 0.245.
  checks.near("E with a kink", kinked.energy([](const Point<2> &x) { return Point<2>(x[0], 0.); }),
              1.245, 1e-14);
}

/** u = (x y, 0): tr eps = y has the mean 1/2, so that the strain is (y/2 + 1/4, 1/4 - y/2, x/2). */
void mean_dilatation(Checks &checks) {
  Body square(rectangle("1, 1", elastic), 0, StrainOperator::mean_dilatation);
  const double linear = square.energy(
    [](const Point<2> &x) { return Point<2>(0.3 * x[0] + 0.4 * x[1], -0.2 * x[0] - 0.2 * x[1]); });
  checks.near("B-bar: linear fields are not affected", linear, lambda * 0.01 + 2. * mu * 0.15,
              1e-14);
  const double twist = square.energy([](const Point<2> &x) { return Point<2>(x[0] * x[1], 0.); });
  checks.near("B-bar: u = (x y, 0)", twist, lambda / 4. + 2. * mu * 22. / 48., 1e-14);
}

/** internal_forces is the product with the unconstrained matrix: work and resultants. */
void forces(Checks &checks) {
  const Body body(polygon("0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1"), 2);
  RandomNumbers random(1);
  const Displacement U = random_rows(body.space, random);
  const DualVector internal = internal_forces(DisplacedBody(body.space, body.scene, U)).forces;
  const double scale = internal.l1_norm();
  const Field rotation = [](const Point<2> &x) { return Point<2>(-x[1], x[0]); };
  const Field translation = [](const Point<2> &) { return Point<2>(1., 2.); };
  checks.near("internal forces have no resultant", internal * nodal_values(body.space, translation),
              0., 1e-13 * scale);
  checks.near("internal forces have no moment", internal * nodal_values(body.space, rotation), 0.,
              1e-13 * scale);
  const auto linear = nodal_values(body.space, [](const Point<2> &x) {
    return Point<2>(0.3 * x[0] + 0.4 * x[1], -0.2 * x[0] - 0.2 * x[1]);
  });
  // Area of the pentagon by the shoelace formula: 5.
  checks.near("work of a linear field",
              linear * internal_forces(DisplacedBody(body.space, body.scene, linear)).forces,
              5. * (lambda * 0.01 + 2. * mu * 0.15), 1e-12);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {rectangles, shapes, congruent_cells, varying_modulus, mean_dilatation, forces});
}
