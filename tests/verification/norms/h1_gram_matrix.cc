// SPDX-License-Identifier: LGPL-2.1-or-later
// A_1, the Gram matrix of V^h in (.,.)_{1,Omega}: the squares of
// the norms of linear fields, integrated over a polygon by hand.

#include <signorini/problem/input/make_scene.h>
#include <signorini/verification/norms/inf_sup.h>

#include <algorithm>
#include <cmath>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace {
const std::vector<Point<2>> corners = {{0., 0.}, {2., 0.}, {2.5, 1.5}, {1., 2.5}, {-0.5, 1.}};
/** By the shoelace formula. */
constexpr double area = 5.;

/** Nothing holds the body: no row is condensed. */
Scene<2> loose(const std::string &vertices) {
  Scene<2> scene = scene_of("Geometry/Shape = polygon\nBoundary/Contact = side0\n"
                            "Boundary/Clamped = side2\nGeometry/Vertices = " +
                            vertices);
  for (auto &condition : scene.boundary)
    condition.role = Role::free;
  scene.contacts.clear();
  return scene;
}

struct GramMatrix {
  GramMatrix(Scene<2> given_scene, const unsigned int level)
    : scene(std::move(given_scene))
    , mesh(scene.geometry, level, level, MPI_COMM_WORLD)
    , space(mesh, scene)
    , A_1(assemble_h1_gram_matrix(space)) {}

  DualVector distribute(const Displacement &values) const {
    DualVector vector = space.make_vector();
    for (const auto i : space.locally_owned())
      vector(i) = values[i];
    vector.compress(dealii::VectorOperation::insert);
    return vector;
  }
  /** v^T A_1 w. */
  double product(const Displacement &v, const Displacement &w) const {
    DualVector image = space.make_vector();
    A_1.vmult(image, distribute(w));
    return distribute(v) * image;
  }

  Scene<2> scene;
  Mesh<2> mesh;
  DisplacementSpace<2> space;
  dealii::TrilinosWrappers::SparseMatrix A_1;
};

/** int v.w over the pentagon: triangles from one corner, the middles of whose edges integrate
 * functions of degree two. */
double integral(const Field &v, const Field &w) {
  double sum = 0.;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Point<2> &a = corners[0], &b = corners[i], &c = corners[i + 1];
    const dealii::Tensor<1, 2> first = b - a, second = c - a;
    const double measure = 0.5 * (first[0] * second[1] - first[1] * second[0]);
    for (const Point<2> &middle : {a + 0.5 * (b - a), b + 0.5 * (c - b), c + 0.5 * (a - c)})
      sum += measure / 3. * (v(middle) * w(middle));
  }
  return sum;
}

void linear_fields(Checks &checks) {
  const dealii::Tensor<2, 2> slope({{0.3, -0.7}, {1.1, 0.4}});
  const dealii::Tensor<1, 2> constant = Point<2>(0.8, -0.6);
  const Field linear = [&](const Point<2> &x) { return constant + slope * x; };
  const Field rotation = [](const Point<2> &x) { return Point<2>(-x[1], x[0]); };
  for (const unsigned int level : {0U, 2U}) {
    const GramMatrix body(loose("0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1"), level);
    checks.about("level " + std::to_string(level));
    const Displacement v = nodal_values(body.space, linear), r = nodal_values(body.space, rotation);
    // |grad v|^2 = 0.09 + 0.49 + 1.21 + 0.16.
    const double square = integral(linear, linear) + 1.95 * area;
    checks.near("a linear field", body.product(v, v), square, 1e-12 * square);
    // grad v : grad r = 1.1 + 0.7.
    checks.near("a linear field and a rotation", body.product(v, r),
                integral(linear, rotation) + 1.8 * area, 1e-11);
  }
}

/**
 * The trapezoid 0 < x < 1, 0 < y < 1 + a x as one cell, whose map has the determinant 1 + a x. The
 * function y/(1 + a x) of its bilinear functions has |v|_0^2 = (1 + a/2)/3 and
 * |v|_1^2 = (1 + a^2/3) log(1 + a)/a.
 */
void trapezoids(Checks &checks) {
  for (const double a : {0.25, 1., 3., 15.}) {
    const GramMatrix body(loose("0,0; 1,0; 1," + std::to_string(1. + a) + "; 0,1"), 0);
    const Displacement v =
      nodal_values(body.space, [](const Point<2> &x) { return Point<2>(x[1] > 0. ? 1. : 0., 0.); });
    const double square = (1. + a / 2.) / 3. + (1. + a * a / 3.) * std::log(1. + a) / a;
    checks.near("trapezoid with sides 1 and " + std::to_string(1. + a), body.product(v, v), square,
                1e-10 * square);
  }
}

} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {linear_fields, trapezoids});
}
