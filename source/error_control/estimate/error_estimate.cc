// SPDX-License-Identifier: LGPL-2.1-or-later
// Distances between interpolations of the nodal values; (24) and (31) make the first an estimate of
// the error of the mesh.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/cell_evaluator.h>
#include <signorini/error_control/estimate/error_estimate.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace Signorini {
namespace {
/** The squares of norms of v - w, of a cell or of the body: of the values and the gradients of the
 * first displacement, and the energy of the last; in 2-D the energy of v itself of the first. */
using Squares = Tensor<1, 4>;

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
    , n_displacements_(displacements.size())
    , n_points_(2 * space.element().degree + 1)
    , u_(space, fields_of(displacements, fine)) {
    if (scene != nullptr)
      energy_.emplace(*scene);
  }
  Squares integrate(const CellIterator &cell) {
    u_.reinit(cell, n_points_);
    Squares sum;
    for (unsigned int k = 0; k < n_displacements_; ++k) {
      const FieldValues<dim> &v = u_.on_reference_cell(2 * k), &w = u_.on_reference_cell(2 * k + 1);
      for (unsigned int q = 0; q < u_.size(); ++q)
        add(k, q, v.values[q] - w.values[q], u_.in_body(v.gradients[q] - w.gradients[q], q), sum);
    }
    for (unsigned int q = 0; dim == 2 && q < u_.size() && scene_ != nullptr; ++q)
      sum[3] += energy_->at(u_.points()[q]).density(u_.value(q), u_.gradient(q)) * u_.measure(q);
    return sum;
  }

private:
  /** Returns v and w of the first displacement, of the second, ... */
  static std::vector<EvaluatedField>
  fields_of(const std::vector<const Displacement *> &displacements, const unsigned int fine) {
    std::vector<EvaluatedField> fields;
    for (const Displacement *const U : displacements)
      fields.insert(fields.end(), {{U, fine}, {U, fine - 1}});
    return fields;
  }
  /** Adds the contribution of a point to the integrals of a displacement. */
  void add(const unsigned int k, const unsigned int q, const Tensor<1, dim> &value,
           const Tensor<2, dim> &gradient, Squares &sum) {
    const Point<dim> &x = u_.points()[q];
    const double dx = u_.measure(q);
    if (k == 0) {
      sum[0] += value.norm_square() * dx;
      sum[1] += (scene_ == nullptr ? gradient.norm_square()
                                   : gradient_square(scene_->geometry, x, value, gradient)) *
                dx;
    }
    if (scene_ != nullptr && k + 1 == n_displacements_)
      sum[2] += energy_->at(x).density(value, gradient) * dx;
  }

  /** Null, and empty, if energies are not wanted. */
  const Scene<dim> *const scene_;
  std::optional<EnergyMeasure<dim>> energy_;
  const unsigned int n_displacements_, n_points_;
  CellEvaluator<dim> u_;
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
  if (dim == 2)
    estimate.post_strain = squares[3];
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
