// SPDX-License-Identifier: LGPL-2.1-or-later
// The energy norm |||u_h||| without the rounding errors of a rigid translation, and whether the
// body only moves as a whole.

#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/discretization/elasticity/integration.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
template <int dim>
double energy_norm(const DisplacementSpace<dim> &space,
                   const Scene<dim> &scene,
                   const Displacement &U)
{
  CellStiffness<dim> stiffness(space, scene);
  dealii::Vector<double> on_cell;
  double energy = 0.;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const auto &element = cell->get_fe();
      on_cell.reinit(element.n_dofs_per_cell());
      cell->get_dof_values(U, on_cell);
      Tensor<1, dim> corner;
      for (unsigned int d = 0; d < dim; ++d)
        corner[d] = on_cell[element.component_to_system_index(d, 0)];
      for (unsigned int i = 0; i < on_cell.size(); ++i)
        on_cell[i] -= corner[element.system_to_component_index(i).first];
      energy += stiffness(cell).matrix_norm_square(on_cell);
    }
  energy = Utilities::MPI::sum(energy, space.mesh().communicator());
  return std::sqrt(std::max(0., energy * stiffness_unit(space, *scene.material)));
}

template <int dim>
std::optional<double> norm_of_rigid_motion(const DisplacementSpace<dim> &space,
                                           const Scene<dim> &scene,
                                           const Displacement &U)
{
  constexpr double unit_roundoff = std::numeric_limits<double>::epsilon();
  const double motion = U.linfty_norm(), size = space.mesh().size();
  // Of a body that moves far, the strains are not known: they are less than rounding of U.
  if (unit_roundoff * motion > 1e-12 * size)
    return {};
  // Rounding, or what V-cycles leave: strains below 1e-10, and below 1e-9 of the motion.
  const double tolerance =
    std::max(1e3 * unit_roundoff, 1e-10 * size / std::max(motion, 0.1 * size));
  CellStiffness<dim> stiffness(space, scene);
  dealii::Vector<double> on_cell, forces;
  bool rigid = true;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (rigid && cell->is_locally_owned())
    {
      on_cell.reinit(cell->get_fe().n_dofs_per_cell());
      forces.reinit(on_cell.size());
      cell->get_dof_values(U, on_cell);
      const FullMatrix<double> &K = stiffness(cell);
      K.vmult(forces, on_cell);
      rigid = forces.linfty_norm() <= tolerance * K.linfty_norm() * motion;
    }
  if (Utilities::MPI::min(rigid ? 1 : 0, space.mesh().communicator()) == 0)
    return {};
  // A body at rest, too, has a size that rounding is compared with.
  constexpr double min_motion = 1e-10;
  return std::max(motion, min_motion * size) * std::sqrt(stiffness_unit(space, *scene.material));
}

template <int dim>
double energy_scale(const double norm,
                    const double error,
                    const DisplacementSpace<dim> &space,
                    const Scene<dim> &scene,
                    const Displacement &U)
{
  constexpr double rounding = 1e-7;
  const std::optional<double> rigid = norm_of_rigid_motion(space, scene, U);
  if (!rigid)
    return norm;
  return error <= rounding * *rigid ? *rigid : error;
}

template double energy_norm(const DisplacementSpace<2> &, const Scene<2> &, const Displacement &);
template double energy_norm(const DisplacementSpace<3> &, const Scene<3> &, const Displacement &);
template std::optional<double> norm_of_rigid_motion(const DisplacementSpace<2> &,
                                                    const Scene<2> &,
                                                    const Displacement &);
template std::optional<double> norm_of_rigid_motion(const DisplacementSpace<3> &,
                                                    const Scene<3> &,
                                                    const Displacement &);
template double
energy_scale(double, double, const DisplacementSpace<2> &, const Scene<2> &, const Displacement &);
template double
energy_scale(double, double, const DisplacementSpace<3> &, const Scene<3> &, const Displacement &);

// B: the normal trace of V^h on Γ_c.

template <int dim>
TraceValues<dim>::TraceValues(const DisplacementSpace<dim> &space)
  : space_(space)
{
}

template <int dim>
const FEFaceValues<dim> &TraceValues<dim>::reinit(const ContactFace<dim> &face,
                                                  const std::vector<Point<dim - 1>> &on_face)
{
  const unsigned int number = space_.element_number(face.cell);
  if (values_ == nullptr || number != element_number_ || on_face != on_face_)
  {
    on_face_ = on_face;
    element_number_ = number;
    values_ = std::make_unique<FEFaceValues<dim>>(space_.mesh().mapping(),
                                                  space_.elements()[number],
                                                  Quadrature<dim - 1>(on_face),
                                                  update_values);
  }
  values_->reinit(space_.dof_cell(face.cell), face.face_no);
  return *values_;
}

template <int dim>
std::vector<Tensor<1, dim>> TraceValues<dim>::displacement(const ContactFace<dim> &face,
                                                           const SurfaceRule<dim> &rule,
                                                           const Displacement &U)
{
  const auto &values = reinit(face, rule.on_face);
  std::vector<Tensor<1, dim>> u(rule.size());
  values[FEValuesExtractors::Vector(0)].get_function_values(U.entries(), u);
  return u;
}

template <int dim>
std::vector<double> TraceValues<dim>::normal_displacement(const ContactFace<dim> &face,
                                                          const SurfaceRule<dim> &rule,
                                                          const Displacement &U)
{
  const std::vector<Tensor<1, dim>> u = displacement(face, rule, U);
  std::vector<double> u_n(rule.size());
  for (std::size_t q = 0; q < rule.size(); ++q)
    u_n[q] = u[q] * rule.normals[q];
  return u_n;
}

template class TraceValues<2>;
template class TraceValues<3>;

// I^h. (VectorTools::interpolate fills in the locally owned cells only.)

template <int dim>
Displacement interpolate_at_nodes(const DisplacementSpace<dim> &space, const Function<dim> &u)
{
  NodePositions<dim> positions(space);
  Displacement values = space.zero();
  std::vector<bool> visited(values.size(), false);
  std::vector<types::global_dof_index> indices;
  dealii::Vector<double> u_at_node(dim);
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    const FiniteElement<dim> &element = cell->get_fe();
    const std::vector<Point<dim>> &nodes = positions(cell);
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

template Displacement interpolate_at_nodes(const DisplacementSpace<2> &, const Function<2> &);
template Displacement interpolate_at_nodes(const DisplacementSpace<3> &, const Function<3> &);
} // namespace Signorini
