// SPDX-License-Identifier: LGPL-2.1-or-later
// A and f of (22): one pass over the cells.

#include <signorini/elasticity/cell_stiffness.h>
#include <signorini/elasticity/h1_gram_matrix.h>
#include <signorini/elasticity/linear_system.h>
#include <signorini/parameters/agreement.h>
#include <signorini/parameters/exceptions.h>

#include <cmath>
#include <sstream>

namespace Signorini
{
namespace
{
/** f_i of one cell: body force and tractions. */
template <int dim>
class CellLoads
{
public:
  CellLoads(const DisplacementSpace<dim> &space,
            const Scene<dim> &scene,
            const Kinks<dim> &kinks,
            const unsigned int n_points)
    : scene_(scene)
    , kinks_(kinks)
    , cell_values_(space.mesh().mapping(), space.element(), kinks, n_points, flags())
    , face_values_(space.mesh().mapping(), space.element(), n_points, flags())
    , value_(dim)
  {
  }

  /** Adds to @p vector and to the resultant. */
  void add(const typename FaceValues<dim>::CellIterator &cell, dealii::Vector<double> &vector)
  {
    if (scene_.body_force != nullptr)
      add_force(cell_values_.reinit(cell), *scene_.body_force, "Load/Body force", vector);
    if (!cell->at_boundary())
      return;
    for (const unsigned int f : cell->face_indices())
    {
      if (!cell->face(f)->at_boundary())
        continue;
      const BoundaryCondition<dim> &condition = scene_.boundary[cell->face(f)->boundary_id()];
      if (condition.role != Role::traction)
        continue;
      const auto cuts = kinks_.cut(cell->face(f)->vertex(0), cell->face(f)->vertex(1));
      add_force(face_values_.reinit(cell, f, cuts), *condition.data, "Boundary/Traction", vector);
    }
  }

  const Resultant<dim> &resultant() const
  {
    return resultant_;
  }

private:
  static dealii::UpdateFlags flags()
  {
    return dealii::update_values | dealii::update_quadrature_points | dealii::update_JxW_values;
  }

  /** vector_i += sum_q force(x_q).phi_i(x_q) JxW_q. */
  void add_force(const dealii::FEValuesBase<dim> &values,
                 const dealii::Function<dim> &force,
                 const char *name,
                 dealii::Vector<double> &vector)
  {
    const auto &element = values.get_fe();
    for (const unsigned int q : values.quadrature_point_indices())
    {
      const dealii::Point<dim> &x = values.quadrature_point(q);
      force.vector_value(x, value_);
      check_finite(x, name);
      dealii::Tensor<1, dim> weighted;
      for (unsigned int d = 0; d < dim; ++d)
        weighted[d] = value_[d] * values.JxW(q);
      resultant_.add(weighted, x);
      for (unsigned int i = 0; i < vector.size(); ++i)
        vector[i] +=
          weighted[element.system_to_component_index(i).first] * values.shape_value(i, q);
    }
  }

  void check_finite(const dealii::Point<dim> &x, const char *name) const
  {
    for (const double component : value_)
      if (!std::isfinite(component))
      {
        std::ostringstream message;
        message << name << ": found the value " << component << " at (" << x
                << "), allowed: finite values on the whole body.";
        throw InputError(message.str());
      }
  }

  const Scene<dim> &scene_;
  const Kinks<dim> &kinks_;
  CellValues<dim> cell_values_;
  FaceValues<dim> face_values_;
  dealii::Vector<double> value_;
  Resultant<dim> resultant_;
};

template <int dim>
Resultant<dim> sum_over_ranks(const Resultant<dim> &part, MPI_Comm communicator)
{
  Resultant<dim> sum;
  sum.force = dealii::Utilities::MPI::sum(part.force, communicator);
  sum.moment = dealii::Utilities::MPI::sum(part.moment, communicator);
  return sum;
}
} // namespace

template <int dim>
LinearSystem<dim> assemble_linear_system(const DisplacementSpace<dim> &space,
                                         const Scene<dim> &scene,
                                         const unsigned int n_points)
{
  const MPI_Comm communicator = space.mesh().communicator();
  const Kinks<dim> kinks = Kinks<dim>::of_scene(scene);
  CellStiffness<dim> stiffness(space, *scene.material, kinks);
  CellLoads<dim> cell_loads(space, scene, kinks, n_points);
  LinearSystem<dim> system = {make_matrix(space), space.make_vector(), space.make_vector(), {}};
  const unsigned int n = space.element().n_dofs_per_cell();
  dealii::Vector<double> cell_f(n);
  std::vector<dealii::types::global_dof_index> indices(n);
  agree(communicator, [&]() {
    for (const auto &cell : space.dofs().active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cell_f = 0.;
        cell_loads.add(cell, cell_f);
        cell->get_dof_indices(indices);
        space.constraints().distribute_local_to_global(
          stiffness(cell), cell_f, indices, system.A, system.f);
        system.loads.add(indices, cell_f);
      }
  });
  system.A.compress(dealii::VectorOperation::add);
  system.f.compress(dealii::VectorOperation::add);
  system.loads.compress(dealii::VectorOperation::add);
  system.applied = sum_over_ranks(cell_loads.resultant(), communicator);
  return system;
}

template LinearSystem<2> assemble_linear_system(const DisplacementSpace<2> &,
                                                const Scene<2> &,
                                                unsigned int);
} // namespace Signorini
