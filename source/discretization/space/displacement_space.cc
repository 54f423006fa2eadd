// SPDX-License-Identifier: LGPL-2.1-or-later
// V^h and its essential boundary conditions.

#include <signorini/discretization/space/displacement_space.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/problem/scene/rigid_motions.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/numerics/vector_tools_boundary.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace Signorini {
namespace {
/** Returns no conditions, on the degrees of freedom of the cells of this rank and next to them. */
template <int dim>
AffineConstraints<double> no_conditions(const DoFHandler<dim> &dofs) {
  IndexSet relevant;
  DoFTools::extract_locally_relevant_dofs(dofs, relevant);
  return AffineConstraints<double>(relevant);
}

/** A node on rollers: its degrees of freedom, and orthonormal directions that are held. */
template <int dim>
struct RollerNode {
  std::array<types::global_dof_index, dim> dofs;
  std::vector<Tensor<1, dim>> held;

  /** Holds a normal as far as it is not held. */
  void hold(Tensor<1, dim> normal) {
    constexpr double smallest_turn = 1e-6;
    for (const Tensor<1, dim> &known : held)
      normal -= (normal * known) * known;
    if (normal.norm() > smallest_turn)
      held.push_back(normal / normal.norm());
  }
};

/** Returns the nodes on rollers by their first degree of freedom. */
template <int dim>
std::map<types::global_dof_index, RollerNode<dim>>
roller_nodes(const Mesh<dim> &mesh, const DoFHandler<dim> &dofs, const Scene<dim> &scene,
             const std::set<types::boundary_id> &rollers) {
  std::map<types::global_dof_index, RollerNode<dim>> nodes;
  for (const auto &cell : dofs.active_cell_iterators())
    for (const unsigned int f : cell->face_indices()) {
      if (cell->is_artificial() || !cell->at_boundary(f) ||
          rollers.count(cell->face(f)->boundary_id()) == 0)
        continue;
      const Side<dim> &side = scene.geometry.sides[cell->face(f)->boundary_id()];
      const FiniteElement<dim> &fe = cell->get_fe();
      std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
      cell->get_dof_indices(indices);
      std::map<unsigned int, std::array<unsigned int, dim>> on_face;
      for (unsigned int i = 0; i < indices.size(); ++i)
        if (fe.has_support_on_face(i, f))
          on_face[fe.system_to_component_index(i).second][fe.system_to_component_index(i).first] =
            i;
      for (const auto &entry : on_face) {
        const std::array<unsigned int, dim> &of_node = entry.second;
        const Point<dim> x =
          mesh.mapping().transform_unit_to_real_cell(cell, fe.unit_support_point(of_node[0]));
        RollerNode<dim> &node = nodes[indices[of_node[0]]];
        for (unsigned int c = 0; c < dim; ++c)
          node.dofs[c] = indices[of_node[c]];
        if constexpr (dim == 2)
          node.hold(side.normal_at(x, cell->face(f)->center()));
        else
          node.hold(side.normal_at(x));
      }
    }
  return nodes;
}

/** Holds the normals of all rollers at their nodes. deal.II's function takes the mean of the
 * normals of two sides where no cell has faces on both, as at edges of tetrahedra. */
template <int dim>
void hold_rollers(const Mesh<dim> &mesh, const DoFHandler<dim> &dofs, const Scene<dim> &scene,
                  const std::set<types::boundary_id> &rollers,
                  AffineConstraints<double> &conditions) {
  constexpr double rounding = 1e-13;
  for (const auto &entry : roller_nodes(mesh, dofs, scene, rollers)) {
    const RollerNode<dim> &node = entry.second;
    const bool is_plane = node.held.size() == 1, is_fixed = node.held.size() == dim;
    // One direction is held or one is free: all along it.
    Tensor<1, dim> along = node.held[0];
    if constexpr (dim == 3)
      if (node.held.size() == 2)
        along = cross_product_3d(node.held[0], node.held[1]);
    unsigned int largest = 0;
    for (unsigned int c = 1; c < dim; ++c)
      if (std::abs(along[c]) > std::abs(along[largest]) + rounding)
        largest = c;
    const auto add = [&](const unsigned int c, const unsigned int other, const double factor) {
      if (std::abs(factor) > rounding)
        conditions.add_entry(node.dofs[c], node.dofs[other], factor);
    };
    for (unsigned int c = 0; c < dim; ++c) {
      const bool is_bound = is_fixed || (c == largest) == is_plane;
      if (!is_bound || conditions.is_constrained(node.dofs[c]))
        continue;
      conditions.add_line(node.dofs[c]);
      for (unsigned int other = 0; is_plane && other < dim; ++other)
        if (other != c)
          add(c, other, -along[other] / along[c]);
      if (!is_plane && !is_fixed)
        add(c, largest, along[c] / along[largest]);
    }
  }
}

/** Returns the conditions of clamped, prescribed and roller sides for u_h. */
template <int dim>
AffineConstraints<double> essential_conditions(const Mesh<dim> &mesh, const DoFHandler<dim> &dofs,
                                               const Scene<dim> &scene) {
  const Functions::ZeroFunction<dim> zero(dim);
  std::map<types::boundary_id, const Function<dim> *> displacements;
  std::set<types::boundary_id> rollers;
  for (unsigned int i = 0; i < scene.boundary.size(); ++i) {
    const BoundaryCondition<dim> &condition = scene.boundary[i];
    if (condition.role == Role::clamped)
      displacements[i] = &zero;
    else if (condition.role == Role::displacement)
      displacements[i] = condition.data.get();
    else if (condition.role == Role::roller)
      rollers.insert(i);
  }
  AffineConstraints<double> conditions = no_conditions(dofs);
  VectorTools::interpolate_boundary_values(mesh.mapping(), dofs, displacements, conditions);
  // Where a roller meets a clamped or prescribed side, the entries above stay.
  hold_rollers(mesh, dofs, scene, rollers, conditions);
  conditions.close();
  return conditions;
}

/** A node for a pin, and the share at which its speed counts where pins are chosen. */
template <int dim>
struct PinCandidate {
  typename DisplacementSpace<dim>::Pin pin;
  double weight;
};

/** Returns the free components of vertices of the coarse mesh, which do not hang. Those on contact
 * sides count little: a pin there takes part of the load. */
template <int dim>
std::vector<PinCandidate<dim>> pin_candidates(const DoFHandler<dim> &dofs, const Scene<dim> &scene,
                                              const AffineConstraints<double> &essential) {
  std::map<unsigned int, double> weights;
  for (const auto &cell : dofs.get_triangulation().cell_iterators_on_level(0))
    for (const unsigned int v : cell->vertex_indices())
      weights[cell->vertex_index(v)] = 1.;
  for (const auto &face : dofs.get_triangulation().active_face_iterators())
    if (face->at_boundary() && scene.boundary[face->boundary_id()].role == Role::contact)
      for (const unsigned int v : face->vertex_indices())
        if (const auto vertex = weights.find(face->vertex_index(v)); vertex != weights.end())
          vertex->second = 1e-3;
  std::vector<PinCandidate<dim>> candidates;
  for (const auto &cell : dofs.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      if (const auto vertex = weights.find(cell->vertex_index(v)); vertex != weights.end()) {
        for (unsigned int c = 0; c < dim; ++c) {
          const auto dof = cell->vertex_dof_index(v, c, cell->active_fe_index());
          if (!essential.is_constrained(dof))
            candidates.push_back(
              {{dof, cell->vertex(v), c, scene.geometry.body_of(cell)}, vertex->second});
        }
        weights.erase(vertex);
      }
  return candidates;
}

/** Returns as many pins as there are motions, chosen one after the other where the motions that are
 * left are fastest: elimination with complete pivoting. */
template <int dim>
std::vector<typename DisplacementSpace<dim>::Pin>
choose_pins(const DoFHandler<dim> &dofs, const Scene<dim> &scene,
            const AffineConstraints<double> &essential) {
  using Pin = typename DisplacementSpace<dim>::Pin;
  std::vector<RigidMotion<dim>> motions = free_rigid_motions(scene);
  const auto candidates = pin_candidates(dofs, scene, essential);
  const auto speed = [](const RigidMotion<dim> &motion, const Pin &pin) {
    return motion.bodies[pin.body].velocity(pin.node)[pin.component];
  };
  std::vector<Pin> pins;
  while (!motions.empty()) {
    Pin pin = {};
    std::size_t fastest = 0;
    double largest = 0.;
    for (const PinCandidate<dim> &candidate : candidates)
      for (std::size_t k = 0; k < motions.size(); ++k)
        if (const double size = candidate.weight * std::abs(speed(motions[k], candidate.pin));
            size > largest) {
          largest = size;
          pin = candidate.pin;
          fastest = k;
        }
    const RigidMotion<dim> stopped = motions[fastest];
    motions.erase(motions.begin() + fastest);
    for (RigidMotion<dim> &motion : motions)
      motion = combine<dim>({motion, stopped}, {1., -speed(motion, pin) / speed(stopped, pin)});
    pins.push_back(pin);
  }
  return pins;
}

/** Returns constrained degrees of freedom and their masters: on an oblique roller both components
 * of a node carry the reaction. */
IndexSet held_dofs(const AffineConstraints<double> &conditions,
                   const types::global_dof_index n_dofs) {
  IndexSet held(n_dofs);
  for (const auto &line : conditions.get_lines()) {
    held.add_index(line.index);
    for (const auto &entry : line.entries)
      held.add_index(entry.first);
  }
  held.compress();
  return held;
}

/** Returns the constraints that keep u_h continuous at hanging nodes and between different degrees.
 */
template <int dim>
AffineConstraints<double> continuity_conditions(const DoFHandler<dim> &dofs) {
  AffineConstraints<double> conditions = no_conditions(dofs);
  if (dofs.get_triangulation().has_hanging_nodes() || dofs.get_fe_collection().size() > 1)
    DoFTools::make_hanging_node_constraints(dofs, conditions);
  conditions.close();
  return conditions;
}

/** Sets the constrained values of w = T w_free. */
void set_constrained(const AffineConstraints<double> &constraints, Displacement &w) {
  w.update_ghost_values();
  for (const auto &line : constraints.get_lines()) {
    if (!w.in_local_range(line.index))
      continue;
    double value = 0.;
    for (const auto &entry : line.entries)
      value += entry.second * w(entry.first);
    w(line.index) = value;
  }
  w.update_ghost_values();
}

/** Returns both sets of constraints; where a degree of freedom has both, the essential condition.
 */
AffineConstraints<double> merge(AffineConstraints<double> essential,
                                const AffineConstraints<double> &continuity) {
  if (continuity.n_constraints() == 0)
    return essential;
  AffineConstraints<double> constraints(continuity);
  constraints.merge(essential, AffineConstraints<double>::right_object_wins);
  constraints.close();
  return constraints;
}
} // namespace

template <int dim>
DisplacementSpace<dim>::DisplacementSpace(const Mesh<dim> &mesh, const Scene<dim> &scene,
                                          const StrainOperator strain_operator,
                                          const unsigned int degree)
  : mesh_(mesh)
  , strain_operator_(strain_operator)
  , dofs_(mesh.triangulation()) {
  distribute(scene, hp::FECollection<dim>(FESystem<dim>(FE_Q<dim>(degree), dim)));
}

template <int dim>
DisplacementSpace<dim>::DisplacementSpace(const Mesh<dim> &mesh, const Scene<dim> &scene,
                                          const std::vector<unsigned int> &degrees)
  : mesh_(mesh)
  , strain_operator_(StrainOperator::symmetric_gradient)
  , dofs_(mesh.triangulation()) {
  AssertDimension(degrees.size(), mesh.triangulation().n_active_cells());
  constexpr unsigned int lowest = 2;
  const unsigned int highest = *std::max_element(degrees.begin(), degrees.end());
  hp::FECollection<dim> elements;
  for (unsigned int degree = lowest; degree <= highest; ++degree)
    elements.push_back(FESystem<dim>(FE_Q<dim>(degree), dim));
  if (elements.size() > 1)
    for (const auto &cell : dofs_.active_cell_iterators())
      cell->set_active_fe_index(degrees[cell->active_cell_index()] - lowest);
  distribute(scene, elements);
}

template <int dim>
void DisplacementSpace<dim>::distribute(const Scene<dim> &scene,
                                        const hp::FECollection<dim> &elements) {
  dofs_.distribute_dofs(elements);
  auto essential = essential_conditions(mesh_, dofs_, scene);
  supports_ = held_dofs(essential, dofs_.n_dofs());
  continuity_ = continuity_conditions(dofs_);
  if (scene.is_held_by_contact) {
    pins_ = choose_pins(dofs_, scene, essential);
    constraints_without_pins_ = merge(AffineConstraints<double>(essential), continuity_);
    AffineConstraints<double> conditions = no_conditions(dofs_);
    conditions.merge(essential);
    for (const Pin &pin : pins_)
      conditions.add_line(pin.dof);
    conditions.close();
    essential = std::move(conditions);
  }
  constraints_ = merge(std::move(essential), continuity_);
  IndexSet relevant;
  DoFTools::extract_locally_relevant_dofs(dofs_, relevant);
  rows_ = std::make_shared<const Utilities::MPI::Partitioner>(locally_owned(), relevant,
                                                              mesh_.communicator());
}

template <int dim>
Displacement DisplacementSpace<dim>::complete(const Displacement &free_values) const {
  Displacement values = free_values;
  values.zero_out_ghost_values();
  constraints_.distribute(values.entries());
  values.update_ghost_values();
  return values;
}

template <int dim>
Displacement DisplacementSpace<dim>::prescribed(const Scene<dim> &scene) const {
  Displacement k(rows_);
  merge(essential_conditions(mesh_, dofs_, scene), continuity_).distribute(k.entries());
  k.update_ghost_values();
  return k;
}

template <int dim>
void DisplacementSpace<dim>::distribute_homogeneous(Displacement &w) const {
  set_constrained(constraints_, w);
}

template <int dim>
void DisplacementSpace<dim>::distribute_without_pins(Displacement &w) const {
  set_constrained(constraints_without_pins(), w);
}

template <int dim>
void DisplacementSpace<dim>::make_continuous(Displacement &v) const {
  set_constrained(continuity_, v);
}

namespace {
/** Adds the rows of constrained degrees of freedom to those that they follow, and clears them. */
void carry(const AffineConstraints<double> &constraints, DualVector &functional) {
  functional.zero_out_ghost_values();
  for (const auto &line : constraints.get_lines()) {
    if (!functional.in_local_range(line.index))
      continue;
    for (const auto &entry : line.entries)
      functional(entry.first) += entry.second * functional(line.index);
    functional(line.index) = 0.;
  }
  functional.compress(VectorOperation::add);
}
} // namespace

template <int dim>
DualVector DisplacementSpace<dim>::condense(const DualVector &functional) const {
  // AffineConstraints::condense() refuses prescribed displacements, which T leaves out.
  DualVector condensed = functional;
  carry(constraints_, condensed);
  return condensed;
}

template <int dim>
void DisplacementSpace<dim>::carry_to_masters(DualVector &functional) const {
  carry(continuity_, functional);
}

template <int dim>
typename DoFHandler<dim>::active_cell_iterator
DisplacementSpace<dim>::dof_cell(const CellIterator &cell) const {
  return {&mesh_.triangulation(), cell->level(), cell->index(), &dofs_};
}

template <int dim>
std::vector<types::global_dof_index>
DisplacementSpace<dim>::cell_dofs(const CellIterator &cell) const {
  std::vector<types::global_dof_index> indices(element(cell).n_dofs_per_cell());
  dof_cell(cell)->get_dof_indices(indices);
  return indices;
}

template class DisplacementSpace<2>;
template class DisplacementSpace<3>;
} // namespace Signorini
