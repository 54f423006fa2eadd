// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/mesh/contact_boundary.h>

namespace Signorini
{
/** tau: an interval of arc length on a contact side. */
struct Patch
{
  /** Number of the side in the geometry. */
  unsigned int side;
  double start;
  double end;

  double length() const
  {
    return end - start;
  }
  double middle() const
  {
    return 0.5 * (start + end);
  }
};

/** face ∩ tau, on which traces are polynomials and multipliers constant. */
struct Piece
{
  /** Number of the contact face. */
  unsigned int face;
  /** Number of the patch. */
  unsigned int patch;
  /** Arc length along the side. */
  double start;
  double end;
};

/** Gamma_c^H: the coarse partition of the contact sides, independent of the mesh. */
struct ContactPartition
{
  std::vector<Patch> patches;
  std::vector<Piece> pieces;

  /** H: the longest patch (length). */
  double longest_patch() const;
  /**
   * Whether a patch is no longer than a face that it meets (H = h): such partitions are not inf-sup
   * stable.
   */
  bool has_unstable_patch() const;
};

/**
 * Patches of @p ratio consecutive faces; where it does not divide the faces of a side, the last
 * patch is the longer one.
 */
template <int dim>
ContactPartition partition_by_ratio(const std::vector<ContactFace<dim>> &faces, unsigned int ratio);

/** @p n equal patches on every contact side, aligned with nothing. */
template <int dim>
ContactPartition partition_equally(const std::vector<ContactFace<dim>> &faces, unsigned int n);
} // namespace Signorini
