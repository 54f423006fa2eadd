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

void Declarations::refuse_unknown(const std::string &path, const std::string &where) const
{
  std::string nearest;
  std::size_t distance = std::numeric_limits<std::size_t>::max();
  for (const auto &entry : allowed_)
    if (edit_distance(entry.first, path) < distance)
    {
      nearest = entry.first;
      distance = edit_distance(entry.first, path);
    }
  throw InputError(where + ": unknown parameter; did you mean '" + nearest +
                   "'? (--print-parameters lists all)");
}

bool Declarations::assign(const std::string &path,
                          const std::string &value,
                          const std::string &where)
{
  const auto known = allowed_.find(path);
  if (known == allowed_.end())
    refuse_unknown(path, where);
  const auto slash = path.find('/');
  if (slash != std::string::npos)
    handler_.enter_subsection(path.substr(0, slash));
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  try
  {
    handler_.set(name, value.empty() ? defaults_[path] : value);
  }
  catch (const dealii::ExceptionBase &)
  {
    throw InputError(where + ": found " + quote(value) + ", allowed: " + known->second + ".");
  }
  if (slash != std::string::npos)
    handler_.leave_subsection();
  return !value.empty() && !is_same_value(value, defaults_[path]);
}

std::set<std::string> Declarations::sections() const
{
  std::set<std::string> names;
  for (const auto &entry : allowed_)
    if (entry.first.find('/') != std::string::npos)
      names.insert(entry.first.substr(0, entry.first.find('/')));
  return names;
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
