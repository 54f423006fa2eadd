// SPDX-License-Identifier: LGPL-2.1-or-later
// The answer of the finest level on the screen.

#include <signorini/base/text.h>
#include <signorini/results/output/answer_output.h>

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <sstream>

#include "answer_summary.h"

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

std::string scaled_text(const double x, const double size) {
  return digits(rounded(x, size));
}
/** Returns "(0.25, 0)", of one number "0.25". */
std::string scaled_text(const AnswerVector &x, const double size) {
  if (x.size() == 1)
    return scaled_text(x[0], size);
  std::vector<std::string> texts;
  for (const double component : x)
    texts.push_back(scaled_text(component, size));
  return "(" + join(texts) + ")";
}

/** Returns "1.234567 +- 1.2e-06", with the digits that are known. */
std::string bounded_text(const double value, const double error) {
  const double known = std::log10(std::abs(value) / error);
  std::ostringstream text;
  text << std::setprecision(known > 5. ? static_cast<int>(std::min(known, 13.)) + 2 : 6) << value
       << " +- " << std::setprecision(2) << 1.05 * error;
  return text.str();
}
/** Returns "1.234567 +- 1.2e-06 at most (guaranteed)", or why there is no interval. */
std::string interval_text(const BoundedValue &mean) {
  return mean.error ? bounded_text(mean.value, *mean.error) + " at most (guaranteed)"
                    : digits(mean.value) + ": no interval, because " + mean.missing;
}

/** Prints an answer; the size of the body decides which lengths are rounding. */
class AnswerLines {
public:
  AnswerLines(std::ostream &stream, const AnswerSummary &summary)
    : stream_(stream)
    , summary_(summary)
    , level_(summary.level)
    , size_(level_.answer.size)
    , scale_(level_.contact.normal_force) {
    const auto count = [this](const SideForce &force) {
      scale_ = std::max(scale_, force.resultant.force.norm());
    };
    const Answer &answer = level_.answer;
    std::for_each(answer.contact_by_side.begin(), answer.contact_by_side.end(), count);
    std::for_each(answer.reactions.begin(), answer.reactions.end(), count);
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

  void add_forces() {
    const Answer &answer = level_.answer;
    const double error = level_.bound ? level_.bound->force_error.value_or(0.) : 0.;
    add("Contact force", force_text(answer.contact_force) +
                           (rounded(error, scale_) > 0. ? ", error at most " + digits(error) : ""));
    if (answer.contact_by_side.size() > 1)
      for (const ContactForce &force : answer.contact_by_side)
        add("  on " + name_of(force), force_text(force));
    for (const SideForce &force : answer.reactions)
      add("Reaction of " + force.side, force_text(force));
  }

  void add_plates() {
    for (const PlateRecord &plate : level_.motions.plates) {
      std::string text = "travel " + scaled_text(plate.travel, size_) + " along " +
                         scaled_text(plate.direction, 1.) + ", force " +
                         scaled_text(plate.force, scale_);
      if (plate.drifts)
        text += ", drift " + scaled_text(plate.drift, size_) + " across, force " +
                scaled_text(plate.cross_force, scale_);
      if (plate.turns)
        text += ", rotation " + scaled_text(plate.rotation, 1.) + " about " +
                scaled_text(plate.centre, size_) + ", moment " +
                scaled_text(plate.moment, scale_ * size_);
      add("Plate on " + plate.side, text);
    }
    for (const std::string &motion : level_.motions.undetermined)
      add("Undetermined", motion + ": nothing resists it, its size means nothing");
  }

  /** Prints a PeakPressure or VonMises, and below it that away from where it grows. */
  template <typename Maximum>
  void add_maximum(const std::string &label, const Maximum &maximum, const MaximumTrends &trends) {
    add(label, maximum_text(maximum, trends.all, maximum.grows_at));
    if (maximum.grows_at && maximum.away)
      add("  farther than " + digits(maximum.grows_at->radius),
          maximum_text(*maximum.away, trends.away));
  }

  void add_reports() {
    for (std::size_t i = 0; i < level_.answer.reports.size(); ++i) {
      const ProbeReport &report = level_.answer.reports[i];
      std::string label = report.probe;
      if (label.size() + 2 >= label_width) {
        stream_ << "  " << label << "\n";
        label.clear();
      }
      const bool is_point = report.rows.size() == 1;
      if (is_point)
        add(label, point_text(values_at_point(report, level_.answer.dimension)));
      else if (report.extremes.empty())
        add(label, report.growth.empty() ? "no point of this mesh lies there" : "");
      // The other fields at a single point follow from these.
      for (std::size_t k = 0; k < report.extremes.size() && !(is_point && k > 0); ++k) {
        std::string name = to_text(static_cast<ReportField>(k));
        boost::replace_all(name, "_m", " M");
        boost::replace_all(name, "_", " ");
        add(k == 0 && !is_point ? label : "",
            name + " " + maximum_text(report.extremes[k], summary_.reports[i][k]));
      }
      for (const BoundedValue &mean : report.means)
        add("", mean.name + " " + interval_text(mean));
      for (const GrowthEdge &edge : report.growth)
        add("", (is_point ? "grows without limit" : "left out") + growth_text(edge) +
                  ", closer than " + digits(edge.radius));
    }
  }

  void add_zones() {
    const bool in_space = level_.answer.dimension == 3;
    if (in_space)
      add("Contact area", digits(level_.contact.length));
    // A zone that is alone has the force and the peak of all contact.
    const std::vector<ContactZone> &zones = level_.answer.zones;
    for (std::size_t i = 0; i < zones.size(); ++i) {
      if (!in_space || zones.size() > 1)
        add_zones("Contact zone", {zones[i]});
      if (zones.size() == 1)
        continue;
      const ContactForce &force = level_.answer.zone_forces[i];
      add("  its force", force_text(force));
      if (force.peak)
        add("  its peak",
            digits(force.peak->value) + " at " + scaled_text(force.peak->at.point, size_));
    }
    if (!level_.tangential)
      return;
    const TangentialSummary &part = *level_.tangential;
    add("Friction",
        "T = " + scaled_text(part.tangential_force, scale_) +
          (summary_.tangential_ratio ? ", T/N = " + scaled_text(*summary_.tangential_ratio, 1.)
                                     : "") +
          ", dissipation " + digits(part.dissipation));
    if (in_space)
      add("  areas", "stick " + digits(part.stick_length) + ", slip " + digits(part.slip_length) +
                       ", open " + digits(part.open_length));
    add("  limits", text_of_limits(part));
    if (part.is_regular)
      add("  uniqueness", text_of_regularity(part));
    add_zones("  stick zone", part.stick_zones);
    add_zones("  slip zone", part.slip_zones);
  }

  void add_penetration() {
    const std::optional<Penetration> &deepest = level_.answer.penetration;
    if (!deepest)
      return;
    const double depth = rounded(deepest->value, size_);
    const std::string text = digits(std::abs(depth)) + " " + at(deepest->at);
    if (depth == 0.)
      add("Penetration", "none");
    else if (depth < 0.)
      add("Smallest opening", text);
    else
      add("Penetration", "at most " + text +
                           (!presses_at(*deepest)      ? " (where nothing presses)"
                            : level_.sizes.is_graded() ? ""
                                                       : " (zero in the mean over each patch)"));
  }

  void add_energy() {
    // The files have all digits.
    constexpr double shown = 1e-7;
    const ErrorBound bound = level_.bound.value_or(ErrorBound());
    std::string text = digits(level_.certificate.energy);
    if (bound.energy_lower && bound.energy_upper) {
      const double middle = 0.5 * (*bound.energy_lower + *bound.energy_upper),
                   margin = 0.5 * (*bound.energy_upper - *bound.energy_lower);
      text +=
        " (exact solution: " + bounded_text(middle, std::max(margin, shown * std::abs(middle))) +
        ")";
    }
    add("Energy", text);
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
      const double s = penetration.at.arc_length - zone.start.at.arc_length;
      return zone.start.at.side == penetration.at.side && s >= -zone.start.uncertainty &&
             s <= zone.length + zone.end.uncertainty;
    };
    return answer.dimension == 3 ? answer.peak_pressure.has_value()
                                 : std::any_of(answer.zones.begin(), answer.zones.end(), contains);
  }
  static std::string text_of_limits(const TangentialSummary &part) {
    const double largest = part.largest_share;
    return "T takes " + digits(100. * rounded(part.carried_share, 1.)) +
           " % of what friction can carry" +
           (largest > 0. && largest < 1. - 1e-9
              ? "; all sticks, down to " + digits(largest) + " times this friction"
              : "");
  }
  /** A solution is never called unique: that is not proved. */
  static std::string text_of_regularity(const TangentialSummary &part) {
    const std::optional<double> critical = part.critical_factor;
    if (!*part.is_regular)
      return "this is one of at least two solutions (sign of the determinant)";
    if (!critical)
      return "with these zones no other solution branches off, however large the coefficient";
    return (*critical < 1.5 ? "other solutions may exist: " : std::string()) +
           "with these zones another solution can branch off only at " + digits(*critical) +
           " times the coefficient of friction";
  }
  void add_zones(const std::string &label, const std::vector<ContactZone> &zones) {
    for (const auto &[start, end, length, contact] : zones) {
      if (level_.answer.dimension == 3) {
        add(label, level_.answer.contact_by_side[contact].side + ", area " + digits(length));
        continue;
      }
      const std::string side = start.at.side;
      const bool all_around = start.at.point.distance(end.at.point) < 1e-10 * length;
      add(label, (all_around ? "all around " + side
                             : side + " from " + end_text(start) + " to " + end_text(end)) +
                   ", length " + digits(length));
    }
  }
  /** Returns the name of the side, with the other one where the side is in several contacts. */
  std::string name_of(const ContactForce &force) const {
    const std::vector<ContactForce> &all = level_.answer.contact_by_side;
    const auto n = std::count_if(
      all.begin(), all.end(), [&](const ContactForce &other) { return other.side == force.side; });
    return force.side + (n > 1 ? " by " + force.other : "");
  }
  std::string force_text(const SideForce &given) const {
    const auto &[force, moment] = given.resultant;
    if (level_.answer.axisymmetric)
      return scaled_text(force[1], scale_) + " along the axis, " + scaled_text(force[0], scale_) +
             " outward in all";
    return scaled_text(force, scale_) +
           (given.through ? " through " + scaled_text(*given.through, size_) + ", moment " +
                              (moment.size() == 1 ? scaled_text(moment[0], scale_ * size_)
                                                  : scaled_text(moment, scale_))
                          : "");
  }
  /** Returns " at the corner (0, 0) like r^-0.455". */
  std::string growth_text(const GrowthEdge &edge) const {
    std::ostringstream text;
    const auto &[first, second] = edge.ends;
    if (first.size() == 2)
      text << " at the corner " << scaled_text(first, size_);
    else
      text << " at the edge from " << scaled_text(first, size_) << " to "
           << scaled_text(second, size_);
    text << " like r^" << std::setprecision(2) << edge.exponent - 1.;
    return text.str();
  }
  /** Returns "u_x = 0.1, u_y = ...", without the coordinates. */
  std::string point_text(const std::vector<std::pair<std::string, double>> &values) const {
    std::vector<std::string> texts;
    for (const auto &[name, value] : values)
      if (name.size() > 1)
        texts.push_back(name + " = " + scaled_text(value, name[0] == 'u' ? size_ : 0.));
    return join(texts);
  }
  std::string at(const BoundaryPoint &point) const {
    return "on " + point.side + " at " + scaled_text(point.point, size_);
  }
  std::string end_text(const ZoneEnd &end) const {
    return scaled_text(end.at.point, size_) +
           (end.uncertainty > 0. ? " +- " + digits(end.uncertainty) : "");
  }
  /** Returns "settled like r^-0.5 (-1 % from the level before)". */
  std::string trend_text(const Trend &trend, const std::optional<GrowthEdge> &growth) const {
    return word_for(trend.kind) + (growth ? growth_text(*growth) : "") +
           (trend.change ? " (" + signed_percent(*trend.change) + " from the " +
                             level_.sizes.word() + " before)"
                         : "");
  }
  std::string maximum_text(const FieldMaximum &maximum, const Trend &trend,
                           const std::optional<GrowthEdge> &growth = {}) const {
    return digits(maximum.value) + " at " + scaled_text(maximum.point, size_) + ", " +
           trend_text(trend, growth);
  }
  std::string maximum_text(const PressureMaximum &maximum, const Trend &trend,
                           const std::optional<GrowthEdge> &growth = {}) const {
    return digits(maximum.value) + " " + at(maximum.at) + ", " + trend_text(trend, growth) +
           "; mean of its patch " + digits(maximum.mean) + " (" +
           signed_percent(maximum.mean / maximum.value - 1.) + ")";
  }

  std::ostream &stream_;
  const AnswerSummary &summary_;
  const LevelRecord &level_;
  /** The size of the body, and that of the forces. */
  double size_, scale_;
};
} // namespace

void print_answer(std::ostream &stream, const std::vector<LevelRecord> &levels,
                  const std::filesystem::path &directory) {
  Assert(!levels.empty(), ExcMessage("The answer is that of a level."));
  const Answer &finest = levels.back().answer;
  stream << "Answer of " << levels.back().sizes.word() << " " << levels.back().sizes.level
         << (finest.axisymmetric      ? ", all around the axis"
             : finest.dimension == 3  ? ""
             : finest.thickness == 1. ? ", per unit of thickness"
                                      : ", for the thickness " + digits(finest.thickness))
         << " (pressure: positive in compression)\n";
  const AnswerSummary summary(levels);
  AnswerLines lines(stream, summary);
  lines.add_forces();
  lines.add_plates();
  if (!finest.peak_pressure)
    lines.add("Peak pressure", "0: nothing touches");
  else
    lines.add_maximum("Peak pressure", *finest.peak_pressure, summary.peak_pressure);
  lines.add_zones();
  lines.add_penetration();
  lines.add_maximum("Von Mises stress", finest.von_mises, summary.von_mises);
  lines.add_reports();
  lines.add_energy();
  lines.add_load_cases();
  // Tests of runs leave out lines of this form.
  lines.add("Time =", digits(std::round(1000. * summary.seconds) / 1000.) + " s");
  if (!directory.empty())
    stream << "  Results           in " << directory.string() << "\n";
}
} // namespace Signorini
