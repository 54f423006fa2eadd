// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/discretization/multiplier/multiplier_space.h>

#include <array>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace Signorini
{
/** The fields at one point of the contact boundary of a 2-D body. Pressures are those of the
 * formulas, sigma_n: negative in compression. */
struct ContactPoint
{
  /** The arc length along the side. */
  double s;
  Point<2> x;
  /** The outward normal. */
  Tensor<1, 2> n;
  double p_H;
  double p_recovered;
  Tensor<1, 2> u;
  double u_n;
  double g;
  std::optional<double> p_exact;
};

/** A piece face ∩ patch with some of its points. */
struct ContactSegment
{
  std::string side;
  /** The numbers of the side in the geometry, of the contact face and of the patch. */
  unsigned int side_number, face, patch;
  /** The length |tau| of the patch (length). */
  double patch_length;
  /** The points of tables, in the order of arc length. A piece with a constant has its middle; a
   * piece with polynomials has its ends, the nodes of the multipliers, and the middles between all
   * of these. */
  std::vector<ContactPoint> rows;
  /** The points of curves. A piece with a constant has its ends and points between them; a piece
   * with polynomials has the same points as in tables. */
  std::vector<ContactPoint> curve;
};

/**
 * Returns the contact boundary piece by piece, side after side, in the order of arc length.
 * @param n_parts into which points divide the curve of a piece with a constant.
 */
std::vector<ContactSegment> trace_contact_line(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const Displacement &U,
                                               const Pressure &P,
                                               unsigned int n_parts = 1);

/** Returns the same with gap and exact pressure of other conditions on the same sides. */
std::vector<ContactSegment> trace_contact_line(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const std::vector<BoundaryCondition<2>> &boundary,
                                               const Displacement &U,
                                               const Pressure &P,
                                               unsigned int n_parts = 1);

/** Writes contact-LL.csv. */
void write_contact_csv(std::ostream &stream, const std::vector<ContactSegment> &line);

/**
 * Writes contact-LL.vtu: pressures (positive in compression), displacement, gap and opening along
 * the contact boundary.
 * @param bound of every contact face; empty if there is none.
 */
void write_contact_vtu(std::ostream &stream,
                       const std::vector<ContactSegment> &line,
                       const std::vector<double> &bound);

/** The fields at one point of the contact boundary of a 3-D body. Pressures are those of the
 * formulas, sigma_n: negative in compression. */
struct ContactAreaPoint
{
  Point<3> x;
  double p_H;
  double p_recovered;
  Tensor<1, 3> u;
  double u_n;
  double g;
  std::optional<double> p_exact;
};

/** A contact face of a 3-D body. */
struct ContactQuadrilateral
{
  std::string side;
  /** The numbers of the side in the geometry, of the contact face and of the patch. */
  unsigned int side_number, face, patch;
  /** The area |tau| of the patch (length²). */
  double patch_area;
  /** The corners in the order of the vertices of deal.II's faces: the second differs from the first
   * in one coordinate, the third in the other, the fourth in both. */
  std::array<ContactAreaPoint, 4> corners;
  ContactAreaPoint middle;
};

/** Returns the contact boundary face by face, side after side, with the conditions of the surface's
 * own scene or with others on the same sides. */
std::vector<ContactQuadrilateral>
trace_contact_area(const DisplacementSpace<3> &space,
                   const MultiplierSpace<3> &multipliers,
                   const std::vector<BoundaryCondition<3>> &boundary,
                   const Displacement &U,
                   const Pressure &P);

/** Writes contact-LL.csv in 3-D: one row for each contact face, at its middle. */
void write_contact_csv(std::ostream &stream, const std::vector<ContactQuadrilateral> &area);

/** Writes contact-LL.vtu in 3-D: the faces with the fields of write_contact_vtu() of a line. @param
 * bound of every contact face; empty if there is none. */
void write_contact_vtu(std::ostream &stream,
                       const std::vector<ContactQuadrilateral> &area,
                       const std::vector<double> &bound);

/** The contact boundary for tables and files, piece by piece. */
template <int dim>
using TracedContact =
  std::vector<std::conditional_t<dim == 2, ContactSegment, ContactQuadrilateral>>;

/** Returns the contact boundary for tables and files. @param boundary the gap and the exact
 * pressure of every side. */
template <int dim>
TracedContact<dim> trace_contact(const DisplacementSpace<dim> &space,
                                 const MultiplierSpace<dim> &multipliers,
                                 const std::vector<BoundaryCondition<dim>> &boundary,
                                 const Displacement &U,
                                 const Pressure &P)
{
  if constexpr (dim == 2)
    return trace_contact_line(space, multipliers, boundary, U, P);
  else
    return trace_contact_area(space, multipliers, boundary, U, P);
}
} // namespace Signorini
