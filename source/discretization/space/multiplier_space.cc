// SPDX-License-Identifier: LGPL-2.1-or-later
// Q^H, G of (22), and D of (22): the normal trace B tested with the basis of Q^H.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/discretization/space/trace_values.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <boost/serialization/map.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>

namespace Signorini {
template <int dim>
MultiplierSpace<dim>::MultiplierSpace(const ContactSurface<dim> &surface)
  : MultiplierSpace(surface, std::vector<unsigned int>(surface.patches().size(), 1)) {}

template <int dim>
MultiplierSpace<dim>::MultiplierSpace(const ContactSurface<dim> &surface,
                                      const std::vector<unsigned int> &n_nodes)
  : surface_(surface)
  , first_({0}) {
  AssertDimension(n_nodes.size(), surface.patches().size());
  for (unsigned int patch = 0; patch < n_nodes.size(); ++patch) {
    Assert(dim == 2 || n_nodes[patch] == 1, ExcNotImplemented());
    patch_of_.insert(patch_of_.end(), n_nodes[patch], patch);
    first_.push_back(patch_of_.size());
    while (rules_.size() < n_nodes[patch]) {
      rules_.emplace_back(rules_.size() + 1);
      bases_.push_back(Polynomials::generate_complete_Lagrange_basis(rules_.back().get_points()));
    }
  }
}

template <int dim>
Point<dim - 1> MultiplierSpace<dim>::node(const unsigned int unknown) const {
  AssertIndexRange(unknown, n_multipliers());
  const unsigned int patch = patch_of_[unknown];
  const Patch<dim> &interval = surface_.patches()[patch];
  const double t = rules_[n_of(patch) - 1].point(unknown - first_[patch])[0];
  return interval.lower + t * (interval.upper - interval.lower);
}

template <int dim>
unsigned int MultiplierSpace<dim>::nearest_node(const unsigned int patch,
                                                const Point<dim - 1> &s) const {
  AssertIndexRange(patch, surface_.patches().size());
  unsigned int nearest = first_[patch];
  for (unsigned int k = nearest; k < first_[patch + 1]; ++k)
    if (node(k).distance(s) < node(nearest).distance(s))
      nearest = k;
  return nearest;
}

template <int dim>
double MultiplierSpace<dim>::shape_value(const unsigned int unknown,
                                         const Point<dim - 1> &s) const {
  AssertIndexRange(unknown, n_multipliers());
  const unsigned int patch = patch_of_[unknown];
  const Patch<dim> &interval = surface_.patches()[patch];
  const double t = (s[0] - interval.lower[0]) / (interval.upper[0] - interval.lower[0]);
  return bases_[n_of(patch) - 1][unknown - first_[patch]].value(t);
}

template <int dim>
double MultiplierSpace<dim>::value(const Vector &P, const unsigned int patch,
                                   const Point<dim - 1> &s, const unsigned int component) const {
  AssertIndexRange(patch, surface_.patches().size());
  Assert((component + 1) * n_multipliers() <= P.size(),
         ExcDimensionMismatch(P.size(), (component + 1) * n_multipliers()));
  double sum = 0.;
  for (unsigned int k = first_of(patch); k < first_of(patch + 1); ++k)
    sum += P[component * n_multipliers() + k] * shape_value(k, s);
  return sum;
}

template <int dim>
dealii::Vector<double> MultiplierSpace<dim>::integrals() const {
  // The circumference has degree one on segments: there ∫ ψ_j ψ_k stays diagonal.
  if (surface_.scene().geometry.axisymmetric)
    return integrate_against_multipliers(
      *this, 3, Grading::none,
      [](const auto &, const auto &rule) { return std::vector<double>(rule.size(), 1.); });
  return lengths();
}

template <int dim>
dealii::Vector<double> MultiplierSpace<dim>::lengths() const {
  Vector integrals(n_multipliers());
  for (unsigned int k = 0; k < n_multipliers(); ++k) {
    const unsigned int patch = patch_of_[k];
    integrals[k] =
      surface_.patches()[patch].measure * rules_[n_of(patch) - 1].weight(k - first_[patch]);
  }
  return integrals;
}

template <int dim>
dealii::Vector<double> MultiplierSpace<dim>::project(const Vector &moments) const {
  AssertDimension(moments.size(), n_multipliers());
  // ∫ ψ_j ψ_k = δ_jk ∫ ψ_k: Gauss' rule integrates the product exactly.
  Vector coefficients = moments;
  const Vector squares = integrals();
  for (unsigned int k = 0; k < n_multipliers(); ++k)
    coefficients[k] /= squares[k];
  return coefficients;
}

template <>
Tensor<1, 2> direction_of(const Component component, const Tensor<1, 2> &m) {
  return component == Component::normal ? m : -cross_product_2d(m);
}

template <>
Tensor<1, 3> direction_of(const Component component, const Tensor<1, 3> &normal) {
  if (component == Component::normal)
    return normal;
  constexpr double nearly_parallel = 0.9;
  Tensor<1, 3> tangent;
  tangent[std::abs(normal[0]) > nearly_parallel ? 1 : 0] = 1.;
  tangent -= (tangent * normal) * normal;
  tangent /= tangent.norm();
  return component == Component::tangential ? tangent : cross_product_3d(normal, tangent);
}

template <int dim>
dealii::Vector<double> assemble_gap(const MultiplierSpace<dim> &space,
                                    const std::vector<ContactCondition<dim>> &contacts,
                                    const unsigned int n_points, const Grading grading,
                                    FunctionPointer<dim> ContactCondition<dim>::*const data,
                                    const Component component) {
  const auto gap_on = [&](const Piece<dim> &piece, const SurfaceRule<dim> &rule) {
    std::vector<double> g(rule.size());
    const auto &given = contacts[space.surface().patches()[piece.patch].contact].*data;
    if (given != nullptr && given->n_components == 1)
      given->value_list(rule.points, g);
    else if (given != nullptr)
      for (std::size_t q = 0; q < rule.size(); ++q)
        for (unsigned int d = 0; d < dim; ++d)
          g[q] += given->value(rule.points[q], d) * direction_of(component, rule.directions[q])[d];
    for (std::size_t q = 0; q < rule.size(); ++q)
      if (!std::isfinite(g[q])) {
        std::ostringstream message;
        message << "the gap has the value " << g[q] << " at (" << rule.points[q]
                << "), allowed: finite values on the whole side.";
        throw InputError(message.str());
      }
    return g;
  };
  // g contains u_n, which may have a fractional power at an end of contact.
  return integrate_against_multipliers(space, n_points, grading, gap_on);
}

template class MultiplierSpace<2>;
template class MultiplierSpace<3>;
INSTANTIATE_FUNCTION(assemble_gap);

void Coupling::add_product(const dealii::Vector<double> &P, DualVector &vector) const {
  AssertDimension(P.size(), n_columns());
  for (unsigned int tau = 0; tau < n_columns(); ++tau)
    if (P[tau] != 0.)
      for (const auto &entry : columns_[tau])
        vector(entry.first) += entry.second * P[tau];
}

template <typename VectorType>
dealii::Vector<double> Coupling::transpose_product(const VectorType &U) const {
  dealii::Vector<double> product(n_columns());
  for (unsigned int tau = 0; tau < n_columns(); ++tau)
    for (const auto &entry : columns_[tau])
      product[tau] += entry.second * U(entry.first);
  if constexpr (!std::is_same_v<VectorType, dealii::Vector<double>>)
    Utilities::MPI::sum(product, U.get_mpi_communicator(), product);
  return product;
}

template dealii::Vector<double> Coupling::transpose_product(const dealii::Vector<double> &) const;
template dealii::Vector<double> Coupling::transpose_product(const DualVector &) const;
template dealii::Vector<double> Coupling::transpose_product(const Displacement &) const;

std::optional<unsigned int> Coupling::empty_column(MPI_Comm communicator) const {
  std::vector<double> n_rows;
  for (const Column &column : columns_)
    n_rows.push_back(column.size());
  Utilities::MPI::sum(n_rows, communicator, n_rows);
  const auto empty = std::find(n_rows.begin(), n_rows.end(), 0.);
  if (empty == n_rows.end())
    return {};
  return empty - n_rows.begin();
}

template <int dim>
Coupling sum_columns(const DisplacementSpace<dim> &space, std::vector<Coupling::Column> parts) {
  if (!space.mesh().is_shared())
    return Coupling(std::move(parts));
  std::vector<Coupling::Column> columns(parts.size());
  for (const auto &of_rank : Utilities::MPI::all_gather(space.mesh().communicator(), parts))
    for (std::size_t k = 0; k < columns.size(); ++k)
      for (const auto &[row, value] : of_rank[k])
        if (space.locally_owned().is_element(row))
          columns[k][row] += value;
  return Coupling(std::move(columns));
}

template <int dim>
Coupling assemble_coupling(const DisplacementSpace<dim> &space,
                           const MultiplierSpace<dim> &multipliers, const Component component,
                           const std::array<double, 2> &share) {
  const ContactSurface<dim> &surface = multipliers.surface();
  const FEValuesExtractors::Vector displacement(0);
  TraceValues<dim> traces(space);
  std::vector<Coupling::Column> columns(multipliers.n_multipliers());
  for (const Piece<dim> &piece : surface.pieces()) {
    const SurfaceRule<dim> &rule = piece.on_mesh;
    const double measure = std::accumulate(rule.weights.begin(), rule.weights.end(), 0.);
    for (const auto &[face, points, sign] : surface.faces_at(piece, rule)) {
      const auto &values = traces.reinit(face, points);
      const auto indices = space.cell_dofs(face.cell);
      for (unsigned int k = multipliers.first_of(piece.patch);
           k < multipliers.first_of(piece.patch + 1); ++k)
        for (unsigned int j = 0; j < indices.size(); ++j) {
          double integral = 0.;
          for (std::size_t q = 0; q < rule.size(); ++q)
            integral += values[displacement].value(j, q) *
                        direction_of(component, rule.directions[q]) *
                        multipliers.shape_value(k, rule.on_side[q]) * rule.weights[q];
          if (std::abs(integral) > 1e-15 * measure)
            columns[k][indices[j]] += sign * share[sign > 0. ? 0 : 1] * integral;
        }
    }
  }
  return sum_columns(space, std::move(columns));
}

dealii::Vector<double> join(const dealii::Vector<double> &normal,
                            const dealii::Vector<double> &tangential) {
  dealii::Vector<double> both(normal);
  both.grow_or_shrink(normal.size() + tangential.size());
  std::copy(tangential.begin(), tangential.end(), both.begin() + normal.size());
  return both;
}

Coupling join(const Coupling &normal, const Coupling &tangential) {
  std::vector<Coupling::Column> columns;
  for (const Coupling *const D : {&normal, &tangential})
    for (unsigned int k = 0; k < D->n_columns(); ++k)
      columns.push_back(D->column(k));
  return Coupling(std::move(columns));
}

Coupling condense(const Coupling &D, const AffineConstraints<double> &constraints) {
  std::vector<Coupling::Column> columns(D.n_columns());
  for (unsigned int tau = 0; tau < D.n_columns(); ++tau)
    for (const auto &entry : D.column(tau)) {
      if (!constraints.is_constrained(entry.first))
        columns[tau][entry.first] += entry.second;
      else if (const auto *line = constraints.get_constraint_entries(entry.first))
        for (const auto &other : *line)
          columns[tau][other.first] += other.second * entry.second;
    }
  return Coupling(std::move(columns));
}

INSTANTIATE_FUNCTION(sum_columns);
INSTANTIATE_FUNCTION(assemble_coupling);
} // namespace Signorini
