// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/scene.h>
#include <signorini/results/files/contact_files.h>

#include <filesystem>
#include <string>
#include <vector>

namespace Signorini
{
/** A picture before it is drawn. */
struct Picture
{
  /** The name of the file: "pressure.svg". */
  std::string file;
  /** The title, as plain text. */
  std::string title;
  /** The data and commands for gnuplot, without the choice of the terminal's kind. */
  std::string script;
};

/** The text of an SVG file, or one sentence why there is none. */
struct Drawing
{
  std::string svg;
  std::string failure;
};

/**
 * Draws a script with gnuplot. The script is its standard input and the picture its standard
 * output: no shell, no files, no settings of the user. The same script gives the same text.
 */
Drawing draw_with_gnuplot(const Picture &picture);

/**
 * Draws the pictures and writes them into a directory. After a failure no further one is tried.
 * @return one sentence about what is missing and what to do; empty if nothing is.
 * @throws ComputationError if a file cannot be written.
 */
std::string write_pictures(const std::filesystem::path &directory,
                           const std::vector<Picture> &pictures);

/**
 * Returns the contact boundary for pressure_picture(), with so many points on each of its pieces
 * that curves are smooth.
 */
std::vector<ContactSegment> trace_for_pictures(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const Displacement &U,
                                               const Pressure &P);

/**
 * Makes pressure.svg: for every contact side the contact pressure -p (positive in compression; p_H,
 * the recovered pressure, and the exact one where it is known), and below it the opening g - u_n,
 * over arc length. Where p_H presses, the ground is coloured.
 * @param line not empty.
 */
Picture pressure_picture(const Scene<2> &scene, const std::vector<ContactSegment> &line);
} // namespace Signorini
