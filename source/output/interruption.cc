// SPDX-License-Identifier: LGPL-2.1-or-later
// How the program ends when it is told to.

#include <signorini/output/interruption.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace Signorini
{
namespace
{
constexpr int usually_ending[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

/** A line of a fixed size, since a signal handler must not allocate. */
class Line
{
public:
  void append(const char *const text, const std::size_t size)
  {
    const std::size_t n = std::min(size, characters_.size() - size_);
    std::memcpy(characters_.data() + size_, text, n);
    size_ += n;
  }

  void append(const char *const text)
  {
    append(text, std::strlen(text));
  }

  void append(const int number)
  {
    if (number >= 10)
      append(number / 10);
    const char digit = static_cast<char>('0' + number % 10);
    append(&digit, 1);
  }

  void append(const Line &other)
  {
    append(other.characters_.data(), other.size_);
  }

  bool is_empty() const
  {
    return size_ == 0;
  }

  void clear()
  {
    size_ = 0;
  }

  void print_to_stderr() const
  {
    // There is nobody left to tell if this fails.
    if (write(STDERR_FILENO, characters_.data(), size_) < 0)
      return;
  }

private:
  std::array<char, 512> characters_ = {};
  std::size_t size_ = 0;
};

/** Two, so that the one which the handler may be reading is never being written. */
std::array<Line, 2> descriptions;
std::atomic<const Line *> current_description = nullptr;
std::atomic<const char *> unfinished_file = nullptr;

extern "C" void end_by_signal(const int number)
{
  if (const char *const file = unfinished_file)
    unlink(file);
  const Line *const description = current_description;
  if (description != nullptr && !description->is_empty())
  {
    Line line;
    line.append(isatty(STDERR_FILENO) != 0 ? "\r\033[Ksignorini: " : "signorini: ");
    line.append("interrupted by signal ");
    line.append(number);
    line.append(" ");
    line.append(*description);
    line.append("\n");
    line.print_to_stderr();
  }
  // SA_RESETHAND: now this is the default action, which follows when the handler returns.
  raise(number);
}
} // namespace

std::vector<int> ending_signals()
{
  std::vector<int> ending;
  for (const int number : usually_ending)
  {
    struct sigaction action = {};
    sigaction(number, nullptr, &action);
    if (action.sa_handler != SIG_IGN)
      ending.push_back(number);
  }
  return ending;
}

void handle_signals(const std::vector<int> &ending)
{
  for (const int number : usually_ending)
  {
    const bool ends = std::find(ending.begin(), ending.end(), number) != ending.end();
    struct sigaction action = {};
    action.sa_handler = ends ? end_by_signal : SIG_IGN;
    action.sa_flags = ends ? static_cast<int>(SA_RESETHAND) : 0;
    sigaction(number, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN);
}

void describe_interruption(const std::string &where)
{
  Line &next = descriptions[current_description == descriptions.data() ? 1 : 0];
  next.clear();
  next.append(where.data(), std::min<std::size_t>(where.size(), 400));
  current_description = &next;
}

RemovedOnInterruption::RemovedOnInterruption(const std::filesystem::path &path)
  : path_(path.string())
{
  unfinished_file = path_.c_str();
}

RemovedOnInterruption::~RemovedOnInterruption()
{
  unfinished_file = nullptr;
}

void make_standard_streams_safe()
{
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0)
      // The lowest free number is taken; opened the wrong way round, it fails like a closed one.
      (void)open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  std::signal(SIGXFSZ, SIG_IGN);
}
} // namespace Signorini
