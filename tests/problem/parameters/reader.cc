// SPDX-License-Identifier: LGPL-2.1-or-later
// The syntax of parameter files, the values they allow, overrides, and the echo.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/parameters/parameter_text.h>
#include <signorini/problem/parameters/parameters.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "tests.h"

using namespace Signorini;

namespace {
using Words = std::vector<std::string>;

void test_lists(Checks &checks) {
  checks.that("split_list keeps empty parts, but for the last",
              split_list("a;; b ;", ';') == Words({"a", "", "b"}) &&
                split_list("a;;", ';') == Words({"a", ""}) && split_list("  ", ',').empty());
  checks.that("split_list keeps parentheses and ||",
              split_list("max(x,0), (1,(2,3)),4", ',') == Words({"max(x,0)", "(1,(2,3))", "4"}) &&
                split_list("a: x>0||y>0 | b: 0", '|') == Words({"a: x>0||y>0", "b: 0"}));
  double number = 0.;
  std::vector<double> numbers;
  checks.that("read_number", read_number(" -1.5e3 ", number) && number == -1500.);
  checks.that("read_numbers",
              read_numbers("1, -2,.5,", numbers) && numbers == std::vector<double>({1., -2., 0.5}));
  checks.that("read_numbers of nothing", read_numbers("", numbers) && numbers.empty());
  for (const std::string text :
       {"1x", "1 2", "nan", "inf", "-inf", "1e400", "x", "1,,", "1,,2", "1; 2"})
    checks.that("refused: " + text, !read_number(text, number) && !read_numbers(text, numbers));
  checks.that("no number", !read_number(" ", number));
}

/** Every kind of line that is understood, once. */
void test_good_syntax(Checks &checks) {
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
  checks.that("place", assignments[1].origin == "a.prm:4");
  checks.that("place of a continued line is its first", assignments[3].origin == "a.prm:10");
  checks.that("an empty line ends a continuation", assignments[2].value == "left");
  checks.that("continued value, with a comment between its lines",
              split_words(assignments[3].value) == Words({"bottom", "top"}));
}

/** Wrong syntax is a part of tests/problem/bad_input. */
void test_files(Checks &checks) {
  std::ofstream("large.prm") << std::string(1000001, '#');
  for (const auto &[file, message] :
       {std::pair("no such file.prm", "no such file.prm: this parameter file cannot be"),
        std::pair(".", ".: this parameter file cannot be read."),
        std::pair("/dev/zero", "/dev/zero: this is a device or a pipe, allowed: a file of text"),
        std::pair("large.prm", "large.prm: this file has 1000001 bytes, "
                               "allowed: at most 1000000.")})
    checks.throws<InputError>(file, message, [name = file] { read_parameters(name); });
  std::remove("large.prm");
  checks.near("line ends of old systems",
              scan_parameter_text("set A = 1\rset B = 2\r", "a.prm").size(), 2, 0.);
}

/** tests/problem/bad_input has the refused texts, and the names of all choices. */
void test_values(Checks &checks) {
  checks.refuses("--set: Discretization/Finest level: found '1', allowed: an integer not "
                 "below "
                 "Discretization/Coarsest level = 2.",
                 [] { parse_parameters("", "a.prm", {"Discretization/Finest level=1"}); });
  const Parameters limits = parse_parameters(
    "", "a.prm",
    {"Solver/Relaxation=1.999", "Geometry/Distortion=0", "Discretization/Coarsest level=0",
     "Discretization/Kinks at x=0.5, -0.25", "Discretization/Patches= 7 "});
  checks.that("values at the limits",
              limits.solver.relaxation == 1.999 && limits.discretization.coarsest_level == 0 &&
                limits.discretization.patches.value == "7" &&
                limits.discretization.kinks_at_x.value == std::vector<double>({0.5, -0.25}));
}

void test_overrides(Checks &checks) {
  const std::string text = "subsection Solver\n set Tolerance = 1e-6\n set Warm start = false\nend";
  const Parameters parameters =
    parse_parameters(text, "a.prm", {"Solver/Tolerance=1e-7", "Solver/Tolerance = 1e-8"});
  checks.near("the last override wins", parameters.solver.tolerance, 1e-8, 0.);
  checks.that("others stay as in the file", !parameters.solver.warm_start);
  const SolverParameters &solver = parameters.solver;
  checks.that("place of an override", solver.tolerance.where() == "--set: Solver/Tolerance");
  const Parameters swept =
    parse_parameters(text, "a.prm", {"Solver/Tolerance=1e-7"}, "", {"Solver/Tolerance=1e-9"});
  checks.that("a value of a sweep comes last, with its option",
              swept.solver.tolerance == 1e-9 &&
                swept.solver.tolerance.where() == "--sweep: Solver/Tolerance");
  checks.that("place in the file", solver.warm_start.where() == "a.prm:3: Solver/Warm start");
  checks.that("place of a default", solver.relaxation.where() == "a.prm: Solver/Relaxation");
  checks.that("changed", solver.tolerance.changed && !solver.relaxation.changed);
  checks.that("place of a subsection", parameters.boundary.where == "a.prm: Boundary");
  checks.that("place without a subsection", parameters.dimension.where() == "a.prm: Dimension");
  checks.that("= in a value", scan_override("Contact/Gap=x==0 ? 1 : 2").value == "x==0 ? 1 : 2");
  checks.that("an override is one line", scan_override("Contact/Gap=x\n+\r1").value == "x + 1");
  for (const std::string argument : {"Solver/Tolerance", "=1", ""})
    checks.throws<InputError>("override '" + argument + "'", "--set: found '",
                              [&] { scan_override(argument); });

  const auto refuses = [&](const std::string &setting, const std::string &rest) {
    checks.refuses("--set: " + rest, [&] {
      parse_parameters("subsection Constants\n set Values = alpha=1, w=2\nend", "a.prm", {setting});
    });
  };
  const std::string allowed = ", allowed: a constant (alpha, w) or Subsection/Parameter.";
  refuses("zz=3", "found 'zz'" + allowed);
  refuses("W=3", "found 'W' (did you mean 'w'?)" + allowed);
  refuses("Constants/W=3", "found the constant 'W' (did you mean 'w'?), allowed: alpha, w.");
  refuses("Tolerance=3", "Tolerance: unknown parameter; did you mean 'Solver/Tolerance'? "
                         "(--print-parameters lists all)");

  // Back at the default, written differently or empty, a parameter is not changed.
  const Parameters same = parse_parameters(
    "subsection Geometry\n set Cells = 4, 4\n set Distortion = 0.1\nend\n"
    "subsection Solver\n set Tolerance = 1e-6\nend",
    "a.prm", {"Geometry/Cells=1,1", "Geometry/Distortion=0.0", "Solver/Tolerance=1e-10"});
  checks.that("back at the default",
              same.changes_of_scene.empty() && !same.geometry.cells.changed &&
                !same.geometry.distortion.changed && !same.solver.tolerance.changed);
  checks.that("the place is the last one", same.geometry.cells.origin == "--set");
  checks.near("the last value holds", same.solver.tolerance, 1e-10, 0.);
}

/** A run can be repeated from its echo alone. */
void test_echo(Checks &checks) {
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
  const auto changes = [](const Parameters &parameters) {
    Words names;
    for (const Entry &entry : parameters.changes_of_scene)
      names.push_back(entry.name);
    return names;
  };
  checks.that("what a catalogue scene fixes",
              changes(first) == Words({"Constants/Values", "Geometry/Distortion", "Geometry/Shape",
                                       "Geometry/Vertices", "Material/Law", "Material/Orientation",
                                       "Boundary/Rollers", "Boundary/Traction", "Contact/Gap",
                                       "Exact solution/Pressure"}));
  checks.that("same changes", changes(first) == changes(second));
  checks.near("same numbers",
              {second.geometry.distortion, second.material.orientation, second.solver.relaxation,
               std::stod(second.discretization.patches),
               second.discretization.kinks_at_x.value.at(0)},
              {0.123456789012345, -30.5, 1.0000000000000002, 5., 0.70710678118654752}, 0.);
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

int main() {
  return run_tests(
    {test_lists, test_good_syntax, test_files, test_values, test_overrides, test_echo});
}
