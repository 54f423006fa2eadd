// SPDX-License-Identifier: LGPL-2.1-or-later
// Piecewise quadratic functions on an edge, and how they are found.

#include <signorini/bound/edge_function.h>

#include <algorithm>
#include <cmath>

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

const EdgeFunction::Part &EdgeFunction::part_at(const double t) const
{
  const auto after = std::upper_bound(parts_.begin(),
                                      parts_.end(),
                                      t,
                                      [](const double x, const Part &part) { return x < part.end; });
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
/** f on an interval: at the ends, in the middle and at the quarters. */
struct Samples
{
  double start, end;
  double first, quarter, middle, three_quarters, last;

  double length() const
  {
    return end - start;
  }
  double bulge() const
  {
    return middle - 0.5 * (first + last);
  }
  /** f minus the parabola at the quarters. */
  double excess_at_quarter() const
  {
    return quarter - (0.75 * first + 0.25 * last + 0.75 * bulge());
  }
  double excess_at_three_quarters() const
  {
    return three_quarters - (0.25 * first + 0.75 * last + 0.75 * bulge());
  }
  /** By how much the parabola is raised at both ends. */
  double lift() const
  {
    return 1.25 * std::max({0., excess_at_quarter(), excess_at_three_quarters()});
  }
  double misfit() const
  {
    return std::max(std::abs(excess_at_quarter()), std::abs(excess_at_three_quarters()));
  }
};

/** Beside a break, f is taken so far from it. */
constexpr double beside = 1e-10;

class Sampler
{
public:
  Sampler(const std::function<double(double)> &f, const std::vector<double> &breaks)
    : f_(f)
  {
    constexpr unsigned int n = 4;
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
      for (unsigned int i = 0; i < n; ++i)
      {
        const double length = breaks[k + 1] - breaks[k];
        Samples samples = {};
        samples.start = breaks[k] + length * i / n;
        samples.end = i + 1 == n ? breaks[k + 1] : breaks[k] + length * (i + 1) / n;
        samples.first = f(i == 0 ? samples.start + beside * length : samples.start);
        samples.last = f(i + 1 == n ? samples.end - beside * length : samples.end);
        // Where f is continuous, it has one value at a break.
        if (i == 0)
          samples.first = std::max(samples.first, f(samples.start));
        if (i + 1 == n)
          samples.last = std::max(samples.last, f(samples.end));
        samples.middle = f(0.5 * (samples.start + samples.end));
        add_quarters(samples);
        intervals_.push_back(samples);
      }
  }

  /** Halves intervals where f is far from a parabola. */
  void refine()
  {
    double range = 0.;
    const double a = intervals_.front().first, b = intervals_.back().last;
    double size = std::max(std::abs(a), std::abs(b));
    for (const Samples &s : intervals_)
    {
      const double t = 0.5 * (s.start + s.end);
      range = std::max({range,
                        std::abs(s.middle - (1. - t) * a - t * b),
                        std::abs(s.first - (1. - s.start) * a - s.start * b)});
      size = std::max(size, std::abs(s.middle));
    }
    const double allowed = 0.01 * range + 1e-13 * size;
    for (unsigned int pass = 0; pass < 6; ++pass)
    {
      std::vector<Samples> finer;
      for (const Samples &s : intervals_)
        if (s.misfit() > allowed)
          halve(s, finer);
        else
          finer.push_back(s);
      if (finer.size() == intervals_.size())
        break;
      intervals_ = std::move(finer);
    }
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
      lifts[i] = starts_pinned ? 0. : std::max(lifts[i], s.lift() * (ends_pinned ? 4. : 1.));
      lifts[i + 1] =
        ends_pinned ? 0. : std::max(lifts[i + 1], s.lift() * (starts_pinned ? 4. : 1.));
      values[i] = i == 0 ? s.first : std::max(s.first, intervals_[i - 1].last);
      values[i + 1] = s.last;
    }
    for (std::size_t i = 0; i <= n; ++i)
      values[i] += lifts[i];
    std::vector<EdgeFunction::Part> parts;
    for (std::size_t i = 0; i < n; ++i)
      parts.push_back(
        {intervals_[i].start, intervals_[i].end, values[i], values[i + 1], intervals_[i].bulge()});
    upper.function = EdgeFunction(std::move(parts));
    return upper;
  }

private:
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
    add_quarters(left);
    add_quarters(right);
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
  }

  const std::function<double(double)> &f_;
  std::vector<Samples> intervals_;
};
} // namespace

UpperInterpolant interpolate_from_above(const std::function<double(double)> &f,
                                        const std::vector<double> &breaks,
                                        const Pinned &pinned)
{
  Sampler sampler(f, breaks);
  sampler.refine();
  return sampler.result(pinned);
}
} // namespace Signorini
