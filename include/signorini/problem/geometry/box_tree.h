// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace Signorini {
/** The line (in 3-D, the plane) normal.x = position, |normal| = 1. */
template <int dim>
struct KinkLine {
  Tensor<1, dim> normal;
  double position;
  /** Whether data of the body changes there, not only that of a side. */
  bool in_body = true;

  /** Returns normal.x - position. */
  double signed_distance(const Point<dim> &x) const {
    return normal * (x - Point<dim>()) - position;
  }
  /** Returns whether another line is the same near a point, up to @p rounding (length). */
  bool coincides(const KinkLine &other, const Point<dim> &x, const double rounding) const {
    const double sign = normal * other.normal < 0. ? -1. : 1.;
    return (normal - sign * other.normal).norm() < 1e-9 &&
           std::abs(signed_distance(x) - sign * other.signed_distance(x)) < rounding;
  }
};

/**
 * The halves of a box, halves of these, and so on, down to boxes in which a few points show the
 * data. It is the whole plane where nothing hides; boxes at the rim have no outer end.
 */
class BoxTree {
public:
  /** In which directions data in a box varies faster than a few points show, whether this
   * variation times the area of the box matters among all of the data, and how far apart the
   * bounds of data are that points do not show. */
  struct View {
    std::array<bool, 2> varies = {{false, false}};
    bool matters = false;
    double hidden = 0.;
  };
  using Look = std::function<View(const BoundingBox<2> &)>;
  using IsSmooth = std::function<bool(const BoundingBox<2> &)>;

  /** A box, and the line that halves it. */
  struct Node {
    KinkLine<2> line;
    /** The part before the line, followed by the one behind it; 0: it is not divided. */
    unsigned int parts = 0;
    /** Whether the data asks for the halves; the first halves are made without asking. */
    bool is_asked_for = false;
    /** Whether data in the box still varies faster than a few points show. */
    bool is_rough = false;
    /** The mean in the box of View::hidden. */
    double hidden = 0.;
  };

  /** The first boxes are 1/4 of the body wide, the smallest 1/4096, or, where their data
   * matters, 6e-8. At most max_deep_looks of them are smaller than 1/4096. */
  static constexpr unsigned int first_halvings = 2, max_halvings = 12, deepest_halvings = 24,
                                max_deep_looks = 4000;
  /** Divides nothing. */
  BoxTree() = default;
  /** @param is_smooth whether points of a box show its data if points of its halves do: bounds may
   * be too far apart in larger boxes. Such halves are joined.
   * @param max_looks the largest number of looks at boxes; those that are left stay whole. */
  BoxTree(const BoundingBox<2> &body, const Look &look, const IsSmooth &is_smooth,
          unsigned int max_looks);

  /** Returns a half of the box of a node. */
  static BoundingBox<2> half_of(const BoundingBox<2> &box, const Node &node, unsigned int half);

  const std::vector<Node> &nodes() const {
    return nodes_;
  }
  /** Returns whether the data asks for a line through the interior of a box. @param skipped the
   * number of halvings that do not count. */
  bool divides(const BoundingBox<2> &box, unsigned int skipped = 0, unsigned int node = 0) const;
  /** Returns whether a few points show the data in one of the smallest boxes that meet a box. */
  bool shows_some(const BoundingBox<2> &box) const;
  /** Returns whether few points do not show it in one of them. */
  bool hides_some(const BoundingBox<2> &box) const;
  /** Returns the number of the smallest boxes that meet a box, at most @p most. */
  unsigned int n_met(const BoundingBox<2> &box, unsigned int most) const;

private:
  /** Returns whether a condition holds for one of the smallest boxes that meet a box. */
  template <typename Condition>
  bool any_met(const BoundingBox<2> &box, unsigned int node, const Condition &holds) const;
  /** Joins halves that nobody asked for, and smooth ones. @return whether others are left. */
  bool join(unsigned int node, const BoundingBox<2> &box, const IsSmooth &is_smooth);

  std::vector<Node> nodes_ = {{}};
};
} // namespace Signorini
