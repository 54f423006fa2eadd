// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/discretization/space/cell_field.h>
#include <signorini/error_control/equilibration/airy_cell.h>
#include <signorini/error_control/equilibration/bound_data.h>
#include <signorini/error_control/equilibration/triangle_parts.h>

#include <deal.II/grid/cell_id.h>

#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace Signorini {
/**
 * The energy of stresses with given tractions on a cell. With y = E x - shift, where E x are the
 * traces of the tractions,
 *
 *     min_τ ‖σ - τ‖²_{E⁻¹,K} = size² (rest² + yᵀ S y),   S of @p airy,
 *
 * over the τ with these traces and div τ + f_K = 0; f_K is the projection of f onto polynomials,
 * and σ is σ(u_h) or zero.
 */
struct CellFit {
  /** Returns y. @param number that of the cell in the space. */
  dealii::Vector<double> traces(const TractionSpace &space, std::size_t number,
                                const dealii::Vector<double> &x) const;
  /** Returns f_K at points. */
  std::vector<Tensor<1, 2>> force(const TractionCell &cell_data,
                                  const std::vector<Point<2>> &points) const;
  /** Returns the degree of f_K up to rounding. */
  unsigned int load_degree() const;

  CellId id;
  std::shared_ptr<const AiryCell> airy;
  /** The longest diagonal (length). */
  double size = 0.;
  dealii::Vector<double> shift;
  double rest = 0.;
  /** ∫ ε(u_h):(C' - C):ε(u_h) at unit size, where boxes do not resolve the law, see AiryPoint. */
  double unresolved = 0.;
  /** f_K at unit size. */
  PolynomialLoad load;
  /** The norm ‖f - f_K‖_{L2(K)}; f - f_K has neither force nor moment. */
  double load_rest = 0.;
  /** The smallest c with e:E:e ≥ c e:e on the cell. */
  double min_eigenvalue = 0.;
};

/** Fits stresses cell by cell. Cells with the same shape up to their size share an AiryCell where
 * the law is constant. */
class CellFitter {
public:
  /** @param compares whether stresses are compared with σ(u_h), else with zero. */
  CellFitter(const BoundData &data, bool compares);

  /** Returns the fits of all cells. @param known fits of other meshes: the same cells keep theirs.
   */
  std::vector<CellFit> fit_all(const EquilibrationMesh &mesh, const TractionSpace &space,
                               const std::vector<CellFit> &known);

private:
  using Cell = EquilibrationMesh::Cell;
  /** The data that cells of the same degree and shape share, unless the law varies. */
  struct Known {
    Known(const unsigned int degree, const CellShape &shape,
          const std::array<Tensor<1, 2>, 3> &edges, const SymmetricTensor<4, 2> &hooke)
      : degree(degree)
      , shape(shape)
      , edges(edges)
      , hooke(hooke) {}

    unsigned int degree;
    /** The first cell, and its edges from corner 0 at unit size. */
    CellShape shape;
    std::array<Tensor<1, 2>, 3> edges;
    /** Hooke's tensor at the crossing of the diagonals. */
    SymmetricTensor<4, 2> hooke;
    /** How many cells share this. A single one forgets its points: most of the time of a cell would
     * be that of fresh memory. */
    unsigned int n_cells = 1;
    std::once_flag is_made;
    std::shared_ptr<AiryCell> airy;
    std::mutex mutex;
    /** The values of Lagrange's polynomials at the points of a cell, in both coordinates, by the
     * degree of u_h. */
    std::map<unsigned int, std::array<LineTable, 2>> tables;
  };

  CellFit fit(const Cell &cell, const TractionSpace &space, Known &known) const;
  /** Returns the shared data of the cell. New data is added to @p alone where no other cell may
   * share it.
   */
  Known &find_known(const TractionCell &cell_data, std::list<Known> &alone);
  std::array<std::vector<AiryPoint>, 4> make_points(const CellShape &shape, double size,
                                                    unsigned int degree) const;
  /** Returns the weighted values of σ(u_h) at the points, and sets CellFit::unresolved. */
  dealii::Vector<double> stress_of_u(const Cell &cell, const CellShape &shape, Known &known,
                                     CellFit &fit) const;
  /** Returns a rule for f and f_K on a cell. */
  PlaneRule load_rule(const Cell &cell, const CellShape &shape, const CellFit &fit) const;
  /** Sets f_K by the points of a rule. */
  void project_load(const CellShape &shape, const PlaneRule &rule, CellFit &fit) const;
  /** Subtracts the stresses of f_K. @return their traces. */
  dealii::Vector<double> subtract_load(const Cell &cell, const CellShape &shape,
                                       dealii::Vector<double> &values, CellFit &fit) const;
  /** Subtracts the stresses that lift tractions given on arcs. @return their traces. */
  dealii::Vector<double> subtract_given(const TractionSpace &space, const TractionCell &cell_data,
                                        dealii::Vector<double> &values, const AiryCell &airy) const;

  const BoundData &data_;
  bool compares_, is_constant_;
  /** Where a law that varies is not smooth. */
  Kinks<2> kinks_;
  /** Gauss' rules by the number of points per direction. */
  mutable std::map<unsigned int, Quadrature<2>> load_rules_;
  mutable std::mutex load_rules_mutex_;
  std::list<Known> known_;
};
} // namespace Signorini
