// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Scenes that a mesh or its patches do not resolve, and scenes of every shape, law and condition.

#include <string>
#include <vector>

#include "scene_text.h"

namespace Unresolved {
/** A scene, how it is discretised, and how fine the reference is. */
struct Given {
  std::string name;
  /** Lines "Section/Name = value"; where none says it, the bottom may touch. */
  std::string scene;
  std::vector<unsigned int> levels;
  unsigned int reference_level = 6;
  std::string discretization = "";
  /** The largest bound / error that is allowed. */
  double largest = 1e30;
};

using Scenes = std::vector<Given>;

inline const std::string clamped_top = "Boundary/Clamped = top\n",
                         pulled = clamped_top + "Boundary/Traction = right: -0.1; 0\n",
                         one = "Material/Young's modulus = 1\n";

inline std::string lowered(const std::string &by) {
  return "Boundary/Displacement = top: 0; -" + by + "\n";
}

inline std::string gap(const std::string &expression) {
  return "Contact/Gap = " + expression + "\n";
}

inline std::string modulus(const std::string &expression) {
  return "Material/Young's modulus = " + expression + "\n";
}

/** Contact between the nodes, and smaller than a patch. */
inline void add_missed_contact(Scenes &scenes) {
  const std::string steel = "Geometry/Lower left = -10, 0\nGeometry/Upper right = 10, 10\n"
                            "Geometry/Cells = 2, 1\n" +
                            modulus("210000") + clamped_top,
                    block = "Geometry/Lower left = -1, 0\nGeometry/Cells = 2, 1\n" + one;
  for (const auto &[name, expression] : std::vector<std::pair<std::string, std::string>>{
         {"parabola", "x^2/(2*50) - 0.003"},
         {"parabola off nodes", "(x-0.7)^2/(2*50) - 0.003"},
         {"wedge", "abs(x)/100 - 0.003"},
         {"roller", "50 - sqrt(50^2 - x^2) - 0.003"},
         {"flat punch", "(abs(x) < 0.4) ? -0.003 : 1"},
         {"corner", "max(x/200, -x/20) - 0.003"}})
    scenes.push_back({"steel under " + name, steel + gap(expression), {2, 3}});
  scenes.push_back({"tip between nodes",
                    "Geometry/Lower left = -1, 0\nGeometry/Upper right = 1, 2\n" + clamped_top +
                      gap("(x-0.0313)^2/(2*0.08)-0.003"),
                    {2, 3, 4},
                    7,
                    "",
                    15.});
  scenes.push_back({"two bumps, one patch",
                    block + clamped_top + gap("min(4*(x-0.5)^2, 4*(x+0.5)^2) - 0.02"),
                    {2, 3},
                    6,
                    "Discretization/Patches = 1\n"});
  scenes.push_back({"deep peak", block + clamped_top + gap("-0.5 + 100*x^2"), {1, 2, 3}});
  scenes.push_back(
    {"lowered onto bumps", block + lowered("0.01") + gap("0.005*(1 + cos(12*pi*x))"), {1, 2}});
  for (const std::string patches : {"Patch ratio = 4", "Patch ratio = 8", "Patch ratio = 16",
                                    "Patches = 1", "Patches = 2", "Patches = 3"})
    scenes.push_back({"bumps, " + patches,
                      block + lowered("0.02") + gap("0.01*(1 + cos(4*pi*x))"),
                      {4},
                      6,
                      "Discretization/" + patches + "\n"});
  // Waves with mean zero on every patch: u_h is a uniform compression, and the contact part is the
  // whole bound.
  for (const std::string height : {"0.0001", "0.001", "-0.001"})
    scenes.push_back(
      {"waves of " + height + " between patches",
       "Boundary/Rollers = left right\n" + lowered("0.01") + gap(height + "*cos(16*pi*x)"),
       {3},
       7,
       "",
       3.});
}

/** Cells that are too few or too thin for bending. */
inline void add_bending(Scenes &scenes) {
  const std::string steel = modulus("1000") + "Boundary/Clamped = left\n";
  for (const std::string length : {"10", "20", "50"})
    scenes.push_back({"cantilever " + length + ":1",
                      steel + "Geometry/Upper right = " + length +
                        ", 1\nBoundary/Traction = top: 0; -0.1\n" + gap("0.001*" + length),
                      {1, 2, 3}});
  scenes.push_back(
    {"free cantilever 10:1",
     steel + "Geometry/Upper right = 10, 1\nLoad/Body force = 0; -0.1\n" + gap("1000"),
     {2}});
  const std::string beam = "Geometry/Upper right = 100, 1\nBoundary/Clamped = left right\n"
                           "Load/Body force = 0; -1\n" +
                           modulus("1e6");
  scenes.push_back({"beam 100 x 1 on 32 x 32 cells", beam + gap("1"), {5}, 7});
  scenes.push_back({"beam 100 x 1 onto a step", beam + gap("(abs(x-50) < 5) ? 0.1 : 1"), {4}});
}

/** Data with periods below the size of cells, and between the points of the system's rules. */
inline void add_fine_data(Scenes &scenes) {
  const std::string free = one + clamped_top + gap("0.1");
  const auto force = [&](const std::string &f) { return free + "Load/Body force = " + f + "\n"; };
  const auto traction = [&](const std::string &t) {
    return free + "Boundary/Traction = " + t + "\n";
  };
  const std::string peak = "100*exp(-((x-0.53)^2+(y-0.51)^2)/0.0001)";
  scenes.insert(
    scenes.end(),
    {{"gap waves", one + lowered("0.01") + gap("0.01*sin(40*pi*x)^2"), {2, 3, 4}, 7},
     {"body force waves", force("sin(40*pi*x)*cos(36*pi*y); cos(40*pi*x)"), {2, 3, 4}, 7},
     {"E(y) waves", modulus("10^sin(40*pi*y)") + lowered("0.01") + gap("0.01*x^2"), {2, 3, 4}, 7},
     {"traction waves", traction("left: sin(50*pi*y); 0 | right: 0; sin(50*pi*y)"), {3}, 7},
     {"narrow peak of the gap",
      one + lowered("0.01") + gap("0.011 - 0.05*exp(-((x-0.547)/0.01)^2)"),
      {1, 2}},
     {"narrow traction", traction("right: 10*exp(-((y-0.53)/0.005)^2); 0"), {1, 2}},
     {"narrow body force", force("0; -" + peak), {1, 2}},
     {"concentrated force", force("0; " + peak), {2, 3}}});
  // A side of the mesh cannot follow.
  for (const auto &[name, u, level] : {std::tuple("waves", "0.01*sin(20*pi*x); 0", 3U),
                                       std::tuple("zero at all nodes", "0; 0.001*sin(16*pi*x)", 3U),
                                       std::tuple("parabola", "0; -0.1*x*(1-x)", 2U)})
    scenes.push_back({"prescribed, " + std::string(name),
                      one + gap("0.1") + "Boundary/Displacement = top: " + u + "\n",
                      {level}});
}

/** Materials that change within cells. */
inline void add_fine_materials(Scenes &scenes) {
  const std::string gently = lowered("0.01") + gap("0.01*x^2"),
                    strongly = lowered("0.1") + gap("0.1*x^2");
  struct Layers {
    std::string name, modulus, rest, kinks = "";
  };
  for (const Layers &given : std::vector<Layers>{
         {"eight sharp layers", "(sin(8*pi*y) > 0) ? 1 : 1e-3", gently,
          "0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875"},
         {"stiff fibres", "(sin(16*pi*x) > 0.95) ? 1000 : 1",
          clamped_top + "Boundary/Traction = right: 0.1; 0.05\n" + gap("0.01*x")},
         {"checkerboard 1 to 1e-3", "(sin(8*pi*x)*sin(8*pi*y) > 0) ? 1 : 1e-3", gently},
         {"thin soft layer along edges", "(abs(y-0.5) < 0.005) ? 0.001 : 1", strongly,
          "0.495, 0.505"},
         {"thin soft layer inside of cells", "(abs(y-0.53) < 0.01) ? 0.001 : 1", strongly},
         {"thin stiff layer", "(abs(y-0.53) < 0.01) ? 1000 : 1", strongly, "0.52, 0.54"}}) {
    const std::string text = modulus(given.modulus) + given.rest;
    scenes.push_back({given.name, text, {2, 3}, 7});
    if (!given.kinks.empty())
      scenes.push_back({given.name + ", kinks given",
                        text + "Discretization/Kinks at y = " + given.kinks + "\n",
                        {2, 3},
                        7});
  }
}

inline void add_locking(Scenes &scenes) {
  const auto ratio = [](const std::string &nu) {
    return "Material/Poisson's ratio = " + nu + "\n";
  };
  const std::string slope = one + pulled + gap("0.01*x");
  scenes.push_back({"nu = 0.4999", slope + ratio("0.4999"), {2, 3, 4}});
  scenes.push_back({"nu = -0.999, plane stress",
                    slope + ratio("-0.999") + "Material/Plane state = stress\n",
                    {2, 3, 4}});
  for (const std::string nu : {"0.3", "0.499"})
    scenes.push_back({"pad 50 x 1, nu = " + nu,
                      one + ratio(nu) + "Geometry/Upper right = 50, 1\n" + lowered("0.05") +
                        gap("0.0001*(x-20)^2"),
                      {2, 3}});
}

/** Conditions that meet, shapes of cells, laws, gaps that jump, and a P that is far from the
 * solution of the dual problem. */
inline void add_mixed(Scenes &scenes) {
  const std::string rectangle = clamped_top + "Boundary/Traction = right: 0.1; 0.2*y*y\n"
                                              "Load/Body force = 0.1+x*y; -0.5*x-sin(3*y)\n",
                    loaded = rectangle + gap("-0.05+0.1*x"),
                    pentagon = "Geometry/Shape = polygon\nBoundary/Rollers = side1\n"
                               "Geometry/Vertices = 0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1\n"
                               "Boundary/Contact = side0 side4\n"
                               "Boundary/Displacement = side3: 0.01; -0.02\n"
                               "Load/Body force = -0.1; -0.2\n",
                    jump = clamped_top + gap("if(x<0.4321, 0.001, -0.002)");
  scenes.insert(
    scenes.end(),
    {{"rollers beside contact",
      one +
        "Boundary/Rollers = left\nBoundary/Traction = top: 0; -0.2\nBoundary/Clamped = right\n" +
        gap("0.1*x*(1-x) + 0.05*(x-0.6)^2"),
      {1, 2, 3}},
     {"contact in a corner",
      one +
        "Boundary/Contact = bottom left\n"
        "Boundary/Displacement = right: -0.05; -0.02 | top: -0.05; -0.02\n" +
        gap("bottom: 0.05*sin(7*x)^2 | left: 0.06*y^2"),
      {1, 2, 3}},
     {"sheared onto a slope",
      one + "Boundary/Displacement = top: 0.3; -0.1\n" + gap("0.2*abs(x - 0.37)"),
      {1, 2, 3}},
     {"stiff along x",
      "Material/Law = orthotropic\nMaterial/Orthotropic moduli = 100; 1; 0.3; 0.5\n"
      "Material/Orientation = 30\n" +
        lowered("0.05") + gap("0.1*x^2"),
      {1, 2, 3}},
     {"rectangles", loaded, {3}},
     {"thin cells", loaded + "Geometry/Upper right = 20, 1\n", {3}},
     {"distorted", loaded + "Geometry/Distortion = 0.2\n", {3}},
     {"patches that end inside faces", loaded + "Discretization/Patches = 3\n", {3}},
     {"plane stress, E(x)",
      loaded + modulus("2+sin(5*x)*y") + "Material/Plane state = stress\n",
      {3}},
     {"B-bar", loaded, {3}, 6, "Discretization/Element = Q1 B-bar\n"},
     {"quadrilateral",
      "Geometry/Shape = polygon\nGeometry/Vertices = 0,0; 1.2,0; 1,0.9; 0.1,1.1\n"
      "Boundary/Clamped = side2\nBoundary/Contact = side0\n"
      "Boundary/Traction = side1: -0.05; 0.02*y | side3: 0.03; -0.01\n"
      "Load/Body force = 0.1+x*y; -0.5*x-sin(3*y)\n" +
        gap("-0.05+0.1*x"),
      {3}},
     {"pentagon", pentagon + gap("0"), {3}, 5},
     {"pentagon on waves", pentagon + gap("0.003*cos(3*x)"), {2}, 5},
     {"two rollers",
      "Boundary/Rollers = left top\nBoundary/Traction = right: -0.2; 0.1*y\n"
      "Load/Body force = 0.1+x*y; -0.5*x-sin(3*y)\n" +
        gap("-0.05+0.1*x"),
      {3}},
     {"plate with a kink of the gap",
      "Geometry/Upper right = 2, 1\nGeometry/Cells = 2, 1\nBoundary/Rollers = left\n"
      "Boundary/Displacement = top: 0; -0.002*(1 - 0.2*x)\nDiscretization/Kinks at x = 0.9\n" +
        gap("0.004*max(0, x-0.9)"),
      {3}},
     {"a gap that jumps", jump, {3}},
     {"a gap that jumps at a kink", jump + "Discretization/Kinks at x = 0.4321\n", {3}},
     {"a gap that jumps at a node", clamped_top + gap("if(x<0.5, -0.002, 0.001)"), {3}},
     {"a gap that jumps upwards", clamped_top + gap("if(x<=0.5, 0.001, -0.002)"), {3}},
     {"stiff layer, PSOR 1e-2",
      "Geometry/Upper right = 8, 1\n" + modulus("(y < 0.25) ? 1000 : 1") + lowered("0.1") +
        gap("0.05*sin(2*x)^2") + "Discretization/Kinks at y = 0.25\n",
      {3, 4, 5},
      7,
      "Solver/Contact solver = psor\nSolver/Tolerance = 1e-2\n"}});
}
} // namespace Unresolved
