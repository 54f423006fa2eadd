// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem and its parts for other programs.

#include <signorini/results/files/matrix_market.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace Signorini {
namespace {
/** Writes the first two lines but for the number of entries. */
void write_head(std::ostream &stream, const std::string &format, const bool symmetric,
                const types::global_dof_index n_rows, const types::global_dof_index n_columns) {
  stream << "%%MatrixMarket matrix " << format << " real " << (symmetric ? "symmetric" : "general")
         << "\n"
         << n_rows << " " << n_columns << std::setprecision(17);
}
} // namespace

void write_matrix_market(std::ostream &stream, const FullMatrix<double> &matrix,
                         const bool symmetric) {
  write_head(stream, "array", symmetric, matrix.m(), matrix.n());
  stream << "\n";
  for (std::size_t j = 0; j < matrix.n(); ++j)
    for (std::size_t i = symmetric ? j : 0; i < matrix.m(); ++i)
      stream << matrix(i, j) << "\n";
}

std::string lower_triangle(const TrilinosWrappers::SparseMatrix &matrix, const double factor) {
  std::ostringstream lines;
  lines << std::setprecision(17);
  // deal.II's iterators copy a row for each of its entries.
  const Epetra_CrsMatrix &A = matrix.trilinos_matrix();
  for (int row = 0; row < A.NumMyRows(); ++row) {
    int n_entries = 0;
    double *values = nullptr;
    int *columns = nullptr;
    A.ExtractMyRowView(row, n_entries, values, columns);
    for (int k = 0; k < n_entries; ++k)
      if (A.GCID64(columns[k]) <= A.GRID64(row) && values[k] != 0.)
        lines << A.GRID64(row) + 1 << " " << A.GCID64(columns[k]) + 1 << " " << factor * values[k]
              << "\n";
  }
  return lines.str();
}

std::string entries_of(const Coupling &D) {
  std::ostringstream lines;
  lines << std::setprecision(17);
  for (unsigned int tau = 0; tau < D.n_columns(); ++tau)
    for (const auto &[row, value] : D.column(tau))
      lines << row + 1 << " " << tau + 1 << " " << value << "\n";
  return lines.str();
}

void write_matrix_market(std::ostream &stream, const types::global_dof_index n_rows,
                         const types::global_dof_index n_columns, const std::string &entries,
                         const bool symmetric) {
  write_head(stream, "coordinate", symmetric, n_rows, n_columns);
  stream << " " << std::count(entries.begin(), entries.end(), '\n') << "\n" << entries;
}
} // namespace Signorini
