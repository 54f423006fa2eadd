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
#include <memory>

namespace Signorini
{
namespace
{
using numbers::PI;
using Vector2 = Tensor<1, 2>;

/** Returns ρ/R for the discs about a point of the cell. */
double roundness(const CellShape &shape, const Point<2> &x)
{
  double rho = std::numeric_limits<double>::max(), R = 0.;
  for (unsigned int k = 0; k < 4; ++k)
  {
    const Vector2 edge = shape.corners[(k + 1) % 4] - shape.corners[k];
    rho = std::min(rho, cross(edge, x - shape.corners[k]) / edge.norm());
    R = std::max(R, x.distance(shape.corners[k]));
  }
  return rho / R;
}

/** Returns Korn's constant, with the better of two centres. */
double korn_constant(const CellShape &shape)
{
  const double tau = std::max(roundness(shape, shape.centre()), roundness(shape, shape.crossing));
  const double beta = tau / std::sqrt(2. * (1. + std::sqrt(std::max(0., 1. - tau * tau))));
  return std::sqrt(1. + 2. / (beta * beta));
}

/** Returns the constant in ‖v‖_e ≤ constant ‖grad v‖_T on the triangle of an edge from a to b and
 * a point P. */
double trace_constant(const Point<2> &a, const Point<2> &b, const Point<2> &P)
{
  const double length = a.distance(b), area = 0.5 * std::abs(cross(b - a, P - a));
  const double to_P = std::max(a.distance(P), b.distance(P));
  const double poincare = std::max(to_P, length) / PI;
  return std::sqrt(length / area * (poincare * poincare + to_P * poincare));
}

/** Returns the depth of the largest rectangle on edge k that lies in the cell; 0 if there is none.
 */
double depth(const CellShape &shape, const unsigned int k)
{
  const auto &a = shape.corners[k], &b = shape.corners[(k + 1) % 4];
  const Vector2 along = (b - a) / a.distance(b);
  const Vector2 left = shape.corners[(k + 3) % 4] - a, right = shape.corners[(k + 2) % 4] - b;
  constexpr double rounding = 1e-12;
  if (left * along > rounding * left.norm() || right * along < -rounding * right.norm())
    return 0.;
  return std::min(cross(along, left), cross(along, right));
}

/** Returns the constant of Airy's function on a rectangle. */
double beam_constant(const double L, const double max_depth)
{
  const double d = std::min(max_depth, 0.73 * L);
  return std::sqrt(13. / 35. * d + 12. / (5. * d) * L * L / (4. * PI * PI) +
                   12. / std::pow(d, 3) * std::pow(L, 4) / 500.56);
}
} // namespace

double turning_constant(const double L, const double max_depth)
{
  const double d = std::min(L, max_depth);
  return std::sqrt(4. * L * L * L / (30. * d) + 4. * L * d / 45. + 4. * d * d * d / (105. * L));
}

OscillationConstants::OscillationConstants(const CellShape &shape)
  : korn(korn_constant(shape))
  , body(korn * shape.diameter() / PI)
{
  const auto &x = shape.corners;
  for (unsigned int k = 0; k < 4; ++k)
  {
    const auto &a = x[k], &b = x[(k + 1) % 4];
    edge[k] =
      korn * std::min(trace_constant(a, b, x[(k + 2) % 4]), trace_constant(a, b, x[(k + 3) % 4]));
    const double d = depth(shape, k);
    normal[k] = d > 0. ? std::min(edge[k], beam_constant(a.distance(b), d)) : edge[k];
  }
}

// Body forces, cell by cell.

namespace
{
using Vector2 = Tensor<1, 2>;
using Matrix2 = Tensor<2, 2>;

Vector2 rotated(const Vector2 &a)
{
  return Vector2({-a[1], a[0]});
}

/** Returns the components of a in the basis g_1, g_2. */
Vector2 in_basis(const Vector2 &a, const Vector2 &g1, const Vector2 &g2)
{
  return Vector2({cross(a, g2), cross(g1, a)}) / cross(g1, g2);
}

Vector2 g1_of(const CellShape &shape)
{
  return 0.5 * (shape.corners[1] - shape.corners[0]);
}
Vector2 g2_of(const CellShape &shape)
{
  return 0.5 * (shape.corners[3] - shape.corners[0]);
}

/** Returns ∫ (x - x_K)(x - x_K)ᵀ over the cell: per triangle A/12 times the sum over its
 * vertices, about its own centre. */
Matrix2 second_moments(const CellShape &shape)
{
  Matrix2 sum;
  for (unsigned int k = 0; k < 4; ++k)
  {
    const Point<2> centre = shape.centre(k);
    for (const auto &v : {shape.corners[k], shape.corners[(k + 1) % 4], shape.crossing})
      sum += shape.areas[k] / 12. * outer_product(v - centre, v - centre);
    const Vector2 arm = centre - shape.centre();
    sum += shape.areas[k] * outer_product(arm, arm);
  }
  return sum;
}

/** The linear force c + G (x - x_K) with the force and the first moments of the nodal forces. */
struct LinearForce
{
  LinearForce(const CellShape &shape, const std::array<Vector2, 4> &nodal)
  {
    const Point<2> centre = shape.centre();
    for (unsigned int a = 0; a < 4; ++a)
    {
      mean += nodal[a] / shape.area();
      first_moments += outer_product(nodal[a], shape.corners[a] - centre);
    }
    gradient = first_moments * invert(second_moments(shape));
  }
  Vector2 mean;
  Matrix2 first_moments, gradient;
};

/**
 * Sets the loads of the triangles.
 * @return the square of the L2-distance from the linear force.
 */
double distribute(const CellShape &shape, const LinearForce &force, CellLoad &load)
{
  double moment = force.first_moments[1][0] - force.first_moments[0][1], inertia = 0.;
  std::array<Vector2, 4> arms;
  for (unsigned int k = 0; k < 4; ++k)
  {
    arms[k] = shape.centre(k) - shape.centre();
    moment -= shape.areas[k] * cross(arms[k], force.gradient * arms[k]);
    inertia += shape.areas[k] * arms[k].norm_square();
  }
  const double omega = moment / inertia;
  double square = 0.;
  for (unsigned int k = 0; k < 4; ++k)
  {
    const Vector2 turn = omega * rotated(arms[k]);
    const Vector2 value = force.mean + force.gradient * arms[k] + turn;
    load.constant[2 * k] = value[0];
    load.constant[2 * k + 1] = value[1];
    square += shape.areas[k] * turn.norm_square();
    for (const auto &v : {shape.corners[k], shape.corners[(k + 1) % 4], shape.crossing})
      square += shape.areas[k] / 12. * (force.gradient * (v - shape.centre(k))).norm_square();
  }
  return square;
}

/** Returns whether finer quadrature gives the same load. */
bool agree(const CellLoad &load, const CellLoad &finer)
{
  constexpr double tolerance = 1e-4;
  double difference = 0., size = 0.;
  for (unsigned int a = 0; a < 4; ++a)
  {
    difference = std::max(difference, (load.nodal[a] - finer.nodal[a]).norm());
    size = std::max(size, load.nodal[a].norm());
  }
  return difference <= tolerance * size && finer.rest <= 1.01 * load.rest + tolerance * size;
}

/** Evaluates the body force at the Gauss points of cells. */
class ForceSampler
{
public:
  ForceSampler(const DisplacementSpace<2> &space,
               const Scene<2> &scene,
               const unsigned int n_points)
    : force_(*scene.body_force)
    , values_(space.mesh().mapping(),
              space,
              scene.kinks,
              n_points,
              update_values | update_quadrature_points | update_JxW_values)
  {
  }
  template <typename CellIterator>
  const ForceAtPoints &sample(const CellIterator &cell)
  {
    const FEValues<2> &values = values_.reinit(cell);
    const auto &points = values.get_quadrature_points();
    if (sample_.values.size() != points.size())
    {
      sample_.values.assign(points.size(), dealii::Vector<double>(2));
      sample_.offsets.resize(points.size());
      sample_.shape_values.resize(points.size());
      sample_.weights.resize(points.size());
    }
    force_.vector_value_list(points, sample_.values);
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      sample_.offsets[i] = points[i] - cell->vertex(0);
      sample_.weights[i] = values.JxW(i);
      // Corners counter-clockwise; the shape functions of a vertex follow each other.
      constexpr std::array<unsigned int, 4> vertex_in_circle = {{0, 1, 3, 2}};
      for (unsigned int a = 0; a < 4; ++a)
        sample_.shape_values[i][a] = values.shape_value(2 * vertex_in_circle[a], i);
    }
    return sample_;
  }

private:
  const Function<2> &force_;
  CellValues<2> values_;
  ForceAtPoints sample_;
};

/** Returns the load of a cell, with the finer points where they are given and change it. */
template <typename CellIterator>
CellLoad checked_load(const CellShape &shape,
                      const CellIterator &cell,
                      ForceSampler &sampler,
                      ForceSampler *const finer)
{
  const CellLoad load = make_load(shape, sampler.sample(cell));
  if (finer == nullptr)
    return load;
  const CellLoad fine = make_load(shape, finer->sample(cell));
  return agree(load, fine) ? load : fine;
}
} // namespace

Components CellLoad::stress(const CellShape &shape, const Point<2> &reference) const
{
  const double xi = reference[0], eta = reference[1];
  const double s1 = -0.5 * slope[0] * (xi * xi - 1.) - slope[1] * xi * eta;
  const double s2 = -0.5 * slope[3] * (eta * eta - 1.) - slope[2] * xi * eta;
  const Vector2 g1 = g1_of(shape), g2 = g2_of(shape);
  return {{s1 * g1[0] * g1[0] + s2 * g2[0] * g2[0],
           s1 * g1[1] * g1[1] + s2 * g2[1] * g2[1],
           s1 * g1[0] * g1[1] + s2 * g2[0] * g2[1]}};
}

CellMoments CellLoad::moments(const CellShape &shape) const
{
  // The traction times |e| on edge 0 is -2 J slope[2] ξ g_2, on edge 1 -2 J slope[1] η g_1, with
  // the opposite sign of ξ and η along the opposite edges.
  const Vector2 g1 = g1_of(shape), g2 = g2_of(shape);
  const double J = cross(g1, g2);
  const Vector2 first = J * slope[2] / 3. * g2, second = J * slope[1] / 3. * g1;
  CellMoments result;
  for (unsigned int k = 0; k < 4; ++k)
    for (unsigned int c = 0; c < 2; ++c)
    {
      const double sign = k < 2 ? 1. : -1.;
      const double at_first_end = sign * (k % 2 == 0 ? first[c] : second[c]);
      result[4 * k + c] = at_first_end;
      result[4 * k + 2 + c] = -at_first_end;
    }
  return result;
}

CellLoad make_load(const CellShape &shape, const ForceAtPoints &force)
{
  CellLoad load;
  for (std::size_t i = 0; i < force.weights.size(); ++i)
    for (unsigned int a = 0; a < 4; ++a)
      for (unsigned int c = 0; c < 2; ++c)
        load.nodal[a][c] += force.values[i][c] * force.shape_values[i][a] * force.weights[i];
  const LinearForce linear(shape, load.nodal);
  double square = 0.;
  const Vector2 to_centre = shape.centre() - shape.corners[0];
  for (std::size_t i = 0; i < force.weights.size(); ++i)
  {
    const Vector2 f_h = linear.mean + linear.gradient * (force.offsets[i] - to_centre);
    const Vector2 f({force.values[i][0], force.values[i][1]});
    square += (f - f_h).norm_square() * force.weights[i];
  }
  load.rest = std::sqrt(square);
  if (shape.affine)
  {
    for (unsigned int k = 0; k < 4; ++k)
      for (unsigned int c = 0; c < 2; ++c)
        load.constant[2 * k + c] = linear.mean[c];
    const Vector2 g1 = g1_of(shape), g2 = g2_of(shape);
    const Vector2 along_xi = in_basis(linear.gradient * g1, g1, g2);
    const Vector2 along_eta = in_basis(linear.gradient * g2, g1, g2);
    load.slope = {{along_xi[0], along_eta[0], along_xi[1], along_eta[1]}};
  }
  else
    load.rest += std::sqrt(distribute(shape, linear, load));
  return load;
}

double add_couple(const CellShape &shape, const double moment, CellLoad &load)
{
  std::array<Vector2, 4> arms;
  double inertia = 0.;
  for (unsigned int k = 0; k < 4; ++k)
  {
    arms[k] = shape.centre(k) - shape.centre();
    inertia += shape.areas[k] * arms[k].norm_square();
  }
  for (unsigned int k = 0; k < 4; ++k)
    for (unsigned int c = 0; c < 2; ++c)
      load.constant[2 * k + c] += moment / inertia * rotated(arms[k])[c];
  return std::abs(moment) / std::sqrt(inertia);
}

std::vector<Triangulation<2>::active_cell_iterator>
cells_in_order(const DisplacementSpace<2> &space)
{
  std::vector<Triangulation<2>::active_cell_iterator> cells;
  cells.reserve(space.mesh().triangulation().n_active_cells());
  for (const auto &cell : space.mesh().triangulation().active_cell_iterators())
    cells.push_back(cell);
  return cells;
}

std::vector<CellLoad> make_loads(const DisplacementSpace<2> &space,
                                 const Scene<2> &scene,
                                 const EdgeMesh &mesh,
                                 const unsigned int n_points)
{
  if (scene.body_force == nullptr)
    return {};
  const auto cells = cells_in_order(space);
  std::vector<CellLoad> loads(cells.size());
  // About 500000 points on the mesh, as long as these are more than the system has.
  const unsigned int n_fine = std::clamp<unsigned int>(std::sqrt(5e5 / cells.size()), 1, 96);
  // The rules of cells that are cut have that many points on each of up to hundreds of parts.
  constexpr unsigned int max_points_on_parts = 8;
  const bool check = n_fine > n_points && !is_constant(*scene.body_force);
  work_on_ranges(n_available_threads(space.mesh().communicator()),
                 cells.size(),
                 [&](const std::size_t begin, const std::size_t end) {
                   ForceSampler sampler(space, scene, n_points);
                   std::unique_ptr<ForceSampler> finer, finer_on_parts;
                   if (check)
                   {
                     finer = std::make_unique<ForceSampler>(space, scene, n_fine);
                     finer_on_parts = std::make_unique<ForceSampler>(
                       space, scene, std::min(n_fine, max_points_on_parts));
                   }
                   for (std::size_t i = begin; i < end; ++i)
                   {
                     const bool is_cut = needs_cuts<2>(scene.kinks, cells[i]);
                     loads[i] = checked_load(CellShape(mesh.cells()[i].corners),
                                             cells[i],
                                             sampler,
                                             (is_cut ? finer_on_parts : finer).get());
                   }
                 });
  return loads;
}
} // namespace Signorini
