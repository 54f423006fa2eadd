// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/base/parallel.h>
#include <signorini/discretization/space/displaced_body.h>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace Signorini {
/** The tangential part at one point. */
struct TangentialPoint {
  /** The tangential traction q_H, and the largest one that is allowed; in space |q_H|. */
  double q_H = 0., s_H = 0.;
  /** The slip u_t - g_t (length); in space its norm. */
  double slip = 0.;
  /** The state of the nearest node. */
  NodeState state = {};
  std::optional<double> q_exact = {};
  /** The same as vectors in space; empty in the plane. */
  Tensor<1, 3> traction = {}, slip_vector = {};

  template <typename Archive>
  void serialize(Archive &archive, unsigned int) {
    archive &q_H &s_H &slip &state.presses &state.slip &traction &slip_vector;
    archive_optional(archive, q_exact);
  }
};

/** The point of the other side of a pair that lies across on the normal of the first one: its
 * displacement u, and u.n for that normal (length). */
template <int dim>
struct PointAcross {
  Point<dim> x;
  Tensor<1, dim> u;
  double u_n = 0.;

  template <typename Archive>
  void serialize(Archive &archive, unsigned int) {
    archive &x &u &u_n;
  }
};

/** The fields at one point of the contact boundary. Pressures are those of the formulas, sigma_n:
 * negative in compression. */
template <int dim>
struct ContactPoint {
  /** The coordinates on the side; in 2-D the arc length. */
  Point<dim - 1> s;
  Point<dim> x;
  double p_H = 0.;
  double p_recovered = 0.;
  Tensor<1, dim> u;
  /** The direction m of contact, and u.m. */
  Tensor<1, dim> direction;
  double u_n = 0.;
  double g = 0.;
  std::optional<double> p_exact;
  std::optional<TangentialPoint> tangential;
  std::optional<PointAcross<dim>> across;

  template <typename Archive>
  void serialize(Archive &archive, unsigned int) {
    archive &s &x &p_H &p_recovered &u &direction &u_n &g;
    archive_optional(archive, p_exact);
    archive_optional(archive, tangential);
    archive_optional(archive, across);
  }
};

/** A piece face ∩ patch with some of its points. */
template <int dim>
struct ContactPiece {
  std::string side;
  /** The numbers of the contact in the scene, of its side in the geometry, of the contact face and
   * of the patch. */
  unsigned int contact, side_number, face, patch;
  /** The length or area |tau| of the patch. */
  double patch_measure;
  /** The number of the side of another body that it may touch. */
  std::optional<unsigned int> other_side;
  /** Whether contact acts along the normals of planes on the side. */
  bool has_direction;
  /** The points of tables. A piece with a constant has its middle; a piece with polynomials has its
   * ends, the nodes of the multipliers, and the middles between all of these, in the order of arc
   * length. */
  std::vector<ContactPoint<dim>> rows;
  /** The points of curves and surfaces. A piece with a constant has its corners, in the order of
   * the vertices of deal.II's faces; a piece with polynomials has the same points as in tables. */
  std::vector<ContactPoint<dim>> corners;

  template <typename Archive>
  void serialize(Archive &archive, unsigned int) {
    archive &side &contact &side_number &face &patch &patch_measure &has_direction &rows &corners;
    archive_optional(archive, other_side);
  }
};

/** The contact boundary piece by piece, contact after contact, in 2-D in the order of arc length.
 */
template <int dim>
using TracedContact = std::vector<ContactPiece<dim>>;

/** Returns the contact boundary for tables and files. Collective. */
template <int dim>
TracedContact<dim> trace_contact(const BodyInContact<dim> &body);

/** Writes contact-LL.csv. */
template <int dim>
void write_contact_csv(std::ostream &stream, const TracedContact<dim> &contact);

/**
 * Writes contact-LL.vtu: pressures (positive in compression), displacement, gap and opening along
 * the contact boundary. Both sides of a pair have a curve, with their own displacement.
 * @param bound of every contact face; empty if there is none.
 */
template <int dim>
void write_contact_vtu(std::ostream &stream, const TracedContact<dim> &contact,
                       const std::vector<double> &bound);
} // namespace Signorini
