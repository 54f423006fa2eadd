// SPDX-License-Identifier: LGPL-2.1-or-later
// Proved constants for the loads that stresses do not balance exactly.

#include <signorini/base/parallel.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/loads/cell_loads.h>
#include <signorini/problem/scene/functions.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini {
namespace {
using numbers::PI;

/** Returns ρ/R for the discs about a point of the cell. */
double roundness(const CellShape &shape, const Point<2> &x) {
  double rho = std::numeric_limits<double>::max(), R = 0.;
  for (unsigned int k = 0; k < 4; ++k) {
    const Tensor<1, 2> edge = shape.corners[(k + 1) % 4] - shape.corners[k];
    rho = std::min(rho, cross(edge, x - shape.corners[k]) / edge.norm());
    R = std::max(R, x.distance(shape.corners[k]));
  }
  return rho / R;
}

/** Returns Korn's constant, with the better of two centres. */
double korn_constant(const CellShape &shape) {
  const double tau = std::max(roundness(shape, shape.centre()), roundness(shape, shape.crossing));
  const double beta = tau / std::sqrt(2. * (1. + std::sqrt(std::max(0., 1. - tau * tau))));
  return std::sqrt(1. + 2. / (beta * beta));
}

/** Returns the constant in ‖v‖_e ≤ constant ‖grad v‖_T on the triangle of an edge from a to b and
 * a point P. */
double trace_constant(const Point<2> &a, const Point<2> &b, const Point<2> &P) {
  const double length = a.distance(b), area = 0.5 * std::abs(cross(b - a, P - a));
  const double to_P = std::max(a.distance(P), b.distance(P));
  const double poincare = std::max(to_P, length) / PI;
  return std::sqrt(length / area * (poincare * poincare + to_P * poincare));
}

/** Returns the depth of the largest rectangle on edge k that lies in the cell; 0 if there is none.
 */
double depth(const CellShape &shape, const unsigned int k) {
  const auto &a = shape.corners[k], &b = shape.corners[(k + 1) % 4];
  const Tensor<1, 2> along = (b - a) / a.distance(b);
  const Tensor<1, 2> left = shape.corners[(k + 3) % 4] - a, right = shape.corners[(k + 2) % 4] - b;
  constexpr double rounding = 1e-12;
  if (left * along > rounding * left.norm() || right * along < -rounding * right.norm())
    return 0.;
  return std::min(cross(along, left), cross(along, right));
}

/** Returns the constant of Airy's function on a rectangle. */
double beam_constant(const double L, const double max_depth) {
  const double d = std::min(max_depth, 0.73 * L);
  return std::sqrt(13. / 35. * d + 12. / (5. * d) * L * L / (4. * PI * PI) +
                   12. / std::pow(d, 3) * std::pow(L, 4) / 500.56);
}
} // namespace

double turning_constant(const double L, const double max_depth) {
  const double d = std::min(L, max_depth);
  return std::sqrt(4. * L * L * L / (30. * d) + 4. * L * d / 45. + 4. * d * d * d / (105. * L));
}

OscillationConstants::OscillationConstants(const CellShape &shape)
  : korn(korn_constant(shape))
  , body(korn * shape.diameter() / PI) {
  const auto &x = shape.corners;
  for (unsigned int k = 0; k < 4; ++k) {
    const auto &a = x[k], &b = x[(k + 1) % 4];
    edge[k] =
      korn * std::min(trace_constant(a, b, x[(k + 2) % 4]), trace_constant(a, b, x[(k + 3) % 4]));
    const double d = depth(shape, k);
    normal[k] = d > 0. ? std::min(edge[k], beam_constant(a.distance(b), d)) : edge[k];
  }
}

// Body forces, cell by cell.

namespace {
/** Returns ∫ (x - c)(x - c)ᵀ over triangle k with its centre c. */
Tensor<2, 2> second_moments(const CellShape &shape, const unsigned int k) {
  Tensor<2, 2> sum;
  for (const Point<2> &v : shape.triangle(k))
    sum += shape.areas[k] / 12. * outer_product(v - shape.centre(k), v - shape.centre(k));
  return sum;
}

/** A rule on cells, with f at its points. */
struct LoadRule {
  LoadRule(const BoundData &data, const unsigned int n_points)
    : values(data.space.mesh().mapping(), data.space, data.scene.kinks, n_points,
             update_values | update_quadrature_points | update_JxW_values) {}

  CellValues<2> values;
  std::vector<dealii::Vector<double>> f;
};

/** Returns the load of a cell by a rule. */
CellLoad make_load(const CellShape &shape, const Triangulation<2>::active_cell_iterator &cell,
                   const Function<2> &force, LoadRule &rule) {
  const FEValues<2> &values = rule.values.reinit(cell);
  const auto &points = values.get_quadrature_points();
  auto &f = rule.f;
  f.resize(points.size(), dealii::Vector<double>(2));
  force.vector_value_list(points, f);
  CellLoad load;
  // Corners counter-clockwise; the shape functions of a vertex follow each other.
  constexpr std::array<unsigned int, 4> vertex_in_circle = {{0, 1, 3, 2}};
  for (std::size_t i = 0; i < points.size(); ++i)
    for (unsigned int a = 0; a < 4; ++a)
      for (unsigned int c = 0; c < 2; ++c)
        load.nodal[a][c] +=
          f[i][c] * values.shape_value(2 * vertex_in_circle[a], i) * values.JxW(i);
  // The linear force mean + gradient (x - centre) with the same force and first moments.
  const Point<2> centre = shape.centre();
  Tensor<1, 2> mean;
  Tensor<2, 2> first_moments, inertia;
  for (unsigned int k = 0; k < 4; ++k) {
    mean += load.nodal[k] / shape.area();
    first_moments += outer_product(load.nodal[k], shape.corners[k] - centre);
    const Tensor<1, 2> arm = shape.centre(k) - centre;
    inertia += second_moments(shape, k) + shape.areas[k] * outer_product(arm, arm);
  }
  const Tensor<2, 2> gradient = first_moments * invert(inertia);
  double square = 0.;
  for (std::size_t i = 0; i < points.size(); ++i)
    square +=
      (Tensor<1, 2>({f[i][0], f[i][1]}) - mean - gradient * (points[i] - centre)).norm_square() *
      values.JxW(i);
  load.rest = std::sqrt(square);
  load.constant.fill(mean);
  if (shape.affine) {
    const Tensor<2, 2> A = shape.half_edges();
    load.slope = invert(A) * gradient * A;
    return load;
  }
  double moment = first_moments[1][0] - first_moments[0][1], rest = 0.;
  for (unsigned int k = 0; k < 4; ++k) {
    const Tensor<1, 2> arm = shape.centre(k) - centre;
    load.constant[k] += gradient * arm;
    moment -= shape.areas[k] * cross(arm, gradient * arm);
    rest += trace(gradient * second_moments(shape, k) * transpose(gradient));
  }
  load.rest += std::sqrt(rest + std::pow(load.add_couple(shape, moment), 2));
  return load;
}
} // namespace

Components CellLoad::stress(const CellShape &shape, const Point<2> &at) const {
  const double xi = 2. * at[0] - 1., eta = 2. * at[1] - 1.;
  Tensor<2, 2> s;
  s[0][0] = -0.5 * slope[0][0] * (xi * xi - 1.) - slope[0][1] * xi * eta;
  s[1][1] = -0.5 * slope[1][1] * (eta * eta - 1.) - slope[1][0] * xi * eta;
  const Tensor<2, 2> A = shape.half_edges(), t = A * s * transpose(A);
  return Components({t[0][0], t[1][1], t[0][1]});
}

CellMoments CellLoad::moments(const CellShape &shape) const {
  // The traction times |e| on edge 0 is -2 J slope[1][0] ξ g_2, on edge 1 -2 J slope[0][1] η g_1,
  // with the opposite sign of ξ and η along the opposite edges, and g_i the columns of A.
  const Tensor<2, 2> A = shape.half_edges();
  CellMoments result;
  for (unsigned int k = 0; k < 4; ++k)
    for (unsigned int c = 0; c < 2; ++c) {
      const unsigned int across = 1 - k % 2;
      const double at_first_end =
        (k < 2 ? 1. : -1.) * determinant(A) / 3. * slope[across][1 - across] * A[c][across];
      result[4 * k + c] = at_first_end;
      result[4 * k + 2 + c] = -at_first_end;
    }
  return result;
}

double CellLoad::add_couple(const CellShape &shape, const double moment) {
  double inertia = 0.;
  for (unsigned int k = 0; k < 4; ++k)
    inertia += shape.areas[k] * (shape.centre(k) - shape.centre()).norm_square();
  for (unsigned int k = 0; k < 4; ++k)
    constant[k] -= moment / inertia * cross_product_2d(shape.centre(k) - shape.centre());
  return std::abs(moment) / std::sqrt(inertia);
}

std::vector<Triangulation<2>::active_cell_iterator>
cells_in_order(const DisplacementSpace<2> &space) {
  std::vector<Triangulation<2>::active_cell_iterator> cells;
  for (const auto &cell : space.mesh().triangulation().active_cell_iterators())
    cells.push_back(cell);
  return cells;
}

std::vector<CellLoad> make_loads(const BoundData &data, const EdgeMesh &mesh) {
  if (data.scene.body_force == nullptr)
    return {};
  const Function<2> &force = *data.scene.body_force;
  const auto cells = cells_in_order(data.space);
  std::vector<CellLoad> loads(cells.size());
  // About 500000 points on the mesh, as long as these are more than the system has.
  const unsigned int n_fine = std::clamp<unsigned int>(std::sqrt(5e5 / cells.size()), 1, 96);
  // The rules of cells that are cut have that many points on each of up to hundreds of parts.
  constexpr unsigned int max_points_on_parts = 8;
  const bool check = n_fine > data.n_points && !is_constant(force);
  const auto work = [&](const std::size_t begin, const std::size_t end) {
    LoadRule rule(data, data.n_points), finer(data, n_fine),
      finer_on_parts(data, std::min(n_fine, max_points_on_parts));
    for (std::size_t i = begin; i < end; ++i) {
      const CellShape shape(mesh.cells()[i].corners);
      loads[i] = make_load(shape, cells[i], force, rule);
      if (!check)
        continue;
      const bool is_cut = needs_cuts<2>(data.scene.kinks, cells[i]);
      const CellLoad fine = make_load(shape, cells[i], force, is_cut ? finer_on_parts : finer);
      if (!agree(loads[i].nodal, fine.nodal, loads[i].rest, fine.rest, shape.area()))
        loads[i] = fine;
    }
  };
  work_on_ranges(n_available_threads(data.space.mesh().communicator()), cells.size(), work);
  return loads;
}
} // namespace Signorini
