// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

namespace Signorini
{
/**
 * A continuous function of t in [0,1], the position on a straight edge, that is a polynomial of
 * degree two between consecutive breaks.
 */
class EdgeFunction
{
public:
  /** On [start, end], with tau = (t - start)/(end - start):
   * (1 - tau) first + tau last + 4 bulge tau (1 - tau). */
  struct Part
  {
    double start, end;
    double first, last;
    double bulge;

    double value(double t) const;
    double slope(double t) const;
    double largest() const;
  };

  /** The function zero. */
  EdgeFunction() = default;
  /** @param parts sorted; they cover [0,1]. */
  explicit EdgeFunction(std::vector<Part> parts)
    : parts_(std::move(parts))
  {
  }

  const std::vector<Part> &parts() const
  {
    return parts_;
  }
  double value(double t) const;
  /** At a break: from the right. */
  double slope(double t) const;
  bool is_zero() const;
  /** The largest value. */
  double largest() const;
  /** int_0^1 r^2 dt, int_0^1 r'^2 dt. Exact. */
  double square_integral() const;
  double slope_integral() const;

private:
  const Part &part_at(double t) const;

  std::vector<Part> parts_;
};

/** A function on an edge from above: q >= f, with the largest value that f was seen to take. */
struct UpperInterpolant
{
  EdgeFunction function;
  double largest;
  double at;
};

/** Ends of the edge at which q is to be f itself, not more. */
struct Pinned
{
  bool start = false;
  bool end = false;
};

/**
 * An EdgeFunction q with q >= f at all points where f was sampled, close to f.
 *
 * Between consecutive @p breaks (0, places where f jumps or has a kink, 1) f is sampled on four
 * equal intervals, each at its ends, its middle and its quarters. q is the parabola through the
 * first three, raised by a piecewise linear function where f exceeds the parabola: for smooth f by
 * O(interval^3), since the excess over a parabola is f'''/6 tau (tau - 1/2) (tau - 1) interval^3,
 * of which the quarters show 97 %; it is raised by 5/4 of what they show. Intervals where the
 * quarters differ by more than 1/100 of the range of f - (its chord) are halved, up to six times;
 * where that is not enough, f has a kink or jumps, and q is linear there and not below any sample.
 * @p n_scanned further points in each of the four intervals, and as close ones in the halves, show
 * details between them: what exceeds the parabola there counts like that at the quarters. What is
 * narrower than 1/16 of the edge, or 1/(4 n_scanned), may be missed. At a break q takes the larger
 * of both values.
 *
 * @param rounding absolute rounding errors of f: what is not larger is nothing. An f that is linear
 * but for rounding gives one part between breaks: other functions may jump there, and integrals
 * with them are taken part by part.
 */
UpperInterpolant interpolate_from_above(const std::function<double(double)> &f,
                                        const std::vector<double> &breaks,
                                        double rounding,
                                        const Pinned &pinned = {},
                                        unsigned int n_scanned = 0);
} // namespace Signorini
