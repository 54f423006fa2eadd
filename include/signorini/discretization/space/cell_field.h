// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/displacement_space.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace Signorini {
/** The values and gradients of a vector field at the quadrature points of a cell. */
template <int dim>
struct FieldValues {
  std::vector<Tensor<1, dim>> values;
  std::vector<Tensor<2, dim>> gradients;
};

/** The values and derivatives of one-dimensional polynomials at points, matrices points ×
 * polynomials.
 */
struct LineTable {
  FullMatrix<double> values, derivatives;
};

LineTable make_line_table(const std::vector<Polynomials::Polynomial<double>> &basis,
                          const std::vector<double> &points);

/** Tabulates Lagrange's polynomials at the nodes of an edge of the element FE_Q, those of Gauss and
 * Lobatto, at points between 0 and 1. */
LineTable make_line_table(unsigned int degree, const std::vector<double> &points);

/**
 * Evaluates a field at the points of a tensor product rule by sums over the nodes of one direction
 * after the other. With k + 1 nodes and q points per direction that takes in 3-D about 4 (k+1)³ q
 * operations where q < k, not 4 (k+1)³ q³.
 * @param nodal_values the coefficients of products of polynomials, the first direction running
 * fastest, like the points of the result.
 * @param lines the polynomials in each direction.
 * @param result values, and derivatives in these directions.
 */
template <int dim>
void evaluate_products(const std::vector<Tensor<1, dim>> &nodal_values,
                       const std::array<const LineTable *, dim> &lines, FieldValues<dim> &result);

/** The solution u_h on one cell, or the map of a cell, as products of polynomials in the two
 * reference coordinates. */
class CellField {
public:
  CellField(const DoFHandler<2>::active_cell_iterator &cell, const Displacement &U);
  /** A polynomial by its values at the nodes of an element of this degree, lexicographically. */
  CellField(const unsigned int degree, std::vector<Tensor<1, 2>> values)
    : degree_(degree)
    , values_(std::move(values)) {}

  unsigned int degree() const {
    return degree_;
  }
  /** Returns component c at node (i, j): node i along the first coordinate, j along the second. */
  double operator()(const unsigned int c, const unsigned int i, const unsigned int j) const {
    return values_[i + (degree_ + 1) * j][c];
  }
  /** Returns the value on a face of the cell, at s in [0,1] from its vertex 0 to its vertex 1. */
  Tensor<1, 2> on_face(unsigned int face, double s) const;
  /** Returns the values and the derivatives with respect to the reference coordinates of the cell
   * at the points (x_i, y_j), point i + n_x j; gradient [c][d] is that of component c with respect
   * to coordinate d. */
  FieldValues<2> evaluate(const LineTable &x, const LineTable &y) const {
    FieldValues<2> result;
    evaluate_products<2>(values_, {&x, &y}, result);
    return result;
  }
  /** Returns the value at the point (x_q, y_q). */
  Tensor<1, 2> value(const LineTable &x, const LineTable &y, unsigned int q) const;
  /** Returns the gradient at this point, from displacements relative to a corner: large
   * translations have rounding errors, but no strain. */
  Tensor<2, 2> gradient(const LineTable &x, const LineTable &y, unsigned int q) const;

private:
  unsigned int degree_;
  /** The nodal values, lexicographically. */
  std::vector<Tensor<1, 2>> values_;
};

/** Points of the reference cell, with the polynomials of several degrees at them. */
class TabulatedRule {
public:
  explicit TabulatedRule(Quadrature<2> rule);

  const Quadrature<2> &rule() const {
    return rule_;
  }
  /** Returns a field and its derivatives in reference coordinates at the points: where they are a
   * tensor product, by sums over the nodes of one direction after the other. */
  FieldValues<2> evaluate(const CellField &field);

private:
  Quadrature<2> rule_;
  /** The coordinates of the points along both directions, of a tensor product each one once. */
  std::array<std::vector<double>, 2> coordinates_;
  /** The tables at these coordinates by degree. */
  std::map<unsigned int, std::array<LineTable, 2>> lines_;
};
} // namespace Signorini
