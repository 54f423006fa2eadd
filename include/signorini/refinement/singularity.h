// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/mesh/mesh.h>
#include <signorini/scene/scene.h>

#include <vector>

namespace Signorini
{
/**
 * A place on the boundary next to which u ~ r^lambda: a corner, a kink, or an end of contact. An
 * end of contact is known to lie between two points of a side.
 */
struct Singularity
{
  enum class Kind
  {
    corner,
    /** Where a line of kinks meets a side: a possible end of contact, or the end of an interface.
     */
    kink,
    end_of_contact
  };
  Kind kind;
  /** The corner, the kink, or the middle of the bracket. */
  dealii::Point<2> point;
  /** lambda, as far as it is known. */
  double exponent = 1.;
  /** Of kinks and ends of contact: the side, and the bracket in its arc length (length). */
  unsigned int side = 0;
  double from = 0., to = 0.;
  /** How often the cells at the place are split. */
  double layers = 0.;
  /** Whether the data of the scene says that u is singular here, and not only that it may be. */
  bool is_certain = false;
  /** The indicator of the cells at the place when it had the layers before these; 0: not known. */
  double last_error = 0., last_layers = 0.;

  /** Whether the place lies in the closure of a cell, or a part of the bracket does. */
  bool touches(const Scene<2> &scene,
               const dealii::Triangulation<2>::active_cell_iterator &cell) const;
};

/** Of the singularities with layers the one that is closest to a point, if there is any. */
const Singularity *nearest(const std::vector<Singularity> &singularities,
                           const dealii::Point<2> &x);
} // namespace Signorini
