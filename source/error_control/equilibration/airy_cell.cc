// SPDX-License-Identifier: LGPL-2.1-or-later
// Stresses on a quadrilateral from Airy's functions on its four triangles, without loads and for
// body forces.

#include <signorini/base/errors.h>
#include <signorini/error_control/equilibration/airy_cell.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/lapack_templates.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Signorini {
namespace {
/** A function with its first and second derivative. */
using Jet = std::array<double, 3>;

const char *const too_flat = "a cell is too flat for stresses in equilibrium";

/** Writes R of A = Q R, at the given row of its diagonal, by Householder's reflections: they keep
 * twice the digits of a factor of AᵀA = RᵀR. @throws ComputationError if R is singular. */
void write_factor(LAPACKFullMatrix<double> A, LAPACKFullMatrix<double> &R,
                  const unsigned int first = 0) {
  const types::blas_int m = A.m(), n = A.n(), n_work = 32 * n;
  if (m < n) // No points: a triangle without area.
    throw ComputationError(too_flat);
  types::blas_int info = 0;
  std::vector<double> scales(n), work(n_work);
  geqrf(&m, &n, &A(0, 0), &m, scales.data(), work.data(), &n_work, &info);
  for (unsigned int j = 0; j < A.n(); ++j) {
    if (A(j, j) == 0.)
      throw ComputationError(too_flat);
    for (unsigned int i = 0; i <= j; ++i)
      R(first + i, first + j) = A(i, j);
  }
  R.set_property(LAPACKSupport::upper_triangular);
}

/** Returns (AᵀA + scale² BᵀB)⁻¹ from a factor of the rows of A and scale B. @throws
 * ComputationError if the product with columns of norm one is singular. */
FullMatrix<double> inverse_of_square(const LAPACKFullMatrix<double> &A,
                                     const LAPACKFullMatrix<double> &B, const double scale) {
  const unsigned int n = A.n();
  LAPACKFullMatrix<double> both(A.m() + B.m(), n), R(n);
  std::vector<double> squares(n);
  for (unsigned int i = 0; i < both.m(); ++i)
    for (unsigned int j = 0; j < n; ++j) {
      both(i, j) = i < A.m() ? A(i, j) : scale * B(i - A.m(), j);
      squares[j] += both(i, j) * both(i, j);
    }
  write_factor(both, R);
  R.invert();
  FullMatrix<double> inverse(n, n);
  R.mTmult(inverse, R);
  double condition = 0.;
  for (unsigned int i = 0; i < n; ++i)
    condition += std::sqrt(squares[i] * inverse(i, i));
  if (!(condition < 1e10))
    throw ComputationError(too_flat);
  return inverse;
}

/** Returns τ n. */
Tensor<1, 2> traction(const Components &s, const Tensor<1, 2> &n) {
  return Tensor<1, 2>({s[0] * n[0] + s[2] * n[1], s[2] * n[0] + s[1] * n[1]});
}

/** Returns f_0, ..., f_n at x, those of the half-axis on which x lies. */
std::vector<Jet> axis_functions(const unsigned int n, const double x, const double half_axis) {
  const double t = std::abs(x) / half_axis, z = 2. * t - 1.,
               scale = (x < 0. ? -1. : 1.) / half_axis;
  std::vector<Jet> f = {{{1., 0., 0.}}, {{x, 1., 0.}}};
  // Legendre's polynomials of z, times X².
  const auto P = legendre_jets(n - 2, z);
  for (unsigned int i = 2; i <= n; ++i) {
    const auto &[p, dp, ddp] = P[i - 2];
    f.push_back({{t * t * p, scale * (2. * t * p + 2. * t * t * dp),
                  scale * scale * (2. * p + 8. * t * dp + 4. * t * t * ddp)}});
  }
  return f;
}
} // namespace

AiryCell::AiryCell(const CellShape &unit_shape, const unsigned int degree,
                   std::array<std::vector<AiryPoint>, 4> points)
  : shape_(unit_shape)
  , degree_(degree)
  , points_(std::move(points))
  , F_(shape_.half_diagonals())
  , inverse_(invert(F_))
  , balance_(balance_rows(unit_shape, degree)) {
  const auto &x = shape_.corners;
  const Tensor<1, 2> a = x[0] - shape_.crossing, b = x[1] - shape_.crossing;
  push_forward_ = Tensor<2, 3>({{a[0] * a[0], b[0] * b[0], 2. * a[0] * b[0]},
                                {a[1] * a[1], b[1] * b[1], 2. * a[1] * b[1]},
                                {a[0] * a[1], b[0] * b[1], a[0] * b[1] + a[1] * b[0]}});
  half_axes_ = {
    {1., 1., x[2].distance(shape_.crossing) / a.norm(), x[3].distance(shape_.crossing) / b.norm()}};
  for (unsigned int k = 0; k < 4; ++k)
    if (shape_.centres[k])
      lifts_[k].emplace(shape_.seen_from_crossing().edge(k), degree);
  number_functions();
  factorise();
  factorise_loads();
}

void AiryCell::number_functions() {
  const unsigned int m = degree_ + 2;
  // The numbers by i, j, and the half-axes on which functions of i ≥ 2 or j ≥ 2 live.
  std::map<std::array<unsigned int, 4>, unsigned int> known;
  // Those of one triangle come first: factorise() begins with them.
  for (const bool is_inner : {true, false})
    for (unsigned int i = 0; i <= m; ++i)
      for (unsigned int j = i < 2 ? 2 - i : 0; i + j <= m; ++j) {
        if ((i > 1 && j > 1) != is_inner)
          continue;
        pairs_.push_back({{i, j}});
        // Triangle k lies between half-axes k and k + 1: on the negative one of X for k = 1, 2.
        for (unsigned int k = 0; k < 4; ++k)
          numbers_[k].push_back(
            known
              .emplace(
                std::array<unsigned int, 4>{{i, i < 2 ? 0 : (k + 1) % 4 / 2, j, j < 2 ? 0 : k / 2}},
                known.size())
              .first->second);
      }
  n_functions_ = known.size();
  for (unsigned int k = 0; k < 4; ++k)
    for (unsigned int i = 0; i < 2 * (degree_ + 1) && lifts_[k]; ++i)
      numbers_[k].push_back(n_functions_++);
}

unsigned int AiryCell::first_condition(const unsigned int k) const {
  const auto n_before = std::count_if(lifts_.begin(), lifts_.begin() + k,
                                      [](const auto &lift) { return lift.has_value(); });
  return 8 * (degree_ + 1) + ArcLift::n_conditions * n_before;
}

std::vector<Components> AiryCell::stresses(const unsigned int k, const Point<2> &at) const {
  AssertIndexRange(k, 4);
  const unsigned int m = degree_ + 2;
  const std::vector<Jet> f = axis_functions(m, at[0], half_axes_[(k + 1) % 4 / 2 * 2]),
                         g = axis_functions(m, at[1], half_axes_[k / 2 * 2 + 1]);
  std::vector<Components> stresses;
  for (const auto &[i, j] : pairs_)
    stresses.push_back(push_forward_ *
                       Components({f[i][0] * g[j][2], f[i][2] * g[j][0], -f[i][1] * g[j][1]}));
  return stresses;
}

std::vector<AiryCell::TracePoint> AiryCell::trace_points(const unsigned int k) const {
  std::vector<TracePoint> points;
  if (lifts_[k]) {
    for (const ArcLift::Node &node : lifts_[k]->nodes())
      points.push_back({on_diagonals(node.x), {}});
    return points;
  }
  const QGauss<1> gauss(degree_ + 2);
  const Tensor<1, 2> a = shape_.corners[k] - shape_.crossing,
                     d = shape_.corners[(k + 1) % 4] - shape_.corners[k], t = d / d.norm();
  const Components on_normal({t[1] * t[1], t[0] * t[0], -2. * t[0] * t[1]}),
    on_shear({t[0] * t[1], -t[0] * t[1], t[1] * t[1] - t[0] * t[0]});
  for (unsigned int q = 0; q < gauss.size(); ++q) {
    const double s = gauss.point(q)[0];
    const std::vector<double> L = legendre_values(degree_, s);
    TracePoint &point = points.emplace_back(TracePoint{on_diagonals(a + s * d), {}});
    for (unsigned int i = 0; i <= degree_; ++i) {
      point.factors.emplace_back(2 * k * (degree_ + 1) + i, gauss.weight(q) * L[i] * on_normal);
      point.factors.emplace_back((2 * k + 1) * (degree_ + 1) + i,
                                 gauss.weight(q) * L[i] * on_shear);
    }
  }
  return points;
}

LAPACKFullMatrix<double> AiryCell::subtract_lift(const unsigned int k,
                                                 const LAPACKFullMatrix<double> &r,
                                                 LAPACKFullMatrix<double> &values) const {
  LAPACKFullMatrix<double> lifted(values.m(), values.n()), conditions(ArcLift::n_conditions, r.n());
  lifts_[k]->stresses().mmult(lifted, r);
  lifts_[k]->conditions().mmult(conditions, r);
  for (std::size_t q = 0; q < points_[k].size(); ++q)
    for (unsigned int l = 0; l < values.n(); ++l) {
      const Components weighted =
        points_[k][q].of_stress *
        Components({lifted(3 * q, l), lifted(3 * q + 1, l), lifted(3 * q + 2, l)});
      for (unsigned int c = 0; c < 3; ++c)
        values(3 * q + c, l) -= weighted[c];
    }
  return conditions;
}

void AiryCell::tabulate(const unsigned int k) {
  const unsigned int n_local = numbers_[k].size(), n_airy = pairs_.size();
  LAPACKFullMatrix<double> &values = values_[k];
  values.reinit(3 * points_[k].size(), n_local);
  for (std::size_t q = 0; q < points_[k].size(); ++q) {
    const std::vector<Components> at_point = stresses(k, points_[k][q].on_diagonals);
    for (unsigned int l = 0; l < n_airy; ++l) {
      const Components weighted = points_[k][q].of_stress * at_point[l];
      for (unsigned int c = 0; c < 3; ++c)
        values(3 * q + c, l) = weighted[c];
    }
  }
  trace_points_[k] = trace_points(k);
  // The tractions that lifts take away at the nodes of an arc: τ n, and -λ.
  LAPACKFullMatrix<double> tractions(lifts_[k] ? 2 * lifts_[k]->nodes().size() : 0, n_local);
  for (std::size_t i = 0; i < trace_points_[k].size(); ++i) {
    const std::vector<Components> at_point = stresses(k, trace_points_[k][i].on_diagonals);
    for (const auto &[row, factors] : trace_points_[k][i].factors)
      for (unsigned int l = 0; l < n_airy; ++l)
        traces_(numbers_[k][l], row) += factors * at_point[l];
    if (!lifts_[k])
      continue;
    const ArcLift::Node &node = lifts_[k]->nodes()[i];
    const std::vector<double> L = legendre_values(degree_, node.position);
    for (unsigned int c = 0; c < 2; ++c) {
      for (unsigned int l = 0; l < n_airy; ++l)
        tractions(2 * i + c, l) = traction(at_point[l], node.normal)[c];
      const Tensor<1, 2> m = shape_.directions[k].value_or(node.normal),
                         t = direction_of(Component::tangential, m);
      for (unsigned int j = 0; j <= degree_; ++j) {
        tractions(2 * i + c, n_airy + j) = -L[j] * m[c];
        tractions(2 * i + c, n_airy + degree_ + 1 + j) = -L[j] * t[c];
      }
    }
  }
  if (!lifts_[k])
    return;
  const LAPACKFullMatrix<double> conditions = subtract_lift(k, tractions, values);
  for (unsigned int l = 0; l < n_local; ++l)
    for (unsigned int r = 0; r < ArcLift::n_conditions; ++r)
      traces_(numbers_[k][l], first_condition(k) + r) = -conditions(r, l);
  for (unsigned int i = 0; i < 2 * (degree_ + 1); ++i)
    traces_(numbers_[k][n_airy + i], 2 * k * (degree_ + 1) + i) = 1.;
}

void AiryCell::factorise() {
  const unsigned int n = n_functions_, n_traces = first_condition(4);
  traces_.reinit(n, n_traces);
  factor_.reinit(n);
  // Functions of one triangle are eliminated first, the others from the Schur complement.
  const unsigned int n_inner = degree_ * (degree_ - 1) / 2;
  unsigned int n_rows = 0, row = 0;
  for (const auto &numbers : numbers_)
    n_rows += numbers.size() - n_inner;
  LAPACKFullMatrix<double> shared(n_rows, n - 4 * n_inner);
  for (unsigned int k = 0; k < 4; ++k) {
    tabulate(k);
    LAPACKFullMatrix<double> R(numbers_[k].size());
    write_factor(values_[k], R);
    for (unsigned int i = 0; i < R.m(); row += i++ >= n_inner)
      for (unsigned int j = i; j < R.m(); ++j)
        (i < n_inner ? factor_(numbers_[k][i], numbers_[k][j])
                     : shared(row, numbers_[k][j] - 4 * n_inner)) = R(i, j);
  }
  write_factor(shared, factor_, 4 * n_inner);
  factor_.solve(traces_, true);
  // S = (N G⁻¹ Nᵀ + weight⁻¹ BᵀB)⁻¹ - weight BᵀB: the rows of B span the kernel.
  const double norm = traces_.frobenius_norm(), share = norm * norm / n_traces;
  LAPACKFullMatrix<double> rows(3, n_traces), unbalanced(n, 3);
  rows = balance_;
  traces_.mTmult(unbalanced, rows);
  // The rank of N is that of the theory.
  if (!(unbalanced.frobenius_norm() < 1e-8 * norm))
    throw ComputationError(too_flat);
  energy_ = inverse_of_square(traces_, rows, std::sqrt(share));
  add_balance(-1. / share, energy_);
}

void AiryCell::add_balance(const double weight, FullMatrix<double> &matrix) const {
  FullMatrix<double> rows(balance_);
  rows *= weight;
  balance_.Tmmult(matrix, rows, true);
}

AiryCell::Vector AiryCell::project(Vector &values) const {
  Vector a(n_functions_);
  std::size_t begin = 0;
  std::array<Vector, 4> parts;
  for (unsigned int k = 0; k < 4; begin += 3 * points_[k++].size()) {
    parts[k].reinit(3 * points_[k].size());
    std::copy_n(values.begin() + begin, parts[k].size(), parts[k].begin());
    Vector local(numbers_[k].size());
    values_[k].Tvmult(local, parts[k]);
    for (unsigned int l = 0; l < local.size(); ++l)
      a[numbers_[k][l]] += local[l];
  }
  factor_.solve(a, true);
  Vector traces(n_traces());
  traces_.Tvmult(traces, a);
  factor_.solve(a);
  begin = 0;
  for (unsigned int k = 0; k < 4; begin += 3 * points_[k++].size()) {
    Vector local(numbers_[k].size());
    for (unsigned int l = 0; l < local.size(); ++l)
      local[l] = -a[numbers_[k][l]];
    values_[k].vmult(parts[k], local, true);
    std::copy(parts[k].begin(), parts[k].end(), values.begin() + begin);
  }
  return traces;
}

void AiryCell::forget_points() {
  for (unsigned int k = 0; k < 4; ++k) {
    points_[k] = {};
    trace_points_[k] = {};
    values_[k].reinit(0);
    lifts_[k].reset();
  }
  factor_.reinit(0);
  load_factor_.reinit(0);
}

AiryCell::Vector AiryCell::multiply(const Vector &y) const {
  Vector product(y.size());
  energy_.vmult(product, y);
  return product;
}

FullMatrix<double> AiryCell::penalised_energy(const double weight) const {
  FullMatrix<double> matrix(energy_);
  add_balance(weight, matrix);
  return matrix;
}

std::array<double, max_legendre> AiryCell::load_values(const unsigned int d,
                                                       const double at) const {
  // The interval between opposite corners, mapped to [-1,1].
  return legendre(degree_, 2. * (at + half_axes_[d + 2]) / (1. + half_axes_[d + 2]) - 1.);
}

std::array<double, max_legendre> AiryCell::load_integrals(const unsigned int d,
                                                          const double at) const {
  const auto P = load_values(d, at), P_0 = load_values(d, 0.);
  std::array<double, max_legendre> integrals = {{at}};
  for (unsigned int k = 1; k < degree_; ++k)
    integrals[k] = 0.5 * (1. + half_axes_[d + 2]) *
                   (P[k + 1] - P_0[k + 1] - P[k - 1] + P_0[k - 1]) / (2. * k + 1.);
  return integrals;
}

void AiryCell::factorise_loads() {
  LAPACKFullMatrix<double> rows(n_points(), degree_ * (degree_ + 1) / 2);
  unsigned int p = 0;
  for (const auto &triangle : points_)
    for (const AiryPoint &point : triangle) {
      const auto X = load_values(0, point.on_diagonals[0]),
                 Y = load_values(1, point.on_diagonals[1]);
      unsigned int l = 0;
      for (unsigned int i = 0; i < degree_; ++i)
        for (unsigned int j = 0; i + j < degree_; ++j)
          rows(p, l++) = std::sqrt(point.weight) * X[i] * Y[j];
      ++p;
    }
  load_factor_.reinit(rows.n());
  write_factor(rows, load_factor_);
}

PolynomialLoad AiryCell::project(const std::vector<Point<2>> &on_diagonals,
                                 const std::vector<double> &weights,
                                 const std::vector<Tensor<1, 2>> &force,
                                 double &rest_square) const {
  // Point by point: rules on pieces of a cell may have a million of them.
  LAPACKFullMatrix<double> coefficients(load_factor_.m(), 2);
  for (std::size_t p = 0; p < weights.size(); ++p) {
    const auto X = load_values(0, on_diagonals[p][0]), Y = load_values(1, on_diagonals[p][1]);
    const Tensor<1, 2> f = weights[p] * (inverse_ * force[p]);
    unsigned int l = 0;
    for (unsigned int i = 0; i < degree_; ++i)
      for (unsigned int j = 0; i + j < degree_; ++j, ++l)
        for (unsigned int c = 0; c < 2; ++c)
          coefficients(l, c) += X[i] * Y[j] * f[c];
  }
  load_factor_.solve(coefficients, true);
  load_factor_.solve(coefficients);
  PolynomialLoad load;
  for (unsigned int l = 0; l < coefficients.m(); ++l)
    load.emplace_back(Tensor<1, 2>({coefficients(l, 0), coefficients(l, 1)}));
  rest_square = 0.;
  for (std::size_t p = 0; p < weights.size(); ++p)
    rest_square += weights[p] * (force[p] - value(load, on_diagonals[p])).norm_square();
  return load;
}

Tensor<1, 2> AiryCell::value(const PolynomialLoad &load, const Point<2> &at) const {
  const auto X = load_values(0, at[0]), Y = load_values(1, at[1]);
  Tensor<1, 2> f;
  auto coefficient = load.begin();
  for (unsigned int i = 0; i < degree_; ++i)
    for (unsigned int j = 0; i + j < degree_; ++j)
      f += X[i] * Y[j] * *coefficient++;
  return F_ * f;
}

Components AiryCell::stress(const PolynomialLoad &load, const Point<2> &at) const {
  const auto X = load_values(0, at[0]), Y = load_values(1, at[1]), to_X = load_integrals(0, at[0]),
             to_Y = load_integrals(1, at[1]);
  Components s;
  auto coefficient = load.begin();
  for (unsigned int i = 0; i < degree_; ++i)
    for (unsigned int j = 0; i + j < degree_; ++j, ++coefficient) {
      s[0] -= (*coefficient)[0] * to_X[i] * Y[j];
      s[1] -= (*coefficient)[1] * X[i] * to_Y[j];
    }
  return push_forward_ * s;
}

AiryCell::Vector AiryCell::subtract_load(const PolynomialLoad &load, Vector &values) const {
  std::size_t at = 0;
  for (const auto &triangle : points_)
    for (const AiryPoint &point : triangle) {
      const Components weighted = point.of_stress * stress(load, point.on_diagonals);
      for (unsigned int c = 0; c < 3; ++c)
        values[at++] -= weighted[c];
    }
  Vector traces(n_traces());
  for (unsigned int k = 0; k < 4; ++k) {
    std::vector<Tensor<1, 2>> minus_traction;
    for (const TracePoint &point : trace_points_[k]) {
      const Components s = stress(load, point.on_diagonals);
      for (const auto &[row, factors] : point.factors)
        traces[row] += factors * s;
      if (lifts_[k])
        minus_traction.push_back(-1. *
                                 traction(s, lifts_[k]->nodes()[minus_traction.size()].normal));
    }
    if (lifts_[k])
      traces += subtract_traction(k, minus_traction, values);
  }
  return traces;
}

AiryCell::Vector AiryCell::subtract_traction(const unsigned int k,
                                             const std::vector<Tensor<1, 2>> &r,
                                             Vector &values) const {
  AssertIndexRange(k, 4);
  LAPACKFullMatrix<double> column(2 * r.size(), 1), of_triangle(3 * points_[k].size(), 1);
  for (std::size_t i = 0; i < column.m(); ++i)
    column(i, 0) = r[i / 2][i % 2];
  const LAPACKFullMatrix<double> conditions = subtract_lift(k, column, of_triangle);
  Vector traces(n_traces());
  for (unsigned int i = 0; i < ArcLift::n_conditions; ++i)
    traces[first_condition(k) + i] = conditions(i, 0);
  std::size_t begin = 0;
  for (unsigned int before = 0; before < k; ++before)
    begin += 3 * points_[before].size();
  for (std::size_t i = 0; i < of_triangle.m(); ++i)
    values[begin + i] += of_triangle(i, 0);
  return traces;
}
} // namespace Signorini
