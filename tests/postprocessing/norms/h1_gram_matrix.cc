// SPDX-License-Identifier: LGPL-2.1-or-later
// A_1, the Gram matrix of V^h in (.,.)_{1,Omega}: symmetric, positive definite, and the squares of
// the norms of linear fields, integrated over a polygon by hand.

#include <signorini/postprocessing/norms/spectral_norm.h>
#include <signorini/problem/input/make_scene.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace
{
const std::vector<Point<2>> corners = {{0., 0.}, {2., 0.}, {2.5, 1.5}, {1., 2.5}, {-0.5, 1.}};
/** By the shoelace formula. */
constexpr double area = 5.;

Scene<2> pentagon()
{
  return make_scene<2>(parse_parameters("subsection Geometry\nset Shape = polygon\n"
                                        "set Vertices = 0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1\nend\n"
                                        "subsection Boundary\nset Contact = side0 side2\n"
                                        "set Rollers = side1\nset Clamped = side3\nend\n",
                                        "test"));
}

/** The same without anything that holds it: no row is condensed. */
Scene<2> loose()
{
  Scene<2> scene = pentagon();
  for (auto &condition : scene.boundary)
    condition.role = Role::free;
  return scene;
}

struct GramMatrix
{
  GramMatrix(Scene<2> given_scene, const unsigned int level)
    : scene(std::move(given_scene))
    , mesh(scene.geometry, level, level, MPI_COMM_WORLD)
    , space(mesh, scene)
    , A_1(assemble_h1_gram_matrix(space))
  {
  }

  DistributedVector distribute(const Displacement &values) const
  {
    DistributedVector vector = space.make_vector();
    for (const auto i : space.locally_owned())
      vector(i) = values[i];
    vector.compress(dealii::VectorOperation::insert);
    return vector;
  }
  /** v^T A_1 w. */
  double product(const Displacement &v, const Displacement &w) const
  {
    DistributedVector image = space.make_vector();
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
double integral(const Field &v, const Field &w)
{
  double sum = 0.;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    const Point<2> &a = corners[0], &b = corners[i], &c = corners[i + 1];
    const dealii::Tensor<1, 2> first = b - a, second = c - a;
    const double measure = 0.5 * (first[0] * second[1] - first[1] * second[0]);
    for (const Point<2> &middle : {a + 0.5 * (b - a), b + 0.5 * (c - b), c + 0.5 * (a - c)})
      sum += measure / 3. * (v(middle) * w(middle));
  }
  return sum;
}

void linear_fields(Checks &checks)
{
  const dealii::Tensor<2, 2> slope({{0.3, -0.7}, {1.1, 0.4}});
  const dealii::Tensor<1, 2> constant = Point<2>(0.8, -0.6);
  const Field linear = [&](const Point<2> &x) { return constant + slope * x; };
  const Field rotation = [](const Point<2> &x) { return Point<2>(-x[1], x[0]); };
  for (const unsigned int level : {0U, 2U})
  {
    const GramMatrix body(loose(), level);
    const std::string name = "level " + std::to_string(level);
    const Displacement v = nodal_values(body.space, linear), r = nodal_values(body.space, rotation);
    // |grad v|^2 = 0.09 + 0.49 + 1.21 + 0.16.
    const double square = integral(linear, linear) + 1.95 * area;
    checks.near(name + ": a linear field", body.product(v, v), square, 1e-12 * square);
    // grad v : grad r = 1.1 + 0.7.
    checks.near(name + ": a linear field and a rotation",
                body.product(v, r),
                integral(linear, rotation) + 1.8 * area,
                1e-11);
  }
}

/**
 * The trapezoid 0 < x < 1, 0 < y < 1 + a x as one cell, whose map has the determinant 1 + a x. The
 * function y/(1 + a x) of its bilinear functions has |v|_0^2 = (1 + a/2)/3 and
 * |v|_1^2 = (1 + a^2/3) log(1 + a)/a.
 */
void trapezoids(Checks &checks)
{
  for (const double a : {0.25, 1., 3., 15.})
  {
    Scene<2> scene = make_scene<2>(
      parse_parameters("subsection Geometry\nset Shape = polygon\nset Vertices = 0,0; "
                       "1,0; 1," +
                         std::to_string(1. + a) +
                         "; 0,1\nend\n"
                         "subsection Boundary\nset Contact = side0\n"
                         "set Clamped = side2\nend\n",
                       "test"));
    for (auto &condition : scene.boundary)
      condition.role = Role::free;
    const GramMatrix body(std::move(scene), 0);
    const Displacement v =
      nodal_values(body.space, [](const Point<2> &x) { return Point<2>(x[1] > 0. ? 1. : 0., 0.); });
    const double square = (1. + a / 2.) / 3. + (1. + a * a / 3.) * std::log(1. + a) / a;
    checks.near("trapezoid with sides 1 and " + std::to_string(1. + a),
                body.product(v, v),
                square,
                1e-10 * square);
  }
}

void positive_definite(Checks &checks, const std::string &name, const GramMatrix &body)
{
  const unsigned int n = body.space.dofs().n_dofs();
  dealii::LAPACKFullMatrix<double> dense(n, n);
  double asymmetry = 0., size = 0.;
  for (const auto &entry : body.A_1)
    dense(entry.row(), entry.column()) = entry.value();
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
    {
      asymmetry = std::max(asymmetry, std::abs(dense(i, j) - dense(j, i)));
      size = std::max(size, std::abs(dense(i, j)));
    }
  checks.near(name + ": symmetric", asymmetry, 0., 1e-14 * size);
  dealii::Vector<double> eigenvalues;
  dealii::FullMatrix<double> vectors;
  dense.compute_eigenvalues_symmetric(-1e300, 1e300, 0., eigenvalues, vectors);
  checks.that(name + ": positive definite",
              eigenvalues.size() == n &&
                *std::min_element(eigenvalues.begin(), eigenvalues.end()) > 1e-3 * size / n);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  linear_fields(checks);
  trapezoids(checks);
  positive_definite(checks, "loose", GramMatrix(loose(), 2));
  positive_definite(checks, "held", GramMatrix(pentagon(), 2));
  return checks.exit_code();
}
