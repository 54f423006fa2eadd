// SPDX-License-Identifier: LGPL-2.1-or-later
// Static condensation of the unknowns inside of single cells.

#include "cell_interiors.h"

#include <signorini/base/errors.h>

#include <Epetra_CrsMatrix.h>

#include <numeric>

namespace Signorini {
namespace {
/** The size below which groups are left to the sparse factorisation. */
constexpr int min_group_size = 8;
} // namespace

Rows::Rows(const TrilinosWrappers::SparseMatrix &A)
  : n(A.trilinos_matrix().NumMyRows()) {
  // With all rows on this rank the columns are numbered like the rows.
  Assert(A.trilinos_matrix().ColMap().SameAs(A.trilinos_matrix().RowMap()), ExcInternalError());
  const int error = A.trilinos_matrix().ExtractCrsDataPointers(start, column, value);
  AssertThrow(error == 0, ExcTrilinosError(error));
}

CellInteriors::CellInteriors(const Rows &A, const std::vector<bool> &kept)
  : rest_(A) {
  const std::vector<std::pair<int, int>> groups = find_groups(A, kept);
  numbers_.assign(A.n, 0);
  for (const auto &[first, size] : groups)
    std::fill_n(numbers_.begin() + first, size, -1);
  for (int i = 0; i < A.n; ++i)
    if (numbers_[i] == 0) {
      numbers_[i] = static_cast<int>(unknowns_.size());
      unknowns_.push_back(i);
    }
  if (groups.empty())
    return;
  copy_the_rest(A);
  groups_.reserve(groups.size());
  for (const auto &[first, size] : groups)
    eliminate(A, first, size);
}

std::vector<std::pair<int, int>> CellInteriors::find_groups(const Rows &A,
                                                            const std::vector<bool> &kept) const {
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
  for (int first = 0, next = 0; first < A.n; first = next) {
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

void CellInteriors::copy_the_rest(const Rows &A) {
  start_ = {0};
  for (const int i : unknowns_) {
    for (int entry = A.start[i]; entry < A.start[i + 1]; ++entry)
      if (numbers_[A.column[entry]] >= 0) {
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

void CellInteriors::eliminate(const Rows &A, const int first, const int size) {
  const int begin = A.start[first], n_others = A.start[first + 1] - begin - size;
  groups_.push_back({first,
                     size,
                     {},
                     LAPACKFullMatrix<double>(size, size),
                     LAPACKFullMatrix<double>(size, n_others)});
  Group &group = groups_.back();
  LAPACKFullMatrix<double> A_GG(size, size);
  // The rows of G have the same columns.
  int inside = 0;
  for (int entry = 0; entry < size + n_others; ++entry) {
    const int number = numbers_[A.column[begin + entry]];
    const int column = number < 0 ? inside++ : static_cast<int>(group.others.size());
    for (int i = 0; i < size; ++i)
      (number < 0 ? A_GG : group.W)(i, column) = A.value[A.start[first + i] + entry];
    if (number >= 0)
      group.others.push_back(number);
  }
  A_GG.set_property(LAPACKSupport::symmetric);
  try {
    A_GG.compute_cholesky_factorization();
  } catch (const LACExceptions::ExcSingular &) {
    throw ComputationError("The factorisation of the stiffness matrix failed: the matrix is "
                           "singular or not positive definite.");
  }
  for (int i = 0; i < size; ++i)
    for (int j = 0; j <= i; ++j)
      group.L(i, j) = A_GG(i, j);
  group.L.set_property(LAPACKSupport::lower_triangular);
  group.L.solve(group.W);
  LAPACKFullMatrix<double> product(n_others, n_others);
  group.W.Tmmult(product, group.W);
  for (int i = 0; i < n_others; ++i) {
    // Both are in increasing order.
    int entry = start_[group.others[i]];
    for (int j = 0; j < n_others; ++j) {
      while (column_[entry] != group.others[j])
        ++entry;
      value_[entry] -= product(std::max(i, j), std::min(i, j));
    }
  }
}

void CellInteriors::reduce(const double *const b, double *const rest) const {
  for (std::size_t i = 0; i < unknowns_.size(); ++i)
    rest[i] = b[unknowns_[i]];
  for (const Group &group : groups_) {
    dealii::Vector<double> b_G(b + group.first, b + group.first + group.size),
      change(group.others.size());
    group.L.solve(b_G);
    group.W.Tvmult(change, b_G);
    for (unsigned int i = 0; i < change.size(); ++i)
      rest[group.others[i]] -= change[i];
  }
}

void CellInteriors::expand(double *const x, const double *const rest) const {
  for (std::size_t i = 0; i < unknowns_.size(); ++i)
    x[unknowns_[i]] = rest[i];
  for (const Group &group : groups_) {
    dealii::Vector<double> x_G(x + group.first, x + group.first + group.size),
      x_R(group.others.size());
    group.L.solve(x_G);
    for (unsigned int i = 0; i < x_R.size(); ++i)
      x_R[i] = -rest[group.others[i]];
    group.W.vmult(x_G, x_R, true);
    group.L.solve(x_G, true);
    std::copy(x_G.begin(), x_G.end(), x + group.first);
  }
}
} // namespace Signorini
