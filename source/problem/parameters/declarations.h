// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/parameters/parameter_text.h>
#include <signorini/problem/parameters/parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <set>
#include <string>

namespace Signorini
{
/**
 * Binds the entries of a ParameterHandler to the members of a Parameters value.
 *
 * deal.II's handler keeps patterns, defaults and help; this class adds the two things a good
 * message needs: the set of known paths, and the allowed values in words.
 */
class Declarations
{
public:
  /** Declares every entry, with its name, and with the file as its place. */
  explicit Declarations(Parameters &parameters);

  /**
   * Sets one entry; an empty value means its default.
   * @throws InputError if the entry is unknown or its value is not allowed.
   */
  void assign(const Assignment &assignment);

  /** Returns the names of all subsections. */
  std::set<std::string> sections() const;

  /** Returns the entries of these subsections that are not at their defaults. */
  std::vector<Entry> changes(const std::vector<std::string> &sections) const;

  /** Returns every entry with its present value, with help and units (@p with_help) or without. */
  std::string print(bool with_help) const;

private:
  /** The data of an entry that deal.II's handler does not store. */
  struct Declared
  {
    /** The allowed values in words. */
    std::string allowed;
    std::string default_text;
    /** The entry's member of the Parameters. */
    Entry *entry;
  };

  template <typename T, typename Pattern>
  void add(const std::string &name,
           Given<T> &given,
           const std::string &help,
           const Pattern &pattern,
           const std::string &allowed);
  /** Adds an entry that may be any text. */
  void add(const std::string &name, Given<std::string> &given, const std::string &help);
  /** Adds an option, which is one of its names. */
  template <typename Option>
  void add(const std::string &name, Given<Option> &given, const std::string &help);
  /** Adds the data of an entry that the handler has declared. */
  void add_entry(const std::string &name, const std::string &allowed, Entry &entry);
  void enter(const std::string &section);
  void leave();

  void declare_scene(Parameters &parameters);
  void declare_geometry(GeometryParameters &geometry);
  void declare_material(MaterialParameters &material);
  void declare_boundary(BoundaryParameters &boundary);
  void declare_data(Parameters &parameters);
  void declare_discretization(DiscretizationParameters &discretization);
  /** Declares the entries of Discretization for Strategy = hp. */
  void declare_graded_meshes(DiscretizationParameters &discretization);
  void declare_solver(SolverParameters &solver);
  void declare_output(OutputParameters &output);
  [[noreturn]] void refuse_unknown(const Assignment &assignment) const;

  mutable ParameterHandler handler_;
  std::string file_name_;
  std::string section_;
  /** The entries by subsection and name. */
  std::map<std::string, Declared> declared_;
};

template <typename T, typename Pattern>
void Declarations::add(const std::string &name,
                       Given<T> &given,
                       const std::string &help,
                       const Pattern &pattern,
                       const std::string &allowed)
{
  handler_.add_parameter(name, given.value, help + " Allowed: " + allowed + ".", pattern);
  add_entry(name, allowed, given);
}

template <typename Option>
void Declarations::add(const std::string &name, Given<Option> &given, const std::string &help)
{
  const std::string allowed = list_names<Option>(", ");
  handler_.declare_entry(name,
                         to_text(given.value),
                         Patterns::Selection(list_names<Option>("|")),
                         help + " Allowed: " + allowed + ".");
  handler_.add_action(name,
                      [&given](const std::string &text) { given.value = from_text<Option>(text); });
  add_entry(name, allowed, given);
}
} // namespace Signorini
