// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/displacement_space.h>
#include <signorini/problem/scene/functions.h>

#include <deal.II/base/function.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/hp/mapping_collection.h>
#include <deal.II/hp/q_collection.h>

#include <vector>

namespace Signorini {
/** The positions of the nodes of a cell, in the order of the cell's scalar shape functions. */
template <int dim>
class NodePositions {
public:
  explicit NodePositions(const DisplacementSpace<dim> &space)
    : mappings_(space.mesh().mapping())
    , values_(mappings_, space.elements(), nodes_of(space.elements()), update_quadrature_points) {}

  /** Returns the positions, valid until the next call. */
  const std::vector<Point<dim>> &
  operator()(const typename DoFHandler<dim>::active_cell_iterator &cell) {
    values_.reinit(cell);
    return values_.get_present_fe_values().get_quadrature_points();
  }

private:
  static hp::QCollection<dim> nodes_of(const hp::FECollection<dim> &elements) {
    hp::QCollection<dim> nodes;
    for (unsigned int number = 0; number < elements.size(); ++number)
      nodes.push_back(Quadrature<dim>(elements[number].base_element(0).get_unit_support_points()));
    return nodes;
  }

  const hp::MappingCollection<dim> mappings_;
  hp::FEValues<dim> values_;
};

/** Returns I^h u: the values of u at the nodes of V^h, all of them on every rank. */
template <int dim>
Displacement interpolate_at_nodes(const DisplacementSpace<dim> &space, const Function<dim> &u);

/** Returns the same for functions by body, of which bodies that touch have several at a point. */
template <int dim>
Displacement interpolate_by_body(const DisplacementSpace<dim> &space,
                                 const std::vector<FieldFunction<dim>> &u);
} // namespace Signorini
