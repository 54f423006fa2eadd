// SPDX-License-Identifier: LGPL-2.1-or-later
// Variations of Hooke's tensor inside of cells.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/error_control/loads/law_sampling.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
std::array<std::vector<TrianglePart>, 4> triangle_parts(const CellShape &shape,
                                                        const Kinks<2> &kinks,
                                                        const LawSampling *const sampling) {
  LawSampling::Samples samples;
  if (sampling != nullptr)
    samples = sampling->scan(shape.corners);
  const bool divide = sampling != nullptr && LawSampling::varies(samples);
  const double least_area = 1e-14 * shape.diameter() * shape.diameter();
  std::array<std::vector<TrianglePart>, 4> parts;
  for (unsigned int k = 0; k < 4; ++k) {
    const Triangle whole = shape.triangle(k);
    for (const auto &[corners, halvings] : cut_polygon(kinks, {whole.begin(), whole.end()}))
      for (std::size_t i = 2; i < corners.size(); ++i) {
        const Triangle part = {{corners[0], corners[i - 1], corners[i]}};
        if (twice_area(part) <= least_area)
          continue;
        if (divide)
          sampling->divide(part, samples, shape.diameter() / sampling->intervals(), parts[k]);
        else
          parts[k].push_back({part});
      }
  }
  return parts;
}

Quadrature<2> triangle_rule(const unsigned int degree) {
  const unsigned int n = degree / 2 + 1;
  if (n <= 7)
    return QWitherdenVincentSimplex<2>(n);
  return QDuffy(n, 1.);
}

LawSampling::LawSampling(const Material<2> &material, const std::size_t n_cells)
  : material_(material)
  , intervals_(std::clamp<unsigned int>(std::sqrt(5e5 / n_cells), min_intervals, 96)) {}

LawSampling::Sample LawSampling::sample(const Point<2> &x) const {
  const SymmetricTensor<4, 2> C = material_.relative_hooke(x);
  const Tensor<2, 3> matrix({{C[0][0][0][0], C[0][0][1][1], C[0][0][0][1]},
                             {C[1][1][0][0], C[1][1][1][1], C[1][1][0][1]},
                             {C[0][1][0][0], C[0][1][1][1], C[0][1][0][1]}});
  const Tensor<2, 3> shares = matrix / matrix.norm();
  return {x,
          {{matrix.norm(), invert(matrix).norm(), shares[0][0], shares[1][1], shares[2][2],
            shares[0][1], shares[0][2], shares[1][2]}}};
}

LawSampling::Samples LawSampling::scan(const std::array<Point<2>, 4> &corners) const {
  const CellShape shape(corners);
  Samples samples;
  samples.reserve(intervals_ * intervals_);
  for (unsigned int i = 0; i < intervals_; ++i)
    for (unsigned int j = 0; j < intervals_; ++j) {
      const Point<2> at((i + 0.5) / intervals_, (j + 0.5) / intervals_);
      samples.push_back(sample(corners[0] + shape.offset(CellFunctions(at))));
    }
  return samples;
}

bool LawSampling::varies_in(const std::array<Point<2>, 4> &corners,
                            const std::vector<Point<2>> &points) const {
  if (intervals_ > min_intervals)
    return varies(scan(corners));
  Samples samples;
  for (const Point<2> &x : points)
    samples.push_back(sample(x));
  return varies(samples);
}

bool LawSampling::varies(const Samples &samples) {
  constexpr double max_ratio = 1.5, max_difference = 0.4;
  for (unsigned int i = 0; i < samples.front().features.size(); ++i) {
    const auto [low, high] =
      std::minmax_element(samples.begin(), samples.end(), [i](const Sample &a, const Sample &b) {
        return a.features[i] < b.features[i];
      });
    const double least = low->features[i], most = high->features[i];
    if (i < 2 ? most > max_ratio * least : most - least > max_difference)
      return true;
  }
  return false;
}

void LawSampling::divide(const Triangle &x, const Samples &samples, const double least,
                         std::vector<TrianglePart> &parts) const {
  // Data may jump on the edges themselves.
  constexpr double inside = 1e-6;
  Samples here;
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(here), [&x](const Sample &s) {
    const std::array<double, 3> lambda = barycentric(x, s.x);
    return *std::min_element(lambda.begin(), lambda.end()) > inside;
  });
  const std::size_t n_scanned = here.size();
  // Near the corners and the middles of edges, and in the centre.
  constexpr double a = 0.02, b = 0.49, c = 1. / 3.;
  constexpr std::array<std::array<double, 2>, 7> places = {
    {{{a, a}}, {{1. - 2. * a, a}}, {{a, 1. - 2. * a}}, {{b, b}}, {{a, b}}, {{b, a}}, {{c, c}}}};
  for (const auto &place : places)
    here.push_back(sample(point_of(x, Point<2>(place[0], place[1]))));
  const bool is_resolved = !varies(here);
  unsigned int longest = 0;
  for (unsigned int k = 1; k < 3; ++k)
    // Rounding must not decide between equal edges.
    if (x[k].distance(x[(k + 1) % 3]) > (1. + 1e-10) * x[longest].distance(x[(longest + 1) % 3]))
      longest = k;
  const Point<2> &start = x[longest], &end = x[(longest + 1) % 3], &tip = x[(longest + 2) % 3];
  if (is_resolved || start.distance(end) < least) {
    parts.push_back({x, is_resolved});
    return;
  }
  here.resize(n_scanned);
  const Point<2> middle = start + 0.5 * (end - start);
  divide({{start, middle, tip}}, here, least, parts);
  divide({{middle, end, tip}}, here, least, parts);
}
} // namespace Signorini
