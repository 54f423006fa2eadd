// SPDX-License-Identifier: LGPL-2.1-or-later
// A value for a declared parameter, or one sentence that says why not.

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>

#include "declarations.h"

namespace Signorini
{
namespace
{
/** Levenshtein distance, for "did you mean". */
std::size_t edit_distance(const std::string &a, const std::string &b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

/** Whether two values mean the same, however blanks and digits are written. */
bool is_same_value(std::string a, std::string b)
{
  double first = 0., second = 0.;
  if (read_number(a, first) && read_number(b, second))
    return first == second;
  for (std::string *const text : {&a, &b})
    text->erase(std::remove(text->begin(), text->end(), ' '), text->end());
  return a == b;
}
} // namespace

void Declarations::refuse_unknown(const Assignment &assignment) const
{
  std::string nearest;
  std::size_t distance = std::numeric_limits<std::size_t>::max();
  for (const auto &declared : declared_)
    if (edit_distance(declared.first, assignment.path) < distance)
    {
      nearest = declared.first;
      distance = edit_distance(declared.first, assignment.path);
    }
  throw InputError(assignment.place + ": " + shorten(assignment.path) +
                   ": unknown parameter; did you mean '" + nearest +
                   "'? (--print-parameters lists all)");
}

void Declarations::assign(const Assignment &assignment)
{
  const std::string &path = assignment.path, &value = assignment.value;
  const auto known = declared_.find(path);
  if (known == declared_.end())
    refuse_unknown(assignment);
  const Declared &declared = known->second;
  Entry &entry = *declared.entry;
  entry.place = assignment.place;
  const auto slash = path.find('/');
  if (slash != std::string::npos)
    handler_.enter_subsection(path.substr(0, slash));
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  try
  {
    handler_.set(name, value.empty() ? declared.default_text : value);
  }
  catch (const dealii::ExceptionBase &)
  {
    throw InputError(entry.where() + ": found " + quote(value) + ", allowed: " + declared.allowed +
                     ".");
  }
  if (slash != std::string::npos)
    handler_.leave_subsection();
  entry.changed = !value.empty() && !is_same_value(value, declared.default_text);
}

std::set<std::string> Declarations::sections() const
{
  std::set<std::string> names;
  for (const auto &declared : declared_)
    if (declared.first.find('/') != std::string::npos)
      names.insert(declared.first.substr(0, declared.first.find('/')));
  return names;
}

std::vector<Entry> Declarations::changes(const std::vector<std::string> &sections) const
{
  std::vector<Entry> changes;
  for (const std::string &section : sections)
    for (const auto &declared : declared_)
      if (declared.first.rfind(section + "/", 0) == 0 && declared.second.entry->changed)
        changes.push_back(*declared.second.entry);
  return changes;
}

std::string Declarations::print(const bool with_help) const
{
  std::ostringstream text;
  handler_.print_parameters(
    text,
    (with_help ? dealii::ParameterHandler::Text : dealii::ParameterHandler::ShortText) |
      dealii::ParameterHandler::KeepDeclarationOrder);
  return text.str();
}
} // namespace Signorini
