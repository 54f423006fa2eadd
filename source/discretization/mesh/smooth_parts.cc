// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of cells that are as small as the boxes of smooth data in them.

#include <signorini/discretization/mesh/smooth_parts.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace Signorini {
Quadrature<2> SquarePart::rule(const unsigned int n) const {
  constexpr unsigned int least = 4;
  return QGauss<2>(std::max(std::min(n, least), n - std::min(n, halvings)));
}

namespace {
void add_smooth_parts(const BoxTree &boxes, const std::function<Point<2>(const Point<2> &)> &image,
                      const SquarePart &whole, std::vector<SquarePart> &parts) {
  // Four boxes of about its size or larger meet in a part.
  constexpr unsigned int most_boxes = 4;
  std::vector<Point<2>> points;
  for (const double s : {0., 0.5, 1.})
    for (const double t : {0., 0.5, 1.})
      points.push_back(image(whole(Point<2>(s, t))));
  if (whole.halvings == BoxTree::deepest_halvings ||
      boxes.n_met(BoundingBox<2>(points), most_boxes + 1) <= most_boxes) {
    parts.push_back(whole);
    return;
  }
  for (const double t : {0., 0.5})
    for (const double s : {0., 0.5})
      add_smooth_parts(boxes, image, {whole(Point<2>(s, t)), 0.5 * whole.width, whole.halvings + 1},
                       parts);
}
} // namespace

std::vector<SquarePart> smooth_parts(const BoxTree &boxes,
                                     const std::function<Point<2>(const Point<2> &)> &image) {
  std::vector<SquarePart> parts;
  add_smooth_parts(boxes, image, {}, parts);
  return parts;
}
} // namespace Signorini
