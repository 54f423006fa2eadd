// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/loads/bound_data.h>
#include <signorini/error_control/loads/edge_mesh.h>

#include <vector>

namespace Signorini {
/** The given tractions on boundary edges. */
struct GivenTractions {
  /** The moments of the tractions on edges of EdgeFreedom::none, zero on others (see EdgeMesh). */
  std::vector<double> moments;
  /** The norms in L2(e) of the normal component and of the shear of t - t_h for every edge; t_h is
   * the linear function with the moments of t. t - t_h has neither force nor moment. */
  std::vector<double> normal_rest, shear_rest;
};

/** Returns the given tractions: t on traction sides, and p_H n on contact sides. t is integrated
 * with Gauss points as in the system, or with up to 256 on edges where these give
 * moments that differ by more than 10^-4 (20000 on all edges at most). p_H n is exact, also where
 * patches end inside a face. */
GivenTractions given_tractions(const BoundData &data, const EdgeMesh &mesh);

/** The forces R_K^i at the corners of a cell. */
using CornerForces = std::array<Tensor<1, 2>, 4>;

/** Moments of tractions around all vertices. */
struct EdgeMoments {
  /** The moments, see EdgeMesh. */
  std::vector<double> moments;
  /** The rest at every vertex, per cell: the moments around a cell balance R_K^i - rest(i). */
  std::vector<Tensor<1, 2>> rest;
};

/**
 * Solves, for every vertex i, the equations b_i^e - b_i^e' = R_K^i for its cells K, with e and e'
 * the edges of K at i in the order of Star and b_i^e the moments of tractions on the cell to the
 * left. The free number per component, where there is one, brings the moments as close to the guess
 * as can be, in least squares.
 *
 * The equations can be solved if Σ_K R_K^i is balanced by given tractions: the Galerkin rows. The
 * rest that rounding or an iterative solver leaves is divided among the cells of the vertex.
 */
EdgeMoments solve_stars(const EdgeMesh &mesh, const std::vector<CornerForces> &R,
                        const std::vector<double> &given, const std::vector<double> &guess);

/** Adds EdgeMoments::rest at the vertices of contact edges to their given tractions. On curved
 * contact sides this rest is the difference between p_H n on arcs and on chords: the moments are
 * then those of the system. */
void give_to_contact(const EdgeMesh &mesh, const Scene<2> &scene,
                     const std::vector<Tensor<1, 2>> &rest, GivenTractions &given);
} // namespace Signorini
