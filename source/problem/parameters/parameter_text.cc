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

// A value for a declared parameter, or one sentence that says why not.

namespace {
/** Returns Levenshtein's distance, for "did you mean". */
std::size_t edit_distance(const std::string &a, const std::string &b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

std::string section_of(const std::string &path) {
  return path.substr(0, path.rfind('/') == std::string::npos ? 0 : path.rfind('/'));
}

std::string name_in_section(const std::string &path) {
  return path.substr(path.rfind('/') + 1);
}

/** Returns the distance of a path from a known one, in which capital letters do not count; another
 * subsection, or none, counts as one character, and the first words of the name are all of it. */
std::size_t distance_of_paths(std::string known, std::string path) {
  boost::to_lower(known);
  boost::to_lower(path);
  const std::string name = name_in_section(known), found = name_in_section(path);
  const std::size_t other_section = section_of(known) == section_of(path) ? 0 : 1;
  if (!found.empty() && name.rfind(found + " ", 0) == 0)
    return other_section;
  return std::min(edit_distance(known, path), edit_distance(name, found) + 1);
}

/** Returns whether two values mean the same, however blanks and digits are written. */
bool is_same_value(std::string a, std::string b) {
  double first = 0., second = 0.;
  if (read_number(a, first) && read_number(b, second))
    return first == second;
  for (std::string *const text : {&a, &b})
    text->erase(std::remove(text->begin(), text->end(), ' '), text->end());
  return a == b;
}

/** Returns numbers with all digits, separated by commas. */
std::string join_numbers(const std::vector<double> &numbers) {
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text << (i > 0 ? ", " : "") << numbers[i];
  return text.str();
}
} // namespace

bool read_number(const Entry &entry, const std::string &text, double &number) {
  if (read_number(text, number))
    return true;
  try {
    const Expression<1> formula(text, *entry.constants, entry.where());
    number = formula(Point<1>());
    return formula.is_constant() && std::isfinite(number);
  } catch (const InputError &) {
    return false;
  }
}

bool read_numbers(const Entry &entry, const std::string &text, std::vector<double> &numbers) {
  numbers.clear();
  for (const std::string &part : split_list(text, ','))
    if (!read_number(entry, part, numbers.emplace_back()))
      return false;
  return true;
}

void Declarations::set_constants(const std::shared_ptr<const Constants> &constants) {
  for (const auto &declared : declared_)
    declared.second.entry->constants = constants;
}

const Declarations::Declared &Declarations::find(const Assignment &assignment) {
  const std::string &path = assignment.path;
  const auto known = declared_.find(path);
  if (known == declared_.end()) {
    const auto nearest =
      std::min_element(declared_.begin(), declared_.end(), [&](const auto &a, const auto &b) {
        return distance_of_paths(a.first, path) < distance_of_paths(b.first, path);
      });
    std::vector<std::string> constants;
    for (const auto &constant : *nearest->second.entry->constants)
      constants.push_back(constant.first);
    const std::string hint = hint_for(path, constants);
    const std::size_t distance = distance_of_paths(nearest->first, path);
    const bool is_far = distance > 1 && 3 * distance > name_in_section(path).size();
    if (assignment.place.rfind("--", 0) == 0 && path.find('/') == std::string::npos &&
        (!hint.empty() || (is_far && !constants.empty())))
      throw input_error(assignment.place, ": found ", quote(path), hint, ", allowed: a constant (",
                        join(constants), ") or Subsection/Parameter.");
    if (!is_far)
      throw input_error(assignment.place, ": ", shorten(path),
                        ": unknown parameter; did you mean '", nearest->first,
                        "'? (--print-parameters lists all)");
    std::vector<std::string> names;
    for (const auto &declared : declared_)
      if (section_of(declared.first) == section_of(path))
        names.push_back(name_in_section(declared.first));
    const bool has_section = !section_of(path).empty() && !names.empty();
    throw input_error(assignment.place, ": ", shorten(path), ": unknown parameter",
                      has_section ? ", allowed in " + section_of(path) + ": " + join(names) + "."
                                  : " (--print-parameters lists all)");
  }
  Entry &entry = *known->second.entry;
  entry.place = assignment.place;
  entry.is_given = true;
  return known->second;
}

void Declarations::assign_by_body(const Assignment &assignment) {
  find(assignment).entry->changed = true;
  by_body_[assignment.path] = assignment.value;
}

void Declarations::assign(const Assignment &assignment) {
  const std::string &path = assignment.path, &value = assignment.value;
  const Declared &declared = find(assignment);
  Entry &entry = *declared.entry;
  if (value.empty() && !declared.default_text.empty())
    throw error_at(entry, "found '', allowed: ",
                   declared.allowed.empty() ? "a value, by default " + quote(declared.default_text)
                                            : declared.allowed,
                   ".");
  // Formulas of constants become numbers; the names of options may begin with a capital.
  std::string text = value;
  std::vector<double> numbers;
  if (declared.is_numeric && !read_numbers(value, numbers) && read_numbers(entry, value, numbers))
    text = join_numbers(numbers);
  for (const std::string &allowed : split_list(declared.allowed, ','))
    if (boost::iequals(allowed, value))
      text = allowed;
  entry.changed = !is_same_value(text, declared.default_text);
  try {
    in_section(path, [&](const std::string &name) { handler_.set(name, text); });
  } catch (const ExceptionBase &) {
    throw error_at(entry, "found ", quote(value), ", allowed: ", declared.allowed, ".");
  }
}

std::set<std::string> Declarations::sections() const {
  std::set<std::string> names;
  for (const auto &declared : declared_)
    if (const std::string section = section_of(declared.first); !section.empty())
      names.insert(section);
  return names;
}

std::vector<Entry> Declarations::changes(const std::vector<std::string> &sections) const {
  std::vector<Entry> changes;
  for (const std::string &section : sections)
    for (const auto &declared : declared_)
      if (section_of(declared.first) == section && declared.second.entry->changed)
        changes.push_back(*declared.second.entry);
  return changes;
}

std::string Declarations::print(const bool with_help) const {
  std::ostringstream text;
  handler_.print_parameters(text,
                            (with_help ? ParameterHandler::Text : ParameterHandler::ShortText) |
                              ParameterHandler::KeepDeclarationOrder);
  std::string lines = text.str();
  for (const auto &[path, value] : by_body_)
    set_in_echo(path, value, lines);
  return lines;
}

void set_in_echo(const std::string &path, const std::string &value, std::string &echo) {
  const std::size_t section = echo.find("subsection " + section_of(path) + "\n"),
                    entry = echo.find("set " + name_in_section(path) + " ", section),
                    begin = echo.find("= ", entry) + 2;
  echo.replace(begin, echo.find('\n', begin) - begin, value);
}
} // namespace Signorini
