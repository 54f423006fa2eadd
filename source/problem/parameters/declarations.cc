// SPDX-License-Identifier: LGPL-2.1-or-later
// A value for a declared parameter, or one sentence that says why not.

#include "declarations.h"

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/formulas/expression.h>
#include <signorini/problem/parameters/entry_error.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <numeric>
#include <sstream>

namespace Signorini {
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

void Declarations::in_section(const std::string &path,
                              const std::function<void(const std::string &)> &act) const {
  const auto slash = path.find('/');
  if (slash == std::string::npos)
    return act(path);
  handler_.enter_subsection(path.substr(0, slash));
  act(path.substr(slash + 1));
  handler_.leave_subsection();
}

void Declarations::add(const std::string &path, Entry &entry, const std::string &default_text,
                       const std::string &help, const Patterns::PatternBase &pattern,
                       const std::string &allowed,
                       const std::function<void(const std::string &)> &set) {
  in_section(path, [&](const std::string &name) {
    handler_.declare_entry(name, default_text, pattern,
                           help + (allowed.empty() ? "" : " Allowed: " + allowed + "."));
    handler_.add_action(name, set);
  });
  entry.name = path;
  entry.origin = file_name_;
  declared_[path] = {allowed, default_text, false, &entry};
}

void Declarations::add(const std::string &path, Given<std::string> &given,
                       const std::string &help) {
  add(path, given, given.value, help, Patterns::Anything(), "",
      [&given](const std::string &text) { given.value = text; });
}

void Declarations::add(const std::string &path, Given<bool> &given, const std::string &help) {
  add(path, given, help, Patterns::Bool(), "true, false");
}

void Declarations::add(const std::string &path, Given<std::vector<double>> &given,
                       const std::string &help) {
  add(path, given, help, Patterns::List(Patterns::Double(), 0, 100, ","),
      "at most 100 numbers separated by commas");
  declared_[path].is_numeric = true;
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
    if (assignment.origin.rfind("--", 0) == 0 && path.find('/') == std::string::npos &&
        (!hint.empty() || (is_far && !constants.empty())))
      throw input_error(assignment.origin, ": found ", quote(path), hint, ", allowed: a constant (",
                        join(constants), ") or Subsection/Parameter.");
    if (!is_far)
      throw input_error(assignment.origin, ": ", shorten(path),
                        ": unknown parameter; did you mean '", nearest->first,
                        "'? (--print-parameters lists all)");
    std::vector<std::string> names;
    for (const auto &declared : declared_)
      if (section_of(declared.first) == section_of(path))
        names.push_back(name_in_section(declared.first));
    const bool has_section = !section_of(path).empty() && !names.empty();
    throw input_error(assignment.origin, ": ", shorten(path), ": unknown parameter",
                      has_section ? ", allowed in " + section_of(path) + ": " + join(names) + "."
                                  : " (--print-parameters lists all)");
  }
  Entry &entry = *known->second.entry;
  entry.origin = assignment.origin;
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
