// SPDX-License-Identifier: LGPL-2.1-or-later
// The syntax of a parameter file, line by line, so that every message can name its line.
// (ParameterHandler loses an entry that is set twice, and the line of a missing 'end'.)

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/formulas/expression.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/parameters/parameter_text.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>

#include "declarations.h"

namespace Signorini {
namespace {
/** The largest size of a parameter file in bytes. */
constexpr std::size_t max_file_size = 1000000;

/** Reads line after line and stores the open subsection. */
class Scanner {
public:
  Scanner(std::string file_name, const std::set<std::string> &known_sections)
    : file_name_(std::move(file_name))
    , known_sections_(known_sections) {}

  void read_line(const std::string &line, const unsigned int number) {
    place_ = file_name_ + ":" + std::to_string(number);
    const auto blank = std::min(line.find_first_of(" \t"), line.size());
    const std::string keyword = line.substr(0, blank), rest = trim(line.substr(blank));
    if (keyword == "subsection" && !rest.empty())
      enter_section(rest);
    else if (keyword == "end" && rest.empty())
      leave_section();
    else if (keyword == "set" && rest.find('=') != std::string::npos && rest[0] != '=')
      add(rest);
    else
      throw input_error(place_, ": found ", quote(line),
                        ", but a line must be 'set Name = value', 'subsection Name' or 'end'.");
  }

  std::vector<Assignment> finish() const {
    if (!section_.empty())
      throw input_error(section_place_, ": subsection ", quote(section_),
                        " is not closed by 'end'.");
    return assignments_;
  }

private:
  void enter_section(const std::string &name) {
    if (!section_.empty())
      throw input_error(place_, ": found the subsection ", quote(name), " inside of ",
                        quote(section_), " (", section_place_,
                        "), allowed: one after the other, each closed by 'end'.");
    section_ = name;
    section_place_ = place_;
    is_empty_ = true;
  }

  void leave_section() {
    if (section_.empty())
      throw input_error(place_, ": found 'end' without an open subsection.");
    if (is_empty_ && known_sections_.count(section_) == 0)
      throw input_error(section_place_, ": found the subsection ", quote(section_),
                        ", allowed: ", join({known_sections_.begin(), known_sections_.end()}), ".");
    section_.clear();
  }

  void add(const std::string &text) {
    const auto equals = text.find('=');
    const std::string path =
      (section_.empty() ? "" : section_ + "/") + trim(text.substr(0, equals));
    is_empty_ = false;
    const auto earlier = places_.emplace(path, place_);
    if (!earlier.second)
      throw input_error(place_, ": ", shorten(path), " was set already at ", earlier.first->second,
                        "; set every parameter only once.");
    assignments_.push_back({path, trim(text.substr(equals + 1)), place_});
  }

  std::string file_name_;
  std::set<std::string> known_sections_;
  std::string place_, section_, section_place_;
  bool is_empty_ = true;
  std::map<std::string, std::string> places_;
  std::vector<Assignment> assignments_;
};

bool is_control(const unsigned char c) {
  return std::iscntrl(c) != 0;
}

/** Returns the text without a byte-order mark, and with the line ends of Unix. */
std::string with_plain_line_ends(std::string text) {
  const std::string byte_order_mark = "\xEF\xBB\xBF";
  if (text.rfind(byte_order_mark, 0) == 0)
    text.erase(0, byte_order_mark.size());
  boost::replace_all(text, "\r\n", "\n");
  boost::replace_all(text, "\r", "\n");
  return text;
}
} // namespace

std::vector<Assignment> scan_parameter_text(const std::string &text, const std::string &file_name,
                                            const std::set<std::string> &known_sections) {
  Scanner scanner(file_name, known_sections);
  std::istringstream stream(with_plain_line_ends(text));
  std::string line, logical_line;
  unsigned int number = 0, first_number = 0;
  const auto finish_line = [&]() {
    if (!trim(logical_line).empty())
      scanner.read_line(trim(logical_line), first_number);
    logical_line.clear();
  };
  while (std::getline(stream, line)) {
    ++number;
    for (const unsigned char c : line)
      if (is_control(c) && c != '\t')
        throw input_error(file_name, ":", number, ": found the control character number ",
                          std::to_string(c), ", allowed: plain text.");
    const auto comment = line.find('#');
    line = trim(line.substr(0, comment));
    // A line that is nothing but a comment may stand between the parts of a continued line.
    if (line.empty() && comment != std::string::npos)
      continue;
    if (logical_line.empty())
      first_number = number;
    const bool continued = !line.empty() && line.back() == '\\';
    logical_line += continued ? line.substr(0, line.size() - 1) + " " : line;
    if (!continued)
      finish_line();
  }
  finish_line();
  return scanner.finish();
}

Assignment scan_override(const std::string &argument, const std::string &option) {
  // An override is one line, like the file it stands in for.
  std::string line = argument;
  std::replace_if(line.begin(), line.end(), is_control, ' ');
  const auto equals = line.find('=');
  if (equals == std::string::npos || trim(line.substr(0, equals)).empty())
    throw input_error(option, ": found ", quote(line),
                      ", but 'Subsection/Parameter=value' is expected.");
  return {trim(line.substr(0, equals)), trim(line.substr(equals + 1)), option};
}

std::string read_whole_file(const std::string &file_name, const std::string &where,
                            const std::string &kind, const std::size_t max_size) {
  namespace fs = std::filesystem;
  const std::string name = where + shorten_path(file_name);
  std::error_code error;
  const fs::file_status status = fs::status(file_name, error);
  // Reading from pipes and some devices might never end.
  if (fs::is_other(status))
    throw input_error(name, ": this is a device or a pipe, allowed: a file of text on a disk.");
  std::ifstream stream(file_name, std::ios::binary);
  const std::size_t size = fs::is_regular_file(status) ? fs::file_size(file_name, error) : 0;
  // Files of the kernel have the size 0, and may have no end.
  const std::size_t most = size > 0 ? std::min(size, max_size) : std::min(max_size, max_file_size);
  std::string text(most + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream.is_open() || stream.bad() || fs::is_directory(status))
    throw input_error(name, ": this ", kind, " cannot be read.");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > most)
    throw input_error(name + ": this file has " +
                      (size > 0 ? std::to_string(size) : "more than " + std::to_string(most)) +
                      " bytes, allowed: at most " + std::to_string(max_size) + ".");
  return text;
}

std::string read_text_file(const std::string &file_name) {
  std::string text = read_whole_file(file_name, "", "parameter file", max_file_size);
  if (text.find('\0') != std::string::npos)
    throw input_error(shorten_path(file_name), ": this is not a text file.");
  return text;
}

} // namespace Signorini
