// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/displaced_body.h>
#include <signorini/postprocessing/quantities/answer_vector.h>
#include <signorini/postprocessing/quantities/singular_edges.h>

#include <optional>
#include <vector>

namespace Signorini {
/** The largest value of a field, and where it is. */
struct FieldMaximum {
  double value = 0.;
  AnswerVector point;
  /** The cell on which the value was found. */
  MeshAt mesh;

  template <typename Archive>
  void serialize(Archive &archive, const unsigned int /*version*/) {
    archive &value &static_cast<std::vector<double> &>(point) & mesh.size &mesh.degree;
  }
};

/** Takes the larger value; of equals (a symmetric body has some) the one further left, then further
 * down, so that neither ranks nor rounding choose. */
void take_larger(const FieldMaximum &other, FieldMaximum &largest);

/** Returns the size and the degree of a cell, where they differ from cell to cell. */
template <int dim>
MeshAt mesh_at(const DisplacementSpace<dim> &space,
               const typename DoFHandler<dim>::active_cell_iterator &cell) {
  return space.has_several_elements() ? MeshAt{cell->diameter(), cell->get_fe().degree} : MeshAt();
}

/** The largest von Mises stress. */
struct VonMises : FieldMaximum {
  /** The edge where the exact value is infinite, if there is one: the value then depends only on
   * how fine the mesh is. */
  std::optional<GrowthEdge> grows_at;
  /** The largest stress away from all SingularEdge, where there are any. */
  std::optional<FieldMaximum> away;
  /** The share of the body (area, volume) in cells with a principal strain above large_strain in
   * their middle, and that in cells that turn by more than large_rotation there. */
  double strained_share = 0., turned_share = 0.;
};

/** The limit of small strains: theories of small strains err by about as much as the strain. */
constexpr double large_strain = 0.1;
/** The limit of small rotations (radians): one by θ is seen as a strain of θ²/2, and an angle by
 * about θ² too large. */
constexpr double large_rotation = 0.1;

/**
 * Returns the largest stress at the points of SampledField::at_nodes() of every cell. Points at
 * which the material's data has no value are left out. Collective.
 * @param edges away is taken outside of them.
 */
template <int dim>
VonMises largest_von_mises(const DisplacedBody<dim> &body,
                           const std::vector<SingularEdge<dim>> &edges = {});
} // namespace Signorini
