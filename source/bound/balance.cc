// SPDX-License-Identifier: LGPL-2.1-or-later
// Carries what cells lack in balance to the supports.

#include <signorini/bound/balance.h>
#include <signorini/elasticity/resultant.h>

#include <cmath>

namespace Signorini
{
namespace
{
using Vector2 = dealii::Tensor<1, 2>;

constexpr unsigned int no_cell = static_cast<unsigned int>(-1);

/** The edge of a cell with its number there. */
struct CellEdge
{
  unsigned int cell, k;
};

/** Adds to the traction on edge k of a cell the linear one with the given resultant. */
void add_resultant(const EdgeCell &cell,
                   const unsigned int k,
                   const Resultant<2> &resultant,
                   std::vector<double> &moments)
{
  const dealii::Point<2> &a = cell.corners[k], &b = cell.corners[(k + 1) % 4];
  const dealii::Point<2> middle = a + 0.5 * (b - a);
  Vector2 normal({b[1] - a[1], a[0] - b[0]});
  normal /= normal.norm();
  // Half of the force at either end, and a couple that is normal to the edge.
  const double couple = resultant.moment_about(middle)[0] / moment_of(a - b, normal)[0];
  CellMoments change{};
  for (unsigned int c = 0; c < 2; ++c)
  {
    change[4 * k + c] = 0.5 * resultant.force[c] + couple * normal[c];
    change[4 * k + 2 + c] = 0.5 * resultant.force[c] - couple * normal[c];
  }
  add_moments(cell, change, moments);
}

/** A tree of cells: every cell but the root knows the edge that leads towards the root. */
class CellTree
{
public:
  CellTree(const EdgeMesh &mesh, const unsigned int root)
    : mesh_(mesh)
    , parent_(mesh.cells().size(), {no_cell, 0})
  {
    std::vector<std::array<unsigned int, 2>> cells_at(mesh.edges().size(), {{no_cell, no_cell}});
    for (unsigned int c = 0; c < mesh.cells().size(); ++c)
      for (unsigned int k = 0; k < 4; ++k)
        cells_at[mesh.cells()[c].edges[k]][mesh.cells()[c].sign[k] > 0. ? 0 : 1] = c;
    order_.push_back(root);
    for (std::size_t i = 0; i < order_.size(); ++i)
      for (const unsigned int edge : mesh.cells()[order_[i]].edges)
        for (const unsigned int other : cells_at[edge])
          if (other != no_cell && other != root && parent_[other].cell == no_cell)
          {
            unsigned int k = 0;
            while (mesh.cells()[other].edges[k] != edge)
              ++k;
            parent_[other] = {order_[i], k};
            order_.push_back(other);
          }
  }
  /** Passes what every cell lacks on to its parent. @return what the root lacks then. */
  Resultant<2> collect(std::vector<Resultant<2>> lacking, std::vector<double> &moments) const
  {
    for (std::size_t i = order_.size(); i-- > 1;)
    {
      const unsigned int c = order_[i];
      add_resultant(mesh_.cells()[c], parent_[c].k, lacking[c], moments);
      lacking[parent_[c].cell] += lacking[c];
    }
    return lacking[order_[0]];
  }
  /** Hands a resultant over from the root to a cell: the traction on the cell, from the side of the
   * root, is its opposite. */
  void hand_over(unsigned int cell, Resultant<2> resultant, std::vector<double> &moments) const
  {
    resultant.force *= -1.;
    resultant.moment *= -1.;
    for (; parent_[cell].cell != no_cell; cell = parent_[cell].cell)
      add_resultant(mesh_.cells()[cell], parent_[cell].k, resultant, moments);
  }

private:
  const EdgeMesh &mesh_;
  std::vector<CellEdge> parent_;
  std::vector<unsigned int> order_;
};

/** Edges that take what is left: one for any traction, or two rollers. */
std::vector<CellEdge> find_supports(const EdgeMesh &mesh)
{
  std::vector<CellEdge> rollers;
  Vector2 first_normal;
  for (unsigned int c = 0; c < mesh.cells().size(); ++c)
    for (unsigned int k = 0; k < 4; ++k)
    {
      const Edge &edge = mesh.edges()[mesh.cells()[c].edges[k]];
      if (edge.side == Edge::no_side || edge.freedom == EdgeFreedom::none)
        continue;
      if (edge.freedom == EdgeFreedom::any)
        return {{c, k}};
      if (rollers.empty())
        first_normal = edge.normal;
      if (rollers.empty() ||
          (rollers.size() == 1 && std::abs(moment_of(first_normal, edge.normal)[0]) > 1e-3))
        rollers.push_back({c, k});
    }
  return rollers;
}

/** Cell by cell, the resultant of rest at its corners. */
std::vector<Resultant<2>> lacking_resultants(const EdgeMesh &mesh, const std::vector<Vector2> &rest)
{
  std::vector<Resultant<2>> lacking(mesh.cells().size());
  for (std::size_t c = 0; c < lacking.size(); ++c)
    for (unsigned int a = 0; a < 4; ++a)
      lacking[c].add(rest[mesh.cells()[c].vertices[a]], mesh.cells()[c].corners[a]);
  return lacking;
}
} // namespace

bool balance_cells(const EdgeMesh &mesh,
                   const std::vector<Vector2> &rest,
                   std::vector<double> &moments)
{
  const std::vector<CellEdge> supports = find_supports(mesh);
  if (supports.empty())
    return false;
  const EdgeCell &root = mesh.cells()[supports[0].cell];
  const Edge &edge = mesh.edges()[root.edges[supports[0].k]];
  if (edge.freedom == EdgeFreedom::normal && supports.size() < 2)
    return false;
  const CellTree tree(mesh, supports[0].cell);
  Resultant<2> left = tree.collect(lacking_resultants(mesh, rest), moments);
  if (edge.freedom == EdgeFreedom::normal)
  {
    // The second roller takes the part of the force that the first one cannot.
    const EdgeCell &cell = mesh.cells()[supports[1].cell];
    const unsigned int k = supports[1].k;
    const Vector2 &n = mesh.edges()[cell.edges[k]].normal;
    const double size = moment_of(edge.normal, left.force)[0] / moment_of(edge.normal, n)[0];
    Resultant<2> second;
    second.add(size * n, cell.corners[k] + 0.5 * (cell.corners[(k + 1) % 4] - cell.corners[k]));
    add_resultant(cell, k, second, moments);
    tree.hand_over(supports[1].cell, second, moments);
    left.force -= second.force;
    left.moment -= second.moment;
    // Normal up to rounding.
    left.force = (left.force * edge.normal) * edge.normal;
  }
  add_resultant(root, supports[0].k, left, moments);
  return true;
}
} // namespace Signorini
