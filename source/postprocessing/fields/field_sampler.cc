// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement and strain at points of cells.

#include <signorini/postprocessing/fields/field_sampler.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_q.h>

#include <cmath>

namespace Signorini {
namespace {
const UpdateFlags sample_flags =
  update_values | update_gradients | update_inverse_jacobians | update_quadrature_points;

/** Returns the middle of the reference cell and these nodes. */
template <int dim>
Quadrature<dim> middle_and(std::vector<Point<dim>> nodes) {
  nodes.insert(nodes.begin(), QMidpoint<dim>().point(0));
  return Quadrature<dim>(nodes);
}

/** Returns the middle and the corners, or the nodes of an element of several. */
template <int dim>
Quadrature<dim> points_of(const DisplacementSpace<dim> &space, const unsigned int number) {
  return middle_and(space.has_several_elements()
                      ? space.elements()[number].base_element(0).get_unit_support_points()
                      : FE_Q<dim>(1).get_unit_support_points());
}

template <int dim>
hp::QCollection<dim> all_points(const DisplacementSpace<dim> &space) {
  hp::QCollection<dim> rules;
  for (unsigned int number = 0; number < space.elements().size(); ++number)
    rules.push_back(points_of(space, number));
  return rules;
}
} // namespace

template <int dim>
SampledField<dim>::SampledField(const DisplacedBody<dim> &body)
  : DisplacedBody<dim>(body)
  , dilatation(body.space.strain_operator() == StrainOperator::mean_dilatation
                 ? mean_dilatations(body)
                 : std::vector<double>()) {}

template <int dim>
Strain<dim> SampledField<dim>::strain(const typename DoFHandler<dim>::active_cell_iterator &cell,
                                      const Point<dim> &x, const Tensor<1, dim> &value,
                                      const Tensor<2, dim> &gradient) const {
  Strain<dim> strain = strain_at(this->scene.geometry, x, value, gradient);
  if (!dilatation.empty())
    strain.replace_trace(dilatation[cell->active_cell_index()]);
  return strain;
}

template <int dim>
FieldSampler<dim>::FieldSampler(const SampledField<dim> &field)
  : field_(field)
  , mappings_(field.space.mesh().mapping())
  , elements_(field.space.has_several_elements() ? field.space.elements()
                                                 : hp::FECollection<dim>(FE_Nothing<dim>()))
  , values_by_element_(mappings_, elements_, all_points(field.space), sample_flags) {
  if (!field.space.has_several_elements())
    interpolation_.emplace(field.space, field.U, points_of(field.space, 0),
                           field.space.mesh().has_parents() ? 1 : 0);
}

template <int dim>
const std::vector<FieldSample<dim>> &FieldSampler<dim>::at_nodes(const Cell &cell) {
  if (interpolation_)
    values_by_element_.reinit(typename Triangulation<dim>::cell_iterator(cell));
  else
    values_by_element_.reinit(cell);
  return evaluate(cell, values_by_element_.get_present_fe_values());
}

template <int dim>
FieldSample<dim> FieldSampler<dim>::at(const Cell &cell, const Point<dim> &unit) {
  FEValues<dim> values(mappings_[0], cell->get_fe(), Quadrature<dim>(unit), sample_flags);
  values.reinit(cell);
  return evaluate(cell, values).front();
}

template <int dim>
const std::vector<FieldSample<dim>> &FieldSampler<dim>::evaluate(const Cell &cell,
                                                                 const FEValues<dim> &values) {
  samples_.resize(values.n_quadrature_points);
  if (!interpolation_) {
    at_points_.values.resize(samples_.size());
    at_points_.gradients.resize(samples_.size());
    const auto &u = values[FEValuesExtractors::Vector(0)];
    u.get_function_values(field_.U.entries(), at_points_.values);
    u.get_function_gradients(field_.U.entries(), at_points_.gradients);
  }
  const FieldValues<dim> &u = interpolation_ ? interpolation_->evaluate(cell, values) : at_points_;
  for (unsigned int q = 0; q < samples_.size(); ++q) {
    const Point<dim> &x = values.quadrature_point(q);
    samples_[q] = {x, values.get_quadrature().point(q), u.values[q],
                   field_.strain(cell, x, u.values[q], u.gradients[q]),
                   (u.gradients[q] - transpose(u.gradients[q])).norm() / std::sqrt(8.)};
  }
  return samples_;
}

template struct SampledField<2>;
template struct SampledField<3>;
template class FieldSampler<2>;
template class FieldSampler<3>;
} // namespace Signorini
