// SPDX-License-Identifier: LGPL-2.1-or-later
// Distances between interpolations of the nodal values; (24) and (31) make the first an estimate of
// the error of the mesh.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/elasticity/body_measure.h>
#include <signorini/discretization/elasticity/cell_values.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <optional>

namespace Signorini {
namespace {
/** The squares of norms of v - w, of a cell or of the body: of the values, the gradients, and the
 * energy. */
using Squares = Tensor<1, 3>;

/** Integrates v - w, where v is the patch interpolation over @p fine generations and w that over
 * one less. Every chunk of cells has its own object. */
template <int dim>
class Distance {
public:
  using CellIterator = typename DoFHandler<dim>::active_cell_iterator;

  // Products of functions of degree two or four per direction: three or five points are exact on
  // parallelograms.
  Distance(const DisplacementSpace<dim> &space, const Scene<dim> *const scene,
           const Displacement &U, const unsigned int fine)
    : scene_(scene)
    , U_(U)
    , values_(space.mesh().mapping(), space.element(),
              QGauss<dim>((space.element().degree << fine) + 1),
              update_values | update_gradients | update_inverse_jacobians | update_JxW_values |
                update_quadrature_points)
    , v_(space, values_.get_quadrature(), fine)
    , w_(space, values_.get_quadrature(), fine - 1) {
    if (scene != nullptr)
      energy_.emplace(*scene);
  }
  Squares integrate(const CellIterator &cell) {
    values_.reinit(cell);
    const FieldValues<dim> &v = v_.evaluate(U_, cell, values_);
    const FieldValues<dim> &w = w_.evaluate(U_, cell, values_);
    Squares sum;
    for (const unsigned int q : values_.quadrature_point_indices()) {
      const Tensor<2, dim> gradient = v.gradients[q] - w.gradients[q];
      const Tensor<1, dim> value = v.values[q] - w.values[q];
      const Point<dim> &x = values_.quadrature_point(q);
      Squares squares({value.norm_square(), gradient.norm_square(), 0.});
      if (scene_ != nullptr) {
        squares[1] = gradient_square(scene_->geometry, x, value, gradient);
        squares[2] = energy_->at(x).density(value, gradient);
      }
      sum += measure_at(values_, q) * squares;
    }
    return sum;
  }

private:
  /** Null, and empty, if energies are not wanted. */
  const Scene<dim> *const scene_;
  std::optional<EnergyMeasure<dim>> energy_;
  const Displacement &U_;
  FEValues<dim> values_;
  PatchInterpolation<dim> v_, w_;
};

/** Returns the sums over all ranks; the parts of the threads are added up in the order of cells. */
template <int dim>
Squares integrate(const DisplacementSpace<dim> &space, const Scene<dim> *const scene,
                  const Displacement &U, const unsigned int fine) {
  Squares sum;
  integrate_by_chunks<Squares, dim>(
    space,
    [&](const Cells<dim> &cells) {
      Distance<dim> distance(space, scene, U, fine);
      Squares chunk_result;
      for (const auto &cell : cells)
        chunk_result += distance.integrate(cell);
      return chunk_result;
    },
    [&sum](const Squares &chunk_result) { sum += chunk_result; });
  return Utilities::MPI::sum(sum, space.mesh().communicator());
}

/** Returns ‖.‖_1 with lengths in the given unit, up to that unit's own power. */
double norm_1(const Squares &squares, const double unit_of_length) {
  return std::sqrt(squares[0] / (unit_of_length * unit_of_length) + squares[1]);
}
} // namespace

template <int dim>
ErrorEstimate estimate_error(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                             const Displacement &U, const EnergyScale &scale,
                             const PressureCorrection &correction, const OtherErrors &others) {
  const Squares u_h_squares = integrate(space, &scene, U, 1);
  double mesh_square = u_h_squares[2];
  if (correction.z.size() > 0) {
    Displacement corrected(U);
    corrected += correction.z;
    mesh_square = integrate(space, &scene, corrected, 1)[2];
  }
  ErrorEstimate estimate;
  estimate.h1 = norm_1(u_h_squares, 1.);
  estimate.mesh = std::sqrt(mesh_square);
  estimate.pressure = correction.energy_norm;
  estimate.algebra = others.algebra;
  estimate.contact = others.contact;
  estimate.energy = std::hypot(std::sqrt(mesh_square), correction.energy_norm);
  estimate.energy = std::hypot(estimate.energy, others.algebra, others.contact);
  if (estimate.energy > 0.)
    estimate.relative = estimate.energy / scale.of(estimate.energy);
  return estimate;
}

template <int dim>
unsigned int best_interpolation(const DisplacementSpace<dim> &space, const Displacement &U) {
  if (space.mesh().n_nested_ancestors() < 2)
    return space.mesh().n_nested_ancestors();
  const auto change = [&](const unsigned int fine) {
    return norm_1(integrate<dim>(space, nullptr, U, fine), space.mesh().size());
  };
  return change(2) < 2. / 3. * change(1) ? 2 : 1;
}

Columns<ErrorEstimate> ErrorEstimate::columns() {
  return {{"estimated_h1", &ErrorEstimate::h1},
          {"estimated_energy", &ErrorEstimate::energy},
          {"estimated_relative", &ErrorEstimate::relative},
          {"estimated_mesh", &ErrorEstimate::mesh},
          {"estimated_pressure", &ErrorEstimate::pressure},
          {"estimated_algebra", &ErrorEstimate::algebra},
          {"estimated_contact", &ErrorEstimate::contact}};
}

INSTANTIATE_FUNCTION(estimate_error);
INSTANTIATE_FUNCTION(best_interpolation);
} // namespace Signorini
