// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem and its parts for other programs.

#include <signorini/results/files/matrix_market.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace Signorini
{
namespace
{
/** Writes a dense matrix of m x n entries, or its lower triangle if it is @p symmetric. */
template <typename Entry>
void write_array(std::ostream &stream,
                 const std::size_t m,
                 const std::size_t n,
                 const bool symmetric,
                 const Entry &entry)
{
  stream << "%%MatrixMarket matrix array real " << (symmetric ? "symmetric" : "general") << "\n"
         << m << " " << n << "\n"
         << std::setprecision(17);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = symmetric ? j : 0; i < m; ++i)
      stream << entry(i, j) << "\n";
}
} // namespace

void write_symmetric_matrix_market(std::ostream &stream, const FullMatrix<double> &matrix)
{
  write_array(stream, matrix.m(), matrix.n(), true, matrix);
}

void write_matrix_market(std::ostream &stream, const FullMatrix<double> &matrix)
{
  write_array(stream, matrix.m(), matrix.n(), false, matrix);
}

void write_matrix_market(std::ostream &stream, const dealii::Vector<double> &vector)
{
  write_array(
    stream, vector.size(), 1, false, [&](const std::size_t i, std::size_t) { return vector[i]; });
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
