// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/parameters/parameter_text.h>
#include <signorini/problem/parameters/parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <type_traits>

namespace Signorini {
/**
 * Binds the entries of a ParameterHandler to the members of a Parameters value.
 *
 * deal.II's handler keeps patterns, defaults and help; this class adds the two things a good
 * message needs: the set of known paths, and the allowed values in words.
 */
class Declarations {
public:
  /** Declares every entry, with its name, and with the file as its origin. */
  explicit Declarations(Parameters &parameters);

  /**
   * Sets one entry.
   * @throws InputError if the entry is unknown or its value is not allowed.
   */
  void assign(const Assignment &assignment);

  /** Takes the value of an entry that has one for each body, for print() alone. @throws InputError
   * if the entry is unknown. */
  void assign_by_body(const Assignment &assignment);

  /** Sets the constants that numbers of all entries may be made of. */
  void set_constants(const std::shared_ptr<const Constants> &constants);

  /** Returns the names of all subsections. */
  std::set<std::string> sections() const;

  /** Returns the entries of these subsections that are not at their defaults. */
  std::vector<Entry> changes(const std::vector<std::string> &sections) const;

  /** Returns every entry with its present value, with help and units (@p with_help) or without. */
  std::string print(bool with_help) const;

private:
  /** The data of an entry that deal.II's handler does not store. */
  struct Declared {
    /** The allowed values in words. */
    std::string allowed;
    std::string default_text;
    /** Whether the value is a number, or a list of numbers. */
    bool is_numeric;
    /** The entry's member of the Parameters. */
    Entry *entry;
  };

  /** Adds an entry that may be any text. */
  void add(const std::string &path, Given<std::string> &given, const std::string &help);
  void add(const std::string &path, Given<bool> &given, const std::string &help);
  /** Adds a list of numbers. */
  void add(const std::string &path, Given<std::vector<double>> &given, const std::string &help);
  /** Adds a number between two bounds. */
  template <typename Number>
  void add(const std::string &path, Given<Number> &given, const std::string &help, Number min,
           Number max, std::string allowed = "");
  /** Adds an option, which is one of its names. */
  template <typename Option>
  void add(const std::string &path, Given<Option> &given, const std::string &help);
  /** Adds an entry whose value @p set takes from a text. */
  void add(const std::string &path, Entry &entry, const std::string &default_text,
           const std::string &help, const Patterns::PatternBase &pattern,
           const std::string &allowed, const std::function<void(const std::string &)> &set);
  /** Adds an entry whose values deal.II reads by its pattern. */
  template <typename T>
  void add(const std::string &path, Given<T> &given, const std::string &help,
           const Patterns::PatternBase &pattern, const std::string &allowed);
  /** Calls @p act with the name of an entry inside of its subsection. */
  void in_section(const std::string &path,
                  const std::function<void(const std::string &)> &act) const;

  void declare_scene(Parameters &parameters);
  void declare_geometry(GeometryParameters &geometry);
  void declare_material(MaterialParameters &material);
  void declare_boundary(BoundaryParameters &boundary);
  void declare_load(LoadParameters &load);
  void declare_contact(ContactParameters &contact);
  void declare_load_cases(LoadCasesParameters &load_cases);
  void declare_exact_solution(ExactSolutionParameters &exact);
  void declare_discretization(DiscretizationParameters &discretization);
  void declare_solver(SolverParameters &solver);
  void declare_output(OutputParameters &output);
  void declare_verify(VerifyParameters &verify);

  /** Returns the declaration of an entry, and notes its origin. @throws InputError */
  const Declared &find(const Assignment &assignment);

  mutable ParameterHandler handler_;
  /** The texts of entries with a value for each body. */
  std::map<std::string, std::string> by_body_;
  std::string file_name_;
  /** The entries by subsection and name. */
  std::map<std::string, Declared> declared_;
};

template <typename Number>
void Declarations::add(const std::string &path, Given<Number> &given, const std::string &help,
                       const Number min, const Number max, std::string allowed) {
  constexpr bool is_integer = std::is_integral_v<Number>;
  if (allowed.empty())
    allowed = concatenate(is_integer ? "an integer" : "a number", " from ", min, " to ", max);
  using Pattern = std::conditional_t<is_integer, Patterns::Integer, Patterns::Double>;
  add(path, given, help, Pattern(min, max), allowed);
  declared_[path].is_numeric = true;
}

template <typename T>
void Declarations::add(const std::string &path, Given<T> &given, const std::string &help,
                       const Patterns::PatternBase &pattern, const std::string &allowed) {
  using Convert = Patterns::Tools::Convert<T>;
  const std::shared_ptr<const Patterns::PatternBase> form(pattern.clone());
  add(path, given, Convert::to_string(given.value, pattern), help, pattern, allowed,
      [&given, form](const std::string &text) { given.value = Convert::to_value(text, *form); });
}

template <typename Option>
void Declarations::add(const std::string &path, Given<Option> &given, const std::string &help) {
  const std::vector<std::string> &names = option_names(typeid(Option));
  add(path, given, to_text(given.value), help, Patterns::Selection(join(names, "|")), join(names),
      [&](const std::string &text) {
        given.value =
          static_cast<Option>(std::find(names.begin(), names.end(), text) - names.begin());
      });
}
} // namespace Signorini
