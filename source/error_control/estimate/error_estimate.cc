// SPDX-License-Identifier: LGPL-2.1-or-later
// Distances between interpolations of the nodal values; (24) and (31) make the first an estimate of
// the error of the mesh.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/body_measure.h>
#include <signorini/discretization/space/cell_values.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace Signorini {
namespace {
/** The squares of norms of v - w, of a cell or of the body: of the values and the gradients of the
 * first displacement, and the energy of the last. */
using Squares = Tensor<1, 3>;

/** Integrates v - w, where v is the patch interpolation over @p fine generations and w that over
 * one less. Every chunk of cells has its own object. */
template <int dim>
class Distance {
public:
  using CellIterator = typename DoFHandler<dim>::active_cell_iterator;

  // Three points are exact on parallelograms for products of functions of degree two per direction.
  // Those of degree four are smooth on a quarter of their length, and only compared.
  Distance(const DisplacementSpace<dim> &space, const Scene<dim> *const scene,
           const std::vector<const Displacement *> &displacements, const unsigned int fine)
    : scene_(scene)
    , map_(space.mesh().mapping(), no_element_, QGauss<dim>(2 * space.element().degree + 1),
           update_inverse_jacobians | update_JxW_values | update_quadrature_points) {
    if (scene != nullptr)
      energy_.emplace(*scene);
    for (const Displacement *const U : displacements)
      for (const unsigned int generations : {fine, fine - 1})
        fields_.emplace_back(space, *U, map_.get_quadrature(), generations);
  }
  Squares integrate(const CellIterator &cell) {
    map_.reinit(typename Triangulation<dim>::cell_iterator(cell));
    Squares sum;
    for (std::size_t k = 0; 2 * k < fields_.size(); ++k) {
      const FieldValues<dim> &v = fields_[2 * k].on_reference_cell(cell),
                             &w = fields_[2 * k + 1].on_reference_cell(cell);
      for (const unsigned int q : map_.quadrature_point_indices())
        add(k, q, v.values[q] - w.values[q],
            (v.gradients[q] - w.gradients[q]) * Tensor<2, dim>(map_.inverse_jacobian(q)), sum);
    }
    return sum;
  }

private:
  /** Adds what a point contributes to the integrals of a displacement. */
  void add(const unsigned int k, const unsigned int q, const Tensor<1, dim> &value,
           const Tensor<2, dim> &gradient, Squares &sum) {
    const Point<dim> &x = map_.quadrature_point(q);
    const double dx = measure_at(map_, q);
    if (k == 0) {
      sum[0] += value.norm_square() * dx;
      sum[1] += (scene_ == nullptr ? gradient.norm_square()
                                   : gradient_square(scene_->geometry, x, value, gradient)) *
                dx;
    }
    if (scene_ != nullptr && 2 * k + 2 == fields_.size())
      sum[2] += energy_->at(x).density(value, gradient) * dx;
  }

  /** Null, and empty, if energies are not wanted. */
  const Scene<dim> *const scene_;
  std::optional<EnergyMeasure<dim>> energy_;
  const FE_Nothing<dim> no_element_;
  FEValues<dim> map_;
  /** v and w of the first displacement, of the second, ... */
  std::vector<PatchInterpolation<dim>> fields_;
};

/** Returns the sums over all ranks; the parts of the threads are added up in the order of cells. */
template <int dim>
Squares integrate(const DisplacementSpace<dim> &space, const Scene<dim> *const scene,
                  const std::vector<const Displacement *> &displacements, const unsigned int fine) {
  Squares sum;
  integrate_by_chunks<Squares, dim>(
    space,
    [&](const Cells<dim> &cells) {
      Distance<dim> distance(space, scene, displacements, fine);
      Squares chunk_result;
      for (const auto &cell : cells)
        chunk_result += distance.integrate(cell);
      return chunk_result;
    },
    [&sum](const Squares &chunk_result) { sum += chunk_result; });
  const ArrayView<double> numbers(sum.begin_raw(), Squares::dimension);
  Utilities::MPI::sum<double>(numbers, space.mesh().communicator(), numbers);
  return sum;
}

/** Returns ‖.‖_1 with lengths in the given unit, up to that unit's own power. */
double norm_1(const Squares &squares, const double unit_of_length) {
  return std::sqrt(squares[0] / (unit_of_length * unit_of_length) + squares[1]);
}
} // namespace

template <int dim>
ErrorEstimate estimate_error(const DisplacedBody<dim> &body, const EnergyScale &scale,
                             const PressureCorrection &correction, const OtherErrors &others) {
  const Displacement &U = body.U;
  const bool is_corrected = correction.z.size() > 0;
  Displacement corrected(U);
  if (is_corrected)
    corrected += correction.z;
  const Squares squares = integrate<dim>(
    body.space, &body.scene,
    is_corrected ? std::vector<const Displacement *>{&U, &corrected} : std::vector{&U}, 1);
  ErrorEstimate estimate;
  estimate.h1 = norm_1(squares, 1.);
  estimate.mesh = std::sqrt(squares[2]);
  estimate.pressure = correction.energy_norm;
  estimate.algebra = others.algebra;
  estimate.contact = others.contact;
  // z_h and the misfit of contact show the same error in two ways.
  estimate.energy = std::hypot(std::sqrt(squares[2]),
                               std::max(correction.energy_norm, others.contact), others.algebra);
  if (estimate.energy > 0.)
    estimate.relative = estimate.energy / scale.of(estimate.energy);
  return estimate;
}

template <int dim>
unsigned int best_interpolation(const DisplacementSpace<dim> &space, const Displacement &U) {
  if (space.mesh().n_nested_ancestors() < 2)
    return space.mesh().n_nested_ancestors();
  const auto change = [&](const unsigned int fine) {
    return norm_1(integrate<dim>(space, nullptr, {&U}, fine), space.mesh().size());
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
