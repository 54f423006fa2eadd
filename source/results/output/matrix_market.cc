// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem and its parts for other programs.

#include <signorini/results/output/matrix_market.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace Signorini {
namespace {
/** Appends a number and the character behind it: the shortest digits that read back as the same
 * number. Streams take five times as long. */
template <typename Number>
void append(std::string &text, const Number number, const char behind) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text.append(digits.data(), end);
  text += behind;
}

void append_entry(std::string &lines, const types::global_dof_index row,
                  const types::global_dof_index column, const double value) {
  append(lines, row + 1, ' ');
  append(lines, column + 1, ' ');
  append(lines, value, '\n');
}

/** Writes the first two lines but for the number of entries. */
void write_head(std::ostream &stream, const std::string &format, const bool symmetric,
                const types::global_dof_index n_rows, const types::global_dof_index n_columns) {
  stream << "%%MatrixMarket matrix " << format << " real " << (symmetric ? "symmetric" : "general")
         << "\n"
         << n_rows << " " << n_columns;
}
} // namespace

void write_matrix_market(std::ostream &stream, const FullMatrix<double> &matrix,
                         const bool symmetric) {
  write_head(stream, "array", symmetric, matrix.m(), matrix.n());
  stream << "\n";
  for (std::size_t j = 0; j < matrix.n(); ++j) {
    std::string column;
    for (std::size_t i = symmetric ? j : 0; i < matrix.m(); ++i)
      append(column, matrix(i, j), '\n');
    stream << column;
  }
}

std::string lower_triangle(const TrilinosWrappers::SparseMatrix &matrix, const double factor) {
  std::string lines;
  // deal.II's iterators copy a row for each of its entries.
  const Epetra_CrsMatrix &A = matrix.trilinos_matrix();
  for (int row = 0; row < A.NumMyRows(); ++row) {
    int n_entries = 0;
    double *values = nullptr;
    int *columns = nullptr;
    A.ExtractMyRowView(row, n_entries, values, columns);
    for (int k = 0; k < n_entries; ++k)
      if (A.GCID64(columns[k]) <= A.GRID64(row) && values[k] != 0.)
        append_entry(lines, A.GRID64(row), A.GCID64(columns[k]), factor * values[k]);
  }
  return lines;
}

std::string entries_of(const Coupling &D) {
  std::string lines;
  for (unsigned int tau = 0; tau < D.n_columns(); ++tau)
    for (const auto &[row, value] : D.column(tau))
      append_entry(lines, row, tau, value);
  return lines;
}

void write_matrix_market(std::ostream &stream, const types::global_dof_index n_rows,
                         const types::global_dof_index n_columns, const std::string &entries,
                         const bool symmetric) {
  write_head(stream, "coordinate", symmetric, n_rows, n_columns);
  stream << " " << std::count(entries.begin(), entries.end(), '\n') << "\n" << entries;
}
} // namespace Signorini
