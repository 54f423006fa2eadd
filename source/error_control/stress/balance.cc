// SPDX-License-Identifier: LGPL-2.1-or-later
// Carries the lacking resultants of cells to the supports, and finds the best stress.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/loads/composite_cell.h>
#include <signorini/error_control/stress/balance.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Signorini
{
namespace
{
constexpr unsigned int no_cell = static_cast<unsigned int>(-1);

/** An edge of a cell, with its number in the cell. */
struct CellEdge
{
  unsigned int cell = no_cell, k = 0;
};

/** Adds the linear traction with the given resultant on edge k of a cell. */
void load_edge(const EdgeCell &cell,
               const unsigned int k,
               const Resultant<2> &resultant,
               std::vector<double> &moments)
{
  const Tensor<1, 2> d = cell.edge_vector(k), normal = cross_product_2d(d) / d.norm();
  // Half of the force at either end, and a couple that is normal to the edge.
  const double couple =
    resultant.moment_about(cell.corners[k] + 0.5 * d)[0] / moment_of(-d, normal)[0];
  CellMoments change{};
  for (unsigned int i = 0; i < 4; ++i)
    change[4 * k + i] = 0.5 * resultant.force[i % 2] + (i < 2 ? couple : -couple) * normal[i % 2];
  add_moments(cell, change, moments);
}

/**
 * Passes the lacking resultant of every cell on to a neighbour that is closer to the root.
 * @return the resultant that the root lacks then.
 */
Resultant<2> carry(const EdgeMesh &mesh,
                   const unsigned int root,
                   std::vector<Resultant<2>> lacking,
                   std::vector<double> &moments)
{
  std::vector<std::array<CellEdge, 2>> sides(mesh.edges().size());
  for (unsigned int c = 0; c < mesh.cells().size(); ++c)
    for (unsigned int k = 0; k < 4; ++k)
      sides[mesh.cells()[c].edges[k]][mesh.cells()[c].sign[k] > 0. ? 0 : 1] = {c, k};
  // Cells in the order of their distance, with the edges and cells towards the root.
  std::vector<CellEdge> order = {{root, 0}};
  std::vector<unsigned int> parent(mesh.cells().size(), no_cell);
  parent[root] = root;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (const unsigned int edge : mesh.cells()[order[i].cell].edges)
      for (const CellEdge &other : sides[edge])
        if (other.cell != no_cell && parent[other.cell] == no_cell)
        {
          parent[other.cell] = order[i].cell;
          order.push_back(other);
        }
  for (std::size_t i = order.size(); i-- > 1;)
  {
    const unsigned int c = order[i].cell;
    load_edge(mesh.cells()[c], order[i].k, lacking[c], moments);
    lacking[parent[c]] += lacking[c];
  }
  return lacking[root];
}

/** Returns the edges that take the remaining resultant: one for any traction, or two rollers. */
std::vector<CellEdge> find_supports(const EdgeMesh &mesh)
{
  std::vector<CellEdge> rollers;
  Tensor<1, 2> first_normal;
  for (unsigned int c = 0; c < mesh.cells().size(); ++c)
    for (unsigned int k = 0; k < 4; ++k)
    {
      const Edge &edge = mesh.edges()[mesh.cells()[c].edges[k]];
      if (edge.is_held())
        return {{c, k}};
      if (!edge.is_boundary() || edge.freedom == EdgeFreedom::none || rollers.size() == 2 ||
          (rollers.size() == 1 && std::abs(cross(first_normal, edge.normal)) <= 1e-3))
        continue;
      if (rollers.empty())
        first_normal = edge.normal;
      rollers.push_back({c, k});
    }
  return rollers.size() == 2 ? rollers : std::vector<CellEdge>();
}
} // namespace

bool balance_cells(const EdgeMesh &mesh,
                   const std::vector<Tensor<1, 2>> &rest,
                   std::vector<double> &moments)
{
  const std::vector<CellEdge> supports = find_supports(mesh);
  if (supports.empty())
    return false;
  std::vector<Resultant<2>> lacking(mesh.cells().size());
  for (std::size_t c = 0; c < lacking.size(); ++c)
    for (unsigned int a = 0; a < 4; ++a)
      lacking[c].add(rest[mesh.cells()[c].vertices[a]], mesh.cells()[c].corners[a]);
  if (supports.size() == 2)
  {
    // The second roller takes the part of the whole force that the first one cannot.
    const EdgeCell &cell = mesh.cells()[supports[1].cell];
    const unsigned int k = supports[1].k;
    const Tensor<1, 2> n = mesh.edges()[cell.edges[k]].normal,
                       m = mesh.edges()[mesh.cells()[supports[0].cell].edges[supports[0].k]].normal;
    const Tensor<1, 2> force = std::accumulate(
      lacking.begin(), lacking.end(), Tensor<1, 2>(), [](const auto &sum, const auto &r) {
        return sum + r.force;
      });
    Resultant<2> second;
    second.add(cross(m, force) / cross(m, n) * n, cell.corners[k] + 0.5 * cell.edge_vector(k));
    load_edge(cell, k, second, moments);
    lacking[supports[1].cell].force -= second.force;
    lacking[supports[1].cell].moment -= second.moment;
  }
  const EdgeCell &root = mesh.cells()[supports[0].cell];
  Resultant<2> left = carry(mesh, supports[0].cell, std::move(lacking), moments);
  // Normal up to rounding.
  left.force = mesh.edges()[root.edges[supports[0].k]].projection() * left.force;
  load_edge(root, supports[0].k, left, moments);
  return true;
}
// The best stress in equilibrium, by one sparse factorisation.

namespace
{
/** Returns the multipliers of a cell that do no work on any edge which may carry tractions: the
 * rigid motions that such edges leave to the body, in the coordinates of the cell. */
std::vector<Tensor<1, 3>> free_motions(const EdgeMesh &mesh, const EdgeCell &frame_cell)
{
  // A motion moves x by (a - w y, b + w x)/size, x and y from corner 0 of the cell.
  const double size = frame_cell.corners[0].distance(frame_cell.corners[2]);
  SymmetricTensor<2, 3> work;
  for (const EdgeCell &cell : mesh.cells())
    for (unsigned int k = 0; k < 4; ++k)
      if (const Edge &edge = mesh.edges()[cell.edges[k]]; edge.is_boundary())
        for (const unsigned int corner : {k, (k + 1) % 4})
        {
          const Tensor<1, 2> arm = (cell.corners[corner] - frame_cell.corners[0]) / size;
          const Tensor<2, 2> P = edge.projection();
          for (unsigned int d = 0; d < 2; ++d)
          {
            const Tensor<1, 3> row({P[d][0], P[d][1], cross(arm, P[d])});
            work += symmetrize(outer_product(row, row));
          }
        }
  std::vector<Tensor<1, 3>> motions;
  const auto pairs = eigenvectors(work);
  for (const auto &[stopped, motion] : pairs)
    if (stopped <= 1e-10 * pairs[0].first)
      motions.push_back(motion);
  return motions;
}

/** Returns the numbers of the moments and multipliers of a cell in the system. */
std::vector<types::global_dof_index> unknowns(const EdgeMesh &mesh, const unsigned int c)
{
  std::vector<types::global_dof_index> numbers;
  for (unsigned int j = 0; j < 16; ++j)
    numbers.push_back(EdgeMesh::position(mesh.cells()[c], j / 4, j % 4 / 2) + j % 2);
  for (unsigned int row = 0; row < 3; ++row)
    numbers.push_back(mesh.n_moments() + 3 * c + row);
  return numbers;
}

/** Returns (P S P, P Bᵀ; B P, 0) of a cell, P the projections of its edges. */
FullMatrix<double> cell_system(const EdgeMesh &mesh, const EdgeCell &cell, const CellEnergy &S)
{
  const auto balance = balance_of(cell, cell.corners[0]);
  FullMatrix<double> system(19, 19), projection(19, 19), result(19, 19);
  for (unsigned int i = 0; i < 16; ++i)
  {
    const Tensor<2, 2> P = mesh.edges()[cell.edges[i / 4]].projection();
    for (unsigned int c = 0; c < 2; ++c)
      projection(i, i - i % 2 + c) = cell.sign[i / 4] * P[i % 2][c];
    for (unsigned int j = 0; j < 16; ++j)
      system(i, j) = S[i][j];
    for (unsigned int row = 0; row < 3; ++row)
      system(i, 16 + row) = system(16 + row, i) = balance[row][i];
  }
  for (unsigned int row = 16; row < 19; ++row)
    projection(row, row) = 1.;
  result.triple_product(system, projection, projection, true);
  return result;
}
} // namespace

std::vector<double> optimal_change(const EdgeMesh &mesh,
                                   const CellEnergies &energies,
                                   const std::vector<double> &r)
{
  const unsigned int n_cells = mesh.cells().size(), n_moments = mesh.n_moments();
  const unsigned int n = n_moments + 3 * n_cells;
  double largest = 0.;
  for (unsigned int c = 0; c < n_cells; ++c)
    for (unsigned int j = 0; j < 16; ++j)
      largest = std::max(largest, energies(c)[j][j]);
  if (!(largest > 0.) || !std::isfinite(largest))
    return {};
  const double scale = 1. / largest;
  const AffineConstraints<double> none;
  DynamicSparsityPattern entries(n, n);
  for (unsigned int c = 0; c < n_cells; ++c)
    none.add_entries_local_to_global(unknowns(mesh, c), entries);
  SparsityPattern pattern;
  pattern.copy_from(entries);
  SparseMatrix<double> matrix(pattern);
  for (unsigned int c = 0; c < n_cells; ++c)
  {
    CellEnergy S = energies(c);
    for (auto &row : S)
      for (double &entry : row)
        entry *= scale;
    none.distribute_local_to_global(
      cell_system(mesh, mesh.cells()[c], S), unknowns(mesh, c), matrix);
  }
  // What edges do not carry is zero.
  dealii::Vector<double> rhs(n), residual(n);
  for (unsigned int i = 0; i < n_moments; ++i)
  {
    const Tensor<2, 2> P = mesh.edges()[i / 4].projection();
    for (unsigned int c = 0; c < 2; ++c)
    {
      matrix.add(i, i - i % 2 + c, (i % 2 == c ? 1. : 0.) - P[i % 2][c]);
      rhs[i] += scale * P[i % 2][c] * r[i - i % 2 + c];
    }
  }
  for (const Tensor<1, 3> &motion : free_motions(mesh, mesh.cells()[0]))
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        matrix.add(n_moments + i, n_moments + j, -motion[i] * motion[j]);
  dealii::Vector<double> x(rhs);
  try
  {
    SparseDirectUMFPACK().solve(matrix, x);
  }
  catch (const ExceptionBase &)
  {
    return {};
  }
  constexpr double tolerance = 1e-9;
  if (!(matrix.residual(residual, x, rhs) <= tolerance * x.l2_norm()))
    return {};
  return {x.begin(), x.begin() + n_moments};
}
} // namespace Signorini
