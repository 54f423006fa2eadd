// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/mesh.h>

#include <deal.II/fe/mapping_q.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace Signorini {
/** The centres of the circles of those edges of a cell that are arcs. */
using ArcCentres = std::array<std::optional<Point<2>>, 4>;

inline bool has_arcs(const ArcCentres &centres) {
  return centres[0] || centres[1] || centres[2] || centres[3];
}

/** Returns the centres by face of a cell. */
ArcCentres arc_centres(const std::vector<Side<2>> &sides,
                       const Triangulation<2>::cell_iterator &cell);

/**
 * The maps of a mesh, with exact arcs: on each face on an arc, the difference between the arc γ and
 * its map F is added with a linear factor in the depth η, F(ξ, η) + (1 - η) (γ(ξ) - F(ξ, 0)), γ by
 * the angle. All other edges keep their maps, so that functions stay continuous. Polynomials of
 * degree ten leave arcs of up to 45 degrees by 1e-15 of the radius, of 90 degrees by 1e-12.
 */
class ArcMapping : public MappingQ<2> {
public:
  static constexpr unsigned int exact_degree = 10;

  /** The arguments must outlive the object. */
  ArcMapping(const Mapping<2> &mapping, const std::vector<Side<2>> &sides);

  std::unique_ptr<Mapping<2>> clone() const override {
    return std::make_unique<ArcMapping>(mapping_, sides_);
  }

protected:
  std::vector<Point<2>>
  compute_mapping_support_points(const Triangulation<2>::cell_iterator &cell) const override;

private:
  const Mapping<2> &mapping_;
  const std::vector<Side<2>> &sides_;
  std::vector<Point<2>> nodes_;
};

/** The maps of a mesh, and exact ones for its cells with an arc. On graded meshes all curved edges
 * are exact: where nodes hang, two polynomials would leave a gap. */
class ExactMaps {
public:
  /** The arguments must outlive the object. */
  ExactMaps(const Mesh<2> &mesh, const std::vector<Side<2>> &sides);

  /** Returns the map of a cell. */
  const Mapping<2> &of(const Triangulation<2>::cell_iterator &cell) const {
    return exact_ && (mesh_.is_graded() || has_arcs(arc_centres(sides_, cell))) ? *exact_
                                                                                : mesh_.mapping();
  }
  /** Returns a degree of polynomials that contain all maps. */
  unsigned int degree() const {
    return mesh_.is_curved() ? ArcMapping::exact_degree : 1;
  }

private:
  const Mesh<2> &mesh_;
  const std::vector<Side<2>> &sides_;
  std::unique_ptr<const Mapping<2>> exact_;
};
} // namespace Signorini
