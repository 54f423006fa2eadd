// SPDX-License-Identifier: LGPL-2.1-or-later
// The end of the program on a signal.

#include <signorini/results/output/signals.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <fcntl.h>
#include <string_view>
#include <unistd.h>

namespace Signorini {
namespace {
/** The path of the file that is being written, for the handler of signals; null: none. */
std::string unfinished_path;
std::atomic<const char *> unfinished = nullptr;

constexpr int usually_ending[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

/** The texts of describe_interruption(): two, so that the one which the handler may be reading is
 * never being written. */
std::array<std::string, 2> descriptions;
std::atomic<const std::string *> current_description = nullptr;

extern "C" void end_by_signal(const int number) {
  if (const char *const path = unfinished)
    unlink(path);
  const std::string *const description = current_description;
  if (description != nullptr && !description->empty()) {
    // A signal handler may neither use streams nor make strings.
    const char digits[] = {static_cast<char>('0' + number / 10),
                           static_cast<char>('0' + number % 10)};
    const std::string_view two_digits(digits, 2);
    const std::string_view parts[] = {isatty(STDERR_FILENO) != 0 ? "\r\033[Ksignorini: "
                                                                 : "signorini: ",
                                      "interrupted by signal ",
                                      two_digits.substr(number < 10 ? 1 : 0),
                                      " ",
                                      *description,
                                      "\n"};
    for (const std::string_view part : parts)
      if (write(STDERR_FILENO, part.data(), part.size()) < 0)
        break;
  }
  // SA_RESETHAND: now this is the default action, which follows when the handler returns.
  raise(number);
}
} // namespace

UnfinishedFile::UnfinishedFile(const std::filesystem::path &path) {
  unfinished_path = path.string();
  unfinished = unfinished_path.c_str();
}

UnfinishedFile::~UnfinishedFile() {
  unfinished = nullptr;
}

std::vector<int> ending_signals() {
  std::vector<int> ending;
  for (const int number : usually_ending) {
    struct sigaction action = {};
    sigaction(number, nullptr, &action);
    if (action.sa_handler != SIG_IGN)
      ending.push_back(number);
  }
  return ending;
}

void handle_signals(const std::vector<int> &ending) {
  for (const int number : usually_ending) {
    const bool ends = std::find(ending.begin(), ending.end(), number) != ending.end();
    struct sigaction action = {};
    action.sa_handler = ends ? end_by_signal : SIG_IGN;
    action.sa_flags = ends ? static_cast<int>(SA_RESETHAND) : 0;
    sigaction(number, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN);
}

void describe_interruption(const std::string &where) {
  std::string &next = descriptions[current_description == descriptions.data() ? 1 : 0];
  next = where;
  current_description = &next;
}

void make_standard_streams_safe() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0)
      // The lowest free number is taken; opened the wrong way round, it fails like a closed one.
      (void)open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  std::signal(SIGXFSZ, SIG_IGN);
}
} // namespace Signorini
