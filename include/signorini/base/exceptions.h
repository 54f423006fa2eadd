// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace Signorini
{
/** A sentence on one line: what would break the line or steer a terminal becomes a question mark.
 */
std::string one_line(std::string sentence);

/**
 * The input is wrong and the user can mend it: exit code 1.
 *
 * The message is one sentence that names the place (file and line, or command line option), the
 * parameter, what was found and what is allowed.
 */
class InputError : public std::runtime_error
{
public:
  explicit InputError(const std::string &sentence)
    : std::runtime_error(one_line(sentence))
  {
  }
};

/** The computation cannot reach what was asked for: exit code 2. The message names the cause. */
class ComputationError : public std::runtime_error
{
public:
  explicit ComputationError(const std::string &sentence)
    : std::runtime_error(one_line(sentence))
  {
  }
};

/** Results cannot be written: exit code 3. The message names the file. */
class WritingError : public ComputationError
{
  using ComputationError::ComputationError;
};
} // namespace Signorini
