// SPDX-License-Identifier: LGPL-2.1-or-later
// Kernels for all instruction sets of this machine give the same up to rounding, in rows and in
// lists. The long test times them.

#include <signorini/solvers/stiffness/cell_operator.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>

#include "random_numbers.h"
#include "tests.h"

using namespace Signorini;

namespace {
constexpr Instructions all[] = {Instructions::basic, Instructions::avx2, Instructions::avx512};

/** One block of n^dim cells. */
template <int dim>
std::shared_ptr<const BlockGrid<dim>> one_block(const unsigned int n) {
  return std::make_shared<const BlockGrid<dim>>(
    1, n, [n](const std::size_t cell, const unsigned int v) {
      std::size_t node = 0, stride = 1, rest = cell;
      for (int d = 0; d < dim; ++d, rest /= n, stride *= n + 1)
        node += stride * (rest % n + ((v >> d) & 1U));
      return static_cast<NodeNumber>(node);
    });
}

template <int components, typename Number>
LevelVector<components, Number> random_values(const unsigned int n_nodes, RandomNumbers &random) {
  LevelVector<components, Number> values(n_nodes);
  for (int c = 0; c < components; ++c)
    for (unsigned int node = 0; node < n_nodes; ++node)
      values[c][node] = static_cast<Number>(random());
  return values;
}

/** The entry (i, j) of a symmetric matrix by rows of its lower triangle. */
unsigned int entry(const unsigned int i, const unsigned int j) {
  return std::max(i, j) * (std::max(i, j) + 1) / 2 + std::min(i, j);
}

/** A shared matrix in the first batch, elsewhere one matrix for each cell, or integration over
 * cells whose nodes were moved a little, with @p n_points per direction. */
template <int dim, typename Number>
CellOperator<dim, Number> random_operator(const unsigned int n, const bool integrated,
                                          RandomNumbers &random, const unsigned int n_points = 2) {
  CellOperator<dim, Number> K(one_block<dim>(n), n_points);
  constexpr unsigned int n_dofs = CellOperator<dim, Number>::n_dofs;
  K.shared.resize(n_dofs * n_dofs);
  for (unsigned int i = 0; i < n_dofs; ++i)
    for (unsigned int j = 0; j <= i; ++j)
      K.shared[i * n_dofs + j] = K.shared[j * n_dofs + i] = static_cast<Number>(random());
  K.storage[0] = 0;
  if (!integrated) {
    K.store_matrices();
    for (Number &value : K.stored)
      value = static_cast<Number>(random());
    return K;
  }
  for (unsigned int m = 0; m < CellOperator<dim, Number>::n_moduli; ++m)
    K.moduli.insert(K.moduli.end(), n_lanes, static_cast<Number>(random()));
  K.positions = random_values<dim, Number>(K.grid->n_nodes(), random);
  for (unsigned int node = 0; node < K.grid->n_nodes(); ++node)
    for (unsigned int d = 0, rest = node; d < dim; ++d, rest /= n + 1)
      K.positions[d][node] = Number(rest % (n + 1)) + Number(0.1) * K.positions[d][node];
  return K;
}

template <int dim, typename Number>
void products(Checks &checks, const unsigned int n, const bool integrated, const double tolerance) {
  RandomNumbers random(dim + n);
  const auto K = random_operator<dim, Number>(n, integrated, random);
  const BlockGrid<dim> &grid = *K.grid;
  const auto x = random_values<dim, Number>(grid.n_nodes(), random);
  // K x by the entries of the matrices.
  LevelVector<dim, Number> expected(grid.n_nodes()), y(grid.n_nodes());
  std::vector<Number> buffer;
  for (std::size_t cell = 0; cell < grid.n_cells; ++cell) {
    const Number *const K_cell = K.entries(cell / n_lanes, buffer) + cell % n_lanes;
    const auto nodes = grid.nodes(cell);
    for (unsigned int i = 0; i < K.n_dofs; ++i)
      for (unsigned int j = 0; j < K.n_dofs; ++j)
        expected[i % dim][nodes[i / dim]] +=
          K_cell[entry(i, j) * n_lanes] * x[j % dim][nodes[j / dim]];
  }
  double largest = 0.;
  for (const Instructions instructions : all)
    if (instructions <= instructions_of_this_machine()) {
      K.multiply(y, x, instructions);
      for (int c = 0; c < dim; ++c)
        for (unsigned int node = 0; node < grid.n_nodes(); ++node)
          largest = std::max(largest, std::abs(double(y[c][node] - expected[c][node])));
    }
  checks.near(std::string(integrated ? "integrated, " : "stored, ") + std::to_string(dim) +
                "-D, rows of " + std::to_string(n) + ", " + std::to_string(sizeof(Number)) +
                " bytes",
              largest, 0., tolerance);
}

/** One step of the smoother, against that with basic instructions, which V-cycles are tested with.
 */
template <int dim>
void smoothing(Checks &checks) {
  RandomNumbers random(7);
  constexpr unsigned int n_nodes = 37;
  const auto values = [&]() { return random_values<dim, float>(n_nodes, random); };
  const auto x = values(), b = values(), y = values(), d = values();
  const auto B = random_values<dim *(dim + 1) / 2, float>(n_nodes, random);
  for (const bool is_first : {false, true}) {
    LevelVector<dim, float> basic_x(x), basic_d(d);
    SmootherStep<dim>{basic_x, basic_d, b, y, B, 0.3F, 0.7F, is_first}.run(Instructions::basic);
    for (const Instructions instructions : all)
      if (instructions <= instructions_of_this_machine()) {
        LevelVector<dim, float> new_x(x), new_d(d);
        SmootherStep<dim>{new_x, new_d, b, y, B, 0.3F, 0.7F, is_first}.run(instructions);
        for (unsigned int node = 0; node < n_nodes; ++node)
          for (int c = 0; c < dim; ++c) {
            checks.near("smoothing: x", new_x[c][node], basic_x[c][node], 1e-6);
            checks.near("smoothing: d", new_d[c][node], basic_d[c][node], 1e-6);
          }
      }
  }
}
/** Returns nanoseconds per cell of a product, the least of ten. */
template <int dim, typename Number>
double time_of(const CellOperator<dim, Number> &K, const Instructions instructions) {
  RandomNumbers random(1);
  const auto x = random_values<dim, Number>(K.grid->n_nodes(), random);
  LevelVector<dim, Number> y(K.grid->n_nodes());
  std::chrono::duration<double, std::nano> least = std::chrono::hours(1);
  for (unsigned int k = 0; k < 10; ++k) {
    const auto start = std::chrono::steady_clock::now();
    K.multiply(y, x, instructions);
    least = std::min<decltype(least)>(least, std::chrono::steady_clock::now() - start);
  }
  return least.count() / static_cast<double>(K.grid->n_cells);
}

/** Rows of a table: n^dim cells. Double precision takes the rule of the assembly. */
template <int dim, typename Number>
void time_kernels(std::ostream &table, const std::string &name, const unsigned int n) {
  RandomNumbers random(n);
  auto shared = random_operator<dim, Number>(n, false, random);
  std::fill(shared.storage.begin(), shared.storage.end(), 0);
  const auto integrated =
    random_operator<dim, Number>(n, true, random, sizeof(Number) == sizeof(double) ? 4 : 2);
  const auto stored = random_operator<dim, Number>(n, false, random);
  for (const auto &[instructions, set] :
       {std::pair(Instructions::basic, "basic"), std::pair(Instructions::avx2, "AVX2"),
        std::pair(Instructions::avx512, "AVX-512")})
    if (instructions <= instructions_of_this_machine()) {
      table << name << ',' << set;
      for (const double time : {time_of(shared, instructions), time_of(integrated, instructions),
                                time_of(stored, instructions)})
        table << ',' << (time < 10. ? std::round(10. * time) / 10. : std::round(time));
      table << '\n';
    }
}

/** multigrid_kernels.csv. */
void times(Checks &checks) {
  if (!checks.is_long())
    return;
  std::ofstream table("multigrid_kernels.csv");
  table << "product,instructions,shared,integrated,stored\n";
  time_kernels<2, float>(table, "\"plane, single precision\"", 512);
  time_kernels<2, double>(table, "\"plane, double\"", 512);
  time_kernels<3, float>(table, "\"space, single precision\"", 32);
  time_kernels<3, double>(table, "\"space, double\"", 32);
}

void agreement(Checks &checks) {
  for (const bool integrated : {false, true})
    for (const unsigned int n : {2U, 8U, 16U, 32U}) {
      products<2, float>(checks, n, integrated, 1e-4);
      products<2, double>(checks, n, integrated, 1e-13);
      if (n == 2 || n == 16) {
        products<3, float>(checks, n, integrated, 1e-4);
        products<3, double>(checks, n, integrated, 1e-13);
      }
    }
  smoothing<2>(checks);
  smoothing<3>(checks);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests({agreement, times}, true, argc > 1 && argv[1] == std::string("long"));
}
