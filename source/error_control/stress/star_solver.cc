// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact solves on the stars of vertices.

#include <signorini/base/parallel.h>
#include <signorini/error_control/stress/star_solver.h>

#include <deal.II/lac/identity_matrix.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace Signorini {
namespace {
/**
 * Spoke j as part of the changes of moments that disturb the balance of no cell of a star. All
 * spokes carry the same force F and the same couple m about the centre, and each carries a shear s
 * along itself that has neither: the outer end has the moment m across + s along, the centre F
 * minus that.
 */
struct SpokeChanges {
  SpokeChanges(const EdgeMesh &mesh, const Star &star, const unsigned int j)
    : SpokeChanges(mesh.edges()[star.spokes[j].edge], star.spokes[j],
                   mesh.edges()[star.spokes[0].edge].length) {}
  /** @param unit a length, the same for all spokes. */
  SpokeChanges(const Edge &edge, const Spoke &spoke, const double unit)
    : edge(edge)
    , sign(spoke.sign)
    , centre(4 * spoke.edge + 2 * spoke.end)
    , outer(4 * spoke.edge + 2 * (1 - spoke.end))
    , along((spoke.end == 0 ? 1. : -1.) * Tensor<1, 2>({-edge.normal[1], edge.normal[0]}))
    , across(unit / edge.length * Tensor<1, 2>({-along[1], along[0]})) {}

  const Edge &edge;
  /** That of Spoke. */
  double sign;
  /** The positions in a vector of moments. */
  unsigned int centre, outer;
  Tensor<1, 2> along, across;
};

/** The numbers of a change: F, m, and s of every spoke. */
constexpr unsigned int of_couple = 2, of_shears = 3;

/** Returns the projection onto the changes that the edges may carry. */
FullMatrix<double> projection(const EdgeMesh &mesh, const Star &star) {
  FullMatrix<double> P = IdentityMatrix(of_shears + star.spokes.size());
  if (star.is_closed())
    return P;
  Tensor<2, 2> force = unit_symmetric_tensor<2>();
  for (const unsigned int j : {0U, static_cast<unsigned int>(star.spokes.size() - 1)}) {
    const SpokeChanges spoke(mesh, star, j);
    if (spoke.edge.freedom == EdgeFreedom::any)
      continue;
    P(of_shears + j, of_shears + j) = 0.;
    // Normal tractions leave one direction of F; those of two rollers, if they are parallel.
    const Tensor<1, 2> barred = force * spoke.along;
    if (barred.norm() > 1e-9)
      force -= outer_product(barred, barred) / barred.norm_square();
    if (spoke.edge.freedom == EdgeFreedom::none)
      P(of_couple, of_couple) = 0.;
  }
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j)
      P(i, j) = P(of_couple, of_couple) * force[i][j];
  return P;
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
  const unsigned int n_cells = star.cells.size(), n = of_shears + star.spokes.size();
  FullMatrix<double> S(n, n), reduced(n, n);
  if (n_cells == 0)
    return S;
  for (unsigned int j = 0; j < n_cells; ++j) {
    const unsigned int left = star.left_of(j), k = star.cells[j].number, before = (k + 3) % 4;
    // The changes F, m, and s of the right and of the left spoke, on the cell. Edge k begins at the
    // centre, edge k - 1 ends there.
    constexpr unsigned int n_changes = 5;
    const std::array<unsigned int, n_changes> numbers = {
      {0, 1, of_couple, of_shears + j, of_shears + left}};
    std::array<CellMoments, n_changes> changes{};
    for (const bool is_left : {false, true}) {
      const SpokeChanges spoke(mesh_, star, is_left ? left : j);
      const double sign = is_left ? -1. : 1.;
      const unsigned int centre = is_left ? 4 * before + 2 : 4 * k,
                         outer = is_left ? 4 * before : 4 * k + 2;
      for (unsigned int c = 0; c < 2; ++c) {
        changes[c][centre + c] = sign;
        changes[of_couple][centre + c] = -sign * spoke.across[c];
        changes[of_couple][outer + c] = sign * spoke.across[c];
        changes[is_left ? 4 : 3][centre + c] = -sign * spoke.along[c];
        changes[is_left ? 4 : 3][outer + c] = sign * spoke.along[c];
      }
    }
    for (unsigned int a = 0; a < n_changes; ++a) {
      const CellMoments forces = Signorini::multiply(energies_(star.cells[j].cell), changes[a]);
      for (unsigned int b = 0; b < n_changes; ++b)
        S(numbers[a], numbers[b]) +=
          std::inner_product(forces.begin(), forces.end(), changes[b].begin(), 0.);
    }
  }
  if (star.is_closed()) {
    reduced.invert(S);
    return reduced;
  }
  // The inverse of P S P, with what P bars in a block of its own.
  const FullMatrix<double> P = projection(mesh_, star);
  FullMatrix<double> barred = IdentityMatrix(n);
  barred.add(-1., P);
  reduced.triple_product(S, P, P);
  reduced.add(S.trace(), barred);
  S.invert(reduced);
  reduced = 0.;
  reduced.triple_product(S, P, P);
  return reduced;
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
  work_on_ranges(
    n_threads_, mesh_.stars().size(), [&](const std::size_t begin, const std::size_t end) {
      std::vector<double> x, y;
      for (std::size_t v = begin; v < end; ++v) {
        const Star &star = mesh_.stars()[v];
        const unsigned int n_spokes = star.spokes.size();
        x.assign(of_shears + n_spokes, 0.);
        y.assign(of_shears + n_spokes, 0.);
        for (unsigned int j = 0; j < n_spokes; ++j) {
          const SpokeChanges spoke(mesh_, star, j);
          for (unsigned int c = 0; c < 2; ++c) {
            const double force = spoke.sign * r[spoke.centre + c],
                         couple = spoke.sign * r[spoke.outer + c] - force;
            x[c] += force;
            x[of_couple] += couple * spoke.across[c];
            x[of_shears + j] += couple * spoke.along[c];
          }
        }
        // The matrix is symmetric: its rows are its columns.
        const FullMatrix<double> &matrix = matrices_[matrix_of_star_[v]];
        for (unsigned int j = 0; j < matrix.m(); ++j)
          for (unsigned int i = 0; i < matrix.m(); ++i)
            y[i] += matrix(j, i) * x[j];
        for (unsigned int j = 0; j < n_spokes; ++j) {
          const SpokeChanges spoke(mesh_, star, j);
          std::vector<double> &part = parts[star.spokes[j].end];
          for (unsigned int c = 0; c < 2; ++c) {
            const double outer = y[of_couple] * spoke.across[c] + y[of_shears + j] * spoke.along[c];
            part[spoke.outer + c] = spoke.sign * outer;
            part[spoke.centre + c] = spoke.sign * (y[c] - outer);
          }
        }
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
