// SPDX-License-Identifier: LGPL-2.1-or-later
// The contact part of the energy bound: w is what the inequality asks for, at random points; its
// energy and contact term are what independent quadrature finds.

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

#include "random_numbers.h"
#include "solved_level.h"
#include "tests.h"

using namespace Signorini;
using dealii::GeometryInfo;
using dealii::Point;
using dealii::Tensor;

namespace
{
std::string square(const std::string &more)
{
  return described("subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" + more);
}

/** Rollers, a prescribed displacement, a kink of the gap inside a face of odd levels. */
const std::string plate =
  described("subsection Geometry\nset Upper right = 2, 1\nset Cells = 2, 1\nend\n"
            "subsection Boundary\nset Rollers = left\nset Contact = bottom\n"
            "set Displacement = top: 0; -0.002*(1 - 0.2*x)\nend\n"
            "subsection Discretization\nset Kinks at x = 0.9\nend\n" +
            gap("0.004*max(0, x-0.9)"));

/** Two contact sides in an oblique corner, one of them next to an oblique roller. */
const std::string pentagon =
  described("subsection Geometry\nset Shape = polygon\n"
            "set Vertices = 0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1\nend\n"
            "subsection Boundary\nset Contact = side0 side4\nset Rollers = side1\n"
            "set Displacement = side3: 0.01; -0.02\nend\n"
            "subsection Load\nset Body force = -0.1; -0.2\nend\n" +
            gap("0.003*cos(3*x)"));

const std::string distorted =
  square("subsection Geometry\nset Distortion = 0.2\nend\n" + gap("-0.01+0.03*(x-0.4)^2"));

/** Patches that end inside faces, and a material that varies. */
const std::string not_nested =
  square("subsection Discretization\nset Patches = 5\nend\n"
         "subsection Material\nset Young's modulus = 1+0.5*sin(7*x)\nend\n" +
         gap("-0.01+0.02*sin(5*x)"));

const std::string jump = square(gap("if(x<0.4321, 0.001, -0.002)"));

const std::string kink = "subsection Discretization\nset Kinks at x = 0.4321\nend\n";

/** A beam that bends onto a foundation. */
const std::string beam =
  described("subsection Geometry\nset Upper right = 10, 1\nset Cells = 10, 1\nend\n"
            "subsection Boundary\nset Clamped = left\nset Contact = bottom\n"
            "set Traction = top: 0; -0.001\nend\n" +
            gap("0.02+0.001*x"));

Point<2> on_edge(const unsigned int face_no, const double t)
{
  Point<2> reference;
  reference[face_no / 2] = face_no % 2;
  reference[1 - face_no / 2] = t;
  return reference;
}

/** max (d - w_n) over random points of Gamma_c, d from the scene. */
double largest_violation(const SolvedLevel &s, const ContactLift &lift, const unsigned int n)
{
  RandomNumbers random(1);
  double largest = -1e300;
  for (unsigned int i = 0; i < n; ++i)
  {
    const ContactFace<2> &face = s.level.surface.faces()[i % s.level.surface.faces().size()];
    const auto cell = s.level.space.dof_cell(face.cell);
    const Point<2> reference = on_edge(face.face_no, 0.5 * (1. + random()));
    Point<2> x;
    Tensor<1, 2> u;
    for (unsigned int v = 0; v < 4; ++v)
    {
      const double shape = GeometryInfo<2>::d_linear_shape_function(reference, v);
      x += shape * cell->vertex(v);
      for (unsigned int d = 0; d < 2; ++d)
        u[d] += shape * s.U[cell->vertex_dof_index(v, d)];
    }
    const Side<2> &side = s.scene.geometry.sides[face.side];
    const double gap = s.scene.boundary[face.side].data->value(x);
    const Tensor<1, 2> w = lift.lift().value(cell, reference);
    largest = std::max(largest, (u - w) * side.normal(side.arc_length(x)) - gap);
  }
  return largest;
}

/** The largest |w| (on rollers |w_n|) on essential sides, and jump of w between cells. */
double largest_defect(const SolvedLevel &s, const ContactLift &lift)
{
  double largest = 0.;
  for (const auto &cell : s.level.space.dofs().active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      for (const double t : {0., 0.01, 0.3, 0.77, 1.})
      {
        const Tensor<1, 2> w = lift.lift().value(cell, on_edge(f, t));
        if (!cell->face(f)->at_boundary())
        {
          const auto other = cell->neighbor(f);
          const unsigned int g = cell->neighbor_of_neighbor(f);
          const bool same = cell->vertex_index(GeometryInfo<2>::face_to_cell_vertices(f, 0)) ==
                            other->vertex_index(GeometryInfo<2>::face_to_cell_vertices(g, 0));
          const Tensor<1, 2> v = lift.lift().value(other, on_edge(g, same ? t : 1. - t));
          largest = std::max(largest, (w - v).norm());
          continue;
        }
        const unsigned int side = cell->face(f)->boundary_id();
        const Role role = s.scene.boundary[side].role;
        if (role == Role::clamped || role == Role::displacement)
          largest = std::max(largest, w.norm());
        if (role == Role::roller)
          largest = std::max(largest, std::abs(w * s.scene.geometry.sides[side].normal(0.)));
      }
  return largest;
}

/** |||w|||² by differences of values of w, on n x n squares of every cell where w is not bilinear.
 */
double energy_by_differences(const SolvedLevel &s, const ContactLift &lift, const unsigned int n)
{
  const double step = 1e-6;
  double energy = 0.;
  for (const auto &cell : s.level.space.dofs().active_cell_iterators())
  {
    const auto w = [&](const Point<2> &x) { return lift.lift().value(cell, x); };
    double size = 0., bend = 0.;
    const dealii::QIterated<2> probes(dealii::QGauss<1>(1), 16);
    for (const Point<2> &x : probes.get_points())
    {
      Tensor<1, 2> change = w(x);
      for (unsigned int v = 0; v < 4; ++v)
        change -=
          GeometryInfo<2>::d_linear_shape_function(x, v) * w(GeometryInfo<2>::unit_cell_vertex(v));
      bend = std::max(bend, change.norm());
      size = std::max(size, w(x).norm());
    }
    const bool fine = bend > 1e-12 * size;
    if (!fine && size == 0.)
      continue;
    const dealii::QIterated<2> rule(dealii::QGauss<1>(2), fine ? n : 4);
    for (unsigned int q = 0; q < rule.size(); ++q)
    {
      const Point<2> &x = rule.point(q);
      Tensor<2, 2> J, slopes;
      Point<2> place;
      for (unsigned int v = 0; v < 4; ++v)
      {
        J += outer_product(Tensor<1, 2>(cell->vertex(v)),
                           GeometryInfo<2>::d_linear_shape_function_gradient(x, v));
        place += GeometryInfo<2>::d_linear_shape_function(x, v) * cell->vertex(v);
      }
      for (unsigned int d = 0; d < 2; ++d)
      {
        Point<2> before = x, after = x;
        before[d] -= step;
        after[d] += step;
        const Tensor<1, 2> change = w(after) - w(before);
        for (unsigned int c = 0; c < 2; ++c)
          slopes[c][d] = change[c] / (2. * step);
      }
      const auto strain = symmetrize(slopes * invert(J));
      energy += strain * (s.scene.material->hooke(place) * strain) * std::abs(determinant(J)) *
                rule.weight(q);
    }
  }
  return energy;
}

/** int p_H (d - w_n) on pieces, by a fine rule. */
double contact_term(const SolvedLevel &s, const ContactLift &lift)
{
  double sum = 0.;
  for (const Piece<2> &piece : s.level.surface.pieces())
  {
    const ContactFace<2> &face = s.level.surface.faces()[piece.face];
    const double a = piece.lower_on_face[0], b = piece.upper_on_face[0];
    const dealii::QIterated<1> rule(dealii::QGauss<1>(3), 200);
    for (unsigned int q = 0; q < rule.size(); ++q)
    {
      const double t = a + (b - a) * rule.point(q)[0];
      const PenetrationFace &trace = lift.trace().faces()[piece.face];
      const double w_n =
        lift.lift().value(s.level.space.dof_cell(face.cell), on_edge(face.face_no, t)) *
        trace.normal;
      sum += s.P[piece.patch] * (lift.trace().penetration(trace, t) - w_n) * std::abs(b - a) *
             trace.length * rule.weight(q);
    }
  }
  return sum;
}

/** How accurately a scene is looked at. */
struct Accuracy
{
  /** Of w_n >= d, relative to the largest d. */
  double violation = 1e-9;
  /** Of the energy by differences, and the squares per direction of a cell. */
  double energy = 3e-3;
  unsigned int n_squares = 60;
};

void admissible(Checks &checks,
                const std::string &name,
                const std::string &text,
                const unsigned int number,
                const Accuracy &accuracy = {})
{
  const SolvedLevel s(text, number);
  for (const bool dual : {false, true})
  {
    const ContactLift lift = s.lift(dual);
    const std::string which = name + (dual ? ", dual" : ", layer");
    checks.that(which + ": there is a bound", lift.bound().has_value());
    if (!lift.bound())
      continue;
    const ContactBound &bound = *lift.bound();
    const double size = lift.trace().max_penetration();
    checks.between(
      which + ": w_n >= d", largest_violation(s, lift, 10000), -1e300, accuracy.violation * size);
    checks.near(which + ": w belongs to V", largest_defect(s, lift), 0., 1e-11 * size);
    checks.near(which + ": energy",
                energy_by_differences(s, lift, accuracy.n_squares),
                bound.lift_energy,
                accuracy.energy * bound.lift_energy);
    checks.near(
      which + ": contact term", contact_term(s, lift), bound.contact_term, 1e-4 * bound.square());
    checks.between(which + ": sign", bound.contact_term, -1e-12 * bound.square(), 1e300);
  }
}

} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);
  for (const char *name : {"A1", "B1", "A3", "C1", "C4", "O1", "V1"})
    admissible(checks, name, named(name), 3);
  admissible(checks, "rollers and prescribed sides", plate, 3);
  admissible(checks, "oblique sides", pentagon, 2);
  admissible(checks, "distorted cells", distorted, 3);
  admissible(checks, "patches that end inside faces", not_nested, 3);
  admissible(checks, "bending", beam, 1);
  admissible(checks, "a gap that jumps at a kink", jump + kink, 3, {1e-9, 0.02, 256});
  admissible(checks, "a gap that jumps at a node", square(gap("if(x<0.5, -0.002, 0.001)")), 3);
  admissible(checks, "the same upwards", square(gap("if(x<=0.5, 0.001, -0.002)")), 3);
  // Between samples, g is not known to 1/1024 of a face, and w is steep on 1/256.
  admissible(checks, "a gap that jumps", jump, 3, {1e-4, 0.5, 256});
  admissible(checks, "missed contact", missed, 5, {1e-9, 0.01, 256});
  return checks.exit_code();
}
