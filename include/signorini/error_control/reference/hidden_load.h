// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/displacement_space.h>

#include <deal.II/base/bounding_box.h>

#include <vector>

namespace Signorini {
/**
 * The distance of the body force f from f̃, the force at the points of rules. In each of the
 * smallest boxes of the scan in which f still varies faster than a rule shows, both are between the
 * bounds of f. There |f - f̃| is at most their distance, elsewhere it is zero.
 */
class HiddenLoad {
public:
  /** The scene must outlive the object. */
  explicit HiddenLoad(const Scene<2> &scene);

  /** Returns a bound of ∫ (|f_1 - f̃_1| + |f_2 - f̃_2|) (force per thickness). */
  double force() const {
    return forces_[0];
  }
  /** Returns a bound of |∫ (f - f̃).u_h|. Let c be the mean of the nodal values of a component on a
   * cell: |u_i - c| is at most the root of the sum of squares of theirs, as the squares of
   * Lagrange's polynomials at the points of Gauss and Lobatto have a sum of at most one (L. Fejér,
   * Math. Ann. 106 (1932) 1-55). */
  double work(const DisplacementSpace<2> &space, const Displacement &U) const;

private:
  /** Adds up the forces in the boxes below a node. */
  double add_forces(unsigned int node, const BoundingBox<2> &box);
  /** Returns a bound of the force in the part of a box that is in the box of a node. */
  double force_in(const BoundingBox<2> &part, unsigned int node, const BoundingBox<2> &box) const;

  const BoxTree &boxes_;
  const BoundingBox<2> body_;
  /** By node of the tree. */
  std::vector<double> forces_;
};
} // namespace Signorini
