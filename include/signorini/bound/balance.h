// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/bound/edge_tractions.h>

#include <vector>

namespace Signorini
{
/**
 * Brings cells into exact balance. Around a cell, @p moments balance R_K^i - rest(i) (EdgeMoments),
 * where rest is what the linear solver left of the Galerkin rows. Each cell passes the force and
 * the moment that it lacks through one edge to a neighbour, and so on to an edge that may carry any
 * traction; in a body on rollers, to two rollers with different normals. What remains is rounding.
 *
 * @return whether such edges exist; if not, moments are not changed.
 */
bool balance_cells(const EdgeMesh &mesh,
                   const std::vector<dealii::Tensor<1, 2>> &rest,
                   std::vector<double> &moments);
} // namespace Signorini
