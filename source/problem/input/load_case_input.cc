// SPDX-License-Identifier: LGPL-2.1-or-later
// "force 0 to 3 in 100 cases, weight 1 | travel 2": lists and ranges of load cases.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "input.h"

namespace Signorini {
namespace {
constexpr unsigned int max_cases = 100000;

/** Returns why a number of load cases could change nothing; empty if it could. */
template <int dim>
std::string uselessness(const CaseFactor &factor, const Scene<dim> &scene) {
  if (factor.name.rfind("shift", 0) == 0)
    for (const ContactCondition<dim> &contact : scene.contacts)
      if (contact.foundation == nullptr)
        return "the side '" + scene.geometry.sides[contact.side].name() +
               "' has no Contact/Foundation that could be moved";
  const bool slides = std::any_of(scene.contacts.begin(), scene.contacts.end(),
                                  [](const auto &contact) { return contact.shift != nullptr; });
  const bool acts = factor.kind ? has_load(scene, *factor.kind) : factor.name != "slide" || slides;
  return acts ? "" : "the scene has " + factor.missing_data;
}

/** Reads a whole number from @p min to @p max; returns 0 if it is none. */
unsigned int whole_number(const Entry &entry, const std::string &text, const double min,
                          const double max) {
  double number = 0.;
  const bool is_whole = read_number(entry, text, number) && number == std::floor(number);
  return is_whole && number >= min && number <= max ? static_cast<unsigned int>(number) : 0;
}

/** Reads one entry between '|': one case, or a range of them. */
template <int dim>
void read_cases(const std::string &entry, const Given<std::string> &given, const Scene<dim> &scene,
                std::vector<LoadCase> &cases) {
  const auto require = [&](const bool is_allowed, const std::string &found,
                           const std::string &allowed) {
    if (!is_allowed)
      throw error_at(given, "found ", quote(found), " in ", quote(entry), ", allowed: ", allowed,
                     ".");
  };
  std::string text = entry;
  unsigned int n = 1;
  const std::vector<std::string> all = split_words(text);
  if (all.size() >= 3 && all.back() == "cases" && all[all.size() - 3] == "in") {
    n = whole_number(given, all[all.size() - 2], 2., max_cases);
    require(n > 0, all[all.size() - 2], "2 to " + std::to_string(max_cases) + " cases");
    text = text.substr(0, text.rfind("in "));
  }
  if (cases.size() + n > max_cases)
    throw error_at(given, "found more than ", max_cases, " cases, allowed: at most that many.");
  const std::size_t first = cases.size();
  cases.resize(first + n);
  std::vector<CaseFactor> factors = case_factors();
  if (dim == 2)
    factors.pop_back();
  std::vector<std::string> names;
  for (const CaseFactor &factor : factors)
    names.push_back(factor.name);
  for (const std::string &part : split_list(text, ',')) {
    const auto factor = std::find_if(factors.begin(), factors.end(), [&](const CaseFactor &known) {
      return part.rfind(known.name + " ", 0) == 0;
    });
    require(factor != factors.end(), part,
            "one of " + join(names) +
              ", a blank and a number; what changes the stiffness needs a run of its own "
              "(--sweep)");
    const std::string useless = uselessness(*factor, scene);
    if (!useless.empty())
      throw error_at(given, "found the factor '", factor->name, "', but ", useless, ".");
    const std::vector<std::string> words = split_words(part.substr(factor->name.size()));
    double from = 0., to = 0.;
    const bool is_range = words.size() == 3 && words[1] == "to";
    require(words.size() == 1 || is_range, part,
            "one number, or two with 'to' between them and 'in 100 cases' at the end, and a comma "
            "before the next factor");
    require(!is_range || n > 1, part, "a range with the number of its cases, 'in 100 cases'");
    require(read_number(given, words.front(), from), words.front(), "a number");
    require(read_number(given, words.back(), to), words.back(), "a number");
    require(std::max(std::abs(from), std::abs(to)) <= max_magnitude, part,
            "numbers up to " + number_text(max_magnitude));
    for (unsigned int i = 0; i < n; ++i) {
      const double t = n > 1 ? static_cast<double>(i) / (n - 1) : 0.;
      cases[first + i].*factor->number = (1. - t) * from + t * to;
    }
  }
}
} // namespace

template <int dim>
std::vector<LoadCase> read_load_cases(const LoadCasesParameters &given, const Scene<dim> &scene) {
  std::vector<LoadCase> cases;
  for (const std::string &entry : split_list(given.cases, '|'))
    read_cases(entry, given.cases, scene, cases);
  for (const std::string &word : split_words(given.fields)) {
    const unsigned int number =
      whole_number(given.fields, word, 1., static_cast<double>(cases.size()));
    if (number == 0)
      throw input_error(
        given.fields.where() + ": found " + quote(word) + ", allowed: numbers of cases, " +
        (cases.empty() ? "of which there are none" : "from 1 to " + std::to_string(cases.size())) +
        ".");
    cases[number - 1].has_fields = true;
  }
  return cases;
}

INSTANTIATE_FUNCTION(read_load_cases);
} // namespace Signorini
