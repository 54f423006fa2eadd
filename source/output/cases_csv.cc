// SPDX-License-Identifier: LGPL-2.1-or-later
// cases.csv: force against travel, zone against force.

#include <signorini/output/cases_csv.h>

#include <iomanip>
#include <limits>

namespace Signorini
{
namespace
{
using CaseColumn = std::pair<const char *, std::function<double(const CaseResult &)>>;

/** Of the first plate; not a number without one. */
double of_first_plate(const CaseResult &result, double PlateMotion::*const part)
{
  return result.plates.empty() ? std::numeric_limits<double>::quiet_NaN()
                               : result.plates.front().*part;
}

const std::vector<CaseColumn> &loads_of_case()
{
  static const std::vector<CaseColumn> columns = {
    {"force", [](const CaseResult &c) { return c.load_case.force; }},
    {"weight", [](const CaseResult &c) { return c.load_case.weight; }},
    {"travel", [](const CaseResult &c) { return c.load_case.travel; }},
    {"gap", [](const CaseResult &c) { return c.load_case.gap; }},
    {"shift_x", [](const CaseResult &c) { return c.load_case.shift[0]; }},
    {"shift_y", [](const CaseResult &c) { return c.load_case.shift[1]; }}};
  return columns;
}

const std::vector<CaseColumn> &answers_of_case()
{
  static const std::vector<CaseColumn> columns = {
    {"contact_force_x", [](const CaseResult &c) { return c.contact.force[0]; }},
    {"contact_force_y", [](const CaseResult &c) { return c.contact.force[1]; }},
    {"contact_moment", [](const CaseResult &c) { return c.contact.moment[0]; }},
    {"peak_pressure", [](const CaseResult &c) { return c.peak_pressure; }},
    {"zone_length", [](const CaseResult &c) { return c.zone_length; }},
    {"zones", [](const CaseResult &c) { return c.n_zones; }},
    {"active", [](const CaseResult &c) { return c.active; }},
    {"plate_travel", [](const CaseResult &c) { return of_first_plate(c, &PlateMotion::travel); }},
    {"plate_rotation",
     [](const CaseResult &c) { return of_first_plate(c, &PlateMotion::rotation); }},
    {"qp_iterations", [](const CaseResult &c) { return c.iterations; }},
    {"kkt", [](const CaseResult &c) { return c.kkt; }}};
  return columns;
}
} // namespace

void write_cases_csv(std::ostream &stream, const std::vector<CaseResult> &cases)
{
  stream << "case";
  for (const auto *const columns : {&loads_of_case(), &answers_of_case()})
    for (const CaseColumn &column : *columns)
      stream << "," << column.first;
  stream << ",state\n" << std::setprecision(16);
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    stream << i + 1;
    for (const CaseColumn &column : loads_of_case())
      stream << "," << column.second(cases[i]);
    for (const CaseColumn &column : answers_of_case())
    {
      stream << ",";
      const double value = column.second(cases[i]);
      if (cases[i].escape.empty() && value == value)
        stream << value;
    }
    stream << ","
           << (!cases[i].escape.empty() ? cases[i].escape
               : cases[i].converged     ? "solved"
                                        : "not converged")
           << "\n";
  }
}
} // namespace Signorini
