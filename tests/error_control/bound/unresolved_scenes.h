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
  unsigned int reference_level;
};

class Scenes
{
public:
  void add(const std::string &name,
           const std::string &scene,
           const std::vector<unsigned int> &levels,
           const unsigned int reference_level = 7,
           const std::string &discretization = "")
  {
    for (const unsigned int level : levels)
      all.push_back({name, scene, discretization, level, reference_level});
  }

  std::vector<Given> all;
};

inline std::string body(const std::string &upper_right)
{
  return entry("Geometry", "Upper right", upper_right);
}

inline std::string material(const std::string &E, const std::string &nu = "0.3")
{
  return entry("Material", "Young's modulus", E) + entry("Material", "Poisson's ratio", nu);
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

inline const std::string one = material("1"), clamped_top = boundary("set Clamped = top\n"),
                         pulled = boundary("set Clamped = top\nset Traction = right: -0.1; 0\n");

inline std::string lowered(const std::string &by)
{
  return boundary("set Displacement = top: 0; -" + by + "\n");
}

/** Contact between the nodes, and smaller than a patch. */
inline void add_missed_contact(Scenes &scenes)
{
  const auto wide = [](const std::string &lower_left, const std::string &upper_right) {
    return entry("Geometry", "Lower left", lower_left) + body(upper_right) +
           entry("Geometry", "Cells", "2, 1");
  };
  const std::string steel = wide("-10, 0", "10, 10") + material("210000") + clamped_top;
  const std::vector<std::pair<std::string, std::string>> gaps = {
    {"parabola", "x^2/(2*50) - 0.003"},
    {"parabola off nodes", "(x-0.7)^2/(2*50) - 0.003"},
    {"wedge", "abs(x)/100 - 0.003"},
    {"roller", "50 - sqrt(50^2 - x^2) - 0.003"},
    {"flat punch", "(abs(x) < 0.4) ? -0.003 : 1"},
    {"corner", "max(x/200, -x/20) - 0.003"}};
  for (const auto &[name, expression] : gaps)
    scenes.add("steel under " + name, steel + gap(expression), {2, 3}, 6);
  const std::string block = wide("-1, 0", "1, 1") + one;
  scenes.add("two bumps, one patch",
             block + clamped_top + gap("min(4*(x-0.5)^2, 4*(x+0.5)^2) - 0.02"),
             {2, 3},
             6,
             option("Patches", "1"));
  scenes.add("deep peak", block + clamped_top + gap("-0.5 + 100*x^2"), {1, 2, 3}, 6);
  scenes.add(
    "lowered onto bumps", block + lowered("0.01") + gap("0.005*(1 + cos(12*pi*x))"), {1, 2}, 6);
  const std::string bumps = block + lowered("0.02") + gap("0.01*(1 + cos(4*pi*x))");
  for (const std::string ratio : {"4", "8", "16"})
    scenes.add("bumps, H/h = " + ratio, bumps, {4}, 6, option("Patch ratio", ratio));
  for (const std::string patches : {"1", "2", "3"})
    scenes.add("bumps, patches: " + patches, bumps, {4}, 6, option("Patches", patches));
}

/** Cells that are too few or too thin for what bends. */
inline void add_bending(Scenes &scenes)
{
  for (const std::string length : {"10", "20", "50"})
    scenes.add("cantilever " + length + ":1",
               body(length + ", 1") + material("1000") +
                 boundary("set Clamped = left\nset Traction = top: 0; -0.1\n") +
                 gap("0.001*" + length),
               {1, 2, 3});
  scenes.add("free cantilever 10:1",
             body("10, 1") + material("1000") + boundary("set Clamped = left\n") +
               force("0; -0.1") + gap("1000"),
             {2});
  const std::string beam =
    body("100, 1") + material("1e6") + boundary("set Clamped = left right\n") + force("0; -1");
  scenes.add("beam 100 x 1 on 32 x 32 cells", beam + gap("1"), {5});
  scenes.add("beam 100 x 1 onto a step", beam + gap("(abs(x-50) < 5) ? 0.1 : 1"), {4});
}

/** Data with periods below the size of cells. */
inline void add_fine_data(Scenes &scenes)
{
  scenes.add("gap waves", one + lowered("0.01") + gap("0.01*sin(40*pi*x)^2"), {2, 3, 4});
  scenes.add("body force waves",
             one + clamped_top + gap("0.1") + force("sin(40*pi*x)*cos(36*pi*y); cos(40*pi*x)"),
             {2, 3, 4});
  scenes.add(
    "E(y) waves", material("10^sin(40*pi*y)") + lowered("0.01") + gap("0.01*x^2"), {2, 3, 4});
  scenes.add("traction waves",
             one +
               boundary("set Clamped = top\nset Traction = left: sin(50*pi*y); 0 | right: "
                        "0; sin(50*pi*y)\n") +
               gap("0.1"),
             {3});
}

/** Materials that change within cells. */
inline void add_fine_materials(Scenes &scenes)
{
  const std::string gently = lowered("0.01") + gap("0.01*x^2"),
                    strongly = lowered("0.1") + gap("0.1*x^2");
  const std::string layers = material("(sin(8*pi*y) > 0) ? 1 : 1e-3");
  scenes.add("eight sharp layers", layers + gently, {2, 3});
  scenes.add("eight sharp layers, kinks given",
             layers + gently + option("Kinks at y", "0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875"),
             {2, 3});
  scenes.add("stiff fibres",
             material("(sin(16*pi*x) > 0.95) ? 1000 : 1") +
               boundary("set Clamped = top\nset Traction = right: 0.1; 0.05\n") + gap("0.01*x"),
             {2, 3});
  scenes.add("checkerboard 1 to 1e-3",
             material("(sin(8*pi*x)*sin(8*pi*y) > 0) ? 1 : 1e-3") + gently,
             {2, 3});
  const std::string soft = material("(abs(y-0.5) < 0.005) ? 0.001 : 1") + strongly,
                    stiff = material("(abs(y-0.53) < 0.01) ? 1000 : 1") + strongly;
  scenes.add("thin soft layer along edges", soft, {2, 3});
  scenes.add("thin soft layer along edges, kinks given",
             soft + option("Kinks at y", "0.495, 0.505"),
             {2, 3});
  scenes.add("thin soft layer inside of cells",
             material("(abs(y-0.53) < 0.01) ? 0.001 : 1") + strongly,
             {2, 3});
  scenes.add("thin stiff layer", stiff, {2, 3});
  scenes.add("thin stiff layer, kinks given", stiff + option("Kinks at y", "0.52, 0.54"), {2, 3});
}

/** Data that is concentrated between the points of the system's rules. */
inline void add_narrow_data(Scenes &scenes)
{
  scenes.add("narrow peak of the gap",
             one + lowered("0.01") + gap("0.011 - 0.05*exp(-((x-0.547)/0.01)^2)"),
             {1, 2});
  scenes.add("narrow traction",
             one +
               boundary("set Clamped = top\n"
                        "set Traction = right: 10*exp(-((y-0.53)/0.005)^2); 0\n") +
               gap("0.1"),
             {1, 2});
  const std::string free = one + clamped_top + gap("0.1");
  scenes.add(
    "narrow body force", free + force("0; -100*exp(-((x-0.53)^2+(y-0.51)^2)/0.0001)"), {1, 2});
  scenes.add(
    "concentrated force", free + force("0; 100*exp(-((x-0.53)^2+(y-0.51)^2)/0.0001)"), {2, 3});
}

/** Displacements that a side of the mesh cannot follow. */
inline void add_prescribed(Scenes &scenes)
{
  const auto prescribed = [](const std::string &u) {
    return one + boundary("set Displacement = top: " + u + "\n") + gap("0.1");
  };
  scenes.add("prescribed waves", prescribed("0.01*sin(20*pi*x); 0"), {3});
  scenes.add("prescribed, zero at all nodes", prescribed("0; 0.001*sin(16*pi*x)"), {3});
  scenes.add("prescribed parabola", prescribed("0; -0.1*x*(1-x)"), {2});
}

inline void add_locking(Scenes &scenes)
{
  scenes.add("nu = 0.4999", material("1", "0.4999") + pulled + gap("0.01*x"), {2, 3, 4});
  scenes.add("nu = -0.999, plane stress",
             material("1", "-0.999") + entry("Material", "Plane state", "stress") + pulled +
               gap("0.01*x"),
             {2, 3, 4});
  for (const std::string nu : {"0.3", "0.499"})
    scenes.add("pad 50 x 1, nu = " + nu,
               body("50, 1") + material("1", nu) + lowered("0.05") + gap("0.0001*(x-20)^2"),
               {2, 3});
}

/** Rollers, contact in a corner, contact that changes along a side, orthotropy. */
inline void add_mixed(Scenes &scenes)
{
  scenes.add("rollers beside contact",
             one +
               boundary("set Rollers = left\nset Traction = top: 0; -0.2\n"
                        "set Clamped = right\n") +
               gap("0.1*x*(1-x) + 0.05*(x-0.6)^2"),
             {1, 2, 3},
             6);
  scenes.add("contact in a corner",
             one +
               "subsection Boundary\nset Contact = bottom left\n"
               "set Displacement = right: -0.05; -0.02 | top: -0.05; -0.02\nend\n" +
               gap("bottom: 0.05*sin(7*x)^2 | left: 0.06*y^2"),
             {1, 2, 3},
             6);
  scenes.add("sheared onto a slope",
             one + boundary("set Displacement = top: 0.3; -0.1\n") + gap("0.2*abs(x - 0.37)"),
             {1, 2, 3},
             6);
  scenes.add("stiff along x",
             entry("Material", "Law", "orthotropic") +
               entry("Material", "Orthotropic moduli", "100; 1; 0.3; 0.5") +
               entry("Material", "Orientation", "30") + lowered("0.05") + gap("0.1*x^2"),
             {1, 2, 3},
             6);
}

/** P that is far from the solution of the dual problem. */
inline void add_loose_solver(Scenes &scenes)
{
  scenes.add("stiff layer, PSOR 1e-2",
             body("8, 1") + material("(y < 0.25) ? 1000 : 1") + lowered("0.1") +
               gap("0.05*sin(2*x)^2") + option("Kinks at y", "0.25"),
             {3, 4, 5},
             7,
             entry("Solver", "Contact solver", "psor") + entry("Solver", "Tolerance", "1e-2"));
}
} // namespace Unresolved
