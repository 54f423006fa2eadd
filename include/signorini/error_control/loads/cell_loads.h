// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/error_control/loads/composite_cell.h>

#include <vector>

namespace Signorini
{
/** The body force of a cell: what its nodes feel, and the part f_h that stresses balance exactly.
 */
struct CellLoad
{
  /** int f phi_i at the four corners, with the quadrature of the system. */
  std::array<dealii::Tensor<1, 2>, 4> nodal;
  /** d_k, the part that is constant on triangle k. */
  CompositeCell::Loads constant{};
  /**
   * On parallelograms, what f_h varies linearly by: with the half edges g_1 = (x_1 - x_0)/2 and
   * g_2 = (x_3 - x_0)/2 and the coordinates xi, eta in [-1,1], it is
   * g_1 (slope[0] xi + slope[1] eta) + g_2 (slope[2] xi + slope[3] eta).
   */
  std::array<double, 4> slope{};
  /** ‖f - f_h‖_{L2(K)}. The rest has neither force nor moment. */
  double rest = 0.;

  /** Components of a stress with the divergence -(what varies linearly). */
  Components stress(const CellShape &shape, const dealii::Point<2> &reference) const;
  /** The moments of its tractions on the edges of the cell. They are linear along edges. */
  CellMoments moments(const CellShape &shape) const;
};

/** A force density f and the values that it takes at points of a cell. */
struct ForceAtPoints
{
  std::vector<dealii::Tensor<1, 2>> offsets;
  std::vector<std::array<double, 4>> shape_values;
  std::vector<double> weights;
  std::vector<dealii::Vector<double>> values;
};

/**
 * f_h is the L2-projection of f onto linear functions on parallelograms. On other cells it is
 * constant on each of the four triangles: the value of that projection at its centre, plus a
 * multiple of the rotation of centres, such that the moment of f_h is that of f.
 */
CellLoad make_load(const CellShape &shape, const ForceAtPoints &force);

/** Adds a rotation about the centre, constant on triangles, with the given moment. @return its norm
 * in L2(K). */
double add_couple(const CellShape &shape, double moment, CellLoad &load);

/** All active cells in their order, the order of EdgeMesh::cells(). */
std::vector<dealii::Triangulation<2>::active_cell_iterator>
cells_in_order(const DisplacementSpace<2> &space);

/**
 * The loads of all cells, with @p n_points Gauss points per direction as in the system; empty
 * without a body force. On meshes below 500000/n_points² cells a rule of about 500000 points checks
 * them, with at most 96 per direction and 8 on the parts of cells that are cut, and takes their
 * place in cells where nodal forces differ by more than 10^-4. The moments of EdgeMoments then
 * leave a rest, which balance_cells() removes.
 */
std::vector<CellLoad> make_loads(const DisplacementSpace<2> &space,
                                 const Scene<2> &scene,
                                 const EdgeMesh &mesh,
                                 unsigned int n_points);
} // namespace Signorini
