// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/cell_field.h>
#include <signorini/error_control/equilibration/airy_cell.h>
#include <signorini/error_control/loads/bound_data.h>
#include <signorini/error_control/loads/law_sampling.h>

#include <list>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace Signorini {
/**
 * What stresses with given tractions cost on a cell. With y = E x - shift, where E x are the traces
 * of the tractions,
 *
 *     min_τ ‖σ(u_h) - τ‖²_{E⁻¹,K} = size² (rest² + yᵀ S y),   S of @p airy,
 *
 * over the τ with these traces and div τ + f_K = 0; f_K is the projection of f onto polynomials.
 */
struct CellFit {
  std::shared_ptr<const AiryCell> airy;
  /** The longest diagonal (length). */
  double size;
  dealii::Vector<double> shift;
  double rest = 0.;
  /** f_K at unit size. */
  PolynomialLoad load;
  /** The norms ‖f - f_K‖_{L2(K)} and ‖f‖; f - f_K has neither force nor moment. */
  double load_rest = 0., load_norm = 0.;
  /** The smallest c with e:E:e ≥ c e:e on the cell. */
  double min_eigenvalue = 0.;
};

/** Fits stresses to σ(u_h), cell by cell. Cells with the same shape up to their size share an
 * AiryCell where the law is constant. */
class CellFitter {
public:
  explicit CellFitter(const BoundData &data);

  /** @param of_u whether the stress is compared with σ(u_h), else with zero. */
  CellFit fit(const Triangulation<2>::active_cell_iterator &cell, const TractionCell &place,
              bool of_u);

private:
  /** The values of Lagrange's polynomials at the points of a cell, in both coordinates. */
  struct Tables {
    LineTable x, y;
  };

  std::array<std::vector<AiryPoint>, 4> make_points(const CellShape &shape, double size,
                                                    unsigned int degree) const;
  static Tables make_tables(const AiryCell &airy, unsigned int degree);
  /** Returns the weighted values of σ(u_h) at the points. */
  dealii::Vector<double> stress_of_u(const Triangulation<2>::active_cell_iterator &cell,
                                     const CellShape &shape, const AiryCell &airy,
                                     const Tables &tables);
  /** Returns f_K by the points of a rule. */
  PolynomialLoad project_load(const CellShape &shape, const Quadrature<2> &rule,
                              CellFit &fit) const;
  /** Subtracts the stresses of f_K. @return their traces. */
  dealii::Vector<double> subtract_load(const Triangulation<2>::active_cell_iterator &cell,
                                       const CellShape &shape, dealii::Vector<double> &values,
                                       CellFit &fit);

  const BoundData &data_;
  bool is_constant_;
  /** Where a law that varies is not smooth. */
  Kinks<2> kinks_;
  /** Gauss' rules by the number of points per direction. */
  std::map<unsigned int, Quadrature<2>> load_rules_;
  /** What cells of the same degree and shape share; tables by the degree of u_h. */
  struct Known {
    unsigned int degree;
    std::array<Tensor<1, 2>, 3> edges;
    std::shared_ptr<AiryCell> airy;
    std::map<unsigned int, Tables> tables;
  };
  /** Returns what the cell shares, a new one if it is the first; alone_ for others. */
  Known &find_known(const CellShape &shape, double size, const TractionCell &place);
  std::list<Known> known_;
  Known alone_;
};
} // namespace Signorini
