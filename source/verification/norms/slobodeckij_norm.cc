// SPDX-License-Identifier: LGPL-2.1-or-later
// |||.|||_{-1/2,Γ_c} as the paper defines it, on one side.

#include <signorini/verification/norms/slobodeckij_norm.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace Signorini {
namespace {
/** A matrix for the values at the two nodes of a first and of a second cell, and such values. */
using PairMatrix = Tensor<2, 4>;
using PairValues = Tensor<1, 4>;

/** Returns the integrals over both orders of two different cells whose first nodes are @p d ≥ 1
 * cells apart. In one dimension the double integral does not depend on the size of the cells. */
PairMatrix pair_matrix(const unsigned int d) {
  if (d == 1) {
    // With al = v0 - v1, be = v2 - v1: 2 [(1 - ln 2)(al² + be²) - 2 (ln 2 - 1/2) al be].
    const double same = 2. * (1. - std::log(2.)), mixed = -2. * (std::log(2.) - 0.5);
    const PairValues al({1., -1., 0., 0.}), be({0., 0., -1., 1.});
    return (same - mixed) * (outer_product(al, al) + outer_product(be, be)) +
           mixed * outer_product(al + be, al + be);
  }
  static const QGauss<1> gauss(12);
  PairMatrix matrix;
  for (unsigned int p = 0; p < gauss.size(); ++p)
    for (unsigned int q = 0; q < gauss.size(); ++q) {
      const double x = gauss.point(p)[0], y = gauss.point(q)[0];
      const PairValues w({1. - x, x, y - 1., -y});
      matrix +=
        2. * gauss.weight(p) * gauss.weight(q) / std::pow(d + y - x, 2) * outer_product(w, w);
    }
  return matrix;
}
} // namespace

LAPACKFullMatrix<double> seminorm_matrix(const unsigned int n_cells) {
  std::vector<PairMatrix> pairs(n_cells);
  for (unsigned int d = 1; d < n_cells; ++d)
    pairs[d] = pair_matrix(d);
  LAPACKFullMatrix<double> matrix(n_cells + 1);
  for (unsigned int c = 0; c < n_cells; ++c) {
    matrix(c, c) += 1.;
    matrix(c + 1, c + 1) += 1.;
    matrix(c, c + 1) -= 1.;
    matrix(c + 1, c) -= 1.;
    // The columns of this cell, as they lie in memory.
    for (unsigned int j = 0; j < 2; ++j)
      for (unsigned int other = 0; other < n_cells; ++other)
        if (other != c) {
          const auto [first, last] = std::minmax(c, other);
          const std::array<unsigned int, 4> nodes = {first, first + 1, last, last + 1};
          for (unsigned int i = 0; i < 4; ++i)
            matrix(nodes[i], c + j) += pairs[last - first][i][c == first ? j : 2 + j];
        }
  }
  return matrix;
}

SlobodeckijNorm::SlobodeckijNorm(const double length, const unsigned int n_cells)
  : length_(length)
  , n_cells_(n_cells)
  , factor_(seminorm_matrix(n_cells)) {
  const double h = length / n_cells;
  for (unsigned int c = 0; c < n_cells; ++c) {
    factor_(c, c) += h / 3.;
    factor_(c + 1, c + 1) += h / 3.;
    factor_(c, c + 1) += h / 6.;
    factor_(c + 1, c) += h / 6.;
  }
  factor_.set_property(LAPACKSupport::symmetric);
  factor_.compute_cholesky_factorization();
}

double SlobodeckijNorm::dual_norm(const std::vector<double> &arc_lengths,
                                  const std::vector<double> &weighted_values) const {
  dealii::Vector<double> b(n_cells_ + 1);
  for (std::size_t q = 0; q < arc_lengths.size(); ++q) {
    const double t = arc_lengths[q] / length_ * n_cells_;
    const unsigned int cell = std::min(static_cast<unsigned int>(std::max(t, 0.)), n_cells_ - 1);
    b[cell] += (1. - (t - cell)) * weighted_values[q];
    b[cell + 1] += (t - cell) * weighted_values[q];
  }
  dealii::Vector<double> x = b;
  factor_.solve(x);
  return std::sqrt(std::max(b * x, 0.));
}
} // namespace Signorini
