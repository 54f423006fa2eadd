// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement, strain and measure at points of cells, and the samples of a solution.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/cell_evaluator.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/filtered_iterator.h>

#include <cmath>
#include <map>

namespace Signorini {
template <int dim>
CellEvaluator<dim>::CellEvaluator(const DisplacementSpace<dim> &space,
                                  std::vector<EvaluatedField> fields, Rule rule, Map map,
                                  const bool measures)
  : space_(space)
  , fields_(std::move(fields))
  , rule_(std::move(rule))
  , map_(std::move(map))
  , by_cells_(space.mesh().is_graded() || space.has_several_elements())
  , maps_(update_inverse_jacobians | update_quadrature_points |
            (measures ? update_JxW_values : update_default),
          rule_)
  , cell_fields_(fields_.size())
  , fields_at_points_(fields_.size()) {
  for ([[maybe_unused]] const EvaluatedField &field : fields_)
    Assert(!by_cells_ || (dim == 2 && field.n_generations == 0),
           ExcMessage("cells of several degrees have no patch interpolation"));
}

template <int dim>
typename CellEvaluator<dim>::Tables
CellEvaluator<dim>::make_tables(const Quadrature<dim> &rule) const {
  Tables tables;
  if constexpr (dim == 2)
    if (by_cells_) {
      tables.rule.emplace(rule);
      return tables;
    }
  tables.patches.reserve(fields_.size());
  for (const EvaluatedField &field : fields_)
    tables.patches.emplace_back(space_, *field.U, rule, field.n_generations);
  return tables;
}

template <int dim>
void CellEvaluator<dim>::reinit(const Cell &cell, const unsigned int rule_number) {
  const auto found = tables_.find(rule_number);
  Tables &tables = found != tables_.end()
                     ? found->second
                     : tables_.emplace(rule_number, make_tables(rule_(rule_number))).first->second;
  map_values_ = &maps_.reinit(map_ ? map_(cell) : space_.mesh().mapping(), no_functions_,
                              rule_number, typename Triangulation<dim>::cell_iterator(cell));
  evaluate(cell, tables);
}

template <int dim>
void CellEvaluator<dim>::reinit_once(const Cell &cell, const Quadrature<dim> &rule) {
  map_once_ = std::make_unique<FEValues<dim>>(map_ ? map_(cell) : space_.mesh().mapping(),
                                              no_functions_, rule, maps_.flags());
  map_once_->reinit(typename Triangulation<dim>::cell_iterator(cell));
  map_values_ = map_once_.get();
  if (by_cells_ || tables_once_.patches.empty())
    tables_once_ = make_tables(by_cells_ ? rule : Quadrature<dim>());
  evaluate(cell, tables_once_);
}

template <int dim>
void CellEvaluator<dim>::evaluate(const Cell &cell, Tables &tables) {
  cell_ = cell;
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    if constexpr (dim == 2)
      if (by_cells_) {
        cell_fields_[k] = tables.rule->evaluate(CellField(cell, *fields_[k].U));
        fields_at_points_[k] = &cell_fields_[k];
        continue;
      }
    fields_at_points_[k] =
      &tables.patches[k].on_reference_cell(cell, map_values_->get_quadrature().get_points());
  }
}

namespace {
/** Returns the middle of the reference cell and the corners, or the nodes of an element of several.
 */
template <int dim>
Quadrature<dim> middle_and_nodes(const DisplacementSpace<dim> &space, const unsigned int number) {
  std::vector<Point<dim>> points =
    space.has_several_elements()
      ? space.elements()[number].base_element(0).get_unit_support_points()
      : FE_Q<dim>(1).get_unit_support_points();
  points.insert(points.begin(), QMidpoint<dim>().point(0));
  return Quadrature<dim>(points);
}
} // namespace

template <int dim>
std::vector<double> mean_dilatations(const DisplacedBody<dim> &body) {
  const DisplacementSpace<dim> &space = body.space;
  CellEvaluator<dim> u(space, {{&body.U}});
  /** The integral and the volume of a parent, or of a cell. */
  std::map<std::pair<int, int>, std::pair<double, double>> sums;
  const auto sums_of = [&](const auto &cell) -> std::pair<double, double> & {
    const bool by_parent = space.mesh().has_parents();
    return sums[{cell->level(), by_parent ? cell->parent_index() : cell->index()}];
  };
  for (const auto &cell :
       space.dofs().active_cell_iterators() | IteratorFilters::LocallyOwnedCell()) {
    u.reinit(cell, 2);
    for (unsigned int q = 0; q < u.size(); ++q) {
      const Strain<dim> strain =
        strain_at(body.scene.geometry, u.points()[q], u.value(q), u.gradient(q));
      sums_of(cell).first += strain.trace() * u.measure(q);
      sums_of(cell).second += u.measure(q);
    }
  }
  std::vector<double> means(space.mesh().triangulation().n_active_cells());
  for (const auto &cell :
       space.dofs().active_cell_iterators() | IteratorFilters::LocallyOwnedCell())
    means[cell->active_cell_index()] = sums_of(cell).first / sums_of(cell).second;
  return means;
}

template <int dim>
SampledField<dim>::SampledField(const DisplacedBody<dim> &body)
  : DisplacedBody<dim>(body)
  , dilatation(body.space.strain_operator() == StrainOperator::mean_dilatation
                 ? mean_dilatations(body)
                 : std::vector<double>()) {}

template <int dim>
CellEvaluator<dim> SampledField<dim>::at_nodes() const {
  const DisplacementSpace<dim> &space = this->space;
  return CellEvaluator<dim>(
    space, {{&this->U, space.mesh().has_parents() ? 1U : 0U}},
    [&space](const unsigned int number) { return middle_and_nodes(space, number); }, {}, false);
}

template <int dim>
FieldSample<dim> SampledField<dim>::sample(const CellEvaluator<dim> &u, const unsigned int q,
                                           const unsigned int k) const {
  const Point<dim> &x = u.points()[q];
  const Tensor<2, dim> gradient = u.gradient(q, k);
  Strain<dim> strain = strain_at(this->scene.geometry, x, u.value(q, k), gradient);
  if (!dilatation.empty())
    strain.replace_trace(dilatation[u.cell()->active_cell_index()]);
  return {x, u.unit_point(q), u.value(q, k), strain,
          (gradient - transpose(gradient)).norm() / std::sqrt(8.)};
}

template <int dim>
void SampledField<dim>::sample(const CellEvaluator<dim> &u,
                               std::vector<FieldSample<dim>> &samples) const {
  samples.clear();
  for (unsigned int q = 0; q < u.size(); ++q)
    samples.push_back(sample(u, q));
}

template class CellEvaluator<2>;
template class CellEvaluator<3>;
INSTANTIATE_FUNCTION(mean_dilatations);
template struct SampledField<2>;
template struct SampledField<3>;
} // namespace Signorini
