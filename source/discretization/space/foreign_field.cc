// SPDX-License-Identifier: LGPL-2.1-or-later
// The displacement of another program on the body: nodes, edges, sides.

#include <signorini/base/message.h>
#include <signorini/discretization/space/foreign_field.h>
#include <signorini/problem/geometry/inside.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace Signorini {
namespace {
constexpr unsigned int no_node = static_cast<unsigned int>(-1);

/** The share of the body within which points coincide: numbers of 32 bits round by 6e-8. */
constexpr double coincidence = 1e-7;

/** Makes the nodes, cells and edges of a ForeignField. */
class ForeignMesh {
public:
  ForeignMesh(const VtuMesh &file, const Geometry<2> &geometry, const double factor,
              const double tolerance)
    : file_(file)
    , geometry_(geometry)
    , factor_(factor)
    , allowed_(tolerance * geometry.diameter()) {
    read_cells();
    check_points();
    check_box();
    find_bodies();
    merge_points();
    find_edges();
    move_nodes();
    place_edges();
    make_cells();
    check_sides();
  }

  std::vector<ForeignCell> cells;
  std::vector<ForeignEdge> edges;
  std::vector<Point<2>> x;
  double largest_motion = 0., largest = 0.;

private:
  template <typename... Parts>
  InputError error(const Parts &...parts) const {
    return input_error(file_.name, ": ", parts...);
  }
  Point<2> file_point(const unsigned int i) const {
    return {file_.points[i][0], file_.points[i][1]};
  }
  Tensor<1, 2> file_value(const unsigned int i) const {
    const double *const first = &file_.values[file_.n_components * i];
    return factor_ * Tensor<1, 2>({first[0], first[1]});
  }
  void read_cells() {
    // Points of lines and vertices, which some programs write beside cells.
    static const std::set<unsigned int> others = {1, 2, 3, 4, 21, 35, 68};
    static const std::set<std::pair<unsigned int, std::size_t>> known = {
      {5, 3},  {22, 6}, {69, 3}, {69, 6}, {8, 4}, {9, 4},
      {23, 8}, {28, 9}, {70, 4}, {70, 8}, {70, 9}};
    static const std::set<unsigned int> triangles = {5, 22, 69}, hexahedra = {11, 12, 25, 29, 72};
    for (std::size_t c = 0; c < file_.cells.size(); ++c) {
      const auto &[type, points] = file_.cells[c];
      if (others.count(type) > 0)
        continue;
      if (known.count({type, points.size()}) == 0)
        throw error("cell ", c, points.empty() ? "" : " at ",
                    points.empty() ? "" : vector_text(file_point(points[0])), " has VTK's type ",
                    type, " with ", points.size(),
                    " points, allowed: triangles and quadrilaterals of degree 1 and 2",
                    hexahedra.count(type) > 0 ? " (of hexahedra one layer thick: CalculiX writes "
                                                "plane elements with OUTPUT=2D)."
                                              : ".");
      ForeignCell &cell = cells.emplace_back();
      cell.is_triangle = triangles.count(type) > 0;
      cell.has_middles = points.size() > cell.n_corners();
      cell.has_centre = points.size() == 9;
      cell.number = static_cast<unsigned int>(c);
      std::copy(points.begin(), points.end(), cell.nodes.begin());
      // Pixels have their points row by row.
      if (type == 8)
        std::swap(cell.nodes[2], cell.nodes[3]);
      orient(cell);
    }
    if (cells.empty())
      throw error("the file has no triangles or quadrilaterals.");
  }

  /** Turns a clockwise cell round. */
  void orient(ForeignCell &cell) const {
    const unsigned int n = cell.n_corners();
    double area = 0.;
    for (unsigned int k = 1; k + 1 < n; ++k)
      area -= cross_product_2d(file_point(cell.nodes[k]) - file_point(cell.nodes[0])) *
              (file_point(cell.nodes[k + 1]) - file_point(cell.nodes[0]));
    if (area > 0.)
      return;
    std::reverse(cell.nodes.begin() + 1, cell.nodes.begin() + n);
    std::reverse(cell.nodes.begin() + n, cell.nodes.begin() + 2 * n);
  }
  /** Calls visit(cell, node) for all nodes of cells, which are points of the file first. */
  template <typename Visit>
  void for_each_node(const Visit &visit) {
    for (ForeignCell &cell : cells)
      for (unsigned int i = 0; i < cell.n_nodes(); ++i)
        visit(cell, cell.nodes[i]);
  }

  void check_points() {
    double lowest = HUGE_VAL, highest = -HUGE_VAL, across = 0.;
    for_each_node([&](const ForeignCell &, const unsigned int i) {
      const Point<3> &at = file_.points[i];
      const Tensor<1, 2> value = file_value(i);
      const double third = file_.n_components == 3 ? factor_ * file_.values[3 * i + 2] : 0.;
      if (!std::isfinite(at.norm()) || !std::isfinite(value.norm()) || !std::isfinite(third))
        throw error("point ", i, " at ", vector_text(at),
                    " or its displacement is not finite, allowed: numbers.");
      lowest = std::min(lowest, at[2]);
      highest = std::max(highest, at[2]);
      largest = std::max(largest, value.norm());
      across = std::max(across, std::abs(third));
    });
    if (highest - lowest > allowed_)
      throw error("points lie at z = ", lowest, " and at z = ", highest,
                  ", allowed: a mesh in a plane.");
    if (across > 1e-6 * largest)
      throw error("the displacement across the plane reaches ", across, ", allowed: zero.");
  }

  /** Compares the boxes of mesh and body: units, and another position. */
  void check_box() {
    std::vector<Point<2>> points;
    for_each_node(
      [&](const ForeignCell &, const unsigned int i) { points.push_back(file_point(i)); });
    const BoundingBox<2> box(points);
    const Point<2> lower = box.get_boundary_points().first,
                   upper = box.get_boundary_points().second;
    const double ratio = lower.distance(upper) / geometry_.diameter();
    const auto compare = [&](const std::string &how) {
      return error("the mesh lies between ", vector_text(lower), " and ", vector_text(upper),
                   ", the body between ", vector_text(geometry_.lower), " and ",
                   vector_text(geometry_.upper), how);
    };
    if (ratio > 1.5 || ratio < 1. / 1.5)
      throw compare(concatenate(", a ratio of ", ratio,
                                ", allowed: the same body with coordinates in the same unit."));
    if (std::max(lower.distance(geometry_.lower), upper.distance(geometry_.upper)) >
        0.25 * geometry_.diameter())
      throw compare(", allowed: the same body at the same position.");
  }

  void find_bodies() {
    for (ForeignCell &cell : cells) {
      Point<2> middle = file_point(cell.nodes[0]);
      for (unsigned int k = 1; k < cell.n_corners(); ++k)
        middle += (file_point(cell.nodes[k]) - file_point(cell.nodes[0])) / cell.n_corners();
      double least = HUGE_VAL;
      for (unsigned int body = 0; body < geometry_.n_bodies() && geometry_.n_bodies() > 1; ++body) {
        const auto [first, last] = sides_of(body);
        const double distance = signed_distance(geometry_.sides, first, last, middle);
        if (distance < least) {
          least = distance;
          cell.body = body;
        }
      }
    }
  }
  std::pair<unsigned int, unsigned int> sides_of(const unsigned int body) const {
    const auto &all = geometry_.bodies;
    return {all.empty() ? 0 : all[body].first_side,
            body + 1 < all.size() ? all[body + 1].first_side : geometry_.sides.size()};
  }

  /** Makes one node of points of a body that coincide. */
  void merge_points() {
    const double width = coincidence * geometry_.diameter();
    std::map<std::tuple<unsigned int, double, double>, unsigned int> grid;
    const auto find = [&](const unsigned int body, const unsigned int point) {
      const Point<2> at = file_point(point);
      const double i = std::floor(at[0] / width), j = std::floor(at[1] / width);
      for (const double di : {-1., 0., 1.})
        for (const double dj : {-1., 0., 1.})
          if (const auto found = grid.find({body, i + di, j + dj});
              found != grid.end() && x[found->second].distance(at) <= width) {
            if ((v_[found->second] - file_value(point)).norm() > 1e-6 * largest)
              throw error("the field jumps at ", vector_text(at), " from ",
                          vector_text(v_[found->second]), " to ", vector_text(file_value(point)),
                          ", allowed: continuous displacements.");
            return found->second;
          }
      x.push_back(at);
      v_.push_back(file_value(point));
      grid[{body, i, j}] = static_cast<unsigned int>(x.size() - 1);
      return static_cast<unsigned int>(x.size() - 1);
    };
    for_each_node(
      [&](const ForeignCell &cell, unsigned int &node) { node = find(cell.body, node); });
    for (const ForeignCell &cell : cells)
      if (const auto end = cell.nodes.begin() + cell.n_nodes();
          std::set<unsigned int>(cell.nodes.begin(), end).size() < cell.n_nodes())
        throw error("cell ", cell.number, " at ", vector_text(x[cell.nodes[0]]),
                    " has two points at one position, allowed: cells that are no points or lines.");
  }

  /** An edge of a cell, from a to b or reversed. */
  struct Half {
    unsigned int low, high;
    unsigned int cell, number;
    bool is_reversed;

    bool operator<(const Half &other) const {
      return std::tie(low, high, cell) < std::tie(other.low, other.high, other.cell);
    }
  };
  unsigned int corner(const Half &half, const unsigned int k) const {
    const ForeignCell &cell = cells[half.cell];
    return cell.nodes[(half.number + k) % cell.n_corners()];
  }
  unsigned int middle(const Half &half) const {
    const ForeignCell &cell = cells[half.cell];
    return cell.has_middles ? cell.nodes[cell.n_corners() + half.number] : no_node;
  }
  std::string name_of(const Half &half) const {
    return concatenate("the edge from ", vector_text(x[corner(half, 0)]), " to ",
                       vector_text(x[corner(half, 1)]));
  }

  void find_edges() {
    std::vector<Half> halves;
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int k = 0; k < cells[c].n_corners(); ++k) {
        const Half half = {0, 0, c, k, false};
        const unsigned int a = corner(half, 0), b = corner(half, 1);
        halves.push_back({std::min(a, b), std::max(a, b), c, k, b < a});
      }
    std::sort(halves.begin(), halves.end());
    for (std::size_t i = 0, n = 0; i < halves.size(); i += n) {
      for (n = 1; i + n < halves.size() && halves[i + n].low == halves[i].low &&
                  halves[i + n].high == halves[i].high;)
        ++n;
      if (n > 2)
        throw error(name_of(halves[i]), " belongs to ", n, " cells, allowed: two at most.");
      if (n == 1) {
        boundary_.push_back(halves[i]);
        continue;
      }
      if (halves[i].is_reversed == halves[i + 1].is_reversed)
        throw error("the cells at ", name_of(halves[i]),
                    " lie on one another, allowed: cells beside each other.");
      if (middle(halves[i]) != middle(halves[i + 1]))
        throw error("the two cells at ", name_of(halves[i]),
                    " have other nodes in its middle, allowed: one node, or none.");
    }
  }

  /** Returns the arc length of the nearest point of a side. */
  double nearest_on(const unsigned int side, const Point<2> &at) const {
    const Side<2> &curve = geometry_.sides[side];
    const double s = curve.arc_length(at);
    return curve.is_closed() ? s : std::clamp(s, 0., curve.length());
  }
  double distance_from(const unsigned int side, const Point<2> &at) const {
    return geometry_.sides[side].point(nearest_on(side, at)).distance(at);
  }

  /** Returns the side of an edge: of those that both ends are on, the one nearest to its middle.
   * @throws InputError if there is none. */
  unsigned int side_of(const Half &half) const {
    const Point<2> &a = x[corner(half, 0)], &b = x[corner(half, 1)], chord = a + 0.5 * (b - a);
    const auto [first, last] = sides_of(cells[half.cell].body);
    unsigned int found = last;
    double nearest = HUGE_VAL, farthest = HUGE_VAL;
    for (unsigned int side = first; side < last; ++side) {
      const double off = std::max(distance_from(side, a), distance_from(side, b)),
                   of_middle = distance_from(side, chord);
      farthest = std::min(farthest, off);
      if (off <= allowed_ && of_middle < nearest) {
        nearest = of_middle;
        found = side;
      }
    }
    if (found == last)
      throw error(name_of(half),
                  " belongs to one cell only and its ends are on no side of the body, but ",
                  farthest,
                  " away: a hanging node, a gap, a corner that is left out or another body, "
                  "allowed: cells that cover the body, with boundary points ",
                  allowed_, " from it (Verify/Tolerance).");
    return found;
  }

  void move_nodes() {
    for (const Half &half : boundary_) {
      sides_.push_back(side_of(half));
      for (const unsigned int k : {0U, 1U})
        sides_of_node_[corner(half, k)].insert(sides_.back());
    }
    for (const auto &[node, sides] : sides_of_node_)
      move(node, sides.size() == 1 ? on_side(*sides.begin(), x[node]) : common_end(sides, x[node]));
  }
  void move(const unsigned int node, const Point<2> &to) {
    largest_motion = std::max(largest_motion, x[node].distance(to));
    x[node] = to;
  }
  /** Returns the nearest point of a side; near the end of a piece that end. */
  Point<2> on_side(const unsigned int side, const Point<2> &at) const {
    const Side<2> &curve = geometry_.sides[side];
    for (unsigned int k = 0; k < curve.n_pieces() && curve.n_pieces() > 1; ++k)
      if (curve.piece(k).start().distance(at) <= allowed_)
        return curve.piece(k).start();
    return curve.point(nearest_on(side, at));
  }
  /** Returns the point in which sides meet. @throws InputError if that is not near. */
  Point<2> common_end(const std::set<unsigned int> &sides, const Point<2> &at) const {
    Point<2> end;
    double nearest = HUGE_VAL;
    const Side<2> &side = geometry_.sides[*sides.begin()];
    for (const Point<2> &candidate : {side.start(), side.end()})
      if (candidate.distance(at) < nearest) {
        nearest = candidate.distance(at);
        end = candidate;
      }
    if (nearest > 2. * allowed_)
      throw error("edges on two sides meet at ", vector_text(at), ", but the end ",
                  vector_text(end), " of '", side.name(), "' is ", nearest,
                  " away, allowed: a node at every corner.");
    return end;
  }

  /** Makes the boundary edges, by side and arc length. */
  void place_edges() {
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
      const Half &half = boundary_[i];
      const Side<2> &side = geometry_.sides[sides_[i]];
      const Point<2> &a = x[corner(half, 0)], &b = x[corner(half, 1)];
      const Curve line = side.between(a, b);
      const Point<2> in_middle = line.point(0.5 * line.length());
      const double s = side.arc_length(in_middle), from = s - 0.5 * line.length();
      const bool wraps = side.is_closed() && from < -1e-9 * side.length();
      ForeignEdge edge = {half.cell,
                          half.number,
                          sides_[i],
                          from + (wraps ? side.length() : 0.),
                          from + line.length() + (wraps ? side.length() : 0.),
                          side.tangent(s, side.length()) * (b - a) < 0.};
      check_pieces(half, edge);
      if (middle(half) != no_node)
        place_middle(half, line, in_middle);
      if (!line.is_flat())
        cells[half.cell].arcs[half.number] = line;
      edges.push_back(edge);
    }
  }
  /** @throws InputError where an edge spans a point at which its side turns or bends. */
  void check_pieces(const Half &half, const ForeignEdge &edge) const {
    const Side<2> &side = geometry_.sides[edge.side];
    const unsigned int n = side.n_pieces();
    const double margin = 1e-9 * side.length();
    for (unsigned int k = 0; k < n && n > 1; ++k)
      for (const double turn : {0., 1.}) {
        const double s = side.start_of(k) + turn * side.length();
        const Curve &before = side.piece((k + n - 1) % n), &behind = side.piece(k);
        if (s > edge.from + margin && s < edge.to - margin &&
            (before.radius() == 0. || behind.radius() == 0. ||
             before.centre_of_circle().distance(behind.centre_of_circle()) > allowed_))
          throw error(name_of(half), " leaves out the point ", vector_text(behind.start()), " of '",
                      side.name(), "', allowed: a node there.");
      }
  }
  /** Moves the node in the middle of an edge to that of its side's part. On an arc it may also be
   * the middle of the chord. */
  void place_middle(const Half &half, const Curve &line, const Point<2> &target) {
    const unsigned int node = middle(half);
    const Point<2> chord = line.start() + 0.5 * (line.end() - line.start());
    if (x[node].distance(target) <= allowed_)
      move(node, target);
    else if (!line.is_flat() && x[node].distance(chord) <= allowed_)
      x[node] = chord;
    else
      throw error("the node at ", vector_text(x[node]),
                  " is not in the middle of its edge, which is ", vector_text(target),
                  ", allowed: nodes ", allowed_, " from it (Verify/Tolerance).");
  }

  void make_cells() {
    for (ForeignCell &cell : cells) {
      for (unsigned int i = 0; i < cell.n_nodes(); ++i) {
        cell.x[i] = x[cell.nodes[i]];
        cell.v[i] = v_[cell.nodes[i]];
      }
      cell.complete(cell.x);
      cell.complete(cell.v);
      check_determinant(cell);
    }
    std::sort(edges.begin(), edges.end(), [](const ForeignEdge &a, const ForeignEdge &b) {
      return std::tie(a.side, a.from) < std::tie(b.side, b.from);
    });
  }
  void check_determinant(const ForeignCell &cell) const {
    // It vanishes at a corner between two edges on one arc, and where a corner of a triangle is an
    // edge of the square.
    const double size = cell.x[0].distance_square(cell.x[1]) + cell.x[0].distance_square(cell.x[2]);
    for (const double s : {0., 0.25, 0.5, 0.75, 1.})
      for (const double t : {0., 0.25, 0.5, 0.75, 1.}) {
        const bool is_inside = s > 0. && s < 1. && t > 0. && t < 1.;
        if (!(cell.at(s, t).determinant > (is_inside ? 1e-10 : -1e-10) * size))
          throw error("cell ", cell.number, " is turned inside out at ",
                      vector_text(cell.at(s, t).x), ", allowed: cells with positive determinants.");
      }
  }

  /** @throws InputError if edges do not cover a side. */
  void check_sides() const {
    auto edge = edges.begin();
    for (unsigned int number = 0; number < geometry_.sides.size(); ++number) {
      const Side<2> &side = geometry_.sides[number];
      const double margin = 1e-9 * geometry_.diameter();
      double s = side.is_closed() && edge != edges.end() && edge->side == number ? edge->from : 0.;
      const double end = s + side.length();
      const auto require = [&](const double next) {
        if (std::abs(next - s) > margin)
          throw error(next > s ? "no cell has" : "two cells have", " an edge on '", side.name(),
                      "' between ", vector_text(side.point(std::min(s, next))), " and ",
                      vector_text(side.point(std::max(s, next))),
                      ", allowed: cells that cover the body once.");
      };
      for (; edge != edges.end() && edge->side == number; ++edge) {
        require(edge->from);
        s = edge->to;
      }
      require(end);
    }
  }

  const VtuMesh &file_;
  const Geometry<2> &geometry_;
  const double factor_, allowed_;
  std::vector<Tensor<1, 2>> v_;
  /** The edges with one cell, with their sides and the parts of these. */
  std::vector<Half> boundary_;
  std::vector<unsigned int> sides_;
  std::map<unsigned int, std::set<unsigned int>> sides_of_node_;
};
} // namespace

ForeignField::ForeignField(const VtuMesh &mesh, const Geometry<2> &geometry, const double factor,
                           const double tolerance) {
  ForeignMesh made(mesh, geometry, factor, tolerance);
  cells_ = std::move(made.cells);
  edges_ = std::move(made.edges);
  n_nodes_ = static_cast<unsigned int>(made.x.size());
  largest_ = made.largest;
  largest_motion_ = made.largest_motion;
}

const ForeignEdge &ForeignField::edge_at(const unsigned int side, const double s) const {
  const auto after = std::upper_bound(
    edges_.begin(), edges_.end(), std::pair(side, s),
    [](const auto &at, const ForeignEdge &edge) { return at < std::pair(edge.side, edge.from); });
  // In front of the first edge of a closed side lies the end of the last one.
  if (after == edges_.begin() || std::prev(after)->side != side)
    return *std::prev(std::upper_bound(
      edges_.begin(), edges_.end(), side,
      [](const unsigned int number, const ForeignEdge &edge) { return number < edge.side; }));
  return *std::prev(after);
}
} // namespace Signorini
