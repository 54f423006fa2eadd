// SPDX-License-Identifier: LGPL-2.1-or-later
// The sides of a body from a mesh file: chains of edges with one name.

#include "file_sides.h"

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "edge_chain.h"

namespace Signorini
{
namespace
{
using Chain = std::vector<FileMesh::Edge>;

/** From left to right, then upwards. */
bool is_left_of(const dealii::Point<2> &a, const dealii::Point<2> &b)
{
  return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1];
}

/** Where a closed chain begins: at its leftmost corner, or without a corner at its leftmost vertex.
 */
std::size_t start_of_loop(const FileMesh &mesh, const Chain &loop)
{
  const auto position = [&](const std::size_t i) -> const dealii::Point<2> & {
    return mesh.vertices[loop[i].start].position;
  };
  const auto is_corner = [&](const std::size_t i) {
    const std::size_t n = loop.size();
    const dealii::Tensor<1, 2> in = position(i) - position((i + n - 1) % n);
    const dealii::Tensor<1, 2> out = position((i + 1) % n) - position(i);
    // Edges of a circle turn by their angle at its centre: corners turn by more than 60 degrees.
    return in * out < 0.5 * in.norm() * out.norm();
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < loop.size(); ++i)
    if (is_corner(i) != is_corner(best) ? is_corner(i) : is_left_of(position(i), position(best)))
      best = i;
  return best;
}

/** The chains of edges with one name in a loop. */
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

/** All chains, by name, and those of one name from left to right. */
std::vector<NamedChain> name_chains(const FileMesh &mesh)
{
  std::vector<Chain> chains;
  for (const Chain &loop : mesh.loops)
    for (Chain &chain : split_loop(mesh, loop))
      chains.push_back(std::move(chain));
  const auto start = [&](const Chain &chain) -> const dealii::Point<2> & {
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

/** Whether each chain is declared an arc, by its own name or by that of all chains of a name. */
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
} // namespace Signorini
