// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/discretization/multiplier/multiplier_space.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>
#include <signorini/problem/scene/scene.h>

#include <vector>

namespace Signorini {
/** Tabulates Lagrange's polynomials at the nodes of an edge of the element FE_Q, those of Gauss and
 * Lobatto, at points between 0 and 1. */
LineTable make_line_table(unsigned int degree, const std::vector<double> &points);

/** The solution u_h on one cell as products of polynomials in the two reference coordinates. */
class CellField {
public:
  CellField(const DoFHandler<2>::active_cell_iterator &cell, const Displacement &U);

  unsigned int degree() const {
    return degree_;
  }
  /** Returns component c at node (i, j): node i along the first coordinate, j along the second. */
  double operator()(const unsigned int c, const unsigned int i, const unsigned int j) const {
    return values_[i + (degree_ + 1) * j][c];
  }
  /** Returns the value on a face of the cell, at s in [0,1] from its vertex 0 to its vertex 1. */
  Tensor<1, 2> on_face(unsigned int face, double s) const;
  /** Returns the derivatives with respect to the reference coordinates of the cell at the points
   * (x_i, y_j), point i + n_x j; [c][d] is that of component c with respect to coordinate d. */
  std::vector<Tensor<2, 2>> gradients(const LineTable &x, const LineTable &y) const {
    return evaluate_products<2>(values_, {&x, &y}).gradients;
  }

private:
  unsigned int degree_;
  /** The nodal values, lexicographically. */
  std::vector<Tensor<1, 2>> values_;
};

/** The error and the smoothness of u_h on a cell, from its coefficients. */
struct CellIndicator {
  /** An approximation of the energy norm of the error on the cell, (force length)^{1/2}. */
  double error = 0.;
  /** The factor by which the error falls when the degree grows by one: near 0 where u is analytic,
   * near 1 where it is singular. */
  double decay = 0.;
};

/**
 * Returns the indicator of every active cell, in their order.
 *
 * On a cell of degree p let s_i be the part of the derivative of u_h along a reference coordinate
 * that has Legendre's degree i in that coordinate, i = 0, ..., p - 1, measured in the energy norm.
 * A line through the last log s_i gives the decay ρ and the first part that is missing, s_p. The
 * missing parts amount to s_p (1 + ρ² + rho⁴ + ...)^{1/2}. The indicator steers the mesh; it is
 * not a bound. (Decay of Legendre coefficients as a measure of smoothness: C. Mavriplis, Comput.
 * Methods Appl. Mech. Eng. 116 (1994) 77-86; P. Houston, E. Suli, ibid. 194 (2005) 229-243.)
 */
std::vector<CellIndicator> indicate(const DisplacementSpace<2> &space, const Scene<2> &scene,
                                    const Displacement &U);

/** Returns a modulus for the energy of all strains but those that incompressible bodies avoid
 * (force/area). */
double indicator_modulus(const Scene<2> &scene, const Point<2> &x);

/** Returns the root of the sum of the squares of the errors. */
double total(const std::vector<CellIndicator> &indicators);

/**
 * Adds the misfit of contact to the indicators: where all multipliers of a face press, u_n = g in
 * the exact solution, but u_h fulfils it in the mean only; where all stick, this holds for u_t =
 * g_t. On a face of length h and degree p the difference r has about p half-waves, and to press the
 * body flat takes about the energy
 *
 *     modulus π/2 p/h ‖r‖_0²,
 *
 * that of a half-space with waves of the number π p/h. @throws InputError where g has no value.
 * @param follows for each patch whether the component follows the foundation there.
 */
void add_contact_misfit(const DisplacementSpace<2> &space, const MultiplierSpace<2> &multipliers,
                        const Scene<2> &scene, const Displacement &U,
                        const std::vector<bool> &follows, Component component,
                        std::vector<CellIndicator> &indicators);

/** Returns the active cells with a contact face on which the body penetrates the foundation
 * although no multiplier there or on a neighbouring face presses: the nodes of the multipliers have
 * missed the contact. Where nothing presses at all, every penetration counts, else those deeper
 * than a thousandth of the largest |u_n - g|. @throws InputError where g has no value. */
std::vector<unsigned int> missed_contact_cells(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const Displacement &U, const Pressure &P);

/** Returns the values of p_H at the nodes of other multipliers on the same sides, cut off at the
 * ends of an interval, as a start for an active set. */
Pressure transfer_pressure(const MultiplierSpace<2> &from, const Pressure &P,
                           const MultiplierSpace<2> &to, const Interval &allowed = {});
} // namespace Signorini
