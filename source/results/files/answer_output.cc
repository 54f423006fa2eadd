// SPDX-License-Identifier: LGPL-2.1-or-later
// The answer of the finest level, for people to read.

#include <signorini/results/files/answer_output.h>

#include <cmath>
#include <iomanip>
#include <sstream>

#include "answer_output_internal.h"

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

/** Returns "(0.25, 0)". */
std::string vector_text(const AnswerVector &x, const double size)
{
  std::string text;
  for (const double component : x.values())
    text += (text.empty() ? "" : ", ") + digits(rounded(component, size));
  return "(" + text + ")";
}

/** Writes lines "label  part part part", broken between parts where the line is full. */
class Lines
{
public:
  explicit Lines(std::ostream &stream)
    : stream_(stream)
  {
  }
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

private:
  std::ostream &stream_;
};

/** Writes one answer; the size of the body decides which lengths are rounding. */
class AnswerBlock
{
public:
  AnswerBlock(std::ostream &stream, const std::vector<LevelRecord> &levels)
    : lines_(stream)
    , levels_(levels)
    , level_(levels.back())
    , answer_(level_.answer)
  {
  }

  void print_forces()
  {
    std::vector<std::string> total = force_parts(answer_.contact_force);
    if (level_.bound && level_.bound->force_error &&
        rounded(*level_.bound->force_error, scale_of_forces()) > 0.)
      total.push_back("error at most " + digits(*level_.bound->force_error));
    lines_.add("Contact force", total);
    if (answer_.contact_by_side.size() > 1)
      for (const SideForce &force : answer_.contact_by_side)
        lines_.add("  on " + force.side, force_parts(force));
    for (const SideForce &force : answer_.reactions)
      lines_.add("Reaction of " + force.side, force_parts(force));
  }

  void print_plates()
  {
    const double scale = scale_of_forces();
    for (const PlateRecord &record : level_.motions.plates)
    {
      const Plate &plate = record.plate;
      std::vector<std::string> parts = {
        "travel " + digits(rounded(record.motion.travel, answer_.size)),
        "along " + vector_text(plate.direction, 1.) + ",",
        "force " + digits(rounded(record.force, scale)) + (plate.turns ? "," : "")};
      if (plate.turns)
        parts.insert(parts.end(),
                     {"rotation " + digits(rounded(record.motion.rotation, 1.)),
                      "about " + vector_text(plate.centre, answer_.size) + ",",
                      "moment " + digits(rounded(record.moment, scale * answer_.size))});
      lines_.add("Plate on " + record.side, parts);
    }
    for (const std::string &motion : level_.motions.undetermined)
      lines_.add("Undetermined", {motion + ":", "nothing resists it,", "it is taken as zero"});
  }

  void print_pressure()
  {
    if (!answer_.peak_pressure)
    {
      lines_.add("Peak pressure", {"0: nothing touches"});
      return;
    }
    const PeakPressure &peak = *answer_.peak_pressure;
    const MaximumTrends trends = trends_of_peak(levels_);
    const auto parts = [this](const PressureMaximum &maximum, std::vector<std::string> trend) {
      trend.back() += ";";
      trend.insert(trend.begin(), {digits(maximum.value), at(maximum.place) + ","});
      trend.insert(trend.end(),
                   {"mean of its patch",
                    digits(maximum.mean),
                    "(" + percent(maximum.mean / maximum.value - 1.) + ")"});
      return trend;
    };
    lines_.add("Peak pressure", parts(peak, trend_parts(trends.largest, peak.grows_at)));
    if (peak.grows_at && peak.away)
      lines_.add(away_text(*peak.grows_at), parts(*peak.away, trend_parts(trends.away)));
  }

  void print_zones()
  {
    if (answer_.dimension == 3)
      lines_.add("Contact area", {digits(level_.contact.length)});
    for (const ContactZone &zone : answer_.zones)
      if (zone.start.place.point.distance(zone.end.place.point) <= 1e-10 * answer_.size)
        lines_.add("Contact zone",
                   {"all around " + zone.start.place.side + ",", "length", digits(zone.length)});
      else
        lines_.add("Contact zone",
                   {zone.start.place.side + " from",
                    end_text(zone.start),
                    "to",
                    end_text(zone.end) + ",",
                    "length",
                    digits(zone.length)});
  }

  void print_penetration()
  {
    if (!answer_.penetration)
      return;
    const Penetration &deepest = *answer_.penetration;
    if (rounded(deepest.value, answer_.size) == 0.)
      lines_.add("Penetration", {"none"});
    else if (deepest.value > 0.)
    {
      std::vector<std::string> parts = {"at most", digits(deepest.value), at(deepest.place)};
      if (!level_.sizes.is_graded())
        parts.emplace_back("(between the means)");
      lines_.add("Penetration", parts);
    }
    else
      lines_.add("Smallest opening", {digits(-deepest.value), at(deepest.place)});
  }

  void print_stress()
  {
    const VonMises &stress = answer_.von_mises;
    const MaximumTrends trends = trends_of_stress(levels_);
    const auto parts = [this](const StressMaximum &maximum, std::vector<std::string> trend) {
      trend.insert(trend.begin(),
                   {digits(maximum.value), "at", vector_text(maximum.point, answer_.size) + ","});
      return trend;
    };
    lines_.add("Von Mises stress", parts(stress, trend_parts(trends.largest, stress.grows_at)));
    if (stress.grows_at && stress.away)
      lines_.add(away_text(*stress.grows_at), parts(*stress.away, trend_parts(trends.away)));
  }

  void print_energy()
  {
    std::vector<std::string> parts = {digits(level_.certificate.energy)};
    if (level_.bound && level_.bound->energy_lower && level_.bound->energy_upper)
      parts.insert(parts.end(),
                   {"(exact: between",
                    digits(*level_.bound->energy_lower),
                    "and",
                    digits(*level_.bound->energy_upper) + ")"});
    lines_.add("Energy", parts);
  }

  void print_load_cases()
  {
    if (!level_.load_cases)
      return;
    const CaseSummary &cases = *level_.load_cases;
    std::vector<std::string> parts = {std::to_string(cases.n_cases) + " in cases.csv,",
                                      "KKT residuals up to " + digits(cases.max_kkt) +
                                        (cases.n_escapes > 0 ? ";" : "")};
    if (cases.n_escapes > 0)
      parts.push_back("in " + std::to_string(cases.n_escapes) + " of them nothing stops the body");
    lines_.add("Load cases", parts);
  }

  void print_end(const std::filesystem::path &directory)
  {
    // Tests of runs leave out lines of this form.
    lines_.add("Time =", {digits(std::round(1000. * total_seconds(levels_)) / 1000.), "s"});
    if (!directory.empty())
      lines_.add("Results", {"in", directory.string()});
  }

private:
  double scale_of_forces() const
  {
    double scale = level_.contact.normal_force;
    for (const auto *const forces : {&answer_.contact_by_side, &answer_.reactions})
      for (const SideForce &force : *forces)
        scale = std::max(scale, force.resultant.force.norm());
    return scale;
  }
  std::vector<std::string> force_parts(const SideForce &force) const
  {
    const double scale = scale_of_forces();
    std::vector<std::string> parts = {vector_text(force.resultant.force, scale)};
    const AnswerVector &moment = force.resultant.moment;
    if (force.through)
      parts.insert(
        parts.end(),
        {"through",
         vector_text(*force.through, answer_.size) + ",",
         "moment " + (moment.size() == 1 ? digits(rounded(moment[0], scale * answer_.size))
                                         : vector_text(moment, scale * answer_.size))});
    return parts;
  }
  std::string at(const BoundaryPlace &place) const
  {
    return "on " + place.side + " at " + vector_text(place.point, answer_.size);
  }
  std::string end_text(const ZoneEnd &end) const
  {
    const std::string point = vector_text(end.place.point, answer_.size);
    return end.uncertainty > 0. ? point + " +- " + digits(end.uncertainty) : point;
  }
  static std::string percent(const double share)
  {
    std::ostringstream text;
    text << std::showpos << std::setprecision(2) << 100. * rounded(share, 1.) << " %";
    return text.str();
  }
  /** Returns "settled (-1 % from the level before)", with the place where a value grows. */
  std::vector<std::string> trend_parts(const Trend &trend,
                                       const std::optional<GrowthPlace> &place = {}) const
  {
    const std::string word = word_for(trend.kind);
    const std::string change =
      trend.change ? "(" + percent(*trend.change) + " from the " + level_.sizes.word() + " before)"
                   : "";
    if (!place)
      return {word + (trend.change ? " " + change : "")};
    const std::string first = vector_text(place->ends[0], answer_.size);
    std::vector<std::string> parts = {word,
                                      answer_.dimension == 2
                                        ? "at the corner " + first
                                        : "at the edge from " + first + " to " +
                                            vector_text(place->ends[1], answer_.size)};
    if (trend.change)
      parts.push_back(change);
    return parts;
  }
  /** Returns "  farther than 0.1". */
  static std::string away_text(const GrowthPlace &place)
  {
    return "  farther than " + digits(place.radius);
  }

  Lines lines_;
  const std::vector<LevelRecord> &levels_;
  const LevelRecord &level_;
  const Answer &answer_;
};
} // namespace

void print_answer(std::ostream &stream,
                  const std::vector<LevelRecord> &levels,
                  const std::filesystem::path &directory)
{
  stream << "Answer of " << levels.back().sizes.word() << " " << levels.back().sizes.level
         << (levels.back().answer.dimension == 2 ? ", per unit of thickness" : "")
         << " (pressure: positive in compression)\n";
  AnswerBlock block(stream, levels);
  block.print_forces();
  block.print_plates();
  block.print_pressure();
  block.print_zones();
  block.print_penetration();
  block.print_stress();
  block.print_energy();
  block.print_load_cases();
  block.print_end(directory);
}

// Numbers of the answer over the levels.

namespace
{
const AnswerVector &point_of(const PressureMaximum &peak)
{
  return peak.place.point;
}
const AnswerVector &point_of(const StressMaximum &stress)
{
  return stress.point;
}

/** Returns whether two maxima lie on the same cell, as far as its size, its degree and the place
 * show. */
template <typename Maximum>
bool share_mesh(const Maximum &a, const Maximum &b)
{
  return a.mesh.degree == b.mesh.degree &&
         std::abs(a.mesh.size - b.mesh.size) < 1e-6 * a.mesh.size &&
         point_of(a).distance(point_of(b)) < a.mesh.size;
}

template <typename Maximum>
Trend trend_of_maxima(const std::vector<std::optional<Maximum>> &maxima)
{
  std::vector<std::optional<double>> values;
  for (const std::optional<Maximum> &maximum : maxima)
    values.push_back(maximum ? std::optional<double>(maximum->value) : std::nullopt);
  Trend trend = trend_of(values);
  const std::size_t n = maxima.size();
  if (n > 1 && maxima[n - 1] && maxima[n - 2] && share_mesh(*maxima[n - 1], *maxima[n - 2]))
    trend.kind = Trend::Kind::not_refined;
  return trend;
}

/** Returns the trends of a maximum over the levels. @param of returns the optional Peak or VonMises
 * of an answer. */
template <typename Maximum, typename Get>
MaximumTrends trends_of(const std::vector<LevelRecord> &levels, const Get &of)
{
  std::vector<std::optional<Maximum>> largest, away;
  for (const LevelRecord &level : levels)
  {
    const auto maximum = of(level.answer);
    largest.push_back(maximum ? std::optional<Maximum>(*maximum) : std::nullopt);
    away.push_back(maximum ? maximum->away : std::nullopt);
  }
  MaximumTrends trends = {trend_of_maxima(largest), trend_of_maxima(away)};
  const auto finest = of(levels.back().answer);
  if (finest && finest->grows_at)
    trends.largest.kind = Trend::Kind::unlimited;
  return trends;
}
} // namespace

MaximumTrends trends_of_peak(const std::vector<LevelRecord> &levels)
{
  return trends_of<PressureMaximum>(levels,
                                    [](const Answer &answer) { return answer.peak_pressure; });
}

MaximumTrends trends_of_stress(const std::vector<LevelRecord> &levels)
{
  return trends_of<StressMaximum>(
    levels, [](const Answer &answer) { return std::optional<VonMises>(answer.von_mises); });
}

double total_seconds(const std::vector<LevelRecord> &levels)
{
  double seconds = 0.;
  for (const LevelRecord &level : levels)
    seconds += level.times.total();
  return seconds;
}
} // namespace Signorini
