// SPDX-License-Identifier: LGPL-2.1-or-later
// u_h on a cell, evaluated by sum factorisation.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/hp/indicators.h>
#include <signorini/postprocessing/fields/forces.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>

#include <boost/math/statistics/linear_regression.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace Signorini {
LineTable make_line_table(const unsigned int degree, const std::vector<double> &points) {
  using Basis = std::vector<Polynomials::Polynomial<double>>;
  // Newton's method finds the nodes in long double: once for every degree.
  thread_local std::map<unsigned int, Basis> known;
  Basis &basis = known[degree];
  if (basis.empty())
    basis =
      Polynomials::generate_complete_Lagrange_basis(QGaussLobatto<1>(degree + 1).get_points());
  return make_line_table(basis, points);
}

Tensor<1, 2> CellField::on_face(const unsigned int face, const double s) const {
  const LineTable line = make_line_table(degree_, {s});
  const unsigned int fixed = face % 2 * degree_;
  Tensor<1, 2> value;
  for (unsigned int i = 0; i <= degree_; ++i)
    value += line.values(0, i) *
             (face < 2 ? values_[fixed + (degree_ + 1) * i] : values_[i + (degree_ + 1) * fixed]);
  return value;
}

CellField::CellField(const DoFHandler<2>::active_cell_iterator &cell, const Displacement &U)
  : degree_(cell->get_fe().degree) {
  const FiniteElement<2> &element = cell->get_fe();
  dealii::Vector<double> nodal(element.n_dofs_per_cell());
  cell->get_dof_values(U, nodal);
  values_.resize(nodal.size() / 2);
  const auto numbers = FETools::hierarchic_to_lexicographic_numbering<2>(degree_);
  for (unsigned int i = 0; i < nodal.size(); ++i) {
    const auto [component, node] = element.system_to_component_index(i);
    values_[numbers[node]][component] = nodal[i];
  }
}

// The decay of Legendre coefficients, cell by cell.

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

/** Returns the area of the quadrilateral of the vertices. It is computed from differences only:
 * cells may be 1e-9 of their distance from the origin. */
double area_of(const Triangulation<2>::active_cell_iterator &cell) {
  const Tensor<1, 2> first = cell->vertex(3) - cell->vertex(0);
  const Tensor<1, 2> second = cell->vertex(2) - cell->vertex(1);
  return 0.5 * std::abs(first * cross_product_2d(second));
}
} // namespace

double indicator_modulus(const Scene<2> &scene, const Point<2> &x) {
  const SymmetricTensor<4, 2> E = scene.material->hooke(x);
  return std::min(std::max(E[0][0][0][0], E[1][1][1][1]), 4. * E[0][1][0][1]);
}

std::vector<CellIndicator> indicate(const DisplacementSpace<2> &space, const Scene<2> &scene,
                                    const Displacement &U) {
  std::map<unsigned int, Analysis> analyses;
  std::vector<CellIndicator> indicators;
  for (const auto &cell : space.dofs().active_cell_iterators()) {
    const CellField u(cell, U);
    const Analysis &analysis = analyses.try_emplace(u.degree(), u.degree()).first->second;
    const double lengths[] = {0.5 * (cell->face(2)->diameter() + cell->face(3)->diameter()),
                              0.5 * (cell->face(0)->diameter() + cell->face(1)->diameter())};
    const double modulus = indicator_modulus(scene, cell->center());
    CellIndicator indicator;
    double square = 0.;
    for (unsigned int d = 0; d < 2; ++d) {
      const CellIndicator along = extrapolate(parts_along(d, u, analysis));
      const double size = modulus * area_of(cell) / (lengths[d] * lengths[d]);
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
    square += indicator.error * indicator.error;
  return std::sqrt(square);
}

// The misfits u_n - g where the body presses, and u_t - g_t where it sticks.

void add_contact_misfit(const DisplacementSpace<2> &space, const MultiplierSpace<2> &multipliers,
                        const Scene<2> &scene, const Displacement &U,
                        const std::vector<bool> &follows, const Component component,
                        std::vector<CellIndicator> &indicators) {
  const ContactSurface<2> &surface = multipliers.surface();
  TraceValues<2> traces(space);
  for (const Piece<2> &piece : surface.pieces()) {
    if (!follows[piece.patch])
      continue;
    const ContactFace<2> &face = surface.faces()[piece.face];
    const unsigned int p = space.element(face.cell).degree;
    const SurfaceRule<2> rule = surface.rule(piece, p + 2);
    const std::vector<double> depths = penetration(surface, piece, rule, U, traces, component);
    double square = 0.;
    for (std::size_t q = 0; q < rule.size(); ++q)
      square += depths[q] * depths[q] * rule.weights[q];
    const double waves = 0.5 * numbers::PI * p / surface.patches()[piece.patch].measure;
    CellIndicator &indicator = indicators[face.cell->active_cell_index()];
    indicator.error = std::sqrt(indicator.error * indicator.error +
                                indicator_modulus(scene, face.cell->center()) * waves * square);
  }
}

// Penetration between the nodes of the multipliers.

namespace {
/** The extreme values of u_n - g on a patch, and whether a multiplier presses. */
struct PatchState {
  unsigned int cell = 0;
  double deepest = 0., largest = 0.;
  bool presses = false;
};

/** Adds samples of u_n - g on a piece to the state of its patch. Around the deepest point the next
 * samples are closer to each other: a tip may touch between those of the whole face. */
void add_samples(const ContactSurface<2> &surface, const Piece<2> &piece, const Displacement &U,
                 TraceValues<2> &traces, PatchState &state) {
  constexpr unsigned int n_zooms = 3, n_intervals = 32;
  double from = 0., to = 1.;
  for (unsigned int zoom = 0; zoom < n_zooms; ++zoom) {
    std::vector<Point<1>> positions;
    for (unsigned int i = 0; i <= n_intervals; ++i)
      positions.emplace_back(from + (to - from) * i / n_intervals);
    const SurfaceRule<2> rule = surface.at(piece, positions);
    const std::vector<double> depths = penetration(surface, piece, rule, U, traces);
    const auto deepest = std::max_element(depths.begin(), depths.end());
    state.deepest = std::max(state.deepest, *deepest);
    for (const double depth : depths)
      state.largest = std::max(state.largest, std::abs(depth));
    const double middle = positions[deepest - depths.begin()][0], step = (to - from) / n_intervals;
    from = std::max(0., middle - step);
    to = std::min(1., middle + step);
  }
}

std::vector<PatchState> patch_states(const DisplacementSpace<2> &space,
                                     const MultiplierSpace<2> &multipliers, const Displacement &U,
                                     const Pressure &P) {
  const ContactSurface<2> &surface = multipliers.surface();
  std::vector<PatchState> states(surface.patches().size());
  TraceValues<2> traces(space);
  for (const Piece<2> &piece : surface.pieces()) {
    PatchState &state = states[piece.patch];
    state.cell = surface.faces()[piece.face].cell->active_cell_index();
    add_samples(surface, piece, U, traces, state);
  }
  const double threshold = pressing_threshold(P);
  for (unsigned int k = 0; k < P.size(); ++k)
    if (P[k] < threshold)
      states[multipliers.patch_of(k)].presses = true;
  return states;
}
} // namespace

std::vector<unsigned int> missed_contact_cells(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const Displacement &U, const Pressure &P) {
  constexpr double rounding = 1e-10, noticeable = 1e-3;
  const std::vector<PatchState> states = patch_states(space, multipliers, U, P);
  double largest = 0.;
  bool touches = false;
  for (const PatchState &state : states) {
    largest = std::max(largest, state.largest);
    touches = touches || state.presses;
  }
  const double tolerance = largest * (touches ? noticeable : rounding);
  std::vector<unsigned int> cells;
  for (std::size_t patch = 0; patch < states.size(); ++patch) {
    const auto presses = [&](const std::size_t other) {
      return other < states.size() && states[other].presses;
    };
    if (states[patch].deepest > tolerance && !presses(patch) && !presses(patch + 1) &&
        !(patch > 0 && presses(patch - 1)))
      cells.push_back(states[patch].cell);
  }
  return cells;
}

// A pressure at the nodes of another mesh.

Pressure transfer_pressure(const MultiplierSpace<2> &from, const Pressure &P,
                           const MultiplierSpace<2> &to, const Interval &allowed) {
  const std::vector<Patch<2>> &known = from.surface().patches();
  Pressure transferred(to.n_multipliers());
  std::size_t patch = 0;
  for (unsigned int k = 0; k < transferred.size(); ++k) {
    const unsigned int side = to.surface().patches()[to.patch_of(k)].side;
    const Point<1> s = to.node(k);
    // Patches and nodes are sorted by side and arc length.
    while (patch + 1 < known.size() && (known[patch].side < side || (known[patch].side == side &&
                                                                     known[patch].upper[0] < s[0])))
      ++patch;
    if (known[patch].side == side)
      transferred[k] = std::clamp(from.value(P, patch, s), allowed.lower, allowed.upper);
  }
  return transferred;
}
} // namespace Signorini
