// SPDX-License-Identifier: LGPL-2.1-or-later
// From the nodes and elements of a file to a checked 2-D mesh in order, with its boundary.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/mesh_file/file_mesh.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>

namespace Signorini {
namespace {
/** The smallest sine of the angle in a corner of a cell. */
constexpr double min_sine = 1e-6;

/** The share of the body's size below which two nodes are one. */
constexpr double min_node_distance = 1e-9;

using Node = FileMesh<2>::Node;
using FileElement = FileMesh<2>::Element;

/** Checks that the corners of cells, the first nodes, have the same z, and that no two are at one
 * point. */
void check_nodes(const FileMesh<2> &mesh, const unsigned int n_corners) {
  std::vector<const Node *> nodes;
  double size = 0.;
  for (unsigned int i = 0; i < n_corners; ++i) {
    nodes.push_back(&mesh.nodes[i]);
    size = std::max(size, mesh.nodes[i].x.distance(mesh.nodes[0].x));
  }
  const auto [lowest, highest] = std::minmax_element(
    nodes.begin(), nodes.end(), [](const Node *a, const Node *b) { return a->z < b->z; });
  if ((*highest)->z - (*lowest)->z > min_node_distance * size)
    throw input_error(mesh.location((*highest)->line), "node ", (*highest)->tag,
                      " has z = ", (*highest)->z, ", node ", (*lowest)->tag, " z = ", (*lowest)->z,
                      ", allowed: a plane body in x and y, with the same z everywhere.");
  check_cracks(mesh, nodes);
}

/** Turns a clockwise cell round. @throws InputError if it is not convex. */
void make_counter_clockwise(const FileMesh<2> &mesh, FileElement &cell) {
  const unsigned int n = cell.n_corners;
  const auto corner = [&](const unsigned int i) { return mesh.nodes[cell.nodes[i % n]].x; };
  std::array<double, 4> sines;
  unsigned int n_left = 0, n_right = 0, wrong = 0;
  for (unsigned int i = 0; i < n; ++i) {
    const Tensor<1, 2> next = corner(i + 1) - corner(i), last = corner(i + n - 1) - corner(i);
    sines[i] = next * cross_product_2d(last) / (next.norm() * last.norm());
    n_left += sines[i] > min_sine ? 1 : 0;
    n_right += sines[i] < -min_sine ? 1 : 0;
  }
  if (n_right == n) {
    std::reverse(cell.nodes.begin() + 1, cell.nodes.begin() + n);
    if (cell.is_quadratic)
      std::reverse(cell.nodes.begin() + n, cell.nodes.begin() + 2 * n);
  }
  if (std::max(n_left, n_right) == n)
    return;
  for (unsigned int i = 0; i < n; ++i)
    if (!((n_left >= n_right ? sines[i] : -sines[i]) > min_sine))
      wrong = i;
  throw input_error(mesh.location(cell.line), "the element ", cell.tag, " is not convex at node ",
                    mesh.nodes[cell.nodes[wrong]].tag,
                    ", allowed: convex elements, all angles below 180 degrees.");
}

/** Lets a cell begin with the corner whose edge to the next one points most to the right (of two
 * the one that points upwards): then cells of a regular mesh are translations of one another. */
void turn_to_first_corner(const FileMesh<2> &mesh, FileElement &cell) {
  const unsigned int n = cell.n_corners;
  unsigned int first = 0;
  Tensor<1, 2> best({-2., 0.});
  for (unsigned int i = 0; i < n; ++i) {
    Tensor<1, 2> d = mesh.nodes[cell.nodes[(i + 1) % n]].x - mesh.nodes[cell.nodes[i]].x;
    d /= d.norm();
    if (d[0] > best[0] + 1e-6 || (d[0] > best[0] - 1e-6 && d[1] > best[1])) {
      first = i;
      best = d;
    }
  }
  const auto turn = [&](const auto begin) { std::rotate(begin, begin + first, begin + n); };
  turn(cell.nodes.begin());
  if (cell.is_quadratic)
    turn(cell.nodes.begin() + n);
}

/** Sorts the cells in the order of Hilbert's curve through their centres. */
void sort_cells(FileMesh<2> &mesh) {
  std::vector<Point<2>> centres;
  for (FileElement &cell : mesh.cells) {
    centres.emplace_back();
    for (unsigned int i = 0; i < cell.n_corners; ++i)
      centres.back() += mesh.nodes[cell.nodes[i]].x / static_cast<double>(cell.n_corners);
  }
  std::vector<FileElement> sorted;
  sorted.reserve(centres.size());
  for (const unsigned int i : order_on_curve(centres))
    sorted.push_back(mesh.cells[i]);
  mesh.cells = std::move(sorted);
}

/** Gives the nodes new indices, the corners of cells first, in the order of the cells. @return the
 * number of corners. */
unsigned int number_nodes(FileMesh<2> &mesh) {
  constexpr unsigned int unused = std::numeric_limits<unsigned int>::max();
  std::vector<unsigned int> number(mesh.nodes.size(), unused);
  std::vector<Node> nodes;
  const auto take = [&](const unsigned int i) {
    if (number[i] == unused) {
      number[i] = nodes.size();
      nodes.push_back(mesh.nodes[i]);
    }
  };
  for (const FileElement &cell : mesh.cells)
    std::for_each(cell.nodes.begin(), cell.nodes.begin() + cell.n_corners, take);
  const auto n_corners = static_cast<unsigned int>(nodes.size());
  for (unsigned int i = 0; i < mesh.nodes.size(); ++i)
    take(i);
  mesh.nodes = std::move(nodes);
  for (std::vector<FileElement> *const elements : {&mesh.faces, &mesh.cells})
    for (FileElement &element : *elements)
      for (unsigned int &node : element.nodes)
        node = number[node];
  return n_corners;
}

/** An edge of a cell in the direction that is counter-clockwise there. */
struct HalfEdge {
  unsigned int start, end, middle;
  const FileElement *cell;

  bool operator<(const HalfEdge &other) const {
    return std::tie(start, end) < std::tie(other.start, other.end);
  }
};

std::string edge_text(const FileMesh<2> &mesh, const unsigned int start, const unsigned int end) {
  return " between nodes " + std::to_string(mesh.nodes[start].tag) + " and " +
         std::to_string(mesh.nodes[end].tag);
}

/** Returns the edges of all cells, sorted. @throws InputError if two cells have one edge on the
 * same side. */
std::vector<HalfEdge> find_edges(const FileMesh<2> &mesh) {
  std::vector<HalfEdge> edges;
  for (const FileElement &cell : mesh.cells)
    for (unsigned int i = 0, n = cell.n_corners; i < n; ++i)
      edges.push_back(
        {cell.nodes[i], cell.nodes[(i + 1) % n], cell.nodes[cell.is_quadratic ? n + i : i], &cell});
  std::stable_sort(edges.begin(), edges.end());
  const auto twin = std::adjacent_find(
    edges.begin(), edges.end(), [](const HalfEdge &a, const HalfEdge &b) { return !(a < b); });
  if (twin == edges.end())
    return edges;
  const auto [first, second] = std::minmax(twin->cell->tag, (twin + 1)->cell->tag);
  throw input_error(mesh.location(std::max(twin->cell->line, (twin + 1)->cell->line)), "the edge",
                    edge_text(mesh, twin->start, twin->end), " has the elements ", first, " and ",
                    second, " on the same side, allowed: elements that do not lie on one another.");
}

using Ends = std::pair<unsigned int, unsigned int>;

/** Returns the lines of the file by their ends, the smaller one first. */
std::map<Ends, const FileElement *> find_lines(const FileMesh<2> &mesh,
                                               const std::vector<HalfEdge> &edges) {
  std::map<Ends, const FileElement *> lines;
  for (const FileElement &line : mesh.faces) {
    const unsigned int a = line.nodes[0], b = line.nodes[1];
    const auto has = [&](const unsigned int start, const unsigned int end) {
      return std::binary_search(edges.begin(), edges.end(), HalfEdge{start, end, 0, nullptr});
    };
    const auto refuse = [&](const std::string &reason) {
      throw input_error(mesh.location(line.line), "the line ", line.tag, edge_text(mesh, a, b),
                        reason);
    };
    if (!has(a, b) && !has(b, a)) {
      // Curves that helped to construct a body have no names.
      if (line.group != 0 && !mesh.is_part)
        refuse(" is not an edge of an element, allowed: lines along edges.");
      continue;
    }
    const FileElement *&known = lines[std::minmax(a, b)];
    if (known == nullptr || known->group == 0)
      known = &line;
    const std::string name = mesh.name_of(*known, 1), other = mesh.name_of(line, 1);
    if (line.group != 0 && name != other)
      refuse(" has the physical names " + quote(name) + " and " + quote(other) + ", allowed: one.");
  }
  return lines;
}

/** Joins the edges with one cell to loops. */
void find_loops(FileMesh<2> &mesh) {
  const std::vector<HalfEdge> edges = find_edges(mesh);
  const auto lines = find_lines(mesh, edges);
  std::map<unsigned int, FileMesh<2>::Edge> edge_from;
  for (const HalfEdge &edge : edges) {
    if (std::binary_search(edges.begin(), edges.end(), HalfEdge{edge.end, edge.start, 0, nullptr}))
      continue;
    const auto line = lines.find(std::minmax(edge.start, edge.end));
    FileMesh<2>::Edge found = {edge.start, edge.end, edge.middle, unnamed};
    if (line != lines.end()) {
      found.name = mesh.name_of(*line->second, 1);
      if (line->second->is_quadratic)
        found.middle = line->second->nodes[2];
    }
    if (!edge_from.emplace(edge.start, found).second)
      throw input_error(mesh.name, ": the body touches itself at node ", mesh.nodes[edge.start].tag,
                        ", allowed: a body whose parts share edges.");
  }
  std::vector<unsigned int> outer;
  while (!edge_from.empty()) {
    mesh.loops.emplace_back();
    double area = 0.;
    const Point<2> &first = mesh.nodes[edge_from.begin()->first].x;
    for (auto edge = edge_from.begin(); edge != edge_from.end();
         edge = edge_from.find(mesh.loops.back().back().end)) {
      const Tensor<1, 2> a = mesh.nodes[edge->second.start].x - first,
                         b = mesh.nodes[edge->second.end].x - first;
      area += a * cross_product_2d(b);
      mesh.loops.back().push_back(edge->second);
      edge_from.erase(edge);
    }
    if (area > 0.)
      outer.push_back(mesh.loops.back()[0].start);
  }
  if (outer.size() > 1)
    throw input_error(mesh.name, ": nodes ", mesh.nodes[outer[0]].tag, " and ",
                      mesh.nodes[outer[1]].tag,
                      " belong to parts that no edges connect, allowed: one body.");
}
} // namespace

template <int dim>
std::string FileMesh<dim>::name_of(const Element &element, const unsigned int dimension) const {
  if (element.group == 0)
    return has_groups[dimension] ? unnamed : std::to_string(element.entity);
  const auto found = group_names.find({dimension, element.group});
  if (found == group_names.end())
    return std::to_string(element.group);
  const std::string &group = found->second;
  // The names of regions stand before a ':', those of sides between blanks.
  const bool is_word = !group.empty() && std::all_of(group.begin(), group.end(), [&](const char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.' ||
           (c == ' ' && dimension == dim);
  });
  if (!is_word)
    throw input_error(
      name, ": found the physical name ", quote(group),
      ", allowed: names of letters, digits, '_', '-' and '.', because the parameter "
      "file separates names by blanks.");
  if (group == unnamed)
    throw input_error(name, ": found the physical name ", quote(group),
                      ", allowed: another one, because this is the name of all that have none.");
  return group;
}

template struct FileMesh<2>;
template struct FileMesh<3>;

std::vector<std::string> number_names(const std::vector<std::string> &names,
                                      const std::string &file) {
  std::vector<std::string> numbered;
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::size_t number = 1;
    while (number <= i && names[i - number] == names[i])
      ++number;
    const bool is_alone = number == 1 && (i + 1 == names.size() || names[i + 1] != names[i]);
    numbered.push_back(is_alone ? names[i] : names[i] + "." + std::to_string(number));
  }
  for (const std::string &name : numbered)
    if (std::count(numbered.begin(), numbered.end(), name) > 1)
      throw input_error(file, ": two sides have the name '", name,
                        "', which also numbers the parts of a side, allowed: another name.");
  return numbered;
}

template <int dim>
void check_cracks(const FileMesh<dim> &mesh,
                  std::vector<const typename FileMesh<dim>::Node *> nodes) {
  // In an oblique direction few nodes of a mesh lie beside one another.
  constexpr std::array<double, 3> oblique = {0.7071, 0.5774, 0.4082};
  const auto height = [&](const auto *node) {
    return std::inner_product(node->x.begin_raw(), node->x.end_raw(), oblique.begin(), 0.);
  };
  std::stable_sort(nodes.begin(), nodes.end(),
                   [&](const auto *a, const auto *b) { return height(a) < height(b); });
  double size = 0.;
  for (const auto *node : nodes)
    size = std::max(size, node->x.distance(nodes[0]->x));
  const double tolerance = min_node_distance * size;
  for (auto a = nodes.begin(); a != nodes.end(); ++a)
    for (auto b = a + 1; b != nodes.end() && height(*b) - height(*a) < tolerance; ++b)
      if ((*a)->x.distance((*b)->x) < tolerance) {
        const auto [first, second] = std::minmax((*a)->tag, (*b)->tag);
        throw input_error(
          mesh.location(std::max((*a)->line, (*b)->line)), "nodes ", first, " and ", second,
          " lie both at ", vector_text((*a)->x),
          ", which is a crack, allowed: one node for every place (Gmsh: Coherence Mesh).");
      }
}

template void check_cracks<2>(const FileMesh<2> &, std::vector<const FileMesh<2>::Node *>);
template void check_cracks<3>(const FileMesh<3> &, std::vector<const FileMesh<3>::Node *>);

template <int dim>
std::vector<unsigned int> order_on_curve(const std::vector<Point<dim>> &points) {
  const auto keys = Utilities::inverse_Hilbert_space_filling_curve<dim>(points, dim == 2 ? 24 : 20);
  std::vector<unsigned int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](const unsigned int a, const unsigned int b) { return keys[a] < keys[b]; });
  return order;
}

INSTANTIATE_FUNCTION(order_on_curve);

void keep_part(FileMesh<2> &mesh, const std::string &body, const std::vector<std::string> &bodies) {
  const auto is_body = [&](const std::string &name) {
    return std::count(bodies.begin(), bodies.end(), name) > 0;
  };
  std::set<std::string> surfaces;
  const auto is_foreign = [&](const FileElement &cell) {
    const std::string surface = mesh.name_of(cell, 2);
    const std::string owner = is_body(surface) ? surface : surface.substr(0, surface.find('.'));
    if (!is_body(owner))
      throw input_error(mesh.name, ": found the surface ", quote(surface),
                        ", allowed: those of the bodies ", join(bodies), ".");
    surfaces.insert(surface);
    return owner != body;
  };
  mesh.cells.erase(std::remove_if(mesh.cells.begin(), mesh.cells.end(), is_foreign),
                   mesh.cells.end());
  if (mesh.cells.empty())
    throw input_error(mesh.name, ": found no surface ", quote(body),
                      " for this body, allowed: ", join({surfaces.begin(), surfaces.end()}), ".");
  for (auto &[group, name] : mesh.group_names)
    if (group.first == 2 && name.rfind(body + ".", 0) == 0)
      name.erase(0, body.size() + 1);
  mesh.is_part = true;
}

unsigned int check_and_sort(FileMesh<2> &mesh) {
  check_nodes(mesh, number_nodes(mesh));
  for (FileElement &cell : mesh.cells) {
    make_counter_clockwise(mesh, cell);
    turn_to_first_corner(mesh, cell);
  }
  sort_cells(mesh);
  const unsigned int n_vertices = number_nodes(mesh);
  find_loops(mesh);
  return n_vertices;
}
} // namespace Signorini
