// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners and edges where stresses grow without limit.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/cell_evaluator.h>
#include <signorini/postprocessing/fields/stress.h>
#include <signorini/postprocessing/quantities/von_mises.h>
#include <signorini/problem/scene/corners.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini {
namespace {
using numbers::PI;

/** The relative difference of values that counts as none. */
constexpr double rounding = 1e-9;

/** The largest singular exponent: closer to one, refinement changes stresses by less than rounding.
 */
constexpr double max_singular_exponent = 1. - 1e-3;

/** The share of the sides and of the distances between corners. */
constexpr double share_of_sides = 0.1;

/** Adds an edge if stresses can be singular there: if the exponent is below one in one of the
 * states that contact may have. */
template <int dim>
void add_if_singular(const SingularEdge<dim> &edge, const Scene<dim> &scene,
                     std::vector<SingularEdge<dim>> &edges) {
  const Role first = scene.boundary[edge.sides[0]].role,
             second = scene.boundary[edge.sides[1]].role;
  const auto is_free = [](const Role role) { return role == Role::free || role == Role::traction; };
  const double angle = opening(edge.layers);
  // This saves time with hundreds of corners: (W1) at convex corners, and where contact goes on
  // straight.
  if (edge.layers.size() == 1 &&
      ((is_free(first) && is_free(second) && angle <= PI + 1e-6) ||
       (first == Role::contact && second == Role::contact && std::abs(angle - PI) < 1e-6)))
    return;
  if (smallest_exponent(scene, edge.ends[0], edge.sides, edge.layers) < max_singular_exponent)
    edges.push_back(edge);
}

/** Returns the unknown of a contact side that is nearest to a point; none on other sides. */
template <int dim>
std::optional<unsigned int> nearest_unknown(const Point<dim> &x, const unsigned int side,
                                            const MultiplierSpace<dim> &multipliers) {
  const ContactSurface<dim> &surface = multipliers.surface();
  double smallest = std::numeric_limits<double>::max();
  std::optional<unsigned int> nearest;
  for (unsigned int k = 0; k < multipliers.n_multipliers(); ++k) {
    const Patch<dim> &patch = surface.patches()[multipliers.patch_of(k)];
    if (patch.side != side)
      continue;
    const double distance = surface.side(patch).point(multipliers.node(k)).distance(x);
    if (distance < smallest) {
      smallest = distance;
      nearest = k;
    }
  }
  return nearest;
}

/** Returns the condition on a side next to a point in the present state of contact. */
template <int dim>
EdgeCondition present_condition(const Point<dim> &x, const unsigned int side,
                                const MultiplierSpace<dim> &multipliers,
                                const Multiplier &multiplier) {
  const Scene<dim> &scene = multipliers.surface().scene();
  const std::optional<unsigned int> k = nearest_unknown(x, side, multipliers);
  if (!k || !multiplier.presses(*k))
    return possible_conditions(scene, side, x).front();
  if (!multiplier.has_friction())
    return {EdgeSupport::sliding};
  if (multiplier.state(*k).slip == State::inside)
    return {EdgeSupport::held};
  const bool rubs = multiplier.is_coupled() && dim == 2;
  return {EdgeSupport::sliding,
          rubs ? multiplier.tangential()[0][*k] / multiplier.normal()[*k] : 0.};
}

/** Returns the exponent of an edge that x lies next to, in the present state of contact. */
template <int dim>
double present_exponent(const SingularEdge<dim> &edge, const Point<dim> &x,
                        const MultiplierSpace<dim> &multipliers, const Multiplier &multiplier) {
  const Point<dim> nearest = edge.nearest(x);
  return corner_exponent(edge.layers,
                         present_condition(nearest, edge.sides[0], multipliers, multiplier),
                         present_condition(nearest, edge.sides[1], multipliers, multiplier));
}

/** Returns the block of Hooke's tensor in the plane of two axes. */
SymmetricTensor<4, 2> in_plane(const SymmetricTensor<4, 3> &hooke,
                               const std::array<unsigned int, 2> &axes) {
  SymmetricTensor<4, 2> plane;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = i; j < 2; ++j)
      for (unsigned int k = 0; k < 2; ++k)
        for (unsigned int l = k; l < 2; ++l)
          plane[i][j][k][l] = hooke[axes[i]][axes[j]][axes[k]][axes[l]];
  return plane;
}
} // namespace

unsigned int axis_of(const Side<3> &side) {
  const Tensor<1, 3> n = side.normal(Point<2>());
  unsigned int axis = 0;
  for (unsigned int d = 1; d < 3; ++d)
    if (std::abs(n[d]) > std::abs(n[axis]))
      axis = d;
  return axis;
}

template <int dim>
Point<dim> SingularEdge<dim>::nearest(const Point<dim> &x) const {
  const Tensor<1, dim> edge = ends[1] - ends[0];
  const double square = edge.norm_square();
  return ends[0] + (square > 0. ? std::clamp((x - ends[0]) * edge / square, 0., 1.) : 0.) * edge;
}

std::vector<SingularEdge<2>> singular_edges(const Scene<2> &scene) {
  std::vector<SingularEdge<2>> edges;
  if (scene.exact_displacement != nullptr)
    return edges;
  std::vector<Corner> all = corners(scene.geometry);
  const std::size_t n_corners = all.size();
  for (const Corner &end : interface_ends(scene))
    all.push_back(end);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Corner &corner = all[i];
    double shortest = std::min(scene.geometry.sides[corner.sides[0]].length(),
                               scene.geometry.sides[corner.sides[1]].length());
    const double rounding = 1e-4 * shortest;
    bool is_known = false;
    for (std::size_t j = 0; j < all.size(); ++j) {
      const double distance = all[j].position.distance(corner.position);
      is_known = is_known || (i >= n_corners && j < n_corners && distance < rounding);
      if (j != i && distance > 0.)
        shortest = std::min(shortest, distance);
    }
    if (!is_known)
      add_if_singular<2>({{{corner.position, corner.position}},
                          corner.sides,
                          layers_at(scene, corner),
                          share_of_sides * shortest},
                         scene, edges);
  }
  return edges;
}

std::vector<SingularEdge<3>> singular_edges(const Scene<3> &scene) {
  std::vector<SingularEdge<3>> edges;
  if (scene.exact_displacement != nullptr)
    return edges;
  const Geometry<3> &box = scene.geometry;
  for (unsigned int i = 0; i < box.sides.size(); ++i)
    for (unsigned int j = i + 1; j < box.sides.size(); ++j) {
      const std::array<unsigned int, 2> axes = {{axis_of(box.sides[i]), axis_of(box.sides[j])}};
      if (axes[0] == axes[1])
        continue;
      Point<3> middle = box.lower + 0.5 * (box.upper - box.lower);
      middle[axes[0]] = box.sides[i].centre()[axes[0]];
      middle[axes[1]] = box.sides[j].centre()[axes[1]];
      const unsigned int along = 3 - axes[0] - axes[1];
      std::array<Point<3>, 2> ends = {{middle, middle}};
      ends[0][along] = box.lower[along];
      ends[1][along] = box.upper[along];
      const SymmetricTensor<4, 2> hooke = in_plane(scene.material->relative_hooke(middle), axes);
      add_if_singular<3>(
        {ends, {{i, j}}, {make_layer(hooke, 0.5 * PI)}, share_of_sides * box.shortest_extent()},
        scene, edges);
    }
  return edges;
}

template <int dim>
bool any_contains(const std::vector<SingularEdge<dim>> &edges, const Point<dim> &x) {
  return std::any_of(edges.begin(), edges.end(),
                     [&x](const auto &edge) { return edge.contains(x); });
}

template <int dim>
std::optional<GrowthEdge> growth_at(const Point<dim> &x,
                                    const std::vector<SingularEdge<dim>> &edges,
                                    const BodyInContact<dim> &body) {
  for (const SingularEdge<dim> &edge : edges)
    if (edge.contains(x))
      if (const double exponent = present_exponent(edge, x, body.multipliers, body.P);
          exponent < max_singular_exponent)
        return GrowthEdge{{{edge.ends[0], edge.ends[1]}}, edge.radius, exponent};
  return {};
}

// The largest von Mises stress of the recovered displacement.

void take_larger(const FieldMaximum &other, FieldMaximum &largest) {
  const bool equal = std::abs(other.value - largest.value) <= rounding * std::abs(largest.value);
  if (equal ? other.point < largest.point : other.value > largest.value)
    largest = other;
}

namespace {

/** The results of a set of cells. */
struct CellResults {
  /** The largest stress of all points, and of those away from singular edges. */
  FieldMaximum all, away;
  /** The measure of the cells, and that of those with large strains and with large rotations. */
  double measure = 0., strained = 0., turned = 0.;

  void add(const CellResults &other) {
    take_larger(other.all, all);
    take_larger(other.away, away);
    measure += other.measure;
    strained += other.strained;
    turned += other.turned;
  }
  template <typename Archive>
  void serialize(Archive &archive, const unsigned int /*version*/) {
    archive &all &away &measure &strained &turned;
  }
};

/** Returns no results: zero at the origin. */
template <int dim>
CellResults no_results() {
  return {{0., Point<dim>(), {}}, {0., Point<dim>(), {}}};
}

/** Returns whether a principal strain is large; none is larger than the norm. */
template <int dim>
bool is_large(const SymmetricTensor<2, dim> &strain) {
  if (strain.norm() <= large_strain)
    return false;
  const auto principal = eigenvalues(strain);
  return std::max(principal[0], -principal[dim - 1]) > large_strain;
}

/** Returns the results of a chunk of cells. Points where the material's data has no value are
 * skipped. */
template <int dim>
CellResults results_of(const Cells<dim> &cells, const SampledField<dim> &field,
                       const std::vector<SingularEdge<dim>> &edges) {
  const bool at_nodes = field.space.has_several_elements();
  CellEvaluator<dim> u = field.at_nodes();
  std::vector<FieldSample<dim>> samples;
  StressIn3D<dim> stress(*field.scene.material);
  CellResults results = no_results<dim>();
  for (const auto &cell : cells) {
    u.reinit(cell, field.space.element_number(cell));
    field.sample(u, samples);
    const double measure = cell->measure();
    results.measure += measure;
    if (is_large(samples[0].strain.in_body))
      results.strained += measure;
    if (samples[0].rotation > large_rotation)
      results.turned += measure;
    const MeshAt mesh = mesh_at(field.space, cell);
    for (unsigned int q = at_nodes ? 1 : 0; q < samples.size(); ++q)
      try {
        const Point<dim> &x = samples[q].x;
        const double value = von_mises(stress(x, cell->center(), samples[q].strain));
        // Most stresses are smaller, and nothing is stored for them.
        const auto matters = [&](const FieldMaximum &largest) {
          return value >= (1. - rounding) * largest.value;
        };
        if (matters(results.all))
          take_larger({value, x, mesh}, results.all);
        if (matters(results.away) && !any_contains(edges, x))
          take_larger({value, x, mesh}, results.away);
      } catch (const InputError &) {
      }
  }
  return results;
}

/** Returns the results of all cells. Collective. */
template <int dim>
CellResults results_of_body(const SampledField<dim> &field,
                            const std::vector<SingularEdge<dim>> &edges) {
  CellResults mine = no_results<dim>(), all = mine;
  integrate_by_chunks<CellResults, dim>(
    field.space, [&](const Cells<dim> &cells) { return results_of(cells, field, edges); },
    [&mine](const CellResults &part) { mine.add(part); });
  for (const CellResults &part :
       Utilities::MPI::all_gather(field.space.mesh().communicator(), mine))
    all.add(part);
  return all;
}
} // namespace

template <int dim>
VonMises largest_von_mises(const DisplacedBody<dim> &body,
                           const std::vector<SingularEdge<dim>> &edges) {
  const CellResults results = results_of_body(SampledField<dim>(body), edges);
  VonMises stress = {results.all, {}, {}};
  if (!edges.empty())
    stress.away = results.away;
  stress.strained_share = results.strained / results.measure;
  stress.turned_share = results.turned / results.measure;
  return stress;
}

template struct SingularEdge<2>;
template struct SingularEdge<3>;
INSTANTIATE_FUNCTION(any_contains);
INSTANTIATE_FUNCTION(growth_at);
INSTANTIATE_FUNCTION(largest_von_mises);
} // namespace Signorini
