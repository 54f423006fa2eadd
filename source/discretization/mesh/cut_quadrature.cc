// SPDX-License-Identifier: LGPL-2.1-or-later
// Quadrature on the pieces into which lines cut cells and faces.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/mesh/cut_quadrature.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace Signorini {
namespace {
/** Returns the part of a convex polygon on one side of a line. */
Polygon clip(const Polygon &polygon, const KinkLine<2> &line, const double sign) {
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point<2> &a = polygon[i];
    const Point<2> &b = polygon[(i + 1) % polygon.size()];
    const double da = sign * line.signed_distance(a);
    const double db = sign * line.signed_distance(b);
    if (da >= 0.)
      part.push_back(a);
    if ((da > 0. && db < 0.) || (da < 0. && db > 0.))
      part.push_back(a + (da / (da - db)) * (b - a));
  }
  return part;
}

/** Returns whether a polygon is a rectangle with edges along x and y. */
bool is_rectangle(const Polygon &polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Tensor<1, 2> edge = polygon[(i + 1) % 4] - polygon[i];
    if (polygon.size() != 4 || edge[0] * edge[1] != 0.)
      return false;
  }
  return true;
}

/** Collects physical points and weights on convex polygons. */
class PolygonRule {
public:
  /**
   * With p + 3 points per direction, p > 1, the rule on whole pieces is exact for products of
   * gradients of functions of degree p per direction; on pieces that are half as large, one point
   * less has the same effect.
   * @param in_rectangle whether the polygons are parts of a rectangle.
   * @param ends points towards which the pieces shrink.
   */
  PolygonRule(const unsigned int n_points, const bool in_rectangle, std::vector<Point<2>> ends)
    : n_points_(n_points)
    , in_rectangle_(in_rectangle)
    , ends_(std::move(ends)) {}

  /** Adds a polygon: a rectangle away from all ends, or else a fan of triangles.
   * @param halvings how often it was halved before. */
  void add_polygon(const Polygon &polygon, const unsigned int halvings) {
    const unsigned int depth = std::min(halvings, deepest);
    if (ends_.empty() && is_rectangle(polygon)) {
      const unsigned int n = n_points(depth, !in_rectangle_);
      add_image(squares_.try_emplace(n, n).first->second, polygon[0], polygon[1] - polygon[0],
                polygon[3] - polygon[0]);
      return;
    }
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      add({{polygon[0], polygon[i], polygon[i + 1]}}, depth);
  }

  const PlaneRule &made() const {
    return made_;
  }

private:
  using Triangle = std::array<Point<2>, 3>;

  /** The number of bisections of the smallest pieces. A function like r^{1/2} is smooth on pieces
   * that are small compared with their distance from the end; the smallest pieces hold a share of
   * 2^{-3/2 deepest} of the integral of r. */
  static constexpr unsigned int deepest = 18;
  /** The number of points on the smallest pieces, near an end and elsewhere. */
  static constexpr unsigned int min_points = 5, min_smooth_points = 3;
  /** The least number of points in a direction that boxes divide and the other does not. */
  static constexpr unsigned int in_box = 6;

  /** Returns the number of points per direction on a piece.
   * @param adds whether degrees in reference coordinates add up along lines in the piece. */
  unsigned int n_points(const unsigned int depth, const bool adds) const {
    if (depth == 0 && n_points_ > 4)
      return adds ? 2 * n_points_ - 4 : std::max(n_points_, in_box);
    const unsigned int least = std::min(n_points_, ends_.empty() ? min_smooth_points : min_points);
    return std::max(least, n_points_ - std::min(n_points_, depth / 2));
  }

  /** Returns a rule by Duffy's map. */
  const QDuffy &rule(const unsigned int depth) {
    const unsigned int n = n_points(depth, true);
    return rules_.try_emplace(n, n, 1.).first->second;
  }

  /** Adds the image of a rule under the linear map that begins at x and has columns s and t. */
  void add_image(const Quadrature<2> &here, const Point<2> &x, const Tensor<1, 2> &s,
                 const Tensor<1, 2> &t) {
    const double jacobian = std::abs(s[0] * t[1] - s[1] * t[0]);
    for (unsigned int q = 0; q < here.size(); ++q) {
      made_.points.push_back(x + here.point(q)[0] * s + here.point(q)[1] * t);
      made_.weights.push_back(here.weight(q) * jacobian);
    }
  }

  void add(const Triangle &piece, const unsigned int depth) {
    // The longest edge, opposite to the vertex a.
    unsigned int a = 0;
    const auto edge = [&piece](const unsigned int opposite) {
      return piece[(opposite + 1) % 3].distance(piece[(opposite + 2) % 3]);
    };
    for (const unsigned int v : {1, 2})
      if (edge(v) > edge(a))
        a = v;
    const Point<2> &x = piece[a], &y = piece[(a + 1) % 3], &z = piece[(a + 2) % 3];
    const Point<2> middle = y + 0.5 * (z - y);
    // No point of the piece is farther from the middle of its longest edge than its vertices.
    const double radius = std::max(0.5 * edge(a), middle.distance(x));
    const auto is_near = [&](const Point<2> &end) {
      return 0.75 * (end.distance(middle) - radius) < edge(a);
    };
    if (depth < deepest && std::any_of(ends_.begin(), ends_.end(), is_near)) {
      add({{x, y, middle}}, depth + 1);
      add({{x, middle, z}}, depth + 1);
      return;
    }
    add_image(rule(depth), x, y - x, z - x);
  }

  const unsigned int n_points_;
  const bool in_rectangle_;
  const std::vector<Point<2>> ends_;
  std::map<unsigned int, QDuffy> rules_;
  std::map<unsigned int, QGauss<2>> squares_;
  PlaneRule made_;
};

/** Returns the Jacobian determinant of the bilinear map of a cell at a reference point. */
double jacobian(const Triangulation<2>::cell_iterator &cell, const Point<2> &xi) {
  const Tensor<1, 2> ds = (1. - xi[1]) * (cell->vertex(1) - cell->vertex(0)) +
                          xi[1] * (cell->vertex(3) - cell->vertex(2));
  const Tensor<1, 2> dt = (1. - xi[0]) * (cell->vertex(2) - cell->vertex(0)) +
                          xi[0] * (cell->vertex(3) - cell->vertex(1));
  return ds[0] * dt[1] - ds[1] * dt[0];
}

/** Returns the possible ends of contact zones that are near the cell, measured by its diameter.
 * Returns none where there are many, as in a comb of lines: contact ends at few of them, and a rule
 * that is graded to all of them would have a million points. */
template <int dim>
std::vector<Point<dim>> ends_near(const Kinks<dim> &kinks,
                                  const typename Triangulation<dim>::cell_iterator &cell) {
  constexpr std::size_t most = 8;
  std::vector<Point<dim>> near;
  for (const Point<dim> &end : kinks.ends())
    if (cell->center().distance(end) < 2.5 * cell->diameter())
      near.push_back(end);
  return near.size() > most ? std::vector<Point<dim>>() : near;
}

/** Appends the parts of a polygon in the boxes below a node. @param halvings in each direction. */
void divide(const Polygon &polygon, const BoxTree &boxes, const unsigned int node,
            const std::array<unsigned int, 2> &halvings, std::vector<PolygonPart> &parts) {
  const BoxTree::Node &halved = boxes.nodes()[node];
  if (halved.parts == 0) {
    parts.push_back({polygon, 2 * std::min(halvings[0], halvings[1]), halved.is_rough});
    return;
  }
  std::array<Polygon, 2> halves;
  for (unsigned int k = 0; k < 2; ++k)
    halves[k] = clip(polygon, halved.line, k == 0 ? -1. : 1.);
  std::array<unsigned int, 2> more = halvings;
  if (halves[0].size() > 2 && halves[1].size() > 2)
    ++more[halved.line.normal[0] == 0. ? 1 : 0];
  for (unsigned int k = 0; k < 2; ++k)
    if (halves[k].size() > 2)
      divide(halves[k], boxes, halved.parts + k, more, parts);
}
} // namespace

template <int dim>
bool crosses(const KinkLine<dim> &line, const typename Triangulation<dim>::cell_iterator &cell) {
  std::array<double, GeometryInfo<dim>::vertices_per_cell> distances;
  for (const unsigned int v : cell->vertex_indices())
    distances[v] = line.signed_distance(cell->vertex(v));
  const auto [lowest, highest] = std::minmax_element(distances.begin(), distances.end());
  const double margin = Kinks<dim>::tolerance * (*highest - *lowest);
  return *lowest<-margin && * highest> margin;
}

template <int dim>
bool needs_cuts(const Kinks<dim> &kinks, const typename Triangulation<dim>::cell_iterator &cell) {
  if (std::any_of(kinks.lines().begin(), kinks.lines().end(),
                  [&cell](const KinkLine<dim> &line) { return crosses<dim>(line, cell); }))
    return true;
  if constexpr (dim == 2)
    if (kinks.boxes().divides(cell->bounding_box()))
      return true;
  return !ends_near(kinks, cell).empty();
}

bool varies_fast(const Kinks<2> &kinks, const Triangulation<2>::cell_iterator &cell) {
  if (std::any_of(kinks.lines().begin(), kinks.lines().end(),
                  [&cell](const KinkLine<2> &line) { return crosses<2>(line, cell); }))
    return true;
  if (!kinks.boxes().divides(cell->bounding_box()))
    return false;
  // Larger boxes leave four parts at most.
  const auto parts =
    cut_polygon(kinks, {cell->vertex(0), cell->vertex(1), cell->vertex(3), cell->vertex(2)});
  return parts.size() > 4 || std::any_of(parts.begin(), parts.end(),
                                         [](const PolygonPart &part) { return part.is_rough; });
}

std::vector<PolygonPart> cut_polygon(const Kinks<2> &kinks, const Polygon &polygon) {
  std::vector<Polygon> pieces = {polygon};
  for (const KinkLine<2> &line : kinks.lines()) {
    std::vector<Polygon> parts;
    for (const Polygon &piece : pieces)
      for (const double sign : {-1., 1.}) {
        Polygon part = clip(piece, line, sign);
        if (part.size() > 2)
          parts.push_back(std::move(part));
      }
    pieces = std::move(parts);
  }
  std::vector<PolygonPart> parts;
  for (const Polygon &piece : pieces)
    divide(piece, kinks.boxes(), 0, {{0, 0}}, parts);
  return parts;
}

PlaneRule cut_rule(const Kinks<2> &kinks, const Triangulation<2>::cell_iterator &cell,
                   const unsigned int n_points) {
  const Polygon whole = {cell->vertex(0), cell->vertex(1), cell->vertex(3), cell->vertex(2)};
  PolygonRule rule(n_points, is_rectangle(whole), ends_near(kinks, cell));
  for (const PolygonPart &part : cut_polygon(kinks, whole))
    rule.add_polygon(part.corners, part.halvings);
  return rule.made();
}

Quadrature<2> cut_quadrature(const Kinks<2> &kinks, const Triangulation<2>::cell_iterator &cell,
                             const unsigned int n_points) {
  auto [points, weights] = cut_rule(kinks, cell, n_points);
  const MappingQ1<2> mapping;
  for (std::size_t q = 0; q < points.size(); ++q) {
    points[q] = mapping.transform_real_to_unit_cell(cell, points[q]);
    weights[q] /= jacobian(cell, points[q]);
  }
  return Quadrature<2>(points, weights);
}

Quadrature<1> split_quadrature(const Quadrature<1> &rule, const std::vector<double> &cuts) {
  std::vector<Point<1>> points;
  std::vector<double> weights;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    for (unsigned int q = 0; q < rule.size(); ++q) {
      const double length = cuts[i + 1] - cuts[i];
      points.emplace_back(cuts[i] + length * rule.point(q)[0]);
      weights.push_back(length * rule.weight(q));
    }
  return Quadrature<1>(points, weights);
}

std::vector<double> graded_positions(const double s, const double distance) {
  std::vector<double> positions;
  for (unsigned int k = 0; k < n_graded_layers; ++k)
    positions.push_back(s + distance * std::pow(0.25, k));
  return positions;
}

INSTANTIATE_FUNCTION(crosses);
INSTANTIATE_FUNCTION(needs_cuts);
} // namespace Signorini
