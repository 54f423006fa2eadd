// SPDX-License-Identifier: LGPL-2.1-or-later
// The parts of cells on which data is smooth.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/error_control/equilibration/triangle_parts.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

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

void add_points(const Quadrature<2> &rule, const Triangle &part, const CellShape &shape,
                std::vector<Point<2>> &points, std::vector<double> &weights) {
  for (unsigned int q = 0; q < rule.size(); ++q) {
    points.push_back(shape.reference(point_of(part, rule.point(q)) - shape.corners[0]));
    weights.push_back(rule.weight(q) * twice_area(part) /
                      determinant(shape.jacobian(CellFunctions(points.back()))));
  }
}
} // namespace Signorini
