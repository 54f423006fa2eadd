// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists by boundary name: entries separated by '|', the name before the first ':'.

#include "side_lists.h"

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>

#include <algorithm>
#include <cctype>

namespace Signorini
{
namespace
{
bool contains(const std::vector<std::string> &names, const std::string &name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/** Expressions may hold a ':' of their own (c ? a : b); a name is a single word before it. */
bool looks_like_a_name(const std::string &text)
{
  return !text.empty() && std::all_of(text.begin(), text.end(), [](const unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
  });
}
} // namespace

bool begins_with_a_name(const std::string &text)
{
  const auto colon = text.find(':');
  return colon != std::string::npos && looks_like_a_name(trim(text.substr(0, colon)));
}

std::vector<std::string> sides_called(const std::string &name,
                                      const std::vector<std::string> &sides)
{
  std::vector<std::string> parts;
  const std::string beginning = name + ".";
  for (const std::string &side : sides)
  {
    if (side == name)
      return {name};
    const std::string number =
      side.compare(0, beginning.size(), beginning) == 0 ? side.substr(beginning.size()) : "";
    if (!number.empty() && std::all_of(number.begin(), number.end(), [](const unsigned char c) {
          return std::isdigit(c) != 0;
        }))
      parts.push_back(side);
  }
  return parts;
}

SideTexts read_side_list(const std::string &text,
                         const std::string &where,
                         const std::vector<std::string> &sides)
{
  SideTexts entries;
  for (const std::string &part : split_list(text, '|'))
  {
    const auto colon = part.find(':');
    const std::string name = trim(part.substr(0, colon));
    const std::vector<std::string> called = sides_called(name, sides);
    if (colon == std::string::npos || called.empty())
      throw InputError(where + ": found " + quote(part) + ", allowed: a side (" + join(sides) +
                       "), ':' and its value.");
    for (const std::string &side : called)
      entries.emplace_back(side, trim(part.substr(colon + 1)));
  }
  return entries;
}

SideTexts read_contact_list(const std::string &text,
                            const std::string &where,
                            const std::vector<std::string> &sides,
                            const std::vector<std::string> &contact_sides)
{
  SideTexts entries;
  if (!begins_with_a_name(text))
  {
    for (const std::string &side : contact_sides)
      entries.emplace_back(side, trim(text));
    return entries;
  }
  for (const auto &entry : read_side_list(text, where, sides))
  {
    const bool repeated = std::any_of(entries.begin(), entries.end(), [&](const auto &other) {
      return other.first == entry.first;
    });
    if (repeated || !contains(contact_sides, entry.first))
      throw InputError(where + ": found an entry for " + quote(entry.first) +
                       ", allowed: one for each contact side (" + join(contact_sides) + ").");
    entries.push_back(entry);
  }
  for (const std::string &side : contact_sides)
    if (std::none_of(
          entries.begin(), entries.end(), [&](const auto &entry) { return entry.first == side; }))
      throw InputError(where + ": found no entry for the contact side '" + side +
                       "', allowed: one for each contact side.");
  return entries;
}
} // namespace Signorini
