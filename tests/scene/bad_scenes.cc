// SPDX-License-Identifier: LGPL-2.1-or-later
// What the program refuses before any work, and how: each message is one sentence on one line that
// begins with the place and the parameter, and names what was found or what is allowed.

#include <signorini/parameters/exceptions.h>
#include <signorini/parameters/parameters.h>
#include <signorini/scene/scene.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "tests.h"

using namespace Signorini;

namespace
{
/** Settings on top of a good scene, the parameter that the message must name, and what it says. */
struct BadScene
{
  std::vector<std::string> settings;
  std::string path;
  std::string fragment;
};

const std::string polygon = "Geometry/Shape=polygon";
const std::string held = "Boundary/Clamped=side2";
const std::string touching = "Boundary/Contact=side0";

const std::vector<BadScene> bad_parameters = {
  {{"Dimension=3"}, "Dimension", "found '3', allowed: 2."},
  {{"Scene/Nme=A1"}, "Scene/Nme", "unknown parameter; did you mean 'Scene/Name'?"},
  {{"Tolerance=1"}, "Tolerance", "unknown parameter; did you mean"},
  {{"Boundary/contact=top"}, "Boundary/contact", "did you mean 'Boundary/Contact'?"},
  {{"Geometry/Shape=disc"}, "Geometry/Shape", "found 'disc', allowed: rectangle, polygon."},
  {{"Geometry/Shape=file"}, "Geometry/Shape", "found 'file', allowed: rectangle, polygon."},
  {{"Geometry/File=body.msh"}, "Geometry/File", "not available yet"},
  {{"Geometry/Distortion=0.5"}, "Geometry/Distortion", "found '0.5', allowed: a number from 0"},
  {{"Material/Law=hyperelastic"}, "Material/Law", "allowed: isotropic, orthotropic, general."},
  {{"Discretization/Coarsest level=4", "Discretization/Finest level=3"},
   "Discretization/Finest level",
   "found '3', allowed: an integer not below Discretization/Coarsest level = 4."},
  {{"Discretization/Finest level=15"}, "Discretization/Finest level", "from 0 to 14"},
  {{"Discretization/Patch ratio=0"}, "Discretization/Patch ratio", "found '0', allowed"},
  {{"Discretization/Kinks at x=0.5; 0.7"}, "Discretization/Kinks at x", "numbers separated"},
  {{"Solver/Contact solver=mprgp"}, "Solver/Contact solver", "allowed: psor, active set."},
  {{"Solver/Linear solver=cholmod"}, "Solver/Linear solver", "found 'cholmod', allowed: "},
  {{"Solver/Linear solver=amg"}, "Solver/Linear solver", "found 'amg', allowed: automatic"},
  {{"Solver/Relaxation=0"}, "Solver/Relaxation", "found '0', allowed: a number between 0 and 2"},
  {{"Solver/Relaxation=2"}, "Solver/Relaxation", "found '2', allowed: a number between 0 and 2"},
  {{"Solver/Relaxation=-1.1"}, "Solver/Relaxation", "(both excluded)"},
  {{"Solver/Tolerance=0"}, "Solver/Tolerance", "found '0', allowed: a number from"},
  {{"Solver/Maximum iterations=-5"}, "Solver/Maximum iterations", "a positive integer"},
  {{"Output/Inf-sup constant=on"}, "Output/Inf-sup constant", "found 'on', allowed: "}};

const std::vector<BadScene> bad_expressions = {
  {{"Contact/Gap=x +"}, "Contact/Gap", "the expression 'x +' cannot be parsed: "},
  {{"Contact/Gap=1,2"}, "Contact/Gap", "a comma stands outside of a function's parentheses."},
  {{"Contact/Gap=x=3"}, "Contact/Gap", "comparisons are written '=='."},
  {{"Contact/Gap=unknown"}, "Contact/Gap", "Unexpected token \"unknown\""},
  {{"Contact/Gap=z"}, "Contact/Gap", "the expression 'z' cannot be parsed"},
  {{"Contact/Gap=0; 0"}, "Contact/Gap", "found 2 component(s) in '0; 0', allowed: 1 expression."},
  {{"Contact/Gap=sqrt(-1-x)"}, "Contact/Gap", "allowed: finite values"},
  {{"Contact/Gap=1/(y-y)"}, "Contact/Gap", "component 1 has the value inf at ("},
  {{"Load/Body force=1"}, "Load/Body force", "found 1 component(s) in '1', allowed: 2"},
  {{"Load/Body force=0; 0; 0"}, "Load/Body force", "found 3 component(s)"},
  {{"Load/Body force=0; 0/0"}, "Load/Body force", "component 2 has the value"},
  {{"Load/Body force=log(x-2); 0"}, "Load/Body force", "component 1 has the value"},
  {{"Boundary/Traction=left: 1"}, "Boundary/Traction", "found 1 component(s) in '1', allowed: 2"},
  {{"Boundary/Traction=left: 1; 0/0"}, "Boundary/Traction", "component 2 has the value"},
  {{"Boundary/Displacement=left: 0/0; 0"}, "Boundary/Displacement", "component 1 has the value"},
  {{"Constants/Values=E"}, "Constants/Values", "found 'E', allowed: name=number"},
  {{"Constants/Values=1E=2"}, "Constants/Values", "found '1E=2', allowed: name=number"},
  {{"Constants/Values=E=1, E=2"}, "Constants/Values", "the name 'E' is taken"},
  {{"Constants/Values=x=1"}, "Constants/Values", "the name 'x' is taken"},
  {{"Constants/Values=E=1; nu=0.3"}, "Constants/Values", "cannot be"},
  {{"Constants/Values=E=1/0"}, "Constants/Values", "must be a finite number, found '1/0'."},
  {{"Exact solution/Displacement=0"}, "Exact solution/Displacement", "found 1 component(s)"},
  {{"Exact solution/Displacement=0; log(-y)"}, "Exact solution/Displacement", "component 2 has"},
  {{"Exact solution/Displacement gradient=0; 0; 0; 0"},
   "Exact solution/Displacement gradient",
   "it needs Exact solution/Displacement, which is not given."},
  {{"Exact solution/Displacement=0; 0", "Exact solution/Displacement gradient=0; 0; 0"},
   "Exact solution/Displacement gradient",
   "found 3 component(s)"},
  {{"Exact solution/Displacement=0; 0", "Exact solution/Displacement gradient=0; 0; 0; 0/0"},
   "Exact solution/Displacement gradient",
   "the gradient of component 2 has no value at ("},
  {{"Exact solution/Pressure=0/0"}, "Exact solution/Pressure", "component 1 has the value"}};

const std::vector<BadScene> bad_materials = {
  {{"Material/Young's modulus=-1"}, "Material/Young's modulus", "allowed: a positive number"},
  {{"Material/Young's modulus=0"}, "Material/Young's modulus", "found 0.000000 at ("},
  {{"Material/Young's modulus=x-0.5"}, "Material/Young's modulus", "a positive number everywhere."},
  {{"Material/Young's modulus=1/0"}, "Material/Young's modulus", "a positive number everywhere."},
  {{"Material/Young's modulus=1; 2"}, "Material/Young's modulus", "found 2 component(s)"},
  {{"Material/Poisson's ratio=0.5"}, "Material/Poisson's ratio", "between -1 and 0.5 (both excl"},
  {{"Material/Poisson's ratio=0.6"}, "Material/Poisson's ratio", "between -1 and 0.5 (both excl"},
  {{"Material/Poisson's ratio=-1"}, "Material/Poisson's ratio", "between -1 and 0.5 (both excl"},
  {{"Material/Poisson's ratio=0/0"}, "Material/Poisson's ratio", "between -1 and 0.5 (both excl"},
  {{"Material/Poisson's ratio=0.3+x"}, "Material/Poisson's ratio", "(both excluded) everywhere."},
  {{"Material/Poisson's ratio=0.5", "Material/Plane state=stress"},
   "Material/Poisson's ratio",
   "found 0.500000 at ("},
  {{"Material/Law=general"}, "Material/Hooke tensor", "found 0 component(s)"},
  {{"Material/Law=general", "Material/Hooke tensor=1; 2; 0; 1; 0; 1"},
   "Material/Hooke tensor",
   "a tensor that is not positive definite"},
  {{"Material/Law=orthotropic", "Material/Orthotropic moduli=4; 1.2; 0.5"},
   "Material/Orthotropic moduli",
   "found 3 component(s)"},
  {{"Material/Law=orthotropic", "Material/Orthotropic moduli=4; 1; 0.5; -1"},
   "Material/Orthotropic moduli",
   "a tensor that is not positive definite"}};

const std::vector<BadScene> bad_geometries = {
  {{"Geometry/Lower left=0"}, "Geometry/Lower left", "found '0', allowed: two numbers"},
  {{"Geometry/Upper right=1, nan"}, "Geometry/Upper right", "found '1, nan', allowed"},
  {{"Geometry/Upper right=1, 0"}, "Geometry/Upper right", "above Lower left = 0, 0."},
  {{"Geometry/Cells=2"}, "Geometry/Cells", "found '2', allowed: two numbers"},
  {{"Geometry/Cells=0, 1"}, "Geometry/Cells", "allowed: two integers from 1 to 10000."},
  {{"Geometry/Cells=1.5, 1"}, "Geometry/Cells", "allowed: two integers from 1 to 10000."},
  {{"Geometry/Vertices=0,0; 1,0; 0,1"}, "Geometry/Vertices", "vertices belong to Shape = polygon"},
  {{polygon}, "Geometry/Vertices", "found 0 vertices, allowed: three or more"},
  {{polygon, "Geometry/Vertices=0,0; 1,0"}, "Geometry/Vertices", "found 2 vertices, allowed"},
  {{polygon, "Geometry/Vertices=0,0; 1; 0,1"}, "Geometry/Vertices", "found '1', allowed: two"},
  {{polygon, "Geometry/Vertices=0,0; 1,0; 0,1;"}, "Geometry/Vertices", "found '', allowed: two"},
  {{polygon, "Geometry/Vertices=0,0; 1,0; 1,a"}, "Geometry/Vertices", "found '1,a', allowed: two"},
  {{polygon, "Geometry/Vertices=0,0; 0,1; 1,0"},
   "Geometry/Vertices",
   "the polygon does not turn left at vertex 1; allowed: the corners of a convex polygon"},
  {{polygon, "Geometry/Vertices=0,0; 2,0; 0.5,0.5; 0,2"},
   "Geometry/Vertices",
   "the polygon does not turn left at vertex 2"},
  {{polygon, "Geometry/Vertices=0,0; 1,1; 1,0; 0,1"}, "Geometry/Vertices", "does not turn left"},
  {{polygon, "Geometry/Vertices=0,0; 1,0; 2,0; 0,1"}, "Geometry/Vertices", "left at vertex 1"},
  {{polygon, "Geometry/Vertices=0,0; 1,0; 1,0; 0,1"}, "Geometry/Vertices", "does not turn left"},
  {{polygon, "Geometry/Vertices=0,0; 0,0; 0,0"}, "Geometry/Vertices", "does not turn left"},
  {{polygon, "Geometry/Vertices=0,3; -1.8,-2.4; 2.9,0.9; -2.9,0.9; 1.8,-2.4"},
   "Geometry/Vertices",
   "the polygon crosses itself"},
  {{polygon, "Geometry/Vertices=0,0; 1,0; 0,1", "Geometry/Cells=2, 2"},
   "Geometry/Cells",
   "this entry belongs to Shape = rectangle, found Shape = polygon."},
  {{polygon, "Geometry/Vertices=0,0; 1,0; 0,1"},
   "Boundary/Clamped",
   "found the side 'top', allowed: side0, side1, side2."},
  {{polygon, "Geometry/Vertices=0,0; 1,0; 0,1", held, "Boundary/Contact=side3"},
   "Boundary/Contact",
   "found the side 'side3', allowed: side0, side1, side2."},
  {{polygon, "Geometry/Vertices=0,0; 1,0; 0,1", held, touching, "Boundary/Rollers=side2"},
   "Boundary/Rollers",
   "the side 'side2' is listed in Boundary/Clamped already"}};

const std::vector<BadScene> bad_boundaries = {
  {{"Boundary/Clamped=Top"}, "Boundary/Clamped", "allowed: left, right, bottom, top."},
  {{"Boundary/Clamped=top top"}, "Boundary/Clamped", "listed in Boundary/Clamped already"},
  {{"Boundary/Contact=top"}, "Boundary/Contact", "every side has exactly one role."},
  {{"Boundary/Contact="}, "Boundary/Contact", "no contact side is given, allowed: one or more"},
  {{"Boundary/Traction=bottom: 0; 1"}, "Boundary/Traction", "listed in Boundary/Contact already"},
  {{"Boundary/Traction=left: 0; 1 | left: 1; 0"},
   "Boundary/Traction",
   "'left' is listed in Boundary/Traction already"},
  {{"Boundary/Traction=0; 1"}, "Boundary/Traction", "found '0; 1', allowed: a side ("},
  {{"Boundary/Traction=west: 0; 1"}, "Boundary/Traction", "found 'west: 0; 1', allowed: a side"},
  {{"Boundary/Traction=left: 0; 1 |"}, "Boundary/Traction", "found '', allowed: a side ("},
  {{"Boundary/Displacement=top: 0; 0"}, "Boundary/Displacement", "Boundary/Clamped already"},
  {{"Boundary/Contact=bottom left", "Contact/Gap=bottom: 0"},
   "Contact/Gap",
   "found no entry for the contact side 'left'"},
  {{"Contact/Gap=bottom: 0 | right: 0"}, "Contact/Gap", "found an entry for 'right', allowed"},
  {{"Contact/Gap=bottom: 0 | bottom: 1"}, "Contact/Gap", "found an entry for 'bottom', allowed"},
  {{"Contact/Gap=botom: 0"}, "Contact/Gap", "found 'botom: 0', allowed: a side (left,"},
  {{"Boundary/Contact=bottom left", "Exact solution/Pressure=left: 0"},
   "Exact solution/Pressure",
   "found no entry for the contact side 'bottom'"},
  {{"Boundary/Clamped="}, "Boundary", "leave the translation along ("},
  {{"Boundary/Clamped="}, "Boundary", " and the rotation about (0.5, 0.5) of the body free"},
  {{"Boundary/Clamped=", "Boundary/Rollers=left right"},
   "Boundary",
   "leave the translation along (0, 1) of the body free"},
  {{"Scene/Name=A4"}, "Scene/Name", "found 'A4', allowed: described, A1, "},
  {{"Scene/Name=a1"}, "Scene/Name", "found 'a1', allowed: described"},
  {{"Scene/Name=A1", "Boundary/Clamped=", "Boundary/Contact=", "Geometry/Distortion=0.1"},
   "Geometry/Distortion",
   "the catalogue scene 'A1' fixes this entry"},
  {{"Scene/Name=A1", "Boundary/Clamped="},
   "Boundary/Contact",
   "the catalogue scene 'A1' fixes this entry; leave it out, or set Scene/Name = described."},
  {{"Scene/Name=A1", "Boundary/Clamped=", "Boundary/Contact=", "Geometry/Cells=11"},
   "Geometry/Cells",
   "fixes this entry"},
  {{"Scene/Name=D1", "Boundary/Clamped=", "Boundary/Contact=", "Constants/Values=a=1"},
   "Constants/Values",
   "the catalogue scene 'D1' fixes this entry"}};

/** The values of a good scene with some of them replaced, in the order of their first mention. */
std::vector<std::pair<std::string, std::string>> entries(const std::vector<std::string> &settings)
{
  std::vector<std::pair<std::string, std::string>> list = {{"Boundary/Clamped", "top"},
                                                           {"Boundary/Contact", "bottom"}};
  for (const std::string &setting : settings)
  {
    const auto equals = setting.find('=');
    const std::string path = setting.substr(0, equals), value = setting.substr(equals + 1);
    const auto found = std::find_if(
      list.begin(), list.end(), [&](const auto &entry) { return entry.first == path; });
    if (found == list.end())
      list.emplace_back(path, value);
    else
      found->second = value;
  }
  return list;
}

std::string message_of(const std::string &text, const std::vector<std::string> &overrides)
{
  try
  {
    make_scene(parse_parameters(text, "bad.prm", overrides));
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "nothing was refused";
}

/** Place and parameter first, then the fragment; one line; a full stop or a closing parenthesis. */
bool is_good(const std::string &message, const std::string &beginning, const std::string &fragment)
{
  return message.rfind(beginning + ": ", 0) == 0 && message.find(fragment) != std::string::npos &&
         message.find_first_of("\n\r") == std::string::npos &&
         (message.back() == '.' || message.back() == ')');
}

void report(Checks &checks,
            const std::string &name,
            const std::string &message,
            const std::string &beginning,
            const std::string &fragment)
{
  const bool good = is_good(message, beginning, fragment);
  checks.that(name, good);
  if (!good)
    std::cout << "  found: " << message << "\n  expected: " << beginning << ": ... " << fragment
              << std::endl;
}

void test(Checks &checks, const BadScene &bad)
{
  std::string name;
  for (const std::string &setting : bad.settings)
    name += (name.empty() ? "" : ", ") + setting;
  // Each entry takes three lines of the file.
  std::ostringstream text;
  std::map<std::string, std::string> places;
  unsigned int line = 1;
  for (const auto &entry : entries(bad.settings))
  {
    const auto slash = entry.first.find('/');
    if (slash != std::string::npos)
      text << "subsection " << entry.first.substr(0, slash);
    text << "\nset " << entry.first.substr(slash == std::string::npos ? 0 : slash + 1) << " = "
         << entry.second << "\n"
         << (slash == std::string::npos ? "" : "end") << "\n";
    places[entry.first] = ":" + std::to_string(line + 1);
    line += 3;
  }
  const std::string place = places.count(bad.path) > 0 ? places[bad.path] : "";
  report(checks,
         name + " (in the file)",
         message_of(text.str(), {}),
         "bad.prm" + place + ": " + bad.path,
         bad.fragment);

  std::vector<std::string> overrides;
  for (const auto &entry : entries(bad.settings))
    overrides.push_back(entry.first + "=" + entry.second);
  report(checks,
         name + " (by --set)",
         message_of("", overrides),
         (place.empty() ? "bad.prm: " : "--set: ") + bad.path,
         bad.fragment);
}
} // namespace

int main()
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  checks.that("the scene without the faults is good",
              message_of("", {"Boundary/Clamped=top", "Boundary/Contact=bottom"}) ==
                "nothing was refused");
  for (const auto *table :
       {&bad_parameters, &bad_expressions, &bad_materials, &bad_geometries, &bad_boundaries})
    for (const BadScene &bad : *table)
      test(checks, bad);
  return checks.exit_code();
}
