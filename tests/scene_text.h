// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <sstream>
#include <string>

/** Returns "subsection SECTION / set NAME = VALUE / end" for short parameter texts. */
inline std::string entry(const std::string &section, const std::string &name,
                         const std::string &value) {
  return "subsection " + section + "\nset " + name + " = " + value + "\nend\n";
}

/** Returns a parameter file in which each line "Section/Name = value" is an entry. Other lines stay
 * as they are. */
inline std::string parameter_file(const std::string &lines) {
  std::istringstream stream(lines);
  std::string text, line;
  while (std::getline(stream, line)) {
    const auto equals = line.find('='), slash = line.rfind('/', equals);
    const bool is_short = equals != std::string::npos && slash != std::string::npos;
    text += is_short ? entry(line.substr(0, slash), line.substr(slash + 1, equals - slash - 1),
                             line.substr(equals + 1))
                     : line + "\n";
  }
  return text;
}
