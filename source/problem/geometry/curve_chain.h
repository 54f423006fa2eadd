// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/curve.h>

#include <utility>
#include <vector>

namespace Signorini
{
/** The pieces of a chain with their boxes in a binary tree: every node halves its range until it is
 * one piece. */
class Curve::Chain
{
public:
  explicit Chain(const std::vector<Curve> &pieces);

  unsigned int n_pieces() const
  {
    return static_cast<unsigned int>(pieces_.size());
  }
  const Curve &piece(const unsigned int k) const
  {
    return pieces_[k];
  }
  /** Returns s where piece k starts; for k = n_pieces() the length. */
  double start_of(const unsigned int k) const
  {
    return starts_[k];
  }
  double length() const
  {
    return starts_.back();
  }
  bool is_closed() const
  {
    return is_closed_;
  }
  const std::vector<double> &corners() const
  {
    return corners_;
  }

  /** Returns the piece at s and the arc length on it; between two pieces the one behind. */
  std::pair<unsigned int, double> place(double s) const;
  /** Returns the piece at s and the arc length on it; between two pieces the one in the direction
   * of @p towards. */
  std::pair<unsigned int, double> place(double s, double towards) const;

  double arc_length(const dealii::Point<2> &x) const;
  std::vector<double>
  crossings(const dealii::Tensor<1, 2> &m, double position, double from, double to) const;
  std::vector<unsigned int> pieces_near(const dealii::Point<2> &x, double distance) const;

private:
  struct Box
  {
    dealii::Point<2> lower, upper;

    /** Returns the square of the distance from a point; zero inside. */
    double distance_square(const dealii::Point<2> &x) const;
  };
  struct Nearest
  {
    unsigned int piece;
    double s, distance_square;
  };

  void find_corners();
  /** Makes the box of node @p n, which holds the pieces from @p first to before @p last. */
  const Box &make_box(std::size_t n, unsigned int first, unsigned int last);
  /** Improves @p nearest, if a piece of the node does. */
  void search(std::size_t n,
              unsigned int first,
              unsigned int last,
              const dealii::Point<2> &x,
              Nearest &nearest) const;
  /** Returns the nearest point of piece k. */
  Nearest on_piece(unsigned int k, const dealii::Point<2> &x) const;

  std::vector<Curve> pieces_;
  /** The arc lengths at which pieces start, and the length. */
  std::vector<double> starts_;
  std::vector<double> corners_;
  bool is_closed_;
  /** Node 1 is the root, 2n and 2n + 1 are the halves of n. */
  std::vector<Box> boxes_;
};
} // namespace Signorini
