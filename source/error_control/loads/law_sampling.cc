// SPDX-License-Identifier: LGPL-2.1-or-later
// Variations of Hooke's tensor inside of cells.

#include <signorini/error_control/loads/law_sampling.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
namespace
{
using LawTriangle = RulePart::Triangle;

/** The logarithm of the factor by which the tensor may vary in a part. */
const double max_log_range = std::log(1.5);

/** The range of every feature over samples. */
class FeatureRange
{
public:
  FeatureRange()
  {
    low_.fill(std::numeric_limits<double>::max());
    high_.fill(std::numeric_limits<double>::lowest());
  }
  void add(const LawSampling::Features &features)
  {
    for (std::size_t i = 0; i < features.size(); ++i)
    {
      low_[i] = std::min(low_[i], features[i]);
      high_[i] = std::max(high_[i], features[i]);
    }
  }
  bool is_large() const
  {
    for (std::size_t i = 0; i < low_.size(); ++i)
      if (high_[i] - low_[i] > max_log_range)
        return true;
    return false;
  }

private:
  LawSampling::Features low_, high_;
};

/** The barycentric coordinates of points inside of a triangle: near its corners, near the middle of
 * its edges, and its centre. Data may jump on the edges themselves. */
constexpr std::array<std::array<double, 3>, 7> places = {{{{0.96, 0.02, 0.02}},
                                                          {{0.02, 0.96, 0.02}},
                                                          {{0.02, 0.02, 0.96}},
                                                          {{0.02, 0.49, 0.49}},
                                                          {{0.49, 0.02, 0.49}},
                                                          {{0.49, 0.49, 0.02}},
                                                          {{1. / 3., 1. / 3., 1. / 3.}}}};

double doubled_area(const Point<2> &a, const Point<2> &b, const Point<2> &c)
{
  return cross(b - a, c - a);
}

/** Returns whether a point is inside, and not closer to an edge than rounding. */
bool is_inside(const LawTriangle &x, const Point<2> &point)
{
  const double least = 1e-6 * doubled_area(x[0], x[1], x[2]);
  return doubled_area(point, x[1], x[2]) > least && doubled_area(x[0], point, x[2]) > least &&
         doubled_area(x[0], x[1], point) > least;
}

/** Returns the number k of the longest edge, from corner k to corner k + 1. */
unsigned int longest_edge(const LawTriangle &x)
{
  unsigned int longest = 0;
  for (unsigned int k = 1; k < 3; ++k)
    // Rounding must not decide between equal edges.
    if (x[k].distance(x[(k + 1) % 3]) > (1. + 1e-10) * x[longest].distance(x[(longest + 1) % 3]))
      longest = k;
  return longest;
}
} // namespace

LawSampling::LawSampling(const Material<2> &material, const std::size_t n_cells)
  : material_(material)
  , intervals_(std::clamp<unsigned int>(std::sqrt(5e5 / n_cells), 6, 96))
{
}

LawSampling::Sample LawSampling::sample(const Point<2> &x) const
{
  const SymmetricTensor<4, 2> C = material_.relative_hooke(x);
  const Tensor<2, 3> matrix({{C[0][0][0][0], C[0][0][1][1], C[0][0][0][1]},
                             {C[1][1][0][0], C[1][1][1][1], C[1][1][0][1]},
                             {C[0][1][0][0], C[0][1][1][1], C[0][1][0][1]}});
  const double norm = matrix.norm();
  return {x,
          {{std::log(norm),
            std::log(invert(matrix).norm()),
            matrix[0][0] / norm,
            matrix[1][1] / norm,
            matrix[2][2] / norm,
            matrix[0][1] / norm,
            matrix[0][2] / norm,
            matrix[1][2] / norm}}};
}

LawSampling::Samples LawSampling::scan(const std::array<Point<2>, 4> &corners) const
{
  Samples samples;
  samples.reserve(intervals_ * intervals_);
  for (unsigned int i = 0; i < intervals_; ++i)
    for (unsigned int j = 0; j < intervals_; ++j)
    {
      const double s = (i + 0.5) / intervals_, t = (j + 0.5) / intervals_;
      samples.push_back(sample(corners[0] + s * (1. - t) * (corners[1] - corners[0]) +
                               s * t * (corners[2] - corners[0]) +
                               (1. - s) * t * (corners[3] - corners[0])));
    }
  return samples;
}

bool LawSampling::varies(const Samples &samples)
{
  FeatureRange range;
  for (const Sample &at : samples)
    range.add(at.features);
  return range.is_large();
}

std::vector<RulePart> LawSampling::divide(const LawTriangle &whole,
                                          const Samples &samples,
                                          const double least) const
{
  struct Open
  {
    LawTriangle x;
    std::vector<const Sample *> samples;
  };
  std::vector<Open> open(1);
  open[0].x = whole;
  for (const Sample &at : samples)
    open[0].samples.push_back(&at);
  std::vector<RulePart> parts;
  while (!open.empty())
  {
    const Open here = std::move(open.back());
    open.pop_back();
    const LawTriangle &x = here.x;
    FeatureRange range;
    std::vector<const Sample *> inside;
    for (const Sample *at : here.samples)
      if (is_inside(x, at->x))
      {
        inside.push_back(at);
        range.add(at->features);
      }
    for (const auto &lambda : places)
      range.add(sample(x[0] + lambda[1] * (x[1] - x[0]) + lambda[2] * (x[2] - x[0])).features);
    const unsigned int k = longest_edge(x);
    const Point<2> &a = x[k], &b = x[(k + 1) % 3], &c = x[(k + 2) % 3];
    if (!range.is_large() || a.distance(b) < least)
    {
      parts.push_back({x, !range.is_large()});
      continue;
    }
    const Point<2> middle = a + 0.5 * (b - a);
    open.push_back({{{a, middle, c}}, inside});
    open.push_back({{{middle, b, c}}, std::move(inside)});
  }
  return parts;
}
} // namespace Signorini
