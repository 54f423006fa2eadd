// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners and edges where stresses grow without limit.

#include <signorini/base/errors.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/postprocessing/fields/forces.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>
#include <signorini/postprocessing/fields/stress.h>
#include <signorini/postprocessing/quantities/von_mises.h>
#include <signorini/problem/scene/corners.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

namespace Signorini
{
namespace
{
using numbers::PI;

/** The largest singular exponent: closer to one, refinement changes stresses by less than rounding.
 */
constexpr double max_singular_exponent = 1. - 1e-3;

/** The share of the sides and of the distances between corners. */
constexpr double share_of_sides = 0.1;

/** Returns the smallest exponent over the states that contact may have. */
double min_exponent(const double angle, const std::array<Role, 2> &roles, const double kappa)
{
  double smallest = max_corner_exponent;
  for (const EdgeSupport first : possible_supports(roles[0]))
    for (const EdgeSupport second : possible_supports(roles[1]))
      smallest = std::min(smallest, corner_exponent(angle, first, second, kappa));
  return smallest;
}

/** Returns whether no state can be singular, which saves time with hundreds of corners: (W1) at
 * convex corners, and where contact goes on straight. There it ends at one of its ends at most,
 * where (1) excludes the root 1/2. */
bool cannot_be_singular(const double angle, const std::array<Role, 2> &roles)
{
  const auto is_free = [](const Role role) { return role == Role::free || role == Role::traction; };
  if (is_free(roles[0]) && is_free(roles[1]))
    return angle <= PI + 1e-6;
  return roles[0] == Role::contact && roles[1] == Role::contact && std::abs(angle - PI) < 1e-6;
}

template <int dim>
std::array<Role, 2> roles_at(const Scene<dim> &scene, const std::array<unsigned int, 2> &sides)
{
  return {{scene.boundary[sides[0]].role, scene.boundary[sides[1]].role}};
}

/** Returns whether the patch of a side that is nearest to a point presses. */
template <int dim>
bool presses_at(const Point<dim> &x,
                const unsigned int side,
                const MultiplierSpace<dim> &multipliers,
                const Pressure &P)
{
  const std::vector<Patch<dim>> &patches = multipliers.surface().patches();
  double smallest = std::numeric_limits<double>::max();
  unsigned int nearest = 0;
  for (unsigned int k = 0; k < P.size(); ++k)
  {
    const Patch<dim> &patch = patches[multipliers.patch_of(k)];
    const double distance =
      patch.side == side ? multipliers.surface().side(patch).point(multipliers.node(k)).distance(x)
                         : smallest;
    if (distance < smallest)
    {
      smallest = distance;
      nearest = k;
    }
  }
  return P.size() > 0 && P[nearest] < pressing_threshold(P);
}

/** Returns the block of Hooke's tensor in the plane of two axes. */
SymmetricTensor<4, 2> in_plane(const SymmetricTensor<4, 3> &hooke,
                               const std::array<unsigned int, 2> &axes)
{
  SymmetricTensor<4, 2> plane;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = i; j < 2; ++j)
      for (unsigned int k = 0; k < 2; ++k)
        for (unsigned int l = k; l < 2; ++l)
          plane[i][j][k][l] = hooke[axes[i]][axes[j]][axes[k]][axes[l]];
  return plane;
}

/** Returns the axis of a box along the normal of a side. */
unsigned int axis_of(const Side<3> &side)
{
  const Tensor<1, 3> n = side.normal(Point<2>());
  unsigned int axis = 0;
  for (unsigned int d = 1; d < 3; ++d)
    if (std::abs(n[d]) > std::abs(n[axis]))
      axis = d;
  return axis;
}
} // namespace

template <int dim>
Point<dim> SingularPlace<dim>::nearest(const Point<dim> &x) const
{
  const Tensor<1, dim> edge = ends[1] - ends[0];
  const double square = edge.norm_square();
  return ends[0] + (square > 0. ? std::clamp((x - ends[0]) * edge / square, 0., 1.) : 0.) * edge;
}

std::vector<SingularPlace<2>> singular_places(const Scene<2> &scene)
{
  std::vector<SingularPlace<2>> places;
  if (scene.exact_displacement != nullptr)
    return places;
  const std::vector<Corner> all = corners(scene.geometry);
  for (const Corner &corner : all)
  {
    const std::array<Role, 2> roles = roles_at(scene, corner.sides);
    if (cannot_be_singular(corner.angle, roles))
      continue;
    const double kappa = kolosov_constant(scene.material->relative_hooke(corner.position));
    if (min_exponent(corner.angle, roles, kappa) >= max_singular_exponent)
      continue;
    double shortest = std::min(scene.geometry.sides[corner.sides[0]].length(),
                               scene.geometry.sides[corner.sides[1]].length());
    for (const Corner &other : all)
      if (&other != &corner && other.position.distance(corner.position) > 0.)
        shortest = std::min(shortest, other.position.distance(corner.position));
    places.push_back({{{corner.position, corner.position}},
                      corner.sides,
                      corner.angle,
                      kappa,
                      share_of_sides * shortest});
  }
  return places;
}

std::vector<SingularPlace<3>> singular_places(const Scene<3> &scene)
{
  std::vector<SingularPlace<3>> places;
  if (scene.exact_displacement != nullptr)
    return places;
  const Geometry<3> &box = scene.geometry;
  for (unsigned int i = 0; i < box.sides.size(); ++i)
    for (unsigned int j = i + 1; j < box.sides.size(); ++j)
    {
      const std::array<unsigned int, 2> axes = {{axis_of(box.sides[i]), axis_of(box.sides[j])}};
      const std::array<Role, 2> roles = roles_at(scene, {{i, j}});
      if (axes[0] == axes[1] || cannot_be_singular(0.5 * PI, roles))
        continue;
      Point<3> middle = box.lower + 0.5 * (box.upper - box.lower);
      middle[axes[0]] = box.sides[i].centre()[axes[0]];
      middle[axes[1]] = box.sides[j].centre()[axes[1]];
      const double kappa = kolosov_constant(in_plane(scene.material->relative_hooke(middle), axes));
      if (min_exponent(0.5 * PI, roles, kappa) >= max_singular_exponent)
        continue;
      const unsigned int along = 3 - axes[0] - axes[1];
      std::array<Point<3>, 2> ends = {{middle, middle}};
      ends[0][along] = box.lower[along];
      ends[1][along] = box.upper[along];
      places.push_back({ends, {{i, j}}, 0.5 * PI, kappa, share_of_sides * box.shortest_extent()});
    }
  return places;
}

template <int dim>
bool any_contains(const std::vector<SingularPlace<dim>> &places, const Point<dim> &x)
{
  return std::any_of(
    places.begin(), places.end(), [&x](const auto &place) { return place.contains(x); });
}

template <int dim>
std::optional<GrowthPlace> growth_at(const Point<dim> &x,
                                     const std::vector<SingularPlace<dim>> &places,
                                     const MultiplierSpace<dim> &multipliers,
                                     const Pressure &P)
{
  const Scene<dim> &scene = multipliers.surface().scene();
  for (const SingularPlace<dim> &place : places)
  {
    if (!place.contains(x))
      continue;
    std::array<EdgeSupport, 2> supports;
    for (unsigned int i = 0; i < 2; ++i)
    {
      const Role role = scene.boundary[place.sides[i]].role;
      const bool closed =
        role == Role::contact && presses_at(place.nearest(x), place.sides[i], multipliers, P);
      supports[i] = closed ? EdgeSupport::sliding : possible_supports(role).front();
    }
    if (corner_exponent(place.angle, supports[0], supports[1], place.kappa) < max_singular_exponent)
      return GrowthPlace{{{place.ends[0], place.ends[1]}}, place.radius};
  }
  return {};
}

template struct SingularPlace<2>;
template struct SingularPlace<3>;
template bool any_contains(const std::vector<SingularPlace<2>> &, const Point<2> &);
template bool any_contains(const std::vector<SingularPlace<3>> &, const Point<3> &);
template std::optional<GrowthPlace> growth_at(const Point<2> &,
                                              const std::vector<SingularPlace<2>> &,
                                              const MultiplierSpace<2> &,
                                              const Pressure &);
template std::optional<GrowthPlace> growth_at(const Point<3> &,
                                              const std::vector<SingularPlace<3>> &,
                                              const MultiplierSpace<3> &,
                                              const Pressure &);

// The largest von Mises stress of the recovered displacement.

namespace
{
/** The value and the position of the largest stress, zero at the origin if there is none. */
template <int dim>
struct StressAt
{
  double value = 0.;
  Point<dim> point;
  MeshAt mesh;
};

/** The results of a set of cells. */
template <int dim>
struct CellResults
{
  /** The largest stress of all points, and of those away from singular places. */
  StressAt<dim> all, away;
  /** The measure of the cells, and that of those with large strains. */
  double measure = 0., strained = 0.;

  /**
   * Adds the measure of a cell.
   * @param strain in the middle of the cell.
   */
  void add_cell(const double cell_data, const SymmetricTensor<2, dim> &strain)
  {
    const auto principal = eigenvalues(strain);
    measure += cell_data;
    if (std::max(principal[0], -principal[dim - 1]) > large_strain)
      strained += cell_data;
  }
};

/** The data of the stress field. */
template <int dim>
struct StressField
{
  const DisplacementSpace<dim> &space;
  const Material<dim> &material;
  const Displacement &U;
  /** The mean dilatations by cell; empty where the strain is that of u_h. */
  const std::vector<double> dilatation;
  const std::vector<SingularPlace<dim>> &places;
};

/** Returns the middle of the reference cell and its corners. */
template <int dim>
Quadrature<dim> middle_and_corners()
{
  std::vector<Point<dim>> points(1);
  for (unsigned int d = 0; d < dim; ++d)
    points[0][d] = 0.5;
  for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
    points.push_back(GeometryInfo<dim>::unit_cell_vertex(v));
  return Quadrature<dim>(points);
}

/** Takes the larger one; of equals (a symmetric body has some) the one further left, then further
 * down, so that neither ranks nor rounding choose. */
template <int dim>
void take_larger(const StressAt<dim> &candidate, StressAt<dim> &largest)
{
  constexpr double rounding = 1e-9;
  const double excess = candidate.value - largest.value;
  const bool equal = std::abs(excess) <= rounding * largest.value;
  const Tensor<1, dim> step = candidate.point - largest.point;
  bool comes_first = false;
  for (unsigned int d = dim; d-- > 0;)
    comes_first = step[d] < 0. || (step[d] == 0. && comes_first);
  if (equal ? comes_first : excess > 0.)
    largest = candidate;
}

/** Adds the results of another part of the body. */
template <int dim>
void add(const CellResults<dim> &part, CellResults<dim> &results)
{
  take_larger(part.all, results.all);
  take_larger(part.away, results.away);
  results.measure += part.measure;
  results.strained += part.strained;
}

/** Compares the stress at a point with the largest one; skips points where the material's data has
 * no value. */
template <int dim>
void compare(const StressField<dim> &field,
             const Point<dim> &x,
             const SymmetricTensor<2, dim> &strain,
             const MeshAt &mesh,
             CellResults<dim> &results)
{
  try
  {
    const StressAt<dim> here = {von_mises(stress_in_3d(field.material, x, strain)), x, mesh};
    take_larger(here, results.all);
    if (!any_contains(field.places, x))
      take_larger(here, results.away);
  }
  catch (const InputError &)
  {
  }
}

/** Returns the middle of the reference cell and the nodes of an element. */
template <int dim>
Quadrature<dim> middle_and_nodes(const FiniteElement<dim> &element)
{
  std::vector<Point<dim>> points = element.base_element(0).get_unit_support_points();
  points.insert(points.begin(), middle_and_corners<dim>().point(0));
  return Quadrature<dim>(points);
}

/** Returns the results of a chunk of cells of several degrees, with the largest stress at the nodes
 * of each. */
template <int dim>
CellResults<dim> results_at_nodes(const Cells<dim> &cells, const StressField<dim> &field)
{
  const FEValuesExtractors::Vector displacement(0);
  CellResults<dim> results;
  std::map<unsigned int, std::unique_ptr<FEValues<dim>>> values_by_degree;
  std::vector<SymmetricTensor<2, dim>> strains;
  for (const auto &cell : cells)
  {
    const FiniteElement<dim> &element = cell->get_fe();
    std::unique_ptr<FEValues<dim>> &values = values_by_degree[element.degree];
    if (values == nullptr)
      values = std::make_unique<FEValues<dim>>(field.space.mesh().mapping(),
                                               element,
                                               middle_and_nodes(element),
                                               update_gradients | update_quadrature_points);
    values->reinit(cell);
    strains.resize(values->n_quadrature_points);
    (*values)[displacement].get_function_symmetric_gradients(field.U.entries(), strains);
    const MeshAt mesh = {cell->diameter(), element.degree};
    results.add_cell(cell->measure(), strains[0]);
    for (unsigned int q = 1; q < strains.size(); ++q)
      compare(field, values->quadrature_point(q), strains[q], mesh, results);
  }
  return results;
}

/** Returns the results of a chunk of cells. */
template <int dim>
CellResults<dim> results_of(const Cells<dim> &cells, const StressField<dim> &field)
{
  const DisplacementSpace<dim> &space = field.space;
  if (space.has_several_elements())
    return results_at_nodes(cells, field);
  FEValues<dim> values(space.mesh().mapping(),
                       space.element(),
                       middle_and_corners<dim>(),
                       update_gradients | update_inverse_jacobians | update_quadrature_points);
  PatchInterpolation<dim> interpolation(
    space, values.get_quadrature(), space.mesh().has_parents() ? 1 : 0);
  CellResults<dim> results;
  for (const auto &cell : cells)
  {
    values.reinit(cell);
    const FieldValues<dim> &u = interpolation.evaluate(field.U, cell, values);
    for (const unsigned int q : values.quadrature_point_indices())
    {
      SymmetricTensor<2, dim> strain = symmetrize(u.gradients[q]);
      if (!field.dilatation.empty())
        replace_trace(strain, field.dilatation[cell->active_cell_index()]);
      compare(field, values.quadrature_point(q), strain, {}, results);
      if (q == 0)
        results.add_cell(cell->measure(), strain);
    }
  }
  return results;
}

/** Returns the results of all cells of this rank. */
template <int dim>
CellResults<dim> results_of_cells(const StressField<dim> &field)
{
  CellResults<dim> results;
  integrate_by_chunks<CellResults<dim>, dim>(
    field.space,
    [&](const Cells<dim> &cells) { return results_of(cells, field); },
    [&results](const CellResults<dim> &chunk_result) { add(chunk_result, results); });
  return results;
}

/** Returns the largest stress of all ranks. */
template <int dim>
StressMaximum max_over_ranks(const StressAt<dim> &mine, MPI_Comm communicator)
{
  std::array<double, 1 + dim> numbers = {{mine.value}};
  for (unsigned int d = 0; d < dim; ++d)
    numbers[1 + d] = mine.point[d];
  StressAt<dim> largest;
  for (const auto &rank_numbers : Utilities::MPI::all_gather(communicator, numbers))
  {
    StressAt<dim> other;
    other.value = rank_numbers[0];
    for (unsigned int d = 0; d < dim; ++d)
      other.point[d] = rank_numbers[1 + d];
    // Graded meshes are serial.
    other.mesh = mine.mesh;
    take_larger(other, largest);
  }
  return {largest.value, largest.point, largest.mesh};
}
} // namespace

template <int dim>
VonMises largest_von_mises(const DisplacementSpace<dim> &space,
                           const Scene<dim> &scene,
                           const Displacement &U,
                           const std::vector<SingularPlace<dim>> &places)
{
  const StressField<dim> field = {space,
                                  *scene.material,
                                  U,
                                  space.strain_operator() == StrainOperator::mean_dilatation
                                    ? mean_dilatations(space, U)
                                    : std::vector<double>(),
                                  places};
  const CellResults<dim> mine = results_of_cells(field);
  MPI_Comm communicator = space.mesh().communicator();
  VonMises stress = {max_over_ranks(mine.all, communicator), {}, {}};
  if (!places.empty())
    stress.away = max_over_ranks(mine.away, communicator);
  stress.strained_share = Utilities::MPI::sum(mine.strained, communicator) /
                          Utilities::MPI::sum(mine.measure, communicator);
  return stress;
}

template VonMises largest_von_mises(const DisplacementSpace<2> &,
                                    const Scene<2> &,
                                    const Displacement &,
                                    const std::vector<SingularPlace<2>> &);
template VonMises largest_von_mises(const DisplacementSpace<3> &,
                                    const Scene<3> &,
                                    const Displacement &,
                                    const std::vector<SingularPlace<3>> &);
} // namespace Signorini
