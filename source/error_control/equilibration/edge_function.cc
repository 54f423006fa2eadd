// SPDX-License-Identifier: LGPL-2.1-or-later
// Piecewise quadratic functions on an edge, and upper interpolants.

#include <signorini/error_control/equilibration/edge_function.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Signorini {
double EdgeFunction::Part::value(const double t) const {
  const double tau = (t - start) / (end - start);
  return (1. - tau) * first + tau * last + 4. * bubble * tau * (1. - tau);
}

double EdgeFunction::Part::slope(const double t) const {
  const double tau = (t - start) / (end - start);
  return (last - first + 4. * bubble * (1. - 2. * tau)) / (end - start);
}

double EdgeFunction::Part::largest() const {
  // The derivative last - first + 4 bubble (1 - 2 τ) vanishes in the middle of a part if
  // |last - first| < 4 bubble.
  if (std::abs(last - first) >= 4. * bubble)
    return std::max(first, last);
  const double tau = 0.5 + (last - first) / (8. * bubble);
  return value(start + tau * (end - start));
}

double EdgeFunction::largest() const {
  double largest = parts_.empty() ? 0. : parts_.front().first;
  for (const Part &part : parts_)
    largest = std::max(largest, part.largest());
  return largest;
}

const EdgeFunction::Part &EdgeFunction::part_at(const double t) const {
  const auto after = std::upper_bound(
    parts_.begin(), parts_.end(), t, [](const double x, const Part &part) { return x < part.end; });
  return after == parts_.end() ? parts_.back() : *after;
}

double EdgeFunction::value(const double t) const {
  return parts_.empty() ? 0. : part_at(t).value(t);
}

double EdgeFunction::slope(const double t) const {
  return parts_.empty() ? 0. : part_at(t).slope(t);
}

bool EdgeFunction::is_zero() const {
  return std::all_of(parts_.begin(), parts_.end(), [](const Part &part) {
    return part.first == 0. && part.last == 0. && part.bubble == 0.;
  });
}

EdgeFunction EdgeFunction::split_at_roots() const {
  std::vector<Part> parts;
  for (const Part &part : parts_) {
    // first + τ b - τ² a = 0
    const double a = 4. * part.bubble, b = part.last - part.first + a,
                 root = std::sqrt(std::max(0., b * b + 4. * a * part.first)),
                 twice = b + std::copysign(root, b);
    std::vector<double> breaks = {0., 1.};
    if (a != 0.)
      breaks.push_back(std::clamp(twice / (2. * a), 0., 1.));
    if (twice != 0.)
      breaks.push_back(std::clamp(-2. * part.first / twice, 0., 1.));
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    const auto position = [&part](const double tau) {
      return tau == 1. ? part.end : part.start + tau * (part.end - part.start);
    };
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const double from = position(breaks[i]), to = position(breaks[i + 1]);
      parts.push_back({from, to, part.value(from), part.value(to),
                       part.bubble * std::pow(breaks[i + 1] - breaks[i], 2)});
    }
  }
  return EdgeFunction(std::move(parts));
}

double EdgeFunction::square_integral() const {
  double sum = 0.;
  for (const Part &part : parts_) {
    const double a = part.first, b = part.last, c = part.bubble;
    sum += (part.end - part.start) *
           ((a * a + a * b + b * b) / 3. + 2. / 3. * c * (a + b) + 8. / 15. * c * c);
  }
  return sum;
}

double EdgeFunction::slope_integral() const {
  double sum = 0.;
  for (const Part &part : parts_) {
    const double rise = part.last - part.first;
    sum += (rise * rise + 16. / 3. * part.bubble * part.bubble) / (part.end - part.start);
  }
  return sum;
}

namespace {
/** An interval with the values of f at equally spaced points, the ends and the quarters among them.
 */
struct SampledInterval {
  double start, end;
  std::vector<double> f;
  /** Whether f is far from any parabola. */
  bool rough = false;

  std::size_t n() const {
    return f.size() - 1;
  }
  double position(const std::size_t i) const {
    return i == n() ? end : start + (end - start) * i / n();
  }
  double bubble() const {
    return f[n() / 2] - 0.5 * (f.front() + f.back());
  }
  /** Returns f minus the parabola through both ends and the middle. */
  double excess(const std::size_t i) const {
    const double tau = static_cast<double>(i) / n();
    return f[i] - ((1. - tau) * f.front() + tau * f.back() + 4. * bubble() * tau * (1. - tau));
  }
  /** Returns the largest of sign × excess at the quarters; or at all points, if these show more. A
   * cubic exceeds the parabola at most by 1.03 of the excess at the quarters. */
  double max_excess(const bool absolute) const {
    const auto size = [&](const std::size_t i) {
      return absolute ? std::abs(excess(i)) : std::max(0., excess(i));
    };
    const double at_quarters = std::max(size(n() / 4), size(3 * n() / 4));
    double largest = 0.;
    for (std::size_t i = 0; i <= n(); ++i)
      largest = std::max(largest, size(i));
    return largest <= 1.2 * at_quarters ? at_quarters : largest;
  }
  double largest() const {
    return *std::max_element(f.begin(), f.end());
  }
  /** Returns the rise of the parabola, or of the chord where f is rough, at the end with the value
   * @p value. */
  double lift(const double value) const {
    return rough ? largest() - value : 1.25 * max_excess(false);
  }
};

/** The number of intervals between two breaks, before any is halved. */
constexpr unsigned int n_intervals = 4;

SampledInterval sample(const std::function<double(double)> &f, const double start, const double end,
                       const unsigned int n_scanned) {
  SampledInterval interval = {start, end, std::vector<double>(n_scanned + 5)};
  for (std::size_t i = 0; i < interval.f.size(); ++i)
    interval.f[i] = f(interval.position(i));
  return interval;
}

/** Replaces f at t by the limit from inside, at the distance @p inwards, if f jumps there. At a
 * jump the limit is the same at both distances; where f is only steep, like the root of the
 * distance, it is not. */
void take_limit(const std::function<double(double)> &f, const double t, const double inwards,
                const double resolution, const double rounding, double &value) {
  // Data that is computed may jump by more than rounding where its formula changes.
  constexpr double least_jump = 1e6;
  const double near = std::copysign(std::max(1e-10 * std::abs(inwards), resolution), inwards),
               far = std::copysign(std::min(1e4 * std::abs(near), std::abs(inwards)), inwards);
  const double limit = f(t + near), change = std::abs(limit - value);
  if (change > least_jump * rounding && change > 0.5 * std::abs(f(t + far) - value))
    value = limit;
}

/** Returns about the effect of rounding on f between two points: the median of second differences
 * over distances at which f does not bend. No halves are closer to f than this. */
double noise_of(const std::function<double(double)> &f, const double start, const double end) {
  constexpr unsigned int n = 7;
  const double distance = 1e-9 * (end - start);
  std::array<double, n> noise;
  for (unsigned int i = 0; i < n; ++i) {
    const double t = start + (end - start) * (i + 0.37) / n;
    noise[i] = std::abs(f(t - distance) - 2. * f(t) + f(t + distance));
  }
  std::sort(noise.begin(), noise.end());
  return noise[n / 2];
}

/** Returns parabolas with the shifts that raise them above f. */
EdgeFunction raised(const std::vector<SampledInterval> &intervals, const Pinned &pinned) {
  const std::size_t n = intervals.size();
  std::vector<double> values(n + 1), lifts(n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const SampledInterval &interval = intervals[i];
    const double first = interval.f.front(), last = interval.f.back();
    // A linear function that vanishes at one end is a quarter of its value at the quarter.
    const bool starts_pinned = pinned.start && i == 0, ends_pinned = pinned.end && i + 1 == n;
    lifts[i] =
      starts_pinned ? 0. : std::max(lifts[i], interval.lift(first) * (ends_pinned ? 4. : 1.));
    lifts[i + 1] =
      ends_pinned ? 0. : std::max(lifts[i + 1], interval.lift(last) * (starts_pinned ? 4. : 1.));
    values[i] = i == 0 ? first : std::max(first, values[i]);
    values[i + 1] = last;
  }
  std::vector<EdgeFunction::Part> parts;
  for (std::size_t i = 0; i < n; ++i)
    parts.push_back({intervals[i].start, intervals[i].end, values[i] + lifts[i],
                     values[i + 1] + lifts[i + 1],
                     intervals[i].rough ? 0. : intervals[i].bubble()});
  return EdgeFunction(std::move(parts));
}

/** Halves intervals where f is far from a parabola, and marks those where it stays so. Where raised
 * parabolas are above zero by more than twice the samples of f, halves of these and of their
 * neighbours, which raise their ends, follow up to rounding: a body that merely touches does not
 * move. */
void refine(const std::function<double(double)> &f, const double allowed, const double rounding,
            unsigned int n_scanned, std::vector<SampledInterval> &intervals) {
  constexpr unsigned int n_passes = 6, n_touching_passes = 20, many = 4000;
  const auto is_rough = [allowed](const SampledInterval &interval) {
    return interval.max_excess(true) > allowed;
  };
  for (unsigned int pass = 0;
       pass < n_passes || (pass < n_touching_passes && intervals.size() < many); ++pass) {
    // The halves have the points of the whole, and not less than four each.
    n_scanned = n_scanned == 0 ? 0 : std::max(4U, n_scanned / 2);
    const EdgeFunction q = raised(intervals, {});
    std::vector<bool> is_halved(intervals.size() + 2);
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      const double seen = std::max(0., intervals[i].largest());
      if (q.parts()[i].largest() - seen > std::max(seen, rounding))
        is_halved[i] = is_halved[i + 1] = is_halved[i + 2] = true;
      else if (pass < n_passes && is_rough(intervals[i]))
        is_halved[i + 1] = true;
    }
    std::vector<SampledInterval> finer;
    for (std::size_t i = 0; i < intervals.size(); ++i)
      if (const SampledInterval &whole = intervals[i]; is_halved[i + 1]) {
        const double middle = 0.5 * (whole.start + whole.end);
        finer.push_back(sample(f, whole.start, middle, n_scanned));
        finer.push_back(sample(f, middle, whole.end, n_scanned));
        // The limits at breaks stay.
        finer[finer.size() - 2].f.front() = whole.f.front();
        finer.back().f.back() = whole.f.back();
      } else
        finer.push_back(whole);
    intervals = std::move(finer);
  }
  for (SampledInterval &interval : intervals)
    interval.rough = is_rough(interval);
}
} // namespace

UpperInterpolant interpolate_from_above(const std::function<double(double)> &f,
                                        const std::vector<double> &breaks, const double rounding,
                                        const Pinned &pinned, const unsigned int n_scanned,
                                        const double resolution) {
  std::vector<SampledInterval> intervals;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const double length = (breaks[k + 1] - breaks[k]) / n_intervals;
    for (unsigned int i = 0; i < n_intervals; ++i)
      intervals.push_back(
        sample(f, breaks[k] + length * i,
               i + 1 == n_intervals ? breaks[k + 1] : breaks[k] + length * (i + 1), n_scanned));
    take_limit(f, breaks[k], length, resolution, rounding,
               intervals[intervals.size() - n_intervals].f.front());
    take_limit(f, breaks[k + 1], -length, resolution, rounding, intervals.back().f.back());
  }
  const double first = intervals.front().f.front(), last = intervals.back().f.back();
  const auto chord = [&](const double t) { return (1. - t) * first + t * last; };
  // The largest distances from the chord and from parabolas.
  double range = 0., misfit = 0.;
  for (const SampledInterval &interval : intervals) {
    for (std::size_t i = 0; i <= interval.n(); ++i)
      range = std::max(range, std::abs(interval.f[i] - chord(interval.position(i))));
    misfit = std::max(misfit, interval.max_excess(true));
  }
  UpperInterpolant upper;
  if (range <= rounding && misfit <= rounding) {
    std::vector<EdgeFunction::Part> parts;
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
      parts.push_back({breaks[k], breaks[k + 1], chord(breaks[k]), chord(breaks[k + 1]), 0.});
    upper.function = EdgeFunction(std::move(parts));
  } else {
    // Parabolas through three values with noise, raised at an end by four times their excess.
    const double seen =
      std::max(rounding, 16. * noise_of(f, intervals.front().start, intervals.front().end));
    refine(f, std::max(0.01 * range, seen), seen, n_scanned, intervals);
    upper.function = raised(intervals, pinned);
  }
  upper.largest = first;
  upper.at = 0.;
  for (const SampledInterval &interval : intervals)
    for (std::size_t i = 0; i <= interval.n(); ++i)
      if (interval.f[i] > upper.largest) {
        upper.largest = interval.f[i];
        upper.at = interval.position(i);
      }
  return upper;
}
} // namespace Signorini
