// SPDX-License-Identifier: LGPL-2.1-or-later
// Force, peak and zone of load cases.

#include <signorini/pictures/travel_picture.h>

#include <cmath>
#include <stdexcept>

#include "script.h"

namespace Signorini
{
namespace
{
/** One of the three diagrams, with a point for each case where these are few. */
void plot_cases(std::ostream &script,
                const std::string &x_label,
                const std::string &y_label,
                const std::string &columns,
                const char *colour,
                const bool with_points)
{
  script << "set xlabel " << plot_text(x_label) << "\nset ylabel " << plot_text(y_label)
         << "\nplot $cases using " << columns << " with "
         << (with_points ? "linespoints pt 7 ps 0.5" : "lines") << " lw 1.6 lc rgb \"" << colour
         << "\" notitle\n";
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
  for (std::size_t i = 0; i < n; ++i)
    script << plot_number(cases.travel[i]) << " "
           << plot_number(std::hypot(cases.force_x[i], cases.force_y[i])) << " "
           << plot_number(cases.peak[i]) << " " << plot_number(cases.zone_length[i]) << "\n";
  script << "END_OF_DATA\nset lmargin 12\nset rmargin 3\nset multiplot layout 1,3\n";
  constexpr std::size_t most_with_points = 40;
  const bool with_points = n <= most_with_points;
  const std::string force = "contact force |F| (force)";
  plot_cases(script, "travel (length)", force, "1:2", Colour::blue, with_points);
  plot_cases(script, force, "peak pressure (force/area)", "2:3", Colour::vermilion, with_points);
  plot_cases(script, force, "length of contact (length)", "2:4", Colour::green, with_points);
  script << "unset multiplot\n";
  return Picture{"travel.svg", "Contact force against travel, pressure and zone", script.str()};
}
} // namespace Signorini
