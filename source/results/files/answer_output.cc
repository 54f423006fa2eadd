// SPDX-License-Identifier: LGPL-2.1-or-later
// The answer of the finest level on the screen.

#include <signorini/results/files/answer_output.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>
#include <sstream>

#include "answer_json.h"

namespace Signorini
{
namespace
{
constexpr std::size_t line_width = 80;
constexpr std::size_t label_width = 20;

std::string digits(const double value)
{
  std::ostringstream text;
  text << std::setprecision(6) << value;
  return text.str();
}

/** Returns zero for a value that is rounding against @p size. */
double rounded(const double value, const double size)
{
  constexpr double rounding = 1e-11;
  return std::abs(value) <= rounding * size ? 0. : value;
}

std::string percent(const double share)
{
  std::ostringstream text;
  text << std::showpos << std::setprecision(2) << 100. * rounded(share, 1.) << " %";
  return text.str();
}

/** Returns "0.25", of a vector "(0.25, 0)". */
std::string number_text(const Json &x, const double size)
{
  if (x.is_number())
    return digits(rounded(x, size));
  std::string text;
  for (const double component : x)
    text += (text.empty() ? "" : ", ") + digits(rounded(component, size));
  return "(" + text + ")";
}

/** Prints an answer; the size of the body decides which lengths are rounding. */
class AnswerLines
{
public:
  AnswerLines(std::ostream &stream, const std::vector<LevelRecord> &levels)
    : stream_(stream)
    , level_(levels.back())
    , size_(level_.answer.size)
    , scale_(level_.contact.normal_force)
  {
    for (const auto *const forces : {&level_.answer.contact_by_side, &level_.answer.reactions})
      for (const SideForce &force : *forces)
        scale_ = std::max(scale_, force.resultant.force.norm());
  }

  /** Prints a line "label  part part part", broken between parts where it is full. */
  void add(const std::string &label, const std::vector<std::string> &parts)
  {
    std::string line = "  " + label;
    line.resize(std::max(label_width, line.size() + 1), ' ');
    const std::size_t indent = line.size();
    for (const std::string &part : parts)
    {
      if (line.size() > indent && line.size() + 1 + part.size() > line_width)
      {
        stream_ << line << "\n";
        line = std::string(indent, ' ');
      }
      line += (line.size() > indent ? " " : "") + part;
    }
    stream_ << line << "\n";
  }

  void add_forces(const Json &answer)
  {
    const Json &total = answer["contact_force"];
    std::vector<std::string> parts = force_parts(total);
    if (total["error"].is_number() && rounded(total["error"], scale_) > 0.)
      parts.push_back("error at most " + digits(total["error"]));
    add("Contact force", parts);
    if (answer["contact_by_side"].size() > 1)
      for (const Json &force : answer["contact_by_side"])
        add("  on " + std::string(force["side"]), force_parts(force));
    for (const Json &force : answer["reactions"])
      add("Reaction of " + std::string(force["side"]), force_parts(force));
  }

  void add_plates(const Json &answer)
  {
    for (std::size_t i = 0; i < answer["plates"].size(); ++i)
    {
      const Json &plate = answer["plates"][i];
      const bool turns = level_.motions.plates[i].plate.turns;
      std::vector<std::string> parts = {"travel " + number_text(plate["travel"], size_),
                                        "along " + number_text(plate["direction"], 1.) + ",",
                                        "force " + number_text(plate["force"], scale_) +
                                          (turns ? "," : "")};
      if (turns)
        parts.insert(parts.end(),
                     {"rotation " + number_text(plate["rotation"], 1.),
                      "about " + number_text(plate["centre"], size_) + ",",
                      "moment " + number_text(plate["moment"], scale_ * size_)});
      add("Plate on " + std::string(plate["side"]), parts);
    }
    for (const std::string &motion : level_.motions.undetermined)
      add("Undetermined", {motion + ":", "nothing resists it,", "it is taken as zero"});
  }

  /** Prints a maximum, and below it that away from the place where it grows. */
  void add_maximum(const std::string &label, const Json &maximum)
  {
    const Json &place = maximum["grows_at"];
    add(label, maximum_parts(maximum, place));
    if (!place.is_null() && !maximum["away"].is_null())
      add("  farther than " + digits(place["radius"]), maximum_parts(maximum["away"], nullptr));
  }

  void add_zones(const Json &answer)
  {
    if (answer.contains("contact_area"))
      add("Contact area", {digits(answer["contact_area"])});
    for (std::size_t i = 0; i < answer["contact_zones"].size(); ++i)
    {
      const Json &zone = answer["contact_zones"][i];
      const auto &[start, end, length] = level_.answer.zones[i];
      const std::string side = start.place.side;
      if (start.place.point.distance(end.place.point) <= 1e-10 * size_)
        add("Contact zone", {"all around " + side + ",", "length", digits(length)});
      else
        add("Contact zone",
            {side + " from",
             end_text(zone["start"]),
             "to",
             end_text(zone["end"]) + ",",
             "length",
             digits(length)});
    }
  }

  void add_penetration(const Json &deepest)
  {
    if (deepest.is_null())
      return;
    const double depth = rounded(deepest["value"], size_);
    std::vector<std::string> parts = {digits(std::abs(depth)), at(deepest)};
    if (depth > 0.)
    {
      parts.insert(parts.begin(), "at most");
      if (!level_.sizes.is_graded())
        parts.emplace_back("(between the means)");
    }
    if (depth == 0.)
      parts = {"none"};
    add(depth < 0. ? "Smallest opening" : "Penetration", parts);
  }

  void add_energy(const Json &energy)
  {
    std::vector<std::string> parts = {digits(energy["value"])};
    if (energy["lower"].is_number() && energy["upper"].is_number())
      parts.insert(
        parts.end(),
        {"(exact: between", digits(energy["lower"]), "and", digits(energy["upper"]) + ")"});
    add("Energy", parts);
  }

  void add_load_cases()
  {
    if (!level_.load_cases)
      return;
    const CaseSummary &cases = *level_.load_cases;
    std::vector<std::string> parts = {std::to_string(cases.n_cases) + " in cases.csv,",
                                      "KKT residuals up to " + digits(cases.max_kkt) +
                                        (cases.n_escapes > 0 ? ";" : "")};
    if (cases.n_escapes > 0)
      parts.push_back("in " + std::to_string(cases.n_escapes) + " of them nothing stops the body");
    add("Load cases", parts);
  }

private:
  std::vector<std::string> force_parts(const Json &force) const
  {
    std::vector<std::string> parts = {number_text(force["force"], scale_)};
    if (!force["through"].is_null())
      parts.insert(parts.end(),
                   {"through",
                    number_text(force["through"], size_) + ",",
                    "moment " + number_text(force["moment"],
                                            scale_ * (force["moment"].is_number() ? size_ : 1.))});
    return parts;
  }
  std::string at(const Json &place) const
  {
    return "on " + std::string(place["side"]) + " at " + number_text(place["point"], size_);
  }
  std::string end_text(const Json &end) const
  {
    const std::string point = number_text(end["point"], size_);
    return end["uncertainty"] > 0. ? point + " +- " + digits(end["uncertainty"]) : point;
  }
  /** Returns value and place, "settled (-1 % from the level before)" with the @p place where the
   * value grows, and the mean of the patch. */
  std::vector<std::string> maximum_parts(const Json &maximum, const Json &place) const
  {
    const bool is_pressure = maximum.contains("mean");
    std::vector<std::string> parts = {digits(maximum["value"])};
    if (is_pressure)
      parts.push_back(at(maximum) + ",");
    else
      parts.insert(parts.end(), {"at", number_text(maximum["point"], size_) + ","});
    const std::string change =
      maximum["change"].is_null()
        ? ""
        : "(" + percent(maximum["change"]) + " from the " + level_.sizes.word() + " before)";
    std::string trend = maximum["trend"];
    if (place.is_null())
      trend += change.empty() ? "" : " " + change;
    parts.push_back(trend);
    if (!place.is_null())
    {
      parts.push_back(place.contains("point")
                        ? "at the corner " + number_text(place["point"], size_)
                        : "at the edge from " + number_text(place["ends"][0], size_) + " to " +
                            number_text(place["ends"][1], size_));
      if (!change.empty())
        parts.push_back(change);
    }
    if (is_pressure)
    {
      parts.back() += ";";
      const double mean = maximum["mean"], value = maximum["value"];
      parts.insert(parts.end(),
                   {"mean of its patch", digits(mean), "(" + percent(mean / value - 1.) + ")"});
    }
    return parts;
  }

  std::ostream &stream_;
  const LevelRecord &level_;
  /** The size of the body, and that of the forces. */
  double size_, scale_;
};
} // namespace

void print_answer(std::ostream &stream,
                  const std::vector<LevelRecord> &levels,
                  const std::filesystem::path &directory)
{
  stream << "Answer of " << levels.back().sizes.word() << " " << levels.back().sizes.level
         << (levels.back().answer.dimension == 2 ? ", per unit of thickness" : "")
         << " (pressure: positive in compression)\n";
  const Json answer = answer_of(levels, StudyVerdict());
  AnswerLines lines(stream, levels);
  lines.add_forces(answer);
  lines.add_plates(answer);
  if (answer["peak_pressure"].is_null())
    lines.add("Peak pressure", {"0: nothing touches"});
  else
    lines.add_maximum("Peak pressure", answer["peak_pressure"]);
  lines.add_zones(answer);
  lines.add_penetration(answer["penetration"]);
  lines.add_maximum("Von Mises stress", answer["von_mises"]);
  lines.add_energy(answer["energy"]);
  lines.add_load_cases();
  // Tests of runs leave out lines of this form.
  lines.add("Time =", {digits(std::round(1000. * double(answer["seconds"])) / 1000.), "s"});
  if (!directory.empty())
    lines.add("Results", {"in", directory.string()});
}
} // namespace Signorini
