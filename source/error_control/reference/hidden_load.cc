// SPDX-License-Identifier: LGPL-2.1-or-later
// The body force between the points of rules.

#include <signorini/error_control/reference/hidden_load.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Signorini {
namespace {
/** Returns the box that contains a cell; its edges may be arcs, which are nowhere farther from
 * their chords than in the middle. */
BoundingBox<2> box_around(const Triangulation<2>::active_cell_iterator &cell) {
  BoundingBox<2> box = cell->bounding_box();
  double height = 0.;
  for (const auto &face : cell->face_iterators())
    height = std::max(height, face->center(true).distance(face->center()));
  box.extend(height);
  return box;
}

/** Returns a bound of |u_1| and |u_2| on a cell. */
double largest_on(const DoFHandler<2>::active_cell_iterator &cell, const Displacement &U) {
  const auto &element = cell->get_fe();
  const unsigned int n = element.n_dofs_per_cell();
  dealii::Vector<double> values(n);
  cell->get_dof_values(U, values);
  const auto component = [&](const unsigned int i) {
    return element.system_to_component_index(i).first;
  };
  std::array<double, 2> means = {{0., 0.}}, squares = means;
  for (unsigned int i = 0; i < n; ++i)
    means[component(i)] += 2. / n * values[i];
  for (unsigned int i = 0; i < n; ++i)
    squares[component(i)] += std::pow(values[i] - means[component(i)], 2);
  return std::max(std::abs(means[0]) + std::sqrt(squares[0]),
                  std::abs(means[1]) + std::sqrt(squares[1]));
}
} // namespace

HiddenLoad::HiddenLoad(const Scene<2> &scene)
  : boxes_(scene.kinks.boxes())
  , body_({scene.geometry.lower, scene.geometry.upper})
  , forces_(boxes_.nodes().size()) {
  add_forces(0, body_);
}

double HiddenLoad::add_forces(const unsigned int node, const BoundingBox<2> &box) {
  const BoxTree::Node &halved = boxes_.nodes()[node];
  double sum = halved.parts == 0 ? box.volume() * halved.hidden : 0.;
  for (unsigned int half = 0; half < 2 && halved.parts != 0; ++half)
    sum += add_forces(halved.parts + half, BoxTree::half_of(box, halved, half));
  return forces_[node] = sum;
}

double HiddenLoad::force_in(const BoundingBox<2> &part, const unsigned int node,
                            const BoundingBox<2> &box) const {
  double share = 1.;
  for (unsigned int d = 0; d < 2; ++d)
    share *= std::max(0., std::min(part.upper_bound(d), box.upper_bound(d)) -
                            std::max(part.lower_bound(d), box.lower_bound(d))) /
             box.side_length(d);
  const BoxTree::Node &halved = boxes_.nodes()[node];
  if (forces_[node] == 0. || share == 0. || halved.parts == 0)
    return share * forces_[node];
  return force_in(part, halved.parts, BoxTree::half_of(box, halved, 0)) +
         force_in(part, halved.parts + 1, BoxTree::half_of(box, halved, 1));
}

double HiddenLoad::work(const DisplacementSpace<2> &space, const Displacement &U) const {
  double sum = 0.;
  if (force() > 0.)
    for (const auto &cell : space.dofs().active_cell_iterators())
      if (const double in_cell = force_in(box_around(cell), 0, body_); in_cell > 0.)
        sum += in_cell * largest_on(cell, U);
  return sum;
}
} // namespace Signorini
