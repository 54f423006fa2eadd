// SPDX-License-Identifier: LGPL-2.1-or-later
// Errors over unknowns.

#include <signorini/results/pictures/convergence_picture.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <stdexcept>
#include <utility>

#include "drawn_cells.h"

namespace Signorini
{
namespace
{
/** The smallest relative error that is not rounding. */
constexpr double min_relative_error = 1e-12;

struct ErrorPoint
{
  double unknowns, h, error;
};

struct ErrorCurve
{
  std::string name;
  const char *colour;
  unsigned int symbol;
  std::vector<ErrorPoint> points;
};

/** Returns |||u - u_h|||/|||u_h|||, with the scale of the estimate. */
std::optional<double> true_error(const LevelRecord &level)
{
  if (!level.displacement_errors || !level.estimate || !(level.estimate->energy > 0.) ||
      !(level.estimate->relative > 0.))
    return {};
  return level.displacement_errors->energy * level.estimate->relative / level.estimate->energy;
}

std::optional<double> estimated_error(const LevelRecord &level)
{
  return level.estimate ? std::optional<double>(level.estimate->relative) : std::nullopt;
}

std::optional<double> bound_of_error(const LevelRecord &level)
{
  return level.bound ? level.bound->relative : std::nullopt;
}

std::vector<ErrorPoint> points_of(const std::vector<LevelRecord> &levels,
                                  std::optional<double> (*error_of)(const LevelRecord &))
{
  std::vector<ErrorPoint> points;
  for (const LevelRecord &level : levels)
    if (const std::optional<double> error = error_of(level);
        error && std::isfinite(*error) && *error > min_relative_error)
      points.push_back({static_cast<double>(level.sizes.dofs), level.sizes.h, *error});
  return points;
}

/** Returns the slope of log(error) over log(h), least squares over the last four levels; at least
 * three are necessary. */
std::optional<double> order_of(const std::vector<ErrorPoint> &points)
{
  constexpr std::size_t n_levels = 4, fewest = 3;
  if (points.size() < fewest)
    return {};
  double n = 0., x = 0., y = 0., xx = 0., xy = 0.;
  for (std::size_t i = points.size() - std::min(n_levels, points.size()); i < points.size(); ++i)
  {
    const double a = std::log(points[i].h), b = std::log(points[i].error);
    n += 1.;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  const double determinant = n * xx - x * x;
  return determinant > 0. ? std::optional<double>((n * xy - x * y) / determinant) : std::nullopt;
}

std::string title_of(const ErrorCurve &curve, const bool graded)
{
  const std::optional<double> order = graded ? std::nullopt : order_of(curve.points);
  if (!order)
    return curve.name;
  std::ostringstream text;
  text << curve.name << ", order " << std::fixed << std::setprecision(2) << *order << " in h";
  return text.str();
}

/** Writes the data of a triangle below the curves: order 1 in h is the slope -1/2 over unknowns.
 * @return whether there are enough levels for one. */
bool write_triangle(std::ostream &script, const std::vector<ErrorCurve> &curves)
{
  const std::vector<ErrorPoint> *longest = &curves.front().points;
  double lowest = std::numeric_limits<double>::infinity();
  for (const ErrorCurve &curve : curves)
  {
    if (curve.points.size() > longest->size())
      longest = &curve.points;
    lowest = std::min(lowest, curve.points.back().error);
  }
  if (longest->size() < 2)
    return false;
  constexpr double distance = 0.55;
  const std::size_t last = longest->size() - 1;
  const double right = (*longest)[last].unknowns,
               left = (*longest)[last - std::min<std::size_t>(last, 2)].unknowns,
               bottom = distance * lowest, top = bottom * std::sqrt(right / left);
  // The triangle is a curve, since gnuplot's polygons leave a stray letter in SVG.
  script << "$triangle << END_OF_DATA\n";
  for (const auto &[x, y] : {std::pair(left, top), {right, bottom}, {left, bottom}, {left, top}})
    script << plot_number(x) << " " << plot_number(y) << "\n";
  script << "END_OF_DATA\n"
         << "set label 'order 1 in h' at " << plot_number(std::sqrt(left * right)) << ","
         << plot_number(bottom) << " center offset 0,-0.8 textcolor rgb \"" << Colour::grey
         << "\"\n";
  return true;
}

void set_ranges(std::ostream &script, const std::vector<ErrorCurve> &curves)
{
  double left = std::numeric_limits<double>::infinity(), right = 0., bottom = left, top = 0.;
  for (const ErrorCurve &curve : curves)
    for (const ErrorPoint &point : curve.points)
    {
      left = std::min(left, point.unknowns);
      right = std::max(right, point.unknowns);
      bottom = std::min(bottom, point.error);
      top = std::max(top, point.error);
    }
  // The ranges leave a margin for the triangle and its label below.
  script << "set xrange [" << plot_number(0.7 * left) << ":" << plot_number(1.5 * right)
         << "]\nset yrange [" << plot_number(0.3 * bottom) << ":" << plot_number(2. * top) << "]\n";
}
} // namespace

std::optional<Picture> convergence_picture(const std::vector<LevelRecord> &levels)
{
  if (levels.empty())
    return {};
  const bool graded = levels.back().sizes.is_graded();
  std::vector<ErrorCurve> curves = {
    {"estimated", Colour::blue, 7, points_of(levels, estimated_error)},
    {"error", Colour::black, 5, points_of(levels, true_error)},
    {"bound", Colour::vermilion, 8, points_of(levels, bound_of_error)}};
  curves.erase(std::remove_if(curves.begin(),
                              curves.end(),
                              [](const ErrorCurve &curve) { return curve.points.empty(); }),
               curves.end());
  if (curves.empty())
    return {};
  std::ostringstream script;
  start_script(script, 720, 540);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    script << "$curve" << i << " << END_OF_DATA\n";
    for (const ErrorPoint &point : curves[i].points)
      script << plot_number(point.unknowns) << " " << plot_number(point.error) << "\n";
    script << "END_OF_DATA\n";
  }
  script << "set logscale xy\nset format y '%.0e'\n"
         << "set title 'Relative error of u_h in the energy norm'\n"
         << "set xlabel 'unknowns'\nset ylabel 'relative error'\nset key top right\n";
  set_ranges(script, curves);
  const bool has_triangle = !graded && write_triangle(script, curves);
  for (std::size_t i = 0; i < curves.size(); ++i)
    script << (i == 0 ? "plot " : ", ") << "$curve" << i << " with linespoints lw 1.6 ps 0.9 pt "
           << curves[i].symbol << " lc rgb \"" << curves[i].colour << "\" title "
           << plot_text(title_of(curves[i], graded));
  if (has_triangle)
    script << ", $triangle with lines lc rgb \"" << Colour::grey << "\" notitle";
  script << "\n";
  return Picture{"convergence.svg", "Relative error of u_h in the energy norm", script.str()};
}

// Force, peak and zone of load cases.

namespace
{
/** Returns a distance between tics that leaves a margin for their numbers: about five on the axis.
 */
double distance_of_tics(const std::vector<double> &values)
{
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const double value : values)
    if (std::isfinite(value))
    {
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  const double wanted = (highest - lowest) / 5.;
  if (!(wanted > 0.) || !std::isfinite(wanted))
    return 0.;
  const double power = std::pow(10., std::floor(std::log10(wanted)));
  for (const double factor : {1., 2., 5.})
    if (factor * power >= wanted)
      return factor * power;
  return 10. * power;
}

/** Draws one of the three diagrams, with a point for each case where these are few. */
void plot_cases(std::ostream &script,
                const std::string &x_label,
                const std::string &y_label,
                const double tics,
                const std::string &columns,
                const char *colour,
                const bool with_points)
{
  script << "set xlabel " << plot_text(x_label) << "\nset ylabel " << plot_text(y_label)
         << "\nset xtics " << (tics > 0. ? plot_number(tics) : "autofreq") << "\nplot $cases using "
         << columns << " with " << (with_points ? "linespoints pt 7 ps 0.5" : "lines")
         << " lw 1.6 lc rgb \"" << colour << "\" notitle\n";
}
} // namespace

std::optional<Picture> travel_picture(const TravelCurve &cases)
{
  const std::size_t n = cases.travel.size();
  for (const std::vector<double> *column :
       {&cases.force_x, &cases.force_y, &cases.peak, &cases.zone_length})
    if (column->size() != n)
      throw std::invalid_argument("travel_picture: columns of different sizes");
  if (n < 2)
    return {};
  std::ostringstream script;
  start_script(script, 1200, 420);
  script << "$cases << END_OF_DATA\n";
  std::vector<double> forces;
  for (std::size_t i = 0; i < n; ++i)
    forces.push_back(std::hypot(cases.force_x[i], cases.force_y[i]));
  for (std::size_t i = 0; i < n; ++i)
    script << plot_number(cases.travel[i]) << " " << plot_number(forces[i]) << " "
           << plot_number(cases.peak[i]) << " " << plot_number(cases.zone_length[i]) << "\n";
  script << "END_OF_DATA\nset lmargin 12\nset rmargin 3\nset multiplot layout 1,3\n";
  constexpr std::size_t max_cases_with_points = 40;
  const bool with_points = n <= max_cases_with_points;
  const std::string force = "contact force |F| (force)";
  const double tics = distance_of_tics(forces);
  plot_cases(script,
             "travel (length)",
             force,
             distance_of_tics(cases.travel),
             "1:2",
             Colour::blue,
             with_points);
  plot_cases(
    script, force, "peak pressure (force/area)", tics, "2:3", Colour::vermilion, with_points);
  plot_cases(script, force, "length of contact (length)", tics, "2:4", Colour::green, with_points);
  script << "unset multiplot\n";
  return Picture{"travel.svg", "Contact force against travel, pressure and zone", script.str()};
}
} // namespace Signorini
