// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/polynomial.h>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace Signorini {
/**
 * A continuous function of t in [0,1], the position on a straight edge, that is a polynomial of
 * degree two between consecutive breaks.
 */
class EdgeFunction {
public:
  /** A part on [start, end]. With τ = (t - start)/(end - start) the function is (1 - τ) first +
   * τ last + 4 bubble τ (1 - τ). */
  struct Part {
    double start, end;
    double first, last;
    double bubble;

    double value(double t) const;
    double slope(double t) const;
    double largest() const;
  };

  /** Makes the zero function. */
  EdgeFunction() = default;
  /**
   * Makes the function from its parts.
   * @param parts sorted; they cover [0,1].
   */
  explicit EdgeFunction(std::vector<Part> parts)
    : parts_(std::move(parts)) {}

  const std::vector<Part> &parts() const {
    return parts_;
  }
  double value(double t) const;
  /** Returns the derivative at t; at a break, that from the right. */
  double slope(double t) const;
  bool is_zero() const;
  /** Returns the same function with further breaks where it vanishes. */
  EdgeFunction split_at_roots() const;
  /** Returns the largest value. */
  double largest() const;
  /** square_integral() returns ∫_0^1 r² dt, slope_integral() ∫_0^1 r'² dt. Both are exact. */
  double square_integral() const;
  double slope_integral() const;

private:
  const Part &part_at(double t) const;

  std::vector<Part> parts_;
};

/** A function q ≥ f on an edge, with the largest sampled value of f and its position. */
struct UpperInterpolant {
  EdgeFunction function;
  double largest;
  double at;
};

/** The ends of the edge at which q equals f. */
struct Pinned {
  bool start = false;
  bool end = false;
};

/**
 * Returns an EdgeFunction q close to f with q ≥ f at all points where f was sampled.
 *
 * Between consecutive @p breaks (0, positions where f jumps or has a kink, 1) f is sampled on four
 * equal intervals, each at its ends, its middle and its quarters. q is the parabola through the
 * first three, raised by a piecewise linear function where f exceeds the parabola: for smooth f by
 * O(interval³), since the excess over a parabola is f'''/6 τ (τ - 1/2) (τ - 1) interval³,
 * of which the quarters show 97 %; it is raised by 5/4 of the excess at them. Intervals where the
 * quarters differ by more than 1/100 of the range of f - (its chord) are halved, up to six times;
 * where that is not enough, f has a kink or jumps, and q is linear there and not below any sample.
 * @p n_scanned further points in each of the four intervals, and as close ones in the halves,
 * resolve details between them: an excess over the parabola counts like that at the quarters.
 * A detail narrower than 1/16 of the edge, or 1/(4 n_scanned), may be missed. At a break q takes
 * the larger of both values.
 *
 * @param rounding absolute rounding errors of f: differences that are not larger are ignored. An f
 * that is linear but for rounding gives one part between breaks: other functions may jump there,
 * and integrals with them are taken part by part.
 * @param resolution the smallest distance of t that points on the edge show.
 */
UpperInterpolant interpolate_from_above(const std::function<double(double)> &f,
                                        const std::vector<double> &breaks, double rounding,
                                        const Pinned &pinned = {}, unsigned int n_scanned = 0,
                                        double resolution = 0.);

/** The tractions τ_n and τ_t on a contact face, as polynomials of t. */
using FaceTractions = std::array<Polynomials::Polynomial<double>, 2>;
} // namespace Signorini
