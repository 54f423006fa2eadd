// SPDX-License-Identifier: LGPL-2.1-or-later
// Stresses in equilibrium on one quadrilateral.

#include <signorini/bound/composite_cell.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/householder.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using Vector2 = dealii::Tensor<1, 2>;

/** The outward normal of an edge with the direction d, counter-clockwise, times its length. */
Vector2 scaled_normal(const Vector2 &d)
{
  Vector2 normal;
  normal[0] = d[1];
  normal[1] = -d[0];
  return normal;
}

/** Solves A x = x for the lower triangle of a positive definite matrix, which is destroyed. */
template <std::size_t n, std::size_t m>
void solve_by_cholesky(std::array<std::array<double, n>, n> &A,
                       std::array<std::array<double, m>, n> &x)
{
  for (unsigned int i = 0; i < n; ++i)
  {
    for (unsigned int k = 0; k <= i; ++k)
    {
      double sum = A[i][k];
      for (unsigned int l = 0; l < k; ++l)
        sum -= A[i][l] * A[k][l];
      A[i][k] = k == i ? std::sqrt(sum) : sum / A[k][k];
    }
    for (unsigned int k = 0; k < i; ++k)
      for (unsigned int j = 0; j < m; ++j)
        x[i][j] -= A[i][k] * x[k][j];
    for (unsigned int j = 0; j < m; ++j)
      x[i][j] /= A[i][i];
  }
  for (unsigned int i = n; i-- > 0;)
  {
    for (unsigned int j = 0; j < m; ++j)
      x[i][j] /= A[i][i];
    for (unsigned int k = 0; k < i; ++k)
      for (unsigned int j = 0; j < m; ++j)
        x[k][j] -= A[i][k] * x[i][j];
  }
}

/** The equations for the 36 components on the quadrilateral (1,0), (0,1), (-p,0), (0,-q). Each
 * comes with 24 right-hand sides: moments and loads. */
class ReferenceEquations
{
public:
  static constexpr unsigned int n_equations = 40, n_sides = 24;
  /** Solution j has the components [i][j]. */
  using Solutions = std::array<std::array<double, n_sides>, CompositeCell::n_stresses>;

  ReferenceEquations(const double p, const double q)
    : matrix_(n_equations, CompositeCell::n_stresses)
    , sides_(n_equations, n_sides)
  {
    corners_[0][0] = 1.;
    corners_[1][1] = 1.;
    corners_[2][0] = -p;
    corners_[3][1] = -q;
    for (unsigned int k = 0; k < 4; ++k)
    {
      join(k);
      load_edge(k);
      balance(k);
    }
  }
  /** The stresses for all right-hand sides. */
  Solutions solve() const
  {
    const dealii::Householder<double> householder(matrix_);
    Solutions solutions;
    dealii::Vector<double> side(n_equations), solution(CompositeCell::n_stresses);
    for (unsigned int j = 0; j < n_sides; ++j)
    {
      for (unsigned int i = 0; i < n_equations; ++i)
        side[i] = sides_(i, j);
      householder.least_squares(solution, side);
      for (unsigned int i = 0; i < CompositeCell::n_stresses; ++i)
        solutions[i][j] = solution[i];
    }
    return solutions;
  }
  /** The same by normal equations, several times faster and with an error of the square of the
   * condition number: for quadrilaterals that are not far from parallelograms. */
  Solutions solve_quickly() const
  {
    constexpr unsigned int n = CompositeCell::n_stresses;
    std::array<std::array<double, n>, n> L{};
    Solutions x{};
    for (unsigned int r = 0; r < n_equations; ++r)
    {
      std::array<unsigned int, n> columns;
      unsigned int n_columns = 0;
      for (unsigned int i = 0; i < n; ++i)
        if (matrix_(r, i) != 0.)
          columns[n_columns++] = i;
      for (unsigned int a = 0; a < n_columns; ++a)
      {
        const unsigned int i = columns[a];
        for (unsigned int b = 0; b <= a; ++b)
          L[i][columns[b]] += matrix_(r, i) * matrix_(r, columns[b]);
        for (unsigned int j = 0; j < n_sides; ++j)
          x[i][j] += matrix_(r, i) * sides_(r, j);
      }
    }
    solve_by_cholesky(L, x);
    return x;
  }

private:
  /** matrix(row + c, .) += factor (tau nu)_c at vertex v of triangle k. */
  void add_traction(const unsigned int row,
                    const unsigned int k,
                    const unsigned int v,
                    const Vector2 &nu,
                    const double factor)
  {
    for (unsigned int m = 0; m < 3; ++m)
      add_product(row, 9 * k + 3 * m, nu, m == v ? -factor : factor);
  }
  /** matrix(row + c, .) += factor (s nu)_c with the components of s from @p column on. */
  void add_product(const unsigned int row,
                   const unsigned int column,
                   const Vector2 &nu,
                   const double factor)
  {
    matrix_(row, column) += factor * nu[0];
    matrix_(row, column + 2) += factor * nu[1];
    matrix_(row + 1, column + 1) += factor * nu[1];
    matrix_(row + 1, column + 2) += factor * nu[0];
  }
  /** Tractions are continuous between triangles k - 1 and k. */
  void join(const unsigned int k)
  {
    const unsigned int before = (k + 3) % 4;
    const Vector2 nu = scaled_normal(corners_[k]);
    add_traction(n_rows_, k, 0, nu, 1.);
    add_traction(n_rows_, before, 1, nu, -1.);
    add_traction(n_rows_ + 2, k, 2, nu, 1.);
    add_traction(n_rows_ + 2, before, 2, nu, -1.);
    n_rows_ += 4;
  }
  /** The moments on edge k: (2 t_a + t_b)/6 and (t_a + 2 t_b)/6 for the traction at its ends. */
  void load_edge(const unsigned int k)
  {
    const Vector2 nu = scaled_normal(corners_[(k + 1) % 4] - corners_[k]);
    for (unsigned int end = 0; end < 2; ++end)
    {
      add_traction(n_rows_, k, end, nu, 2. / 6.);
      add_traction(n_rows_, k, 1 - end, nu, 1. / 6.);
      for (unsigned int c = 0; c < 2; ++c)
        sides_(n_rows_ + c, 4 * k + 2 * end + c) = 1.;
      n_rows_ += 2;
    }
  }
  /** div tau + d_k = 0 on triangle k, with grad psi_m = -2 grad lambda_m. */
  void balance(const unsigned int k)
  {
    const std::array<Vector2, 3> x = {{corners_[k], corners_[(k + 1) % 4], Vector2()}};
    const double twice_area = cross(x[0], x[1]);
    for (unsigned int m = 0; m < 3; ++m)
      add_product(
        n_rows_, 9 * k + 3 * m, scaled_normal(x[(m + 2) % 3] - x[(m + 1) % 3]) / twice_area, 2.);
    for (unsigned int c = 0; c < 2; ++c)
      sides_(n_rows_ + c, CompositeCell::n_moments + 2 * k + c) = -1.;
    n_rows_ += 2;
  }

  std::array<Vector2, 4> corners_;
  dealii::FullMatrix<double> matrix_, sides_;
  unsigned int n_rows_ = 0;
};

/** F s F^T for F = (a1, a2). */
Components push_forward(const Components &s, const Vector2 &a1, const Vector2 &a2)
{
  Components result;
  result[0] = a1[0] * a1[0] * s[0] + a2[0] * a2[0] * s[1] + 2. * a1[0] * a2[0] * s[2];
  result[1] = a1[1] * a1[1] * s[0] + a2[1] * a2[1] * s[1] + 2. * a1[1] * a2[1] * s[2];
  result[2] = a1[0] * a1[1] * s[0] + a2[0] * a2[1] * s[1] + (a1[0] * a2[1] + a1[1] * a2[0]) * s[2];
  return result;
}
} // namespace

CellShape::CellShape(const std::array<dealii::Point<2>, 4> &corners)
  : corners(corners)
{
  const Vector2 first = corners[2] - corners[0], second = corners[3] - corners[1];
  const double t = cross(corners[1] - corners[0], second) / cross(first, second);
  const double s = cross(corners[1] - corners[0], first) / cross(first, second);
  crossing = corners[0] + t * first;
  p = (1. - t) / t;
  q = (1. - s) / s;
  for (unsigned int k = 0; k < 4; ++k)
    areas[k] = 0.5 * cross(corners[k] - crossing, corners[(k + 1) % 4] - crossing);
  const Vector2 difference = (corners[0] - corners[1]) + (corners[2] - corners[3]);
  affine = difference.norm() < 1e-12 * first.norm();
}

double CellShape::diameter() const
{
  double largest = 0.;
  for (const auto &a : corners)
    for (const auto &b : corners)
      largest = std::max(largest, a.distance(b));
  return largest;
}

dealii::Point<2> CellShape::centre(const unsigned int k) const
{
  return crossing + ((corners[k] - crossing) + (corners[(k + 1) % 4] - crossing)) / 3.;
}

dealii::Point<2> CellShape::centre() const
{
  dealii::Tensor<1, 2> sum;
  for (unsigned int k = 0; k < 4; ++k)
    sum += areas[k] / area() * (centre(k) - crossing);
  return crossing + sum;
}

CompositeCell::CompositeCell(const CellShape &shape)
{
  const bool quick =
    !shape.affine && std::min(shape.p, shape.q) > 0.25 && std::max(shape.p, shape.q) < 4.;
  const ReferenceEquations equations(shape.affine ? 1. : shape.p, shape.affine ? 1. : shape.q);
  const auto reference = quick ? equations.solve_quickly() : equations.solve();
  const Vector2 a1 = shape.corners[0] - shape.crossing, a2 = shape.corners[1] - shape.crossing;
  const double J = cross(a1, a2);
  // Pairs of columns belong to vectors: b' = F^{-1} b / det F and d' = F^{-1} d.
  for (unsigned int j = 0; j < n_moments + n_loads; j += 2)
  {
    const double scale = j < n_moments ? 1. / (J * J) : 1. / J;
    const std::array<Vector2, 2> inverse = {
      {scale * Vector2({a2[1], -a1[1]}), scale * Vector2({-a2[0], a1[0]})}};
    for (unsigned int c = 0; c < 2; ++c)
      for (unsigned int i = 0; i < n_stresses; i += 3)
      {
        Components s;
        for (unsigned int l = 0; l < 3; ++l)
          s[l] = inverse[c][0] * reference[i + l][j] + inverse[c][1] * reference[i + l][j + 1];
        s = push_forward(s, a1, a2);
        std::copy(s.begin(), s.end(), columns_[j + c].begin() + i);
      }
  }
}

CompositeCell::Stresses CompositeCell::stress(const CellMoments &moments) const
{
  Stresses result{};
  for (unsigned int j = 0; j < n_moments; ++j)
    for (unsigned int i = 0; i < n_stresses; ++i)
      result[i] += columns_[j][i] * moments[j];
  return result;
}

CompositeCell::Stresses CompositeCell::stress(const CellMoments &moments, const Loads &loads) const
{
  Stresses result = stress(moments);
  for (unsigned int j = 0; j < n_loads; ++j)
    for (unsigned int i = 0; i < n_stresses; ++i)
      result[i] += columns_[n_moments + j][i] * loads[j];
  return result;
}

CellMoments CompositeCell::transposed(const Stresses &values) const
{
  CellMoments result;
  for (unsigned int j = 0; j < n_moments; ++j)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < n_stresses; ++i)
      sum += columns_[j][i] * values[i];
    result[j] = sum;
  }
  return result;
}
} // namespace Signorini
