// SPDX-License-Identifier: LGPL-2.1-or-later
// Piecewise quadratic functions on an edge, and upper interpolants.

#include <signorini/error_control/loads/edge_function.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
double EdgeFunction::Part::value(const double t) const
{
  const double tau = (t - start) / (end - start);
  return (1. - tau) * first + tau * last + 4. * bulge * tau * (1. - tau);
}

double EdgeFunction::Part::slope(const double t) const
{
  const double tau = (t - start) / (end - start);
  return (last - first + 4. * bulge * (1. - 2. * tau)) / (end - start);
}

double EdgeFunction::Part::largest() const
{
  // The derivative last - first + 4 bulge (1 - 2 τ) vanishes in the middle of a part if
  // |last - first| < 4 bulge.
  if (std::abs(last - first) >= 4. * bulge)
    return std::max(first, last);
  const double tau = 0.5 + (last - first) / (8. * bulge);
  return value(start + tau * (end - start));
}

double EdgeFunction::largest() const
{
  double largest = parts_.empty() ? 0. : parts_.front().first;
  for (const Part &part : parts_)
    largest = std::max(largest, part.largest());
  return largest;
}

const EdgeFunction::Part &EdgeFunction::part_at(const double t) const
{
  const auto after = std::upper_bound(
    parts_.begin(), parts_.end(), t, [](const double x, const Part &part) { return x < part.end; });
  return after == parts_.end() ? parts_.back() : *after;
}

double EdgeFunction::value(const double t) const
{
  return parts_.empty() ? 0. : part_at(t).value(t);
}

double EdgeFunction::slope(const double t) const
{
  return parts_.empty() ? 0. : part_at(t).slope(t);
}

bool EdgeFunction::is_zero() const
{
  return std::all_of(parts_.begin(), parts_.end(), [](const Part &part) {
    return part.first == 0. && part.last == 0. && part.bulge == 0.;
  });
}

double EdgeFunction::square_integral() const
{
  double sum = 0.;
  for (const Part &part : parts_)
  {
    const double a = part.first, b = part.last, c = part.bulge;
    sum += (part.end - part.start) *
           ((a * a + a * b + b * b) / 3. + 2. / 3. * c * (a + b) + 8. / 15. * c * c);
  }
  return sum;
}

double EdgeFunction::slope_integral() const
{
  double sum = 0.;
  for (const Part &part : parts_)
  {
    const double rise = part.last - part.first;
    sum += (rise * rise + 16. / 3. * part.bulge * part.bulge) / (part.end - part.start);
  }
  return sum;
}

namespace
{
/** The samples of f on an interval: at the ends, in the middle and at the quarters. */
struct Samples
{
  double start, end;
  double first, quarter, middle, three_quarters, last;

  /** Whether f is far from any parabola. */
  bool rough = false;

  /** The excess of f over the parabola at further points: the largest value and the largest
   * absolute value. */
  double scanned_excess = 0., scanned_misfit = 0.;
  /** The largest value of f at further points, and its position. */
  double scanned_largest = std::numeric_limits<double>::lowest(), scanned_at = 0.;

  double parabola(const double tau) const
  {
    return (1. - tau) * first + tau * last + 4. * bulge() * tau * (1. - tau);
  }
  void scan(const std::function<double(double)> &f, const unsigned int n_points)
  {
    for (unsigned int i = 0; i < n_points; ++i)
    {
      const double tau = (i + 0.5) / n_points, t = start + tau * length(), value = f(t);
      const double excess = value - parabola(tau);
      scanned_excess = std::max(scanned_excess, excess);
      scanned_misfit = std::max(scanned_misfit, std::abs(excess));
      if (value > scanned_largest)
      {
        scanned_largest = value;
        scanned_at = t;
      }
    }
  }

  double length() const
  {
    return end - start;
  }
  double bulge() const
  {
    return middle - 0.5 * (first + last);
  }
  /** excess_at_quarter() and excess_at_three_quarters() return f minus the parabola there. */
  double excess_at_quarter() const
  {
    return quarter - (0.75 * first + 0.25 * last + 0.75 * bulge());
  }
  double excess_at_three_quarters() const
  {
    return three_quarters - (0.25 * first + 0.75 * last + 0.75 * bulge());
  }
  /** Returns the rise of the parabola, or of the chord where f is rough, at the end with the value
   * @p value. */
  double lift(const double value) const
  {
    if (rough)
      return std::max({first, quarter, middle, three_quarters, last, scanned_largest}) - value;
    const double excess = std::max({0., excess_at_quarter(), excess_at_three_quarters()});
    return 1.25 * (is_smooth(excess, scanned_excess) ? excess : scanned_excess);
  }
  double misfit() const
  {
    const double misfit =
      std::max(std::abs(excess_at_quarter()), std::abs(excess_at_three_quarters()));
    return is_smooth(misfit, scanned_misfit) ? misfit : scanned_misfit;
  }
  /** Returns whether further points show no more than the quarters do: a cubic exceeds the parabola
   * at most by 1.03 of the excess at the quarters. */
  static bool is_smooth(const double at_quarters, const double scanned)
  {
    return scanned <= 1.2 * at_quarters;
  }
};

/** The number of intervals between two breaks, before any is halved. */
constexpr unsigned int n_intervals = 4;

class Sampler
{
public:
  Sampler(const std::function<double(double)> &f,
          const std::vector<double> &breaks,
          const double rounding,
          const unsigned int n_scanned)
    : f_(f)
    , n_scanned_(n_scanned)
  {
    constexpr unsigned int n = n_intervals;
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
      for (unsigned int i = 0; i < n; ++i)
      {
        const double length = breaks[k + 1] - breaks[k];
        Samples samples = {};
        samples.start = breaks[k] + length * i / n;
        samples.end = i + 1 == n ? breaks[k + 1] : breaks[k] + length * (i + 1) / n;
        samples.middle = f(0.5 * (samples.start + samples.end));
        samples.first = i == 0 ? beside_break(samples, samples.start, rounding) : f(samples.start);
        samples.last = i + 1 == n ? beside_break(samples, samples.end, rounding) : f(samples.end);
        add_quarters(samples);
        samples.scan(f_, n_scanned_);
        intervals_.push_back(samples);
      }
  }

  /** Halves intervals where f is far from a parabola. */
  void refine(const double rounding)
  {
    const double range = bend();
    linear_ = range <= rounding && max_misfit() <= rounding;
    if (linear_)
      return;
    const double allowed = std::max(0.01 * range, rounding);
    for (unsigned int pass = 0; pass < 6 && max_misfit() > allowed; ++pass)
    {
      // The halves have the points of the whole, and not less than four each.
      n_scanned_ = n_scanned_ == 0 ? 0 : std::max(4U, n_scanned_ / 2);
      std::vector<Samples> finer;
      for (const Samples &s : intervals_)
        if (s.misfit() > allowed)
          halve(s, finer);
        else
          finer.push_back(s);
      intervals_ = std::move(finer);
    }
    for (Samples &s : intervals_)
      s.rough = s.misfit() > allowed;
  }

  UpperInterpolant result(const Pinned &pinned) const
  {
    const std::size_t n = intervals_.size();
    std::vector<double> values(n + 1), lifts(n + 1);
    UpperInterpolant upper = {EdgeFunction(), intervals_[0].first, intervals_[0].start};
    for (std::size_t i = 0; i < n; ++i)
    {
      const Samples &s = intervals_[i];
      note(s, upper);
      // A linear function that vanishes at one end is a quarter of its value at the quarter.
      const bool starts_pinned = pinned.start && i == 0, ends_pinned = pinned.end && i + 1 == n;
      lifts[i] = starts_pinned ? 0. : std::max(lifts[i], s.lift(s.first) * (ends_pinned ? 4. : 1.));
      lifts[i + 1] =
        ends_pinned ? 0. : std::max(lifts[i + 1], s.lift(s.last) * (starts_pinned ? 4. : 1.));
      values[i] = i == 0 ? s.first : std::max(s.first, intervals_[i - 1].last);
      values[i + 1] = s.last;
    }
    for (std::size_t i = 0; i <= n; ++i)
      values[i] += lifts[i];
    std::vector<EdgeFunction::Part> parts;
    const double a = intervals_.front().first, b = intervals_.back().last;
    for (std::size_t i = 0; i < n && linear_; i += n_intervals)
    {
      const double start = intervals_[i].start, end = intervals_[i + n_intervals - 1].end;
      parts.push_back({start, end, (1. - start) * a + start * b, (1. - end) * a + end * b, 0.});
    }
    for (std::size_t i = 0; i < n && !linear_; ++i)
      parts.push_back({intervals_[i].start,
                       intervals_[i].end,
                       values[i],
                       values[i + 1],
                       intervals_[i].rough ? 0. : intervals_[i].bulge()});
    upper.function = EdgeFunction(std::move(parts));
    return upper;
  }

private:
  /** Returns f at one end of the samples, or the limit from inside if f jumps there. At a jump the
   * limit is the same at both distances; where f is only steep, like the root of the distance, it
   * is not. */
  double beside_break(const Samples &samples, const double t, const double rounding) const
  {
    const double value = f_(t), length = samples.end - samples.start;
    const double inwards = t == samples.start ? length : -length;
    const double limit = f_(t + 1e-10 * inwards);
    const double change = std::abs(limit - value);
    const bool jumps = change > rounding && change > 0.5 * std::abs(f_(t + 1e-6 * inwards) - value);
    return jumps ? limit : value;
  }
  /** Returns the largest distance of f from its chord. */
  double bend() const
  {
    const double a = intervals_.front().first, b = intervals_.back().last;
    double largest = 0.;
    for (const Samples &s : intervals_)
    {
      const double t = 0.5 * (s.start + s.end);
      largest = std::max({largest,
                          std::abs(s.middle - (1. - t) * a - t * b),
                          std::abs(s.first - (1. - s.start) * a - s.start * b)});
    }
    return largest;
  }
  double max_misfit() const
  {
    double largest = 0.;
    for (const Samples &s : intervals_)
      largest = std::max(largest, s.misfit());
    return largest;
  }
  void add_quarters(Samples &samples) const
  {
    samples.quarter = f_(0.75 * samples.start + 0.25 * samples.end);
    samples.three_quarters = f_(0.25 * samples.start + 0.75 * samples.end);
  }
  void halve(const Samples &s, std::vector<Samples> &to) const
  {
    const double middle = 0.5 * (s.start + s.end);
    Samples left = {s.start, middle, s.first, 0., s.quarter, 0., s.middle};
    Samples right = {middle, s.end, s.middle, 0., s.three_quarters, 0., s.last};
    for (Samples *half : {&left, &right})
    {
      add_quarters(*half);
      half->scan(f_, n_scanned_);
    }
    to.push_back(left);
    to.push_back(right);
  }
  static void note(const Samples &s, UpperInterpolant &upper)
  {
    const double values[] = {s.first, s.quarter, s.middle, s.three_quarters, s.last};
    for (unsigned int k = 0; k < 5; ++k)
      if (values[k] > upper.largest)
      {
        upper.largest = values[k];
        upper.at = s.start + 0.25 * k * s.length();
      }
    if (s.scanned_largest > upper.largest)
    {
      upper.largest = s.scanned_largest;
      upper.at = s.scanned_at;
    }
  }

  const std::function<double(double)> &f_;
  unsigned int n_scanned_;
  std::vector<Samples> intervals_;
  bool linear_ = false;
};
} // namespace

UpperInterpolant interpolate_from_above(const std::function<double(double)> &f,
                                        const std::vector<double> &breaks,
                                        const double rounding,
                                        const Pinned &pinned,
                                        const unsigned int n_scanned)
{
  Sampler sampler(f, breaks, rounding, n_scanned);
  sampler.refine(rounding);
  return sampler.result(pinned);
}
} // namespace Signorini
