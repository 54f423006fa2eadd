// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/contact_term/contact_trace.h>
#include <signorini/error_control/loads/law_sampling.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>

#include <map>
#include <optional>
#include <vector>

namespace Signorini
{
/**
 * The lift w = w_h + Σ_F r_F(t) ψ_F n: a function of V^h with homogeneous essential conditions,
 * and for each contact face F what it lacks inside the face.
 *
 * F is the end of a column of cells, each entered through one edge and left through the opposite
 * one, with t along these edges. r_F vanishes at both ends of F, and so on the flanks of the
 * column; ψ_F is 1 on F, piecewise linear along the column, and 0 where it ends. So w is
 * continuous and vanishes on essential boundaries like w_h, whatever the shapes of the cells.
 *
 * The depth of a column is D = (3 C_nn ∫ r² / (C_nt ∫ r'²))^{1/2}, C_nn and C_nt the moduli of
 * stretch along n and of shear at F: for r(t) (1 - y/D) n on a strip the energy is at most 1/2
 * (C_nn ∫ r²/D + C_nt D/3 ∫ r'²) + mixed terms, least for this D. Any D is right; it is cut
 * where the column meets the boundary or cells of another size.
 */
class LiftField
{
public:
  using CellIterator = DoFHandler<2>::active_cell_iterator;

  /**
   * Builds the columns below all faces with a remainder. Space, scene and trace must outlive the
   * object.
   * @param remainders r_F in the order of trace.faces(); zero at 0 and 1.
   */
  LiftField(const DisplacementSpace<2> &space,
            const Scene<2> &scene,
            const ContactTrace &trace,
            Displacement w_h,
            std::vector<EdgeFunction> remainders);

  /** Returns w_n at t of a face. */
  double normal_value(unsigned int face, double t) const;
  /** Returns r_F of a face. */
  const EdgeFunction &remainder(const unsigned int face) const
  {
    return remainders_[face];
  }
  /** Returns w at a point of the reference cell. */
  Tensor<1, 2> value(const CellIterator &cell, const Point<2> &reference) const;

  /**
   * Returns ∫_K ε(w):E:ε(w) for every active cell K (force x length per thickness), and zero
   * for cells of other ranks.
   *
   * It is integrated by Gauss' formula on the parts of a cell on which w is a polynomial of degree
   * two in reference coordinates. This is exact on parallelograms with constant E. Elsewhere the
   * rule has four points per direction and part, and the parts are also cut where kinks of the data
   * cross edges of the cell. Where E varies by more than a factor of 1.5 in a cell (LawSampling),
   * the cell is cut into m/4 parts per direction, too.
   */
  dealii::Vector<double> cell_energies() const;

private:
  /** The part of a column in one cell. */
  struct Passage
  {
    unsigned int face;
    /** The edge through which the column enters, and whether t runs against that edge. */
    unsigned int entry;
    bool flipped;
    /** The coefficients of ψ = (top - slope η)_+, η in [0,1] across the cell from the entry.
     */
    double top, slope;
  };
  /** The values of w_h, the vertices and the columns that pass through a cell. */
  struct LocalField
  {
    std::array<Point<2>, 4> vertices;
    std::array<Tensor<1, 2>, 4> w_h;
    const std::vector<Passage> *passages;
  };

  void add_column(unsigned int face);
  double depth(unsigned int face) const;
  LocalField local_field(const CellIterator &cell) const;
  /** Returns the gradient of w with respect to reference coordinates. */
  Tensor<2, 2> reference_gradient(const LocalField &field, const Point<2> &x) const;
  double energy_of(const CellIterator &cell, const LocalField &field) const;
  /** Returns the positions at which pieces of w or of the material begin and end in reference
   * coordinate @p d, with those of @p n_equal parts. */
  std::vector<double> cuts(const CellIterator &cell,
                           const LocalField &field,
                           unsigned int d,
                           unsigned int n_equal) const;
  /** Returns the number of parts per direction into which the cell is cut because the material
   * varies in it. */
  unsigned int n_equal_parts(const LocalField &field) const;

  const DisplacementSpace<2> &space_;
  const Scene<2> &scene_;
  const ContactTrace &trace_;
  Displacement w_h_;
  std::vector<EdgeFunction> remainders_;
  /** The Gauss rules of two, three and four points. */
  std::array<QGauss<1>, 3> rules_;
  /** The samples of the material, if it varies. */
  std::optional<LawSampling> sampling_;
  /** The passages through each cell, by active cell index. */
  std::map<unsigned int, std::vector<Passage>> passages_;
};
} // namespace Signorini
