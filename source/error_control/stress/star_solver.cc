// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact solves on the stars of vertices.

#include <signorini/base/parallel.h>
#include <signorini/error_control/stress/star_solver.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace Signorini
{
namespace
{
using Vector2 = Tensor<1, 2>;

/** Returns the position in a star of the first component that a spoke has at its centre (end 0) or
 * outer end (1). */
unsigned int in_star(const unsigned int spoke, const unsigned int end)
{
  return 4 * spoke + 2 * end;
}

/** The positions in the cell and in the star of a moment of the two spokes of cell j, with its sign
 * in the star. */
struct StarEntry
{
  unsigned int in_cell, in_star;
  double sign;
};

std::array<StarEntry, 8> entries(const Star &star, const unsigned int j)
{
  const unsigned int k = star.cells[j].number, left = (k + 3) % 4;
  std::array<StarEntry, 8> result;
  for (unsigned int end = 0; end < 2; ++end)
    for (unsigned int c = 0; c < 2; ++c)
    {
      // Edge k begins at the centre, edge k - 1 ends there.
      result[2 * end + c] = {4 * k + 2 * end + c, in_star(j, end) + c, 1.};
      result[4 + 2 * end + c] = {
        4 * left + 2 * (1 - end) + c, in_star(star.left_of(j), end) + c, -1.};
    }
  return result;
}

/** Returns one column per moment that the star may change. */
FullMatrix<double> free_moments(const EdgeMesh &mesh, const Star &star)
{
  std::vector<std::pair<unsigned int, Vector2>> columns;
  for (unsigned int j = 0; j < star.spokes.size(); ++j)
  {
    const Edge &edge = mesh.edges()[star.spokes[j].edge];
    for (unsigned int end = 0; end < 2; ++end)
      if (edge.freedom == EdgeFreedom::normal)
        columns.emplace_back(in_star(j, end), edge.normal);
      else if (edge.freedom == EdgeFreedom::any)
        for (unsigned int c = 0; c < 2; ++c)
          columns.emplace_back(in_star(j, end), Vector2({c == 0 ? 1. : 0., c == 1 ? 1. : 0.}));
  }
  FullMatrix<double> basis(4 * star.spokes.size(), columns.size());
  for (unsigned int i = 0; i < columns.size(); ++i)
    for (unsigned int c = 0; c < 2; ++c)
      basis(columns[i].first + c, i) = columns[i].second[c];
  return basis;
}

/** Returns the forces and moments of the cells of a star: three rows per cell. */
FullMatrix<double> balances(const EdgeMesh &mesh, const Star &star)
{
  FullMatrix<double> rows(3 * star.cells.size(), 4 * star.spokes.size());
  for (unsigned int j = 0; j < star.cells.size(); ++j)
  {
    const EdgeCell &cell = mesh.cells()[star.cells[j].cell];
    const Point<2> &centre = cell.corners[star.cells[j].number];
    const double size = cell.corners[0].distance(cell.corners[2]);
    for (const StarEntry &entry : entries(star, j))
    {
      const unsigned int edge = entry.in_cell / 4, end = entry.in_cell % 4 / 2;
      const unsigned int c = entry.in_cell % 2;
      const Vector2 arm = (cell.corners[(edge + end) % 4] - centre) / size;
      rows(3 * j + c, entry.in_star) += entry.sign;
      rows(3 * j + 2, entry.in_star) += entry.sign * (c == 0 ? -arm[1] : arm[0]);
    }
  }
  return rows;
}

/** Returns columns that span the changes which disturb the balance of no cell around a vertex
 * inside of the body, where all edges take any traction. With a_j and b_j the moments of spoke j at
 * the centre and at its outer end r_j, the cells are in balance if a_j + b_j and r_j x b_j are the
 * same for all j: one force in two components, one moment, and for every spoke a couple along it.
 */
FullMatrix<double> balanced_inside(const EdgeMesh &mesh, const Star &star)
{
  const unsigned int n = star.spokes.size();
  const EdgeCell &first = mesh.cells()[star.cells[0].cell];
  const double length = first.corners[0].distance(first.corners[2]);
  FullMatrix<double> Z(4 * n, n + 3);
  for (unsigned int j = 0; j < n; ++j)
  {
    // Spoke j is edge k of cell j, from the centre outwards.
    const EdgeCell &cell = mesh.cells()[star.cells[j].cell];
    const unsigned int k = star.cells[j].number;
    const Vector2 spoke = cell.corners[(k + 1) % 4] - cell.corners[k];
    const Vector2 r = spoke / spoke.norm();
    const double size = length / spoke.norm();
    const Vector2 turn({-size * r[1], size * r[0]});
    for (unsigned int c = 0; c < 2; ++c)
    {
      const unsigned int a = in_star(j, 0) + c, b = in_star(j, 1) + c;
      Z(a, c) = 1.;
      Z(b, 2) = turn[c];
      Z(a, 2) = -turn[c];
      Z(b, 3 + j) = r[c];
      Z(a, 3 + j) = -r[c];
    }
  }
  return Z;
}

/** Returns A B. Matrices are small: a call of a linear algebra library takes longer. */
FullMatrix<double> product(const FullMatrix<double> &A, const FullMatrix<double> &B)
{
  FullMatrix<double> C(A.m(), B.n());
  for (unsigned int i = 0; i < C.m(); ++i)
    for (unsigned int k = 0; k < A.n(); ++k)
      if (const double factor = A(i, k); factor != 0.)
        for (unsigned int j = 0; j < C.n(); ++j)
          C(i, j) += factor * B(k, j);
  return C;
}

/** Returns the changes of moments that disturb the balance of no cell of a star, as columns. */
FullMatrix<double> basis(const EdgeMesh &mesh, const Star &star)
{
  if (star.is_closed())
    return balanced_inside(mesh, star);
  const FullMatrix<double> free = free_moments(mesh, star);
  return product(free, null_space(product(balances(mesh, star), free)));
}

/** Returns X with A X = B for a positive definite A, by Cholesky's method. */
FullMatrix<double> solve(FullMatrix<double> A, FullMatrix<double> B)
{
  const unsigned int n = A.m(), m = B.n();
  for (unsigned int i = 0; i < n; ++i)
  {
    for (unsigned int k = 0; k <= i; ++k)
    {
      double sum = A(i, k);
      for (unsigned int l = 0; l < k; ++l)
        sum -= A(i, l) * A(k, l);
      A(i, k) = k == i ? std::sqrt(sum) : sum / A(k, k);
    }
    for (unsigned int j = 0; j < m; ++j)
    {
      double sum = B(i, j);
      for (unsigned int k = 0; k < i; ++k)
        sum -= A(i, k) * B(k, j);
      B(i, j) = sum / A(i, i);
    }
  }
  for (unsigned int i = n; i-- > 0;)
    for (unsigned int j = 0; j < m; ++j)
    {
      double sum = B(i, j);
      for (unsigned int k = i + 1; k < n; ++k)
        sum -= A(k, i) * B(k, j);
      B(i, j) = sum / A(i, i);
    }
  return B;
}

/** The number of moments of a star of four edges, as inside the body. With it, the compiler knows
 * the sizes of loops. */
constexpr unsigned int usual_size = 16;

/** Calls @p f(number, position, sign) for the n moments of a star, in the order of its matrix. */
template <typename Size, typename Function>
void for_moments(const Star &star, const Size n, const Function &f)
{
  for (unsigned int j = 0; j < n / 4; ++j)
  {
    const Spoke &spoke = star.spokes[j];
    for (unsigned int i = 0; i < 4; ++i)
    {
      const unsigned int end = i < 2 ? spoke.end : 1 - spoke.end;
      f(4 * j + i, 4 * spoke.edge + 2 * end + i % 2, spoke.sign);
    }
  }
}

/** Adds the solution for one star to z; n is a number or a constant. */
template <typename Size, typename Array>
void add_solution(const Star &star,
                  const double *row,
                  const Size n,
                  const std::vector<double> &r,
                  std::vector<double> &z,
                  Array &x,
                  Array &y)
{
  for_moments(star, n, [&](const unsigned int i, const unsigned int position, const double sign) {
    x[i] = sign * r[position];
    y[i] = 0.;
  });
  // The matrix is symmetric: its rows are its columns.
  for (unsigned int j = 0; j < n; ++j, row += n)
    for (unsigned int i = 0; i < n; ++i)
      y[i] += row[i] * x[j];
  for_moments(star, n, [&](const unsigned int i, const unsigned int position, const double sign) {
    z[position] += sign * y[i];
  });
}
} // namespace

FullMatrix<double> null_space(FullMatrix<double> matrix)
{
  const unsigned int m = matrix.m(), n = matrix.n();
  std::vector<unsigned int> column(n);
  for (unsigned int j = 0; j < n; ++j)
    column[j] = j;
  const double tolerance = 1e-9 * (m > 0 && n > 0 ? matrix.linfty_norm() : 0.);
  unsigned int rank = 0;
  for (; rank < std::min(m, n); ++rank)
  {
    unsigned int row = rank, pivot = rank;
    for (unsigned int i = rank; i < m; ++i)
      for (unsigned int j = rank; j < n; ++j)
        if (std::abs(matrix(i, column[j])) > std::abs(matrix(row, column[pivot])))
        {
          row = i;
          pivot = j;
        }
    if (std::abs(matrix(row, column[pivot])) <= tolerance)
      break;
    std::swap(column[rank], column[pivot]);
    for (unsigned int j = 0; j < n; ++j)
      std::swap(matrix(row, j), matrix(rank, j));
    const double diagonal = matrix(rank, column[rank]);
    for (unsigned int j = 0; j < n; ++j)
      matrix(rank, j) /= diagonal;
    for (unsigned int i = 0; i < m; ++i)
      if (i != rank)
      {
        const double factor = matrix(i, column[rank]);
        for (unsigned int j = 0; j < n; ++j)
          matrix(i, j) -= factor * matrix(rank, j);
      }
  }
  FullMatrix<double> basis(n, n - rank);
  for (unsigned int j = rank; j < n; ++j)
  {
    basis(column[j], j - rank) = 1.;
    for (unsigned int i = 0; i < rank; ++i)
      basis(column[i], j - rank) = -matrix(i, column[j]);
  }
  return basis;
}

CellEnergies::CellEnergies(const CellTable &table, const std::size_t n_cells)
  : shared_(table.constant_law())
  , table_(table)
  , index_(n_cells)
{
  constexpr unsigned int unknown = static_cast<unsigned int>(-1);
  std::vector<unsigned int> matrix_of_shape(table.n_shapes(), unknown);
  for (unsigned int cell = 0; cell < n_cells; ++cell)
  {
    unsigned int *const shared = is_shared(cell) ? &matrix_of_shape[table.shape_of(cell)] : nullptr;
    index_[cell] = shared != nullptr && *shared != unknown ? *shared : first_cell_.size();
    if (index_[cell] == first_cell_.size())
      first_cell_.push_back(cell);
    if (shared != nullptr)
      *shared = index_[cell];
  }
  matrices_.resize(first_cell_.size());
}

StarSolver::StarSolver(const EdgeMesh &mesh,
                       const CellEnergies &energies,
                       const unsigned int n_threads)
  : mesh_(mesh)
  , matrix_of_star_(mesh.stars().size())
{
  std::map<std::vector<unsigned int>, unsigned int> known;
  std::vector<unsigned int> to_solve;
  for (unsigned int v = 0; v < mesh.stars().size(); ++v)
  {
    const std::vector<unsigned int> name = key(mesh.stars()[v], energies);
    matrix_of_star_[v] =
      name.empty() ? to_solve.size() : known.emplace(name, to_solve.size()).first->second;
    if (matrix_of_star_[v] == to_solve.size())
      to_solve.push_back(v);
  }
  matrices_.resize(to_solve.size());
  work_on_ranges(n_threads, to_solve.size(), [&](const std::size_t begin, const std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      matrices_[i] = solve_star(mesh.stars()[to_solve[i]], energies);
  });
}

void StarSolver::renew(const unsigned int vertex, const CellEnergies &energies)
{
  matrix_of_star_[vertex] = matrices_.size();
  matrices_.push_back(solve_star(mesh_.stars()[vertex], energies));
}

std::vector<unsigned int> StarSolver::key(const Star &star, const CellEnergies &energies) const
{
  std::vector<unsigned int> name;
  if (!star.is_closed() ||
      !std::all_of(star.cells.begin(), star.cells.end(), [&](const CellCorner &corner) {
        return energies.is_shared(corner.cell);
      }))
    return name;
  name.reserve(star.cells.size());
  for (const CellCorner &corner : star.cells)
    name.push_back(4 * energies.number(corner.cell) + corner.number);
  return name;
}

std::vector<double> StarSolver::solve_star(const Star &star, const CellEnergies &energies) const
{
  const unsigned int n = 4 * star.spokes.size();
  const FullMatrix<double> Z = basis(mesh_, star);
  std::vector<double> rows(n * n, 0.);
  if (Z.n() == 0)
    return rows;
  FullMatrix<double> S(n, n);
  for (unsigned int j = 0; j < star.cells.size(); ++j)
  {
    const CellEnergy &energy = energies(star.cells[j].cell);
    const auto cell_data = entries(star, j);
    for (const StarEntry &a : cell_data)
      for (const StarEntry &b : cell_data)
        S(a.in_star, b.in_star) +=
          a.sign * b.sign * energy[CompositeCell::n_moments * a.in_cell + b.in_cell];
  }
  FullMatrix<double> Zt(Z.n(), Z.m());
  Zt.copy_transposed(Z);
  const FullMatrix<double> matrix = product(Z, solve(product(product(Zt, S), Z), Zt));
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      rows[i * n + j] = matrix(i, j);
  return rows;
}

void StarSolver::apply(const std::vector<double> &r, std::vector<double> &z) const
{
  std::fill(z.begin(), z.end(), 0.);
  std::array<double, usual_size> fixed_x, fixed_y;
  std::vector<double> x, y;
  for (unsigned int v = 0; v < mesh_.stars().size(); ++v)
  {
    const Star &star = mesh_.stars()[v];
    const unsigned int n = 4 * star.spokes.size();
    const double *matrix = matrices_[matrix_of_star_[v]].data();
    if (n == usual_size)
    {
      add_solution(
        star, matrix, std::integral_constant<unsigned int, usual_size>(), r, z, fixed_x, fixed_y);
      continue;
    }
    x.resize(n);
    y.resize(n);
    add_solution(star, matrix, n, r, z, x, y);
  }
}

CellMoments multiply(const CellEnergy &energy, const CellMoments &b)
{
  constexpr unsigned int n = CompositeCell::n_moments;
  CellMoments y{};
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
      y[i] += energy[n * j + i] * b[j];
  return y;
}

void multiply(const EdgeMesh &mesh,
              const CellEnergies &energies,
              const std::vector<double> &b,
              std::vector<double> &gradient)
{
  std::fill(gradient.begin(), gradient.end(), 0.);
  for (unsigned int c = 0; c < mesh.cells().size(); ++c)
  {
    const EdgeCell &cell = mesh.cells()[c];
    add_moments(cell, multiply(energies(c), moments_on(cell, b)), gradient);
  }
}
} // namespace Signorini
