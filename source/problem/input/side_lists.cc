// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists by boundary name: entries separated by '|', the name before the first ':'.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "input.h"

namespace Signorini {
Phrase::Phrase(const std::string &text, const std::string &words)
  : parts(1) {
  const std::regex any("\\b(" + words + ")\\b");
  bool is_word = false;
  for (std::sregex_token_iterator piece(text.begin(), text.end(), any, {-1, 0}), end; piece != end;
       ++piece, is_word = !is_word)
    if (is_word)
      parts.push_back({*piece, ""});
    else
      parts.back().text = trim(*piece);
  form = parts[0].text.empty() ? "" : "...";
  for (std::size_t i = 1; i < parts.size(); ++i)
    form += (form.empty() ? "" : " ") + parts[i].word;
}

// Expressions may contain a ':' of their own (c ? a : b).
bool begins_with_a_name(const std::string &text) {
  const auto colon = text.find(':');
  const std::string name = trim(text.substr(0, colon));
  return colon != std::string::npos && !name.empty() &&
         std::all_of(name.begin(), name.end(), [](const unsigned char c) {
           return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c == ' ';
         });
}

std::vector<std::string> sides_called(const std::string &name,
                                      const std::vector<std::string> &sides) {
  std::vector<std::string> parts;
  for (const std::string &side : sides) {
    if (side == name)
      return {name};
    const bool is_part = side.rfind(name + ".", 0) == 0 && side.size() > name.size() + 1 &&
                         side.find_first_not_of("0123456789", name.size() + 1) == std::string::npos;
    if (is_part || side.rfind(name + " with ", 0) == 0)
      parts.push_back(side);
  }
  return parts;
}

SideTexts read_side_list(const std::string &text, const std::string &where,
                         const std::vector<std::string> &sides) {
  SideTexts entries;
  for (const std::string &part : split_list(text, '|')) {
    const auto colon = part.find(':');
    const std::vector<std::string> called = sides_called(trim(part.substr(0, colon)), sides);
    if (colon == std::string::npos || called.empty())
      throw input_error(where, ": found ", quote(part),
                        hint_for(trim(part.substr(0, colon)), sides), ", allowed: one of ",
                        join(sides), ", ':' and its value.");
    for (const std::string &side : called)
      entries.emplace_back(side, trim(part.substr(colon + 1)));
  }
  return entries;
}

SideTexts read_list_for(const std::vector<std::string> &called, const std::string &text,
                        const std::string &where, const std::vector<std::string> &sides) {
  SideTexts entries;
  if (!begins_with_a_name(text))
    for (const std::string &side : called)
      entries.emplace_back(side, trim(text));
  else
    entries = read_side_list(text, where, sides);
  std::multiset<std::string> names;
  for (const auto &entry : entries)
    names.insert(entry.first);
  for (const std::string &name : sides)
    if (const bool belongs = std::count(called.begin(), called.end(), name) > 0;
        names.count(name) != (belongs ? 1U : 0U))
      throw input_error(where, ": the number of entries for '", name, "' is ", names.count(name),
                        ", allowed: one for each of ", join(called), ".");
  return entries;
}

} // namespace Signorini
