// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/stiffness/condensed_inverse.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <utility>
#include <vector>

namespace Signorini {
/**
 * The unknowns G inside cells of high degree, eliminated by dense matrices: with A_GG = L Lᵀ and
 * W = L⁻¹ A_GR for each cell,
 *
 *     A_RR - sum WᵀW
 *
 * is left for the other unknowns R. These dense blocks are nearly all of the entries of A, of which
 * a sparse factorisation makes several copies before it computes anything: without this, graded
 * meshes need a seventh more memory and CPU seconds.
 */
class CellInteriors {
public:
  /**
   * Finds groups of unknowns that follow each other and have the same couplings, of which none is
   * in @p kept; if none has a worthwhile size, nothing is eliminated and rest() is A.
   * @throws ComputationError if A is not positive definite.
   */
  CellInteriors(const Rows &A, const std::vector<bool> &kept);

  /** Returns A_RR - sum WᵀW. */
  const Rows &rest() const {
    return rest_;
  }
  /** Returns the unknown of A that belongs to each unknown of rest(), in increasing order. */
  const std::vector<int> &unknowns() const {
    return unknowns_;
  }
  /** Computes the right-hand side of rest() from that of A. */
  void reduce(const double *b, double *rest) const;
  /** Computes the solution for A from that for rest(), in the place of the right-hand side. */
  void expand(double *x, const double *rest) const;

private:
  struct Group {
    int first;
    int size;
    /** The unknowns R by numbers of rest(). */
    std::vector<int> others;
    LAPACKFullMatrix<double> L, W;
  };

  std::vector<std::pair<int, int>> find_groups(const Rows &A, const std::vector<bool> &kept) const;
  void copy_the_rest(const Rows &A);
  void eliminate(const Rows &A, int first, int size);

  std::vector<Group> groups_;
  Rows rest_;
  std::vector<int> unknowns_;
  /** The number in rest() of every unknown of A, or -1. */
  std::vector<int> numbers_;
  std::vector<int> start_, column_;
  std::vector<double> value_;
};
} // namespace Signorini
