// SPDX-License-Identifier: LGPL-2.1-or-later
// The sides of a body from a mesh file: chains of edges with one name.

#include "file_sides.h"

#include <signorini/base/errors.h>
#include <signorini/base/text.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace Signorini
{
namespace
{
using Chain = std::vector<FileMesh::Edge>;

/** Returns whether a point comes before another one: from left to right, then upwards. */
bool is_left_of(const Point<2> &a, const Point<2> &b)
{
  return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1];
}

/** Returns where a closed chain begins: at its leftmost corner, or without a corner at its leftmost
 * vertex. */
std::size_t start_of_loop(const FileMesh &mesh, const Chain &loop)
{
  const auto position = [&](const std::size_t i) -> const Point<2> & {
    return mesh.vertices[loop[i].start].position;
  };
  const auto is_corner = [&](const std::size_t i) {
    const std::size_t n = loop.size();
    const Tensor<1, 2> in = position(i) - position((i + n - 1) % n);
    const Tensor<1, 2> out = position((i + 1) % n) - position(i);
    // Edges of a circle turn by their angle at its centre: corners turn by more than 60 degrees.
    return in * out < 0.5 * in.norm() * out.norm();
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < loop.size(); ++i)
    if (is_corner(i) != is_corner(best) ? is_corner(i) : is_left_of(position(i), position(best)))
      best = i;
  return best;
}

/** Splits a loop into the chains of edges with one name. */
std::vector<Chain> split_loop(const FileMesh &mesh, Chain loop)
{
  const auto changes = [&](const std::size_t i) {
    return loop[i].name != loop[(i + loop.size() - 1) % loop.size()].name;
  };
  std::size_t first = 0;
  while (first < loop.size() && !changes(first))
    ++first;
  if (first == loop.size())
    first = start_of_loop(mesh, loop);
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
  std::vector<Chain> chains;
  for (const FileMesh::Edge &edge : loop)
  {
    if (chains.empty() || chains.back().back().name != edge.name)
      chains.emplace_back();
    chains.back().push_back(edge);
  }
  return chains;
}

/** A chain and the name of its side. */
struct NamedChain
{
  std::string name;
  Chain edges;
};

/** Returns all chains, by name, and those of one name from left to right. */
std::vector<NamedChain> name_chains(const FileMesh &mesh)
{
  std::vector<Chain> chains;
  for (const Chain &loop : mesh.loops)
    for (Chain &chain : split_loop(mesh, loop))
      chains.push_back(std::move(chain));
  const auto start = [&](const Chain &chain) -> const Point<2> & {
    return mesh.vertices[chain.front().start].position;
  };
  std::sort(chains.begin(), chains.end(), [&](const Chain &a, const Chain &b) {
    return a.front().name != b.front().name ? a.front().name < b.front().name
                                            : is_left_of(start(a), start(b));
  });
  std::vector<NamedChain> named;
  for (std::size_t i = 0, n = 0; i < chains.size(); i += n)
  {
    const unsigned int number = chains[i].front().name;
    n = 1;
    while (i + n < chains.size() && chains[i + n].front().name == number)
      ++n;
    for (std::size_t k = 0; k < n; ++k)
      named.push_back({mesh.names[number] + (n > 1 ? "." + std::to_string(k + 1) : ""),
                       std::move(chains[i + k])});
  }
  return named;
}

void refuse_same_names(const FileMesh &mesh, const std::vector<NamedChain> &chains)
{
  std::set<std::string> names;
  for (const NamedChain &chain : chains)
    if (!names.insert(chain.name).second)
      throw InputError(mesh.file + ": two sides have the name '" + chain.name +
                       "', which also numbers the parts of a side, allowed: another name.");
}

/** Returns whether each chain is declared an arc, by its own name or by that of all chains of a
 * name. */
std::vector<bool> find_arcs(const FileMesh &mesh,
                            const std::vector<NamedChain> &chains,
                            const std::vector<std::string> &arcs,
                            const std::string &where)
{
  std::vector<bool> is_arc(chains.size(), false);
  for (const std::string &arc : arcs)
  {
    bool found = false;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < chains.size(); ++i)
    {
      names.push_back(chains[i].name);
      if (chains[i].name == arc || mesh.names[chains[i].edges.front().name] == arc)
        found = is_arc[i] = true;
    }
    if (!found)
      throw InputError(where + ": found the side " + quote(arc) + ", allowed: " + join(names) +
                       ".");
  }
  return is_arc;
}
} // namespace

FileSides find_sides(FileMesh &mesh, const std::vector<std::string> &arcs, const std::string &where)
{
  const std::vector<NamedChain> chains = name_chains(mesh);
  refuse_same_names(mesh, chains);
  const std::vector<bool> is_arc = find_arcs(mesh, chains, arcs, where);
  FileSides found;
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    const Chain &chain = chains[i].edges;
    const std::vector<ChainPiece> pieces =
      is_arc[i] ? std::vector<ChainPiece>{make_arc(
                    mesh, chain, where + ": the side " + quote(chains[i].name))}
                : divide_chain(mesh, chain);
    std::vector<Curve> curves;
    for (const ChainPiece &piece : pieces)
    {
      int circle = -1;
      if (piece.circle)
      {
        circle = static_cast<int>(found.centres.size());
        found.centres.push_back(piece.circle->centre);
      }
      for (std::size_t e = piece.first; e < piece.last; ++e)
        found.edges.push_back({chain[e], static_cast<unsigned int>(i), circle});
      move_onto(piece, chain, mesh);
      curves.push_back(piece.curve);
    }
    found.sides.emplace_back(chains[i].name,
                             curves.size() == 1 ? curves.front() : Curve::chain(curves));
  }
  return found;
}

// The edges of a mesh from a file: between two cells, or on the boundary with a name.

const std::string unnamed_side_name = "rest";

namespace
{
/** An edge with the direction that it has in one of its cells. */
struct HalfEdge
{
  /** The nodes in the file. */
  unsigned int start, end;
  unsigned int cell, edge_of_cell;

  /** Returns the nodes in an order that is the same for both cells of an edge. */
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

  /** Returns the edges with one cell. */
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

  /** Returns whether two nodes are joined by an edge. */
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

  /** Checks that every cell can be reached from every other one through edges. */
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

/** The name of an edge and the line of the file that gives it. */
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

/** Returns the physical name of a line; a group without a name is called by its number. */
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
  if (name == unnamed_side_name)
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

/** Returns the node in the middle of an edge, of its cell or of its line. */
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
    names.insert(is_named ? line_of.back()->name : unnamed_side_name);
  }
  mesh.names.assign(names.begin(), names.end());
  std::vector<FileMesh::Edge> edges;
  for (std::size_t i = 0; i < boundary.size(); ++i)
  {
    const HalfEdge &edge = boundary[i];
    const FileMesh::Cell &cell = mesh.cells[edge.cell];
    const bool is_named = line_of[i] != nullptr && !line_of[i]->name.empty();
    const auto name = std::lower_bound(
      mesh.names.begin(), mesh.names.end(), is_named ? line_of[i]->name : unnamed_side_name);
    edges.push_back({cell.corners[edge.edge_of_cell],
                     cell.corners[(edge.edge_of_cell + 1) % 4],
                     middle_of(gmsh, cells[edge.cell], edge, line_of[i]),
                     static_cast<unsigned int>(name - mesh.names.begin()),
                     edge.cell,
                     edge.edge_of_cell});
  }
  // The order of the cells does not depend on the numbers in the file.
  std::sort(edges.begin(), edges.end(), [](const FileMesh::Edge &a, const FileMesh::Edge &b) {
    return a.cell != b.cell ? a.cell < b.cell : a.edge_of_cell < b.edge_of_cell;
  });
  mesh.loops = make_loops(edges, mesh);
}
} // namespace Signorini
