// SPDX-License-Identifier: LGPL-2.1-or-later
// C by one solve per product.

#include <signorini/compliance/solved_compliance.h>

#include <deal.II/base/mpi.h>

#include <numeric>

namespace Signorini
{
SolvedCompliance::SolvedCompliance(const StiffnessInverse &inverse,
                                   const Coupling &condensed_D,
                                   Vector diagonal)
  : inverse_(inverse)
  , D_(condensed_D)
  , diagonal_(std::move(diagonal))
{
}

unsigned int SolvedCompliance::size() const
{
  return D_.n_columns();
}

SolvedCompliance::Vector SolvedCompliance::apply(const Vector &P) const
{
  if (P.size() == 0 || P.all_zero())
    return Vector(P.size());
  DistributedVector b = inverse_.make_vector(), x = inverse_.make_vector();
  D_.add_product(P, b);
  b.compress(dealii::VectorOperation::add);
  inverse_.solve(x, b);
  Vector product = D_.local_transpose_product(x);
  dealii::Utilities::MPI::sum(product, inverse_.communicator(), product);
  return product;
}

SolvedCompliance::Vector SolvedCompliance::diagonal() const
{
  return diagonal_;
}

SolvedCompliance::Matrix SolvedCompliance::columns(const Indices &numbers) const
{
  Matrix values(size(), numbers.size());
  Vector unit(size());
  for (unsigned int j = 0; j < numbers.size(); ++j)
  {
    unit = 0.;
    unit[numbers[j]] = 1.;
    const Vector column = apply(unit);
    for (unsigned int i = 0; i < size(); ++i)
      values(i, j) = column[i];
  }
  return values;
}

const SolvedCompliance::Matrix &SolvedCompliance::dense() const
{
  if (dense_.m() != size())
  {
    Indices all(size());
    std::iota(all.begin(), all.end(), 0);
    dense_ = columns(all);
  }
  return dense_;
}

bool SolvedCompliance::is_explicit() const
{
  return false;
}
} // namespace Signorini
