// SPDX-License-Identifier: LGPL-2.1-or-later
// The square of the misfit of pi^{2h} u_h, cell by cell.

#include <signorini/bound/bubble_form.h>
#include <signorini/bound/pointwise.h>

namespace Signorini
{
namespace
{
/** The strain of a function with the given gradient in one component. */
Components strain_of_component(const dealii::Tensor<1, 2> &gradient, const unsigned int component)
{
  return component == 0 ? Components{{gradient[0], 0., gradient[1]}}
                        : Components{{0., gradient[1], gradient[0]}};
}
} // namespace

BubbleForm::BubbleForm(const CellShape &shape, const Law &law)
{
  RuleKind kind = {true, false};
  kind.fine = true;
  for (const StressPoint &point : make_rule(shape, kind, {}))
  {
    const BubbleGradients gradients = bubble_gradients(point);
    std::array<Components, n_bubbles> strains;
    for (unsigned int i = 0; i < n_bubbles; ++i)
      strains[i] = strain_of_component(gradients[i / 2], i % 2);
    std::array<Components, 4> of_slopes;
    for (unsigned int q = 0; q < 4; ++q)
    {
      CellLoad load;
      load.slope[q] = 1.;
      of_slopes[q] = load.stress(shape, point.reference);
    }
    for (unsigned int i = 0; i < n_bubbles; ++i)
    {
      const Components &e = strains[i], s = law.stress(e);
      auto &row = rows_[i];
      for (unsigned int a = 0; a < first_stress; ++a)
        row[a] +=
          2. * point.weight * contraction(s, strain_of_component(point.gradients[a / 2], a % 2));
      for (unsigned int m = 0; m < 3; ++m)
        for (unsigned int l = 0; l < 3; ++l)
          row[first_stress + 9 * point.triangle + 3 * m + l] -=
            2. * point.weight * e[l] * point.psi[m];
      for (unsigned int q = 0; q < 4; ++q)
        row[first_slope + q] -= 2. * point.weight * contraction(e, of_slopes[q]);
      for (unsigned int j = 0; j < n_bubbles; ++j)
        row[first_bubble + j] += point.weight * contraction(s, strains[j]);
    }
  }
}

double BubbleForm::change(const PatchBubbles::Coefficients &b, const CellMisfit &misfit) const
{
  std::array<double, n_columns> values;
  for (unsigned int a = 0; a < first_stress; ++a)
    values[a] = misfit.u[a / 2][a % 2];
  std::copy(misfit.stresses.begin(), misfit.stresses.end(), values.begin() + first_stress);
  std::copy(misfit.slope.begin(), misfit.slope.end(), values.begin() + first_slope);
  for (unsigned int i = 0; i < n_bubbles; ++i)
    values[first_bubble + i] = b[i / 2][i % 2];
  double sum = 0.;
  for (unsigned int i = 0; i < n_bubbles; ++i)
  {
    double product = 0.;
    for (unsigned int j = 0; j < n_columns; ++j)
      product += rows_[i][j] * values[j];
    sum += values[first_bubble + i] * product;
  }
  return sum;
}

CompositeCell::Stresses BubbleForm::dual(const PatchBubbles::Coefficients &b) const
{
  CompositeCell::Stresses sum{};
  for (unsigned int i = 0; i < n_bubbles; ++i)
    for (unsigned int j = 0; j < sum.size(); ++j)
      sum[j] -= 0.5 * b[i / 2][i % 2] * rows_[i][first_stress + j];
  return sum;
}

BubbleForms::BubbleForms(const CellTable &table)
  : table_(table)
{
  if (!table.constant_law())
    return;
  for (unsigned int shape = 0; shape < table.n_shapes(); ++shape)
  {
    const CellShape &cell = table.shared(shape).shape;
    forms_.push_back(
      cell.affine ? std::make_unique<const BubbleForm>(cell, table.law(cell.corners[0])) : nullptr);
  }
}

const BubbleForm *BubbleForms::of(const unsigned int cell) const
{
  const unsigned int shape = table_.shape_of(cell);
  return shape < forms_.size() ? forms_[shape].get() : nullptr;
}
} // namespace Signorini
