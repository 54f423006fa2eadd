// SPDX-License-Identifier: LGPL-2.1-or-later
// Quadrature on the pieces into which lines cut cells and faces.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/discretization/mesh/smooth_parts.h>

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

double area_of(const Tensor<1, 2> &a, const Tensor<1, 2> &b) {
  return a[0] * b[1] - a[1] * b[0];
}

/** Collects physical points and weights on convex polygons. */
class PolygonRule {
public:
  /** The least number of points in a direction that boxes divide and the other does not. */
  static constexpr unsigned int in_box = 6;

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
  void add_image(const Quadrature<2> &rule, const Point<2> &x, const Tensor<1, 2> &s,
                 const Tensor<1, 2> &t) {
    const double jacobian = std::abs(area_of(s, t));
    for (unsigned int q = 0; q < rule.size(); ++q) {
      made_.points.push_back(x + rule.point(q)[0] * s + rule.point(q)[1] * t);
      made_.weights.push_back(rule.weight(q) * jacobian);
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

/** The bilinear map of the unit square to a quadrilateral with corners in the order of a polygon.
 */
struct BilinearMap {
  Polygon x;

  Point<2> operator()(const Point<2> &xi) const {
    return x[0] + xi[0] * (x[1] - x[0]) + xi[1] * (x[3] - x[0]) +
           xi[0] * xi[1] * ((x[2] - x[3]) - (x[1] - x[0]));
  }
  std::array<Tensor<1, 2>, 2> derivatives(const Point<2> &xi) const {
    return {{(1. - xi[1]) * (x[1] - x[0]) + xi[1] * (x[2] - x[3]),
             (1. - xi[0]) * (x[3] - x[0]) + xi[0] * (x[2] - x[1])}};
  }
  double jacobian(const Point<2> &xi) const {
    const auto [ds, dt] = derivatives(xi);
    return area_of(ds, dt);
  }
  /** Returns the point with the image @p y, by Newton's method. */
  Point<2> inverse(const Point<2> &y) const {
    Point<2> xi(0.5, 0.5);
    for (unsigned int step = 0; step < 20; ++step) {
      const auto [ds, dt] = derivatives(xi);
      const Tensor<1, 2> rest = y - (*this)(xi);
      const Tensor<1, 2> change(
        {area_of(rest, dt) / area_of(ds, dt), area_of(ds, rest) / area_of(ds, dt)});
      xi += change;
      if (change.norm() < 1e-15)
        break;
    }
    return xi;
  }
};

/** Returns the possible ends of contact zones that are near the cell, measured by its diameter.
 * Returns none where there are many, as in a comb of lines: contact ends at few of them, and a rule
 * that is graded to all of them would have a million points. */
template <int dim>
std::vector<Point<dim>> ends_near(const Kinks<dim> &kinks, const Point<dim> &centre,
                                  const double diameter) {
  constexpr std::size_t most = 8;
  std::vector<Point<dim>> near;
  for (const Point<dim> &end : kinks.ends())
    if (centre.distance(end) < 2.5 * diameter)
      near.push_back(end);
  return near.size() > most ? std::vector<Point<dim>>() : near;
}

template <int dim>
std::vector<Point<dim>> ends_near(const Kinks<dim> &kinks,
                                  const typename Triangulation<dim>::cell_iterator &cell) {
  return ends_near(kinks, cell->center(), cell->diameter());
}

/** Returns the vertices of a cell, and the middles of its edges, which may be curved. */
template <int dim>
std::vector<Point<dim>> outline_of(const typename Triangulation<dim>::cell_iterator &cell) {
  std::vector<Point<dim>> points;
  for (const unsigned int v : cell->vertex_indices())
    points.push_back(cell->vertex(v));
  if constexpr (dim == 2)
    for (const auto &face : cell->face_iterators())
      points.push_back(face->center(/*respect_manifold=*/true));
  return points;
}

template <int dim>
bool divides(const KinkLine<dim> &line, const std::vector<Point<dim>> &outline) {
  double lowest = 0., highest = 0.;
  for (const Point<dim> &x : outline) {
    lowest = std::min(lowest, line.signed_distance(x));
    highest = std::max(highest, line.signed_distance(x));
  }
  const double margin = Kinks<dim>::tolerance * (highest - lowest);
  return lowest < -margin && highest > margin;
}

template <int dim>
bool any_divides(const std::vector<KinkLine<dim>> &lines, const std::vector<Point<dim>> &outline) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const KinkLine<dim> &line) { return divides(line, outline); });
}

/** Returns whether a line or a box of the data divides a body with the given outline. */
template <int dim>
bool meets(const Kinks<dim> &kinks, const std::vector<Point<dim>> &outline) {
  if (any_divides(kinks.lines(), outline))
    return true;
  if constexpr (dim == 2)
    return kinks.boxes().divides(BoundingBox<2>(outline));
  return false;
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
  return divides(line, outline_of<dim>(cell));
}

template <int dim>
bool needs_cuts(const Kinks<dim> &kinks, const typename Triangulation<dim>::cell_iterator &cell) {
  return meets(kinks, outline_of<dim>(cell)) || !ends_near(kinks, cell).empty();
}

bool may_jump(const Kinks<2> &kinks, const Triangulation<2>::cell_iterator &cell) {
  const std::vector<Point<2>> outline = outline_of<2>(cell);
  return any_divides(kinks.lines(), outline) || kinks.boxes().hides_some(BoundingBox<2>(outline));
}

bool varies_fast(const Kinks<2> &kinks, const Triangulation<2>::cell_iterator &cell) {
  const std::vector<Point<2>> outline = outline_of<2>(cell);
  if (any_divides(kinks.lines(), outline))
    return true;
  if (!kinks.boxes().divides(BoundingBox<2>(outline)))
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

PlaneRule cut_rule(const Kinks<2> &kinks, const std::array<Point<2>, 4> &corners,
                   const unsigned int n_points) {
  const Polygon whole(corners.begin(), corners.end());
  const Point<2> centre =
    corners[0] +
    0.25 * ((corners[1] - corners[0]) + (corners[2] - corners[0]) + (corners[3] - corners[0]));
  const double diameter =
    std::max(corners[0].distance(corners[2]), corners[1].distance(corners[3]));
  PolygonRule rule(n_points, is_rectangle(whole), ends_near(kinks, centre, diameter));
  for (const PolygonPart &part : cut_polygon(kinks, whole))
    rule.add_polygon(part.corners, part.halvings);
  return rule.made();
}

namespace {
/** The rule of cut_quadrature(). A square of the reference cell whose image is too curved for the
 * parts cut in it is halved in both directions; most edges of cells are straight. */
class CellCuts {
public:
  CellCuts(const Kinks<2> &kinks, const Mapping<2> &mapping,
           const Triangulation<2>::cell_iterator &cell, const unsigned int n_points)
    : kinks_(kinks)
    , mapping_(mapping)
    , cell_(cell)
    , n_points_(n_points)
    , origin_(mapping.transform_unit_to_real_cell(cell, Point<2>()))
    , scale_(cell->vertex(0).distance(cell->vertex(1)) /
             origin_.distance(mapping.transform_unit_to_real_cell(cell, Point<2>(1., 0.))))
    , ends_(ends_near(kinks, cell)) {
    if (ends_.empty() && !may_jump(kinks, cell) && !is_quadrilateral())
      add_smooth();
    else
      add(Point<2>(), 1., 0);
  }
  Quadrature<2> rule() const {
    return Quadrature<2>(points_, weights_);
  }

private:
  /** The bend of an edge, as a share of the cell, that counts as rounding. */
  static constexpr double straight = 1e-12;

  /** Returns the image of a reference point in the body; maps may have another unit of length. */
  Point<2> image(const Point<2> &xi) const {
    return cell_->vertex(0) + scale_ * (mapping_.transform_unit_to_real_cell(cell_, xi) - origin_);
  }
  /** Returns the bilinear map with the same corners on a square. @param bend their distance. */
  BilinearMap bilinear(const Point<2> &corner, const double width, double &bend) const {
    const auto at = [&](const double s, const double t) {
      return image(corner + width * Tensor<1, 2>({s, t}));
    };
    BilinearMap map = {{at(0., 0.), at(1., 0.), at(1., 1.), at(0., 1.)}};
    bend = 0.;
    for (const Point<2> &xi : {Point<2>(0.5, 0.), Point<2>(1., 0.5), Point<2>(0.5, 1.),
                               Point<2>(0., 0.5), Point<2>(0.5, 0.5)})
      bend = std::max(bend, map(xi).distance(at(xi[0], xi[1])));
    return map;
  }
  /** Returns whether the cell has straight edges. */
  bool is_quadrilateral() const {
    double bend;
    const BilinearMap map = bilinear(Point<2>(), 1., bend);
    return bend < straight * map.x[0].distance(map.x[2]);
  }
  void add_smooth() {
    for (const SquarePart &part :
         smooth_parts(kinks_.boxes(), [this](const Point<2> &xi) { return image(xi); })) {
      const Quadrature<2> rule = part.rule(std::max(n_points_, PolygonRule::in_box));
      for (unsigned int q = 0; q < rule.size(); ++q) {
        points_.push_back(part(rule.point(q)));
        weights_.push_back(rule.weight(q) * part.width * part.width);
      }
    }
  }
  /** Adds the square with the given lower left corner and width. */
  void add(const Point<2> &corner, const double width, const unsigned int halvings) {
    constexpr unsigned int most_halvings = 8;
    const auto at = [&](const double s, const double t) {
      return corner + width * Tensor<1, 2>({s, t});
    };
    double bend;
    const BilinearMap map = bilinear(corner, width, bend);
    if (halvings < most_halvings && is_too_curved(map, bend)) {
      for (const double t : {0., 0.5})
        for (const double s : {0., 0.5})
          add(at(s, t), 0.5 * width, halvings + 1);
      return;
    }
    PolygonRule rule(n_points_, is_rectangle(map.x), ends_);
    for (const PolygonPart &part : cut_polygon(kinks_, map.x))
      rule.add_polygon(part.corners, part.halvings);
    for (std::size_t q = 0; q < rule.made().points.size(); ++q) {
      const Point<2> xi = map.inverse(rule.made().points[q]);
      points_.push_back(at(xi[0], xi[1]));
      weights_.push_back(rule.made().weights[q] / map.jacobian(xi) * width * width);
    }
  }
  /** Returns whether the part cut in a quadrilateral, or near it, is not large compared with the
   * distance of its image from it. */
  bool is_too_curved(const BilinearMap &map, const double bend) const {
    constexpr double allowed = 0.1;
    const double size = map.x[0].distance(map.x[2]);
    if (bend < straight * size)
      return false;
    Polygon wider = map.x;
    const Point<2> centre = map(Point<2>(0.5, 0.5));
    for (Point<2> &x : wider)
      x += 4. * bend / size * (x - centre);
    if (!meets(kinks_, wider))
      return false;
    const auto parts = cut_polygon(kinks_, wider);
    return std::any_of(parts.begin(), parts.end(), [&](const PolygonPart &part) {
      double area = 0.;
      for (std::size_t i = 1; i + 1 < part.corners.size(); ++i)
        area += 0.5 * std::abs(area_of(part.corners[i] - part.corners[0],
                                       part.corners[i + 1] - part.corners[0]));
      return bend > allowed * std::sqrt(area);
    });
  }

  const Kinks<2> &kinks_;
  const Mapping<2> &mapping_;
  const Triangulation<2>::cell_iterator cell_;
  const unsigned int n_points_;
  const Point<2> origin_;
  const double scale_;
  const std::vector<Point<2>> ends_;
  std::vector<Point<2>> points_;
  std::vector<double> weights_;
};
} // namespace

Quadrature<2> cut_quadrature(const Kinks<2> &kinks, const Triangulation<2>::cell_iterator &cell,
                             const unsigned int n_points, const Mapping<2> &mapping) {
  return CellCuts(kinks, mapping, cell, n_points).rule();
}

std::vector<double> cut_edge(const Kinks<2> &kinks, const Side<2> &side, const Point<2> &a,
                             const Point<2> &b) {
  const Tensor<1, 2> edge = b - a;
  const Point<2> chord = a + 0.5 * edge;
  const double s = side.is_flat() ? 0. : side.arc_length(chord);
  const Point<2> middle = side.is_flat() ? chord : side.point(s);
  // The edge is a parabola through the middle of the arc; its coordinate along the chord is linear.
  const double angle = 2. * std::atan(2. * middle.distance(chord) / edge.norm());
  if (angle < 1e-10)
    return kinks.cut(a, b);
  const double half = 0.5 * edge.norm() * angle / std::sin(angle),
               sign = (side.point(s + 0.5 * half) - middle) * edge < 0. ? -1. : 1.;
  std::vector<double> cuts;
  for (const double on_arc : kinks.cut(side, s - half, s + half)) {
    const double k = std::tan(sign * angle * (on_arc - s) / half), sine = std::sin(angle);
    const double eta =
      2. * k / (sine + std::sqrt(sine * sine + 4. * k * k * (1. - std::cos(angle))));
    cuts.push_back(std::clamp(0.5 + 0.5 * eta, 0., 1.));
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.front() = 0.;
  cuts.back() = 1.;
  return cuts;
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
