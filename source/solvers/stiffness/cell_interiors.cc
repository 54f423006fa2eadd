// SPDX-License-Identifier: LGPL-2.1-or-later
// Static condensation of the unknowns inside of single cells.

#include "cell_interiors.h"

#include <signorini/base/errors.h>

#include <deal.II/lac/lapack_templates.h>

#include <Epetra_CrsMatrix.h>

#include <numeric>

namespace Signorini
{
namespace
{
/** The size below which groups are left to the sparse factorisation. */
constexpr int min_group_size = 8;

constexpr int one = 1;
constexpr double plus = 1., minus = -1., nothing = 0.;
} // namespace

Rows::Rows(const TrilinosWrappers::SparseMatrix &A)
  : n(A.trilinos_matrix().NumMyRows())
{
  // With all rows on this rank the columns are numbered like the rows.
  Assert(A.trilinos_matrix().ColMap().SameAs(A.trilinos_matrix().RowMap()), ExcInternalError());
  const int error = A.trilinos_matrix().ExtractCrsDataPointers(start, column, value);
  AssertThrow(error == 0, ExcTrilinosError(error));
}

CellInteriors::CellInteriors(const Rows &A, const std::vector<bool> &kept)
  : rest_(A)
{
  const std::vector<std::pair<int, int>> groups = find_groups(A, kept);
  number_the_rest(A, groups);
  if (groups.empty())
    return;
  copy_the_rest(A);
  groups_.reserve(groups.size());
  for (const auto &[first, size] : groups)
    eliminate(A, first, size);
}

std::vector<std::pair<int, int>> CellInteriors::find_groups(const Rows &A,
                                                            const std::vector<bool> &kept) const
{
  std::vector<std::pair<int, int>> groups;
  std::vector<bool> eliminated(A.n, false);
  // What is eliminated adds entries for all pairs of the others, which must have a place in A.
  const auto is_inside_a_cell = [&](const int first, const int size) {
    const int *const begin = A.column + A.start[first], *const end = A.column + A.start[first + 1];
    return std::all_of(begin, end, [&](const int i) {
      return (i >= first && i < first + size) ||
             (!eliminated[i] &&
              std::includes(A.column + A.start[i], A.column + A.start[i + 1], begin, end));
    });
  };
  for (int first = 0, next = 0; first < A.n; first = next)
  {
    next = first + 1;
    if (kept[first] || A.start[next] - A.start[first] < min_group_size)
      continue;
    while (next < A.n && !kept[next] && A.same_pattern(first, next))
      ++next;
    // A cell alone is the whole body: something is left for the sparse factorisation.
    const bool has_others = A.start[first + 1] - A.start[first] > next - first;
    if (next - first < min_group_size || !has_others || !is_inside_a_cell(first, next - first))
      continue;
    groups.emplace_back(first, next - first);
    std::fill(eliminated.begin() + first, eliminated.begin() + next, true);
  }
  return groups;
}

void CellInteriors::number_the_rest(const Rows &A, const std::vector<std::pair<int, int>> &groups)
{
  numbers_.assign(A.n, 0);
  for (const auto &[first, size] : groups)
    std::fill(numbers_.begin() + first, numbers_.begin() + first + size, -1);
  for (int i = 0; i < A.n; ++i)
    if (numbers_[i] == 0)
    {
      numbers_[i] = static_cast<int>(unknowns_.size());
      unknowns_.push_back(i);
    }
}

void CellInteriors::copy_the_rest(const Rows &A)
{
  start_ = {0};
  for (const int i : unknowns_)
  {
    for (int entry = A.start[i]; entry < A.start[i + 1]; ++entry)
      if (numbers_[A.column[entry]] >= 0)
      {
        column_.push_back(numbers_[A.column[entry]]);
        value_.push_back(A.value[entry]);
      }
    start_.push_back(static_cast<int>(column_.size()));
  }
  rest_.n = static_cast<int>(unknowns_.size());
  rest_.start = start_.data();
  rest_.column = column_.data();
  rest_.value = value_.data();
}

void CellInteriors::eliminate(const Rows &A, const int first, const int size)
{
  Group group = {first, size, {}, std::vector<double>(size * size), {}};
  const int begin = A.start[first], n = A.start[first + 1] - begin;
  group.W.reserve(static_cast<std::size_t>(size) * (n - size));
  double *L = group.L.data();
  for (int entry = 0; entry < n; ++entry)
  {
    // The rows of G have the same columns: one column of A_GG or A_GR.
    const int number = numbers_[A.column[begin + entry]];
    for (int i = first; i < first + size; ++i)
      if (number < 0)
        *L++ = A.value[A.start[i] + entry];
      else
        group.W.push_back(A.value[A.start[i] + entry]);
    if (number >= 0)
      group.others.push_back(number);
  }
  std::vector<double> diagonal(size);
  for (int i = 0; i < size; ++i)
    diagonal[i] = group.L[i * (size + 1)];

  int info = 0;
  potrf("L", &size, group.L.data(), &size, &info);
  if (info != 0)
    throw ComputationError("The factorisation of the stiffness matrix failed: the matrix is "
                           "singular or not positive definite.");
  for (int i = 0; i < size; ++i)
  {
    const double L_ii = group.L[i * (size + 1)];
    min_pivot_ = std::min(min_pivot_, L_ii * L_ii / diagonal[i]);
  }
  const int n_others = static_cast<int>(group.others.size());
  trtrs("L", "N", "N", &size, &n_others, group.L.data(), &size, group.W.data(), &size, &info);
  AssertThrow(info == 0, ExcInternalError());
  subtract_from_rest(group);
  groups_.push_back(std::move(group));
}

void CellInteriors::subtract_from_rest(const Group &group)
{
  const int n = static_cast<int>(group.others.size());
  std::vector<double> product(n * n);
  syrk("L", "T", &n, &group.size, &plus, group.W.data(), &group.size, &nothing, product.data(), &n);
  for (int i = 0; i < n; ++i)
  {
    // Both are in increasing order.
    int entry = start_[group.others[i]];
    for (int j = 0; j < n; ++j)
    {
      while (column_[entry] != group.others[j])
        ++entry;
      value_[entry] -= product[std::max(i, j) + n * std::min(i, j)];
    }
  }
}

void CellInteriors::reduce(double *b, double *rest) const
{
  for (std::size_t i = 0; i < unknowns_.size(); ++i)
    rest[i] = b[unknowns_[i]];
  std::vector<double> change;
  int info = 0;
  for (const Group &group : groups_)
  {
    const int n = static_cast<int>(group.others.size());
    double *const b_G = b + group.first;
    trtrs("L", "N", "N", &group.size, &one, group.L.data(), &group.size, b_G, &group.size, &info);
    change.resize(n);
    gemv("T",
         &group.size,
         &n,
         &plus,
         group.W.data(),
         &group.size,
         b_G,
         &one,
         &nothing,
         change.data(),
         &one);
    for (int i = 0; i < n; ++i)
      rest[group.others[i]] -= change[i];
  }
}

void CellInteriors::expand(double *x, const double *rest) const
{
  for (std::size_t i = 0; i < unknowns_.size(); ++i)
    x[unknowns_[i]] = rest[i];
  std::vector<double> others;
  int info = 0;
  for (const Group &group : groups_)
  {
    const int n = static_cast<int>(group.others.size());
    double *const x_G = x + group.first;
    others.clear();
    for (const int i : group.others)
      others.push_back(rest[i]);
    gemv("N",
         &group.size,
         &n,
         &minus,
         group.W.data(),
         &group.size,
         others.data(),
         &one,
         &plus,
         x_G,
         &one);
    trtrs("L", "T", "N", &group.size, &one, group.L.data(), &group.size, x_G, &group.size, &info);
  }
}
} // namespace Signorini
