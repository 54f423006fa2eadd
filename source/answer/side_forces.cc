// SPDX-License-Identifier: LGPL-2.1-or-later
// Which force acts through which side.

#include <signorini/answer/side_forces.h>
#include <signorini/elasticity/node_positions.h>

#include <cmath>
#include <map>

namespace Signorini
{
namespace
{
using Vector2 = dealii::Tensor<1, 2>;

/** A side that holds a node. */
struct Holder
{
  unsigned int side;
  /** Whether it is a roller, which acts along its normal only. */
  bool roller;
  /** The sum of the unit normals of its faces at the node. */
  Vector2 normal;
};

/** A node that is held, by one or two sides. */
struct HeldNode
{
  dealii::Point<2> point;
  Vector2 reaction;
  std::vector<Holder> holders;
};

bool holds(const Role role)
{
  return role == Role::clamped || role == Role::roller || role == Role::displacement;
}

/** The outward unit normal of a boundary face between its vertices. */
Vector2 face_normal(const dealii::Triangulation<2>::active_cell_iterator &cell,
                    const unsigned int f)
{
  const Vector2 edge = cell->face(f)->vertex(1) - cell->face(f)->vertex(0);
  Vector2 normal({edge[1], -edge[0]});
  if (normal * (cell->face(f)->center() - cell->center()) < 0.)
    normal *= -1.;
  return normal / normal.norm();
}

void add_holder(const unsigned int side, const Role role, const Vector2 &normal, HeldNode &node)
{
  for (Holder &holder : node.holders)
    if (holder.side == side)
    {
      holder.normal += normal;
      return;
    }
  node.holders.push_back({side, role == Role::roller, normal});
}

/** By the first degree of freedom. */
std::map<dealii::types::global_dof_index, HeldNode> held_nodes(const DisplacementSpace<2> &space,
                                                               const Scene<2> &scene,
                                                               const NodalForces &forces)
{
  std::map<dealii::types::global_dof_index, HeldNode> nodes;
  NodePositions<2> positions(space);
  std::vector<dealii::types::global_dof_index> indices;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->at_boundary())
      for (const unsigned int f : cell->face_indices())
      {
        const auto face = cell->face(f);
        if (!face->at_boundary() || !holds(scene.boundary[face->boundary_id()].role))
          continue;
        const dealii::FiniteElement<2> &element = cell->get_fe();
        indices.resize(element.n_dofs_per_cell());
        cell->get_dof_indices(indices);
        const std::vector<dealii::Point<2>> &points = positions(cell);
        for (unsigned int k = 0; k < points.size(); ++k)
        {
          const unsigned int first = element.component_to_system_index(0, k);
          if (!element.has_support_on_face(first, f))
            continue;
          HeldNode &node = nodes[indices[first]];
          node.point = points[k];
          for (unsigned int c = 0; c < 2; ++c)
            node.reaction[c] = forces.residual[indices[element.component_to_system_index(c, k)]];
          add_holder(face->boundary_id(),
                     scene.boundary[face->boundary_id()].role,
                     face_normal(cell, f),
                     node);
        }
      }
  return nodes;
}

/** What the first of two holders takes of the reaction. */
Vector2 share_of_first(const Vector2 &reaction, const Holder &first, const Holder &second)
{
  const Vector2 n = first.normal / first.normal.norm(), m = second.normal / second.normal.norm();
  const double sine = n[0] * m[1] - n[1] * m[0];
  const bool parallel = std::abs(sine) < 1e-6;
  if (first.roller && second.roller && !parallel)
    return (reaction[0] * m[1] - reaction[1] * m[0]) / sine * n;
  if (first.roller == second.roller)
    return 0.5 * reaction;
  return first.roller ? (reaction * n) * n : reaction - (reaction * m) * m;
}
} // namespace

std::vector<SideForce> contact_forces(const MultiplierSpace<2> &multipliers,
                                      const Scene<2> &scene,
                                      const dealii::Vector<double> &P)
{
  std::vector<SideForce> forces;
  const ContactSurface<2> &surface = multipliers.surface();
  for (const unsigned int side : scene.contact_sides())
  {
    SideForce force = {scene.geometry.sides[side].name(), {}, {}};
    double total = 0.;
    Vector2 centre;
    for (const Piece<2> &piece : surface.pieces())
      if (surface.patches()[piece.patch].side == side)
      {
        force.resultant += contact_resultant(multipliers, P, piece);
        const SurfaceRule<2> &rule = piece.on_mesh;
        for (std::size_t q = 0; q < rule.size(); ++q)
        {
          const double share = multipliers.value(P, piece.patch, rule.on_side[q]) * rule.weights[q];
          total += share;
          centre += share * rule.points[q];
        }
      }
    if (total != 0.)
      force.through =
        point_of_action(force.resultant, dealii::Point<2>(centre / total), std::abs(total));
    forces.push_back(force);
  }
  return forces;
}

std::vector<SideForce> reactions(const DisplacementSpace<2> &space,
                                 const Scene<2> &scene,
                                 const NodalForces &forces)
{
  std::map<unsigned int, Resultant<2>> by_side;
  for (const auto &[vertex, node] : held_nodes(space, scene, forces))
  {
    const Holder &first = node.holders.front();
    if (node.holders.size() == 1)
    {
      by_side[first.side].add(node.reaction, node.point);
      continue;
    }
    const Vector2 share = share_of_first(node.reaction, first, node.holders[1]);
    by_side[first.side].add(share, node.point);
    by_side[node.holders[1].side].add(node.reaction - share, node.point);
  }
  const double scale = forces.largest();
  std::vector<SideForce> result;
  for (const auto &[number, resultant] : by_side)
  {
    const Side<2> &side = scene.geometry.sides[number];
    result.push_back(
      {side.name(), resultant, point_of_action(resultant, side.point(0.5 * side.length()), scale)});
  }
  return result;
}

std::optional<dealii::Point<2>> point_of_action(const Resultant<2> &resultant,
                                                const dealii::Point<2> &centre,
                                                const double scale)
{
  constexpr double negligible = 1e-10;
  const Vector2 &F = resultant.force;
  if (!(F.norm() > negligible * scale))
    return {};
  // x = centre + t (F2, -F1) has the moment centre × F + t |F|².
  const double t = resultant.moment_about(centre)[0] / F.norm_square();
  return centre + t * Vector2({F[1], -F[0]});
}
} // namespace Signorini
