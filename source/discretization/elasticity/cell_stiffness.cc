// SPDX-License-Identifier: LGPL-2.1-or-later
// a(u,v) = ∫ E_ijkl u_{k,l} v_{i,j}, cell by cell.

#include <signorini/discretization/elasticity/cell_stiffness.h>

#include <algorithm>
#include <limits>

namespace Signorini
{
namespace
{
const UpdateFlags stiffness_flags = update_gradients | update_quadrature_points | update_JxW_values;

/** Returns the edges from the first vertex. They are equal for congruent cells, up to translation.
 */
template <int dim>
std::vector<Tensor<1, dim>> shape_of(const typename Triangulation<dim>::active_cell_iterator &cell)
{
  std::vector<Tensor<1, dim>> shape;
  for (const unsigned int v : cell->vertex_indices())
    shape.push_back(cell->vertex(v) - cell->vertex(0));
  return shape;
}

/** Returns ∫_K div φ_i / |K| for all i. */
template <int dim>
std::vector<double> mean_divergences(const FEValues<dim> &values)
{
  const FEValuesExtractors::Vector displacement(0);
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

/** Returns whether every vertex is the sum of the edges along its coordinates: a parallelogram, in
 * 3-D a parallelepiped. */
template <int dim>
bool is_affine(const std::vector<Tensor<1, dim>> &shape, const double tolerance)
{
  for (unsigned int v = 0; v < shape.size(); ++v)
  {
    Tensor<1, dim> difference = shape[v];
    for (unsigned int d = 0; d < dim; ++d)
      if (((v >> d) & 1U) != 0)
        difference -= shape[1U << d];
    if (!(difference.norm() < tolerance * shape.back().norm()))
      return false;
  }
  return true;
}

/** Returns the tolerance relative to the size of a cell: the coordinates of small cells far from
 * the origin determine their shape less accurately. */
double tolerance_of_shapes(const double distance_from_origin, const double size)
{
  return std::max(1e-12,
                  16. * std::numeric_limits<double>::epsilon() * distance_from_origin / size);
}

/** Computes magnitudes_i = Σ_j |K_ij x_j|. */
void multiply_magnitudes(const FullMatrix<double> &K,
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
  : space_(space)
  , mesh_(space.mesh())
  , material_(*scene.material)
  , strain_operator_(space.strain_operator())
  , constant_(material_.is_constant())
  , curved_(mesh_.is_curved())
  , kinks_(constant_ ? Kinks<dim>() : scene.kinks)
  , affine_values_(mesh_.unit_mapping(), space, kinks_, 2, stiffness_flags)
  , general_values_(mesh_.unit_mapping(), space, kinks_, 4, stiffness_flags)
{
}

template <int dim>
const typename CellStiffness<dim>::Sample *
CellStiffness<dim>::find_sample(const unsigned int element_number,
                                const std::vector<Tensor<1, dim>> &shape,
                                const double tolerance) const
{
  const double size = shape.back().norm();
  const auto fits = [&](const Sample &sample) {
    if (sample.element_number != element_number)
      return false;
    for (unsigned int v = 0; v < shape.size(); ++v)
      if ((shape[v] / size - sample.shape[v]).norm() > tolerance)
        return false;
    return true;
  };
  const auto found = std::find_if(samples_.begin(), samples_.end(), fits);
  return found == samples_.end() ? nullptr : &*found;
}

template <int dim>
typename CellStiffness<dim>::Matrix CellStiffness<dim>::integrate(const FEValues<dim> &values)
{
  const FEValuesExtractors::Vector displacement(0);
  constexpr unsigned int n_strains = SymmetricTensor<2, dim>::n_independent_components;
  const unsigned int n = values.dofs_per_cell;
  const std::vector<double> mean_dilatation = strain_operator_ == StrainOperator::mean_dilatation
                                                ? mean_divergences(values)
                                                : std::vector<double>();
  const auto hooke_at = [&](const unsigned int q) {
    return material_.relative_hooke(mesh_.from_unit_body(values.quadrature_point(q)));
  };
  SymmetricTensor<4, dim> hooke = hooke_at(0);
  // With a row for every point and component, the sum over both is a product of matrices.
  strains_.reinit(values.n_quadrature_points * n_strains, n);
  stresses_.reinit(values.n_quadrature_points * n_strains, n);
  for (const unsigned int q : values.quadrature_point_indices())
  {
    if (!constant_)
      hooke = hooke_at(q);
    for (unsigned int i = 0; i < n; ++i)
    {
      SymmetricTensor<2, dim> strain = values[displacement].symmetric_gradient(i, q);
      if (!mean_dilatation.empty())
        replace_trace(strain, mean_dilatation[i]);
      const SymmetricTensor<2, dim> stress = values.JxW(q) * (hooke * strain);
      for (unsigned int c = 0; c < n_strains; ++c)
      {
        // Off the diagonal a component stands for two.
        strains_(q * n_strains + c, i) = (c < dim ? 1. : 2.) * strain.access_raw_entry(c);
        stresses_(q * n_strains + c, i) = stress.access_raw_entry(c);
      }
    }
  }
  const auto matrix = std::make_shared<FullMatrix<double>>(n, n);
  strains_.Tmmult(*matrix, stresses_);
  return matrix;
}

template <int dim>
typename CellStiffness<dim>::Matrix CellStiffness<dim>::share(const CellIterator &cell)
{
  std::vector<Tensor<1, dim>> shape = shape_of<dim>(cell);
  const double size = shape.back().norm();
  const double tolerance = tolerance_of_shapes(cell->vertex(0).norm(), size);
  if (!constant_ || curved_ || !is_affine<dim>(shape, tolerance))
    return integrate(general_values_.reinit(cell));
  const unsigned int element_number = space_.element_number(cell);
  const Sample *const sample = find_sample(element_number, shape, tolerance);
  if (sample != nullptr && (dim == 2 || std::abs(sample->size - size) < 1e-12 * size))
    return sample->matrix;
  Matrix matrix = integrate(affine_values_.reinit(cell));
  constexpr std::size_t max_samples = 64;
  if (sample != nullptr || samples_.size() == max_samples)
    return matrix;
  for (Tensor<1, dim> &edge : shape)
    edge /= size;
  samples_.push_back({element_number, size, shape, matrix});
  return matrix;
}

template <int dim>
InternalForces<dim> internal_forces(const DisplacementSpace<dim> &space,
                                    const Scene<dim> &scene,
                                    const Displacement &U)
{
  CellStiffness<dim> stiffness(space, scene);
  InternalForces<dim> result = {space.make_vector(), space.make_vector()};
  dealii::Vector<double> cell_U, forces, magnitudes;
  std::vector<types::global_dof_index> indices;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const unsigned int n = cell->get_fe().n_dofs_per_cell();
      for (dealii::Vector<double> *const vector : {&cell_U, &forces, &magnitudes})
        vector->reinit(n);
      indices.resize(n);
      cell->get_dof_indices(indices);
      cell->get_dof_values(U, cell_U);
      const FullMatrix<double> &K = stiffness(cell);
      K.vmult(forces, cell_U);
      multiply_magnitudes(K, cell_U, magnitudes);
      result.forces.add(indices, forces);
      result.magnitudes.add(indices, magnitudes);
    }
  for (DistributedVector *const vector : {&result.forces, &result.magnitudes})
  {
    vector->compress(VectorOperation::add);
    *vector *= stiffness_unit(space, *scene.material);
  }
  return result;
}

template class CellStiffness<2>;
template class CellStiffness<3>;
template InternalForces<2> internal_forces(const DisplacementSpace<2> &,
                                           const Scene<2> &,
                                           const Displacement &);
template InternalForces<3> internal_forces(const DisplacementSpace<3> &,
                                           const Scene<3> &,
                                           const Displacement &);
} // namespace Signorini
