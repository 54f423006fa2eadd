// SPDX-License-Identifier: LGPL-2.1-or-later
// Pressure and opening over arc length.

#include <signorini/base/errors.h>
#include <signorini/results/pictures/pressure_picture.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gnuplot_internal.h"

namespace Signorini
{
namespace
{
/** The pieces of one contact side, and their name. */
struct DrawnSide
{
  std::string name;
  std::vector<const ContactSegment *> segments;
  bool has_exact_pressure = false;
  bool has_exact_opening = false;
};

std::vector<DrawnSide> sides_of(const Scene<2> &scene, const std::vector<ContactSegment> &line)
{
  std::vector<DrawnSide> sides;
  for (const ContactSegment &segment : line)
  {
    if (sides.empty() || sides.back().segments.front()->side_number != segment.side_number)
      sides.push_back({segment.side, {}, false, scene.exact_displacement != nullptr});
    sides.back().segments.push_back(&segment);
    for (const ContactPoint &point : segment.curve)
      sides.back().has_exact_pressure =
        sides.back().has_exact_pressure || point.p_exact.has_value();
  }
  return sides;
}

/** Returns g - u_n of the exact displacement; NaN where that has no value. */
double exact_opening(const Scene<2> &scene, const ContactPoint &point)
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (scene.exact_displacement == nullptr)
    return unknown;
  try
  {
    dealii::Vector<double> u(2);
    scene.exact_displacement->vector_value(point.x, u);
    return point.g - (u[0] * point.n[0] + u[1] * point.n[1]);
  }
  catch (const InputError &)
  {
    return unknown;
  }
}

/** Returns -p, where zero has no sign. */
double compression(const double p)
{
  return p == 0. ? 0. : -p;
}

/** Writes the curves of a side: s, p_H, recovered and exact pressure, opening, exact opening.
 * Constants jump where two pieces meet, which draws steps. */
void write_data(std::ostream &script,
                const Scene<2> &scene,
                const std::string &name,
                const DrawnSide &side)
{
  constexpr double rounding = 1e-13;
  const double tiny = rounding * scene.geometry.longest_extent();
  script << "$" << name << " << END_OF_DATA\n";
  for (const ContactSegment *segment : side.segments)
    for (const ContactPoint &point : segment->curve)
    {
      const double opening = point.g - point.u_n;
      script << plot_number(point.s) << " " << plot_number(compression(point.p_H)) << " "
             << plot_number(compression(point.p_recovered)) << " "
             << (point.p_exact ? plot_number(compression(*point.p_exact)) : "NaN") << " "
             << plot_number(std::abs(opening) < tiny ? 0. : opening) << " "
             << plot_number(exact_opening(scene, point)) << "\n";
    }
  script << "END_OF_DATA\n";
}

/** Colours the ground where p_H presses. The numbers of objects begin anew with every side. */
void mark_zones(std::ostream &script, const DrawnSide &side, const double largest_pressure)
{
  constexpr double pressing = 1e-10;
  script << "unset object\n";
  bool open = false;
  double start = 0., end = 0.;
  const auto close = [&]() {
    if (open)
      script << "set object rectangle from " << plot_number(start) << ", graph 0 to "
             << plot_number(end) << ", graph 1 behind fillstyle solid noborder fillcolor rgb \""
             << Colour::pale_blue << "\"\n";
    open = false;
  };
  for (const ContactSegment *segment : side.segments)
    for (std::size_t i = 0; i + 1 < segment->curve.size(); ++i)
    {
      const ContactPoint &a = segment->curve[i], &b = segment->curve[i + 1];
      if (-0.5 * (a.p_H + b.p_H) <= pressing * largest_pressure)
        close();
      else
      {
        if (!open)
          start = a.s;
        open = true;
        end = b.s;
      }
    }
  close();
}

/** Returns "$side0 using 1:3 with lines ...". */
std::string curve(const std::string &data,
                  const unsigned int column,
                  const char *style,
                  const char *colour,
                  const std::string &title)
{
  return "$" + data + " using 1:" + std::to_string(column) + " with lines " + style + " lc rgb \"" +
         colour + "\" title " + plot_text(title);
}

void plot_pressure(std::ostream &script, const DrawnSide &side, const std::string &data)
{
  script << "set title " << plot_text("Contact pressure on " + side.name) << "\n"
         << "set ylabel 'contact pressure −p (force/area)'\n"
         << "plot " << curve(data, 2, "lw 1.2", Colour::blue, "p_H") << ", "
         << curve(data, 3, "lw 1.6", Colour::orange, "recovered");
  if (side.has_exact_pressure)
    script << ", " << curve(data, 4, "lw 1.6 dt 2", Colour::black, "exact");
  script << "\n";
}

void plot_opening(std::ostream &script, const DrawnSide &side, const std::string &data)
{
  script << "set title " << plot_text("Opening on " + side.name) << "\n"
         << "set ylabel 'opening g − u_n (length)'\n"
         << "plot " << curve(data, 5, "lw 1.6", Colour::blue, "u_h");
  if (side.has_exact_opening)
    script << ", " << curve(data, 6, "lw 1.6 dt 2", Colour::black, "exact");
  script << "\n";
}
} // namespace

std::vector<ContactSegment> trace_for_pictures(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const Displacement &U,
                                               const Pressure &P)
{
  constexpr std::size_t enough_points = 300;
  const std::size_t n_pieces = std::max<std::size_t>(1, multipliers.surface().pieces().size());
  const std::size_t n_parts = 1 + (enough_points - 1) / n_pieces;
  return trace_contact_line(space, multipliers, U, P, static_cast<unsigned int>(n_parts));
}

Picture pressure_picture(const Scene<2> &scene, const std::vector<ContactSegment> &line)
{
  const std::vector<DrawnSide> sides = sides_of(scene, line);
  double largest_pressure = 0.;
  for (const ContactSegment &segment : line)
    for (const ContactPoint &point : segment.curve)
      largest_pressure = std::max(largest_pressure, -point.p_H);

  constexpr unsigned int most_columns = 3, width = 560, height = 660;
  const unsigned int n_columns = std::min<unsigned int>(sides.size(), most_columns);
  const unsigned int n_rows = (sides.size() + n_columns - 1) / n_columns;
  std::ostringstream script;
  start_script(script, std::max(720U, width * n_columns), height * n_rows);
  for (std::size_t i = 0; i < sides.size(); ++i)
    write_data(script, scene, "side" + std::to_string(i), sides[i]);
  script << "set lmargin 12\nset rmargin 3\nset key top right\nset yrange [*<0:*]\n"
         << "set multiplot layout " << 2 * n_rows << "," << n_columns << "\n";
  // Row by row: the pressures of some sides, then their openings.
  for (std::size_t first = 0; first < sides.size(); first += n_columns)
    for (const bool opening : {false, true})
      for (std::size_t i = first; i < first + n_columns; ++i)
      {
        if (i >= sides.size())
        {
          script << "set multiplot next\n";
          continue;
        }
        const std::string data = "side" + std::to_string(i);
        mark_zones(script, sides[i], largest_pressure);
        script << "set xlabel "
               << (opening ? plot_text("arc length s along " + sides[i].name + " (length)") : "''")
               << "\nset xrange [" << plot_number(sides[i].segments.front()->curve.front().s) << ":"
               << plot_number(sides[i].segments.back()->curve.back().s) << "]\n";
        if (opening)
          plot_opening(script, sides[i], data);
        else
          plot_pressure(script, sides[i], data);
      }
  script << "unset multiplot\n";
  return {"pressure.svg", "Contact pressure and opening along the contact sides", script.str()};
}
} // namespace Signorini
