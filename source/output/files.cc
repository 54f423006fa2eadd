// SPDX-License-Identifier: LGPL-2.1-or-later
// Files appear complete or not at all.

#include <signorini/output/files.h>
#include <signorini/parameters/exceptions.h>

#include <fstream>

namespace Signorini
{
namespace
{
/** The name under which a file is written until it is complete. */
std::filesystem::path temporary_name(const std::filesystem::path &path)
{
  return path.parent_path() / ("." + path.filename().string() + ".part");
}

/** Writes and flushes; returns whether every byte was taken. Nothing is left if @p write throws. */
bool try_to_write(const std::filesystem::path &path,
                  const std::function<void(std::ostream &)> &write)
{
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (!file)
    return false;
  try
  {
    write(file);
  }
  catch (...)
  {
    file.close();
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    throw;
  }
  file.close();
  return !file.fail();
}

/** The outermost of the directories above and including @p directory that is not there. */
std::filesystem::path outermost_missing(const std::filesystem::path &directory)
{
  std::filesystem::path missing;
  std::error_code error;
  for (std::filesystem::path path = directory;
       !path.empty() && !std::filesystem::exists(path, error);
       path = path.parent_path())
    missing = path;
  return missing;
}

/** Removes @p directory and those above it up to @p outermost, as far as they are empty. */
void remove_empty(const std::filesystem::path &directory, const std::filesystem::path &outermost)
{
  std::error_code ignored;
  if (outermost.empty())
    return;
  for (std::filesystem::path path = directory; !path.empty(); path = path.parent_path())
  {
    std::filesystem::remove(path, ignored);
    if (path == outermost)
      return;
  }
}
} // namespace

std::filesystem::path prepare_directory(const std::filesystem::path &directory)
{
  std::error_code error;
  const std::filesystem::path outermost = outermost_missing(directory);
  std::filesystem::create_directories(directory, error);
  const std::filesystem::path trial = temporary_name(directory / "trial");
  const bool writable =
    !error && try_to_write(trial, [](std::ostream &stream) { stream << "trial\n"; });
  std::filesystem::remove(trial, error);
  if (writable)
    return outermost;
  remove_empty(directory, outermost);
  throw InputError("--output: found '" + directory.string() +
                   "', allowed: a directory that can be made and written to.");
}

void remove_if_unused(const std::filesystem::path &directory,
                      const std::filesystem::path &outermost)
{
  std::error_code ignored;
  if (outermost.empty())
    return;
  for (const auto &entry : std::filesystem::directory_iterator(directory, ignored))
    if (entry.path().filename() != "parameters.prm")
      return;
  std::filesystem::remove(directory / "parameters.prm", ignored);
  remove_empty(directory, outermost);
}

void write_file(const std::filesystem::path &path, const std::function<void(std::ostream &)> &write)
{
  const std::filesystem::path temporary = temporary_name(path);
  std::error_code error;
  if (try_to_write(temporary, write))
  {
    std::filesystem::rename(temporary, path, error);
    if (!error)
      return;
  }
  std::filesystem::remove(temporary, error);
  throw ComputationError("The file '" + path.string() +
                         "' could not be written: the disk is full, or the directory has been "
                         "removed or write-protected.");
}
} // namespace Signorini
