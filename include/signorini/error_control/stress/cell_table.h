// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/loads/cell_loads.h>
#include <signorini/error_control/loads/edge_mesh.h>
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
struct CellScratch
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
  const CellData &data(unsigned int cell, CellScratch &room) const;
  /** Returns two Gauss points on every edge of a cell. */
  std::array<std::array<EdgePoint, 2>, 4> on_edges(const unsigned int cell) const
  {
    return shape_of_[cell] < max_shapes ? shared_[shape_of_[cell]]->on_edges
                                        : edge_points(CellShape(mesh_.cells()[cell].corners));
  }
  /** Returns the laws at the points of a cell, valid until the next call with the same @p room.
   * Where Hooke's tensor is constant, one law holds at all points. */
  const std::vector<Law> &laws(unsigned int cell, const CellData &data, CellScratch &room) const;

  /** Returns the law at a point. */
  Law law(const Point<2> &x) const
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
   * fewer than max_shapes. */
  unsigned int classify(unsigned int cell);

  /** The number of shapes beyond which cells are computed one by one. */
  static constexpr std::size_t max_shapes = 64;

  const EdgeMesh &mesh_;
  const Material<2> &material_;
  std::vector<KinkLine<2>> lines_;
  RuleKind kind_;
  /** The samples of the law, if it varies. */
  std::optional<LawSampling> sampling_;
  /** Whether the law varies much in a cell; empty where the law is constant. */
  std::vector<bool> varied_;
  const PrescribedLift &lift_;
  std::vector<std::array<Tensor<1, 2>, 3>> edges_of_shape_;
  std::vector<std::unique_ptr<CellData>> shared_;
  std::vector<unsigned int> shape_of_;
  /** The law, if it is constant. */
  std::vector<Law> law_;
};

CellEnergy make_energy(const CellData &data, const std::vector<Law> &laws);

/**
 * The difference b = π^{2h} u_h - u_h on the cells of T^h, in the reference coordinates of each
 * cell.
 *
 * b vanishes at nodes and is of degree two per direction. So it is
 *
 *     Σ_k m_k 4 s_k (1 - s_k) (1 - d_k) + c 16 s_0 (1 - s_0) s_1 (1 - s_1),
 *
 * with s_k the position along edge k and d_k the depth behind it, both in [0,1]; m_k is the value
 * of b in the middle of the edge, the same from both of its cells.
 *
 * On edges with prescribed displacements m_k is held back: there π^{2h} u_h is not u_D, either,
 * and PrescribedLift makes up for u_D - u_h.
 */
class PatchBubbles
{
public:
  /** The coefficients m_k of the four edges of an EdgeCell, 0 where m_k is held back, then c. */
  using Coefficients = std::array<Tensor<1, 2>, 5>;

  /** Interpolates u_h. Needs Mesh::has_parents(). */
  PatchBubbles(const DisplacementSpace<2> &space, const EdgeMesh &mesh, const Displacement &U);

  Coefficients on(const unsigned int cell) const
  {
    const auto &edges = mesh_.cells()[cell].edges;
    return {{edges_[edges[0]], edges_[edges[1]], edges_[edges[2]], edges_[edges[3]], cells_[cell]}};
  }
  /** Returns whether the cell has an edge with m_k != 0 that is held back. */
  bool holds_back(const unsigned int cell) const
  {
    return !held_.empty() && held_.find(cell) != held_.end();
  }
  /** Returns the coefficients that are held back on such a cell. */
  const Coefficients &held_back(const unsigned int cell) const
  {
    return held_.at(cell);
  }
  /** Returns b in the middle of an edge, 0 where it is held back. */
  const Tensor<1, 2> &on_edge(const unsigned int edge) const
  {
    return edges_[edge];
  }

private:
  const EdgeMesh &mesh_;
  std::vector<Tensor<1, 2>> edges_, cells_;
  std::map<unsigned int, Coefficients> held_;
};

/** The gradients of the five functions at a point, see PatchBubbles. */
using BubbleGradients = std::array<Tensor<1, 2>, 5>;
BubbleGradients bubble_gradients(const StressPoint &point);

/** Returns the strain (e11, e22, 2 e12) of a sum of the five functions. */
Components strain_of(const BubbleGradients &gradients,
                     const PatchBubbles::Coefficients &coefficients);

/** The data that determine σ(u_h) - τ on a parallelogram with a constant law. */
struct CellMisfit
{
  /** The values of u_h at the corners, relative to one of them. */
  std::array<Tensor<1, 2>, 4> u;
  /** The stress τ without the part of CellLoad::slope. */
  CompositeCell::Stresses stresses;
  std::array<double, 4> slope;
};

/** The form ‖σ(u_h + b) - τ‖² - ‖σ(u_h) - τ‖² = 2 ∫ ε(b):(σ(u_h) - τ) +
 * |||b|||² on a parallelogram with a constant law, in the ten components of b. It is exact: the
 * products have the degree six, the rule ten. */
class BubbleForm
{
public:
  BubbleForm(const CellShape &shape, const Law &law);

  double change(const PatchBubbles::Coefficients &b, const CellMisfit &misfit) const;
  /** Returns ∫ ε(b) ψ, which is minus half of the derivative of change() with respect to the
   * stresses. */
  CompositeCell::Stresses dual(const PatchBubbles::Coefficients &b) const;

private:
  static constexpr unsigned int n_bubbles = 10, first_stress = 8,
                                first_slope = first_stress + CompositeCell::n_stresses,
                                first_bubble = first_slope + 4,
                                n_columns = first_bubble + n_bubbles;
  std::array<std::array<double, n_columns>, n_bubbles> rows_{};
};

/** The forms of cells with a constant law that share CellData. */
class BubbleForms
{
public:
  explicit BubbleForms(const CellTable &table);

  /** Returns the form of a cell; null where the cell is no parallelogram, shares CellData with no
   * other cell, or the law varies. */
  const BubbleForm *of(unsigned int cell) const;

private:
  const CellTable &table_;
  /** The forms, by shape. */
  std::vector<std::unique_ptr<const BubbleForm>> forms_;
};
} // namespace Signorini
