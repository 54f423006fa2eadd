// SPDX-License-Identifier: LGPL-2.1-or-later
// π^{2h} of (30), and interpolations of higher degree on larger patches.

#include <signorini/postprocessing/fields/patch_interpolation.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>

namespace Signorini
{
namespace
{
/** Returns the number of a cell among the children of its parent. */
template <typename CellIterator>
unsigned int child_number(const CellIterator &parent, const int index)
{
  unsigned int c = 0;
  while (parent->child_index(c) != index)
    ++c;
  return c;
}

/** Returns coordinate d (0 or 1) of a child's place in its parent. */
unsigned int bit(const unsigned int number, const unsigned int d)
{
  return (number >> d) & 1U;
}
/** Returns the nodes of the element of degree p in one dimension, ascending from 0 to 1. */
std::vector<Point<1>> nodes_on_line(const unsigned int degree)
{
  std::vector<Point<1>> nodes = FE_Q<1>(degree).get_unit_support_points();
  std::sort(nodes.begin(), nodes.end(), [](const auto &a, const auto &b) { return a[0] < b[0]; });
  return nodes;
}

/** Returns these nodes on n cells next to each other, which fill [0, 1]. */
std::vector<Point<1>> nodes_on_line(const unsigned int degree, const unsigned int n_cells)
{
  std::vector<Point<1>> nodes = {Point<1>(0.)};
  const std::vector<Point<1>> on_cell = nodes_on_line(degree);
  for (unsigned int c = 0; c < n_cells; ++c)
    for (unsigned int i = 1; i < on_cell.size(); ++i)
      nodes.emplace_back((c + on_cell[i][0]) / n_cells);
  return nodes;
}

/** Returns for every node of an element the number of nodes before it in each direction. */
template <int dim>
std::vector<std::array<unsigned int, dim>> places_of_nodes(const FiniteElement<dim> &element)
{
  const std::vector<Point<1>> line = nodes_on_line(element.degree);
  std::vector<std::array<unsigned int, dim>> places;
  for (const Point<dim> &node : element.base_element(0).get_unit_support_points())
  {
    places.emplace_back();
    for (unsigned int d = 0; d < dim; ++d)
      places.back()[d] = static_cast<unsigned int>(std::count_if(
        line.begin(), line.end(), [&](const auto &x) { return x[0] < node[d] - 1e-10; }));
  }
  return places;
}
} // namespace

template <int dim>
PatchInterpolation<dim>::PatchInterpolation(const DisplacementSpace<dim> &space,
                                            const Quadrature<dim> &usual_rule,
                                            const unsigned int n_generations)
  : space_(space)
  , n_generations_(n_generations)
  , n_cells_(1U << n_generations)
  , degree_(n_cells_ * space.element().degree)
  , nodes_of_cell_(places_of_nodes(space.element()))
  , polynomials_(Polynomials::generate_complete_Lagrange_basis(
      nodes_on_line(space.element().degree, n_cells_)))
  , usual_points_(usual_rule.get_points())
  , ancestor_(space.dofs().end())
  , nodal_dofs_(polynomials_.n())
  , cell_dofs_(space.element().n_dofs_per_cell())
  , nodal_values_(polynomials_.n())
{
  Assert(space.mesh().n_nested_ancestors() >= n_generations,
         ExcMessage("patch interpolation needs the levels before"));
  if constexpr (dim == 3)
    if (usual_rule.size() > 0 && usual_rule.is_tensor_product())
      tensor_.emplace(Polynomials::generate_complete_Lagrange_basis(
                        nodes_on_line(space.element().degree, n_cells_)),
                      usual_rule.get_tensor_basis(),
                      n_cells_);
  if (!tensor_)
    make_tables();
}

template <int dim>
void PatchInterpolation<dim>::make_tables()
{
  const unsigned int n_places = Utilities::pow(n_cells_, dim);
  for (unsigned int i = 0; i < n_places; ++i)
  {
    Place place;
    for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= n_cells_)
      place[d] = rest % n_cells_;
    tables_.push_back(make_table(usual_points_, place));
  }
}

template <int dim>
unsigned int PatchInterpolation<dim>::lexicographic(const Place &place,
                                                    const unsigned int n_per_direction) const
{
  unsigned int index = 0;
  for (unsigned int d = dim; d > 0; --d)
    index = n_per_direction * index + place[d - 1];
  return index;
}

template <int dim>
typename PatchInterpolation<dim>::ShapeTable
PatchInterpolation<dim>::make_table(const std::vector<Point<dim>> &points, const Place &place) const
{
  ShapeTable table;
  std::vector<double> values(polynomials_.n());
  std::vector<Tensor<1, dim>> gradients(polynomials_.n());
  // Second and third derivatives are not computed.
  std::vector<Tensor<2, dim>> second;
  std::vector<Tensor<3, dim>> third;
  std::vector<Tensor<4, dim>> fourth;
  for (const Point<dim> &point : points)
  {
    Point<dim> point_in_ancestor;
    for (unsigned int d = 0; d < dim; ++d)
      point_in_ancestor[d] = (point[d] + place[d]) / n_cells_;
    polynomials_.evaluate(point_in_ancestor, values, gradients, second, third, fourth);
    table.values.insert(table.values.end(), values.begin(), values.end());
    for (const Tensor<1, dim> &gradient : gradients)
      table.gradients.push_back(gradient / n_cells_);
  }
  return table;
}

template <int dim>
const typename PatchInterpolation<dim>::ShapeTable &
PatchInterpolation<dim>::table(const Quadrature<dim> &quadrature,
                               const bool is_usual,
                               const Place &place)
{
  if (is_usual)
    return tables_[lexicographic(place, n_cells_)];
  cut_table_ = make_table(quadrature.get_points(), place);
  return cut_table_;
}

template <int dim>
void PatchInterpolation<dim>::find_nodes(const AncestorIterator &cell, const Place &place)
{
  if (cell->has_children())
  {
    for (unsigned int c = 0; c < cell->n_children(); ++c)
    {
      Place child;
      for (unsigned int d = 0; d < dim; ++d)
        child[d] = 2 * place[d] + bit(c, d);
      find_nodes(cell->child(c), child);
    }
    return;
  }
  CellIterator(cell)->get_dof_indices(cell_dofs_);
  for (unsigned int i = 0; i < cell_dofs_.size(); ++i)
  {
    const auto [component, number] = space_.element().system_to_component_index(i);
    Place node = nodes_of_cell_[number];
    for (unsigned int d = 0; d < dim; ++d)
      node[d] += space_.element().degree * place[d];
    nodal_dofs_[lexicographic(node, degree_ + 1)][component] = cell_dofs_[i];
  }
}

template <int dim>
typename PatchInterpolation<dim>::Place
PatchInterpolation<dim>::collect_values(const Displacement &U, const CellIterator &cell)
{
  AncestorIterator ancestor = cell;
  Place place = {};
  for (unsigned int g = 0; g < n_generations_; ++g)
  {
    const auto parent = ancestor->parent();
    const unsigned int c = child_number(parent, ancestor->index());
    for (unsigned int d = 0; d < dim; ++d)
      place[d] += bit(c, d) << g;
    ancestor = parent;
  }
  if (ancestor != ancestor_)
  {
    find_nodes(ancestor, Place());
    ancestor_ = ancestor;
  }
  for (unsigned int k = 0; k < nodal_dofs_.size(); ++k)
    for (unsigned int d = 0; d < dim; ++d)
      nodal_values_[k][d] = U[nodal_dofs_[k][d]];
  return place;
}

template <int dim>
const std::vector<Tensor<1, dim>> &PatchInterpolation<dim>::values(const Displacement &U,
                                                                   const CellIterator &cell)
{
  const Place place = collect_values(U, cell);
  if constexpr (dim == 3)
    if (tensor_)
    {
      tensor_->evaluate(nodal_values_, place, result_.values, result_.gradients);
      return result_.values;
    }
  const ShapeTable &shapes = tables_[lexicographic(place, n_cells_)];
  const unsigned int n_nodes = nodal_values_.size();
  result_.values.assign(usual_points_.size(), Tensor<1, dim>());
  for (unsigned int q = 0; q < usual_points_.size(); ++q)
    for (unsigned int k = 0; k < n_nodes; ++k)
      result_.values[q] += shapes.values[q * n_nodes + k] * nodal_values_[k];
  return result_.values;
}

template <int dim>
void PatchInterpolation<dim>::sum_up(const ShapeTable &shapes, const unsigned int n_points)
{
  const unsigned int n_nodes = nodal_values_.size();
  result_.values.assign(n_points, Tensor<1, dim>());
  result_.gradients.assign(n_points, Tensor<2, dim>());
  for (unsigned int q = 0; q < n_points; ++q)
    for (unsigned int k = 0; k < n_nodes; ++k)
    {
      result_.values[q] += shapes.values[q * n_nodes + k] * nodal_values_[k];
      result_.gradients[q] += outer_product(nodal_values_[k], shapes.gradients[q * n_nodes + k]);
    }
}

template <int dim>
const FieldValues<dim> &PatchInterpolation<dim>::evaluate(const Displacement &U,
                                                          const CellIterator &cell,
                                                          const FEValues<dim> &fe_values)
{
  const Place place = collect_values(U, cell);
  const Quadrature<dim> &rule = fe_values.get_quadrature();
  const bool is_usual = rule.get_points() == usual_points_;
  bool done = false;
  if constexpr (dim == 3)
    if (tensor_ && is_usual)
    {
      tensor_->evaluate(nodal_values_, place, result_.values, result_.gradients);
      done = true;
    }
  if (!done)
    sum_up(table(rule, is_usual, place), rule.size());
  // du_i/dx_j = Σ_k du_i/dxi_k dxi_k/dx_j
  for (unsigned int q = 0; q < rule.size(); ++q)
    result_.gradients[q] = result_.gradients[q] * Tensor<2, dim>(fe_values.inverse_jacobian(q));
  return result_;
}

template class PatchInterpolation<2>;
template class PatchInterpolation<3>;

// A displacement carried over to the next level.

namespace
{
/** 3^dim. */
template <int dim>
constexpr unsigned int n_next_nodes = dim == 2 ? 9 : 27;

/** Its vertices and the middles between them, lexicographically. */
template <int dim>
Quadrature<dim> next_nodes()
{
  std::vector<Point<dim>> points(n_next_nodes<dim>);
  for (unsigned int i = 0; i < points.size(); ++i)
    for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= 3)
      points[i][d] = 0.5 * (rest % 3);
  return Quadrature<dim>(points);
}

/** The place of vertex v of child c among these. */
template <int dim>
unsigned int place_of_vertex(const unsigned int child, const unsigned int vertex)
{
  unsigned int place = 0;
  for (unsigned int d = 0, power = 1; d < dim; ++d, power *= 3)
    place += power * (((child >> d) & 1U) + ((vertex >> d) & 1U));
  return place;
}
} // namespace

template <int dim>
CoarseDisplacement<dim>::CoarseDisplacement(const DisplacementSpace<dim> &space,
                                            const Displacement &U)
  : level_(space.mesh().level())
  , first_vertices_(space.mesh().triangulation().n_cells(level_))
  , values_(first_vertices_.size() * n_next_nodes<dim> * dim)
{
  PatchInterpolation<dim> interpolation(
    space, next_nodes<dim>(), space.mesh().has_parents() ? 1 : 0);
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    const auto number = static_cast<std::size_t>(cell->index());
    first_vertices_[number] = cell->vertex(0);
    const std::vector<Tensor<1, dim>> &values = interpolation.values(U, cell);
    for (unsigned int q = 0; q < n_next_nodes<dim>; ++q)
      for (unsigned int d = 0; d < dim; ++d)
        values_[(number * n_next_nodes<dim> + q) * dim + d] = static_cast<float>(values[q][d]);
  }
}

template <int dim>
Displacement CoarseDisplacement<dim>::at_nodes_of(const DisplacementSpace<dim> &space) const
{
  const auto &mesh = space.mesh().triangulation();
  if (space.mesh().level() != level_ + 1 || mesh.n_cells(level_) != first_vertices_.size())
    return {};
  Displacement U = space.zero();
  const double rounding = 1e-10 * space.mesh().size();
  for (const auto &parent : space.dofs().cell_iterators_on_level(level_))
  {
    const auto number = static_cast<std::size_t>(parent->index());
    if (parent->is_active() || parent->vertex(0).distance(first_vertices_[number]) > rounding)
      return {};
    for (unsigned int c = 0; c < parent->n_children(); ++c)
      for (const unsigned int v : parent->vertex_indices())
        for (unsigned int d = 0; d < dim; ++d)
          U[parent->child(c)->vertex_dof_index(v, d)] =
            values_[(number * n_next_nodes<dim> + place_of_vertex<dim>(c, v)) * dim + d];
  }
  U.update_ghost_values();
  return U;
}

template class CoarseDisplacement<2>;
template class CoarseDisplacement<3>;
} // namespace Signorini
