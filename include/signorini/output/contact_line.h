// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>
#include <signorini/multiplier/multiplier_space.h>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace Signorini
{
/** What is known at one point of the contact boundary of a plane body. Pressures are those of the
 * formulas, sigma_n: negative in compression. */
struct ContactPoint
{
  /** Arc length along the side. */
  double s;
  dealii::Point<2> x;
  /** Outward. */
  dealii::Tensor<1, 2> n;
  double p_H;
  double p_recovered;
  dealii::Tensor<1, 2> u;
  double u_n;
  double g;
  std::optional<double> p_exact;
};

/** A piece face ∩ patch with some of its points. */
struct ContactSegment
{
  std::string side;
  /** Number of the side in the geometry, of the contact face and of the patch. */
  unsigned int side_number, face, patch;
  /** |tau| (length). */
  double patch_length;
  /** What tables show, in the order of arc length. Of constants the middle. Of polynomials the
   * ends, the nodes of the multipliers, and the middles between all of these. */
  std::vector<ContactPoint> rows;
  /** What curves join: of constants the ends and points between them, of polynomials the same
   * points as in tables. */
  std::vector<ContactPoint> curve;
};

/**
 * The contact boundary piece by piece, side after side, in the order of arc length.
 * @param n_parts into which points divide the curve of a piece with a constant.
 */
std::vector<ContactSegment> trace_contact_line(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const NodalVector &U,
                                               const dealii::Vector<double> &P,
                                               unsigned int n_parts = 1);

/** The same with gap and exact pressure of other conditions on the same sides. */
std::vector<ContactSegment> trace_contact_line(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const std::vector<BoundaryCondition<2>> &boundary,
                                               const NodalVector &U,
                                               const dealii::Vector<double> &P,
                                               unsigned int n_parts = 1);

/** contact-LL.csv. */
void write_contact_csv(std::ostream &stream, const std::vector<ContactSegment> &line);

/**
 * contact-LL.vtu: pressures (positive in compression), displacement, gap and opening along the
 * contact boundary.
 * @param bound of every contact face; empty if there is none.
 */
void write_contact_vtu(std::ostream &stream,
                       const std::vector<ContactSegment> &line,
                       const std::vector<double> &bound);
} // namespace Signorini
