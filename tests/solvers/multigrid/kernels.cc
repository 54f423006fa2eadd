// SPDX-License-Identifier: LGPL-2.1-or-later
// Kernels for all instruction sets of this machine give the same up to rounding, in rows and in
// lists.

#include <signorini/solvers/multigrid/cell_integration.h>
#include <signorini/solvers/multigrid/kernels.h>

#include <algorithm>
#include <ctime>
#include <numeric>

#include "random_numbers.h"
#include "tests.h"

using namespace Signorini;

namespace
{
constexpr Instructions all[] = {Instructions::basic, Instructions::avx2, Instructions::avx512};

/** One block of n^dim cells. */
template <int dim>
BlockGrid<dim> one_block(const unsigned int n)
{
  std::vector<NodeNumber> places(dim == 2 ? (n + 1) * (n + 1) : (n + 1) * (n + 1) * (n + 1));
  std::iota(places.begin(), places.end(), 0U);
  return BlockGrid<dim>(1, n, places, places.size());
}

template <int components, typename Number>
double distance(const LevelVector<components, Number> &a,
                const LevelVector<components, Number> &b,
                const unsigned int n_nodes)
{
  double largest = 0.;
  for (int c = 0; c < components; ++c)
    for (unsigned int node = 0; node < n_nodes; ++node)
      largest = std::max(largest, std::abs(static_cast<double>(a[c][node] - b[c][node])));
  return largest;
}

template <int components, typename Number>
LevelVector<components, Number> random_values(const unsigned int n_nodes, RandomNumbers &random)
{
  LevelVector<components, Number> values(n_nodes);
  for (int c = 0; c < components; ++c)
    for (unsigned int node = 0; node < n_nodes; ++node)
      values[c][node] = static_cast<Number>(random());
  return values;
}

/** Nodes of one block, moved a little. */
template <int dim>
NodePlaces<dim> random_places(const unsigned int n, RandomNumbers &random)
{
  const unsigned int n_nodes = dim == 2 ? (n + 1) * (n + 1) : (n + 1) * (n + 1) * (n + 1);
  NodePlaces<dim> places(n_nodes);
  for (unsigned int node = 0; node < n_nodes; ++node)
    for (unsigned int d = 0, rest = node; d < dim; ++d, rest /= n + 1)
      places[d][node] = rest % (n + 1) + 0.1 * random();
  return places;
}

/** A shared matrix in the first batch, integration in the last, one matrix for each cell elsewhere.
 */
template <int dim, typename Number>
CellMatrices<dim, Number> random_matrices(const BlockGrid<dim> &grid, RandomNumbers &random)
{
  using Matrices = CellMatrices<dim, Number>;
  const std::size_t n_batches = grid.n_batches();
  Matrices matrices(n_batches);
  matrices.shared.resize(Matrices::n_dofs * Matrices::n_dofs);
  for (unsigned int i = 0; i < Matrices::n_dofs; ++i)
    for (unsigned int j = 0; j <= i; ++j)
      matrices.shared[i * Matrices::n_dofs + j] = matrices.shared[j * Matrices::n_dofs + i] =
        static_cast<Number>(random());
  for (std::size_t batch = 1; batch < n_batches; ++batch)
    matrices.store(batch);
  for (Number &value : matrices.stored)
    value = static_cast<Number>(random());
  std::array<double, PointRule<dim, Number>::n_moduli> moduli;
  for (double &modulus : moduli)
    modulus = random();
  matrices.rule =
    make_point_rule<dim, Number>(random_places<dim>(grid.n(), random), grid.n_nodes(), moduli, 2);
  matrices.batch_storage.back() = Matrices::integrated;
  return matrices;
}

/** y = K x by the entries of the matrices. */
template <int dim, typename Number>
LevelVector<dim, Number> product_by_entries(const BlockGrid<dim> &grid,
                                            const CellMatrices<dim, Number> &matrices,
                                            const LevelVector<dim, Number> &x)
{
  LevelVector<dim, Number> y(grid.n_nodes());
  std::vector<Number> buffer;
  for (std::size_t cell = 0; cell < grid.n_cells(); ++cell)
  {
    const Number *const K = entries_of_batch(matrices, grid, cell / n_lanes, buffer);
    const auto nodes = grid.nodes(cell);
    for (unsigned int i = 0; i < dim * nodes.size(); ++i)
      for (unsigned int j = 0; j < dim * nodes.size(); ++j)
        y[i % dim][nodes[i / dim]] +=
          K[CellMatrices<dim, Number>::entry(i, j) * n_lanes + cell % n_lanes] *
          x[j % dim][nodes[j / dim]];
  }
  return y;
}

template <int dim, typename Number>
void products(Checks &checks, const std::string &name, const unsigned int n, const double tolerance)
{
  RandomNumbers random(dim + n);
  const BlockGrid<dim> grid = one_block<dim>(n);
  const auto matrices = random_matrices<dim, Number>(grid, random);
  const auto x = random_values<dim, Number>(grid.n_nodes(), random);
  const auto expected = product_by_entries(grid, matrices, x);
  double largest = 0.;
  for (const Instructions instructions : all)
    if (instructions <= instructions_of_this_machine())
    {
      LevelVector<dim, Number> y(grid.n_nodes());
      multiply(y, x, grid, matrices, instructions);
      largest = std::max(largest, distance(y, expected, grid.n_nodes()));
    }
  checks.near(
    name + ", " + std::to_string(dim) + "-D, rows of " + std::to_string(n), largest, 0., tolerance);
}

template <int dim>
void smoothing(Checks &checks)
{
  RandomNumbers random(7);
  constexpr unsigned int n_nodes = 37;
  const auto x = random_values<dim, float>(n_nodes, random),
             b = random_values<dim, float>(n_nodes, random),
             y = random_values<dim, float>(n_nodes, random),
             d = random_values<dim, float>(n_nodes, random);
  const auto B = random_values<dim *(dim + 1) / 2, float>(n_nodes, random);
  double largest = 0.;
  for (const bool is_first : {false, true})
    for (const Instructions instructions : all)
      if (instructions <= instructions_of_this_machine())
      {
        LevelVector<dim, float> new_x(x), new_d(d);
        smooth<dim>({new_x, new_d, b, y, B, n_nodes, 0.3F, 0.7F, is_first}, instructions);
        for (unsigned int node = 0; node < n_nodes; ++node)
          for (int c = 0; c < dim; ++c)
          {
            float change = is_first ? 0.F : 0.3F * d[c][node];
            for (int e = 0; e < dim; ++e)
              change += 0.7F * B[c == e ? c : dim + c + e - 1][node] *
                        (b[e][node] - (is_first ? 0.F : y[e][node]));
            const float expected = change + (is_first ? 0.F : x[c][node]);
            largest = std::max({largest,
                                std::abs(static_cast<double>(new_d[c][node] - change)),
                                std::abs(static_cast<double>(new_x[c][node] - expected))});
          }
      }
  checks.near("smoothing, " + std::to_string(dim) + "-D", largest, 0., 1e-6);
}
double cpu_seconds()
{
  timespec time = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/** The smallest of ten times, with matrices of one kind in all batches. */
template <int dim, typename Number>
void print_seconds(const std::string &name, const unsigned int n, const unsigned int n_points)
{
  RandomNumbers random(1);
  const BlockGrid<dim> grid = one_block<dim>(n);
  auto matrices = random_matrices<dim, Number>(grid, random);
  std::array<double, PointRule<dim, Number>::n_moduli> moduli = {};
  matrices.rule =
    make_point_rule<dim, Number>(random_places<dim>(n, random), grid.n_nodes(), moduli, n_points);
  const auto x = random_values<dim, Number>(grid.n_nodes(), random);
  LevelVector<dim, Number> y(grid.n_nodes());
  for (const Instructions instructions : all)
    if (instructions <= instructions_of_this_machine())
      for (const char *const kind : {"stored", "shared", "integrated"})
      {
        const bool shared = kind == std::string("shared"), stored = kind == std::string("stored");
        if (!stored)
          std::fill(matrices.batch_storage.begin(),
                    matrices.batch_storage.end(),
                    shared ? 0 : CellMatrices<dim, Number>::integrated);
        else
          for (std::size_t batch = 0; batch < grid.n_batches(); ++batch)
            matrices.batch_storage[batch] =
              -1 - static_cast<int>(std::min(batch, grid.n_batches() - 2));
        double best = 1e9;
        for (unsigned int i = 0; i < 10; ++i)
        {
          const double begin = cpu_seconds();
          multiply(y, x, grid, matrices, instructions);
          best = std::min(best, cpu_seconds() - begin);
        }
        std::cout << name << ", " << kind << ", instructions " << static_cast<int>(instructions)
                  << ": " << 1e9 * best / static_cast<double>(grid.n_cells()) << " ns per cell"
                  << std::endl;
      }
}
} // namespace

int main(int argc, char ** /*argv*/)
{
  if (argc > 1)
  {
    print_seconds<2, float>("512 x 512, float", 512, 2);
    print_seconds<2, double>("512 x 512, double", 512, 4);
    print_seconds<3, float>("32^3, float", 32, 2);
    print_seconds<3, double>("32^3, double", 32, 4);
    return 0;
  }
  Checks checks;
  for (const unsigned int n : {2U, 8U, 16U, 32U})
  {
    products<2, float>(checks, "float", n, 1e-4);
    products<2, double>(checks, "double", n, 1e-13);
  }
  for (const unsigned int n : {2U, 16U})
  {
    products<3, float>(checks, "float", n, 1e-4);
    products<3, double>(checks, "double", n, 1e-13);
  }
  smoothing<2>(checks);
  smoothing<3>(checks);
  return checks.exit_code();
}
