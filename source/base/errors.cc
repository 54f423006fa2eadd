// SPDX-License-Identifier: LGPL-2.1-or-later
// Messages of errors on one line, and errors on one rank that become the same errors on all.

#include <signorini/base/dealii.h>
#include <signorini/base/errors.h>
#include <signorini/base/text.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <cctype>
#include <new>
#include <string>

namespace Signorini {
std::string one_line(std::string sentence) {
  std::replace_if(
    sentence.begin(), sentence.end(), [](const unsigned char c) { return std::iscntrl(c) != 0; },
    '?');
  return sentence;
}

namespace {
enum class Outcome {
  success,
  input_error,
  computation_error,
  writing_error,
  out_of_memory,
  other_error
};

[[noreturn]] void rethrow(const Outcome outcome, const std::string &message) {
  if (outcome == Outcome::input_error)
    throw InputError(message);
  if (outcome == Outcome::computation_error)
    throw ComputationError(message);
  if (outcome == Outcome::writing_error)
    throw WritingError(message);
  if (outcome == Outcome::out_of_memory)
    throw std::bad_alloc();
  throw std::runtime_error(message);
}
} // namespace

void agree(MPI_Comm communicator, const std::function<void()> &work) {
  if (Utilities::MPI::n_mpi_processes(communicator) == 1)
    return work();
  Outcome outcome = Outcome::success;
  std::string message;
  try {
    work();
  } catch (const std::exception &error) {
    message = error.what();
    outcome = Outcome::other_error;
    if (dynamic_cast<const InputError *>(&error) != nullptr)
      outcome = Outcome::input_error;
    if (dynamic_cast<const ComputationError *>(&error) != nullptr)
      outcome = Outcome::computation_error;
    if (dynamic_cast<const WritingError *>(&error) != nullptr)
      outcome = Outcome::writing_error;
    if (dynamic_cast<const std::bad_alloc *>(&error) != nullptr)
      outcome = Outcome::out_of_memory;
  }
  const auto outcomes =
    Utilities::MPI::all_gather(communicator, std::make_pair(static_cast<int>(outcome), message));
  for (const auto &other : outcomes)
    if (other.first != static_cast<int>(Outcome::success))
      rethrow(static_cast<Outcome>(other.first), other.second);
}

std::string list_ranks(MPI_Comm communicator, const bool condition) {
  const std::vector<int> all =
    Utilities::MPI::all_gather(communicator, static_cast<int>(condition));
  std::vector<std::string> ranks;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i] != 0)
      ranks.push_back(std::to_string(i));
  if (ranks.empty())
    return "";
  return (ranks.size() == 1 ? "rank " : "the ranks ") + join(ranks);
}
} // namespace Signorini
