// SPDX-License-Identifier: LGPL-2.1-or-later
// The syntax of parameter files, the values they allow, overrides, and the echo.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/parameters/parameter_text.h>
#include <signorini/problem/parameters/parameters.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>

#include "tests.h"

using namespace Signorini;

namespace
{
using Words = std::vector<std::string>;

void test_lists(Checks &checks)
{
  checks.that("trim", trim(" \t a b\r\n") == "a b" && trim(" \n").empty());
  checks.that("split_words", split_words("  top, left\tright ") == Words({"top", "left", "right"}));
  checks.that("split_list keeps empty parts",
              split_list("a;; b ;", ';') == Words({"a", "", "b", ""}));
  checks.that("split_list of nothing", split_list("  ", ',').empty());
  checks.that("split_list keeps parentheses",
              split_list("max(x,0), (1,(2,3)),4", ',') == Words({"max(x,0)", "(1,(2,3))", "4"}));
  checks.that("split_list keeps ||",
              split_list("a: x>0||y>0 ? 1 : 2 | b: 0", '|') ==
                Words({"a: x>0||y>0 ? 1 : 2", "b: 0"}));
  double number = 0.;
  checks.that("read_number", read_number(" -1.5e3 ", number) && number == -1500.);
  for (const char *text : {"", " ", "1x", "1 2", "nan", "inf", "-inf", "1e400", "x", "1,"})
    checks.that("read_number refuses '" + std::string(text) + "'", !read_number(text, number));
  std::vector<double> numbers;
  checks.that("read_numbers",
              read_numbers("1, -2,.5", numbers) && numbers == std::vector<double>({1., -2., 0.5}));
  checks.that("read_numbers of nothing", read_numbers("", numbers) && numbers.empty());
  for (const char *text : {"1, nan", "inf, 0", "1,,2", "1; 2"})
    checks.that("read_numbers refuses '" + std::string(text) + "'", !read_numbers(text, numbers));
  checks.that("shorten",
              shorten("short") == "short" && shorten(std::string(500, 'a')).size() < 120);
  std::string greek;
  for (int i = 0; i < 100; ++i)
    greek += "\u03bb";
  checks.that("shorten keeps characters whole",
              shorten(greek).substr(78, 4) == "\u03bb ." && quote("a") == "'a'");
  checks.that("number_text",
              number_text(-std::nan("")) == "nan" && number_text(1e300) == "1e+300" &&
                number_text(0.5) == "0.5");
  checks.that("join", join({"a", "b", "c"}) == "a, b, c" && join({}).empty());
}

/** Every kind of line that is understood, once. */
void test_good_syntax(Checks &checks)
{
  const std::string text = "\xEF\xBB\xBF# a comment\r\n"
                           "subsection Solver   # another\r\n"
                           "\tset Tolerance=1e-8# no blanks\r\n"
                           "  set  Contact solver  =   psor  \r\n"
                           "\r\n"
                           "end\r\n"
                           "subsection Boundary\r\n"
                           "  set Clamped = left \\\r\n"
                           "\r\n"
                           "  set Contact = \\\n"
                           "   # a comment\n"
                           "   bottom\\\n"
                           "   top\n"
                           "end\n"
                           "subsection Solver\n"
                           "  set Relaxation = 1.5\n"
                           "end";
  const auto assignments = scan_parameter_text(text, "a.prm");
  checks.near("assignments", assignments.size(), 5, 0);
  checks.that("path", assignments[1].path == "Solver/Contact solver");
  checks.that("value", assignments[1].value == "psor");
  checks.that("place", assignments[1].place == "a.prm:4");
  checks.that("place of a continued line is its first", assignments[3].place == "a.prm:10");
  checks.that("an empty line ends a continuation", assignments[2].value == "left");
  checks.that("continued value, with a comment between its lines",
              split_words(assignments[3].value) == Words({"bottom", "top"}));
}

/** Wrong syntax is a part of tests/problem/bad_input. */
void test_files(Checks &checks)
{
  checks.throws<InputError>("unreadable file",
                            "no such file.prm: this parameter file cannot be",
                            [] { read_parameters("no such file.prm"); });
  checks.throws<InputError>(
    "directory as file", ".: this parameter file cannot be read.", [] { read_parameters("."); });
  checks.throws<InputError>("endless file",
                            "/dev/zero: this is a device or a pipe, allowed: a file of text",
                            [] { read_parameters("/dev/zero"); });
  std::ofstream("large.prm") << std::string(1000001, '#');
  checks.throws<InputError>("large file",
                            "large.prm: this file has 1000001 bytes, allowed: at most 1000000.",
                            [] { read_parameters("large.prm"); });
  std::remove("large.prm");
  checks.that("line ends of old systems",
              scan_parameter_text("set A = 1\rset B = 2\r", "a.prm").size() == 2);
}

/** What each pattern refuses; the message names what is allowed. */
void test_values(Checks &checks)
{
  const std::vector<std::pair<std::string, Words>> refused = {
    {"Dimension", {"4", "1", "two"}},
    {"Geometry/Shape", {"disk", "Rectangle", "rectangle polygon"}},
    {"Geometry/Mesh size", {"-1", "fine"}},
    {"Geometry/Radius", {"0", "-1"}},
    {"Geometry/Inner radius", {"0", "inf"}},
    {"Geometry/Distortion", {"-0.1", "0.46", "nan", "0,1", "much"}},
    {"Material/Law", {"elastic"}},
    {"Material/Plane state", {"plane strain"}},
    {"Material/Orientation", {"inf", "30 degrees"}},
    {"Discretization/Coarsest level", {"-1", "15", "1.5", "99999999999999999999"}},
    {"Discretization/Patch ratio", {"0", "2.5"}},
    {"Discretization/Patches", {"-1"}},
    {"Discretization/Target error", {"-1e-3", "1.1"}},
    {"Discretization/Quadrature points", {"0", "17"}},
    {"Discretization/Kinks at x", {"0.5; 0.6", "a", "nan"}},
    {"Solver/Contact solver", {"mprg", "active-set", "PSOR"}},
    {"Solver/Relaxation", {"0", "2", "-1", "2.05"}},
    {"Solver/Tolerance", {"0", "1", "1e-16"}},
    {"Solver/Maximum iterations", {"0", "1e5"}},
    {"Solver/Linear solver", {"cholmod", "amg"}},
    {"Solver/Warm start", {"maybe", "1"}},
    {"Output/VTU", {"all levels"}},
    {"Output/Inf-sup constant", {"perhaps", "1"}},
    {"Output/Compliance", {"sometimes"}}};
  for (const auto &row : refused)
    for (const std::string &value : row.second)
      checks.throws<InputError>(row.first + " = " + value,
                                "--set: " + row.first + ": found '" + value + "', allowed: ",
                                [&] { parse_parameters("", "a.prm", {row.first + "=" + value}); });
  checks.throws<InputError>("allowed values are named",
                            "found 'mprg', allowed: automatic, psor, active set, mprgp, multigrid.",
                            [] { parse_parameters("", "a.prm", {"Solver/Contact solver=mprg"}); });
  checks.throws<InputError>(
    "finest below coarsest",
    "--set: Discretization/Finest level: found '1', allowed: an integer not "
    "below Discretization/Coarsest level = 2.",
    [] { parse_parameters("", "a.prm", {"Discretization/Finest level=1"}); });
  const Parameters limits = parse_parameters("",
                                             "a.prm",
                                             {"Solver/Relaxation=1.999",
                                              "Geometry/Distortion=0",
                                              "Discretization/Coarsest level=0",
                                              "Discretization/Kinks at x=0.5, -0.25",
                                              "Discretization/Patches= 7 "});
  checks.that("values at the limits",
              limits.solver.relaxation == 1.999 && limits.discretization.coarsest_level == 0 &&
                limits.discretization.patches == 7 &&
                limits.discretization.kinks_at_x.value == std::vector<double>({0.5, -0.25}));
  const Parameters defaults = parse_parameters("", "a.prm");
  checks.that("defaults",
              defaults.dimension == 2 && defaults.scene.name.value == "described" &&
                defaults.solver.tolerance == 1e-10 && defaults.solver.warm_start &&
                defaults.discretization.patch_ratio == 2 && defaults.changes_of_scene.empty());
}

/** The names of an option in the order of its values, and the value when one of them is given. */
template <typename Option>
void test_option(Checks &checks,
                 const std::string &path,
                 const Words &names,
                 const std::function<Given<Option>(const Parameters &)> &option)
{
  checks.that(path + ": names", option_names(typeid(Option)) == names);
  const Given<Option> by_default = option(parse_parameters("", "a.prm"));
  bool read = !by_default.changed && by_default.where() == "a.prm: " + path;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const Given<Option> given = option(parse_parameters("", "a.prm", {path + "=" + names[i]}));
    read = read && given.value == static_cast<Option>(i) && to_text(given.value) == names[i] &&
           given.changed == (given.value != by_default.value);
  }
  checks.that(path + ": values", read);
}

void test_options(Checks &checks)
{
  test_option<Shape>(checks,
                     "Geometry/Shape",
                     {"rectangle", "box", "polygon", "half disc", "disc", "ring", "file"},
                     [](const Parameters &p) { return p.geometry.shape; });
  test_option<MaterialLaw>(checks,
                           "Material/Law",
                           {"isotropic", "orthotropic", "general"},
                           [](const Parameters &p) { return p.material.law; });
  test_option<PlaneState>(checks,
                          "Material/Plane state",
                          {"strain", "stress"},
                          [](const Parameters &p) { return p.material.plane_state; });
  test_option<Element>(checks,
                       "Discretization/Element",
                       {"Q1", "Q1 B-bar", "Q2"},
                       [](const Parameters &p) { return p.discretization.element; });
  test_option<ContactSolver>(checks,
                             "Solver/Contact solver",
                             {"automatic", "psor", "active set", "mprgp", "multigrid"},
                             [](const Parameters &p) { return p.solver.contact_solver; });
  test_option<LinearSolver>(checks,
                            "Solver/Linear solver",
                            {"automatic", "condensed", "amesos_mumps", "amesos_klu", "multigrid"},
                            [](const Parameters &p) { return p.solver.linear_solver; });
  test_option<VtuLevels>(checks, "Output/VTU", {"none", "finest", "all"}, [](const Parameters &p) {
    return p.output.vtu;
  });
  test_option<Choice>(checks,
                      "Output/Inf-sup constant",
                      {"true", "false", "automatic"},
                      [](const Parameters &p) { return p.output.inf_sup_constant; });
}

void test_overrides(Checks &checks)
{
  const std::string text = "subsection Solver\n set Tolerance = 1e-6\n set Warm start = false\nend";
  const Parameters parameters =
    parse_parameters(text, "a.prm", {"Solver/Tolerance=1e-7", "Solver/Tolerance = 1e-8"});
  checks.near("the last override wins", parameters.solver.tolerance, 1e-8, 0.);
  checks.that("others stay as in the file", !parameters.solver.warm_start);
  const SolverParameters &solver = parameters.solver;
  checks.that("place of an override", solver.tolerance.where() == "--set: Solver/Tolerance");
  checks.that("place in the file", solver.warm_start.where() == "a.prm:3: Solver/Warm start");
  checks.that("place of a default", solver.relaxation.where() == "a.prm: Solver/Relaxation");
  checks.that("changed", solver.tolerance.changed && !solver.relaxation.changed);
  checks.that("place of a subsection", parameters.boundary.where == "a.prm: Boundary");
  checks.that("place without a subsection", parameters.dimension.where() == "a.prm: Dimension");
  const Assignment formula = scan_override("Contact/Gap=bottom: x==0 ? 1 : 2");
  checks.that("= in a value", formula.value == "bottom: x==0 ? 1 : 2");
  checks.that("an override is one line", scan_override("Contact/Gap=x\n+\r1").value == "x + 1");
  for (const char *argument : {"Solver/Tolerance", "=1", ""})
    checks.throws<InputError>("override '" + std::string(argument) + "'", "--set: found '", [&] {
      scan_override(argument);
    });
  checks.throws<InputError>("unknown override",
                            "--set: Solvr/Tolerance: unknown parameter; did you "
                            "mean 'Solver/Tolerance'?",
                            [] { parse_parameters("", "a.prm", {"Solvr/Tolerance=1e-8"}); });

  // Back at the default, written differently or empty, a parameter is not changed.
  const Parameters same =
    parse_parameters("subsection Geometry\n set Cells = 4, 4\n set Distortion = 0.1\nend\n"
                     "subsection Solver\n set Tolerance = 1e-6\nend",
                     "a.prm",
                     {"Geometry/Cells=1,1", "Geometry/Distortion=0.0", "Solver/Tolerance="});
  checks.that("back at the default",
              same.changes_of_scene.empty() && !same.geometry.cells.changed &&
                !same.geometry.distortion.changed && !same.solver.tolerance.changed);
  checks.that("the place is the last one", same.geometry.cells.place == "--set");
  checks.near("empty means not given", same.solver.tolerance, 1e-10, 0.);
  const Parameters other = parse_parameters("", "a.prm", {"Geometry/Cells=11"});
  checks.that("11 is not 1, 1", other.geometry.cells.changed);
}

/** A run can be repeated from its echo alone. */
void test_echo(Checks &checks)
{
  const Words overrides = {"Scene/Name=A1",
                           "Constants/Values=E=1, nu=0.3",
                           "Geometry/Shape=polygon",
                           "Geometry/Vertices=0,0; 1,0; 0,1",
                           "Geometry/Distortion=0.123456789012345",
                           "Material/Law=orthotropic",
                           "Material/Orientation=-30.5",
                           "Boundary/Rollers=side0 side1",
                           "Boundary/Traction=side0: x>0||y>0 ? 1 : 2; -1 | side1: 0; 0",
                           "Contact/Gap=max(x-0.1,0)^2",
                           "Exact solution/Pressure=-1",
                           "Discretization/Kinks at x=0.70710678118654752, 0.25",
                           "Discretization/Patches=5",
                           "Solver/Relaxation=1.0000000000000002",
                           "Solver/Warm start=false",
                           "Output/Compliance=true"};
  const Parameters first = parse_parameters("", "a.prm", overrides);
  const Parameters second = parse_parameters(first.echo, "echo.prm");
  checks.that("echo of the echo", first.echo == second.echo && !first.echo.empty());
  Words changed, changed_again;
  for (const Entry &entry : first.changes_of_scene)
    changed.push_back(entry.name);
  for (const Entry &entry : second.changes_of_scene)
    changed_again.push_back(entry.name);
  checks.that("what a catalogue scene fixes",
              changed == Words({"Constants/Values",
                                "Geometry/Distortion",
                                "Geometry/Shape",
                                "Geometry/Vertices",
                                "Material/Law",
                                "Material/Orientation",
                                "Boundary/Rollers",
                                "Boundary/Traction",
                                "Contact/Gap",
                                "Exact solution/Pressure"}));
  checks.that("same changes", changed == changed_again);
  checks.that(
    "same numbers",
    second.geometry.distortion == 0.123456789012345 && second.material.orientation == -30.5 &&
      second.solver.relaxation == 1.0000000000000002 && second.discretization.patches == 5);
  checks.that("same lists",
              second.discretization.kinks_at_x.value ==
                std::vector<double>({0.70710678118654752, 0.25}));
  checks.that("same switches", !second.solver.warm_start && second.output.compliance);
  checks.that("same texts",
              second.boundary.traction.value == first.boundary.traction.value &&
                second.contact.gap.value == "max(x-0.1,0)^2" &&
                second.constants.values.value == "E=1, nu=0.3");

  // The description is a parameter file of the defaults, with help in its comments.
  const std::string description = describe_parameters();
  checks.that("description can be read",
              parse_parameters(description, "b.prm").echo == parse_parameters("", "b.prm").echo);
  const std::size_t declared = scan_parameter_text(description, "b.prm").size();
  checks.near("echo is complete", scan_parameter_text(first.echo, "b.prm").size(), declared, 0);
  std::size_t explained = 0;
  for (std::size_t at = 0; (at = description.find("Allowed:", at)) != std::string::npos; ++at)
    ++explained;
  checks.that("description names allowed values", explained > 15);
}
} // namespace

int main()
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  test_lists(checks);
  test_good_syntax(checks);
  test_files(checks);
  test_values(checks);
  test_options(checks);
  test_overrides(checks);
  test_echo(checks);
  return checks.exit_code();
}
