// SPDX-License-Identifier: LGPL-2.1-or-later
// B: the normal trace of V^h on Γ_c.

#include <signorini/discretization/elasticity/traces.h>

namespace Signorini
{
template <int dim>
TraceValues<dim>::TraceValues(const DisplacementSpace<dim> &space)
  : space_(space)
{
}

template <int dim>
const dealii::FEFaceValues<dim> &
TraceValues<dim>::reinit(const ContactFace<dim> &face,
                         const std::vector<dealii::Point<dim - 1>> &on_face)
{
  const unsigned int number = space_.element_number(face.cell);
  if (values_ == nullptr || number != element_number_ || on_face != on_face_)
  {
    on_face_ = on_face;
    element_number_ = number;
    values_ = std::make_unique<dealii::FEFaceValues<dim>>(space_.mesh().mapping(),
                                                          space_.elements()[number],
                                                          dealii::Quadrature<dim - 1>(on_face),
                                                          dealii::update_values);
  }
  values_->reinit(space_.dof_cell(face.cell), face.face_no);
  return *values_;
}

template <int dim>
std::vector<dealii::Tensor<1, dim>> TraceValues<dim>::displacement(const ContactFace<dim> &face,
                                                                   const SurfaceRule<dim> &rule,
                                                                   const Displacement &U)
{
  const auto &values = reinit(face, rule.on_face);
  std::vector<dealii::Tensor<1, dim>> u(rule.size());
  values[dealii::FEValuesExtractors::Vector(0)].get_function_values(U.entries(), u);
  return u;
}

template <int dim>
std::vector<double> TraceValues<dim>::normal_displacement(const ContactFace<dim> &face,
                                                          const SurfaceRule<dim> &rule,
                                                          const Displacement &U)
{
  const std::vector<dealii::Tensor<1, dim>> u = displacement(face, rule, U);
  std::vector<double> u_n(rule.size());
  for (std::size_t q = 0; q < rule.size(); ++q)
    u_n[q] = u[q] * rule.normals[q];
  return u_n;
}

template class TraceValues<2>;
template class TraceValues<3>;

// I^h. (VectorTools::interpolate fills in the locally owned cells only.)

template <int dim>
Displacement interpolate_at_nodes(const DisplacementSpace<dim> &space,
                                  const dealii::Function<dim> &u)
{
  NodePositions<dim> positions(space);
  Displacement values = space.zero();
  std::vector<bool> visited(values.size(), false);
  std::vector<dealii::types::global_dof_index> indices;
  dealii::Vector<double> u_at_node(dim);
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    const dealii::FiniteElement<dim> &element = cell->get_fe();
    const std::vector<dealii::Point<dim>> &nodes = positions(cell);
    indices.resize(element.n_dofs_per_cell());
    cell->get_dof_indices(indices);
    for (unsigned int node = 0; node < nodes.size(); ++node)
    {
      if (visited[indices[element.component_to_system_index(0, node)]])
        continue;
      u.vector_value(nodes[node], u_at_node);
      for (unsigned int d = 0; d < dim; ++d)
      {
        const auto index = indices[element.component_to_system_index(d, node)];
        values[index] = u_at_node[d];
        visited[index] = true;
      }
    }
  }
  values.update_ghost_values();
  return values;
}

template Displacement interpolate_at_nodes(const DisplacementSpace<2> &,
                                           const dealii::Function<2> &);
template Displacement interpolate_at_nodes(const DisplacementSpace<3> &,
                                           const dealii::Function<3> &);
} // namespace Signorini
