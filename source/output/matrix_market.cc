// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem for other programs: a real contact QP.

#include <signorini/output/matrix_market.h>

#include <iomanip>

namespace Signorini
{
void write_matrix_market(std::ostream &stream, const dealii::FullMatrix<double> &matrix)
{
  stream << "%%MatrixMarket matrix array real general\n"
         << matrix.m() << " " << matrix.n() << "\n"
         << std::setprecision(17);
  for (unsigned int j = 0; j < matrix.n(); ++j)
    for (unsigned int i = 0; i < matrix.m(); ++i)
      stream << matrix(i, j) << "\n";
}

void write_matrix_market(std::ostream &stream, const dealii::Vector<double> &vector)
{
  dealii::FullMatrix<double> column(vector.size(), 1);
  for (unsigned int i = 0; i < vector.size(); ++i)
    column(i, 0) = vector[i];
  write_matrix_market(stream, column);
}

void write_matrix_market(std::ostream &stream,
                         const Coupling &D,
                         const dealii::types::global_dof_index n_rows)
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
