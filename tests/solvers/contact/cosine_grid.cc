// SPDX-License-Identifier: LGPL-2.1-or-later
// The cosine series on a grid of patches against closed forms.

#include <signorini/solvers/contact/kernel_models.h>
#include <signorini/verification/norms/cosine_norm.h>

#include <cmath>

#include "random_numbers.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** The norm of doc/formulas.md on a segment has omega_0 = 1. */
void series(Checks &checks) {
  constexpr unsigned int n = 12;
  constexpr double length = 1.7;
  const CosineGrid grid({n, 1}, {length, 0.}, 1.);
  std::vector<double> ends;
  for (unsigned int i = 0; i <= n; ++i)
    ends.push_back(length * i / n);
  const auto gram = CosineNorm<2>(length).gram_matrix(ends);
  double largest = 0.;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      largest = std::max(largest, std::abs(gram(i, j) - grid.entry(i, j)));
  checks.near("Gram matrix of the spectral norm", largest / gram(0, 0), 0., 1e-4);
}

void products(Checks &checks) {
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
  const auto expect = [&](const std::string &name, dealii::Vector<double> found,
                          const dealii::Vector<double> &expected) {
    found -= expected;
    checks.near(name, found.linfty_norm() / expected.linfty_norm(), 0., 1e-13);
  };
  expect("product by entries", apply(P, false), by_entries);
  expect("inverse", apply(apply(P, false), true), P);
  constant = 3.;
  dealii::Vector<double> expected(35);
  expected = 3. * (2. / 35.) / 0.5;
  expect("constants: area/omega_0", apply(constant, false), expected);
}

} // namespace

int main() {
  return run_tests({series, products});
}
