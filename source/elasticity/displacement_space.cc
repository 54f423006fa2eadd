// SPDX-License-Identifier: LGPL-2.1-or-later
// V^h and its essential boundary conditions.

#include <signorini/elasticity/displacement_space.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/numerics/vector_tools_boundary.h>
#include <deal.II/numerics/vector_tools_constraints.h>

#include <algorithm>

namespace Signorini
{
namespace
{
/** What clamped, prescribed and roller sides say about u_h. */
template <int dim>
dealii::AffineConstraints<double> essential_conditions(const Mesh<dim> &mesh,
                                                       const dealii::DoFHandler<dim> &dofs,
                                                       const Scene<dim> &scene)
{
  const dealii::Functions::ZeroFunction<dim> zero(dim);
  std::map<dealii::types::boundary_id, const dealii::Function<dim> *> displacements;
  std::set<dealii::types::boundary_id> rollers;
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
  {
    const BoundaryCondition<dim> &condition = scene.boundary[i];
    if (condition.role == Role::clamped)
      displacements[i] = &zero;
    else if (condition.role == Role::displacement)
      displacements[i] = condition.data.get();
    else if (condition.role == Role::roller)
      rollers.insert(i);
  }
  dealii::AffineConstraints<double> conditions;
  dealii::VectorTools::interpolate_boundary_values(mesh.mapping(), dofs, displacements, conditions);
  // Where a roller meets a clamped or prescribed side, the entries above stay.
  if (!rollers.empty())
    dealii::VectorTools::compute_no_normal_flux_constraints(
      dofs, 0, rollers, conditions, mesh.mapping());
  conditions.close();
  return conditions;
}

/** Constrained degrees of freedom and those that they follow: on an oblique roller both components
 * of a node carry the reaction. */
dealii::IndexSet held_dofs(const dealii::AffineConstraints<double> &conditions,
                           const dealii::types::global_dof_index n_dofs)
{
  dealii::IndexSet held(n_dofs);
  for (const auto &line : conditions.get_lines())
  {
    held.add_index(line.index);
    for (const auto &entry : line.entries)
      held.add_index(entry.first);
  }
  held.compress();
  return held;
}

/** What keeps u_h continuous at hanging nodes and between different degrees. */
template <int dim>
dealii::AffineConstraints<double> continuity_conditions(const dealii::DoFHandler<dim> &dofs)
{
  dealii::AffineConstraints<double> conditions;
  if (dofs.get_triangulation().has_hanging_nodes() || dofs.get_fe_collection().size() > 1)
    dealii::DoFTools::make_hanging_node_constraints(dofs, conditions);
  conditions.close();
  return conditions;
}

/** Both; where a degree of freedom has both, the essential condition. */
dealii::AffineConstraints<double> merge(dealii::AffineConstraints<double> essential,
                                        const dealii::AffineConstraints<double> &continuity)
{
  if (continuity.n_constraints() == 0)
    return essential;
  dealii::AffineConstraints<double> constraints(continuity);
  constraints.merge(essential, dealii::AffineConstraints<double>::right_object_wins);
  constraints.close();
  return constraints;
}
} // namespace

template <int dim>
DisplacementSpace<dim>::DisplacementSpace(const Mesh<dim> &mesh,
                                          const Scene<dim> &scene,
                                          const StrainOperator strain_operator,
                                          const unsigned int degree)
  : mesh_(mesh)
  , strain_operator_(strain_operator)
  , dofs_(mesh.triangulation())
{
  distribute(scene,
             dealii::hp::FECollection<dim>(dealii::FESystem<dim>(dealii::FE_Q<dim>(degree), dim)));
}

template <int dim>
DisplacementSpace<dim>::DisplacementSpace(const Mesh<dim> &mesh,
                                          const Scene<dim> &scene,
                                          const std::vector<unsigned int> &degrees)
  : mesh_(mesh)
  , strain_operator_(StrainOperator::symmetric_gradient)
  , dofs_(mesh.triangulation())
{
  AssertDimension(degrees.size(), mesh.triangulation().n_active_cells());
  constexpr unsigned int lowest = 2;
  const unsigned int highest = *std::max_element(degrees.begin(), degrees.end());
  dealii::hp::FECollection<dim> elements;
  for (unsigned int degree = lowest; degree <= highest; ++degree)
    elements.push_back(dealii::FESystem<dim>(dealii::FE_Q<dim>(degree), dim));
  if (elements.size() > 1)
    for (const auto &cell : dofs_.active_cell_iterators())
      cell->set_active_fe_index(degrees[cell->active_cell_index()] - lowest);
  distribute(scene, elements);
}

template <int dim>
void DisplacementSpace<dim>::distribute(const Scene<dim> &scene,
                                        const dealii::hp::FECollection<dim> &elements)
{
  dofs_.distribute_dofs(elements);
  auto essential = essential_conditions(mesh_, dofs_, scene);
  supports_ = held_dofs(essential, dofs_.n_dofs());
  continuity_ = continuity_conditions(dofs_);
  constraints_ = merge(std::move(essential), continuity_);
}

template <int dim>
DistributedVector DisplacementSpace<dim>::make_vector() const
{
  return DistributedVector(locally_owned(), mesh_.communicator());
}

template <int dim>
NodalVector DisplacementSpace<dim>::complete(const DistributedVector &free_values) const
{
  NodalVector values(free_values);
  constraints_.distribute(values);
  return values;
}

template <int dim>
void DisplacementSpace<dim>::distribute_homogeneous(NodalVector &w) const
{
  for (const auto &line : constraints_.get_lines())
  {
    w[line.index] = 0.;
    for (const auto &entry : line.entries)
      w[line.index] += entry.second * w[entry.first];
  }
}

template <int dim>
NodalVector DisplacementSpace<dim>::condense(const NodalVector &functional) const
{
  // AffineConstraints::condense() refuses prescribed displacements, which T leaves out.
  NodalVector condensed = functional;
  for (const auto &line : constraints_.get_lines())
  {
    for (const auto &entry : line.entries)
      condensed[entry.first] += entry.second * functional[line.index];
    condensed[line.index] = 0.;
  }
  return condensed;
}

template <int dim>
void DisplacementSpace<dim>::carry_to_masters(NodalVector &functional) const
{
  for (const auto &line : continuity_.get_lines())
  {
    for (const auto &entry : line.entries)
      functional[entry.first] += entry.second * functional[line.index];
    functional[line.index] = 0.;
  }
}

template <int dim>
typename dealii::DoFHandler<dim>::active_cell_iterator
DisplacementSpace<dim>::dof_cell(const CellIterator &cell) const
{
  return {&mesh_.triangulation(), cell->level(), cell->index(), &dofs_};
}

template <int dim>
std::vector<dealii::types::global_dof_index>
DisplacementSpace<dim>::cell_dofs(const CellIterator &cell) const
{
  std::vector<dealii::types::global_dof_index> indices(element(cell).n_dofs_per_cell());
  dof_cell(cell)->get_dof_indices(indices);
  return indices;
}

template class DisplacementSpace<2>;
template class DisplacementSpace<3>;
} // namespace Signorini
