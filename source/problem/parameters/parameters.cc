// SPDX-License-Identifier: LGPL-2.1-or-later
// From the text of a parameter file and overrides to checked plain values.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/formulas/expression.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/parameters/parameter_text.h>
#include <signorini/problem/parameters/parameters.h>

#include <algorithm>
#include <filesystem>

#include "declarations.h"

namespace Signorini {
namespace {
/** The subsections that describe a scene, and that a catalogue scene fixes. */
const std::vector<std::string> sections_of_scene = {
  "Constants", "Geometry", "Material", "Boundary", "Load", "Contact", "Exact solution"};

const std::string constants_section = "Constants/", constants_path = "Constants/Values";

const std::string mesh_file_path = "Geometry/File";

/** The entries that name files. */
bool is_file(const std::string &path) {
  return path == mesh_file_path || path == "Verify/File";
}

/** Returns the names of the list "E=1, nu=0.3". */
std::vector<std::string> names_of(const std::string &list) {
  std::vector<std::string> names;
  for (const std::string &part : split_list(list, ','))
    names.push_back(trim(part.substr(0, part.find('='))));
  return names;
}

/** Returns the name of the constant that an override changes, Constants/NAME=value or NAME=value;
 * empty for others. */
std::string constant_of(const Assignment &assignment, const std::string &list) {
  const std::vector<std::string> names = names_of(list);
  if (std::count(names.begin(), names.end(), assignment.path) > 0)
    return assignment.path;
  return assignment.path.rfind(constants_section, 0) == 0 && assignment.path != constants_path
           ? trim(assignment.path.substr(constants_section.size()))
           : "";
}

/** Returns the list "E=1, nu=0.3" with another value of one name. @throws InputError if it lacks
 * it. */
std::string with_constant(const std::string &list, const std::string &name,
                          const Assignment &assignment) {
  std::vector<std::string> parts = split_list(list, ',');
  const std::vector<std::string> names = names_of(list);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw input_error(
      assignment.origin + ": found the constant " + quote(name) + hint_for(name, names) +
      ", allowed: " + (names.empty() ? constants_path + ", which is empty" : join(names)) + ".");
  const std::vector<std::string> values = split_list(assignment.value, ',');
  if (values.size() != 1)
    throw input_error(assignment.origin, ": ", assignment.path, ": found ", quote(assignment.value),
                      ", allowed: one value.");
  parts[found - names.begin()] = name + "=" + values[0];
  return join(parts);
}

/** Adds the values of an option of the command line. */
void add_overrides(const std::vector<std::string> &overrides, const std::string &option,
                   std::vector<Assignment> &assignments) {
  for (const std::string &argument : overrides) {
    Assignment override = scan_override(argument, option);
    std::string list;
    for (const Assignment &assignment : assignments)
      if (assignment.path == constants_path)
        list = assignment.value;
    const std::string name = constant_of(override, list);
    if (!name.empty()) {
      override.value = with_constant(list, name, override);
      override.path = constants_path;
    }
    assignments.push_back(override);
  }
}

/** Returns where a named file is: in @p folder or in the working folder. The name is unchanged if
 * the file is in neither. */
std::string find_file(const std::string &name, const std::string &folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  for (const fs::path &candidate : {fs::path(folder) / name, fs::path(name)})
    if (!name.empty() && fs::exists(candidate, error)) {
      const fs::path absolute = fs::absolute(candidate, error).lexically_normal();
      return error ? candidate.string() : absolute.string();
    }
  return name;
}

const std::string geometry_section = "Geometry/", bodies_path = "Geometry/Bodies";

/** Returns the values of "upper: 1 | lower: 2" by body; empty if the text is one value for all. A
 * part that begins with no body belongs to the one before it. */
std::map<std::string, std::string> values_by_body(const std::string &text,
                                                  const std::set<std::string> &bodies) {
  std::map<std::string, std::string> values;
  std::string body;
  for (const std::string &part : split_list(text, '|')) {
    const std::size_t colon = part.find(':');
    const std::string name = trim(part.substr(0, colon));
    if (colon != std::string::npos && bodies.count(name) > 0)
      values[body = name] = trim(part.substr(colon + 1));
    else if (!body.empty())
      values[body] += " | " + part;
  }
  return values;
}

/** Returns the geometry of one of several bodies. */
GeometryParameters read_body(const std::string &name, const std::set<std::string> &bodies,
                             const std::vector<Assignment> &assignments,
                             const std::shared_ptr<const Constants> &constants,
                             const Parameters &parameters) {
  Parameters body;
  body.file_name = parameters.file_name;
  body.geometry.folder = parameters.geometry.folder;
  Declarations declarations(body);
  declarations.set_constants(constants);
  for (Assignment assignment : assignments) {
    if (assignment.path.rfind(geometry_section, 0) != 0)
      continue;
    const auto values = values_by_body(assignment.value, bodies);
    if (const auto own = values.find(name); own != values.end())
      assignment.value = own->second;
    if (assignment.path == mesh_file_path)
      assignment.value = find_file(assignment.value, body.geometry.folder);
    if (values.empty() || values.count(name) > 0)
      declarations.assign(assignment);
  }
  return body.geometry;
}

/** Checks the names of bodies. */
void check_names(const std::vector<std::string> &names, const std::string &where) {
  // Their motions are unknowns of one dense matrix, whose factors cost the cube of their number.
  constexpr std::size_t most = 500;
  if (names.size() > most)
    throw input_error(where, ": found ", names.size(), " bodies, allowed: at most ", most,
                      ", since the time grows like the cube of their number.");
  for (const std::string &name : names) {
    if (std::count(names.begin(), names.end(), name) > 1)
      throw input_error(where, ": found '", name, "' twice, allowed: bodies with different names.");
    // A name ends at these in 'name: value | ...' and 'name.side with name.side'.
    if (name.find_first_of(".:|") != std::string::npos || name == "with")
      throw input_error(where, ": found '", name,
                        "', allowed: names other than 'with', without '.', ':' and '|'.");
  }
}

/** Checks plain values for contradictions that do not depend on the scene. */
void check(const Parameters &parameters) {
  const DiscretizationParameters &discretization = parameters.discretization;
  if (parameters.dimension == 3 && !parameters.bodies.empty())
    throw error_at(parameters.geometry.bodies, "found '", parameters.geometry.bodies.value,
                   "' with ", parameters.dimension.name, " = 3, allowed with it: one body.");
  if (discretization.strategy != Strategy::hp &&
      discretization.finest_level < discretization.coarsest_level)
    throw error_at(discretization.finest_level, "found '", discretization.finest_level,
                   "', allowed: an integer not below ", discretization.coarsest_level.name, " = ",
                   discretization.coarsest_level, ".");
  if (parameters.output.lemmas && !parameters.output.errors)
    throw error_at(parameters.output.lemmas, "found 'true' beside ", parameters.output.errors.name,
                   " = false, allowed: both, or false.");
}
} // namespace

Parameters parse_parameters(const std::string &text, const std::string &file_name,
                            const std::vector<std::string> &overrides, const std::string &folder,
                            const std::vector<std::string> &swept) {
  Parameters parameters;
  parameters.file_name = file_name;
  parameters.geometry.folder = folder;
  Declarations declarations(parameters);
  std::vector<Assignment> assignments =
    scan_parameter_text(text, file_name, declarations.sections());
  add_overrides(overrides, "--set", assignments);
  add_overrides(swept, "--sweep", assignments);
  std::vector<std::string> bodies;
  auto constants = std::make_shared<const Constants>();
  for (const Assignment &assignment : assignments)
    if (assignment.path == constants_path)
      constants = std::make_shared<const Constants>(
        read_constants(assignment.value, assignment.origin + ": " + constants_path));
    else if (assignment.path == bodies_path) {
      bodies = split_words(assignment.value);
      check_names(bodies, assignment.origin + ": " + bodies_path);
    }
  declarations.set_constants(constants);
  const std::set<std::string> names(bodies.begin(), bodies.end());
  for (const std::string &name : bodies)
    parameters.bodies.push_back(read_body(name, names, assignments, constants, parameters));
  for (Assignment &assignment : assignments) {
    const auto values = assignment.path.rfind(geometry_section, 0) == 0
                          ? values_by_body(assignment.value, names)
                          : std::map<std::string, std::string>();
    if (!values.empty()) {
      std::vector<std::string> files;
      for (const auto &[body, file] : values)
        if (assignment.path == mesh_file_path)
          files.push_back(body + ": " + find_file(file, folder));
      if (!files.empty())
        assignment.value = join(files, " | ");
      declarations.assign_by_body(assignment);
      continue;
    }
    if (is_file(assignment.path))
      assignment.value = find_file(assignment.value, folder);
    declarations.assign(assignment);
  }
  parameters.changes_of_scene = declarations.changes(sections_of_scene);
  check(parameters);
  parameters.echo = declarations.print(false);
  return parameters;
}

Parameters read_parameters(const std::string &file_name,
                           const std::vector<std::string> &overrides) {
  return parse_parameters(read_text_file(file_name), shorten_path(file_name), overrides,
                          std::filesystem::path(file_name).parent_path().string());
}

std::string describe_parameters(const std::vector<std::string> &sections) {
  Parameters defaults;
  const Declarations declarations(defaults);
  const std::string all = declarations.print(true);
  const std::set<std::string> known = declarations.sections();
  std::string text = sections.empty() ? all : "";
  for (const std::string &section : sections) {
    if (known.count(section) == 0)
      throw input_error("command line: found the subsection ", quote(section),
                        ", allowed: ", join({known.begin(), known.end()}), ".");
    const std::string end = "\nend\n";
    const std::size_t begin = all.find("subsection " + section + "\n");
    text += all.substr(begin, all.find(end, begin) + end.size() - begin);
  }
  return text;
}
} // namespace Signorini
