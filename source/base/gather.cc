// SPDX-License-Identifier: LGPL-2.1-or-later
// Texts of all ranks for the one that writes files.

#include <signorini/base/exceptions.h>
#include <signorini/base/gather.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace Signorini
{
std::vector<std::string> gather_texts(std::string text, MPI_Comm communicator)
{
  const int rank = static_cast<int>(dealii::Utilities::MPI::this_mpi_process(communicator));
  const int n_ranks = static_cast<int>(dealii::Utilities::MPI::n_mpi_processes(communicator));
  const auto sizes = dealii::Utilities::MPI::all_gather(communicator, text.size());
  if (*std::max_element(sizes.begin(), sizes.end()) > std::numeric_limits<int>::max())
    throw ComputationError("A rank's part of a file has more than 2 GiB; more ranks, 'VTU = "
                           "none' or 'Compliance = false' avoid that.");
  const auto size = [&](const int r) { return static_cast<int>(sizes[static_cast<unsigned>(r)]); };
  if (rank != 0)
  {
    MPI_Send(text.data(), size(rank), MPI_CHAR, 0, 0, communicator);
    return {};
  }
  std::vector<std::string> texts = {std::move(text)};
  for (int r = 1; r < n_ranks; ++r)
  {
    texts.emplace_back(sizes[static_cast<unsigned>(r)], ' ');
    MPI_Recv(texts.back().data(), size(r), MPI_CHAR, r, 0, communicator, MPI_STATUS_IGNORE);
  }
  return texts;
}
} // namespace Signorini
