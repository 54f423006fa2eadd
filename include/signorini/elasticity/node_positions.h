// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>

#include <deal.II/fe/fe_values.h>

#include <memory>
#include <vector>

namespace Signorini
{
/** Where the nodes of a cell lie in space, in the order of the cell's scalar shape functions. */
template <int dim>
class NodePositions
{
public:
  explicit NodePositions(const DisplacementSpace<dim> &space)
    : space_(space)
    , values_(space.elements().size())
  {
  }

  /** Valid until the next call. */
  const std::vector<dealii::Point<dim>> &
  operator()(const typename DisplacementSpace<dim>::CellIterator &cell)
  {
    const unsigned int number = space_.element_number(cell);
    std::unique_ptr<dealii::FEValues<dim>> &values = values_[number];
    if (values == nullptr)
    {
      const dealii::FiniteElement<dim> &element = space_.elements()[number];
      values = std::make_unique<dealii::FEValues<dim>>(
        space_.mesh().mapping(),
        element,
        dealii::Quadrature<dim>(element.base_element(0).get_unit_support_points()),
        dealii::update_quadrature_points);
    }
    values->reinit(cell);
    return values->get_quadrature_points();
  }

private:
  const DisplacementSpace<dim> &space_;
  /** By element. */
  std::vector<std::unique_ptr<dealii::FEValues<dim>>> values_;
};
} // namespace Signorini
