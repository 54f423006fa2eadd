// SPDX-License-Identifier: LGPL-2.1-or-later
// C and motions against a stiffness.

#include <signorini/qp/stiffened_compliance.h>

namespace Signorini
{
StiffenedCompliance::StiffenedCompliance(std::shared_ptr<const ComplianceOperator> C,
                                         const Matrix &B,
                                         const SmallCholesky &Q)
  : C_(std::move(C))
  , V_(B.m(), B.n())
{
  Vector row(B.n());
  for (unsigned int i = 0; i < B.m(); ++i)
  {
    for (unsigned int j = 0; j < B.n(); ++j)
      row[j] = B(i, j);
    const Vector scaled = Q.forward(row);
    for (unsigned int j = 0; j < B.n(); ++j)
      V_(i, j) = scaled[j];
  }
}

double StiffenedCompliance::by_motion(const unsigned int i, const unsigned int j) const
{
  double sum = 0.;
  for (unsigned int l = 0; l < V_.n(); ++l)
    sum += V_(i, l) * V_(j, l);
  return sum;
}

unsigned int StiffenedCompliance::size() const
{
  return C_->size();
}

StiffenedCompliance::Vector StiffenedCompliance::apply(const Vector &P) const
{
  Vector product = C_->apply(P);
  product += times(V_, transpose_times(V_, P));
  return product;
}

StiffenedCompliance::Vector StiffenedCompliance::diagonal() const
{
  Vector diagonal = C_->diagonal();
  for (unsigned int i = 0; i < diagonal.size(); ++i)
    diagonal[i] += by_motion(i, i);
  return diagonal;
}

StiffenedCompliance::Matrix StiffenedCompliance::columns(const Indices &numbers) const
{
  Matrix columns = C_->columns(numbers);
  for (unsigned int i = 0; i < size(); ++i)
    for (unsigned int j = 0; j < numbers.size(); ++j)
      columns(i, j) += by_motion(i, numbers[j]);
  return columns;
}

const StiffenedCompliance::Matrix &StiffenedCompliance::dense() const
{
  if (dense_.m() == 0)
  {
    dense_ = C_->dense();
    for (unsigned int i = 0; i < size(); ++i)
      for (unsigned int j = 0; j < size(); ++j)
        dense_(i, j) += by_motion(i, j);
  }
  return dense_;
}

bool StiffenedCompliance::is_explicit() const
{
  return C_->is_explicit();
}
} // namespace Signorini
