// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Scenes that a mesh or its patches do not resolve.

#include <string>
#include <utility>
#include <vector>

#include "one_level.h"

namespace Unresolved
{
/** A scene, how it is discretised, and how fine the reference is. */
struct Given
{
  std::string name;
  std::string scene;
  std::string discretization;
  unsigned int level;
  unsigned int reference_level = 6;
};

/** A rectangle with sides. */
inline std::string body(const std::string &lower_left,
                        const std::string &upper_right,
                        const std::string &cells = "1, 1")
{
  return "subsection Geometry\nset Lower left = " + lower_left +
         "\nset Upper right = " + upper_right + "\nset Cells = " + cells + "\nend\n";
}

inline std::string material(const std::string &E,
                            const std::string &nu = "0.3",
                            const std::string &state = "strain")
{
  return "subsection Material\nset Young's modulus = " + E + "\nset Poisson's ratio = " + nu +
         "\nset Plane state = " + state + "\nend\n";
}

/** Roles of sides, line by line. */
inline std::string boundary(const std::string &lines)
{
  return "subsection Boundary\nset Contact = bottom\n" + lines + "end\n";
}

inline std::string gap(const std::string &expression)
{
  return entry("Contact", "Gap", expression);
}

inline std::string force(const std::string &expression)
{
  return entry("Load", "Body force", expression);
}

inline std::string option(const std::string &name, const std::string &value)
{
  return entry("Discretization", name, value);
}

inline const std::string clamped_top = boundary("set Clamped = top\n");
inline const std::string clamped_left = boundary("set Clamped = left\n");

inline std::string lowered(const std::string &by)
{
  return boundary("set Displacement = top: 0; -" + by + "\n");
}

using Scenes = std::vector<Given>;

/** Contact between the nodes, and smaller than a patch. */
inline void add_missed_contact(Scenes &scenes)
{
  const std::string steel = body("-10, 0", "10, 10", "2, 1") + material("210000") + clamped_top;
  const std::vector<std::pair<std::string, std::string>> gaps = {
    {"parabola", "x^2/(2*50) - 0.003"},
    {"parabola off nodes", "(x-0.7)^2/(2*50) - 0.003"},
    {"wedge", "abs(x)/100 - 0.003"},
    {"roller", "50 - sqrt(50^2 - x^2) - 0.003"},
    {"flat punch", "(abs(x) < 0.4) ? -0.003 : 1"},
    {"corner", "max(x/200, -x/20) - 0.003"}};
  for (const auto &[name, expression] : gaps)
    for (const unsigned int level : {2U, 3U})
      scenes.push_back({"steel under " + name, steel + gap(expression), "", level});
  const std::string block = body("-1, 0", "1, 1", "2, 1") + material("1");
  for (const unsigned int level : {2U, 3U})
    scenes.push_back({"two bumps, one patch",
                      block + clamped_top + gap("min(4*(x-0.5)^2, 4*(x+0.5)^2) - 0.02"),
                      option("Patches", "1"),
                      level});
  for (const unsigned int level : {1U, 2U, 3U})
    scenes.push_back({"deep peak", block + clamped_top + gap("-0.5 + 100*x^2"), "", level});
  for (const unsigned int level : {1U, 2U})
    scenes.push_back(
      {"lowered onto bumps", block + lowered("0.01") + gap("0.005*(1 + cos(12*pi*x))"), "", level});
  for (const char *ratio : {"4", "8", "16"})
    scenes.push_back({std::string("bumps, H/h = ") + ratio,
                      block + lowered("0.02") + gap("0.01*(1 + cos(4*pi*x))"),
                      option("Patch ratio", ratio),
                      4});
  for (const char *patches : {"1", "2", "3"})
    scenes.push_back({std::string("bumps, patches: ") + patches,
                      block + lowered("0.02") + gap("0.01*(1 + cos(4*pi*x))"),
                      option("Patches", patches),
                      4});
}

/** Cells that are too few or too thin for what bends. */
inline void add_bending(Scenes &scenes)
{
  for (const char *length : {"10", "20", "50"})
    for (const unsigned int level : {1U, 2U, 3U})
      scenes.push_back({std::string("cantilever ") + length + ":1",
                        body("0, 0", std::string(length) + ", 1") + material("1000") +
                          boundary("set Clamped = left\nset Traction = top: 0; -0.1\n") +
                          gap(std::string("0.001*") + length),
                        "",
                        level,
                        7});
  scenes.push_back(
    {"free cantilever 10:1",
     body("0, 0", "10, 1") + material("1000") + clamped_left + force("0; -0.1") + gap("1000"),
     "",
     2,
     7});
  scenes.push_back({"beam 100 x 1 on 32 x 32 cells",
                    body("0, 0", "100, 1") + material("1e6") +
                      boundary("set Clamped = left right\n") + force("0; -1") + gap("1"),
                    "",
                    5,
                    7});
  scenes.push_back({"beam 100 x 1 onto a step",
                    body("0, 0", "100, 1") + material("1e6") +
                      boundary("set Clamped = left right\n") + force("0; -1") +
                      gap("(abs(x-50) < 5) ? 0.1 : 1"),
                    "",
                    4,
                    7});
}

/** Data with periods below the size of cells. */
inline void add_fine_data(Scenes &scenes)
{
  const std::string square = body("0, 0", "1, 1"), one = material("1");
  for (const unsigned int level : {2U, 3U, 4U})
  {
    scenes.push_back(
      {"gap waves", square + one + lowered("0.01") + gap("0.01*sin(40*pi*x)^2"), "", level, 7});
    scenes.push_back(
      {"body force waves",
       square + one + clamped_top + gap("0.1") + force("sin(40*pi*x)*cos(36*pi*y); cos(40*pi*x)"),
       "",
       level,
       7});
    scenes.push_back({"E(y) waves",
                      square + material("10^sin(40*pi*y)") + lowered("0.01") + gap("0.01*x^2"),
                      "",
                      level,
                      7});
  }
  scenes.push_back({"traction waves",
                    square + one +
                      boundary("set Clamped = top\nset Traction = left: sin(50*pi*y); 0 | right: "
                               "0; sin(50*pi*y)\n") +
                      gap("0.1"),
                    "",
                    3,
                    7});
}

/** Materials that change within cells. */
inline void add_fine_materials(Scenes &scenes)
{
  const std::string square = body("0, 0", "1, 1");
  for (const unsigned int level : {2U, 3U})
  {
    scenes.push_back(
      {"eight sharp layers",
       square + material("(sin(8*pi*y) > 0) ? 1 : 1e-3") + lowered("0.01") + gap("0.01*x^2"),
       "",
       level,
       7});
    scenes.push_back({"eight sharp layers, kinks given",
                      square + material("(sin(8*pi*y) > 0) ? 1 : 1e-3") + lowered("0.01") +
                        gap("0.01*x^2") +
                        option("Kinks at y", "0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875"),
                      "",
                      level,
                      7});
    scenes.push_back({"stiff fibres",
                      square + material("(sin(16*pi*x) > 0.95) ? 1000 : 1") +
                        boundary("set Clamped = top\nset Traction = right: 0.1; 0.05\n") +
                        gap("0.01*x"),
                      "",
                      level,
                      7});
    scenes.push_back({"checkerboard 1 to 1e-3",
                      square + material("(sin(8*pi*x)*sin(8*pi*y) > 0) ? 1 : 1e-3") +
                        lowered("0.01") + gap("0.01*x^2"),
                      "",
                      level,
                      7});
  }
  for (const unsigned int level : {2U, 3U})
  {
    scenes.push_back(
      {"thin soft layer along edges",
       square + material("(abs(y-0.5) < 0.005) ? 0.001 : 1") + lowered("0.1") + gap("0.1*x^2"),
       "",
       level,
       7});
    scenes.push_back(
      {"thin stiff layer",
       square + material("(abs(y-0.53) < 0.01) ? 1000 : 1") + lowered("0.1") + gap("0.1*x^2"),
       "",
       level,
       7});
    scenes.push_back({"thin soft layer along edges, kinks given",
                      square + material("(abs(y-0.5) < 0.005) ? 0.001 : 1") + lowered("0.1") +
                        gap("0.1*x^2") + option("Kinks at y", "0.495, 0.505"),
                      "",
                      level,
                      7});
    scenes.push_back(
      {"thin soft layer inside of cells",
       square + material("(abs(y-0.53) < 0.01) ? 0.001 : 1") + lowered("0.1") + gap("0.1*x^2"),
       "",
       level,
       7});
    scenes.push_back({"thin stiff layer, kinks given",
                      square + material("(abs(y-0.53) < 0.01) ? 1000 : 1") + lowered("0.1") +
                        gap("0.1*x^2") + option("Kinks at y", "0.52, 0.54"),
                      "",
                      level,
                      7});
  }
}

/** Data that is concentrated between the points of the system's rules. */
inline void add_narrow_data(Scenes &scenes)
{
  const std::string square = body("0, 0", "1, 1"), one = material("1");
  for (const unsigned int level : {1U, 2U})
  {
    // Between the points that the system takes.
    scenes.push_back({"narrow peak of the gap",
                      square + one + lowered("0.01") + gap("0.011 - 0.05*exp(-((x-0.547)/0.01)^2)"),
                      "",
                      level,
                      7});
    scenes.push_back({"narrow traction",
                      square + one +
                        boundary("set Clamped = top\n"
                                 "set Traction = right: 10*exp(-((y-0.53)/0.005)^2); 0\n") +
                        gap("0.1"),
                      "",
                      level,
                      7});
    scenes.push_back({"narrow body force",
                      square + one + clamped_top + gap("0.1") +
                        force("0; -100*exp(-((x-0.53)^2+(y-0.51)^2)/0.0001)"),
                      "",
                      level,
                      7});
  }
  for (const unsigned int level : {2U, 3U})
    scenes.push_back({"concentrated force",
                      square + one + clamped_top + gap("0.1") +
                        force("0; 100*exp(-((x-0.53)^2+(y-0.51)^2)/0.0001)"),
                      "",
                      level,
                      7});
}

/** Displacements that a side of the mesh cannot follow. */
inline void add_prescribed(Scenes &scenes)
{
  const std::string square = body("0, 0", "1, 1"), one = material("1");
  scenes.push_back(
    {"prescribed waves",
     square + one + boundary("set Displacement = top: 0.01*sin(20*pi*x); 0\n") + gap("0.1"),
     "",
     3,
     7});
  scenes.push_back(
    {"prescribed, zero at all nodes",
     square + one + boundary("set Displacement = top: 0; 0.001*sin(16*pi*x)\n") + gap("0.1"),
     "",
     3,
     7});
  scenes.push_back(
    {"prescribed parabola",
     square + one + boundary("set Displacement = top: 0; -0.1*x*(1-x)\n") + gap("0.1"),
     "",
     2,
     7});
}

inline void add_locking(Scenes &scenes)
{
  const std::string square = body("0, 0", "1, 1");
  for (const unsigned int level : {2U, 3U, 4U})
  {
    scenes.push_back({"nu = 0.4999",
                      square + material("1", "0.4999") +
                        boundary("set Clamped = top\nset Traction = right: -0.1; 0\n") +
                        gap("0.01*x"),
                      "",
                      level,
                      7});
    scenes.push_back({"nu = -0.999, plane stress",
                      square + material("1", "-0.999", "stress") +
                        boundary("set Clamped = top\nset Traction = right: -0.1; 0\n") +
                        gap("0.01*x"),
                      "",
                      level,
                      7});
  }
  for (const char *nu : {"0.3", "0.499"})
    for (const unsigned int level : {2U, 3U})
      scenes.push_back(
        {std::string("pad 50 x 1, nu = ") + nu,
         body("0, 0", "50, 1") + material("1", nu) + lowered("0.05") + gap("0.0001*(x-20)^2"),
         "",
         level,
         7});
}

/** Rollers, contact in a corner, contact that changes along a side, orthotropy. */
inline void add_mixed(Scenes &scenes)
{
  const std::string square = body("0, 0", "1, 1"), one = material("1");
  for (const unsigned int level : {1U, 2U, 3U})
  {
    scenes.push_back({"rollers beside contact",
                      square + one +
                        boundary("set Rollers = left\nset Traction = top: 0; -0.2\n"
                                 "set Clamped = right\n") +
                        gap("0.1*x*(1-x) + 0.05*(x-0.6)^2"),
                      "",
                      level});
    scenes.push_back({"contact in a corner",
                      square + one +
                        "subsection Boundary\nset Contact = bottom left\n"
                        "set Displacement = right: -0.05; -0.02 | top: -0.05; -0.02\nend\n" +
                        gap("bottom: 0.05*sin(7*x)^2 | left: 0.06*y^2"),
                      "",
                      level});
    scenes.push_back(
      {"sheared onto a slope",
       square + one + boundary("set Displacement = top: 0.3; -0.1\n") + gap("0.2*abs(x - 0.37)"),
       "",
       level});
    scenes.push_back({"stiff along x",
                      square +
                        "subsection Material\nset Law = orthotropic\n"
                        "set Orthotropic moduli = 100; 1; 0.3; 0.5\nset Orientation = 30\nend\n" +
                        lowered("0.05") + gap("0.1*x^2"),
                      "",
                      level});
  }
}

/** P that is far from the solution of the dual problem. */
inline void add_loose_solver(Scenes &scenes)
{
  const std::string layer = body("0, 0", "8, 1") + material("(y < 0.25) ? 1000 : 1") +
                            lowered("0.1") + gap("0.05*sin(2*x)^2") + option("Kinks at y", "0.25");
  const std::string psor = "subsection Solver\nset Contact solver = psor\nset Tolerance = 1e-2\n"
                           "end\n";
  for (const unsigned int level : {3U, 4U, 5U})
    scenes.push_back({"stiff layer, PSOR 1e-2", layer, psor, level, 7});
}
} // namespace Unresolved
