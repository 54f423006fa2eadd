// SPDX-License-Identifier: LGPL-2.1-or-later
// The forces on sides: those of the contact pressure with their lines of action, and reactions
// divided among the sides that hold the body.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/nodes.h>
#include <signorini/postprocessing/quantities/side_forces.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace Signorini {
namespace {
/** Returns the shift of the line of action of F by a moment: F × M / |F|². */
Tensor<1, 2> shift(const Tensor<1, 2> &F, const Moment<2> &moment) {
  return moment[0] / F.norm_square() * Tensor<1, 2>({F[1], -F[0]});
}
Tensor<1, 3> shift(const Tensor<1, 3> &F, const Moment<3> &moment) {
  return cross_product_3d(F, moment) / F.norm_square();
}
} // namespace

template <int dim>
SideForce side_force(const std::string &name, const Resultant<dim> &resultant,
                     const Point<dim> &centre, const double scale) {
  constexpr double negligible = 1e-10;
  const Tensor<1, dim> &F = resultant.force;
  SideForce force = {name, {F, resultant.moment}, {}};
  // x = centre + t (F2, -F1) has the moment centre × F + t |F|²; in 3-D F × M / |F|².
  if (F.norm() > negligible * scale)
    force.through = centre + shift(F, resultant.moment_about(centre));
  return force;
}

template <int dim>
std::vector<unsigned int> contacts_of_contact_force(const Scene<dim> &scene) {
  std::vector<unsigned int> contacts;
  for (const ContactPair<dim> &pair : contact_pairs(scene))
    if (!pair.other_side())
      contacts.push_back(pair.number());
  if (contacts.empty())
    contacts.push_back(0);
  return contacts;
}

template <int dim>
PairSide body_of_contact_force(const Scene<dim> &scene) {
  const unsigned int first = contacts_of_contact_force(scene).front();
  return scene.contacts[first].is_exchanged ? PairSide::second : PairSide::first;
}

namespace {
/** Returns the force of the pieces that belong to a part of Γ_c with a name. */
template <int dim, typename Belongs>
SideForce force_of_pieces(const std::string &name, const MultiplierSpace<dim> &multipliers,
                          const Multiplier &multiplier, const PairSide acts_on,
                          const Belongs &belongs) {
  const ContactSurface<dim> &surface = multipliers.surface();
  Resultant<dim> resultant;
  double total = 0.;
  Tensor<1, dim> centre;
  for (const Piece<dim> &piece : surface.pieces())
    if (belongs(piece)) {
      const PairedPiece<dim> pair(surface, piece);
      resultant += pair.resultant(multipliers, multiplier, acts_on);
      const SurfaceRule<dim> &rule = piece.on_mesh;
      const std::vector<Point<dim>> points = pair.points(rule, acts_on);
      for (std::size_t q = 0; q < rule.size(); ++q) {
        const double share =
          multipliers.value(multiplier.normal(), piece.patch, rule.on_side[q]) * rule.weights[q];
        total += share;
        centre += share * points[q];
      }
    }
  const MPI_Comm communicator = surface.communicator();
  resultant = sum_over_ranks(resultant, communicator);
  total = Utilities::MPI::sum(total, communicator);
  centre = Utilities::MPI::sum(centre, communicator);
  return side_force(name, resultant, total != 0. ? Point<dim>(centre / total) : Point<dim>(),
                    std::abs(total));
}

/** Returns the distance of an arc length from a zone, 0 inside (length). */
double distance_from(const ContactZone &zone, const double s, const Side<2> &side) {
  const double middle = zone.start.at.arc_length + 0.5 * zone.length;
  double distance = std::abs(s - middle);
  if (side.is_closed())
    distance = std::abs(distance - side.length() * std::round(distance / side.length()));
  return std::max(0., distance - 0.5 * zone.length);
}
} // namespace

template <int dim>
SideForce contact_force(const MultiplierSpace<dim> &multipliers,
                        const std::vector<unsigned int> &contacts, const Multiplier &multiplier,
                        const PairSide acts_on) {
  const ContactSurface<dim> &surface = multipliers.surface();
  const Scene<dim> &scene = surface.scene();
  const ContactPair<dim> first(scene, contacts.front());
  const std::string name = contacts.size() > 1 ? std::string()
                           : acts_on == PairSide::second
                             ? first.other_name()
                             : scene.geometry.sides[first.side()].name();
  return force_of_pieces(name, multipliers, multiplier, acts_on, [&](const Piece<dim> &piece) {
    return std::count(contacts.begin(), contacts.end(), surface.patches()[piece.patch].contact) > 0;
  });
}

template <int dim>
std::vector<ContactForce> contact_forces(const MultiplierSpace<dim> &multipliers,
                                         const Multiplier &multiplier) {
  const ContactSurface<dim> &surface = multipliers.surface();
  std::vector<ContactForce> forces;
  for (const ContactPair<dim> &pair : contact_pairs(surface.scene())) {
    forces.push_back(
      {contact_force(multipliers, {pair.number()}, multiplier), pair.other_name(), PairSide::first,
       peak_pressure<dim>(multipliers, multiplier.normal(), {}, [&](const unsigned int patch) {
         return surface.patches()[patch].contact == pair.number();
       })});
    if (!pair.other_side())
      continue;
    const std::string own = forces.back().side;
    forces.push_back({contact_force(multipliers, {pair.number()}, multiplier, PairSide::second),
                      own, PairSide::second});
    if (pair.data().is_exchanged)
      std::swap(forces.back(), forces[forces.size() - 2]);
  }
  return forces;
}

std::vector<ContactForce> zone_forces(const MultiplierSpace<2> &multipliers,
                                      const Multiplier &multiplier,
                                      const std::vector<ContactZone> &zones) {
  const ContactSurface<2> &surface = multipliers.surface();
  // The zone at a part of a patch.
  const auto zone_at = [&](const unsigned int patch, const double s) {
    double least = std::numeric_limits<double>::max();
    std::size_t nearest = zones.size();
    for (std::size_t i = 0; i < zones.size(); ++i)
      if (zones[i].contact == surface.patches()[patch].contact)
        if (const double distance =
              distance_from(zones[i], s, surface.side(surface.patches()[patch]));
            distance < least) {
          least = distance;
          nearest = i;
        }
    return nearest;
  };
  std::vector<std::size_t> of_pieces, of_patches;
  for (const Piece<2> &piece : surface.pieces())
    of_pieces.push_back(zone_at(piece.patch, 0.5 * (piece.lower[0] + piece.upper[0])));
  for (unsigned int k = 0; k < surface.patches().size(); ++k)
    of_patches.push_back(zone_at(k, surface.patches()[k].centre()[0]));
  std::vector<ContactForce> forces;
  for (std::size_t i = 0; i < zones.size(); ++i)
    forces.push_back(
      {force_of_pieces(
         zones[i].start.at.side, multipliers, multiplier, PairSide::first,
         [&](const Piece<2> &piece) { return of_pieces[&piece - surface.pieces().data()] == i; }),
       ContactPair<2>(surface.scene(), zones[i].contact).other_name(), PairSide::first,
       peak_pressure<2>(multipliers, multiplier.normal(), {},
                        [&](const unsigned int patch) { return of_patches[patch] == i; })});
  return forces;
}

std::vector<ContactForce> zone_forces(const MultiplierSpace<3> &multipliers,
                                      const Multiplier &multiplier,
                                      const std::vector<PressedArea> &areas) {
  const ContactSurface<3> &surface = multipliers.surface();
  std::vector<ContactForce> forces;
  for (const PressedArea &area : areas) {
    const std::set<unsigned int> patches(area.patches.begin(), area.patches.end());
    const auto is_part = [&](const unsigned int patch) { return patches.count(patch) > 0; };
    forces.push_back({force_of_pieces(surface.side(surface.patches()[area.patches.front()]).name(),
                                      multipliers, multiplier, PairSide::first,
                                      [&](const Piece<3> &piece) { return is_part(piece.patch); }),
                      "", PairSide::first,
                      peak_pressure<3>(multipliers, multiplier.normal(), {}, is_part)});
  }
  return forces;
}

namespace {
/** A node that is held, by one or more sides. */
template <int dim>
struct HeldNode {
  Point<dim> point;
  std::array<types::global_dof_index, dim> dofs;
  std::set<unsigned int> sides;
};

/** Returns the held nodes of this rank by their first degree of freedom. */
template <int dim>
std::map<types::global_dof_index, HeldNode<dim>> held_nodes(const DisplacementSpace<dim> &space,
                                                            const Scene<dim> &scene) {
  std::map<types::global_dof_index, HeldNode<dim>> nodes;
  NodePositions<dim> positions(space);
  std::vector<types::global_dof_index> indices;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (!cell->is_artificial() && cell->at_boundary())
      for (const unsigned int f : cell->face_indices()) {
        const auto face = cell->face(f);
        if (!face->at_boundary() || !holds(scene.boundary[face->boundary_id()].role))
          continue;
        const FiniteElement<dim> &element = cell->get_fe();
        indices.resize(element.n_dofs_per_cell());
        cell->get_dof_indices(indices);
        const std::vector<Point<dim>> &points = positions(cell);
        for (unsigned int k = 0; k < points.size(); ++k) {
          const unsigned int first = element.component_to_system_index(0, k);
          if (!element.has_support_on_face(first, f) ||
              !space.locally_owned().is_element(indices[first]))
            continue;
          HeldNode<dim> &node = nodes[indices[first]];
          node.point = points[k];
          for (unsigned int c = 0; c < dim; ++c)
            node.dofs[c] = indices[element.component_to_system_index(c, k)];
          node.sides.insert(face->boundary_id());
        }
      }
  return nodes;
}

/** Adds the reaction of a node to the sides that hold it: to rollers its projection on their
 * normals, to others equal shares of the rest. */
template <int dim>
void divide(const HeldNode<dim> &node, const Tensor<1, dim> &reaction, const Scene<dim> &scene,
            std::map<unsigned int, Resultant<dim>> &by_side) {
  std::vector<unsigned int> rollers, others;
  for (const unsigned int side : node.sides)
    (scene.boundary[side].role == Role::roller ? rollers : others).push_back(side);
  Tensor<1, dim> rest = reaction;
  if (const unsigned int n = rollers.size()) {
    // Σ λ_i n_i with n_j.Σ λ_i n_i = n_j.R, where normals are parallel in equal shares.
    std::vector<Tensor<1, dim>> normals;
    for (const unsigned int number : rollers) {
      const Side<dim> &side = scene.geometry.sides[number];
      normals.push_back(side.normal_at(node.point));
    }
    LAPACKFullMatrix<double> products(n, n);
    dealii::Vector<double> components(n), lambda(n);
    for (unsigned int i = 0; i < n; ++i) {
      components[i] = normals[i] * reaction;
      for (unsigned int j = 0; j < n; ++j)
        products(i, j) = normals[i] * normals[j];
    }
    products.compute_inverse_svd(1e-6);
    products.vmult(lambda, components);
    for (unsigned int i = 0; i < n; ++i) {
      by_side[rollers[i]].add(lambda[i] * normals[i], node.point);
      rest -= lambda[i] * normals[i];
    }
  }
  // Between rollers alone only rounding is left.
  if (others.empty())
    others.push_back(rollers.back());
  for (const unsigned int side : others)
    by_side[side].add(rest / static_cast<double>(others.size()), node.point);
}
} // namespace

template <int dim>
std::vector<SideForce> reactions(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                                 const NodalForces &forces) {
  std::map<unsigned int, Resultant<dim>> by_side;
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    if (holds(scene.boundary[i].role))
      by_side[i] = {};
  for (const auto &[dof, node] : held_nodes(space, scene)) {
    Tensor<1, dim> reaction;
    for (unsigned int c = 0; c < dim; ++c)
      reaction[c] = forces.residual(node.dofs[c]);
    divide(node, reaction, scene, by_side);
  }
  const double scale = forces.largest();
  std::vector<SideForce> result;
  for (const auto &[number, part] : by_side) {
    const Side<dim> &side = scene.geometry.sides[number];
    result.push_back(side_force(side.name(), sum_over_ranks(part, space.mesh().communicator()),
                                side.centre(), scale));
  }
  return result;
}

ReactionFunctionals::ReactionFunctionals(const DisplacementSpace<2> &space, const Scene<2> &scene) {
  std::map<unsigned int, std::array<Displacement, 2>> v;
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    if (holds(scene.boundary[i].role))
      v[i] = {{space.zero(), space.zero()}};
  for (const auto &[dof, node] : held_nodes(space, scene))
    for (unsigned int c = 0; c < 2; ++c) {
      std::map<unsigned int, Resultant<2>> by_side;
      Tensor<1, 2> unit;
      unit[c] = 1.;
      divide(node, unit, scene, by_side);
      for (const auto &[side, part] : by_side)
        for (unsigned int d = 0; d < 2; ++d)
          v[side][d](node.dofs[c]) = part.force[d];
    }
  for (auto &[side, components] : v)
    for (unsigned int d = 0; d < 2; ++d) {
      space.make_continuous(components[d]);
      functionals_.push_back({scene.geometry.sides[side].name() + "_" + "xy"[d], components[d],
                              internal_forces(DisplacedBody(space, scene, components[d])).forces});
    }
}

std::vector<std::pair<std::string, double>>
ReactionFunctionals::of(const Displacement &U, const DualVector &forces) const {
  std::vector<std::pair<std::string, double>> values;
  for (const Functional &functional : functionals_)
    values.emplace_back(functional.name, U * functional.stiffness - functional.v * forces);
  return values;
}

INSTANTIATE_FUNCTION(side_force);
INSTANTIATE_FUNCTION(contacts_of_contact_force);
INSTANTIATE_FUNCTION(body_of_contact_force);
INSTANTIATE_FUNCTION(contact_force);
INSTANTIATE_FUNCTION(contact_forces);
INSTANTIATE_FUNCTION(reactions);
} // namespace Signorini
