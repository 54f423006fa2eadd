// SPDX-License-Identifier: LGPL-2.1-or-later
// Files appear complete or not at all.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/results/files/files.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <regex>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace Signorini
{
namespace
{
const std::string temporary_prefix = ".", temporary_suffix = ".part";
constexpr const char *trial_name = "trial";
constexpr const char *earlier_results = ".earlier-results";

/** Makes an empty file of this name; what had the name before, say a pipe or a link, is removed. */
bool make_new_file(const std::filesystem::path &path)
{
  unlink(path.c_str());
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  return descriptor >= 0 && close(descriptor) == 0;
}

/** Writes and flushes; returns whether every byte was written. The file is removed if @p write
 * throws for another reason. */
bool try_to_write(const std::filesystem::path &path,
                  const std::function<void(std::ostream &)> &write)
{
  if (!make_new_file(path))
    return false;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (!file)
    return false;
  try
  {
    write(file);
  }
  catch (...)
  {
    // deal.II's writers throw when the disk is full.
    if (!file)
      return false;
    file.close();
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    throw;
  }
  file.close();
  return !file.fail();
}

/** Returns whether something has this name, also a link that leads nowhere. */
bool is_taken_name(const std::filesystem::path &path)
{
  std::error_code error;
  return std::filesystem::exists(std::filesystem::symlink_status(path, error));
}

/** Makes the directory and those above it, as far as they are missing. A path may lead up again by
 * "..", so that not every directory on it is above the last. @return what was made, in this order.
 */
std::vector<std::filesystem::path> make_directories(const std::filesystem::path &directory)
{
  std::vector<std::filesystem::path> made;
  std::filesystem::path path;
  for (const std::filesystem::path &part : directory)
  {
    path /= part;
    if (mkdir(path.c_str(), 0777) == 0)
      made.push_back(path);
  }
  return made;
}

/** Returns whether a small file can be written into @p directory; it is removed again. */
bool is_writable(const std::filesystem::path &directory)
{
  const std::filesystem::path trial = temporary_name(directory / trial_name);
  const RemovedOnInterruption registered(trial);
  const bool written = try_to_write(trial, [](std::ostream &stream) { stream << "trial\n"; });
  std::error_code ignored;
  std::filesystem::remove(trial, ignored);
  return written;
}

/** Returns the name of the file that @p name is a part of; @p name itself if it is not temporary.
 */
std::string final_name(const std::string &name)
{
  const std::size_t extra = temporary_prefix.size() + temporary_suffix.size();
  const bool temporary =
    name.size() > extra && name.compare(0, temporary_prefix.size(), temporary_prefix) == 0 &&
    name.compare(
      name.size() - temporary_suffix.size(), temporary_suffix.size(), temporary_suffix) == 0;
  return temporary ? name.substr(temporary_prefix.size(), name.size() - extra) : name;
}

/** Returns the files of a directory whose names satisfy a test. */
std::vector<std::filesystem::path> find_files(const std::filesystem::path &directory,
                                              const NameTest &is_wanted)
{
  std::error_code error;
  std::vector<std::filesystem::path> found;
  for (const auto &entry : std::filesystem::directory_iterator(directory, error))
    if (!entry.is_directory(error) && is_wanted(entry.path().filename().string()))
      found.push_back(entry.path());
  return found;
}

/** Returns whether a file of the directory that the results replace is the file @p input, under any
 * name of it and through links. */
bool holds_as_result(const std::filesystem::path &directory,
                     const std::filesystem::path &input,
                     const NameTest &is_result)
{
  const auto found = find_files(directory, [&](const std::string &name) {
    return is_result(final_name(name)) || final_name(name) == trial_name;
  });
  return std::any_of(found.begin(), found.end(), [&](const std::filesystem::path &path) {
    std::error_code error;
    return std::filesystem::equivalent(path, input, error);
  });
}

[[noreturn]] void refuse_to_leave(const std::filesystem::path &path, const std::error_code &error)
{
  throw WritingError("The file '" + shorten_path(path.string()) +
                     "' of an earlier run could not be removed: " + error.message() + ".");
}
} // namespace

ResultsDirectory::ResultsDirectory(const std::filesystem::path &path,
                                   const std::vector<std::filesystem::path> &inputs,
                                   const NameTest &is_result)
  : path_(path)
{
  const std::string found = "--output: found '" + shorten_path(path_.string()) + "', ";
  std::error_code error;
  if (is_taken_name(path_) && !std::filesystem::exists(path_, error))
    throw InputError(found +
                     "a symbolic link that leads nowhere, allowed: a directory that can be made "
                     "and written to.");
  made_ = make_directories(path_);
  const std::string objection = lock(inputs, is_result);
  if (objection.empty())
    return;
  unlock();
  remove_if_empty();
  throw InputError(found + objection);
}

ResultsDirectory::~ResultsDirectory()
{
  unlock();
}

std::string ResultsDirectory::lock(const std::vector<std::filesystem::path> &inputs,
                                   const NameTest &is_result)
{
  const std::string allowed = "allowed: a directory that can be made and written to.";
  std::error_code error;
  if (!std::filesystem::is_directory(path_, error))
    return allowed;
  // The kernel releases the lock when the process ends, however that happens.
  descriptor_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    return "into which another run is writing, allowed: a directory of its own.";
  for (const std::filesystem::path &input : inputs)
    if (holds_as_result(path_, input, is_result) ||
        holds_as_result(path_ / earlier_results, input, is_result))
      return "where the file " + quote(shorten_path(input.string())) +
             ", which the run reads, would be overwritten by the results, allowed: another "
             "directory, or another name of this file.";
  return is_writable(path_) ? "" : allowed;
}

void ResultsDirectory::unlock()
{
  if (descriptor_ >= 0)
    close(descriptor_);
  descriptor_ = -1;
}

void ResultsDirectory::remove_if_empty() const
{
  // rmdir() removes neither a file nor a directory that is not empty.
  for (auto path = made_.rbegin(); path != made_.rend(); ++path)
    rmdir(path->c_str());
}

HeldDirectory::HeldDirectory(const std::filesystem::path &path)
  : path_(path)
  , descriptor_(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
}

HeldDirectory::~HeldDirectory()
{
  if (descriptor_ >= 0)
    close(descriptor_);
}

void HeldDirectory::check() const
{
  struct stat held = {}, present = {};
  if (descriptor_ < 0 || fstat(descriptor_, &held) != 0)
    return;
  if (stat(path_.c_str(), &present) != 0 || held.st_dev != present.st_dev ||
      held.st_ino != present.st_ino)
    throw WritingError("The directory '" + shorten_path(path_.string()) +
                       "' was removed or replaced while the run was writing into it: its "
                       "results are incomplete.");
}

bool is_name_of_result(const std::string &name)
{
  static const std::regex names(
    "convergence\\.(csv|md|tex)|answer\\.json|(solution|contact)\\.pvd|contact-[0-9]{2}\\.csv|"
    "(solution|contact)-[0-9]{2}\\.vtu|mesh-[0-9]{2}\\.svg|(pressure|deformed|convergence|travel)"
    "\\.svg|"
    "[ABCDFGKPbfq]-[0-9]{2}\\.mtx|cases\\.csv|contact-case-[0-9]{6}\\.csv|"
    "solution-case-[0-9]{6}\\.vtu");
  return std::regex_match(name, names) || name == parameters_name || name == certificate_name;
}

std::filesystem::path temporary_name(const std::filesystem::path &path)
{
  return path.parent_path() / (temporary_prefix + path.filename().string() + temporary_suffix);
}

void write_file(const std::filesystem::path &path, const std::function<void(std::ostream &)> &write)
{
  const std::filesystem::path temporary = temporary_name(path);
  const RemovedOnInterruption registered(temporary);
  std::error_code error;
  if (try_to_write(temporary, write))
  {
    std::filesystem::rename(temporary, path, error);
    if (!error)
      return;
  }
  std::filesystem::remove(temporary, error);
  throw WritingError("The file '" + shorten_path(path.string()) +
                     "' could not be written: the disk is full, or the directory has been "
                     "removed or write-protected.");
}

void remove_files(const std::filesystem::path &directory, const NameTest &is_removed)
{
  for (const std::filesystem::path &path :
       find_files(directory, [&](const std::string &name) { return is_removed(final_name(name)); }))
  {
    std::error_code error;
    std::filesystem::remove(path, error);
    if (error)
      refuse_to_leave(path, error);
  }
}

void set_results_aside(const std::filesystem::path &directory)
{
  const std::filesystem::path aside = directory / earlier_results;
  remove_files(aside, is_name_of_result);
  std::vector<std::filesystem::path> found = find_files(directory, is_name_of_result);
  // Without its results there must be no verdict: the certificate goes first.
  std::partition(found.begin(), found.end(), [](const std::filesystem::path &path) {
    return path.filename() == certificate_name;
  });
  if (!found.empty())
    mkdir(aside.c_str(), 0777);
  for (const std::filesystem::path &path : found)
  {
    std::error_code error;
    std::filesystem::rename(path, aside / path.filename(), error);
    if (error)
    {
      put_results_back(directory);
      refuse_to_leave(path, error);
    }
  }
}

void put_results_back(const std::filesystem::path &directory)
{
  const std::filesystem::path aside = directory / earlier_results;
  for (const std::filesystem::path &path : find_files(aside, is_name_of_result))
  {
    // What cannot be moved stays where it is.
    std::error_code ignored;
    std::filesystem::rename(path, directory / path.filename(), ignored);
  }
  rmdir(aside.c_str());
}

void remove_results_aside(const std::filesystem::path &directory)
{
  const std::filesystem::path aside = directory / earlier_results;
  remove_files(aside, is_name_of_result);
  rmdir(aside.c_str());
}

// The end of the program on a signal.

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
    // Nothing can be done if this fails.
    if (write(STDERR_FILENO, characters_.data(), size_) < 0)
      return;
  }

private:
  std::array<char, 512> characters_ = {};
  std::size_t size_ = 0;
};

/** The texts of describe_interruption(): two, so that the one which the handler may be reading is
 * never being written. */
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
