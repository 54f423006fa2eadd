// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact solves on the stars of vertices.

#include <signorini/base/parallel.h>
#include <signorini/error_control/stress/star_solver.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Signorini {
namespace {
/** The positions in the cell and in the star of the moments of the two spokes of cell j; in the
 * star, the second half has the opposite sign. */
struct StarEntries {
  StarEntries(const Star &star, const unsigned int j) {
    const unsigned int k = star.cells[j].number, left = (k + 3) % 4;
    for (unsigned int end = 0; end < 2; ++end)
      for (unsigned int c = 0; c < 2; ++c) {
        // Edge k begins at the centre, edge k - 1 ends there.
        const unsigned int i = 2 * end + c;
        in_cell[i] = 4 * k + i;
        in_star[i] = 4 * j + i;
        in_cell[4 + i] = 4 * left + 2 * (1 - end) + c;
        in_star[4 + i] = 4 * star.left_of(j) + i;
      }
  }
  static double sign(const unsigned int i) {
    return i < 4 ? 1. : -1.;
  }
  static constexpr unsigned int n = 8;
  std::array<unsigned int, n> in_cell, in_star;
};

/** Returns a basis of the null space of a matrix, as columns, by elimination with full pivoting.
 * (Singular values take ten times as long for matrices of this size.) */
FullMatrix<double> null_space(FullMatrix<double> matrix) {
  const unsigned int m = matrix.m(), n = matrix.n();
  std::vector<unsigned int> column(n);
  for (unsigned int j = 0; j < n; ++j)
    column[j] = j;
  const double tolerance = 1e-9 * matrix.linfty_norm();
  unsigned int rank = 0;
  for (; rank < std::min(m, n); ++rank) {
    unsigned int row = rank, pivot = rank;
    for (unsigned int i = rank; i < m; ++i)
      for (unsigned int j = rank; j < n; ++j)
        if (std::abs(matrix(i, column[j])) > std::abs(matrix(row, column[pivot]))) {
          row = i;
          pivot = j;
        }
    const double largest = matrix(row, column[pivot]);
    if (std::abs(largest) <= tolerance)
      break;
    std::swap(column[rank], column[pivot]);
    if (row != rank)
      matrix.swap_row(row, rank);
    for (unsigned int j = 0; j < n; ++j)
      matrix(rank, j) /= largest;
    for (unsigned int i = 0; i < m; ++i)
      if (const double factor = matrix(i, column[rank]); i != rank && factor != 0.)
        matrix.add_row(i, -factor, rank);
  }
  FullMatrix<double> basis(n, n - rank);
  for (unsigned int j = rank; j < n; ++j) {
    basis(column[j], j - rank) = 1.;
    for (unsigned int i = 0; i < rank; ++i)
      basis(column[i], j - rank) = -matrix(i, column[j]);
  }
  return basis;
}

/** Returns the changes of moments that disturb the balance of no cell of a star and that its edges
 * may carry, as columns. */
FullMatrix<double> basis(const EdgeMesh &mesh, const Star &star) {
  const unsigned int n_cells = star.cells.size(), n = 4 * star.spokes.size();
  FullMatrix<double> conditions(3 * n_cells + (star.is_closed() ? 0 : n), n);
  for (unsigned int j = 0; j < n_cells; ++j) {
    const EdgeCell &cell = mesh.cells()[star.cells[j].cell];
    const auto balance = balance_of(cell, cell.corners[star.cells[j].number]);
    const StarEntries at(star, j);
    for (unsigned int row = 0; row < 3; ++row)
      for (unsigned int i = 0; i < at.n; ++i)
        conditions(3 * j + row, at.in_star[i]) += at.sign(i) * balance[row][at.in_cell[i]];
  }
  for (unsigned int i = 0; i < n && !star.is_closed(); ++i) {
    const Tensor<2, 2> P = mesh.edges()[star.spokes[i / 4].edge].projection();
    for (unsigned int c = 0; c < 2; ++c)
      conditions(3 * n_cells + i, i - i % 2 + c) = (i % 2 == c ? 1. : 0.) - P[i % 2][c];
  }
  return null_space(conditions);
}
} // namespace

std::array<CellMoments, 3> balance_of(const EdgeCell &cell, const Point<2> &centre) {
  const double size = cell.corners[0].distance(cell.corners[2]);
  std::array<CellMoments, 3> rows{};
  for (unsigned int j = 0; j < 16; ++j) {
    const Tensor<1, 2> arm = (cell.corners[(j / 4 + j % 4 / 2) % 4] - centre) / size;
    rows[j % 2][j] = 1.;
    rows[2][j] = j % 2 == 0 ? -arm[1] : arm[0];
  }
  return rows;
}

StarSolver::StarSolver(const EdgeMesh &mesh, const CellEnergies &energies,
                       const unsigned int n_threads)
  : mesh_(mesh)
  , energies_(energies)
  , n_threads_(n_threads) {
  // Closed stars with the same matrices around them have the same solution.
  std::map<std::vector<unsigned int>, unsigned int> known;
  std::vector<unsigned int> to_solve;
  for (unsigned int v = 0; v < mesh.stars().size(); ++v) {
    const Star &star = mesh.stars()[v];
    std::vector<unsigned int> key;
    for (const CellCorner &corner : star.cells)
      if (star.is_closed() && energies.is_shared(corner.cell))
        key.push_back(4 * energies.number(corner.cell) + corner.number);
    const unsigned int number = key.empty() || key.size() < star.cells.size()
                                  ? to_solve.size()
                                  : known.emplace(key, to_solve.size()).first->second;
    matrix_of_star_.push_back(number);
    if (number == to_solve.size())
      to_solve.push_back(v);
  }
  matrices_.resize(to_solve.size());
  work_on_ranges(n_threads, to_solve.size(), [&](const std::size_t begin, const std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      matrices_[i] = solve_star(mesh.stars()[to_solve[i]]);
  });
}

void StarSolver::renew(const unsigned int vertex) {
  matrix_of_star_[vertex] = matrices_.size();
  matrices_.push_back(solve_star(mesh_.stars()[vertex]));
}

FullMatrix<double> StarSolver::solve_star(const Star &star) const {
  const unsigned int n = 4 * star.spokes.size();
  FullMatrix<double> S(n, n), result(n, n);
  if (n == 0)
    return result;
  const FullMatrix<double> Z = basis(mesh_, star);
  if (Z.n() == 0)
    return result;
  for (unsigned int j = 0; j < star.cells.size(); ++j) {
    const CellEnergy &energy = energies_(star.cells[j].cell);
    const StarEntries at(star, j);
    for (unsigned int a = 0; a < at.n; ++a)
      for (unsigned int b = 0; b < at.n; ++b)
        S(at.in_star[a], at.in_star[b]) +=
          at.sign(a) * at.sign(b) * energy[at.in_cell[a]][at.in_cell[b]];
  }
  FullMatrix<double> reduced(Z.n(), Z.n());
  reduced.triple_product(S, Z, Z, true);
  reduced.gauss_jordan();
  result.triple_product(reduced, Z, Z, false, true);
  return result;
}

namespace {
/** Adds two vectors to which threads wrote without conflict. */
void sum_up(const std::array<std::vector<double>, 2> &parts, std::vector<double> &sum) {
  std::transform(parts[0].begin(), parts[0].end(), parts[1].begin(), sum.begin(),
                 std::plus<double>());
}
} // namespace

void StarSolver::apply(const std::vector<double> &r, std::vector<double> &z) const {
  // An edge gets what its first end has solved, and what its second.
  std::array<std::vector<double>, 2> parts = {
    {std::vector<double>(z.size(), 0.), std::vector<double>(z.size(), 0.)}};
  work_on_ranges(n_threads_, mesh_.stars().size(),
                 [&](const std::size_t begin, const std::size_t end) {
                   std::vector<double> x, y;
                   for (std::size_t v = begin; v < end; ++v) {
                     const Star &star = mesh_.stars()[v];
                     const auto position = [&](const unsigned int i) {
                       const Spoke &spoke = star.spokes[i / 4];
                       return 4 * spoke.edge + (i % 4 + 2 * spoke.end) % 4;
                     };
                     const unsigned int n = 4 * star.spokes.size();
                     x.resize(n);
                     y.assign(n, 0.);
                     for (unsigned int i = 0; i < n; ++i)
                       x[i] = star.spokes[i / 4].sign * r[position(i)];
                     // The matrix is symmetric: its rows are its columns.
                     const FullMatrix<double> &matrix = matrices_[matrix_of_star_[v]];
                     for (unsigned int j = 0; j < n; ++j) {
                       const double *const row = &matrix(j, 0);
                       for (unsigned int i = 0; i < n; ++i)
                         y[i] += row[i] * x[j];
                     }
                     for (unsigned int i = 0; i < n; ++i)
                       parts[star.spokes[i / 4].end][position(i)] = star.spokes[i / 4].sign * y[i];
                   }
                 });
  sum_up(parts, z);
}

void StarSolver::multiply(const std::vector<double> &b, std::vector<double> &gradient) const {
  // An edge gets what its first cell has, and what its second.
  std::array<std::vector<double>, 2> parts = {
    {std::vector<double>(b.size(), 0.), std::vector<double>(b.size(), 0.)}};
  work_on_ranges(
    n_threads_, mesh_.cells().size(), [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t c = begin; c < end; ++c) {
        const EdgeCell &cell = mesh_.cells()[c];
        const CellMoments Sb = Signorini::multiply(energies_(c), moments_on(cell, b));
        for (unsigned int j = 0; j < Sb.size(); ++j)
          parts[cell.sign[j / 4] > 0. ? 0 : 1][EdgeMesh::position(cell, j / 4, j % 4 / 2) + j % 2] =
            cell.sign[j / 4] * Sb[j];
      }
    });
  sum_up(parts, gradient);
}
} // namespace Signorini
