// SPDX-License-Identifier: LGPL-2.1-or-later
// From the nodes and elements of a file to a checked 2-D mesh.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/mesh_file/file_mesh.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "file_sides.h"

namespace Signorini
{
namespace
{
using dealii::Point;

/** The smallest sine of the angle in a corner of a cell. */
constexpr double min_sine = 1e-6;

/** The share of the body's size below which two nodes are one. */
constexpr double min_node_distance = 1e-9;

constexpr unsigned int unused = std::numeric_limits<unsigned int>::max();

std::string place_of(const GmshMesh &gmsh, const std::size_t line)
{
  return gmsh.name + ":" + std::to_string(line);
}

std::string point_text(const Point<2> &x)
{
  return "(" + number_text(x[0]) + ", " + number_text(x[1]) + ")";
}

Point<2> position_of(const GmshMesh &gmsh, const unsigned int node)
{
  return {gmsh.nodes[node].x[0], gmsh.nodes[node].x[1]};
}

double cross_product(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/** Checks that the nodes of elements have the same z. @return the size of the box around them. */
double check_nodes(const GmshMesh &gmsh, const std::vector<bool> &is_used)
{
  Point<2> lower, upper;
  const GmshMesh::Node *first = nullptr, *lowest = nullptr, *highest = nullptr;
  for (std::size_t i = 0; i < gmsh.nodes.size(); ++i)
    if (is_used[i])
    {
      const GmshMesh::Node &node = gmsh.nodes[i];
      if (first == nullptr)
      {
        first = lowest = highest = &node;
        lower = upper = position_of(gmsh, i);
      }
      for (unsigned int d = 0; d < 2; ++d)
      {
        lower[d] = std::min(lower[d], node.x[d]);
        upper[d] = std::max(upper[d], node.x[d]);
      }
      lowest = node.x[2] < lowest->x[2] ? &node : lowest;
      highest = node.x[2] > highest->x[2] ? &node : highest;
    }
  const double size = lower.distance(upper);
  if (highest->x[2] - lowest->x[2] > min_node_distance * size)
    throw InputError(place_of(gmsh, highest->line) + ": node " + std::to_string(highest->tag) +
                     " has z = " + number_text(highest->x[2]) + ", node " +
                     std::to_string(lowest->tag) + " z = " + number_text(lowest->x[2]) +
                     ", allowed: a plane body in x and y, with the same z everywhere.");
  return size;
}

/** Refuses two nodes at one place, which would be a crack. */
void check_distances(const GmshMesh &gmsh, const std::vector<bool> &is_used, const double size)
{
  // In an oblique direction few nodes of a mesh lie beside one another.
  const auto along = [&](const unsigned int i) {
    return 0.8191520442889918 * gmsh.nodes[i].x[0] + 0.5735764363510461 * gmsh.nodes[i].x[1];
  };
  std::vector<std::pair<double, unsigned int>> sorted;
  for (unsigned int i = 0; i < gmsh.nodes.size(); ++i)
    if (is_used[i])
      sorted.emplace_back(along(i), i);
  std::sort(sorted.begin(), sorted.end());
  const double tolerance = min_node_distance * size;
  for (std::size_t a = 0; a < sorted.size(); ++a)
    for (std::size_t b = a + 1; b < sorted.size() && sorted[b].first - sorted[a].first < tolerance;
         ++b)
    {
      const unsigned int i = std::min(sorted[a].second, sorted[b].second);
      const unsigned int j = std::max(sorted[a].second, sorted[b].second);
      if (position_of(gmsh, i).distance(position_of(gmsh, j)) < tolerance)
        throw InputError(place_of(gmsh, gmsh.nodes[j].line) + ": nodes " +
                         std::to_string(gmsh.nodes[i].tag) + " and " +
                         std::to_string(gmsh.nodes[j].tag) + " lie both at " +
                         point_text(position_of(gmsh, i)) +
                         ", which is a crack, allowed: one node for every place (Gmsh: Coherence "
                         "Mesh).");
    }
}

/** Turns a clockwise cell round. @throws InputError if it is not convex. */
void make_counter_clockwise(const GmshMesh &gmsh, GmshMesh::Element &cell)
{
  unsigned int n_left = 0, n_right = 0, wrong = 0;
  double sines[4];
  for (unsigned int i = 0; i < 4; ++i)
  {
    const Point<2> x = position_of(gmsh, cell.nodes[i]);
    const Tensor<1, 2> next = position_of(gmsh, cell.nodes[(i + 1) % 4]) - x;
    const Tensor<1, 2> last = position_of(gmsh, cell.nodes[(i + 3) % 4]) - x;
    sines[i] = cross_product(next, last) / (next.norm() * last.norm());
    n_left += sines[i] > min_sine ? 1 : 0;
    n_right += sines[i] < -min_sine ? 1 : 0;
  }
  if (n_right == 4)
  {
    std::swap(cell.nodes[1], cell.nodes[3]);
    if (cell.n_nodes > 4)
    {
      std::swap(cell.nodes[4], cell.nodes[7]);
      std::swap(cell.nodes[5], cell.nodes[6]);
    }
    return;
  }
  if (n_left == 4)
    return;
  for (unsigned int i = 0; i < 4; ++i)
    if (!(n_left >= n_right ? sines[i] > min_sine : sines[i] < -min_sine))
      wrong = i;
  throw InputError(place_of(gmsh, cell.line) + ": the quadrilateral " + std::to_string(cell.tag) +
                   " is not convex at node " + std::to_string(gmsh.nodes[cell.nodes[wrong]].tag) +
                   ", allowed: convex quadrilaterals, all angles below 180 degrees.");
}

/** Sorts the cells in the order of Hilbert's curve through their centres: neighbours in the body
 * are neighbours in memory. */
void sort_along_hilbert_curve(const GmshMesh &gmsh, std::vector<GmshMesh::Element> &cells)
{
  std::vector<Point<2>> centres;
  centres.reserve(cells.size());
  for (const GmshMesh::Element &cell : cells)
  {
    Point<2> centre;
    for (unsigned int i = 0; i < 4; ++i)
      centre += 0.25 * position_of(gmsh, cell.nodes[i]);
    centres.push_back(centre);
  }
  const auto keys = Utilities::inverse_Hilbert_space_filling_curve<2>(centres, 24);
  std::vector<unsigned int> order(cells.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](const unsigned int a, const unsigned int b) {
    return keys[a] < keys[b];
  });
  std::vector<GmshMesh::Element> sorted;
  sorted.reserve(cells.size());
  for (const unsigned int i : order)
    sorted.push_back(cells[i]);
  cells = std::move(sorted);
}

/** Returns the corner whose edge to the next one points most to the right (of two the one that
 * points upwards). If it comes first, cells of a regular mesh are translations of one another. */
unsigned int first_corner(const GmshMesh &gmsh, const GmshMesh::Element &cell)
{
  Tensor<1, 2> directions[4];
  double most = -2.;
  for (unsigned int i = 0; i < 4; ++i)
  {
    directions[i] = position_of(gmsh, cell.nodes[(i + 1) % 4]) - position_of(gmsh, cell.nodes[i]);
    directions[i] /= directions[i].norm();
    most = std::max(most, directions[i][0]);
  }
  unsigned int first = 4;
  for (unsigned int i = 0; i < 4; ++i)
    if (directions[i][0] > most - 1e-6 && (first == 4 || directions[i][1] > directions[first][1]))
      first = i;
  return first;
}

/** Returns the cells with their vertices, which are numbered in the order of their first cells. */
FileMesh number_vertices(const GmshMesh &gmsh, std::vector<GmshMesh::Element> &cells)
{
  FileMesh mesh;
  mesh.file = gmsh.name;
  std::vector<unsigned int> vertex_of_node(gmsh.nodes.size(), unused);
  for (GmshMesh::Element &cell : cells)
  {
    const unsigned int first = first_corner(gmsh, cell);
    std::rotate(cell.nodes.begin(), cell.nodes.begin() + first, cell.nodes.begin() + 4);
    if (cell.n_nodes > 4)
      std::rotate(cell.nodes.begin() + 4, cell.nodes.begin() + 4 + first, cell.nodes.begin() + 8);
    FileMesh::Cell numbered = {{}, cell.tag};
    for (unsigned int i = 0; i < 4; ++i)
    {
      unsigned int &vertex = vertex_of_node[cell.nodes[i]];
      if (vertex == unused)
      {
        vertex = mesh.vertices.size();
        mesh.vertices.push_back({position_of(gmsh, cell.nodes[i]), gmsh.nodes[cell.nodes[i]].tag});
      }
      numbered.corners[i] = vertex;
    }
    mesh.cells.push_back(numbered);
  }
  return mesh;
}
} // namespace

FileMesh make_file_mesh(const GmshMesh &gmsh)
{
  std::vector<bool> is_used(gmsh.nodes.size(), false);
  for (const GmshMesh::Element &cell : gmsh.quadrilaterals)
    for (unsigned int i = 0; i < cell.n_nodes; ++i)
      is_used[cell.nodes[i]] = true;
  const double size = check_nodes(gmsh, is_used);
  check_distances(gmsh, is_used, size);
  std::vector<GmshMesh::Element> cells = gmsh.quadrilaterals;
  for (GmshMesh::Element &cell : cells)
    make_counter_clockwise(gmsh, cell);
  sort_along_hilbert_curve(gmsh, cells);
  FileMesh mesh = number_vertices(gmsh, cells);
  add_boundary(gmsh, cells, mesh);
  return mesh;
}
} // namespace Signorini
