// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

namespace Signorini
{
/**
 * Makes a directory for results, with those above it, and tries to write into it.
 * @return the outermost directory that had to be made; empty if all were there.
 * @throws InputError if that is not possible; nothing is left behind then.
 */
std::filesystem::path prepare_directory(const std::filesystem::path &directory);

/**
 * Undoes prepare_directory(), which returned @p outermost: removes the directory if it holds
 * nothing but parameters.prm, and those above it if they are empty then. Others are left alone.
 */
void remove_if_unused(const std::filesystem::path &directory,
                      const std::filesystem::path &outermost);

/**
 * Writes a file under a temporary name and renames it when it is complete, so that a reader never
 * meets half a file. @throws ComputationError if the disk is full or the file cannot be written.
 */
void write_file(const std::filesystem::path &path,
                const std::function<void(std::ostream &)> &write);
} // namespace Signorini
