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

const BubbleForm *BubbleForms::of(const unsigned int cell,
                                  const CellTable &table,
                                  const CellData &data)
{
  const unsigned int shape = table.shape_of(cell);
  if (!table.constant_law() || !data.shape.affine)
    return nullptr;
  if (shape >= table.n_shapes())
  {
    single_ = std::make_unique<const BubbleForm>(data.shape, table.law(data.shape.corners[0]));
    return single_.get();
  }
  if (forms_.empty())
    forms_.resize(table.n_shapes());
  if (!forms_[shape])
    forms_[shape] =
      std::make_unique<const BubbleForm>(data.shape, table.law(data.shape.corners[0]));
  return forms_[shape].get();
}
} // namespace Signorini
