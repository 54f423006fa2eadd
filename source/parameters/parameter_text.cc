// SPDX-License-Identifier: LGPL-2.1-or-later
// The syntax of a parameter file, line by line, so that every message can name its line.

#include <signorini/parameters/exceptions.h>
#include <signorini/parameters/lists.h>
#include <signorini/parameters/parameter_text.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace Signorini
{
namespace
{
/** Keeps track of the open subsections while the lines go by. */
class Scanner
{
public:
  explicit Scanner(std::string file_name)
    : file_name_(std::move(file_name))
  {
  }

  void read_line(const std::string &line, const unsigned int number)
  {
    place_ = file_name_ + ":" + std::to_string(number);
    const auto blank = line.find_first_of(" \t");
    const std::string keyword = line.substr(0, blank);
    const std::string rest = blank == std::string::npos ? "" : trim(line.substr(blank));
    if (keyword == "subsection" && !rest.empty())
      sections_.emplace_back(rest, place_);
    else if (keyword == "end" && rest.empty())
      leave_section();
    else if (keyword == "set" && rest.find('=') != std::string::npos)
      add(rest);
    else
      throw InputError(place_ + ": found '" + line +
                       "', but a line must be 'set Name = value', 'subsection Name' or 'end'.");
  }

  std::vector<Assignment> finish() const
  {
    if (!sections_.empty())
      throw InputError(sections_.back().second + ": subsection '" + sections_.back().first +
                       "' is not closed by 'end'.");
    return assignments_;
  }

private:
  void leave_section()
  {
    if (sections_.empty())
      throw InputError(place_ + ": found 'end' without an open subsection.");
    sections_.pop_back();
  }

  void add(const std::string &text)
  {
    const auto equals = text.find('=');
    std::string path;
    for (const auto &section : sections_)
      path += section.first + "/";
    path += trim(text.substr(0, equals));
    const auto earlier = places_.emplace(path, place_);
    if (!earlier.second)
      throw InputError(place_ + ": " + path + " was set already at " + earlier.first->second +
                       "; set every parameter only once.");
    assignments_.push_back({path, trim(text.substr(equals + 1)), place_});
  }

  std::string file_name_;
  std::string place_;
  std::vector<std::pair<std::string, std::string>> sections_;
  std::map<std::string, std::string> places_;
  std::vector<Assignment> assignments_;
};
} // namespace

std::vector<Assignment> scan_parameter_text(const std::string &text, const std::string &file_name)
{
  Scanner scanner(file_name);
  const std::string byte_order_mark = "\xEF\xBB\xBF";
  std::istringstream stream(
    text.compare(0, byte_order_mark.size(), byte_order_mark) == 0 ? text.substr(3) : text);
  std::string line;
  std::string logical_line;
  unsigned int number = 0;
  unsigned int first_number = 0;
  while (std::getline(stream, line))
  {
    ++number;
    const auto comment = line.find('#');
    line = trim(line.substr(0, comment));
    // A line that is nothing but a comment may stand between the parts of a continued line.
    if (line.empty() && comment != std::string::npos)
      continue;
    if (logical_line.empty())
      first_number = number;
    const bool continued = !line.empty() && line.back() == '\\';
    logical_line += continued ? line.substr(0, line.size() - 1) + " " : line;
    if (continued)
      continue;
    logical_line = trim(logical_line);
    if (!logical_line.empty())
      scanner.read_line(logical_line, first_number);
    logical_line.clear();
  }
  if (!trim(logical_line).empty())
    scanner.read_line(trim(logical_line), first_number);
  return scanner.finish();
}

Assignment scan_override(const std::string &argument)
{
  // An override is one line, like the file it stands in for.
  std::string line = argument;
  std::replace_if(
    line.begin(), line.end(), [](const unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  const auto equals = line.find('=');
  if (equals == std::string::npos || trim(line.substr(0, equals)).empty())
    throw InputError("--set: found '" + line + "', but 'Subsection/Parameter=value' is expected.");
  return {trim(line.substr(0, equals)), trim(line.substr(equals + 1)), "--set"};
}

std::string read_text_file(const std::string &file_name)
{
  std::error_code ignored;
  std::ifstream file(file_name, std::ios::binary);
  if (!file || std::filesystem::is_directory(file_name, ignored))
    throw InputError(file_name + ": this parameter file cannot be read.");
  std::ostringstream text;
  text << file.rdbuf();
  if (text.str().find('\0') != std::string::npos)
    throw InputError(file_name + ": this is not a text file.");
  return text.str();
}
} // namespace Signorini
