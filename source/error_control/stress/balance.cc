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

namespace Signorini {
namespace {
constexpr unsigned int no_cell = static_cast<unsigned int>(-1);

/** An edge of a cell, with its number in the cell. */
struct CellEdge {
  unsigned int cell = no_cell, k = 0;
};

/** Adds the linear traction with the given resultant on edge k of a cell. */
void load_edge(const EdgeCell &cell, const unsigned int k, const Resultant<2> &resultant,
               std::vector<double> &moments) {
  const Tensor<1, 2> d = cell.edge_vector(k), normal = cross_product_2d(d) / d.norm();
  // Half of the force at either end, and a couple that is normal to the edge.
  const double couple =
    resultant.moment_about(cell.corners[k] + 0.5 * d)[0] / moment_of(-d, normal)[0];
  CellMoments change{};
  for (unsigned int i = 0; i < 4; ++i)
    change[4 * k + i] = 0.5 * resultant.force[i % 2] + (i < 2 ? couple : -couple) * normal[i % 2];
  add_moments(cell, change, moments);
}

/** Passes the lacking resultant of every cell on to a neighbour that is closer to cell 0. What cell
 * 0 lacks then is that of the body. */
void carry(const EdgeMesh &mesh, std::vector<Resultant<2>> lacking, std::vector<double> &moments) {
  std::vector<std::array<CellEdge, 2>> sides(mesh.edges().size());
  for (unsigned int c = 0; c < mesh.cells().size(); ++c)
    for (unsigned int k = 0; k < 4; ++k)
      sides[mesh.cells()[c].edges[k]][mesh.cells()[c].sign[k] > 0. ? 0 : 1] = {c, k};
  // Cells in the order of their distance, with the edges and cells towards cell 0.
  std::vector<CellEdge> order = {{0, 0}};
  std::vector<unsigned int> parent(mesh.cells().size(), no_cell);
  parent[0] = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (const unsigned int edge : mesh.cells()[order[i].cell].edges)
      for (const CellEdge &other : sides[edge])
        if (other.cell != no_cell && parent[other.cell] == no_cell) {
          parent[other.cell] = order[i].cell;
          order.push_back(other);
        }
  for (std::size_t i = order.size(); i-- > 1;) {
    const unsigned int c = order[i].cell;
    load_edge(mesh.cells()[c], order[i].k, lacking[c], moments);
    lacking[parent[c]] += lacking[c];
  }
}

/** An end of an edge that holds the body: the forces P f there have the components rows.(a, w) for
 * f = a + w (x - c)^⊥/size, and the resultant f.rows. */
struct Support {
  unsigned int cell, position;
  Point<2> x;
  Tensor<1, 2, Tensor<1, 3>> rows;
};

std::vector<Support> find_supports(const EdgeMesh &mesh, const Point<2> &c, const double size) {
  std::vector<Support> supports;
  for (unsigned int number = 0; number < mesh.cells().size(); ++number)
    for (unsigned int k = 0; k < 4; ++k) {
      const EdgeCell &cell = mesh.cells()[number];
      const Edge &edge = mesh.edges()[cell.edges[k]];
      if (edge.is_boundary() && edge.freedom != EdgeFreedom::none)
        for (const unsigned int end : {0, 1}) {
          Support &support = supports.emplace_back(
            Support{number, EdgeMesh::position(cell, k, end), cell.corners[(k + end) % 4], {}});
          const Tensor<2, 2> P = edge.projection();
          for (unsigned int d = 0; d < 2; ++d)
            support.rows[d] = Tensor<1, 3>({P[d][0], P[d][1], cross(support.x - c, P[d]) / size});
        }
    }
  return supports;
}
} // namespace

bool balance_cells(const EdgeMesh &mesh, const std::vector<Tensor<1, 2>> &rest,
                   std::vector<double> &moments) {
  std::vector<Resultant<2>> lacking(mesh.cells().size());
  Resultant<2> all;
  for (std::size_t c = 0; c < lacking.size(); ++c) {
    for (unsigned int a = 0; a < 4; ++a)
      lacking[c].add(rest[mesh.cells()[c].vertices[a]], mesh.cells()[c].corners[a]);
    all += lacking[c];
  }
  // The least forces that the supports can add take the resultant of all cells.
  const auto &corners = mesh.cells()[0].corners;
  const double size = corners[0].distance(corners[2]);
  const std::vector<Support> supports = find_supports(mesh, corners[0], size);
  SymmetricTensor<2, 3> gram;
  for (const Support &support : supports)
    for (unsigned int d = 0; d < 2; ++d)
      gram += symmetrize(outer_product(support.rows[d], support.rows[d]));
  const Tensor<1, 3> total({all.force[0], all.force[1], all.moment_about(corners[0])[0] / size});
  const auto motions = eigenvectors(gram);
  if (!(motions[2].first > 1e-10 * motions[0].first))
    return false;
  Tensor<1, 3> q;
  for (const auto &[square, motion] : motions)
    q += (motion * total) / square * motion;
  for (const Support &support : supports) {
    const Tensor<1, 2> force({support.rows[0] * q, support.rows[1] * q});
    lacking[support.cell].add(-force, support.x);
    for (unsigned int d = 0; d < 2; ++d)
      moments[support.position + d] += force[d];
  }
  carry(mesh, std::move(lacking), moments);
  return true;
}
// The best stress in equilibrium, by one sparse factorisation.

namespace {
/** The weight of the squares of unbalanced forces beside the largest entry of S. */
constexpr double penalty = 1e5;

/** Returns the numbers of the moments of a cell. */
std::vector<types::global_dof_index> numbers_of(const EdgeCell &cell) {
  std::vector<types::global_dof_index> numbers;
  for (unsigned int j = 0; j < 16; ++j)
    numbers.push_back(EdgeMesh::position(cell, j / 4, j % 4 / 2) + j % 2);
  return numbers;
}

/** Returns P (scale S + penalty Bᵀ B) P of a cell, P the projections of its edges. */
FullMatrix<double> cell_system(const EdgeMesh &mesh, const EdgeCell &cell, const CellEnergy &S,
                               const double scale) {
  const auto balance = balance_of(cell, cell.corners[0]);
  FullMatrix<double> system(16, 16), projection(16, 16), result(16, 16);
  for (unsigned int i = 0; i < 16; ++i) {
    const Tensor<2, 2> P = mesh.edges()[cell.edges[i / 4]].projection();
    for (unsigned int c = 0; c < 2; ++c)
      projection(i, i - i % 2 + c) = cell.sign[i / 4] * P[i % 2][c];
    for (unsigned int j = 0; j < 16; ++j) {
      system(i, j) = scale * S[i][j];
      for (const CellMoments &row : balance)
        system(i, j) += penalty * row[i] * row[j];
    }
  }
  result.triple_product(system, projection, projection, true);
  return result;
}

/** Adds penalty B b to the multipliers l, and Bᵀ of that to @p forces.
 * @return the largest unbalanced force. */
double add_unbalanced(const EdgeMesh &mesh, const std::vector<double> &b,
                      std::vector<double> &forces) {
  double largest = 0.;
  for (const EdgeCell &cell : mesh.cells()) {
    const CellMoments here = moments_on(cell, b);
    CellMoments added{};
    for (const CellMoments &row : balance_of(cell, cell.corners[0])) {
      const double lacking = std::inner_product(row.begin(), row.end(), here.begin(), 0.);
      largest = std::max(largest, std::abs(lacking));
      for (unsigned int j = 0; j < added.size(); ++j)
        added[j] += penalty * lacking * row[j];
    }
    add_moments(cell, added, forces);
  }
  return largest;
}
} // namespace

std::vector<double> optimal_change(const EdgeMesh &mesh, const CellEnergies &energies,
                                   const std::vector<double> &r) {
  const unsigned int n_cells = mesh.cells().size(), n = mesh.n_moments();
  double largest = 0.;
  for (unsigned int c = 0; c < n_cells; ++c)
    for (unsigned int j = 0; j < 16; ++j)
      largest = std::max(largest, energies(c)[j][j]);
  if (!(largest > 0.) || !std::isfinite(largest))
    return {};
  const AffineConstraints<double> none;
  DynamicSparsityPattern entries(n, n);
  for (const EdgeCell &cell : mesh.cells())
    none.add_entries_local_to_global(numbers_of(cell), entries);
  SparsityPattern pattern;
  pattern.copy_from(entries);
  SparseMatrix<double> matrix(pattern);
  for (unsigned int c = 0; c < n_cells; ++c) {
    const EdgeCell &cell = mesh.cells()[c];
    none.distribute_local_to_global(cell_system(mesh, cell, energies(c), 1. / largest),
                                    numbers_of(cell), matrix);
  }
  // What edges do not carry is zero.
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int c = 0; c < 2; ++c)
      matrix.add(i, i - i % 2 + c, (i % 2 == c) - mesh.edges()[i / 4].projection()[i % 2][c]);
  SparseDirectUMFPACK factors;
  std::vector<double> forces(n, 0.), b(n);
  try {
    factors.initialize(matrix);
  } catch (const ExceptionBase &) {
    return {};
  }
  for (unsigned int step = 0; step < 10; ++step) {
    dealii::Vector<double> x(n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int c = 0; c < 2; ++c)
        x[i] += mesh.edges()[i / 4].projection()[i % 2][c] *
                (r[i - i % 2 + c] / largest - forces[i - i % 2 + c]);
    factors.solve(x);
    b.assign(x.begin(), x.end());
    if (add_unbalanced(mesh, b, forces) <= 1e-13 * x.linfty_norm())
      return b;
  }
  return {};
}
} // namespace Signorini
