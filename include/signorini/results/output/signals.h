// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace Signorini {
/** The end of the program on a signal. Long runs are killed often, by a user or a queue, and a half
 * written file must not look like a result. A signal handler takes no arguments, so it needs the
 * global variables of signals.cc. */

/** Makes a path known as that of an unfinished file as long as the object lives. */
class UnfinishedFile {
public:
  explicit UnfinishedFile(const std::filesystem::path &path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile &) = delete;
  UnfinishedFile &operator=(const UnfinishedFile &) = delete;
};

/**
 * Returns which of SIGINT, SIGTERM, SIGHUP and SIGQUIT end the process, and are not ignored
 * (nohup). Call it before MPI starts, since PETSc, which deal.II starts with it, takes some of
 * them.
 */
std::vector<int> ending_signals();

/**
 * Installs handlers: from here on the @p ending signals print the sentence of
 * describe_interruption(), remove the file that is being written, and end the process as they would
 * without a handler, also in the middle of a factorisation; the others of that list are ignored.
 * SIGPIPE does nothing: writing to a closed pipe is an error of the stream.
 */
void handle_signals(const std::vector<int> &ending);

/**
 * Stores @p where, one line, which is printed on stderr after "signorini:
 * interrupted by signal N ". Nothing is printed before the first call, or if @p where is empty.
 */
void describe_interruption(const std::string &where);

/**
 * Replaces a closed stdin, stdout or stderr by one that fails: otherwise the next file that is
 * opened would take its number and receive the output. Writing beyond the limit of `ulimit -f`
 * becomes an error of the stream, too. Call it first of all.
 */
void make_standard_streams_safe();
} // namespace Signorini
