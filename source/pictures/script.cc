// SPDX-License-Identifier: LGPL-2.1-or-later
// What the scripts of all pictures have in common.

#include "script.h"

#include <cmath>
#include <iomanip>

namespace Signorini
{
void start_script(std::ostream &script, const unsigned int width, const unsigned int height)
{
  script << "set terminal svg size " << width << "," << height
         << " font \"sans-serif,13\" background \"white\" noenhanced\n"
            "set encoding utf8\n"
            "set border lc rgb \""
         << Colour::grey
         << "\"\n"
            "set grid lc rgb \"#DDDDDD\" lw 0.5\n"
            "set tics textcolor rgb \""
         << Colour::black
         << "\"\n"
            "set key textcolor rgb \""
         << Colour::black << "\" samplen 2.5\n";
}

std::string plot_number(const double value)
{
  if (!std::isfinite(value))
    return "NaN";
  std::ostringstream text;
  text << std::setprecision(9) << value;
  return text.str();
}

std::string plot_text(const std::string &text)
{
  // Nothing is replaced in single quotes, but for a quote, which is written twice.
  std::string result = "'";
  for (const char c : text)
    result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}
} // namespace Signorini
