// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Signorini
{
/** The cell or patch of a graded mesh on which a value was found: it tells whether a later mesh is
 * finer there. Nested meshes are finer everywhere, and leave it zero. */
struct MeshAt
{
  /** The diameter of the cell, or the length of the patch (length). */
  double size = 0.;
  /** Of the polynomials. */
  unsigned int degree = 0;
};
} // namespace Signorini
