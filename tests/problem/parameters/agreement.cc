// SPDX-License-Identifier: LGPL-2.1-or-later
// What one rank throws, every rank throws: the same kind of error with the same message.

#include <signorini/base/errors.h>

#include <deal.II/base/mpi.h>

#include "tests.h"

using namespace Signorini;

namespace
{
/** The last rank alone throws. */
template <typename Exception>
void fail_on_last_rank(Checks &checks, const std::string &name)
{
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  checks.throws<Exception>(name, "the disk of the last rank is full", [&]() {
    agree(MPI_COMM_WORLD, [&]() {
      if (rank + 1 == n_ranks)
        throw Exception("the disk of the last rank is full");
    });
  });
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);
  bool done = false;
  agree(MPI_COMM_WORLD, [&]() { done = true; });
  checks.that("work without errors", done);
  fail_on_last_rank<InputError>(checks, "wrong input");
  fail_on_last_rank<ComputationError>(checks, "a computation that fails");
  fail_on_last_rank<std::runtime_error>(checks, "another error");
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  checks.that("no rank", list_ranks(MPI_COMM_WORLD, false).empty());
  checks.that("all but the first rank",
              list_ranks(MPI_COMM_WORLD, rank > 0) == (n_ranks == 1 ? "" : "rank 1"));
  return checks.exit_code();
}
