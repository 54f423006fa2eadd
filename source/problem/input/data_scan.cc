// SPDX-License-Identifier: LGPL-2.1-or-later
// Formulas in boxes over the body and its sides.

#include <signorini/problem/input/data_scan.h>
#include <signorini/problem/scene/functions.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace Signorini {
namespace {
/** The variation of a formula that counts: a share of its mean, in the whole body. */
constexpr double negligible = 1e-8;

/** The largest number of lines: more are resolved by boxes. */
constexpr std::size_t max_lines = 64;

/** A formula, the size of its values, and whether it belongs to the body, not to a side. */
struct Datum {
  Expression<2> formula;
  double size;
  bool in_body;
};
using Data = std::vector<Datum>;

/** Returns the mean of the absolute value at points where it is finite. */
double mean_size(const Expression<2> &formula, const std::vector<Point<2>> &points) {
  std::vector<double> values(points.size());
  formula.evaluate(points, values);
  double sum = 0.;
  for (const double value : values)
    sum += std::isfinite(value) ? std::abs(value) : 0.;
  return sum / points.size();
}

/** Appends the components of a function that is given by formulas. */
void append(const FunctionPointer<2> &function, std::vector<Expression<2>> &formulas) {
  if (const auto given = std::dynamic_pointer_cast<const ExpressionFunction<2>>(function))
    formulas.insert(formulas.end(), given->components().begin(), given->components().end());
}

/** Returns whether a formula or its derivatives jump on a line, at one of many points in a box. */
bool jumps_on(const KinkLine<2> &line, const Datum &datum, const BoundingBox<2> &body) {
  constexpr int n = 128;
  constexpr double step = 1e-10, least = 1e-5;
  const double size = body.side_length(0) + body.side_length(1);
  const FormulaTree<2> &formula = datum.formula.formula();
  const Point<2> foot = body.center() - line.signed_distance(body.center()) * line.normal;
  for (int i = -n; i <= n; ++i) {
    const Point<2> x = foot + (i + 0.3) * size / n * cross_product_2d(line.normal),
                   before = x - step * size * line.normal, behind = x + step * size * line.normal;
    if (!body.point_inside(x))
      continue;
    const double jump = std::abs(formula.value(behind) - formula.value(before)),
                 kink = (formula.gradient(behind) - formula.gradient(before)).norm() * size;
    if (!(std::max(jump, kink) <= least * datum.size))
      return true;
  }
  return false;
}

/** A part of a side, and whether Gauss' rules show its data. */
struct Interval {
  double from, to;
  bool is_shown;
};

/** Looks at boxes, and collects the lines on which formulas switch. */
class Scan {
public:
  explicit Scan(const Scene<2> &scene)
    : scene_(scene)
    , body_({scene.geometry.lower, scene.geometry.upper})
    , lines_(scene.kinks.lines()) {
    constexpr unsigned int n = 32;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        points_.push_back(body_.unit_to_real(Point<2>((i + 0.5) / n, (j + 0.5) / n)));
  }

  /** @param max_looks the price of data that varies everywhere. */
  BoxTree scan_body(const std::vector<Expression<2>> &formulas, unsigned int max_looks);
  void scan_side(unsigned int number, std::vector<Point<2>> &breaks);
  /** Returns the lines of the scene, and those on which data is not smooth: switches inside of
   * others may change nothing. */
  std::vector<KinkLine<2>> kinks() const;

private:
  /** Returns the formulas that depend on the place. @param side points of the side that has them;
   * empty for those of the body. */
  Data data_of(const std::vector<Expression<2>> &formulas, const std::vector<Point<2>> &side = {});
  /** @param share that of the box in the body, or of an interval in its side. */
  std::array<bool, 2> look(const FormulaBox<2> &box, const Data &data, double share);
  void add_lines(const FormulaTree<2> &formula, const FormulaBox<2> &box);
  bool shows(const Curve &curve, const Data &data, double from, double to);
  void halve(const Curve &curve, const Data &data, const Interval &whole, unsigned int depth,
             std::vector<Interval> &parts);

  const Scene<2> &scene_;
  const BoundingBox<2> body_;
  /** Points in the box around the body. */
  std::vector<Point<2>> points_;
  /** All lines on which switches change. */
  std::vector<KinkLine<2>> lines_;
  Data all_data_;
};

Data Scan::data_of(const std::vector<Expression<2>> &formulas, const std::vector<Point<2>> &side) {
  // What vanishes on a side vanishes up to rounding of its values in the body.
  constexpr double rounding = 1e-6;
  Data data;
  for (const Expression<2> &formula : formulas)
    if (!formula.is_constant())
      data.push_back({formula,
                      side.empty()
                        ? mean_size(formula, points_)
                        : mean_size(formula, side) + rounding * mean_size(formula, points_),
                      side.empty()});
  all_data_.insert(all_data_.end(), data.begin(), data.end());
  return data;
}

std::vector<KinkLine<2>> Scan::kinks() const {
  const std::size_t n_given = scene_.kinks.lines().size();
  std::vector<KinkLine<2>> found(lines_.begin(), lines_.begin() + n_given);
  for (auto line = lines_.begin() + n_given; line != lines_.end(); ++line) {
    const auto jumps_in = [&](const bool in_body) {
      return std::any_of(all_data_.begin(), all_data_.end(), [&](const Datum &datum) {
        return datum.in_body == in_body && jumps_on(*line, datum, body_);
      });
    };
    const bool in_body = jumps_in(true);
    if (in_body || jumps_in(false))
      found.push_back({line->normal, line->position, in_body});
  }
  return found;
}

void Scan::add_lines(const FormulaTree<2> &formula, const FormulaBox<2> &box) {
  bool all = false;
  const double size = scene_.geometry.diameter();
  for (const KinkLine<2> &line : formula.lines_in(box, all)) {
    const bool is_known = std::any_of(lines_.begin(), lines_.end(), [&](const auto &known) {
      return line.coincides(known, box.centre(), 1e-9 * size);
    });
    if (!is_known && lines_.size() < max_lines)
      lines_.push_back(line);
  }
}

std::array<bool, 2> Scan::look(const FormulaBox<2> &box, const Data &data, const double share) {
  // In tiny boxes every curve looks like a line.
  constexpr double least_share = 1e-6;
  std::array<bool, 2> wanted = {{false, false}};
  for (const auto &[expression, size, in_body] : data) {
    const FormulaTree<2> &formula = expression.formula();
    const double tolerance = negligible * size / share;
    bool is_shown = formula.is_shown(box, lines_, tolerance);
    if (!is_shown && share > least_share) {
      const std::size_t n_lines = lines_.size();
      add_lines(formula, box);
      is_shown = lines_.size() > n_lines && formula.is_shown(box, lines_, tolerance);
    }
    if (is_shown)
      continue;
    const auto varies = formula.enclose(box).varies;
    for (unsigned int d = 0; d < 2; ++d)
      wanted[d] = wanted[d] || varies[d];
  }
  return wanted;
}

BoxTree Scan::scan_body(const std::vector<Expression<2>> &formulas, const unsigned int max_looks) {
  const Data data = data_of(formulas);
  if (data.empty())
    return {};
  // Where boxes meet on a line, nothing switches in either of them.
  for (const Datum &datum : data)
    add_lines(datum.formula.formula(), {scene_.geometry.lower, scene_.geometry.upper});
  return BoxTree(
    body_,
    [&](const BoundingBox<2> &box) {
      return look({box.get_boundary_points().first, box.get_boundary_points().second}, data,
                  box.volume() / body_.volume());
    },
    max_looks);
}

bool Scan::shows(const Curve &curve, const Data &data, const double from, const double to) {
  const Point<2> a = curve.point(from), b = curve.point(to), chord = a + 0.5 * (b - a);
  // An arc is nowhere farther from its chord than in the middle.
  const double height = curve.is_flat() ? 0. : curve.point(0.5 * (from + to)).distance(chord);
  BoundingBox<2> box({a, a});
  box.merge_with(BoundingBox<2>({b, b}));
  box.extend(height);
  const auto wanted = look({box.get_boundary_points().first, box.get_boundary_points().second},
                           data, (to - from) / curve.length());
  return !wanted[0] && !wanted[1];
}

void Scan::halve(const Curve &curve, const Data &data, const Interval &whole,
                 const unsigned int depth, std::vector<Interval> &parts) {
  constexpr unsigned int deepest = 36, most = 4000;
  const bool is_shown = shows(curve, data, whole.from, whole.to);
  if (is_shown || depth == deepest || parts.size() >= most) {
    parts.push_back({whole.from, whole.to, is_shown});
    return;
  }
  const double middle = 0.5 * (whole.from + whole.to);
  halve(curve, data, {whole.from, middle, false}, depth + 1, parts);
  halve(curve, data, {middle, whole.to, false}, depth + 1, parts);
}

void Scan::scan_side(const unsigned int number, std::vector<Point<2>> &breaks) {
  const Side<2> &side = scene_.geometry.sides[number];
  const BoundaryCondition<2> &condition = scene_.boundary[number];
  constexpr unsigned int n = 64;
  std::vector<Point<2>> points;
  for (unsigned int i = 0; i < n; ++i)
    points.push_back(side.point((i + 0.5) / n * side.length()));
  std::vector<Expression<2>> formulas;
  for (const auto &function : {condition.data, condition.friction, condition.shift})
    append(function, formulas);
  const Data data = data_of(formulas, points);
  const unsigned int n_first = side.n_pieces() > 16 ? 1 : 4;
  for (unsigned int k = 0; k < side.n_pieces() * n_first && !data.empty(); ++k) {
    const Curve &piece = side.piece(k / n_first);
    const double width = piece.length() / n_first, from = (k % n_first) * width;
    std::vector<Interval> parts, joined;
    halve(piece, data, {from, from + width, false}, 0, parts);
    // The halves shrink towards a jump; what lies between two jumps is one interval again.
    for (const Interval &part : parts)
      if (!joined.empty() && joined.back().is_shown && part.is_shown &&
          shows(piece, data, joined.back().from, part.to))
        joined.back().to = part.to;
      else
        joined.push_back(part);
    for (std::size_t i = 0; i < joined.size() && joined.size() > 1; ++i)
      for (const double s : {joined[i].from, joined[i].to})
        if (breaks.empty() || breaks.back().distance(piece.point(s)) > 1e-10 * side.length())
          breaks.push_back(piece.point(s));
  }
}
} // namespace

void scan_data(Scene<2> &scene) {
  // A box of the moduli costs many points in each integral of the bound.
  constexpr unsigned int max_looks_at_law = 1500, max_looks_at_force = 100000;
  Scan scan(scene);
  std::vector<Expression<2>> force;
  append(scene.body_force, force);
  BoxTree of_law = scan.scan_body(scene.material->expressions(), max_looks_at_law),
          of_force = scan.scan_body(force, max_looks_at_force);
  std::vector<Point<2>> breaks;
  for (unsigned int side = 0; side < scene.boundary.size(); ++side)
    scan.scan_side(side, breaks);
  const std::vector<KinkLine<2>> lines = scan.kinks();
  if (!scene.material->is_constant_on_cells())
    scene.law_kinks = Kinks<2>(lines, {}, std::move(of_law));
  scene.kinks = Kinks<2>(lines, std::move(breaks), std::move(of_force));
}
} // namespace Signorini
