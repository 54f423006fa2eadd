// SPDX-License-Identifier: LGPL-2.1-or-later
// From the text of a parameter file and overrides to checked plain values.

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>
#include <signorini/parameters/parameter_text.h>
#include <signorini/parameters/parameters.h>

#include "declarations.h"

namespace Signorini
{
namespace
{
/** The subsections that describe a scene, and that a catalogue scene fixes. */
const std::vector<std::string> sections_of_scene =
  {"Constants", "Geometry", "Material", "Boundary", "Load", "Contact", "Exact solution"};

/** What can be judged without knowing the scene: contradictions between plain values. */
void check(const Parameters &parameters)
{
  const DiscretizationParameters &discretization = parameters.discretization;
  if (discretization.finest_level < discretization.coarsest_level)
    throw InputError(discretization.finest_level.where() + ": found '" +
                     std::to_string(discretization.finest_level) +
                     "', allowed: an integer not below " + discretization.coarsest_level.name +
                     " = " + std::to_string(discretization.coarsest_level) + ".");
  if (parameters.output.lemmas && !parameters.output.errors)
    throw InputError(parameters.output.lemmas.where() + ": found 'true' beside " +
                     parameters.output.errors.name + " = false, allowed: both, or false.");
}
} // namespace

Parameters parse_parameters(const std::string &text,
                            const std::string &file_name,
                            const std::vector<std::string> &overrides)
{
  Parameters parameters;
  parameters.file_name = file_name;
  Declarations declarations(parameters);
  std::vector<Assignment> assignments =
    scan_parameter_text(text, file_name, declarations.sections());
  for (const std::string &argument : overrides)
    assignments.push_back(scan_override(argument));
  for (const Assignment &assignment : assignments)
    declarations.assign(assignment);
  parameters.changes_of_scene = declarations.changes(sections_of_scene);
  check(parameters);
  parameters.echo = declarations.print(false);
  return parameters;
}

Parameters read_parameters(const std::string &file_name, const std::vector<std::string> &overrides)
{
  return parse_parameters(read_text_file(file_name), file_name, overrides);
}

std::string describe_parameters()
{
  Parameters defaults;
  return Declarations(defaults).print(true);
}
} // namespace Signorini
