// SPDX-License-Identifier: LGPL-2.1-or-later
// Chains of segments and arcs: arc length and the nearest piece by bisection.

#include "curve_chain.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
namespace
{
/** The largest distance between pieces that follow one another, in lengths of the chain. */
constexpr double max_gap_between_pieces = 1e-8;

/** Returns the pieces with all segments in a row on one line joined to one. */
std::vector<Curve> without_straight_joints(const std::vector<Curve> &pieces)
{
  std::vector<Curve> merged;
  for (const Curve &piece : pieces)
  {
    const bool goes_on = !merged.empty() && merged.back().is_flat() && piece.is_flat() &&
                         (merged.back().tangent(0., 1.) - piece.tangent(0., 1.)).norm() < 1e-10;
    if (goes_on)
      merged.back() = Curve(merged.back().start(), piece.end(), merged.back().normal(0.));
    else
      merged.push_back(piece);
  }
  return merged;
}

double cross_product(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
{
  return a[0] * b[1] - a[1] * b[0];
}
} // namespace

Curve::Chain::Chain(const std::vector<Curve> &pieces)
  : pieces_(without_straight_joints(pieces))
  , starts_(1, 0.)
  , is_closed_(false)
{
  AssertThrow(!pieces_.empty(), ExcMessage("a chain has pieces"));
  for (const Curve &piece : pieces_)
    starts_.push_back(starts_.back() + piece.length());
  const auto hand = [](const Curve &piece) {
    return cross_product(piece.tangent(0., 1.), piece.normal(0.));
  };
  for (unsigned int k = 0; k < n_pieces(); ++k)
    AssertThrow(pieces_[k].n_pieces() == 1 && hand(pieces_[k]) * hand(pieces_[0]) > 0. &&
                  (k == 0 || pieces_[k - 1].end().distance(pieces_[k].start()) <=
                               max_gap_between_pieces * length()),
                ExcMessage("pieces of a chain follow one another"));
  is_closed_ = n_pieces() == 1 ? pieces_[0].is_closed()
                               : pieces_.back().end().distance(pieces_[0].start()) <=
                                   max_gap_between_pieces * length();
  find_corners();
  boxes_.resize(4 * pieces_.size());
  make_box(1, 0, n_pieces());
}

void Curve::Chain::find_corners()
{
  const auto turns = [&](const unsigned int before, const unsigned int after) {
    const double s = pieces_[before].length();
    const Tensor<1, 2> in = pieces_[before].tangent(s, s), out = pieces_[after].tangent(0., 0.);
    return std::abs(std::atan2(cross_product(in, out), in * out)) > min_corner_turn;
  };
  if (is_closed_ && n_pieces() > 1 && turns(n_pieces() - 1, 0))
    corners_.push_back(0.);
  for (unsigned int k = 1; k < n_pieces(); ++k)
    if (turns(k - 1, k))
      corners_.push_back(starts_[k]);
}

double Curve::Chain::Box::distance_square(const Point<2> &x) const
{
  double sum = 0.;
  for (unsigned int d = 0; d < 2; ++d)
  {
    const double outside = std::max({0., lower[d] - x[d], x[d] - upper[d]});
    sum += outside * outside;
  }
  return sum;
}

const Curve::Chain::Box &Curve::Chain::make_box(const std::size_t n,
                                                const unsigned int first,
                                                const unsigned int last)
{
  Box box;
  if (last - first == 1)
  {
    const Curve &piece = pieces_[first];
    box = {piece.start(), piece.start()};
    // A part of an arc is nowhere farther from its end than it is long.
    const unsigned int n_parts = piece.is_flat() ? 1 : 8;
    for (unsigned int i = 1; i <= n_parts; ++i)
      for (unsigned int d = 0; d < 2; ++d)
      {
        const double x = piece.point(i * piece.length() / n_parts)[d];
        const double margin = piece.is_flat() ? 0. : piece.length() / n_parts;
        box.lower[d] = std::min(box.lower[d], x - margin);
        box.upper[d] = std::max(box.upper[d], x + margin);
      }
  }
  else
  {
    const unsigned int middle = (first + last) / 2;
    box = make_box(2 * n, first, middle);
    const Box &other = make_box(2 * n + 1, middle, last);
    for (unsigned int d = 0; d < 2; ++d)
    {
      box.lower[d] = std::min(box.lower[d], other.lower[d]);
      box.upper[d] = std::max(box.upper[d], other.upper[d]);
    }
  }
  boxes_[n] = box;
  return boxes_[n];
}

std::pair<unsigned int, double> Curve::Chain::place(double s) const
{
  if (is_closed_)
    s -= length() * std::floor(s / length());
  const auto next = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, s);
  const auto k = static_cast<unsigned int>(next - starts_.begin() - 1);
  return {k, s - starts_[k]};
}

std::pair<unsigned int, double> Curve::Chain::place(double s, const double towards) const
{
  const double step =
    std::copysign(std::min(1e-9 * length(), 0.5 * std::abs(towards - s)), towards - s);
  const double turns = is_closed_ ? length() * std::floor((s + step) / length()) : 0.;
  const unsigned int k = place(s + step - turns).first;
  return {k, s - turns - starts_[k]};
}

Curve::Chain::Nearest Curve::Chain::on_piece(const unsigned int k, const Point<2> &x) const
{
  const Curve &piece = pieces_[k];
  const double s = std::clamp(piece.arc_length(x), 0., piece.length());
  return {k, s, piece.point(s).distance_square(x)};
}

void Curve::Chain::search(const std::size_t n,
                          const unsigned int first,
                          const unsigned int last,
                          const Point<2> &x,
                          Nearest &nearest) const
{
  if (boxes_[n].distance_square(x) >= nearest.distance_square)
    return;
  if (last - first == 1)
  {
    const Nearest found = on_piece(first, x);
    if (found.distance_square < nearest.distance_square)
      nearest = found;
    return;
  }
  const unsigned int middle = (first + last) / 2;
  const bool right_first = boxes_[2 * n + 1].distance_square(x) < boxes_[2 * n].distance_square(x);
  for (const bool right : {right_first, !right_first})
    if (right)
      search(2 * n + 1, middle, last, x, nearest);
    else
      search(2 * n, first, middle, x, nearest);
}

double Curve::Chain::arc_length(const Point<2> &x) const
{
  Nearest nearest = {0, 0., std::numeric_limits<double>::infinity()};
  search(1, 0, n_pieces(), x, nearest);
  const Curve &piece = pieces_[nearest.piece];
  double s = starts_[nearest.piece] + nearest.s;
  if (is_closed_)
    return s < length() ? s : 0.;
  // The outer pieces go on beyond the ends of the chain.
  if (nearest.piece == 0 && nearest.s == 0.)
    s = std::min(0., piece.arc_length(x));
  else if (nearest.piece + 1 == n_pieces() && nearest.s == piece.length())
    s = starts_[nearest.piece] + std::max(piece.length(), piece.arc_length(x));
  return s;
}

std::vector<unsigned int> Curve::Chain::pieces_near(const Point<2> &x, const double distance) const
{
  struct Node
  {
    std::size_t n;
    unsigned int first, last;
  };
  std::vector<unsigned int> found;
  std::vector<Node> nodes = {{1, 0, n_pieces()}};
  while (!nodes.empty())
  {
    const Node node = nodes.back();
    nodes.pop_back();
    if (boxes_[node.n].distance_square(x) > distance * distance)
      continue;
    const unsigned int middle = (node.first + node.last) / 2;
    if (node.last - node.first > 1)
    {
      nodes.push_back({2 * node.n, node.first, middle});
      nodes.push_back({2 * node.n + 1, middle, node.last});
    }
    else if (on_piece(node.first, x).distance_square <= distance * distance)
      found.push_back(node.first);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<double> Curve::Chain::crossings(const Tensor<1, 2> &m,
                                            const double position,
                                            const double from,
                                            const double to) const
{
  std::vector<double> found;
  const double apart = 1e-12 * length();
  const auto add = [&](const unsigned int k, const double turns) {
    const double start = turns + starts_[k];
    const bool is_first = k == 0 && !is_closed_, is_last = k + 1 == n_pieces() && !is_closed_;
    // What rounding takes from one piece it leaves to the other.
    const double lowest = is_first ? from - start : std::max(from - start, -apart);
    const double highest = is_last ? to - start : std::min(to - start, pieces_[k].length() + apart);
    if (lowest <= highest)
      for (const double s : pieces_[k].crossings(m, position, lowest, highest))
        if (found.empty() || start + s > found.back() + 4. * apart)
          found.push_back(start + s);
  };
  const double first_turn = is_closed_ ? std::floor(from / length()) : 0.;
  for (double turn = first_turn; turn == first_turn || (is_closed_ && turn * length() <= to);
       ++turn)
  {
    const double turns = turn * length();
    for (unsigned int k = place(std::max(from, turns) - turns).first;
         k < n_pieces() && turns + starts_[k] <= to;
         ++k)
      add(k, turns);
  }
  return found;
}
} // namespace Signorini
