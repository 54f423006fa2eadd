// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace Signorini
{
/*
 * How the program ends on a signal. Long runs are killed often, by a user or a queue, and a half
 * written file must not look like a result. A signal handler takes no arguments, so it needs global
 * variables: those of interruption.cc are the only ones of the program.
 */

/**
 * Which of SIGINT, SIGTERM, SIGHUP and SIGQUIT end the process, and are not ignored (nohup). To be
 * asked before MPI starts, since PETSc, which deal.II starts with it, takes some of them.
 */
std::vector<int> ending_signals();

/**
 * From here on the @p ending signals remove the file that is being written, print the sentence of
 * describe_interruption(), and end the process as they would without a handler, also in the middle
 * of a factorisation; the others of that list are ignored. SIGPIPE does nothing: writing to a
 * closed pipe is an error of the stream.
 */
void handle_signals(const std::vector<int> &ending);

/**
 * What is said on stderr after "signorini: interrupted by signal N ": @p where, one line of at most
 * 400 characters. Nothing is said before the first call, or if @p where is empty.
 */
void describe_interruption(const std::string &where);

/**
 * While an object of this class lives, a signal that ends the program removes its file. At most one
 * lives at a time.
 */
class RemovedOnInterruption
{
public:
  explicit RemovedOnInterruption(const std::filesystem::path &path);
  ~RemovedOnInterruption();
  RemovedOnInterruption(const RemovedOnInterruption &) = delete;
  RemovedOnInterruption &operator=(const RemovedOnInterruption &) = delete;

private:
  const std::string path_;
};

/**
 * A closed stdin, stdout or stderr becomes one that fails: otherwise the next file that is opened
 * would take its number and receive what is printed. Writing beyond the limit of `ulimit -f`
 * becomes an error of the stream, too. To be called first of all.
 */
void make_standard_streams_safe();
} // namespace Signorini
