// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/bound/cell_loads.h>
#include <signorini/bound/patch_bubbles.h>

#include <memory>
#include <vector>

namespace Signorini
{
/** What determines sigma(u_h) - tau on a parallelogram with a constant law. */
struct CellMisfit
{
  /** u_h at the corners, relative to one of them. */
  std::array<dealii::Tensor<1, 2>, 4> u;
  /** tau without the part of CellLoad::slope. */
  CompositeCell::Stresses stresses;
  std::array<double, 4> slope;
};

/**
 * ‖sigma(u_h + b) - tau‖² - ‖sigma(u_h) - tau‖² = 2 int eps(b):(sigma(u_h) - tau) + |||b|||² on a
 * parallelogram with a constant law, as a form in the ten components of b. Exact: the products have
 * the degree six, the rule ten.
 */
class BubbleForm
{
public:
  BubbleForm(const CellShape &shape, const Law &law);

  double change(const PatchBubbles::Coefficients &b, const CellMisfit &misfit) const;
  /** int eps(b) psi: minus half of the derivative of change() by the stresses. */
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

  /** None where the cell is no parallelogram, shares CellData with no other or the law varies. */
  const BubbleForm *of(unsigned int cell) const;

private:
  const CellTable &table_;
  /** By shape. */
  std::vector<std::unique_ptr<const BubbleForm>> forms_;
};
} // namespace Signorini
