// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/error_control/loads/law_sampling.h>
#include <signorini/error_control/loads/prescribed_lift.h>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace Signorini
{
/** The data of a cell that stresses need. They are the same for all cells of its shape. */
struct CellData
{
  CellData(const CellShape &shape,
           const RuleKind &kind,
           const std::vector<KinkLine<2>> &lines,
           const TriangleDivision &divide = {})
    : shape(shape)
    , composite(shape)
    , points(make_rule(shape, kind, lines, divide))
    , on_edges(edge_points(shape))
  {
  }
  CellShape shape;
  CompositeCell composite;
  std::vector<StressPoint> points;
  /** Two Gauss points on every edge. */
  std::array<std::array<EdgePoint, 2>, 4> on_edges;
};

/** Scratch data for cells that share CellData with no other; every thread needs its own. */
struct CellRoom
{
  std::unique_ptr<CellData> data;
  std::vector<Law> laws;
};

/** The complementary energy of stresses without loads, bᵀ S b = ‖τ(b)‖², row by row. */
using CellEnergy = std::array<double, CompositeCell::n_moments * CompositeCell::n_moments>;

/** Makes CellData, once for congruent cells as long as there are few shapes, and Hooke's laws at
 * their points. */
class CellTable
{
public:
  /**
   * Classifies the cells by shape.
   * @param quadratic whether stresses have quadratic parts.
   * @param lift makes displacements more than bilinear on some cells.
   */
  CellTable(const EdgeMesh &mesh,
            const Scene<2> &scene,
            bool quadratic,
            const PrescribedLift &lift);

  /** Returns the data of cell number @p cell; valid until the next call with the same @p room. */
  const CellData &data(unsigned int cell, CellRoom &room) const;
  /** Returns two Gauss points on every edge of a cell. */
  std::array<std::array<EdgePoint, 2>, 4> on_edges(const unsigned int cell) const
  {
    return shape_of_[cell] < most_shapes ? shared_[shape_of_[cell]]->on_edges
                                         : edge_points(CellShape(mesh_.cells()[cell].corners));
  }
  /** Returns the laws at the points of a cell, valid until the next call with the same @p room.
   * Where Hooke's tensor is constant, one law holds at all points. */
  const std::vector<Law> &laws(unsigned int cell, const CellData &data, CellRoom &room) const;

  /** Returns the law at a point. */
  Law law(const dealii::Point<2> &x) const
  {
    return kind_.constant_law ? law_[0] : Law(material_.hooke(x));
  }

  bool constant_law() const
  {
    return kind_.constant_law;
  }
  /** Returns the number of the cell's shape. Cells with the same number have the same CellData. The
   * number is not below n_shapes() for cells that share CellData with no other cell. */
  unsigned int shape_of(const unsigned int cell) const
  {
    return shape_of_[cell];
  }
  unsigned int n_shapes() const
  {
    return shared_.size();
  }
  const CellData &shared(const unsigned int shape) const
  {
    return *shared_[shape];
  }

private:
  /** Returns the number of the cell's shape among the shared ones; a new one as long as there are
   * fewer than most_shapes. */
  unsigned int classify(unsigned int cell);

  /** The number of shapes beyond which cells are computed one by one. */
  static constexpr std::size_t most_shapes = 64;

  const EdgeMesh &mesh_;
  const Material<2> &material_;
  std::vector<KinkLine<2>> lines_;
  RuleKind kind_;
  /** The samples of the law, if it varies. */
  std::optional<LawSampling> sampling_;
  /** Whether the law varies much in a cell; empty where the law is constant. */
  std::vector<bool> varied_;
  const PrescribedLift &lift_;
  std::vector<std::array<dealii::Tensor<1, 2>, 3>> edges_of_shape_;
  std::vector<std::unique_ptr<CellData>> shared_;
  std::vector<unsigned int> shape_of_;
  /** The law, if it is constant. */
  std::vector<Law> law_;
};

CellEnergy make_energy(const CellData &data, const std::vector<Law> &laws);
} // namespace Signorini
