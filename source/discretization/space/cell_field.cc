// SPDX-License-Identifier: LGPL-2.1-or-later
// Functions on a cell, evaluated by sums along one direction after the other.

#include <signorini/base/instantiate.h>
#include <signorini/base/instructions.h>
#include <signorini/discretization/space/cell_field.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>

#include <boost/container/small_vector.hpp>

#include <map>

namespace Signorini {
namespace {
/** The components of a vector, filled up to a size that registers have. */
template <int dim>
struct Padded {
  typedef double Vector __attribute__((vector_size(dim == 2 ? 16 : 32)));
};

/** Computes Σ_k A_qk v_k for k < n along one direction of an array, in which @p stride entries of
 * the directions before follow one another. */
template <typename Size, typename Vector>
SIGNORINI_INLINE inline void along(const Size n, const FullMatrix<double> &A, const Vector *v,
                                   const std::size_t stride, const std::size_t n_blocks,
                                   Vector *sums) {
  for (std::size_t block = 0; block < n_blocks; ++block, v += n * stride)
    for (std::size_t q = 0; q < A.m(); ++q) {
      const double *const a = &A(q, 0);
      for (std::size_t i = 0; i < stride; ++i) {
        Vector sum = a[0] * v[i];
        for (std::size_t k = 1; k < n; ++k)
          sum += a[k] * v[k * stride + i];
        *sums++ = sum;
      }
    }
}
} // namespace

LineTable make_line_table(const std::vector<Polynomials::Polynomial<double>> &basis,
                          const std::vector<double> &points) {
  LineTable table = {{points.size(), basis.size()}, {points.size(), basis.size()}};
  std::vector<double> value_and_derivative(2);
  for (unsigned int q = 0; q < points.size(); ++q)
    for (unsigned int i = 0; i < basis.size(); ++i) {
      basis[i].value(points[q], value_and_derivative);
      table.values(q, i) = value_and_derivative[0];
      table.derivatives(q, i) = value_and_derivative[1];
    }
  return table;
}

template <int dim>
void evaluate_products(const std::vector<Tensor<1, dim>> &nodal_values,
                       const std::array<const LineTable *, dim> &lines, FieldValues<dim> &result) {
  // The field, and its derivatives along the directions so far, one after the other.
  std::size_t size = nodal_values.size(), stride = 1;
  thread_local AlignedVector<typename Padded<dim>::Vector> fields, sums;
  fields.resize_fast(size);
  for (std::size_t i = 0; i < size; ++i)
    for (unsigned int c = 0; c < dim; ++c)
      fields[i][c] = nodal_values[i][c];
  for (unsigned int d = 0; d < dim; ++d) {
    const FullMatrix<double> &values = lines[d]->values;
    const std::size_t n_blocks = size / (values.n() * stride);
    const std::size_t new_size = n_blocks * values.m() * stride;
    sums.resize_fast((d + 2) * new_size);
    // Those along this direction first: it is that of the field.
    const auto sum = [&](const auto n) SIGNORINI_INLINE {
      along(n, lines[d]->derivatives, fields.data(), stride, n_blocks,
            sums.data() + (d + 1) * new_size);
      along(n, values, fields.data(), stride, (d + 1) * n_blocks, sums.data());
    };
    run(instructions_of_this_machine(), [&](auto) SIGNORINI_INLINE {
      // Sums of known length have no loop.
      if (values.n() == 3)
        sum(std::integral_constant<unsigned int, 3>());
      else if (values.n() == 2)
        sum(std::integral_constant<unsigned int, 2>());
      else
        sum(values.n());
    });
    fields.swap(sums);
    stride *= values.m();
    size = new_size;
  }
  result.values.resize(size);
  result.gradients.resize(size);
  for (std::size_t q = 0; q < size; ++q)
    for (unsigned int c = 0; c < dim; ++c) {
      result.values[q][c] = fields[q][c];
      for (unsigned int d = 0; d < dim; ++d)
        result.gradients[q][c][d] = fields[(d + 1) * size + q][c];
    }
}

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

Tensor<1, 2> CellField::value(const LineTable &x, const LineTable &y, const unsigned int q) const {
  Tensor<1, 2> value;
  for (unsigned int j = 0; j <= degree_; ++j)
    for (unsigned int i = 0; i <= degree_; ++i)
      value += x.values(q, i) * y.values(q, j) * values_[i + (degree_ + 1) * j];
  return value;
}

Tensor<2, 2> CellField::gradient(const LineTable &x, const LineTable &y,
                                 const unsigned int q) const {
  Tensor<2, 2> gradient;
  for (unsigned int j = 0; j <= degree_; ++j) {
    Tensor<1, 2> value, slope;
    for (unsigned int i = 0; i <= degree_; ++i) {
      const Tensor<1, 2> nodal = values_[i + (degree_ + 1) * j] - values_[0];
      value += x.values(q, i) * nodal;
      slope += x.derivatives(q, i) * nodal;
    }
    for (unsigned int c = 0; c < 2; ++c) {
      gradient[c][0] += y.values(q, j) * slope[c];
      gradient[c][1] += y.derivatives(q, j) * value[c];
    }
  }
  return gradient;
}

Tensor<1, 2> CellField::on_face(const unsigned int face, const double s) const {
  AssertIndexRange(face, 4);
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
  boost::container::small_vector<double, 50> nodal(element.n_dofs_per_cell());
  cell->get_dof_values(U, nodal.begin(), nodal.end());
  values_.resize(nodal.size() / 2);
  thread_local std::map<unsigned int, std::vector<unsigned int>> known;
  std::vector<unsigned int> &numbers = known[degree_];
  if (numbers.empty())
    numbers = FETools::hierarchic_to_lexicographic_numbering<2>(degree_);
  for (unsigned int i = 0; i < nodal.size(); ++i) {
    const auto [component, node] = element.system_to_component_index(i);
    values_[numbers[node]][component] = nodal[i];
  }
}

TabulatedRule::TabulatedRule(Quadrature<2> rule)
  : rule_(std::move(rule)) {
  if (rule_.is_tensor_product()) {
    for (unsigned int d = 0; d < 2; ++d)
      for (const Point<1> &x : rule_.get_tensor_basis()[d].get_points())
        coordinates_[d].push_back(x[0]);
    return;
  }
  for (const Point<2> &x : rule_.get_points())
    for (unsigned int d = 0; d < 2; ++d)
      coordinates_[d].push_back(x[d]);
}

FieldValues<2> TabulatedRule::evaluate(const CellField &field) {
  auto &[x, y] = lines_[field.degree()];
  if (x.values.empty()) {
    x = make_line_table(field.degree(), coordinates_[0]);
    y = make_line_table(field.degree(), coordinates_[1]);
  }
  if (rule_.is_tensor_product())
    return field.evaluate(x, y);
  FieldValues<2> result;
  for (unsigned int q = 0; q < rule_.size(); ++q) {
    result.values.push_back(field.value(x, y, q));
    result.gradients.push_back(field.gradient(x, y, q));
  }
  return result;
}

INSTANTIATE_FUNCTION(evaluate_products);
} // namespace Signorini
