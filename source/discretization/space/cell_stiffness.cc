// SPDX-License-Identifier: LGPL-2.1-or-later
// a(u,v) = ∫ E_ijkl u_{k,l} v_{i,j}, cell by cell.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/body_measure.h>
#include <signorini/discretization/space/cell_stiffness.h>

#include <algorithm>
#include <limits>

namespace Signorini {
namespace {
const UpdateFlags stiffness_flags = update_gradients | update_quadrature_points | update_JxW_values;

/** Returns the strain of a shape function at a point of a cell of the body of size one. */
template <int dim>
Strain<dim> shape_strain(const Mesh<dim> &mesh, const FEValues<dim> &values, const unsigned int i,
                         const unsigned int q) {
  const FEValuesExtractors::Vector displacement(0);
  Strain<dim> strain = {values[displacement].symmetric_gradient(i, q)};
  if (mesh.is_axisymmetric())
    strain.hoop = values[displacement].value(i, q)[0] * mesh.size() /
                  mesh.from_unit_body(values.quadrature_point(q))[0];
  return strain;
}

/** The data of integrals over a mesh. */
template <int dim>
UpdateFlags flags_on(const Mesh<dim> &mesh) {
  return mesh.is_axisymmetric() ? stiffness_flags | update_values : stiffness_flags;
}

/** Returns ∫_K div φ_i / |K| for all i. */
template <int dim>
std::vector<double> mean_divergences(const Mesh<dim> &mesh, const FEValues<dim> &values) {
  std::vector<double> means(values.dofs_per_cell, 0.);
  double volume = 0.;
  for (const unsigned int q : values.quadrature_point_indices()) {
    volume += measure_at(values, q);
    for (unsigned int i = 0; i < means.size(); ++i)
      means[i] += shape_strain(mesh, values, i, q).trace() * measure_at(values, q);
  }
  for (double &mean : means)
    mean /= volume;
  return means;
}
} // namespace

template <int dim>
bool is_affine(const typename Triangulation<dim>::cell_iterator &cell) {
  const double size = cell->vertex(cell->n_vertices() - 1).distance(cell->vertex(0));
  for (const unsigned int v : cell->vertex_indices()) {
    Tensor<1, dim> difference = cell->vertex(v) - cell->vertex(0);
    for (unsigned int d = 0; d < dim; ++d)
      if (((v >> d) & 1U) != 0)
        difference -= cell->vertex(1U << d) - cell->vertex(0);
    if (!(difference.norm() < 1e-12 * size))
      return false;
  }
  return true;
}

template <int dim>
CellStiffness<dim>::CellStiffness(const DisplacementSpace<dim> &space, const Scene<dim> &scene)
  : space_(space)
  , mesh_(space.mesh())
  , material_(*scene.material)
  , strain_operator_(space.strain_operator())
  , constant_(material_.is_constant())
  , kinks_(scene.law_kinks)
  , affine_values_(mesh_.unit_mapping(), space, kinks_, 2, flags_on(mesh_))
  , values_(mesh_.unit_mapping(), space, kinks_,
            mesh_.is_axisymmetric() ? 3 : n_stiffness_points<dim>(constant_), flags_on(mesh_)) {}

template <int dim>
typename CellStiffness<dim>::Matrix CellStiffness<dim>::integrate(const CellIterator &cell) {
  // Fewer points are exact for a constant tensor where edges are parallel.
  const bool axisymmetric = mesh_.is_axisymmetric();
  const bool is_exact = constant_ && !axisymmetric && !mesh_.is_curved() && is_affine<dim>(cell);
  const FEValues<dim> &values = (is_exact ? affine_values_ : values_).reinit(cell);
  constexpr unsigned int n_in_body = SymmetricTensor<2, dim>::n_independent_components;
  const unsigned int n_strains = n_in_body + (axisymmetric ? 1 : 0);
  const unsigned int n = values.dofs_per_cell;
  const std::vector<double> mean_dilatation = strain_operator_ == StrainOperator::mean_dilatation
                                                ? mean_divergences(mesh_, values)
                                                : std::vector<double>();
  const auto law_at = [&](const unsigned int q) {
    const Point<dim> x = mesh_.from_unit_body(values.quadrature_point(q));
    return HookesLaw<dim>{material_.relative_hooke(x),
                          axisymmetric ? material_.relative_across(x) : AcrossLaw<dim>()};
  };
  HookesLaw<dim> law = law_at(0);
  // With a row for every point and component, the sum over both is a product of matrices.
  strains_.reinit(values.n_quadrature_points * n_strains, n);
  stresses_.reinit(values.n_quadrature_points * n_strains, n);
  for (const unsigned int q : values.quadrature_point_indices()) {
    if (!constant_)
      law = law_at(q);
    for (unsigned int i = 0; i < n; ++i) {
      Strain<dim> strain = shape_strain(mesh_, values, i, q);
      if (!mean_dilatation.empty())
        strain.replace_trace(mean_dilatation[i]);
      const SymmetricTensor<2, dim> stress = measure_at(values, q) * law.stress(strain);
      for (unsigned int c = 0; c < n_in_body; ++c) {
        // Off the diagonal a component stands for two.
        strains_(q * n_strains + c, i) = (c < dim ? 1. : 2.) * strain.in_body.access_raw_entry(c);
        stresses_(q * n_strains + c, i) = stress.access_raw_entry(c);
      }
      if (axisymmetric) {
        strains_(q * n_strains + n_in_body, i) = *strain.hoop;
        stresses_(q * n_strains + n_in_body, i) = measure_at(values, q) * law.stress_across(strain);
      }
    }
  }
  const auto matrix = std::make_shared<FullMatrix<double>>(n, n);
  strains_.Tmmult(*matrix, stresses_);
  return matrix;
}

template <int dim>
typename CellStiffness<dim>::Matrix CellStiffness<dim>::share(const CellIterator &cell) {
  // Vertices do not determine the shape of a curved cell; distances from an axis matter.
  if (!constant_ || mesh_.is_curved() || mesh_.is_axisymmetric())
    return integrate(cell);
  Sample sample = {space_.element_number(cell), {}, nullptr};
  const double size = cell->vertex(cell->n_vertices() - 1).distance(cell->vertex(0));
  for (const unsigned int v : cell->vertex_indices())
    sample.shape[v] = (cell->vertex(v) - cell->vertex(0)) / (dim == 2 ? size : mesh_.size());
  // The coordinates of small cells far from the origin determine their shape less accurately.
  const double tolerance =
    std::max(1e-12, 16. * std::numeric_limits<double>::epsilon() * cell->vertex(0).norm() / size) *
    sample.shape.back().norm();
  for (const Sample &known : samples_)
    if (known.element_number == sample.element_number &&
        std::equal(known.shape.begin(), known.shape.end(), sample.shape.begin(),
                   [&](const auto &a, const auto &b) { return (a - b).norm() <= tolerance; }))
      return known.matrix;
  sample.matrix = integrate(cell);
  constexpr std::size_t max_samples = 64;
  if (samples_.size() < max_samples)
    samples_.push_back(sample);
  return sample.matrix;
}

INSTANTIATE_FUNCTION(is_affine);
template class CellStiffness<2>;
template class CellStiffness<3>;
} // namespace Signorini
