// SPDX-License-Identifier: LGPL-2.1-or-later
// Files appear complete or not at all.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/results/output/files.h>
#include <signorini/results/output/signals.h>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <regex>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace Signorini {
namespace {
constexpr const char *trial_name = "trial";

/** Writes and flushes. @return whether every byte was written. */
bool try_to_write(const std::filesystem::path &path,
                  const std::function<void(std::ostream &)> &write) {
  // A pipe or a link with this name must not be written to.
  unlink(path.c_str());
  std::ofstream file(path, std::ios::binary);
  try {
    write(file);
  } catch (...) {
    // deal.II's writers throw when the disk is full.
    if (!file)
      return false;
    unlink(path.c_str());
    throw;
  }
  file.close();
  return !file.fail();
}

/** Returns whether something has this name, also a link that leads nowhere. */
bool is_taken_name(const std::filesystem::path &path) {
  std::error_code error;
  return std::filesystem::exists(std::filesystem::symlink_status(path, error));
}

/** Makes the directory and those above it, as far as they are missing. A path may lead up again by
 * "..", so that not every directory on it is above the last. @return the directories that were
 * made, in this order.
 */
std::vector<std::filesystem::path> make_directories(const std::filesystem::path &directory) {
  std::vector<std::filesystem::path> made;
  std::filesystem::path path;
  for (const std::filesystem::path &part : directory) {
    path /= part;
    if (mkdir(path.c_str(), 0777) == 0)
      made.push_back(path);
  }
  return made;
}

/** Returns whether a small file can be written into @p directory; it is removed again. */
bool is_writable(const std::filesystem::path &directory) {
  const std::filesystem::path trial = temporary_name(directory / trial_name);
  const UnfinishedFile until_end(trial);
  const bool written = try_to_write(trial, [](std::ostream &stream) { stream << "trial\n"; });
  unlink(trial.c_str());
  return written;
}

/** Returns the name of the file that @p name is a part of; @p name itself if it is not temporary.
 */
std::string final_name(const std::string &name) {
  static const std::regex temporary("\\.(.+)\\.part");
  return std::regex_replace(name, temporary, "$1");
}

/** Returns the files of a directory whose names satisfy a test. */
std::vector<std::filesystem::path> find_files(const std::filesystem::path &directory,
                                              const NameTest &is_wanted) {
  std::error_code error;
  std::vector<std::filesystem::path> found;
  for (const auto &entry : std::filesystem::directory_iterator(directory, error))
    if (!entry.is_directory(error) && is_wanted(entry.path().filename().string()))
      found.push_back(entry.path());
  return found;
}

/** Returns whether a file of the directory that the results replace is the file @p input, under any
 * name of it and through links. */
bool holds_as_result(const std::filesystem::path &directory, const std::filesystem::path &input,
                     const NameTest &is_result) {
  const auto found = find_files(directory, [&](const std::string &name) {
    return is_result(final_name(name)) || final_name(name) == trial_name;
  });
  return std::any_of(found.begin(), found.end(), [&](const std::filesystem::path &path) {
    std::error_code error;
    return std::filesystem::equivalent(path, input, error);
  });
}

} // namespace

ResultsDirectory::ResultsDirectory(const std::filesystem::path &path,
                                   const std::vector<std::filesystem::path> &inputs,
                                   const NameTest &is_result)
  : path_(path) {
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

ResultsDirectory::~ResultsDirectory() {
  unlock();
}

std::string ResultsDirectory::lock(const std::vector<std::filesystem::path> &inputs,
                                   const NameTest &is_result) {
  const std::string allowed = "allowed: a directory that can be made and written to.";
  std::error_code error;
  if (!std::filesystem::is_directory(path_, error))
    return allowed;
  // The kernel releases the lock when the process ends, however that happens.
  descriptor_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    return "into which another run is writing, allowed: a directory of its own.";
  for (const std::filesystem::path &input : inputs)
    if (holds_as_result(path_, input, is_result))
      return "where the file " + quote(shorten_path(input.string())) +
             ", which the run reads, would be overwritten by the results, allowed: another "
             "directory, or another name of this file.";
  return is_writable(path_) ? "" : allowed;
}

void ResultsDirectory::unlock() {
  if (descriptor_ >= 0)
    close(descriptor_);
  descriptor_ = -1;
}

void ResultsDirectory::remove_if_empty() const {
  // rmdir() removes neither a file nor a directory that is not empty.
  for (auto path = made_.rbegin(); path != made_.rend(); ++path)
    rmdir(path->c_str());
}

bool is_name_of_result(const std::string &name) {
  static const std::regex names(
    "convergence\\.(csv|md|tex)|(answer|scene|verified)\\.json|verified\\.vtu|(solution|contact)(-"
    "cases)?\\.pvd|"
    "contact-[0-9]{2}\\.csv|(solution|contact)-[0-9]{2}(\\.[0-9]{4})?\\.p?vtu|"
    "(mesh-[0-9]{2}|pressure(-case-[0-9]{6})?|deformed|bound|scene|convergence|travel|verified)\\."
    "(svg|png|pdf)|"
    "[ABCDFGKPbcfqs]-[0-9]{2}\\.mtx|(cases|contacts)\\.csv|contact-case-[0-9]{6}\\.csv|"
    "(solution|contact)-case-[0-9]{6}\\.vtu|line-[0-9]+\\.csv");
  return std::regex_match(name, names) || name == parameters_name || name == certificate_name;
}

std::filesystem::path temporary_name(const std::filesystem::path &path) {
  return path.parent_path() / ("." + path.filename().string() + ".part");
}

void write_file(const std::filesystem::path &path,
                const std::function<void(std::ostream &)> &write) {
  const std::filesystem::path temporary = temporary_name(path);
  const UnfinishedFile until_end(temporary);
  std::error_code error;
  if (try_to_write(temporary, write)) {
    std::filesystem::rename(temporary, path, error);
    if (!error)
      return;
  }
  std::filesystem::remove(temporary, error);
  throw WritingError("The file '" + shorten_path(path.string()) +
                     "' could not be written: the disk is full, or the directory has been "
                     "removed or write-protected.");
}

void remove_files(const std::filesystem::path &directory, const NameTest &is_removed) {
  for (const std::filesystem::path &path : find_files(
         directory, [&](const std::string &name) { return is_removed(final_name(name)); })) {
    std::error_code error;
    std::filesystem::remove(path, error);
    if (error)
      throw WritingError("The file '" + shorten_path(path.string()) +
                         "' of an earlier run could not be removed: " + error.message() + ".");
  }
}

} // namespace Signorini
