// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

namespace Signorini
{
/**
 * Makes a directory for results and tries to write into it.
 * @throws InputError if that is not possible; nothing is left behind then.
 */
void prepare_directory(const std::filesystem::path &directory);

/** Removes a directory that prepare_directory() made if it holds nothing but parameters.prm. */
void remove_if_unused(const std::filesystem::path &directory);

/**
 * Writes a file under a temporary name and renames it when it is complete, so that a reader never
 * meets half a file. @throws ComputationError if the disk is full or the file cannot be written.
 */
void write_file(const std::filesystem::path &path,
                const std::function<void(std::ostream &)> &write);
} // namespace Signorini
