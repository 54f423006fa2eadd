// SPDX-License-Identifier: LGPL-2.1-or-later
// The cosine series on a grid of patches, and integrals of the kernel, against closed forms.

#include <signorini/postprocessing/norms/spectral_norm.h>
#include <signorini/solvers/cycles/kernel_models.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <numeric>

#include "random_numbers.h"
#include "tests.h"

using namespace Signorini;

namespace
{
double difference(dealii::Vector<double> a, const dealii::Vector<double> &b)
{
  a -= b;
  return a.linfty_norm() / b.linfty_norm();
}

/** The norm of doc/formulas.md on a segment has omega_0 = 1. */
void series(Checks &checks)
{
  constexpr unsigned int n = 12;
  constexpr double length = 1.7;
  const CosineGrid grid({n, 1}, {length, 0.}, 1.);
  std::vector<double> ends;
  for (unsigned int i = 0; i <= n; ++i)
    ends.push_back(length * i / n);
  const auto gram = SpectralNorm(length).gram_matrix(ends);
  double largest = 0.;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      largest = std::max(largest, std::abs(gram(i, j) - grid.entry(i, j)));
  checks.near("Gram matrix of the spectral norm", largest / gram(0, 0), 0., 1e-4);
}

void products(Checks &checks)
{
  RandomNumbers random(1);
  const CosineGrid grid({5, 7}, {1., 2.}, 0.5);
  const dealii::Vector<double> P = random.vector(grid.size());
  dealii::Vector<double> by_entries(grid.size()), constant(grid.size());
  for (unsigned int i = 0; i < grid.size(); ++i)
    for (unsigned int j = 0; j < grid.size(); ++j)
      by_entries[i] += grid.entry(i, j) * P[j];
  checks.near("product by entries", difference(grid.apply(P), by_entries), 0., 1e-13);
  checks.near("inverse", difference(grid.apply_inverse(grid.apply(P)), P), 0., 1e-13);
  constant = 3.;
  dealii::Vector<double> expected(grid.size());
  expected = 3. * (2. / 35.) / 0.5;
  checks.near("constants: area/omega_0", difference(grid.apply(constant), expected), 0., 1e-13);
}

/** Solves on sets by factors and by gradients. */
void solves(Checks &checks)
{
  RandomNumbers random(2);
  const unsigned int n = 32;
  std::vector<GridBlock> blocks = {{CosineGrid({n, n}, {1., 1.}, 1.), {}}};
  blocks[0].multipliers.resize(n * n);
  std::iota(blocks[0].multipliers.begin(), blocks[0].multipliers.end(), 0);
  dealii::Vector<double> scaling = random.vector(n * n);
  for (double &s : scaling)
    s = 1.5 + 0.5 * s;
  const CosineModel model(blocks, scaling, 500);
  for (const unsigned int radius : {8U, 15U})
  {
    std::vector<unsigned int> set;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        if (std::hypot(i - 15.5, j - 15.5) < radius)
          set.push_back(i + n * j);
    const dealii::Vector<double> rhs = random.vector(set.size());
    const dealii::Vector<double> x = model.solve(set, rhs);
    dealii::Vector<double> all(n * n), back(set.size());
    for (unsigned int r = 0; r < set.size(); ++r)
      all[set[r]] = x[r];
    const dealii::Vector<double> product = model.apply(all);
    for (unsigned int r = 0; r < set.size(); ++r)
      back[r] = product[set[r]];
    checks.near(
      "solve on " + std::to_string(set.size()) + " patches", difference(back, rhs), 0., 1e-8);
  }
}

/** Potentials known in closed form. */
void kernels(Checks &checks)
{
  using std::log;
  const FlatPatch<2> segment = {{0., 0.}, {dealii::Point<2>(2., 0.)}, 2.};
  // -int_0^2 log|1 - s| = 2.
  checks.near("segment, its middle", patch_potential<2>(segment, {1., 0.}, 1.), 2., 1e-14);
  checks.near("segment, R = e", patch_potential<2>(segment, {1., 0.}, std::exp(1.)), 4., 1e-14);
  // -int_0^2 log r at (0, 2): -(2 log 8/2 - 2 + 2 atan 1).
  checks.near("segment, aside",
              patch_potential<2>(segment, {0., 2.}, 1.),
              2. - log(8.) - dealii::numbers::PI_2,
              1e-14);
  const FlatPatch<3> square = {
    {-1., -1., 0.}, {dealii::Point<3>(2., 0., 0.), dealii::Point<3>(0., 2., 0.)}, 4.};
  // 8 log(1 + sqrt 2) times 1/2.
  checks.near("square, its middle",
              patch_potential<3>(square, {0., 0., 0.}, 1.),
              4. * log(1. + std::sqrt(2.)),
              1e-13);
  checks.near("square, far away", patch_potential<3>(square, {0., 0., 1e3}, 1.), 4. * 0.5e-3, 1e-8);
  // The mean of 1/r over pairs of points of the unit square: 4 log(1 + sqrt 2) - 4 (sqrt 2 - 1)/3.
  const FlatPatch<3> unit = {
    {0., 0., 0.}, {dealii::Point<3>(1., 0., 0.), dealii::Point<3>(0., 1., 0.)}, 1.};
  checks.near("square with itself",
              patch_interaction<3>(unit, unit, 1.),
              2. * log(1. + std::sqrt(2.)) - 2. * (std::sqrt(2.) - 1.) / 3.,
              3e-3);
}
} // namespace

int main()
{
  Checks checks;
  series(checks);
  products(checks);
  solves(checks);
  kernels(checks);
  return checks.exit_code();
}
