// SPDX-License-Identifier: LGPL-2.1-or-later
// The parts of a side that face another side.

#include <signorini/problem/geometry/inside.h>
#include <signorini/problem/scene/facing.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** The share of a length that is rounding. */
constexpr double sliver = 1e-9;

bool is_circular(const Curve &piece) {
  return piece.radius() > 0.;
}

/** The point at which a line meets a segment or an arc that faces it, continued beyond the ends:
 * its distance, and m.n; and whether the line meets the circle nowhere nearer. */
struct Hit {
  double distance, cosine;
  bool is_nearest;
};

/** Returns it; where the line x + t n misses the circle, the nearest value. */
Hit hit(const Curve &piece, const Point<2> &x, const Tensor<1, 2> &n) {
  if (!is_circular(piece)) {
    const Tensor<1, 2> m = piece.normal(0.);
    return {(piece.start() - x) * m / (m * n), m * n, true};
  }
  const Tensor<1, 2> arm = piece.centre_of_circle() - x;
  const double orientation =
                 piece.normal(0.) * (piece.start() - piece.centre_of_circle()) > 0. ? 1. : -1.,
               beside = arm * cross_product_2d(n), r = piece.radius(),
               root = std::sqrt(std::max(0., (r - beside) * (r + beside)));
  return {arm * n - orientation * root, -root / r, orientation * (arm * n) >= 0.};
}

/** Adds the arc lengths of a piece at which its normal is parallel to a direction; none on a
 * segment. */
void add_parallel(const Curve &piece, const Tensor<1, 2> &direction, std::vector<double> &breaks) {
  if (is_circular(piece) && direction.norm() > 0.)
    for (const double sign : {-1., 1.})
      breaks.push_back(piece.arc_length(piece.centre_of_circle() +
                                        sign * piece.radius() * direction / direction.norm()));
}

/** Adds the arc lengths of a piece from which the line along the normal goes through a point. */
void add_through(const Curve &piece, const Point<2> &x, std::vector<double> &breaks) {
  if (is_circular(piece))
    add_parallel(piece, x - piece.centre_of_circle(), breaks);
  else
    breaks.push_back(piece.arc_length(x));
}

Tensor<1, 2> turned(const Tensor<1, 2> &x, const double angle) {
  return std::cos(angle) * x - std::sin(angle) * cross_product_2d(x);
}

/** Returns the ends of a piece, and the arc lengths between them at which it may begin to face
 * another piece, or the distance has an extremum; sorted. */
std::vector<double> breaks_of(const Curve &piece, const Curve &other, const double least) {
  std::vector<double> breaks = {0., piece.length()};
  add_through(piece, other.start(), breaks);
  add_through(piece, other.end(), breaks);
  if (is_circular(other)) {
    // m.n = -(1 - (h/r)²)^{1/2} with the distance h of the line from the centre.
    const Point<2> &centre = other.centre_of_circle();
    const double h = other.radius() * std::sqrt((1. - least) * (1. + least));
    add_through(piece, centre, breaks);
    if (is_circular(piece)) {
      const Tensor<1, 2> between = centre - piece.centre_of_circle();
      const double d = between.norm();
      for (const double sign : {-1., 1.}) {
        if (d > h)
          add_parallel(piece, turned(between, sign * std::asin(h / d)), breaks);
        // Both points at which the line meets the circle are equally far.
        if (d > piece.radius())
          add_parallel(piece, turned(between, sign * std::acos(piece.radius() / d)), breaks);
      }
    } else
      for (const double sign : {-1., 1.})
        breaks.push_back(piece.arc_length(centre) + sign * h);
  } else
    for (const double angle : {0., std::acos(least), -std::acos(least)})
      add_parallel(piece, turned(other.normal(0.), angle), breaks);
  breaks.erase(std::remove_if(breaks.begin(), breaks.end(),
                              [&](const double s) { return !(s >= 0. && s <= piece.length()); }),
               breaks.end());
  std::sort(breaks.begin(), breaks.end());
  return breaks;
}

/** Adds the parts of piece @p k of a curve that face a piece of another one. */
void add_parts(const Curve &first, const unsigned int k, const Curve &other, const double least,
               std::vector<FacingPart> &parts) {
  const Curve &piece = first.piece(k);
  const double start = first.start_of(k);
  const std::vector<double> breaks = breaks_of(piece, other, least);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double from = breaks[i], to = breaks[i + 1], middle = 0.5 * (from + to);
    if (!(to - from > sliver * sliver * first.length()))
      continue;
    const Point<2> x = piece.point(middle);
    const Tensor<1, 2> n = piece.normal(middle);
    const Hit found = hit(other, x, n);
    const double s = other.arc_length(x + found.distance * n);
    if (!(found.cosine < -least && found.is_nearest && s >= 0. && s <= other.length()))
      continue;
    FacingPart part = {start + from, start + to, found.distance, start + middle};
    // Between two breaks the distance rises or falls.
    for (const double end : {from, to})
      if (const Hit at_end = hit(other, piece.point(end), piece.normal(end));
          at_end.distance < part.distance && at_end.cosine < -sliver) {
        part.distance = at_end.distance;
        part.nearest = start + end;
      }
    parts.push_back(part);
  }
}
} // namespace

std::vector<FacingPart> facing_parts(const Curve &first, const Curve &second, const double least) {
  Assert(least >= 0. && least < 1., ExcMessage("A cosine lies between 0 and 1."));
  std::vector<FacingPart> all, parts;
  for (unsigned int k = 0; k < first.n_pieces(); ++k)
    for (unsigned int j = 0; j < second.n_pieces(); ++j)
      add_parts(first, k, second.piece(j), least, all);
  std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) { return a.from < b.from; });
  const double slack = sliver * first.length();
  const auto join = [](FacingPart &part, const FacingPart &next) {
    part.to = std::max(part.to, next.to);
    if (next.distance < part.distance) {
      part.distance = next.distance;
      part.nearest = next.nearest;
    }
  };
  for (const FacingPart &next : all)
    if (parts.empty() || next.from > parts.back().to + slack)
      parts.push_back(next);
    else
      join(parts.back(), next);
  if (first.is_closed() && parts.size() > 1 && parts.front().from <= slack &&
      parts.back().to >= first.length() - slack) {
    FacingPart next = parts.front();
    next.to += first.length();
    join(parts.back(), next);
    parts.erase(parts.begin());
  }
  return parts;
}

namespace {
/** Returns the nearest point at which the line x + t n meets a piece of a curve that faces it; x
 * where there is none. */
Point<2> facing_point(const Curve &curve, const Point<2> &x, const Tensor<1, 2> &n,
                      const double least) {
  double nearest = HUGE_VAL;
  for (unsigned int k = 0; k < curve.n_pieces(); ++k) {
    const Curve &piece = curve.piece(k);
    const Hit found = hit(piece, x, n);
    const double s = piece.arc_length(x + found.distance * n), slack = sliver * curve.length();
    if (found.cosine < -least && found.is_nearest && s >= -slack && s <= piece.length() + slack &&
        std::abs(found.distance) < std::abs(nearest))
      nearest = found.distance;
  }
  return std::isfinite(nearest) ? Point<2>(x + nearest * n) : x;
}

/** Returns whether a segment outside of the body that it leaves meets a side, or lies in a body
 * that touches both of its ends. */
bool is_crossed(const Point<2> &x, const Point<2> &y, const bool leaves,
                const Geometry<2> &geometry) {
  const double length = x.distance(y);
  if (!(length > 0.))
    return false;
  const std::vector<Side<2>> &sides = geometry.sides;
  const Tensor<1, 2> along = (y - x) / length, across = cross_product_2d(along);
  const bool meets = std::any_of(sides.begin(), sides.end(), [&](const Side<2> &side) {
    const double rounding = sliver * (length + side.length());
    const std::vector<double> met = side.crossings(across, across * x, 0., side.length());
    return std::any_of(met.begin(), met.end(), [&](const double s) {
      const double at = (side.point(s) - x) * along;
      return at > rounding && at < length - rounding;
    });
  });
  return meets || (leaves &&
                   distance_from_body(geometry, x + 0.5 * (y - x)) < -sliver * geometry.diameter());
}
} // namespace

std::vector<FacingPart> seen_parts(const Curve &first, const Curve &second, const double least,
                                   const Geometry<2> &geometry) {
  std::vector<FacingPart> parts = facing_parts(first, second, least);
  const auto is_hidden = [&](const FacingPart &part) {
    constexpr unsigned int n_samples = 9;
    std::vector<double> samples = {part.nearest};
    for (unsigned int i = 0; i < n_samples; ++i)
      samples.push_back(part.from + (i + 0.5) / n_samples * (part.to - part.from));
    return std::all_of(samples.begin(), samples.end(), [&](const double s) {
      const Point<2> x = first.point(s);
      const Tensor<1, 2> n = first.normal(s);
      const Point<2> y = facing_point(second, x, n, least);
      return is_crossed(x, y, (y - x) * n > 0., geometry);
    });
  };
  parts.erase(std::remove_if(parts.begin(), parts.end(), is_hidden), parts.end());
  return parts;
}

std::pair<double, double> part_across(const Curve &first, const Curve &second, const double from,
                                      const double to) {
  const auto across = [&](const double s) {
    return second.arc_length(second.across(first.point(s), first.normal(s)));
  };
  std::pair<double, double> part(across(from), across(to));
  if (second.is_closed())
    for (double *const s : {&part.first, &part.second})
      *s += second.length() * std::round((across(0.5 * (from + to)) - *s) / second.length());
  return part;
}

FacingPart hull_of(const Curve &first, const std::vector<FacingPart> &parts) {
  Assert(!parts.empty(), ExcMessage("The curves face each other."));
  // Around a closed curve, all but the longest gap.
  std::size_t begin = 0;
  double longest = 0.;
  for (std::size_t i = 0; i < parts.size() && first.is_closed(); ++i) {
    const double end_before = i > 0 ? parts[i - 1].to : parts.back().to - first.length();
    if (parts[i].from - end_before > longest) {
      longest = parts[i].from - end_before;
      begin = i;
    }
  }
  FacingPart overlap = parts[begin];
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::size_t k = (begin + i) % parts.size();
    overlap.to = parts[k].to + (k < begin ? first.length() : 0.);
    if (parts[k].distance < overlap.distance) {
      overlap.distance = parts[k].distance;
      overlap.nearest = parts[k].nearest;
    }
  }
  return overlap;
}
} // namespace Signorini
