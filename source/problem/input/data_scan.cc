// SPDX-License-Identifier: LGPL-2.1-or-later
// Formulas in boxes over the body and its sides.

#include <signorini/problem/input/data_scan.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/problem/scene/functions.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace Signorini {
namespace {
/** The variation of a formula that counts: a share of its mean, in the whole body. */
constexpr double negligible = 1e-9;

/** The largest number of lines: more are resolved by boxes. */
constexpr std::size_t max_lines = 64;

/** The share of a box by which it overlaps its neighbours, so that a switch between two boxes lies
 * in both. */
constexpr double overlap = 1e-7;

/** The distance from a line at which branches are compared, and the difference that counts, as
 * shares of the body and of the size of the data: a derivative may jump by 1e-5 of that. */
constexpr double beside_line = 1e-6, least_effect = 1e-11;

/** A formula, the size of its values, and the side that has it; none if the body has it. */
struct Datum {
  Expression<2> formula;
  double size;
  const Side<2> *side;
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

/** Returns the part of a line in a box; two equal points if there is none. */
std::array<Point<2>, 2> part_in(const KinkLine<2> &line, const BoundingBox<2> &box) {
  const Tensor<1, 2> along = cross_product_2d(line.normal);
  const Point<2> foot = box.center() - line.signed_distance(box.center()) * line.normal;
  double from = -HUGE_VAL, to = HUGE_VAL;
  for (unsigned int d = 0; d < 2; ++d)
    if (std::abs(along[d]) > 1e-14) {
      const double one = (box.lower_bound(d) - foot[d]) / along[d],
                   other = (box.upper_bound(d) - foot[d]) / along[d];
      from = std::max(from, std::min(one, other));
      to = std::min(to, std::max(one, other));
    }
  return {{foot + from * along, foot + std::max(from, to) * along}};
}

/** Returns the box of all points that are not farther from a segment than a vector. */
FormulaBox<2> box_around(const Point<2> &a, const Point<2> &b, const Tensor<1, 2> &margin = {}) {
  FormulaBox<2> box = {a, b};
  for (unsigned int d = 0; d < 2; ++d) {
    box.lower[d] = std::min(a[d], b[d]) - std::abs(margin[d]);
    box.upper[d] = std::max(a[d], b[d]) + std::abs(margin[d]);
  }
  return box;
}

/** Returns whether data of the body changes on a line anywhere between two of its points. Parts in
 * which that is unclear are halved, down to some 1e-7 of the body.
 * @param n_looks the number of looks that are left; if they do not suffice, the data changes. */
bool changes_between(const Datum &datum, const KinkLine<2> &line, const Point<2> &a,
                     const Point<2> &b, const double size, unsigned int &n_looks) {
  constexpr double shortest = 1e-8;
  constexpr unsigned int n = 8;
  const Tensor<1, 2> step = std::min(beside_line * size, a.distance(b)) * line.normal;
  std::vector<Point<2>> points;
  for (unsigned int i = 0; i < n; ++i)
    for (const double sign : {-0.5, 0.5})
      points.push_back(a + (i + 0.5) / n * (b - a) + sign * step);
  const LineEffect effect = datum.formula.formula().effect_of(line, box_around(a, b, step), points,
                                                              least_effect * datum.size);
  if (effect != LineEffect::unclear || n_looks == 0)
    return effect != LineEffect::none;
  --n_looks;
  const Point<2> middle = a + 0.5 * (b - a);
  return a.distance(b) > shortest * size &&
         (changes_between(datum, line, a, middle, size, n_looks) ||
          changes_between(datum, line, middle, b, size, n_looks));
}

/** Returns whether data of a side changes where a line crosses it. */
bool changes_at_crossing(const Datum &datum, const KinkLine<2> &line, const double size) {
  const Side<2> &side = *datum.side;
  const std::vector<double> crossings =
    side.crossings(line.normal, line.position, 0., side.length());
  return std::any_of(crossings.begin(), crossings.end(), [&](const double s) {
    const Point<2> before = side.point(std::max(0., s - beside_line * size)),
                   behind = side.point(std::min(side.length(), s + beside_line * size));
    return datum.formula.formula().effect_of(line, box_around(before, behind), {before, behind},
                                             least_effect * datum.size) != LineEffect::none;
  });
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
  /** Returns the lines of the scene, and those on which data changes: a switch may change nothing
   * where others are as they are. */
  std::vector<KinkLine<2>> kinks() const;

private:
  /** Returns the formulas that depend on x. @param side that has them; none for the body.
   */
  Data data_of(const std::vector<Expression<2>> &formulas, const Side<2> *side = nullptr);
  /** @param share that of the box in the body, or of an interval in its side. */
  BoxTree::View look(const FormulaBox<2> &box, const Data &data, double share);
  /** Returns whether 8 x 8 points of a box show data that points of its halves show, as if it were
   * a polynomial of low degree. */
  static bool is_smooth(const BoundingBox<2> &box, const Data &data);
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

Data Scan::data_of(const std::vector<Expression<2>> &formulas, const Side<2> *const side) {
  // The size of a formula on a side has 1e-6 of its size in the body as a floor.
  constexpr double rounding = 1e-6;
  constexpr unsigned int n = 64;
  std::vector<Point<2>> on_side;
  for (unsigned int i = 0; i < n && side != nullptr; ++i)
    on_side.push_back(side->point((i + 0.5) / n * side->length()));
  Data data;
  for (const Expression<2> &formula : formulas)
    if (!formula.is_constant()) {
      const double in_body = mean_size(formula, points_);
      data.push_back({formula,
                      side == nullptr ? in_body : mean_size(formula, on_side) + rounding * in_body,
                      side});
    }
  all_data_.insert(all_data_.end(), data.begin(), data.end());
  return data;
}

std::vector<KinkLine<2>> Scan::kinks() const {
  constexpr unsigned int max_looks = 4000;
  const double size = scene_.geometry.diameter();
  const std::size_t n_given = scene_.kinks.lines().size();
  std::vector<KinkLine<2>> found(lines_.begin(), lines_.begin() + n_given);
  for (auto line = lines_.begin() + n_given; line != lines_.end(); ++line) {
    const std::array<Point<2>, 2> ends = part_in(*line, body_);
    const auto changes = [&](const bool in_body) {
      return std::any_of(all_data_.begin(), all_data_.end(), [&](const Datum &datum) {
        unsigned int n_looks = max_looks;
        return (datum.side == nullptr) == in_body &&
               (in_body ? changes_between(datum, *line, ends[0], ends[1], size, n_looks)
                        : changes_at_crossing(datum, *line, size));
      });
    };
    const bool in_body = changes(true);
    if (in_body || changes(false))
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

BoxTree::View Scan::look(const FormulaBox<2> &box, const Data &data, const double share) {
  // In tiny boxes every curve looks like a line.
  constexpr double least_share = 1e-6, matters = 1e-6;
  BoxTree::View view;
  for (const auto &[expression, size, side] : data) {
    const FormulaTree<2> &formula = expression.formula();
    const double tolerance = negligible * size / share;
    bool is_shown = formula.is_shown(box, lines_, tolerance);
    if (!is_shown && share > least_share) {
      const std::size_t n_lines = lines_.size();
      add_lines(formula, box);
      is_shown = lines_.size() > n_lines && formula.is_shown(box, lines_, tolerance);
    }
    const Enclosure<2> values = formula.enclose(box);
    if (!is_shown || (values.width() <= tolerance && !formula.is_shown(box, lines_, 0.)))
      view.hidden += values.width();
    if (is_shown)
      continue;
    for (unsigned int d = 0; d < 2; ++d)
      view.varies[d] = view.varies[d] || values.varies[d];
    view.matters = view.matters || values.width() * share > matters * size;
  }
  return view;
}

bool Scan::is_smooth(const BoundingBox<2> &box, const Data &data) {
  constexpr unsigned int n = 8;
  constexpr double rounding = 1e-12, largest_fourth = 0.002;
  std::vector<Point<2>> points;
  for (unsigned int i = 0; i < n * n; ++i)
    points.push_back(box.unit_to_real(Point<2>((i % n + 0.5) / n, (i / n + 0.5) / n)));
  std::vector<double> values(points.size());
  for (const Datum &datum : data) {
    datum.formula.evaluate(points, values);
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    double fourth = 0.;
    for (const unsigned int step : {1U, n})
      for (unsigned int i = 0; i < n * n; ++i)
        if (i / step % n + 4 < n)
          fourth = std::max(fourth,
                            std::abs(values[i] - 4. * values[i + step] + 6. * values[i + 2 * step] -
                                     4. * values[i + 3 * step] + values[i + 4 * step]));
    // Also where values are not finite.
    if (!(fourth <= largest_fourth * (*high - *low) + rounding * datum.size))
      return false;
  }
  return true;
}

BoxTree Scan::scan_body(const std::vector<Expression<2>> &formulas, const unsigned int max_looks) {
  const Data data = data_of(formulas);
  if (data.empty())
    return {};
  return BoxTree(
    body_,
    [&](const BoundingBox<2> &box) {
      FormulaBox<2> wider;
      for (unsigned int d = 0; d < 2; ++d) {
        const double margin = overlap * box.side_length(d);
        wider.lower[d] = std::max(box.lower_bound(d) - margin, body_.lower_bound(d));
        wider.upper[d] = std::min(box.upper_bound(d) + margin, body_.upper_bound(d));
      }
      return look(wider, data, box.volume() / body_.volume());
    },
    [&](const BoundingBox<2> &box) { return is_smooth(box, data); }, max_looks);
}

bool Scan::shows(const Curve &curve, const Data &data, const double from, const double to) {
  const double margin = overlap * (to - from);
  const Point<2> a = curve.point(std::max(0., from - margin)),
                 b = curve.point(std::min(curve.length(), to + margin)), chord = a + 0.5 * (b - a);
  // An arc is nowhere farther from its chord than in the middle.
  const double height = curve.is_flat() ? 0. : curve.point(0.5 * (from + to)).distance(chord);
  BoundingBox<2> box(std::vector<Point<2>>{a, b});
  box.extend(height);
  const auto varies = look({box.get_boundary_points().first, box.get_boundary_points().second},
                           data, (to - from) / curve.length())
                        .varies;
  return !varies[0] && !varies[1];
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
  std::vector<Expression<2>> formulas;
  append(scene_.boundary[number].data, formulas);
  for (const ContactCondition<2> &contact : scene_.contacts) {
    if (contact.side != number)
      continue;
    append(contact.gap, formulas);
    for (const auto &limit : scene_.contact_law.limits())
      append(contact.*limit.data, formulas);
    append(contact.shift, formulas);
  }
  const Data data = data_of(formulas, &side);
  const unsigned int n_first = side.n_pieces() > 16 ? 1 : 4;
  for (unsigned int k = 0; k < side.n_pieces() * n_first && !data.empty(); ++k) {
    const Curve &piece = side.piece(k / n_first);
    const double width = piece.length() / n_first, from = (k % n_first) * width;
    std::vector<Interval> parts, joined;
    halve(piece, data, {from, from + width, false}, 0, parts);
    // The halves shrink towards a jump; the intervals between two jumps are one again.
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
