// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <functional>
#include <stdexcept>
#include <string>

namespace Signorini {
/** Returns the sentence with a question mark instead of every control character, which would break
 * the line or steer a terminal. */
std::string one_line(std::string sentence);

/**
 * Thrown if the input is wrong and the user can mend it: exit code 1.
 *
 * The message is one sentence that names the origin (file and line, or command line option), the
 * parameter, the value found and the values allowed.
 */
class InputError : public std::runtime_error {
public:
  explicit InputError(const std::string &sentence)
    : std::runtime_error(one_line(sentence)) {}
};

/** Thrown if a result cannot be computed: exit code 2. The message names the cause. */
class ComputationError : public std::runtime_error {
public:
  explicit ComputationError(const std::string &sentence)
    : std::runtime_error(one_line(sentence)) {}
};

/** Thrown if results cannot be written: exit code 3. The message names the file. */
class WritingError : public ComputationError {
  using ComputationError::ComputationError;
};

/**
 * Runs @p work, which must not communicate, and lets all ranks leave together: if it throws on one
 * of them, all throw. An InputError, ComputationError or WritingError keeps its type and its
 * message (that of the lowest rank that threw one), and std::bad_alloc its type; others become
 * std::runtime_error. Collective.
 */
void agree(MPI_Comm communicator, const std::function<void()> &work);

/** Returns "rank 1" or "the ranks 1, 3", the ranks on which @p condition holds; empty if there are
 * none. All ranks get the same result. Collective. */
std::string list_ranks(MPI_Comm communicator, bool condition);
} // namespace Signorini
