// SPDX-License-Identifier: LGPL-2.1-or-later
// π^{2h} of (30), and interpolations of higher degree on larger patches.

#include <signorini/discretization/space/patch_interpolation.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>

namespace Signorini {
namespace {
/** Returns the digits of a number, the lowest first: the position of a point in a grid. */
template <int dim>
std::array<unsigned int, dim> digits(unsigned int number, const unsigned int base) {
  std::array<unsigned int, dim> position;
  for (unsigned int &digit : position) {
    digit = number % base;
    number /= base;
  }
  return position;
}

/** Returns the number with these digits. */
template <int dim>
unsigned int lexicographic(const std::array<unsigned int, dim> &position, const unsigned int base) {
  unsigned int number = 0;
  for (unsigned int d = dim; d > 0; --d)
    number = base * number + position[d - 1];
  return number;
}

/** Returns the polynomials that belong to the nodes of elements of degree p on n intervals, which
 * fill [0, 1]. */
std::vector<Polynomials::Polynomial<double>> nodal_basis(const unsigned int degree,
                                                         const unsigned int n_cells) {
  return Polynomials::generate_complete_Lagrange_basis(
    QIterated<1>(QGaussLobatto<1>(degree + 1), n_cells).get_points());
}
} // namespace

template <int dim>
PatchInterpolation<dim>::PatchInterpolation(const DisplacementSpace<dim> &space,
                                            const Displacement &U,
                                            const Quadrature<dim> &usual_rule,
                                            const unsigned int n_generations)
  : space_(space)
  , U_(U)
  , n_generations_(n_generations)
  , n_cells_(1U << n_generations)
  , degree_(n_cells_ * space.element().degree)
  , polynomials_(nodal_basis(space.element().degree, n_cells_))
  , usual_points_(usual_rule.get_points())
  , ancestor_(space.dofs().end())
  , nodal_values_(polynomials_.n())
  , on_cell_(space.element().dofs_per_cell) {
  Assert(space.mesh().n_nested_ancestors() >= n_generations,
         ExcMessage("patch interpolation needs the levels before"));
  const unsigned int p = space.element().degree;
  if (space.mesh().has_bent_parents() && n_generations > 0 && p == 1)
    vertices_.resize(polynomials_.n());
  const auto numbers = FETools::hierarchic_to_lexicographic_numbering<dim>(p);
  for (unsigned int i = 0; i < on_cell_.size(); ++i) {
    const auto [component, node] = space.element().system_to_component_index(i);
    nodes_of_cell_.emplace_back(component,
                                lexicographic<dim>(digits<dim>(numbers[node], p + 1), degree_ + 1));
  }
  // In 2-D the sums over all nodes are short.
  if (dim == 2 || usual_rule.size() == 0 || !usual_rule.is_tensor_product())
    for (unsigned int i = 0; i < Utilities::pow(n_cells_, dim); ++i)
      tables_.push_back(make_table(usual_points_, digits<dim>(i, n_cells_)));
  else
    for (unsigned int c = 0; c < n_cells_; ++c) {
      std::vector<double> points;
      for (const Point<1> &x : usual_rule.get_tensor_basis()[0].get_points())
        points.push_back((x[0] + c) / n_cells_);
      lines_.push_back(make_line_table(nodal_basis(p, n_cells_), points));
      lines_.back().derivatives /= n_cells_;
    }
}

template <int dim>
typename PatchInterpolation<dim>::ShapeTable PatchInterpolation<dim>::make_table(
  const std::vector<Point<dim>> &points, const GridPosition &position) const {
  ShapeTable table;
  std::vector<double> values(polynomials_.n());
  std::vector<Tensor<1, dim>> gradients(polynomials_.n());
  // Second and third derivatives are not computed.
  std::vector<Tensor<2, dim>> second;
  std::vector<Tensor<3, dim>> third;
  std::vector<Tensor<4, dim>> fourth;
  for (const Point<dim> &point : points) {
    Point<dim> point_in_ancestor;
    for (unsigned int d = 0; d < dim; ++d)
      point_in_ancestor[d] = (point[d] + position[d]) / n_cells_;
    polynomials_.evaluate(point_in_ancestor, values, gradients, second, third, fourth);
    table.emplace_back();
    for (unsigned int k = 0; k < values.size(); ++k)
      if (values[k] != 0. || gradients[k].norm_square() != 0.)
        table.back().push_back({k, values[k], gradients[k] / n_cells_});
  }
  return table;
}

template <int dim>
void PatchInterpolation<dim>::read_values(const AncestorIterator &cell,
                                          const GridPosition &position) {
  for (unsigned int c = 0; c < cell->n_children(); ++c) {
    GridPosition child = digits<dim>(c, 2);
    for (unsigned int d = 0; d < dim; ++d)
      child[d] += 2 * position[d];
    read_values(cell->child(c), child);
  }
  if (cell->has_children())
    return;
  cell->get_dof_values(U_.entries(), on_cell_);
  const unsigned int first = space_.element().degree * lexicographic<dim>(position, degree_ + 1);
  for (unsigned int i = 0; i < on_cell_.size(); ++i)
    nodal_values_[first + nodes_of_cell_[i].second][nodes_of_cell_[i].first] = on_cell_[i];
  if (!vertices_.empty())
    for (const unsigned int v : cell->vertex_indices())
      vertices_[first + lexicographic<dim>(digits<dim>(v, 2), degree_ + 1)] = cell->vertex(v);
}

template <int dim>
typename PatchInterpolation<dim>::GridPosition
PatchInterpolation<dim>::collect_values(const CellIterator &cell) {
  AncestorIterator ancestor = cell;
  GridPosition position = {};
  for (unsigned int g = 0; g < n_generations_; ++g) {
    const auto parent = ancestor->parent();
    unsigned int c = 0;
    while (parent->child_index(c) != ancestor->index())
      ++c;
    for (unsigned int d = 0; d < dim; ++d)
      position[d] += digits<dim>(c, 2)[d] << g;
    ancestor = parent;
  }
  if (ancestor != ancestor_) {
    read_values(ancestor, GridPosition());
    ancestor_ = ancestor;
  }
  return position;
}

template <int dim>
void PatchInterpolation<dim>::evaluate(const std::vector<Tensor<1, dim>> &nodal_values,
                                       const GridPosition &position,
                                       const std::vector<Point<dim>> &points,
                                       FieldValues<dim> &result) {
  const bool is_usual = points == usual_points_;
  if (is_usual && !lines_.empty()) {
    std::array<const LineTable *, dim> lines;
    for (unsigned int d = 0; d < dim; ++d)
      lines[d] = &lines_[position[d]];
    evaluate_products<dim>(nodal_values, lines, result);
    return;
  }
  result.values.assign(points.size(), Tensor<1, dim>());
  result.gradients.assign(points.size(), Tensor<2, dim>());
  if (!is_usual)
    cut_table_ = make_table(points, position);
  const ShapeTable &shapes =
    is_usual ? tables_[lexicographic<dim>(position, n_cells_)] : cut_table_;
  for (unsigned int q = 0; q < points.size(); ++q)
    for (const Shape &shape : shapes[q]) {
      result.values[q] += shape.value * nodal_values[shape.node];
      result.gradients[q] += outer_product(nodal_values[shape.node], shape.gradient);
    }
}

template <int dim>
void PatchInterpolation<dim>::follow_ancestor(const CellIterator &cell,
                                              const std::vector<Point<dim>> &points) {
  for (unsigned int q = 0; q < points.size(); ++q) {
    Tensor<2, dim> of_cell;
    for (const unsigned int v : cell->vertex_indices())
      of_cell += outer_product(cell->vertex(v),
                               GeometryInfo<dim>::d_linear_shape_function_gradient(points[q], v));
    result_.gradients[q] = result_.gradients[q] * invert(map_.gradients[q]) * of_cell;
  }
}

template <int dim>
const FieldValues<dim> &PatchInterpolation<dim>::on_reference_cell(
  const CellIterator &cell, const std::vector<Point<dim>> &points) {
  const GridPosition position = collect_values(cell);
  evaluate(nodal_values_, position, points, result_);
  if (!vertices_.empty()) {
    evaluate(vertices_, position, points, map_);
    follow_ancestor(cell, points);
  }
  return result_;
}

template <int dim>
const FieldValues<dim> &PatchInterpolation<dim>::evaluate(const CellIterator &cell,
                                                          const FEValues<dim> &fe_values) {
  on_reference_cell(cell, fe_values.get_quadrature().get_points());
  // du_i/dx_j = Σ_k du_i/dxi_k dxi_k/dx_j
  for (const unsigned int q : fe_values.quadrature_point_indices())
    result_.gradients[q] = result_.gradients[q] * Tensor<2, dim>(fe_values.inverse_jacobian(q));
  return result_;
}

template class PatchInterpolation<2>;
template class PatchInterpolation<3>;
} // namespace Signorini
