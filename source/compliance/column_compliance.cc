// SPDX-License-Identifier: LGPL-2.1-or-later
// C column by column, as far as it is needed.

#include <signorini/base/stage_timer.h>
#include <signorini/compliance/column_compliance.h>

#include <deal.II/base/mpi.h>

#include <numeric>

namespace Signorini
{
namespace
{
/** As many right-hand sides as are solved at once. */
constexpr std::size_t block_size = 32;
} // namespace

ColumnCompliance::ColumnCompliance(const StiffnessInverse &inverse,
                                   const Coupling &condensed_D,
                                   double &seconds,
                                   ColumnProgress progress)
  : inverse_(inverse)
  , D_(condensed_D)
  , seconds_(seconds)
  , progress_(std::move(progress))
  , C_(condensed_D.n_columns(), condensed_D.n_columns())
  , known_(condensed_D.n_columns(), false)
{
}

unsigned int ColumnCompliance::size() const
{
  return known_.size();
}

ComplianceOperator::Vector ColumnCompliance::apply(const Vector &P) const
{
  Indices pressing;
  for (unsigned int k = 0; k < size(); ++k)
    if (P[k] != 0.)
      pressing.push_back(k);
  require(pressing);
  Vector product(size());
  for (unsigned int i = 0; i < size(); ++i)
    for (const unsigned int k : pressing)
      product[i] += C_(i, k) * P[k];
  return product;
}

ComplianceOperator::Vector ColumnCompliance::diagonal() const
{
  require(all());
  Vector diagonal(size());
  for (unsigned int k = 0; k < size(); ++k)
    diagonal[k] = C_(k, k);
  return diagonal;
}

ComplianceOperator::Matrix ColumnCompliance::columns(const Indices &numbers) const
{
  require(numbers);
  Matrix columns(size(), numbers.size());
  for (unsigned int i = 0; i < size(); ++i)
    for (unsigned int j = 0; j < numbers.size(); ++j)
      columns(i, j) = C_(i, numbers[j]);
  return columns;
}

const ComplianceOperator::Matrix &ColumnCompliance::dense() const
{
  require(all());
  return C_;
}

bool ColumnCompliance::is_explicit() const
{
  return n_known_ == size();
}

ComplianceOperator::Indices ColumnCompliance::all() const
{
  Indices numbers(size());
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

ComplianceOperator::Matrix ColumnCompliance::solve_for(const Indices &numbers) const
{
  Matrix found(size(), numbers.size());
  dealii::Vector<double> unit(size());
  for (std::size_t first = 0; first < numbers.size(); first += block_size)
  {
    const std::size_t last = std::min(first + block_size, numbers.size());
    std::vector<DistributedVector> right_hand_sides, solutions;
    for (std::size_t j = first; j < last; ++j)
    {
      unit = 0.;
      unit[numbers[j]] = 1.;
      right_hand_sides.push_back(inverse_.make_vector());
      D_.add_product(unit, right_hand_sides.back());
      right_hand_sides.back().compress(dealii::VectorOperation::add);
      solutions.push_back(inverse_.make_vector());
    }
    inverse_.solve(solutions, right_hand_sides);
    for (std::size_t j = first; j < last; ++j)
    {
      const dealii::Vector<double> column = D_.local_transpose_product(solutions[j - first]);
      for (unsigned int i = 0; i < size(); ++i)
        found(i, j) = column[i];
    }
    if (progress_)
      progress_(n_known_ + last);
  }
  dealii::Utilities::MPI::sum(found, inverse_.communicator(), found);
  return found;
}

void ColumnCompliance::require(const Indices &numbers) const
{
  Indices missing;
  for (const unsigned int k : numbers)
    if (!known_[k])
      missing.push_back(k);
  if (missing.empty())
    return;
  const StageTimer timer(seconds_);
  const Matrix found = solve_for(missing);
  for (unsigned int j = 0; j < missing.size(); ++j)
  {
    known_[missing[j]] = true;
    for (unsigned int i = 0; i < size(); ++i)
      C_(i, missing[j]) = found(i, j);
  }
  // Where both columns were computed now, the mean; elsewhere the row is the column.
  std::vector<bool> is_new(size(), false);
  for (const unsigned int k : missing)
    is_new[k] = true;
  for (const unsigned int k : missing)
    for (unsigned int i = 0; i < size(); ++i)
      if (!is_new[i])
        C_(k, i) = C_(i, k);
      else if (i < k)
        C_(k, i) = C_(i, k) = 0.5 * (C_(k, i) + C_(i, k));
  n_known_ += static_cast<unsigned int>(missing.size());
}
} // namespace Signorini
