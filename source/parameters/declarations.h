// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/parameters/parameters.h>

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
  explicit Declarations(Parameters &parameters);

  /**
   * Sets one entry, an empty value means its default; throws InputError if it is unknown or its
   * value is not allowed.
   * @return whether the value differs from the default.
   */
  bool assign(const std::string &path, const std::string &value, const std::string &where);

  /** The names of all subsections. */
  std::set<std::string> sections() const;

  /** Every entry with its present value, with help and units (@p with_help) or without. */
  std::string print(bool with_help) const;

private:
  template <typename T>
  void add(const std::string &name, T &value, const std::string &help);
  template <typename T, typename Pattern>
  void add(const std::string &name,
           T &value,
           const std::string &help,
           const Pattern &pattern,
           const std::string &allowed);
  void enter(const std::string &section);
  void leave();

  void declare_scene(Parameters &parameters);
  void declare_geometry(GeometryParameters &geometry);
  void declare_material(MaterialParameters &material);
  void declare_boundary(BoundaryParameters &boundary);
  void declare_data(Parameters &parameters);
  void declare_discretization(DiscretizationParameters &discretization);
  void declare_solver(SolverParameters &solver);
  void declare_output(OutputParameters &output);
  [[noreturn]] void refuse_unknown(const std::string &path, const std::string &where) const;

  mutable dealii::ParameterHandler handler_;
  std::string section_;
  std::map<std::string, std::string> allowed_;
  std::map<std::string, std::string> defaults_;
};
} // namespace Signorini
