// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/displacement_space.h>

#include <sstream>
#include <string>
#include <vector>

namespace Signorini
{
/** A point of the body as it is drawn. */
struct DrawnPoint
{
  Point<2> x;
  Tensor<1, 2> u;
  /** The von Mises stress (force/area); NaN where the material's data has no value. */
  double von_mises = 0.;
};

/** A cell as n by n quadrilaterals: their (n+1)² corners, row after row. */
struct DrawnCell
{
  unsigned int n = 1;
  std::vector<DrawnPoint> points;
  /** Whether each edge is at the boundary: left, right, bottom, top in the order of the rows. */
  bool at_boundary[4] = {false, false, false, false};

  const DrawnPoint &point(const unsigned int i, const unsigned int j) const
  {
    return points[j * (n + 1) + i];
  }
};

/** Returns the cells of the mesh, or where these are many their ancestors, with the values that are
 * drawn. Large cells are divided so that colours change smoothly. Not collective. */
std::vector<DrawnCell> collect_drawn_cells(const DisplacementSpace<2> &space,
                                           const Scene<2> &scene,
                                           const Displacement &U);

/** Colours that people with any colour vision tell apart (Okabe and Ito, 2008). */
namespace Colour
{
constexpr const char *blue = "#0072B2", *orange = "#E69F00", *vermilion = "#D55E00",
                     *green = "#009E73", *black = "#222222", *grey = "#888888",
                     *pale_blue = "#DCEAF4", *foundation = "#B5B0A8";
} // namespace Colour

/** Writes the beginning of every script: an SVG of a size in pixels, with grid and fonts. */
void start_script(std::ostream &script, unsigned int width, unsigned int height);

/** Returns a number as gnuplot reads it: NaN leaves a hole in a curve. */
std::string plot_number(double value);

/** Returns a text in quotes for gnuplot: names may contain any character. */
std::string plot_text(const std::string &text);
} // namespace Signorini
