// SPDX-License-Identifier: LGPL-2.1-or-later
// An error on one rank becomes an error on every rank: the same kind of error with the same
// message.

#include <signorini/base/errors.h>

#include <deal.II/base/mpi.h>

#include "tests.h"

using namespace Signorini;

namespace {
unsigned int rank() {
  return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
}

/** The last rank alone throws. */
template <typename Exception>
void fail_on_last_rank(Checks &checks) {
  checks.throws<Exception>("an error", "the disk of the last rank is full", [&]() {
    agree(MPI_COMM_WORLD, [&]() {
      if (rank() + 1 == dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD))
        throw Exception("the disk of the last rank is full");
    });
  });
}

void test_agreement(Checks &checks) {
  bool done = false;
  agree(MPI_COMM_WORLD, [&]() { done = true; });
  checks.that("work without errors", done);
  fail_on_last_rank<InputError>(checks);
  fail_on_last_rank<ComputationError>(checks);
  fail_on_last_rank<std::runtime_error>(checks);
  const bool alone = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
  checks.that("no rank", list_ranks(MPI_COMM_WORLD, false).empty());
  checks.that("all but the first rank",
              list_ranks(MPI_COMM_WORLD, rank() > 0) == (alone ? "" : "rank 1"));
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_agreement});
}
