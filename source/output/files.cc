// SPDX-License-Identifier: LGPL-2.1-or-later
// Files appear complete or not at all.

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>
#include <signorini/output/files.h>
#include <signorini/output/interruption.h>

#include <cerrno>
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

/** Makes an empty file of this name; what had the name before, say a pipe or a link, is removed. */
bool make_new_file(const std::filesystem::path &path)
{
  unlink(path.c_str());
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  return descriptor >= 0 && close(descriptor) == 0;
}

/** Writes and flushes; returns whether every byte was taken. Nothing is left if @p write throws for
 * another reason. */
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

/** Whether something has this name: a link that leads nowhere, too. */
bool is_taken_name(const std::filesystem::path &path)
{
  std::error_code error;
  return std::filesystem::exists(std::filesystem::symlink_status(path, error));
}

/** The outermost of the directories above and including @p directory that is not there. */
std::filesystem::path outermost_missing(const std::filesystem::path &directory)
{
  std::filesystem::path missing;
  for (std::filesystem::path path = directory; !path.empty() && !is_taken_name(path);
       path = path.parent_path())
    missing = path;
  return missing;
}

/** Whether a small file can be written into @p directory; it is removed again. */
bool is_writable(const std::filesystem::path &directory)
{
  const std::filesystem::path trial = temporary_name(directory / "trial");
  const RemovedOnInterruption registered(trial);
  const bool written = try_to_write(trial, [](std::ostream &stream) { stream << "trial\n"; });
  std::error_code ignored;
  std::filesystem::remove(trial, ignored);
  return written;
}

/** The name of the file that @p name is a part of; @p name itself if it is not temporary. */
std::string final_name(const std::string &name)
{
  const std::size_t extra = temporary_prefix.size() + temporary_suffix.size();
  const bool temporary =
    name.size() > extra && name.compare(0, temporary_prefix.size(), temporary_prefix) == 0 &&
    name.compare(
      name.size() - temporary_suffix.size(), temporary_suffix.size(), temporary_suffix) == 0;
  return temporary ? name.substr(temporary_prefix.size(), name.size() - extra) : name;
}
} // namespace

ResultsDirectory::ResultsDirectory(const std::filesystem::path &path)
  : path_(path)
  , outermost_made_(outermost_missing(path))
{
  const std::string found = "--output: found '" + shorten_path(path_.string()) + "', ";
  std::error_code error;
  if (is_taken_name(path_) && !std::filesystem::exists(path_, error))
    throw InputError(found +
                     "a symbolic link that leads nowhere, allowed: a directory that can be made "
                     "and written to.");
  std::filesystem::create_directories(path_, error);
  if (error)
  {
    remove_if_empty();
    throw InputError(found + "allowed: a directory that can be made and written to.");
  }
  // The kernel releases the lock when the process ends, however that happens.
  descriptor_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
  {
    close(descriptor_);
    throw InputError(found + "into which another run is writing, allowed: a directory of its own.");
  }
  if (!is_writable(path_))
  {
    if (descriptor_ >= 0)
      close(descriptor_);
    remove_if_empty();
    throw InputError(found + "allowed: a directory that can be made and written to.");
  }
}

ResultsDirectory::~ResultsDirectory()
{
  if (descriptor_ >= 0)
    close(descriptor_);
}

void ResultsDirectory::remove_if_empty() const
{
  std::error_code ignored;
  if (outermost_made_.empty())
    return;
  for (std::filesystem::path path = path_; !path.empty(); path = path.parent_path())
  {
    std::filesystem::remove(path, ignored);
    if (path == outermost_made_)
      return;
  }
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
    throw ComputationError("The directory '" + shorten_path(path_.string()) +
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
  throw ComputationError("The file '" + shorten_path(path.string()) +
                         "' could not be written: the disk is full, or the directory has been "
                         "removed or write-protected.");
}

void remove_files(const std::filesystem::path &directory,
                  const std::function<bool(const std::string &name)> &is_removed)
{
  std::error_code error;
  std::vector<std::filesystem::path> found;
  for (const auto &entry : std::filesystem::directory_iterator(directory, error))
    if (!entry.is_directory(error) && is_removed(final_name(entry.path().filename().string())))
      found.push_back(entry.path());
  for (const std::filesystem::path &path : found)
  {
    std::filesystem::remove(path, error);
    if (error)
      throw ComputationError("The file '" + shorten_path(path.string()) +
                             "' of an earlier run could not be removed: " + error.message() + ".");
  }
}
} // namespace Signorini
