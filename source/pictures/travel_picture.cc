// SPDX-License-Identifier: LGPL-2.1-or-later
// Force, peak and zone of load cases.

#include <signorini/pictures/travel_picture.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "script.h"

namespace Signorini
{
namespace
{
/** A distance between tics that leaves room for their numbers: about five on the axis. */
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

/** One of the three diagrams, with a point for each case where these are few. */
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
  constexpr std::size_t most_with_points = 40;
  const bool with_points = n <= most_with_points;
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
