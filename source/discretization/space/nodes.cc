// SPDX-License-Identifier: LGPL-2.1-or-later
// I^h: interpolation at the nodes of V^h.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/nodes.h>

#include <deal.II/numerics/vector_tools_interpolate.h>

namespace Signorini {
template <int dim>
Displacement interpolate_at_nodes(const DisplacementSpace<dim> &space, const Function<dim> &u) {
  Displacement values = space.zero();
  values.zero_out_ghost_values();
  VectorTools::interpolate(space.mesh().mapping(), space.dofs(), u, values.entries());
  values.update_ghost_values();
  return values;
}

template <int dim>
Displacement interpolate_by_body(const DisplacementSpace<dim> &space,
                                 const std::vector<FieldFunction<dim>> &u) {
  Displacement values = space.zero();
  values.zero_out_ghost_values();
  std::map<types::material_id, const Function<dim> *> by_body;
  for (std::size_t b = 0; b < u.size(); ++b)
    by_body[b] = &u[b];
  VectorTools::interpolate_based_on_material_id(space.mesh().mapping(), space.dofs(), by_body,
                                                values.entries());
  values.update_ghost_values();
  return values;
}

INSTANTIATE_FUNCTION(interpolate_at_nodes);
INSTANTIATE_FUNCTION(interpolate_by_body);
} // namespace Signorini
