// SPDX-License-Identifier: LGPL-2.1-or-later
// "force 0 to 3 in 100 cases, weight 1 | travel 2": lists and ranges of load cases.

#include "load_case_input.h"

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
constexpr unsigned int most_cases = 100000;

/** One factor, or a range of it. */
struct CaseFactor
{
  std::string name;
  double from;
  double to;
};

const std::vector<std::string> &factor_names()
{
  static const std::vector<std::string> names = {
    "force", "weight", "travel", "gap", "shift x", "shift y"};
  return names;
}

double &factor_of(LoadCase &load_case, const std::string &name)
{
  if (name == "force")
    return load_case.force;
  if (name == "weight")
    return load_case.weight;
  if (name == "travel")
    return load_case.travel;
  if (name == "gap")
    return load_case.gap;
  return load_case.shift[name == "shift x" ? 0 : 1];
}

/** Reads the entries of one parameter. */
class CaseReader
{
public:
  CaseReader(const Given<std::string> &given, const Scene<2> &scene)
    : given_(given)
    , scene_(scene)
  {
  }

  /** Reads one entry between '|'. */
  void read(const std::string &entry, std::vector<LoadCase> &cases) const
  {
    std::string text = entry;
    const unsigned int n = take_count(text);
    std::vector<CaseFactor> factors;
    for (const std::string &part : split_list(text, ','))
      factors.push_back(read_factor(part, entry));
    if (cases.size() + n > most_cases)
      throw InputError(given_.where() + ": found more than " + std::to_string(most_cases) +
                       " cases, allowed: at most that many.");
    for (unsigned int i = 0; i < n; ++i)
    {
      LoadCase load_case;
      const double t = n > 1 ? static_cast<double>(i) / (n - 1) : 0.;
      for (const CaseFactor &factor : factors)
        factor_of(load_case, factor.name) = (1. - t) * factor.from + t * factor.to;
      cases.push_back(load_case);
    }
    for (const CaseFactor &factor : factors)
      if (factor.from != factor.to && n == 1)
        refuse(entry);
  }

private:
  [[noreturn]] void refuse(const std::string &entry) const
  {
    throw InputError(given_.where() + ": found " + quote(entry) +
                     ", allowed: entries separated by '|' like force 0.5, weight 2 or force 0 to "
                     "3 in 100 cases, with the names " +
                     join(factor_names()) +
                     "; what changes the stiffness needs a run of its own (--sweep).");
  }

  /** Takes "in n cases" off the end. @return n, or 1. */
  unsigned int take_count(std::string &text) const
  {
    const std::vector<std::string> words = split_words(text);
    const std::size_t n = words.size();
    if (n < 3 || words[n - 1] != "cases" || words[n - 3] != "in")
      return 1;
    std::vector<double> count;
    if (!read_numbers(words[n - 2], count) || count.size() != 1 || !(count[0] >= 2.) ||
        !(count[0] <= most_cases) || count[0] != std::floor(count[0]))
      refuse(text);
    text = text.substr(0, text.rfind("in "));
    return static_cast<unsigned int>(count[0]);
  }

  CaseFactor read_factor(const std::string &part, const std::string &entry) const
  {
    for (const std::string &name : factor_names())
      if (part.compare(0, name.size() + 1, name + " ") == 0)
      {
        check(name);
        const std::vector<std::string> words = split_words(part.substr(name.size()));
        const bool is_range = words.size() == 3 && words[1] == "to";
        if (words.size() != 1 && !is_range)
          refuse(entry);
        return {name, number(words.front(), entry), number(words.back(), entry)};
      }
    refuse(entry);
  }

  double number(const std::string &word, const std::string &entry) const
  {
    std::vector<double> value;
    if (!read_numbers(word, value) || value.size() != 1 ||
        !(std::abs(value[0]) <= largest_magnitude))
      refuse(entry);
    return value[0];
  }

  /** Refuses a factor that could change nothing. */
  void check(const std::string &name) const
  {
    const auto refuse_name = [&](const std::string &what) {
      throw InputError(given_.where() + ": found the factor '" + name + "', but " + what + ".");
    };
    const bool is_shift = name == "shift x" || name == "shift y";
    if (is_shift)
      for (const unsigned int side : scene_.contact_sides())
        if (scene_.boundary[side].foundation == nullptr)
          refuse_name("the side '" + scene_.geometry.sides[side].name() +
                      "' has no Contact/Foundation that could be moved");
    if (name == "force" && !has_load(scene_, LoadKind::force))
      refuse_name("the scene has neither tractions nor plates with a force");
    if (name == "weight" && !has_load(scene_, LoadKind::weight))
      refuse_name("the scene has no body force");
    if (name == "travel" && !has_load(scene_, LoadKind::travel))
      refuse_name("the scene has no prescribed displacement");
  }

  const Given<std::string> &given_;
  const Scene<2> &scene_;
};

/** Marks the cases whose fields are written. */
void read_fields(const Given<std::string> &given, std::vector<LoadCase> &cases)
{
  for (const std::string &word : split_words(given.value))
  {
    std::vector<double> number;
    if (!read_numbers(word, number) || number.size() != 1 || number[0] != std::floor(number[0]) ||
        !(number[0] >= 1.) || !(number[0] <= static_cast<double>(cases.size())))
      throw InputError(
        given.where() + ": found " + quote(word) + ", allowed: numbers of cases, " +
        (cases.empty() ? "of which there are none" : "from 1 to " + std::to_string(cases.size())) +
        ".");
    cases[static_cast<std::size_t>(number[0]) - 1].has_fields = true;
  }
}
} // namespace

std::vector<LoadCase> read_load_cases(const LoadCasesParameters &given, const Scene<2> &scene)
{
  std::vector<LoadCase> cases;
  const CaseReader reader(given.cases, scene);
  if (!given.cases.value.empty())
    for (const std::string &entry : split_list(given.cases, '|'))
      reader.read(entry, cases);
  read_fields(given.fields, cases);
  return cases;
}
} // namespace Signorini
