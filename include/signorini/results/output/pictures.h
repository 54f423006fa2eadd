// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <string>

namespace Signorini {
/** Draws the results in a directory by the script signorini-plot beside the program. @return one
 * sentence with the reason and how to draw later; empty if the pictures are there. */
std::string draw_pictures(const std::filesystem::path &directory, const std::string &option = "");
} // namespace Signorini
