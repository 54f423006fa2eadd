// SPDX-License-Identifier: LGPL-2.1-or-later
// a(u,v) = int E_ijkl u_{k,l} v_{i,j}, cell by cell.

#include <signorini/elasticity/cell_stiffness.h>

namespace Signorini
{
namespace
{
const dealii::UpdateFlags stiffness_flags =
  dealii::update_gradients | dealii::update_quadrature_points | dealii::update_JxW_values;

/** Edges from the first vertex: they tell congruent cells, up to translation. */
template <int dim>
std::vector<dealii::Tensor<1, dim>>
shape_of(const typename dealii::Triangulation<dim>::active_cell_iterator &cell)
{
  std::vector<dealii::Tensor<1, dim>> shape;
  for (const unsigned int v : cell->vertex_indices())
    shape.push_back(cell->vertex(v) - cell->vertex(0));
  return shape;
}

/** int_K div phi_i / |K| for all i. */
template <int dim>
std::vector<double> mean_divergences(const dealii::FEValues<dim> &values)
{
  const dealii::FEValuesExtractors::Vector displacement(0);
  std::vector<double> means(values.dofs_per_cell, 0.);
  double volume = 0.;
  for (const unsigned int q : values.quadrature_point_indices())
  {
    volume += values.JxW(q);
    for (unsigned int i = 0; i < means.size(); ++i)
      means[i] += values[displacement].divergence(i, q) * values.JxW(q);
  }
  for (double &mean : means)
    mean /= volume;
  return means;
}

/** Whether every vertex is the sum of the edges along its coordinates: a parallelogram, in space a
 * parallelepiped. */
template <int dim>
bool is_affine(const std::vector<dealii::Tensor<1, dim>> &shape)
{
  for (unsigned int v = 0; v < shape.size(); ++v)
  {
    dealii::Tensor<1, dim> difference = shape[v];
    for (unsigned int d = 0; d < dim; ++d)
      if (((v >> d) & 1U) != 0)
        difference -= shape[1U << d];
    if (!(difference.norm() < 1e-12 * shape.back().norm()))
      return false;
  }
  return true;
}

/** magnitudes_i = sum_j |K_ij x_j|. */
void multiply_magnitudes(const dealii::FullMatrix<double> &K,
                         const dealii::Vector<double> &x,
                         dealii::Vector<double> &magnitudes)
{
  magnitudes = 0.;
  for (unsigned int i = 0; i < x.size(); ++i)
    for (unsigned int j = 0; j < x.size(); ++j)
      magnitudes[i] += std::abs(K(i, j) * x[j]);
}
} // namespace

template <int dim>
CellStiffness<dim>::CellStiffness(const DisplacementSpace<dim> &space, const Scene<dim> &scene)
  : mesh_(space.mesh())
  , material_(*scene.material)
  , strain_operator_(space.strain_operator())
  , constant_(material_.is_constant())
  , curved_(mesh_.is_curved())
  , kinks_(constant_ ? Kinks<dim>() : scene.kinks)
  , affine_values_(mesh_.unit_mapping(),
                   space.element(),
                   kinks_,
                   space.element().degree + 1,
                   stiffness_flags)
  , general_values_(mesh_.unit_mapping(),
                    space.element(),
                    kinks_,
                    space.element().degree + 3,
                    stiffness_flags)
  , matrix_(space.element().n_dofs_per_cell())
{
}

template <int dim>
bool CellStiffness<dim>::is_congruent(const CellIterator &cell) const
{
  if (!constant_ || curved_ || shape_.empty())
    return false;
  const double size = shape_.back().norm();
  for (const unsigned int v : cell->vertex_indices())
    if ((cell->vertex(v) - cell->vertex(0) - shape_[v]).norm() > 1e-12 * size)
      return false;
  return true;
}

template <int dim>
void CellStiffness<dim>::integrate(const dealii::FEValues<dim> &values)
{
  const dealii::FEValuesExtractors::Vector displacement(0);
  const unsigned int n = values.dofs_per_cell;
  std::vector<dealii::SymmetricTensor<2, dim>> strain(n), stress(n);
  const std::vector<double> mean_dilatation = strain_operator_ == StrainOperator::mean_dilatation
                                                ? mean_divergences(values)
                                                : std::vector<double>();
  const auto hooke_at = [&](const unsigned int q) {
    return material_.relative_hooke(mesh_.from_unit_body(values.quadrature_point(q)));
  };
  dealii::SymmetricTensor<4, dim> hooke = hooke_at(0);
  matrix_ = 0.;
  for (const unsigned int q : values.quadrature_point_indices())
  {
    if (!constant_)
      hooke = hooke_at(q);
    for (unsigned int i = 0; i < n; ++i)
    {
      strain[i] = values[displacement].symmetric_gradient(i, q);
      if (!mean_dilatation.empty())
        replace_trace(strain[i], mean_dilatation[i]);
      stress[i] = hooke * strain[i];
    }
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        matrix_(i, j) += strain[i] * stress[j] * values.JxW(q);
  }
}

template <int dim>
const dealii::FullMatrix<double> &CellStiffness<dim>::operator()(const CellIterator &cell)
{
  if (is_congruent(cell))
    return matrix_;
  shape_ = shape_of<dim>(cell);
  const bool exact_with_few_points = constant_ && !curved_ && is_affine<dim>(shape_);
  integrate((exact_with_few_points ? affine_values_ : general_values_).reinit(cell));
  return matrix_;
}

template <int dim>
InternalForces<dim> internal_forces(const DisplacementSpace<dim> &space,
                                    const Scene<dim> &scene,
                                    const NodalVector &U)
{
  CellStiffness<dim> stiffness(space, scene);
  InternalForces<dim> result = {space.make_vector(), space.make_vector()};
  const unsigned int n = space.element().n_dofs_per_cell();
  dealii::Vector<double> cell_U(n), forces(n), magnitudes(n);
  std::vector<dealii::types::global_dof_index> indices(n);
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell->get_dof_indices(indices);
      cell->get_dof_values(U, cell_U);
      const dealii::FullMatrix<double> &K = stiffness(cell);
      K.vmult(forces, cell_U);
      multiply_magnitudes(K, cell_U, magnitudes);
      result.forces.add(indices, forces);
      result.magnitudes.add(indices, magnitudes);
    }
  for (DistributedVector *const vector : {&result.forces, &result.magnitudes})
  {
    vector->compress(dealii::VectorOperation::add);
    *vector *= stiffness_unit(space, *scene.material);
  }
  return result;
}

template class CellStiffness<2>;
template class CellStiffness<3>;
template InternalForces<2> internal_forces(const DisplacementSpace<2> &,
                                           const Scene<2> &,
                                           const NodalVector &);
template InternalForces<3> internal_forces(const DisplacementSpace<3> &,
                                           const Scene<3> &,
                                           const NodalVector &);
} // namespace Signorini
