// SPDX-License-Identifier: LGPL-2.1-or-later
// V^h and its essential boundary conditions.

#include <signorini/elasticity/displacement_space.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/numerics/vector_tools_boundary.h>
#include <deal.II/numerics/vector_tools_constraints.h>

namespace Signorini
{
namespace
{
template <int dim>
dealii::AffineConstraints<double> make_constraints(const Mesh<dim> &mesh,
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
  dealii::AffineConstraints<double> constraints;
  dealii::VectorTools::interpolate_boundary_values(
    mesh.mapping(), dofs, displacements, constraints);
  // Where a roller meets a clamped or prescribed side, the entries above stay.
  if (!rollers.empty())
    dealii::VectorTools::compute_no_normal_flux_constraints(
      dofs, 0, rollers, constraints, mesh.mapping());
  constraints.close();
  return constraints;
}
} // namespace

template <int dim>
DisplacementSpace<dim>::DisplacementSpace(const Mesh<dim> &mesh,
                                          const Scene<dim> &scene,
                                          const StrainOperator strain_operator)
  : mesh_(mesh)
  , strain_operator_(strain_operator)
  , element_(dealii::FE_Q<dim>(1), dim)
  , dofs_(mesh.triangulation())
{
  dofs_.distribute_dofs(element_);
  constraints_ = make_constraints(mesh, dofs_, scene);
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
typename dealii::DoFHandler<dim>::active_cell_iterator DisplacementSpace<dim>::dof_cell(
  const typename dealii::Triangulation<dim>::active_cell_iterator &cell) const
{
  return {&mesh_.triangulation(), cell->level(), cell->index(), &dofs_};
}

template <int dim>
std::vector<dealii::types::global_dof_index> DisplacementSpace<dim>::cell_dofs(
  const typename dealii::Triangulation<dim>::active_cell_iterator &cell) const
{
  std::vector<dealii::types::global_dof_index> indices(element_.n_dofs_per_cell());
  dof_cell(cell)->get_dof_indices(indices);
  return indices;
}

template class DisplacementSpace<2>;
} // namespace Signorini
