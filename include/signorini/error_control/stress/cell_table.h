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
/** Hooke's law C at a point, in Components. */
struct Law {
  explicit Law(const SymmetricTensor<4, 2> &hooke);

  /** Returns the lower triangular G with G Gᵀ = C. */
  Tensor<2, 3> root() const;

  Tensor<2, 3> stiffness, compliance;
  /** The smallest c with e:C:e ≥ c e:e. */
  double min_eigenvalue;
};

/**
 * The numbers that determine σ(u_h + b + z) - τ on a cell: for τ the moments of tractions, the
 * constant loads and the slope of CellLoad; u_h at the corners, the coefficients of the bubbles b
 * (CellFunctions), and the factor 1 of z (PrescribedLift).
 */
struct CellColumns {
  static constexpr unsigned int loads = CompositeCell::n_moments, slope = CompositeCell::n_data,
                                corners = slope + 4,
                                bubbles = corners + 2 * CellFunctions::n_corners,
                                lift = corners + 2 * CellFunctions::n_functions, end = lift + 1;
};
using CellVector = std::array<double, CellColumns::end>;

/** The complementary energy of stresses without loads, bᵀ S b = ‖τ(b)‖². */
using CellEnergy =
  std::array<std::array<double, CompositeCell::n_moments>, CompositeCell::n_moments>;

/** The square of a norm, and half of its gradient g with respect to the moments: after a change b
 * it is value + 2 g.b + bᵀ S b. */
struct Square {
  double value = 0.;
  CellMoments gradient{};
};

/** The integrals over a cell: the squares of the misfits of u_h + z and of π^{2h} u_h + z', and
 * of the norm of τ, and the energies of z and z'. */
struct CellIntegrals {
  Square stress, misfit, interpolated_part;
  double lift = 0., interpolated_lift = 0., min_eigenvalue = 0.;
  /** Whether the law is resolved. If it is not, squares are taken from above at the end. */
  bool is_resolved = true;
};

/** Quadrature points of a cell. */
class CellPoints {
public:
  /**
   * Computes the points.
   * @param rule a rule on the unit simplex, for every part of a triangle.
   * @param parts the parts of triangle k.
   * @param lift is not null if the cell, number @p cell, has one.
   */
  CellPoints(const CellShape &shape, const Quadrature<2> &rule,
             const std::array<std::vector<TrianglePart>, 4> &parts,
             const PrescribedLift *lift = nullptr, unsigned int cell = 0);
  /** Computes the points on whole triangles. */
  CellPoints(const CellShape &shape, const Quadrature<2> &rule);

  /** Returns the laws at all points of a cell with this shape. */
  std::vector<Law> laws(const Material<2> &material, const Point<2> &corner) const;
  /**
   * Integrates over a cell.
   * @param laws those at all points, or a single one.
   * @param held the factor of z' and the bubbles that π^{2h} u_h has in addition to those of
   * @p data, with the opposite sign.
   * @param from_above where the law is not resolved, the largest value in a part counts for all of
   * the part.
   * @param energy receives S, unless it is null.
   */
  CellIntegrals integrate(const std::vector<Law> &laws, const CellVector &data,
                          const CellVector &held, bool from_above, CellEnergy *energy) const;

private:
  friend class CellMatrix;
  /** A point; on curved cells, its image. */
  struct PointOfCell {
    /** The vector from corner 0, and the place in [0,1]². */
    Tensor<1, 2> offset;
    Point<2> at;
    double weight;
    /** The triangle, and barycentric coordinates in it. */
    unsigned int triangle;
    std::array<double, 3> lambda;
    std::array<Tensor<1, 2>, CellFunctions::n_functions> gradients;
    /** The strain of z. */
    Components lift;

    /** Returns the strain of the functions [begin, end). */
    Components strain(const CellVector &data, unsigned int begin, unsigned int end) const;
  };
  /** Stresses or strains, in the order of CompositeCell. */
  using CornerValues = std::array<double, CompositeCell::n_stresses>;

  void add_point(unsigned int triangle, const Tensor<1, 2> &offset, double weight);
  /** Returns the part of τ that is linear on triangles; stress() τ itself. */
  CornerValues linear_stress(const CellVector &data, const CellLoad &load) const;
  Components stress(const PointOfCell &point, const CornerValues &linear,
                    const CellLoad &load) const;
  CellEnergy energy(const std::vector<Law> &laws) const;

  CellShape shape_;
  CompositeCell composite_;
  std::vector<PointOfCell> points_;
  /** Points [begin, end) of a part in which the law is not resolved. */
  struct Range {
    std::size_t begin, end;
  };
  std::vector<Range> unresolved_;
};

/** An upper triangular matrix R with ‖σ(u_h + b) - τ‖² = |R v|² for the v of CellColumns, for
 * resolved cells without z. Squares of R v lose no digits, unlike with the matrix RᵀR. */
class CellMatrix {
public:
  CellMatrix(const CellPoints &points, const Law &law);

  /** Integrates over a cell, see CellPoints. */
  CellIntegrals integrate(const CellVector &data, const CellVector &held) const;
  CellEnergy energy() const;

private:
  /** Adds columns [begin, end) times @p v to @p y. */
  template <unsigned int begin, unsigned int end>
  void add(const CellVector &v, CellVector &y) const;
  Square square(const CellVector &y) const;

  std::array<CellVector, CellColumns::end> columns_{};
  double min_eigenvalue_;
};

/** The matrices of cells; one for congruent cells, as long as there are few shapes. */
class CellTable {
public:
  /** What congruent cells share. */
  struct Shape {
    std::array<Tensor<1, 2>, 3> edges;
    CellPoints points;
    OscillationConstants constants;
    /** The matrix, if the law is constant. */
    std::optional<CellMatrix> matrix;
  };

  CellTable(const EdgeMesh &mesh, const Scene<2> &scene, const PrescribedLift &lift);

  /** Integrates over a cell, see CellPoints. */
  CellIntegrals integrate(unsigned int cell, const CellVector &data, const CellVector &held,
                          bool from_above, CellEnergy *energy) const;
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
  /** Returns the points of a cell that shares none, or, with @p divide, where the law varies. */
  CellPoints own_points(unsigned int cell, bool divide) const;
  /** Returns whether the law varies in a cell with the given ones at its points. */
  bool varies(unsigned int cell, const std::vector<Law> &laws) const;

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
