// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace Signorini
{
using NameTest = std::function<bool(const std::string &name)>;

/** Whether a run writes files of this name. */
bool is_name_of_result(const std::string &name);
constexpr const char *parameters_name = "parameters.prm";
constexpr const char *certificate_name = "certificate.json";

/** A directory for results, which is this run's alone as long as the object lives. */
class ResultsDirectory
{
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
  /** @return what speaks against the directory, empty if nothing does. */
  std::string lock(const std::vector<std::filesystem::path> &inputs, const NameTest &is_result);
  void unlock();

  std::filesystem::path path_;
  /** The directories that had to be made, each behind those above it. */
  std::vector<std::filesystem::path> made_;
  /** Of the open directory, which bears the lock; negative: none. */
  int descriptor_ = -1;
};

/**
 * The directory that a path led to when the object was made. It may be moved, removed or replaced
 * while a run writes into it; then the files of the run would be scattered over two directories.
 */
class HeldDirectory
{
public:
  explicit HeldDirectory(const std::filesystem::path &path);
  ~HeldDirectory();
  HeldDirectory(const HeldDirectory &) = delete;
  HeldDirectory &operator=(const HeldDirectory &) = delete;

  /** @throws WritingError if the path leads elsewhere now. */
  void check() const;

private:
  std::filesystem::path path_;
  /** Keeps the kernel from giving the directory's number to another one. */
  int descriptor_;
};

/** The name under which a file is written until it is complete. */
std::filesystem::path temporary_name(const std::filesystem::path &path);

/**
 * Writes a file under a temporary name and renames it when it is complete, so that a reader never
 * meets half a file, even if the run is killed. @throws WritingError if the disk is full or the
 * file cannot be written.
 */
void write_file(const std::filesystem::path &path,
                const std::function<void(std::ostream &)> &write);

/**
 * Removes the files of a directory whose names satisfy @p is_removed; with a file goes what is left
 * of an attempt to write it. @throws WritingError if one cannot be removed.
 */
void remove_files(const std::filesystem::path &directory, const NameTest &is_removed);

/*
 * The results of an earlier run stay in a hidden folder of their directory until the run that
 * replaces them has a verdict. A run that is killed before that leaves them there.
 */

/** Moves the results into the folder, the certificate first; what was in it is removed.
 * @throws WritingError if that is not possible; then they are where they were. */
void set_results_aside(const std::filesystem::path &directory);
/** Moves them back. */
void put_results_back(const std::filesystem::path &directory);
/** Removes the folder with the earlier results. @throws WritingError */
void remove_results_aside(const std::filesystem::path &directory);
} // namespace Signorini
