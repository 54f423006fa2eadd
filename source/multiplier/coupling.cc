// SPDX-License-Identifier: LGPL-2.1-or-later
// D of (22): the normal trace B tested with the basis of Q^H.

#include <signorini/elasticity/integration.h>
#include <signorini/multiplier/coupling.h>

#include <map>

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
                           const std::vector<ContactFace<dim>> &faces,
                           const ContactPartition &partition)
{
  // phi_j.n dS is linear on a straight face and of degree two on one that is a parabola: two Gauss
  // points are exact.
  FaceValues<dim> face_values(space.mesh().mapping(),
                              space.element(),
                              2,
                              dealii::update_values | dealii::update_normal_vectors |
                                dealii::update_JxW_values);
  const dealii::FEValuesExtractors::Vector displacement(0);
  std::vector<Sums> columns(partition.patches.size());
  for (const Piece &piece : partition.pieces)
  {
    const ContactFace<dim> &face = faces[piece.face];
    const auto &values =
      face_values.reinit(face.cell, face.face_no, face.parameters_between(piece.start, piece.end));
    const auto indices = space.cell_dofs(face.cell);
    for (unsigned int j = 0; j < indices.size(); ++j)
    {
      double integral = 0.;
      for (const unsigned int q : values.quadrature_point_indices())
        integral += values[displacement].value(j, q) * values.normal_vector(q) * values.JxW(q);
      if (std::abs(integral) > 1e-15 * (piece.end - piece.start))
        columns[piece.patch][indices[j]] += integral;
    }
  }
  return to_coupling(columns);
}

template <int dim>
double normal_displacement(const DisplacementSpace<dim> &space,
                           const ContactFace<dim> &face,
                           const dealii::Tensor<1, dim> &normal,
                           const NodalVector &U,
                           const double s)
{
  const auto mesh_face = space.dof_cell(face.cell)->face(face.face_no);
  const double t = face.parameter(s);
  double u_n = 0.;
  for (unsigned int d = 0; d < dim; ++d)
    u_n += normal[d] * ((1. - t) * U[mesh_face->vertex_dof_index(0, d)] +
                        t * U[mesh_face->vertex_dof_index(1, d)]);
  return u_n;
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

template Coupling assemble_coupling(const DisplacementSpace<2> &,
                                    const std::vector<ContactFace<2>> &,
                                    const ContactPartition &);
template double normal_displacement(const DisplacementSpace<2> &,
                                    const ContactFace<2> &,
                                    const dealii::Tensor<1, 2> &,
                                    const NodalVector &,
                                    double);
} // namespace Signorini
