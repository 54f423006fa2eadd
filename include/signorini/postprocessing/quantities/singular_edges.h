// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/displaced_body.h>
#include <signorini/postprocessing/quantities/answer_vector.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/problem/scene/wedges.h>

#include <boost/serialization/vector.hpp>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace Signorini {
/** An edge where stresses grow without limit, for records. */
struct GrowthEdge {
  /** The ends of an edge of a 3-D body; equal for a corner of a 2-D body. */
  std::array<AnswerVector, 2> ends;
  /** The distance from which on largest values elsewhere are taken (length). */
  double radius = 0.;
  /** The stress grows like r^{exponent - 1}. */
  double exponent = 1.;

  template <typename Archive>
  void serialize(Archive &archive, const unsigned int /*version*/) {
    for (AnswerVector &end : ends)
      archive &static_cast<std::vector<double> &>(end);
    archive &radius &exponent;
  }
};

/** A corner of a 2-D body, the point of another body across from one, an end of an interface of
 * materials on its boundary, or an edge of a body in space, at which stresses behave like r^{λ - 1}
 * with λ < 1 (corner_exponent()) in at least one state of contact. */
template <int dim>
struct SingularEdge {
  /** The ends of the edge; equal in 2-D. */
  std::array<Point<dim>, 2> ends;
  std::array<unsigned int, 2> sides;
  /** The materials about it. */
  std::vector<WedgeLayer> layers;
  /** A tenth of the shortest side that meets here, or of the distance to the next corner where that
   * is shorter (length). It is the same on all levels. */
  double radius;
  /** Returns the exponent of two elastic bodies that press each other here in a state of contact;
   * empty where there is one body. */
  std::function<double(const EdgeCondition &)> of_pair = {};

  /** Returns the point of the edge that is nearest to @p x. */
  Point<dim> nearest(const Point<dim> &x) const;
  bool contains(const Point<dim> &x) const {
    return nearest(x).distance(x) < radius;
  }
};

/** Returns the singular edges. There are none where the exact solution is known: it may be smooth
 * at every corner. Across an edge in space the exponent is that of plane strain. */
std::vector<SingularEdge<2>> singular_edges(const Scene<2> &scene);
std::vector<SingularEdge<3>> singular_edges(const Scene<3> &scene);

/** Returns whether @p x lies at one of the edges. */
template <int dim>
bool any_contains(const std::vector<SingularEdge<dim>> &edges, const Point<dim> &x);

/** Returns the edge where a value at @p x is part of unlimited growth: @p x lies next to it, and
 * the state of contact there makes λ < 1. The result is empty if there is none. */
template <int dim>
std::optional<GrowthEdge> growth_at(const Point<dim> &x,
                                    const std::vector<SingularEdge<dim>> &edges,
                                    const BodyInContact<dim> &body);

} // namespace Signorini
