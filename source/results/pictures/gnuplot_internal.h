// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <sstream>
#include <string>

namespace Signorini
{
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
