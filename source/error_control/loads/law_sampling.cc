// SPDX-License-Identifier: LGPL-2.1-or-later
// The parts of cells on which data is smooth, and how much Hooke's tensor varies in a cell.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/error_control/loads/law_sampling.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
std::array<std::vector<TrianglePart>, 4> triangle_parts(const CellShape &shape,
                                                        const Kinks<2> &kinks) {
  const double least_area = 1e-14 * shape.diameter() * shape.diameter();
  std::array<std::vector<TrianglePart>, 4> parts;
  for (unsigned int k = 0; k < 4; ++k) {
    const Triangle whole = shape.triangle(k);
    for (const auto &[corners, halvings, is_rough] :
         cut_polygon(kinks, {whole.begin(), whole.end()}))
      for (std::size_t i = 2; i < corners.size(); ++i)
        if (const Triangle part = {{corners[0], corners[i - 1], corners[i]}};
            twice_area(part) > least_area)
          parts[k].push_back({part, halvings, is_rough});
  }
  return parts;
}

Quadrature<2> triangle_rule(const unsigned int degree) {
  const unsigned int n = degree / 2 + 1;
  if (n <= 7)
    return QWitherdenVincentSimplex<2>(n);
  return QDuffy(n, 1.);
}

namespace {
/** Returns the norms of Hooke's tensor and of its inverse, and the shares of its entries in the
 * norm. */
std::array<double, 8> features(const SymmetricTensor<4, 2> &C) {
  const Tensor<2, 3> matrix({{C[0][0][0][0], C[0][0][1][1], C[0][0][0][1]},
                             {C[1][1][0][0], C[1][1][1][1], C[1][1][0][1]},
                             {C[0][1][0][0], C[0][1][1][1], C[0][1][0][1]}});
  const Tensor<2, 3> shares = matrix / matrix.norm();
  return {{matrix.norm(), invert(matrix).norm(), shares[0][0], shares[1][1], shares[2][2],
           shares[0][1], shares[0][2], shares[1][2]}};
}
} // namespace

bool law_varies(const Material<2> &material, const std::array<Point<2>, 4> &corners) {
  constexpr unsigned int n = 6;
  constexpr double max_ratio = 1.5, max_difference = 0.4;
  const CellShape shape(corners);
  std::array<double, 8> low, high;
  low.fill(HUGE_VAL);
  high.fill(-HUGE_VAL);
  const QIterated<2> places(QMidpoint<1>(), n);
  for (const Point<2> &at : places.get_points()) {
    const std::array<double, 8> here =
      features(material.relative_hooke(corners[0] + shape.offset(CellFunctions(at))));
    for (unsigned int i = 0; i < here.size(); ++i) {
      low[i] = std::min(low[i], here[i]);
      high[i] = std::max(high[i], here[i]);
    }
  }
  for (unsigned int i = 0; i < low.size(); ++i)
    if (i < 2 ? high[i] > max_ratio * low[i] : high[i] - low[i] > max_difference)
      return true;
  return false;
}
} // namespace Signorini
