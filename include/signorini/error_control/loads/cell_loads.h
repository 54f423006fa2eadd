// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/error_control/loads/composite_cell.h>

#include <vector>

namespace Signorini
{
/** The body force of a cell: its nodal forces, and the part f_h that stresses balance exactly. */
struct CellLoad
{
  /** The nodal forces ∫ f φ_i at the four corners, with the quadrature of the system. */
  std::array<dealii::Tensor<1, 2>, 4> nodal;
  /** The loads d_k, the part of f_h that is constant on triangle k. */
  CompositeCell::Loads constant{};
  /** The linear part of f_h on parallelograms. With the half edges g_1 = (x_1 - x_0)/2 and g_2 =
   * (x_3 - x_0)/2 and the coordinates ξ, η in [-1,1], it is g_1 (slope[0] ξ + slope[1] η) +
   * g_2 (slope[2] ξ + slope[3] η). */
  std::array<double, 4> slope{};
  /** The norm ‖f - f_h‖_{L2(K)}. f - f_h has neither force nor moment. */
  double rest = 0.;

  /** Returns the components of a stress whose divergence is minus the linear part of f_h. */
  Components stress(const CellShape &shape, const dealii::Point<2> &reference) const;
  /** Returns the moments of the tractions of that stress on the edges of the cell. The tractions
   * are linear along edges. */
  CellMoments moments(const CellShape &shape) const;
};

/** The values of a force density f at points of a cell. */
struct ForceAtPoints
{
  std::vector<dealii::Tensor<1, 2>> offsets;
  std::vector<std::array<double, 4>> shape_values;
  std::vector<double> weights;
  std::vector<dealii::Vector<double>> values;
};

/** Returns the load of a cell. f_h is the L2-projection of f onto linear functions on
 * parallelograms. On other cells it is constant on each of the four triangles: the value of that
 * projection at its centre, plus a multiple of the rotation of centres, such that the moment of f_h
 * is that of f. */
CellLoad make_load(const CellShape &shape, const ForceAtPoints &force);

/**
 * Adds a rotation about the centre, constant on triangles, with the given moment.
 * @return the norm of the rotation in L2(K).
 */
double add_couple(const CellShape &shape, double moment, CellLoad &load);

/** Returns all active cells in their order, which is that of EdgeMesh::cells(). */
std::vector<dealii::Triangulation<2>::active_cell_iterator>
cells_in_order(const DisplacementSpace<2> &space);

/** Returns the loads of all cells, with @p n_points Gauss points per direction as in the system;
 * empty without a body force. On meshes below 500000/n_points² cells a rule of about 500000 points
 * checks them, with at most 96 per direction and 8 on the parts of cells that are cut, and takes
 * their place in cells where nodal forces differ by more than 10^-4. Then EdgeMoments leave a rest,
 * which balance_cells() removes. */
std::vector<CellLoad> make_loads(const DisplacementSpace<2> &space,
                                 const Scene<2> &scene,
                                 const EdgeMesh &mesh,
                                 unsigned int n_points);
} // namespace Signorini
