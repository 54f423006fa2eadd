// SPDX-License-Identifier: LGPL-2.1-or-later
// D of (22): the normal trace B tested with the basis of Q^H.

#include <signorini/elasticity/trace_values.h>
#include <signorini/multiplier/coupling.h>

#include <cmath>
#include <map>
#include <numeric>

namespace Signorini
{
namespace
{
/** A column while it is summed up. */
using Sums = std::map<dealii::types::global_dof_index, double>;

Coupling to_coupling(const std::vector<Sums> &sums)
{
  std::vector<Coupling::Column> columns;
  columns.reserve(sums.size());
  for (const Sums &column : sums)
    columns.emplace_back(column.begin(), column.end());
  return Coupling(std::move(columns));
}
} // namespace

Coupling::Coupling(std::vector<Column> columns)
  : columns_(std::move(columns))
{
}

void Coupling::add_product(const dealii::Vector<double> &P, DistributedVector &vector) const
{
  AssertDimension(P.size(), n_columns());
  for (unsigned int tau = 0; tau < n_columns(); ++tau)
    if (P[tau] != 0.)
      for (const auto &entry : columns_[tau])
        if (vector.in_local_range(entry.first))
          vector(entry.first) += entry.second * P[tau];
}

dealii::Vector<double> Coupling::transpose_product(const NodalVector &U) const
{
  dealii::Vector<double> product(n_columns());
  for (unsigned int tau = 0; tau < n_columns(); ++tau)
    for (const auto &entry : columns_[tau])
      product[tau] += entry.second * U[entry.first];
  return product;
}

dealii::Vector<double> Coupling::local_transpose_product(const DistributedVector &U) const
{
  dealii::Vector<double> product(n_columns());
  for (unsigned int tau = 0; tau < n_columns(); ++tau)
    for (const auto &entry : columns_[tau])
      if (U.in_local_range(entry.first))
        product[tau] += entry.second * U(entry.first);
  return product;
}

template <int dim>
Coupling assemble_coupling(const DisplacementSpace<dim> &space,
                           const MultiplierSpace<dim> &multipliers)
{
  const ContactSurface<dim> &surface = multipliers.surface();
  const dealii::FEValuesExtractors::Vector displacement(0);
  TraceValues<dim> traces(space);
  std::vector<Sums> columns(multipliers.n_multipliers());
  for (const Piece<dim> &piece : surface.pieces())
  {
    const ContactFace<dim> &face = surface.faces()[piece.face];
    const SurfaceRule<dim> &rule = piece.on_mesh;
    const auto &values = traces.reinit(face, rule.on_face);
    const auto indices = space.cell_dofs(face.cell);
    const double measure = std::accumulate(rule.weights.begin(), rule.weights.end(), 0.);
    const auto &unknowns = multipliers.unknowns_on(piece.patch);
    for (unsigned int k = 0; k < unknowns.size(); ++k)
      for (unsigned int j = 0; j < indices.size() && unknowns[k] != multipliers.no_unknown; ++j)
      {
        double integral = 0.;
        for (std::size_t q = 0; q < rule.size(); ++q)
          integral += values[displacement].value(j, q) * rule.normals[q] *
                      multipliers.shape_value(piece.patch, k, rule.on_side[q]) * rule.weights[q];
        if (std::abs(integral) > 1e-15 * measure)
          columns[unknowns[k]][indices[j]] += integral;
      }
  }
  return to_coupling(columns);
}

Coupling condense(const Coupling &D, const dealii::AffineConstraints<double> &constraints)
{
  std::vector<Sums> columns(D.n_columns());
  for (unsigned int tau = 0; tau < D.n_columns(); ++tau)
    for (const auto &entry : D.column(tau))
    {
      if (!constraints.is_constrained(entry.first))
        columns[tau][entry.first] += entry.second;
      else if (const auto *line = constraints.get_constraint_entries(entry.first))
        for (const auto &other : *line)
          columns[tau][other.first] += other.second * entry.second;
    }
  return to_coupling(columns);
}

template Coupling assemble_coupling(const DisplacementSpace<2> &, const MultiplierSpace<2> &);
template Coupling assemble_coupling(const DisplacementSpace<3> &, const MultiplierSpace<3> &);
} // namespace Signorini
