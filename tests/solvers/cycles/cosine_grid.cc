// SPDX-License-Identifier: LGPL-2.1-or-later
// The cosine series on a grid of patches against closed forms.

#include <signorini/postprocessing/norms/spectral_norm.h>
#include <signorini/solvers/cycles/kernel_models.h>

#include <cmath>

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
  const dealii::Vector<double> P = random.vector(35);
  dealii::Vector<double> by_entries(35), constant(35);
  for (unsigned int i = 0; i < 35; ++i)
    for (unsigned int j = 0; j < 35; ++j)
      by_entries[i] += grid.entry(i, j) * P[j];
  const auto apply = [&](const dealii::Vector<double> &x, const bool inverse) {
    dealii::Vector<double> y(35);
    grid.apply(y, x, inverse);
    return y;
  };
  checks.near("product by entries", difference(apply(P, false), by_entries), 0., 1e-13);
  checks.near("inverse", difference(apply(apply(P, false), true), P), 0., 1e-13);
  constant = 3.;
  dealii::Vector<double> expected(35);
  expected = 3. * (2. / 35.) / 0.5;
  checks.near("constants: area/omega_0", difference(apply(constant, false), expected), 0., 1e-13);
}

/** Solves on sets by factors and by gradients. */
void solves(Checks &checks)
{
  RandomNumbers random(2);
  const unsigned int n = 32;
  dealii::Vector<double> scaling = random.vector(n * n);
  for (double &s : scaling)
    s = 1.5 + 0.5 * s;
  const CosineModel model({CosineGrid({n, n}, {1., 1.}, 1.)}, scaling, 500);
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

} // namespace

int main()
{
  Checks checks;
  series(checks);
  products(checks);
  solves(checks);
  return checks.exit_code();
}
