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
/** What can be judged without knowing the scene: contradictions between plain values. */
void check(const Parameters &parameters)
{
  const DiscretizationParameters &discretization = parameters.discretization;
  if (discretization.finest_level < discretization.coarsest_level)
    throw InputError(parameters.where("Discretization/Finest level") + ": found '" +
                     std::to_string(discretization.finest_level) +
                     "', allowed: an integer not below Discretization/Coarsest level = " +
                     std::to_string(discretization.coarsest_level) + ".");
  if (parameters.output.lemmas && !parameters.output.errors)
    throw InputError(parameters.where("Output/Lemmas") +
                     ": found 'true' beside Output/Errors = false, allowed: both, or false.");
}
} // namespace

std::string Parameters::where(const std::string &path) const
{
  const auto place = places.find(path);
  return (place == places.end() ? file_name : place->second) + ": " + shorten(path);
}

bool Parameters::changed(const std::string &path) const
{
  return changes.count(path) > 0;
}

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
  {
    parameters.places[assignment.path] = assignment.place;
    if (declarations.assign(assignment.path, assignment.value, parameters.where(assignment.path)))
      parameters.changes.insert(assignment.path);
    else
      parameters.changes.erase(assignment.path);
  }
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
