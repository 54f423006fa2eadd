// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem and its parts for other programs.

#include <signorini/results/files/matrix_market.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace Signorini
{
void write_symmetric_matrix_market(std::ostream &stream, const FullMatrix<double> &matrix)
{
  stream << "%%MatrixMarket matrix array real symmetric\n"
         << matrix.m() << " " << matrix.n() << "\n"
         << std::setprecision(17);
  for (unsigned int j = 0; j < matrix.n(); ++j)
    for (unsigned int i = j; i < matrix.m(); ++i)
      stream << matrix(i, j) << "\n";
}

void write_matrix_market(std::ostream &stream, const FullMatrix<double> &matrix)
{
  stream << "%%MatrixMarket matrix array real general\n"
         << matrix.m() << " " << matrix.n() << "\n"
         << std::setprecision(17);
  for (unsigned int j = 0; j < matrix.n(); ++j)
    for (unsigned int i = 0; i < matrix.m(); ++i)
      stream << matrix(i, j) << "\n";
}

std::string lower_triangle(const TrilinosWrappers::SparseMatrix &matrix, const double factor)
{
  std::ostringstream lines;
  lines << std::setprecision(17);
  const auto [first, end] = matrix.local_range();
  for (auto row = first; row < end; ++row)
    for (auto entry = matrix.begin(row); entry != matrix.end(row); ++entry)
      if (entry->column() <= row && entry->value() != 0.)
        lines << row + 1 << " " << entry->column() + 1 << " " << factor * entry->value() << "\n";
  return lines.str();
}

void write_symmetric_matrix_market(std::ostream &stream,
                                   const types::global_dof_index n,
                                   const std::vector<std::string> &parts)
{
  std::ptrdiff_t n_entries = 0;
  for (const std::string &part : parts)
    n_entries += std::count(part.begin(), part.end(), '\n');
  stream << "%%MatrixMarket matrix coordinate real symmetric\n"
         << n << " " << n << " " << n_entries << "\n";
  for (const std::string &part : parts)
    stream << part;
}

void write_matrix_market(std::ostream &stream, const dealii::Vector<double> &vector)
{
  stream << "%%MatrixMarket matrix array real general\n"
         << vector.size() << " 1\n"
         << std::setprecision(17);
  for (const double entry : vector)
    stream << entry << "\n";
}

void write_matrix_market(std::ostream &stream,
                         const Coupling &D,
                         const types::global_dof_index n_rows)
{
  std::size_t n_entries = 0;
  for (unsigned int tau = 0; tau < D.n_columns(); ++tau)
    n_entries += D.column(tau).size();
  stream << "%%MatrixMarket matrix coordinate real general\n"
         << n_rows << " " << D.n_columns() << " " << n_entries << "\n"
         << std::setprecision(17);
  for (unsigned int tau = 0; tau < D.n_columns(); ++tau)
    for (const auto &entry : D.column(tau))
      stream << entry.first + 1 << " " << tau + 1 << " " << entry.second << "\n";
}
} // namespace Signorini
