// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/** Parts of the text of a mesh file, and their replacements. */
using Changes = std::vector<std::pair<std::string, std::string>>;

/** A mesh that is wrong by changes of a good one, and the message that refuses it. */
struct WrongMesh {
  Changes changes;
  std::string message;
};

/** Returns a text with changes, each of which it must contain. */
inline std::string change(std::string text, const Changes &changes) {
  for (const auto &[from, to] : changes) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos)
      throw std::runtime_error("the text has no " + from);
    text.replace(at, from.size(), to);
  }
  return text;
}
