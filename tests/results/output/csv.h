// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <vector>

/** Comma-separated fields, empty ones included. */
inline std::vector<std::string> fields(const std::string &line) {
  std::vector<std::string> result(1);
  for (const char c : line)
    if (c == ',')
      result.emplace_back();
    else
      result.back() += c;
  return result;
}

/** Rows of a CSV text as maps from the name of a column to its field. */
inline std::vector<std::map<std::string, std::string>> read_csv(const std::string &text) {
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  const auto names = fields(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(stream, line)) {
    const auto values = fields(line);
    rows.emplace_back();
    for (std::size_t i = 0; i < names.size() && values.size() == names.size(); ++i)
      rows.back()[names[i]] = values[i];
  }
  return rows;
}
