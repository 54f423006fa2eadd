// SPDX-License-Identifier: LGPL-2.1-or-later
// The edges of a mesh from a file: between two cells, or on the boundary with a name.

#include "file_edges.h"

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>
#include <set>

namespace Signorini
{
const std::string name_of_the_rest = "rest";

namespace
{
/** An edge as one of its cells sees it. */
struct HalfEdge
{
  /** Nodes of the file. */
  unsigned int start, end;
  unsigned int cell, edge_of_cell;

  /** The same for both cells of an edge. */
  std::pair<unsigned int, unsigned int> key() const
  {
    return std::minmax(start, end);
  }
};

bool by_key(const HalfEdge &a, const HalfEdge &b)
{
  return a.key() != b.key() ? a.key() < b.key() : a.cell < b.cell;
}

/** The edges of one file. */
class EdgeTable
{
public:
  EdgeTable(const GmshMesh &gmsh, const std::vector<GmshMesh::Element> &cells)
    : gmsh_(gmsh)
    , cells_(cells)
  {
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int e = 0; e < 4; ++e)
        edges_.push_back({cells[c].nodes[e], cells[c].nodes[(e + 1) % 4], c, e});
    std::sort(edges_.begin(), edges_.end(), by_key);
    check();
    check_connection();
  }

  /** The edges with one cell. */
  std::vector<HalfEdge> boundary() const
  {
    std::vector<HalfEdge> found;
    for (std::size_t i = 0, n = 0; i < edges_.size(); i += n)
    {
      n = multiplicity(i);
      if (n == 1)
        found.push_back(edges_[i]);
    }
    return found;
  }

  /** Whether two nodes are joined by an edge. */
  bool has(const unsigned int start, const unsigned int end) const
  {
    const HalfEdge wanted = {start, end, 0, 0};
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), wanted, by_key);
    return found != edges_.end() && found->key() == wanted.key();
  }

private:
  std::size_t multiplicity(const std::size_t i) const
  {
    std::size_t n = 1;
    while (i + n < edges_.size() && edges_[i + n].key() == edges_[i].key())
      ++n;
    return n;
  }

  std::string where(const HalfEdge &edge) const
  {
    return gmsh_.name + ":" + std::to_string(cells_[edge.cell].line) + ": the edge between nodes " +
           std::to_string(gmsh_.nodes[edge.start].tag) + " and " +
           std::to_string(gmsh_.nodes[edge.end].tag);
  }

  std::string name(const HalfEdge &edge) const
  {
    return std::to_string(cells_[edge.cell].tag);
  }

  void check() const
  {
    for (std::size_t i = 0, n = 0; i < edges_.size(); i += n)
    {
      n = multiplicity(i);
      if (n > 2)
        throw InputError(where(edges_[i + 2]) + " belongs to the quadrilaterals " +
                         name(edges_[i]) + ", " + name(edges_[i + 1]) + " and " +
                         name(edges_[i + 2]) + ", allowed: two at most.");
      if (n == 2 && edges_[i].start == edges_[i + 1].start)
        throw InputError(where(edges_[i + 1]) + " has the quadrilaterals " + name(edges_[i]) +
                         " and " + name(edges_[i + 1]) +
                         " on the same side, allowed: quadrilaterals that do not lie on one "
                         "another.");
    }
  }

  /** From one cell every other one can be reached through edges. */
  void check_connection() const
  {
    std::vector<unsigned int> parent(cells_.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](unsigned int c) {
      while (parent[c] != c)
        c = parent[c] = parent[parent[c]];
      return c;
    };
    for (std::size_t i = 0; i + 1 < edges_.size(); ++i)
      if (edges_[i].key() == edges_[i + 1].key())
        parent[root(edges_[i].cell)] = root(edges_[i + 1].cell);
    for (unsigned int c = 1; c < cells_.size(); ++c)
      if (root(c) != root(0))
        throw InputError(gmsh_.name + ":" + std::to_string(cells_[c].line) +
                         ": the quadrilaterals " + std::to_string(cells_[0].tag) + " and " +
                         std::to_string(cells_[c].tag) +
                         " belong to parts that no edges connect, allowed: one body.");
  }

  const GmshMesh &gmsh_;
  const std::vector<GmshMesh::Element> &cells_;
  std::vector<HalfEdge> edges_;
};

/** What a line of the file says about an edge. */
struct NamedLine
{
  std::string name;
  const GmshMesh::Element *line;
};
using NamedLines = std::map<std::pair<unsigned int, unsigned int>, NamedLine>;

std::string where(const GmshMesh &gmsh, const GmshMesh::Element &line)
{
  return gmsh.name + ":" + std::to_string(line.line) + ": the line " + std::to_string(line.tag) +
         " between nodes " + std::to_string(gmsh.nodes[line.nodes[0]].tag) + " and " +
         std::to_string(gmsh.nodes[line.nodes[1]].tag);
}

/** The physical name of a line; a group without a name is called by its number. */
std::string name_of(const GmshMesh &gmsh, const GmshMesh::Element &line)
{
  if (line.group == 0)
    return "";
  const auto found = gmsh.curve_names.find(line.group);
  const std::string name =
    found == gmsh.curve_names.end() ? std::to_string(line.group) : found->second;
  const bool is_word = !name.empty() && std::all_of(name.begin(), name.end(), [](const char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
  });
  if (!is_word)
    throw InputError(gmsh.name + ": found the physical name " + quote(name) +
                     ", allowed: names of letters, digits, '_', '-' and '.', because the parameter "
                     "file separates names by blanks.");
  if (name == name_of_the_rest)
    throw InputError(gmsh.name + ": found the physical name " + quote(name) +
                     ", allowed: another one, because this is the side of all edges without a "
                     "name.");
  return name;
}

NamedLines read_lines(const GmshMesh &gmsh, const EdgeTable &edges)
{
  NamedLines lines;
  for (const GmshMesh::Element &line : gmsh.lines)
  {
    if (!edges.has(line.nodes[0], line.nodes[1]))
      throw InputError(where(gmsh, line) +
                       " is not an edge of a quadrilateral, allowed: lines along edges.");
    const std::string name = name_of(gmsh, line);
    const auto known =
      lines.emplace(std::minmax(line.nodes[0], line.nodes[1]), NamedLine{name, &line}).first;
    if (known->second.name.empty())
      known->second = {name, &line};
    else if (!name.empty() && known->second.name != name)
      throw InputError(where(gmsh, line) + " has the physical names " + quote(known->second.name) +
                       " and " + quote(name) + ", allowed: one.");
  }
  return lines;
}

/** The node in the middle of an edge, of its cell or of its line. */
std::optional<FileMesh::Vertex> middle_of(const GmshMesh &gmsh,
                                          const GmshMesh::Element &cell,
                                          const HalfEdge &edge,
                                          const NamedLine *line)
{
  const bool is_in_cell = cell.n_nodes > 4;
  if (!is_in_cell && (line == nullptr || line->line->n_nodes < 3))
    return {};
  const GmshMesh::Node &node =
    gmsh.nodes[is_in_cell ? cell.nodes[4 + edge.edge_of_cell] : line->line->nodes[2]];
  return FileMesh::Vertex{{node.x[0], node.x[1]}, node.tag};
}

/** Joins edges to loops, beginning with the first edge that is left. */
std::vector<std::vector<FileMesh::Edge>> make_loops(const std::vector<FileMesh::Edge> &edges,
                                                    const FileMesh &mesh)
{
  std::map<unsigned int, unsigned int> edge_from;
  for (unsigned int i = 0; i < edges.size(); ++i)
    if (!edge_from.emplace(edges[i].start, i).second)
      throw InputError(mesh.file + ": the body touches itself at node " +
                       std::to_string(mesh.vertices[edges[i].start].tag) +
                       ", allowed: a body whose parts share edges.");
  std::vector<std::vector<FileMesh::Edge>> loops;
  std::vector<bool> is_done(edges.size(), false);
  for (unsigned int first = 0; first < edges.size(); ++first)
  {
    if (is_done[first])
      continue;
    loops.emplace_back();
    for (unsigned int i = first; !is_done[i]; i = edge_from.at(edges[i].end))
    {
      is_done[i] = true;
      loops.back().push_back(edges[i]);
    }
  }
  return loops;
}
} // namespace

void add_boundary(const GmshMesh &gmsh, const std::vector<GmshMesh::Element> &cells, FileMesh &mesh)
{
  const EdgeTable table(gmsh, cells);
  const NamedLines lines = read_lines(gmsh, table);
  const std::vector<HalfEdge> boundary = table.boundary();
  std::vector<const NamedLine *> line_of;
  std::set<std::string> names;
  for (const HalfEdge &edge : boundary)
  {
    const auto line = lines.find(edge.key());
    line_of.push_back(line == lines.end() ? nullptr : &line->second);
    const bool is_named = line_of.back() != nullptr && !line_of.back()->name.empty();
    names.insert(is_named ? line_of.back()->name : name_of_the_rest);
  }
  mesh.names.assign(names.begin(), names.end());
  std::vector<FileMesh::Edge> edges;
  for (std::size_t i = 0; i < boundary.size(); ++i)
  {
    const HalfEdge &edge = boundary[i];
    const FileMesh::Cell &cell = mesh.cells[edge.cell];
    const bool is_named = line_of[i] != nullptr && !line_of[i]->name.empty();
    const auto name = std::lower_bound(
      mesh.names.begin(), mesh.names.end(), is_named ? line_of[i]->name : name_of_the_rest);
    edges.push_back({cell.corners[edge.edge_of_cell],
                     cell.corners[(edge.edge_of_cell + 1) % 4],
                     middle_of(gmsh, cells[edge.cell], edge, line_of[i]),
                     static_cast<unsigned int>(name - mesh.names.begin()),
                     edge.cell,
                     edge.edge_of_cell});
  }
  // In the order of the cells, which does not depend on the numbers of the file.
  std::sort(edges.begin(), edges.end(), [](const FileMesh::Edge &a, const FileMesh::Edge &b) {
    return a.cell != b.cell ? a.cell < b.cell : a.edge_of_cell < b.edge_of_cell;
  });
  mesh.loops = make_loops(edges, mesh);
}
} // namespace Signorini
