// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace Signorini {
using NameTest = std::function<bool(const std::string &name)>;

/** Returns whether a run writes files of this name. */
bool is_name_of_result(const std::string &name);
constexpr const char *parameters_name = "parameters.prm";
constexpr const char *certificate_name = "certificate.json";

/** A directory for results, which belongs to this run alone as long as the object lives. */
class ResultsDirectory {
public:
  /**
   * Makes the directory with those above it, tries to write into it, and keeps other runs out of it
   * (where the file system has locks).
   * @param inputs files that the run reads. None of them may be in the directory, under any name or
   * through a link, as a file whose name satisfies @p is_result: it would be replaced.
   * @throws InputError if that is not possible; nothing is left behind then.
   */
  explicit ResultsDirectory(const std::filesystem::path &path,
                            const std::vector<std::filesystem::path> &inputs = {},
                            const NameTest &is_result = is_name_of_result);
  ~ResultsDirectory();
  ResultsDirectory(const ResultsDirectory &) = delete;
  ResultsDirectory &operator=(const ResultsDirectory &) = delete;

  /** Removes the directories that this object made, as far as they are empty. */
  void remove_if_empty() const;

private:
  /** Locks the directory. @return the reason why the directory cannot be used; empty if there is
   * none. */
  std::string lock(const std::vector<std::filesystem::path> &inputs, const NameTest &is_result);
  void unlock();

  std::filesystem::path path_;
  /** The directories that were made, each behind those above it. */
  std::vector<std::filesystem::path> made_;
  /** The descriptor of the open directory, which bears the lock; negative: none. */
  int descriptor_ = -1;
};

/** Returns the name under which a file is written until it is complete. */
std::filesystem::path temporary_name(const std::filesystem::path &path);

/**
 * Writes a file under a temporary name and renames it when it is complete, so that a reader never
 * meets half a file, even if the run is killed. @throws WritingError if the disk is full or the
 * file cannot be written.
 */
void write_file(const std::filesystem::path &path,
                const std::function<void(std::ostream &)> &write);

/**
 * Removes the files of a directory whose names satisfy @p is_removed; with a file go the
 * remains of an attempt to write it. @throws WritingError if one cannot be removed.
 */
void remove_files(const std::filesystem::path &directory, const NameTest &is_removed);

} // namespace Signorini
