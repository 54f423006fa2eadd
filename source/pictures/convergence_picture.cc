// SPDX-License-Identifier: LGPL-2.1-or-later
// Errors over unknowns.

#include <signorini/pictures/convergence_picture.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <utility>

#include "script.h"

namespace Signorini
{
namespace
{
/** Relative errors below are rounding. */
constexpr double smallest_relative_error = 1e-12;

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

/** |||u - u_h|||/|||u_h|||, with the scale of the estimate. */
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
        error && std::isfinite(*error) && *error > smallest_relative_error)
      points.push_back({static_cast<double>(level.sizes.dofs), level.sizes.h, *error});
  return points;
}

/** The slope of log(error) over log(h), least squares over the last four levels; needs three. */
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

/** Order 1 in h is the slope -1/2 over unknowns: the data of a triangle below the curves. @return
 * whether there are enough levels for one. */
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
  // Drawn as a curve, since gnuplot's polygons leave a stray letter in SVG.
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
  // Room for the triangle and its label below.
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
} // namespace Signorini
