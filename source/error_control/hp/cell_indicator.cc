// SPDX-License-Identifier: LGPL-2.1-or-later
// The decay of Legendre coefficients, cell by cell.

#include <signorini/discretization/space/cell_field.h>
#include <signorini/error_control/equilibration/cell_shape.h>
#include <signorini/error_control/estimate/contact_part.h>
#include <signorini/error_control/hp/cell_indicator.h>

#include <deal.II/base/quadrature_lib.h>

#include <boost/math/statistics/linear_regression.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace Signorini {
namespace {
/** The matrix that takes values at the nodes of an edge to the orthonormal Legendre coefficients 0,
 * ..., p - 1 of the derivative, and the weights of Gauss and Lobatto at the nodes. */
struct Analysis {
  explicit Analysis(const unsigned int degree)
    : coefficients(degree, degree + 1)
    , weights(QGaussLobatto<1>(degree + 1).get_weights()) {
    const QGauss<1> gauss(degree + 1);
    std::vector<double> points;
    for (const Point<1> &x : gauss.get_points())
      points.push_back(x[0]);
    const LineTable table = make_line_table(degree, points);
    for (unsigned int i = 0; i < degree; ++i)
      for (unsigned int k = 0; k <= degree; ++k)
        for (unsigned int q = 0; q < gauss.size(); ++q)
          coefficients(i, k) += std::sqrt(2. * i + 1.) * std::legendre(i, 2. * points[q] - 1.) *
                                table.derivatives(q, k) * gauss.weight(q);
  }

  FullMatrix<double> coefficients;
  std::vector<double> weights;
};

/** Returns ‖s_i‖ of the reference cell along coordinate d. */
std::vector<double> parts_along(const unsigned int d, const CellField &u,
                                const Analysis &analysis) {
  const unsigned int p = u.degree();
  std::vector<double> squares(p, 0.);
  for (unsigned int c = 0; c < 2; ++c)
    for (unsigned int across = 0; across <= p; ++across)
      for (unsigned int i = 0; i < p; ++i) {
        double coefficient = 0.;
        for (unsigned int k = 0; k <= p; ++k)
          coefficient += analysis.coefficients(i, k) * (d == 0 ? u(c, k, across) : u(c, across, k));
        squares[i] += analysis.weights[across] * coefficient * coefficient;
      }
  for (double &square : squares)
    square = std::sqrt(square);
  return squares;
}

/** Returns the missing parts, from a line through the logarithms of the last ones. */
CellIndicator extrapolate(const std::vector<double> &parts) {
  constexpr unsigned int max_parts = 4;
  constexpr double slowest = 0.9, fastest = 0.02;
  const unsigned int p = parts.size();
  const unsigned int first = p > max_parts ? p - max_parts : 0;
  // Parts that are rounding against the largest one do not enter the slope.
  const double negligible = 1e-13 * *std::max_element(parts.begin(), parts.end());
  std::vector<double> degrees, logarithms;
  for (unsigned int i = first; i < p; ++i) {
    degrees.push_back(i);
    logarithms.push_back(std::log(std::max(parts[i], negligible + 1e-300)));
  }
  const auto [constant, slope] =
    boost::math::statistics::simple_ordinary_least_squares(degrees, logarithms);
  const double rho = std::clamp(std::exp(slope), fastest, slowest);
  const double by_line = std::exp(constant + slope * p);
  // A line through two parts of an odd or even function may be steeper than both.
  const double next = std::clamp(by_line, rho * parts[p - 1], parts[p - 1]);
  return {next / std::sqrt(1. - rho * rho), rho};
}

} // namespace

std::vector<CellIndicator> indicate(const DisplacedBody<2> &body) {
  std::map<unsigned int, Analysis> analyses;
  std::vector<CellIndicator> indicators;
  for (const auto &cell : body.space.dofs().active_cell_iterators()) {
    const CellField u(cell, body.U);
    const Analysis &analysis = analyses.try_emplace(u.degree(), u.degree()).first->second;
    const double lengths[] = {0.5 * (cell->face(2)->diameter() + cell->face(3)->diameter()),
                              0.5 * (cell->face(0)->diameter() + cell->face(1)->diameter())};
    const double modulus = softer_modulus(body.scene, cell->center());
    // From differences only: cells may be 1e-9 of their distance from the origin.
    const double area =
      0.5 * cross(cell->vertex(3) - cell->vertex(0), cell->vertex(2) - cell->vertex(1)) *
      body.scene.geometry.circumference(cell->center());
    CellIndicator indicator;
    double square = 0.;
    for (unsigned int d = 0; d < 2; ++d) {
      const CellIndicator along = extrapolate(parts_along(d, u, analysis));
      const double size = modulus * area / (lengths[d] * lengths[d]);
      square += size * along.error * along.error;
      // The direction that the error comes from decides.
      indicator.decay += along.decay * size * along.error * along.error;
    }
    indicator.decay = square > 0. ? indicator.decay / square : 0.;
    indicator.error = std::sqrt(square);
    indicators.push_back(indicator);
  }
  return indicators;
}

double total(const std::vector<CellIndicator> &indicators) {
  double square = 0.;
  for (const CellIndicator &indicator : indicators)
    square += std::pow(indicator.error, 2) + std::pow(indicator.oscillation, 2);
  return std::sqrt(square);
}
} // namespace Signorini
