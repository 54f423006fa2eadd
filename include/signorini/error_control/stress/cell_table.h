// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/loads/cell_loads.h>
#include <signorini/error_control/loads/law_sampling.h>
#include <signorini/error_control/loads/prescribed_lift.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <optional>
#include <vector>

namespace Signorini {
/** Hooke's law C = G Gᵀ at a point: with strains e and stresses s, |Gᵀ e|² = e:C:e and |G⁻¹ s|² is
 * the complementary energy. */
struct Law {
  explicit Law(const SymmetricTensor<4, 2> &hooke);

  Tensor<2, 3> stiffness, root, inverse_root;
  /** The smallest c with e:C:e ≥ c e:e. */
  double min_eigenvalue;
};

/**
 * The numbers that determine σ(u_h + b + z) - τ on a cell: u_h at the corners, the coefficients of
 * the bubbles b (CellFunctions), the factor 1 of z (PrescribedLift), and for τ the moments of
 * tractions, the constant loads and the slope of CellLoad.
 */
struct CellColumns {
  static constexpr unsigned int bubbles = 2 * CellFunctions::n_corners,
                                lift = 2 * CellFunctions::n_functions, moments = lift + 1,
                                loads = moments + CompositeCell::n_moments,
                                slope = moments + CompositeCell::n_data, end = slope + 4;
};
using CellVector = std::array<double, CellColumns::end>;

/** The complementary energy of stresses without loads, bᵀ S b = ‖τ(b)‖². */
using CellEnergy =
  std::array<std::array<double, CompositeCell::n_moments>, CompositeCell::n_moments>;

/** Strains of displacements, and minus stresses, at the quadrature points of a cell. */
struct CellBasis {
  /**
   * Computes the basis.
   * @param rule a rule on the unit simplex, for every part of a triangle.
   * @param parts the parts of triangle k.
   * @param lift is not null if the cell, number @p cell, has one.
   */
  CellBasis(const CellShape &shape, const Quadrature<2> &rule,
            const std::array<std::vector<TrianglePart>, 4> &parts,
            const PrescribedLift *lift = nullptr, unsigned int cell = 0);
  /** Computes the basis on whole triangles. */
  CellBasis(const CellShape &shape, const Quadrature<2> &rule);

  /** A point; on curved cells, its image. */
  struct PointOfCell {
    /** The vector from corner 0. */
    Tensor<1, 2> offset;
    double weight;
    std::array<CellVector, 3> components;
  };
  std::vector<PointOfCell> points;
  /** Points [begin, end) of a part in which the law is not resolved. */
  struct Range {
    std::size_t begin, end;
  };
  std::vector<Range> unresolved;

private:
  void add_point(const CellShape &shape, const CompositeCell &composite, unsigned int triangle,
                 const Tensor<1, 2> &offset, double weight);
};

/** A matrix A with ‖σ(u_h + b + z) - τ‖² = |A v|² for the v of CellColumns. */
class CellMatrix {
public:
  using Values = std::vector<double>;

  /** Weights the basis with the laws at its points, or with a single one. */
  CellMatrix(const CellBasis &basis, const std::vector<Law> &laws);

  /** Replaces A by as many rows as it has columns, by a singular value decomposition. |A v| loses
   * no digits by that, unlike with the matrix AᵀA. */
  void compress();
  /** Adds columns [begin, end) times @p v to @p y. */
  void add(const CellVector &v, unsigned int begin, unsigned int end, Values &y) const;
  Values zero() const {
    return Values(rows_.size(), 0.);
  }
  /** Returns the products of the columns of the moments with y. */
  CellMoments moments_of(const Values &y) const;
  CellEnergy energy() const;
  /** Returns |y|². With @p from_above, where the law is not resolved, the largest value in a part
   * counts for all of the part. */
  double square(const Values &y, bool from_above) const;
  bool is_resolved() const {
    return unresolved_.empty();
  }
  /** Returns the smallest Law::min_eigenvalue of all points. */
  double min_eigenvalue() const {
    return min_eigenvalue_;
  }

private:
  std::vector<CellVector> rows_;
  std::vector<double> weights_;
  std::vector<CellBasis::Range> unresolved_;
  double min_eigenvalue_;
};

/** The matrices of cells; one for congruent cells, as long as there are few shapes. */
class CellTable {
public:
  /** What congruent cells share. */
  struct Shape {
    std::array<Tensor<1, 2>, 3> edges;
    CellBasis basis;
    OscillationConstants constants;
    /** The matrix, if the law is constant. */
    std::optional<CellMatrix> matrix;
  };

  CellTable(const EdgeMesh &mesh, const Scene<2> &scene, const PrescribedLift &lift);

  /** Returns the matrix of a cell, which @p own may hold. */
  const CellMatrix &matrix(unsigned int cell, std::optional<CellMatrix> &own) const;
  Law law(const Point<2> &x) const {
    return constant_law_ ? *constant_law_ : Law(material_.hooke(x));
  }
  /** Returns whether a cell shares its matrix, the given number of those that are shared. */
  std::optional<unsigned int> shared(const unsigned int cell) const {
    if (constant_law_ && shape_of_[cell] < shapes_.size())
      return shape_of_[cell];
    return {};
  }
  const std::vector<Shape> &shapes() const {
    return shapes_;
  }
  OscillationConstants constants(const unsigned int cell) const {
    return shape_of_[cell] < shapes_.size() ? shapes_[shape_of_[cell]].constants
                                            : OscillationConstants(CellShape(mesh_.cells()[cell]));
  }

private:
  /** Returns the number of the cell's shape, a new one as long as there are few; alone for others.
   */
  unsigned int classify(unsigned int cell);
  CellBasis own_basis(unsigned int cell) const;
  bool varies(unsigned int cell) const;

  static constexpr unsigned int max_shapes = 64, alone = static_cast<unsigned int>(-1);

  /** Rules of the degrees 5, 7 and 11. */
  const QWitherdenVincentSimplex<2> rule_{3}, exact_rule_{4}, lift_rule_{6};
  const EdgeMesh &mesh_;
  const Material<2> &material_;
  const PrescribedLift &lift_;
  std::vector<KinkLine<2>> lines_;
  std::optional<Law> constant_law_;
  std::optional<LawSampling> sampling_;
  std::vector<Shape> shapes_;
  std::vector<unsigned int> shape_of_;
};

/** The matrices S of all cells. */
class CellEnergies {
public:
  CellEnergies(const CellTable &table, std::size_t n_cells);
  CellEnergy &operator()(const unsigned int cell) {
    return matrices_[index_[cell]];
  }
  const CellEnergy &operator()(const unsigned int cell) const {
    return matrices_[index_[cell]];
  }
  /** Returns the number of a cell's matrix. */
  unsigned int number(const unsigned int cell) const {
    return index_[cell];
  }
  /** Returns whether other cells may have the same matrix; it is known from the beginning. */
  bool is_shared(const unsigned int cell) const {
    return index_[cell] < n_shared_;
  }

private:
  unsigned int n_shared_;
  std::vector<unsigned int> index_;
  std::vector<CellEnergy> matrices_;
};

/** Returns S b. */
CellMoments multiply(const CellEnergy &S, const CellMoments &b);
} // namespace Signorini
