// SPDX-License-Identifier: LGPL-2.1-or-later
// The force of the contact pressure, and lines of action.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/postprocessing/quantities/side_forces.h>

#include <cmath>
#include <map>

namespace Signorini
{
namespace
{
/** Returns the shift of the line of action of F by a moment: F × M / |F|². */
Tensor<1, 2> shift(const Tensor<1, 2> &F, const Moment<2> &moment)
{
  return moment[0] / F.norm_square() * Tensor<1, 2>({F[1], -F[0]});
}
Tensor<1, 3> shift(const Tensor<1, 3> &F, const Moment<3> &moment)
{
  return cross_product_3d(F, moment) / F.norm_square();
}
} // namespace

template <int dim>
std::vector<SideForce> contact_forces(const MultiplierSpace<dim> &multipliers,
                                      const Scene<dim> &scene,
                                      const Pressure &P)
{
  std::vector<SideForce> forces;
  const ContactSurface<dim> &surface = multipliers.surface();
  for (const unsigned int side : scene.contact_sides())
  {
    Resultant<dim> resultant;
    std::optional<AnswerVector> through;
    double total = 0.;
    Tensor<1, dim> centre;
    for (const Piece<dim> &piece : surface.pieces())
      if (surface.patches()[piece.patch].side == side)
      {
        resultant += contact_resultant(multipliers, P, piece);
        const SurfaceRule<dim> &rule = piece.on_mesh;
        for (std::size_t q = 0; q < rule.size(); ++q)
        {
          const double share = multipliers.value(P, piece.patch, rule.on_side[q]) * rule.weights[q];
          total += share;
          centre += share * rule.points[q];
        }
      }
    if (total != 0.)
      through = point_of_action(resultant, Point<dim>(centre / total), std::abs(total));
    forces.push_back(
      {scene.geometry.sides[side].name(), {resultant.force, resultant.moment}, through});
  }
  return forces;
}

template <int dim>
std::optional<Point<dim>> point_of_action(const Resultant<dim> &resultant,
                                          const Point<dim> &centre,
                                          const double scale)
{
  constexpr double negligible = 1e-10;
  const Tensor<1, dim> &F = resultant.force;
  if (!(F.norm() > negligible * scale))
    return {};
  // x = centre + t (F2, -F1) has the moment centre × F + t |F|²; in 3-D F × M / |F|².
  return centre + shift(F, resultant.moment_about(centre));
}

template std::vector<SideForce> contact_forces(const MultiplierSpace<2> &,
                                               const Scene<2> &,
                                               const Pressure &);
template std::optional<Point<2>> point_of_action(const Resultant<2> &, const Point<2> &, double);
template std::vector<SideForce> contact_forces(const MultiplierSpace<3> &,
                                               const Scene<3> &,
                                               const Pressure &);
template std::optional<Point<3>> point_of_action(const Resultant<3> &, const Point<3> &, double);

// The division of reactions among the sides that hold the body.

namespace
{
/** A side that holds a node. */
template <int dim>
struct Holder
{
  unsigned int side;
  /** Whether it is a roller, which acts along its normal only. */
  bool roller;
  /** The sum of the unit normals of its faces at the node. */
  Tensor<1, dim> normal;
};

/** A node that is held, by one or more sides. */
template <int dim>
struct HeldNode
{
  Point<dim> point;
  Tensor<1, dim> reaction;
  std::vector<Holder<dim>> holders;
};

bool holds(const Role role)
{
  return role == Role::clamped || role == Role::roller || role == Role::displacement;
}

/** Returns a vector at right angles to a face, by its vertices. */
template <int dim, typename Face>
Tensor<1, dim> across_face(const Face &face)
{
  if constexpr (dim == 2)
  {
    const Tensor<1, 2> edge = face->vertex(1) - face->vertex(0);
    return Tensor<1, 2>({edge[1], -edge[0]});
  }
  else
    return cross_product_3d(face->vertex(3) - face->vertex(0), face->vertex(2) - face->vertex(1));
}

/** Returns the outward unit normal of a boundary face between its vertices. */
template <int dim>
Tensor<1, dim> face_normal(const typename Triangulation<dim>::active_cell_iterator &cell,
                           const unsigned int f)
{
  Tensor<1, dim> normal = across_face<dim>(cell->face(f));
  if (normal * (cell->face(f)->center() - cell->center()) < 0.)
    normal *= -1.;
  return normal / normal.norm();
}

template <int dim>
void add_holder(const unsigned int side,
                const Role role,
                const Tensor<1, dim> &normal,
                HeldNode<dim> &node)
{
  for (Holder<dim> &holder : node.holders)
    if (holder.side == side)
    {
      holder.normal += normal;
      return;
    }
  node.holders.push_back({side, role == Role::roller, normal});
}

/** Returns the held nodes of this rank by their first degree of freedom. */
template <int dim>
std::map<types::global_dof_index, HeldNode<dim>> held_nodes(const DisplacementSpace<dim> &space,
                                                            const Scene<dim> &scene,
                                                            const NodalForces &forces)
{
  std::map<types::global_dof_index, HeldNode<dim>> nodes;
  NodePositions<dim> positions(space);
  std::vector<types::global_dof_index> indices;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (!cell->is_artificial() && cell->at_boundary())
      for (const unsigned int f : cell->face_indices())
      {
        const auto face = cell->face(f);
        if (!face->at_boundary() || !holds(scene.boundary[face->boundary_id()].role))
          continue;
        const FiniteElement<dim> &element = cell->get_fe();
        indices.resize(element.n_dofs_per_cell());
        cell->get_dof_indices(indices);
        const std::vector<Point<dim>> &points = positions(cell);
        for (unsigned int k = 0; k < points.size(); ++k)
        {
          const unsigned int first = element.component_to_system_index(0, k);
          if (!element.has_support_on_face(first, f) ||
              !forces.residual.in_local_range(indices[first]))
            continue;
          HeldNode<dim> &node = nodes[indices[first]];
          node.point = points[k];
          for (unsigned int c = 0; c < dim; ++c)
            node.reaction[c] = forces.residual(indices[element.component_to_system_index(c, k)]);
          add_holder(face->boundary_id(),
                     scene.boundary[face->boundary_id()].role,
                     face_normal<dim>(cell, f),
                     node);
        }
      }
  return nodes;
}

/** Returns the shares of two holders in the reaction, in 2-D. */
std::vector<Tensor<1, 2>> shares(const Tensor<1, 2> &reaction,
                                 const std::vector<Holder<2>> &holders)
{
  const Holder<2> &first = holders[0], &second = holders[1];
  const Tensor<1, 2> n = first.normal / first.normal.norm(),
                     m = second.normal / second.normal.norm();
  const double sine = n[0] * m[1] - n[1] * m[0];
  const bool parallel = std::abs(sine) < 1e-6;
  Tensor<1, 2> share;
  if (first.roller && second.roller && !parallel)
    share = (reaction[0] * m[1] - reaction[1] * m[0]) / sine * n;
  else if (first.roller == second.roller)
    share = 0.5 * reaction;
  else
    share = first.roller ? (reaction * n) * n : reaction - (reaction * m) * m;
  return {share, reaction - share};
}

/** Returns the shares of the holders in the reaction, in 3-D: rollers, whose normals are at right
 * angles on a box, take the components along them; the others share the rest. */
std::vector<Tensor<1, 3>> shares(const Tensor<1, 3> &reaction,
                                 const std::vector<Holder<3>> &holders)
{
  std::vector<Tensor<1, 3>> parts(holders.size());
  Tensor<1, 3> rest = reaction;
  double n_others = 0.;
  for (std::size_t i = 0; i < holders.size(); ++i)
    if (holders[i].roller)
    {
      const Tensor<1, 3> n = holders[i].normal / holders[i].normal.norm();
      parts[i] = (rest * n) * n;
      rest -= parts[i];
    }
    else
      n_others += 1.;
  // Between rollers alone only rounding is left.
  for (std::size_t i = 0; i < holders.size(); ++i)
    if (n_others == 0. || !holders[i].roller)
      parts[i] += rest / (n_others == 0. ? static_cast<double>(holders.size()) : n_others);
  return parts;
}

Point<2> middle_of(const Side<2> &side)
{
  return side.point(0.5 * side.length());
}
Point<3> middle_of(const Side<3> &side)
{
  return side.centre();
}
} // namespace

template <int dim>
std::vector<SideForce> reactions(const DisplacementSpace<dim> &space,
                                 const Scene<dim> &scene,
                                 const NodalForces &forces)
{
  std::map<unsigned int, Resultant<dim>> by_side;
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    if (holds(scene.boundary[i].role))
      by_side[i] = {};
  for (const auto &[vertex, node] : held_nodes(space, scene, forces))
  {
    if (node.holders.size() == 1)
    {
      by_side[node.holders[0].side].add(node.reaction, node.point);
      continue;
    }
    const std::vector<Tensor<1, dim>> parts = shares(node.reaction, node.holders);
    for (std::size_t i = 0; i < parts.size(); ++i)
      by_side[node.holders[i].side].add(parts[i], node.point);
  }
  const double scale = forces.largest();
  std::vector<SideForce> result;
  for (const auto &[number, part] : by_side)
  {
    const Resultant<dim> resultant = sum_over_ranks(part, space.mesh().communicator());
    const Side<dim> &side = scene.geometry.sides[number];
    result.push_back({side.name(),
                      {resultant.force, resultant.moment},
                      point_of_action(resultant, middle_of(side), scale)});
  }
  return result;
}

template std::vector<SideForce> reactions(const DisplacementSpace<2> &,
                                          const Scene<2> &,
                                          const NodalForces &);
template std::vector<SideForce> reactions(const DisplacementSpace<3> &,
                                          const Scene<3> &,
                                          const NodalForces &);
} // namespace Signorini
