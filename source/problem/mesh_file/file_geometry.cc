// SPDX-License-Identifier: LGPL-2.1-or-later
// The body of a mesh file: sides of segments and arcs, regions, and the coarse mesh.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/geometry/outline.h>
#include <signorini/problem/mesh_file/file_geometry.h>

#include <deal.II/base/table.h>
#include <deal.II/numerics/rtree.h>

#include <boost/geometry.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <tuple>

namespace Signorini {
namespace {
using Chain = std::vector<FileMesh<2>::Edge>;
using Nodes = std::vector<const FileMesh<2>::Node *>;

/** The share of the length by which nodes may lie off their segment. */
constexpr double segment_tolerance = 1e-8;

/** The share of the radius by which nodes may lie off their arc; of one that Geometry/Arcs names,
 * to which files with few digits belong. */
constexpr double arc_tolerance = 1e-6, declared_arc_tolerance = 1e-4;

/** The share of an edge's length: an edge whose middle lies closer to its chord is straight. */
constexpr double min_rise = 1e-6;

/** Returns where a closed chain begins: at its leftmost corner, or without a corner at its leftmost
 * vertex. */
std::size_t start_of_loop(const FileMesh<2> &mesh, const Chain &loop) {
  std::vector<std::tuple<bool, double, double>> ranks;
  for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
    const Point<2> &x = mesh.nodes[loop[i].start].x;
    const Tensor<1, 2> in = x - mesh.nodes[loop[(i + n - 1) % n].start].x;
    const Tensor<1, 2> out = mesh.nodes[loop[i].end].x - x;
    // Edges of a circle turn by their angle at its centre: corners turn by more than 60 degrees.
    ranks.emplace_back(in * out >= 0.5 * in.norm() * out.norm(), x[0], x[1]);
  }
  return std::min_element(ranks.begin(), ranks.end()) - ranks.begin();
}

/** Returns all chains of edges with one name, by name, and those of one name from left to right. */
std::vector<Chain> find_chains(const FileMesh<2> &mesh) {
  std::vector<Chain> chains;
  for (Chain loop : mesh.loops) {
    std::size_t first = 0;
    while (first < loop.size() &&
           loop[first].name == loop[(first + loop.size() - 1) % loop.size()].name)
      ++first;
    if (first == loop.size())
      first = start_of_loop(mesh, loop);
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (i == 0 || loop[i].name != loop[i - 1].name)
        chains.emplace_back();
      chains.back().push_back(loop[i]);
    }
  }
  const auto rank = [&](const Chain &chain) {
    const Point<2> &x = mesh.nodes[chain[0].start].x;
    return std::make_tuple(chain[0].name, x[0], x[1]);
  };
  std::sort(chains.begin(), chains.end(),
            [&](const Chain &a, const Chain &b) { return rank(a) < rank(b); });
  return chains;
}

bool is_bent(const FileMesh<2> &mesh, const FileMesh<2>::Edge &edge) {
  const Tensor<1, 2> chord = mesh.nodes[edge.end].x - mesh.nodes[edge.start].x;
  const Tensor<1, 2> to_middle = mesh.nodes[edge.middle].x - mesh.nodes[edge.start].x;
  return std::abs(chord * cross_product_2d(to_middle)) > min_rise * chord.norm_square();
}

/** Returns the nodes along the edges [first, last) of a chain. */
Nodes nodes_along(const FileMesh<2> &mesh, const Chain &chain, const std::size_t first,
                  const std::size_t last) {
  Nodes nodes = {&mesh.nodes[chain[first].start]};
  for (std::size_t i = first; i < last; ++i) {
    if (chain[i].middle != chain[i].start)
      nodes.push_back(&mesh.nodes[chain[i].middle]);
    nodes.push_back(&mesh.nodes[chain[i].end]);
  }
  return nodes;
}

/** Returns the arc through the first node, one in the middle and the last, or of a closed chain one
 * at each third. It is flat if they are on a line. */
Curve arc_through(const Nodes &nodes) {
  const bool is_closed = nodes.front() == nodes.back();
  const std::size_t last = nodes.size() - 1;
  const Point<2> &start = nodes[0]->x;
  const Tensor<1, 2> a = nodes[is_closed ? last / 3 : (last + 1) / 2]->x - start;
  const Tensor<1, 2> b = nodes[is_closed ? 2 * last / 3 : last]->x - start;
  const double product = a * cross_product_2d(b);
  if (!(std::abs(product) > min_rise * a.norm() * b.norm()))
    return Curve(start, nodes[last]->x);
  return Curve::arc_between(start, nodes[last]->x, Curve::circumcentre(start, a, b), product > 0.);
}

/** The edges [first, last) of a chain, which are one segment or one arc. */
struct Piece {
  std::size_t first, last;
  Curve curve;
};

/** Divides a chain into segments and arcs, as long as possible: edges of second order that are bent
 * are parts of arcs, and so are all edges of a side that is declared one. */
std::vector<Piece> divide_chain(const FileMesh<2> &mesh, const Chain &chain,
                                const bool is_declared) {
  std::vector<Piece> pieces;
  for (std::size_t first = 0, last = 0; first < chain.size(); first = last) {
    const bool is_arc = is_declared || is_bent(mesh, chain[first]);
    const auto curve_along = [&](const std::size_t end) {
      const Nodes nodes = nodes_along(mesh, chain, first, end);
      return is_arc ? arc_through(nodes) : Curve(nodes.front()->x, nodes.back()->x);
    };
    const Curve curve = curve_along(is_declared ? chain.size() : first + 1);
    const auto fits = [&](const unsigned int node) {
      const Point<2> &x = mesh.nodes[node].x;
      return curve.point(curve.arc_length(x)).distance(x) <=
             (is_arc ? (is_declared ? declared_arc_tolerance : arc_tolerance) * curve.radius()
                     : segment_tolerance * curve.start().distance(x));
    };
    last = is_declared ? first : first + 1;
    while (last < chain.size() && (is_declared || is_bent(mesh, chain[last]) == is_arc) &&
           fits(chain[last].end) && (!is_arc || fits(chain[last].middle)))
      ++last;
    last = std::max(last, first + 1);
    pieces.push_back({first, last, curve_along(last)});
  }
  return pieces;
}

/** Moves the vertices inside of a piece onto it. @return the largest motion (length). */
double move_onto(const Piece &piece, const Chain &chain, FileMesh<2> &mesh) {
  const bool is_closed = piece.curve.is_closed();
  double largest = 0.;
  for (std::size_t i = piece.first; i < piece.last; ++i) {
    Point<2> &x = mesh.nodes[chain[i].start].x;
    if (i == piece.first && !is_closed)
      continue;
    const Point<2> on_curve = piece.curve.point(piece.curve.arc_length(x));
    largest = std::max(largest, x.distance(on_curve));
    x = on_curve;
  }
  return largest;
}

/** Returns whether each side is declared an arc, by its own name or by that of all its chains. */
std::vector<bool> find_arcs(const std::vector<Chain> &chains, const std::vector<std::string> &names,
                            const std::vector<std::string> &arcs, const std::string &where) {
  std::vector<bool> is_arc(chains.size(), false);
  for (const std::string &arc : arcs) {
    bool found = false;
    for (std::size_t i = 0; i < chains.size(); ++i)
      if (names[i] == arc || chains[i][0].name == arc)
        found = is_arc[i] = true;
    if (!found)
      throw input_error(where, ": found the side ", quote(arc), ", allowed: ", join(names), ".");
  }
  return is_arc;
}

/** The cells of a mesh with their regions, by their positions. */
struct RegionMap {
  std::vector<boost::geometry::model::ring<Point<2>, false, false>> cells;
  std::vector<unsigned int> regions;
  RTree<std::pair<BoundingBox<2>, unsigned int>> boxes;
  /** The body's box, divided into a grid: the region of each of its parts, n_regions where more
   * than one may be there, or none is. */
  BoundingBox<2> body;
  unsigned int n_regions = 0;
  Table<2, unsigned int> grid;

  /** Returns the row or column of the grid in which a coordinate lies. */
  unsigned int index_of(const double x, const unsigned int d) const {
    const double part = (x - body.lower_bound(d)) / body.side_length(d);
    return std::clamp(part, 0., 1. - 1e-9) * grid.size(d);
  }
  /** Fills the grid. Cells count in the parts next to their boxes, too. */
  void fill_grid() {
    constexpr unsigned int n_parts = 256;
    constexpr unsigned int none = numbers::invalid_unsigned_int;
    grid.reinit(n_parts, n_parts);
    grid.fill(none);
    for (const auto &[box, cell] : boxes) {
      std::array<unsigned int, 2> begin = {}, end = {};
      for (unsigned int d = 0; d < 2; ++d) {
        begin[d] = std::max(1U, index_of(box.lower_bound(d), d)) - 1;
        end[d] = std::min(n_parts, index_of(box.upper_bound(d), d) + 2);
      }
      for (unsigned int i = begin[0]; i < end[0]; ++i)
        for (unsigned int j = begin[1]; j < end[1]; ++j)
          grid(i, j) =
            grid(i, j) == none || grid(i, j) == regions[cell] ? regions[cell] : n_regions;
    }
    for (unsigned int i = 0; i < n_parts; ++i)
      for (unsigned int j = 0; j < n_parts; ++j)
        grid(i, j) = std::min(grid(i, j), n_regions);
  }

  /** Returns the region of a point. Beyond chords of arcs no cell has it: the nearest one counts.
   */
  unsigned int region_at(const Point<2> &x) const {
    if (const unsigned int region = grid(index_of(x[0], 0), index_of(x[1], 1)); region < n_regions)
      return region;
    constexpr unsigned int n_near = 8;
    std::pair<double, unsigned int> nearest(HUGE_VAL, 0);
    for (auto entry = boxes.qbegin(boost::geometry::index::nearest(x, n_near));
         entry != boxes.qend() && nearest.first > 0.; ++entry)
      nearest =
        std::min(nearest, {boost::geometry::distance(x, cells[entry->second]), entry->second});
    return regions[nearest.second];
  }
};

/** Names the regions of a body, and finds them by points. */
void add_regions(const FileMesh<2> &mesh, Geometry<2> &geometry) {
  std::set<std::string> names;
  for (const FileMesh<2>::Element &cell : mesh.cells)
    names.insert(mesh.name_of(cell, 2));
  geometry.regions.assign(names.begin(), names.end());
  geometry.region_at = [](const Point<2> &) { return 0U; };
  if (names.size() == 1)
    return;
  const auto map = std::make_shared<RegionMap>();
  std::vector<std::pair<BoundingBox<2>, unsigned int>> boxes;
  std::vector<Point<2>> corners_of_body;
  for (const FileMesh<2>::Element &cell : mesh.cells) {
    std::vector<Point<2>> corners;
    for (unsigned int i = 0; i < cell.n_corners; ++i)
      corners.push_back(mesh.nodes[cell.nodes[i]].x);
    corners_of_body.insert(corners_of_body.end(), corners.begin(), corners.end());
    boxes.emplace_back(BoundingBox<2>(corners), boxes.size());
    map->cells.emplace_back(corners.begin(), corners.end());
    map->regions.push_back(std::distance(names.begin(), names.find(mesh.name_of(cell, 2))));
  }
  map->boxes = pack_rtree(boxes);
  map->body = BoundingBox<2>(corners_of_body);
  map->n_regions = names.size();
  map->fill_grid();
  geometry.region_at = [map](const Point<2> &x) { return map->region_at(x); };
}
} // namespace

Geometry<2> make_geometry(FileMesh<2> mesh, const std::vector<std::string> &arcs,
                          const std::string &where) {
  const unsigned int n_vertices = check_and_sort(mesh);
  const std::vector<Chain> chains = find_chains(mesh);
  std::vector<std::string> names;
  for (const Chain &chain : chains)
    names.push_back(chain[0].name);
  names = number_names(names, mesh.name);
  const std::vector<bool> is_arc = find_arcs(chains, names, arcs, where);
  std::vector<Side<2>> sides;
  std::vector<std::vector<Piece>> pieces;
  double largest_motion = 0.;
  CoarseMesh coarse;
  for (unsigned int i = 0; i < chains.size(); ++i) {
    pieces.push_back(divide_chain(mesh, chains[i], is_arc[i]));
    if (is_arc[i] && (pieces[i].size() > 1 || pieces[i][0].curve.is_flat()))
      throw input_error(where, ": the side ", quote(names[i]),
                        " is not one arc, allowed: nodes on one circle, to ",
                        declared_arc_tolerance, " of its radius.");
    std::vector<Curve> curves;
    for (const Piece &piece : pieces[i]) {
      const double motion = move_onto(piece, chains[i], mesh);
      if (is_arc[i])
        largest_motion = std::max(largest_motion, motion);
      curves.push_back(piece.curve);
      for (std::size_t e = piece.first; e < piece.last; ++e)
        coarse.edges.push_back({chains[i][e].start, chains[i][e].end, i, &piece.curve});
    }
    sides.emplace_back(names[i], Curve::chain(curves));
  }
  for (unsigned int v = 0; v < n_vertices; ++v)
    coarse.vertices.push_back(mesh.nodes[v].x);
  std::size_t n_triangles = 0;
  std::vector<std::size_t> tags;
  for (const FileMesh<2>::Element &cell : mesh.cells) {
    coarse.cells.emplace_back(cell.nodes.begin(), cell.nodes.begin() + cell.n_corners);
    n_triangles += cell.n_corners == 3 ? 1 : 0;
  }
  if (n_triangles > 0)
    coarse = split_cells(coarse);
  for (const FileMesh<2>::Element &cell : mesh.cells)
    tags.insert(tags.end(), n_triangles > 0 ? cell.n_corners : 1, cell.tag);
  if (const auto folded = find_folded_cell(coarse, 0.))
    throw input_error(
      mesh.name, ": the element ", tags[*folded],
      " is turned inside out by its edge on a circle, allowed: a finer mesh there.");
  Geometry<2> geometry = make_body(sides, coarse);
  add_regions(mesh, geometry);
  std::vector<std::string> notes;
  if (n_triangles > 0)
    notes.push_back("each triangle of the mesh is split into three quadrilaterals (" +
                    std::to_string(n_triangles) + " triangles)");
  if (largest_motion > segment_tolerance * geometry.diameter())
    notes.push_back("nodes on arcs are moved onto them, by at most " + number_text(largest_motion));
  geometry.note = join(notes, "; ");
  return geometry;
}
} // namespace Signorini
