// SPDX-License-Identifier: LGPL-2.1-or-later
// The answer of the finest level on the screen.

#include <signorini/base/text.h>
#include <signorini/results/output/answer_output.h>

#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <sstream>

#include "answer_json.h"

namespace Signorini {
namespace {
constexpr std::size_t line_width = 80;
constexpr std::size_t label_width = 20;

std::string digits(const double value) {
  std::ostringstream text;
  text << std::setprecision(6) << value;
  return text.str();
}

/** Returns zero for a value that is rounding against @p size. */
double rounded(const double value, const double size) {
  constexpr double rounding = 1e-11;
  return std::abs(value) <= rounding * size ? 0. : value;
}

std::string signed_percent(const double share) {
  std::ostringstream text;
  text << std::showpos << std::setprecision(2) << 100. * rounded(share, 1.) << " %";
  return text.str();
}

/** Returns "0.25", of a vector "(0.25, 0)". */
std::string scaled_text(const Json &x, const double size) {
  if (x.is_number())
    return digits(rounded(x, size));
  std::string text;
  for (const double component : x)
    text += (text.empty() ? "" : ", ") + digits(rounded(component, size));
  return "(" + text + ")";
}

/** Prints an answer; the size of the body decides which lengths are rounding. */
class AnswerLines {
public:
  AnswerLines(std::ostream &stream, const std::vector<LevelRecord> &levels)
    : stream_(stream)
    , level_(levels.back())
    , size_(level_.answer.size)
    , scale_(level_.contact.normal_force) {
    for (const auto *const forces : {&level_.answer.contact_by_side, &level_.answer.reactions})
      for (const SideForce &force : *forces)
        scale_ = std::max(scale_, force.resultant.force.norm());
  }

  /** Prints a line "label  text", broken where it is full: at commas and semicolons, or at blanks
   * of a phrase that is longer than a line, outside of parentheses. */
  void add(const std::string &label, const std::string &text) {
    std::string line = "  " + label;
    line.resize(std::max(label_width, line.size() + 1), ' ');
    const std::size_t indent = line.size();
    std::vector<std::string> phrases;
    for (const std::string &word : split_list(text, ' '))
      if (!phrases.empty() && std::strchr(",;", phrases.back().back()) == nullptr &&
          indent + phrases.back().size() + 1 + word.size() <= line_width)
        phrases.back() += " " + word;
      else
        phrases.push_back(word);
    for (const std::string &phrase : phrases) {
      if (line.size() > indent && line.size() + 1 + phrase.size() > line_width) {
        stream_ << line << "\n";
        line = std::string(indent, ' ');
      }
      line += (line.size() > indent ? " " : "") + phrase;
    }
    stream_ << line << "\n";
  }

  void add_forces(const Json &answer) {
    const Json &total = answer["contact_force"];
    const bool is_uncertain = total["error"].is_number() && rounded(total["error"], scale_) > 0.;
    add("Contact force",
        force_text(total) + (is_uncertain ? ", error at most " + digits(total["error"]) : ""));
    if (answer["contact_by_side"].size() > 1)
      for (const Json &force : answer["contact_by_side"])
        add("  on " + std::string(force["side"]), force_text(force));
    for (const Json &force : answer["reactions"])
      add("Reaction of " + std::string(force["side"]), force_text(force));
  }

  void add_plates(const Json &answer) {
    for (std::size_t i = 0; i < answer["plates"].size(); ++i) {
      const Json &plate = answer["plates"][i];
      std::string text = "travel " + scaled_text(plate["travel"], size_) + " along " +
                         scaled_text(plate["direction"], 1.) + ", force " +
                         scaled_text(plate["force"], scale_);
      if (level_.motions.plates[i].plate.drifts)
        text += ", drift " + scaled_text(plate["drift"], size_) + " across, force " +
                scaled_text(plate["cross_force"], scale_);
      if (level_.motions.plates[i].plate.turns)
        text += ", rotation " + scaled_text(plate["rotation"], 1.) + " about " +
                scaled_text(plate["centre"], size_) + ", moment " +
                scaled_text(plate["moment"], scale_ * size_);
      add("Plate on " + std::string(plate["side"]), text);
    }
    for (const std::string &motion : level_.motions.undetermined)
      add("Undetermined", motion + ": nothing resists it, its size means nothing");
  }

  /** Prints a maximum, and below it that away from the place where it grows. */
  void add_maximum(const std::string &label, const Json &maximum) {
    const Json &place = maximum["grows_at"];
    add(label, maximum_text(maximum, place));
    if (!place.is_null() && !maximum["away"].is_null())
      add("  farther than " + digits(place["radius"]), maximum_text(maximum["away"], nullptr));
  }

  void add_reports(const Json &answer) {
    if (!answer.contains("reports"))
      return;
    for (const Json &report : answer["reports"]) {
      std::string label = report["place"];
      if (label.size() + 2 >= label_width) {
        stream_ << "  " << label << "\n";
        label.clear();
      }
      if (report.contains("values"))
        add(label, point_text(report["values"]));
      else if (!report.contains("von_mises"))
        add(label, report["growth"].empty() ? "no point of this mesh lies there" : "");
      // The other fields at a single point follow from these.
      const bool is_point = report.contains("values");
      for (std::size_t k = 0; k < (is_point ? 1 : n_report_fields); ++k)
        if (const std::string name = to_text(static_cast<ReportField>(k)); report.contains(name))
          add(k == 0 && !is_point ? label : "",
              boost::replace_all_copy(boost::replace_all_copy(name, "_m", " M"), "_", " ") + " " +
                maximum_text(report[name], nullptr));
      for (const Json &place : report["growth"])
        add("", (is_point ? "grows without limit" : "left out") + growth_text(place) +
                  ", closer than " + digits(place["radius"]));
    }
  }

  void add_zones(const Json &answer) {
    if (answer.contains("contact_area"))
      add("Contact area", digits(answer["contact_area"]));
    add_zones("Contact zone", answer["contact_zones"], level_.answer.zones);
    if (!level_.friction)
      return;
    const Json &friction = answer["friction"];
    add("Friction",
        "T = " + scaled_text(friction["tangential_force"], scale_) +
          (friction["ratio"].is_null() ? "" : ", T/N = " + scaled_text(friction["ratio"], 1.)) +
          ", dissipation " + digits(friction["dissipation"]));
    if (answer.contains("contact_area"))
      add("  areas", "stick " + digits(friction["stick_length"]) + ", slip " +
                       digits(friction["slip_length"]) + ", open " +
                       digits(friction["open_length"]));
    add("  limits", text_of_limits(*level_.friction));
    if (level_.friction->is_regular)
      add("  uniqueness", text_of_regularity(*level_.friction));
    add_zones("  stick zone", friction["stick_zones"], level_.friction->stick_zones);
    add_zones("  slip zone", friction["slip_zones"], level_.friction->slip_zones);
  }

  void add_penetration(const Json &deepest) {
    if (deepest.is_null())
      return;
    const double depth = rounded(deepest["value"], size_);
    const std::string text = digits(std::abs(depth)) + " " + at(deepest);
    if (depth == 0.)
      add("Penetration", "none");
    else if (depth < 0.)
      add("Smallest opening", text);
    else
      add("Penetration", "at most " + text +
                           (!presses_at(*level_.answer.penetration) ? " (where nothing presses)"
                            : level_.sizes.is_graded()              ? ""
                                                                    : " (between the means)"));
  }

  void add_energy(const Json &energy) {
    const bool is_bounded = energy["lower"].is_number() && energy["upper"].is_number();
    add("Energy",
        digits(energy["value"]) + (is_bounded ? " (exact: between " + digits(energy["lower"]) +
                                                  " and " + digits(energy["upper"]) + ")"
                                              : ""));
  }

  void add_load_cases() {
    if (!level_.load_cases)
      return;
    const CaseSummary &cases = *level_.load_cases;
    add("Load cases", std::to_string(cases.n_cases) + " in cases.csv, KKT residuals up to " +
                        digits(cases.max_kkt) + ", errors up to " +
                        digits(100. * rounded(cases.max_estimate, 1.)) + " % (estimated)" +
                        (cases.n_escapes > 0 ? "; in " + std::to_string(cases.n_escapes) +
                                                 " of them nothing stops the body"
                                             : ""));
  }

private:
  /** Returns whether something presses near a point of Γ_c; in 3-D, anywhere. */
  bool presses_at(const Penetration &penetration) const {
    const Answer &answer = level_.answer;
    const auto contains = [&](const ContactZone &zone) {
      const double s = penetration.place.arc_length - zone.start.place.arc_length;
      return zone.start.place.side == penetration.place.side && s >= -zone.start.uncertainty &&
             s <= zone.length + zone.end.uncertainty;
    };
    return answer.dimension == 3 ? answer.peak_pressure.has_value()
                                 : std::any_of(answer.zones.begin(), answer.zones.end(), contains);
  }
  static std::string text_of_limits(const FrictionSummary &friction) {
    const double largest = friction.largest_share;
    return "T takes " + digits(100. * rounded(friction.carried_share, 1.)) +
           " % of what friction can carry" +
           (largest > 0. && largest < 1. - 1e-9
              ? "; all sticks, down to " + digits(largest) + " times this friction"
              : "");
  }
  /** A solution is never called unique: that is not proved. */
  static std::string text_of_regularity(const FrictionSummary &friction) {
    const std::optional<double> critical = friction.critical_factor;
    if (!*friction.is_regular)
      return "this is one of at least two solutions (sign of the determinant)";
    if (!critical)
      return "these zones are regular for every coefficient";
    return (*critical < 1.5 ? "other solutions may exist: " : std::string()) +
           "these zones lose uniqueness at " + digits(*critical) + " times the coefficient";
  }
  void add_zones(const std::string &label, const Json &json,
                 const std::vector<ContactZone> &zones) {
    for (std::size_t i = 0; i < zones.size(); ++i) {
      const auto &[start, end, length] = zones[i];
      const std::string side = start.place.side;
      const bool all_around = start.place.point.distance(end.place.point) < 1e-10 * length;
      add(label, (all_around ? "all around " + side
                             : side + " from " + end_text(json[i]["start"]) + " to " +
                                 end_text(json[i]["end"])) +
                   ", length " + digits(length));
    }
  }
  std::string force_text(const Json &force) const {
    std::string text = scaled_text(force["force"], scale_);
    if (level_.answer.axisymmetric)
      return scaled_text(force["force"][1], scale_) + " along the axis, " +
             scaled_text(force["force"][0], scale_) + " outward in all";
    if (force["through"].is_null())
      return text;
    const Json &moment = force["moment"];
    return text + " through " + scaled_text(force["through"], size_) + ", moment " +
           scaled_text(moment, scale_ * (moment.is_number() ? size_ : 1.));
  }
  /** Returns " at the corner (0, 0) like r^-0.455". */
  std::string growth_text(const Json &place) const {
    std::ostringstream power;
    power << std::setprecision(2) << double(place["exponent"]) - 1.;
    return (place.contains("point") ? " at the corner " + scaled_text(place["point"], size_)
                                    : " at the edge from " + scaled_text(place["ends"][0], size_) +
                                        " to " + scaled_text(place["ends"][1], size_)) +
           " like r^" + power.str();
  }
  /** Returns "u_x = 0.1, u_y = ...". */
  std::string point_text(const Json &values) const {
    std::string text;
    for (const auto &[name, value] : values.items())
      if (name.size() > 1)
        text += (text.empty() ? "" : ", ") + name + " = " +
                scaled_text(value, name[0] == 'u' ? size_ : 0.);
    return text;
  }
  std::string at(const Json &place) const {
    return "on " + std::string(place["side"]) + " at " + scaled_text(place["point"], size_);
  }
  std::string end_text(const Json &end) const {
    const std::string point = scaled_text(end["point"], size_);
    return end["uncertainty"] > 0. ? point + " +- " + digits(end["uncertainty"]) : point;
  }
  /** Returns value and place, "settled (-1 % from the level before)" with the @p place where the
   * value grows, and the mean of the patch. */
  std::string maximum_text(const Json &maximum, const Json &place) const {
    const bool is_pressure = maximum.contains("mean");
    std::string text = digits(maximum["value"]) + " " +
                       (is_pressure ? at(maximum) : "at " + scaled_text(maximum["point"], size_)) +
                       ", " + std::string(maximum["trend"]);
    if (!place.is_null())
      text += growth_text(place);
    if (!maximum["change"].is_null())
      text +=
        " (" + signed_percent(maximum["change"]) + " from the " + level_.sizes.word() + " before)";
    if (is_pressure) {
      const double mean = maximum["mean"], value = maximum["value"];
      text +=
        "; mean of its patch " + digits(mean) + " (" + signed_percent(mean / value - 1.) + ")";
    }
    return text;
  }

  std::ostream &stream_;
  const LevelRecord &level_;
  /** The size of the body, and that of the forces. */
  double size_, scale_;
};
} // namespace

void print_answer(std::ostream &stream, const std::vector<LevelRecord> &levels,
                  const std::filesystem::path &directory) {
  const Answer &finest = levels.back().answer;
  stream << "Answer of " << levels.back().sizes.word() << " " << levels.back().sizes.level
         << (finest.axisymmetric      ? ", all around the axis"
             : finest.dimension == 3  ? ""
             : finest.thickness == 1. ? ", per unit of thickness"
                                      : ", for the thickness " + digits(finest.thickness))
         << " (pressure: positive in compression)\n";
  const Json answer = answer_of(levels, StudyVerdict());
  AnswerLines lines(stream, levels);
  lines.add_forces(answer);
  lines.add_plates(answer);
  if (answer["peak_pressure"].is_null())
    lines.add("Peak pressure", "0: nothing touches");
  else
    lines.add_maximum("Peak pressure", answer["peak_pressure"]);
  lines.add_zones(answer);
  lines.add_penetration(answer["penetration"]);
  lines.add_maximum("Von Mises stress", answer["von_mises"]);
  lines.add_reports(answer);
  lines.add_energy(answer["energy"]);
  lines.add_load_cases();
  // Tests of runs leave out lines of this form.
  lines.add("Time =", digits(std::round(1000. * double(answer["seconds"])) / 1000.) + " s");
  if (!directory.empty())
    stream << "  Results           in " << directory.string() << "\n";
}
} // namespace Signorini
