// SPDX-License-Identifier: LGPL-2.1-or-later
// The square of the misfit of π^{2h} u_h, cell by cell.

#include <signorini/error_control/loads/cell_rule.h>
#include <signorini/error_control/stress/bubbles.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>

namespace Signorini
{
namespace
{
/** Returns the strain of a function with the given gradient in one component. */
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

// The difference between π^{2h} u_h and u_h.

namespace
{
using Vector2 = dealii::Tensor<1, 2>;

/** Returns the middles of the edges of a cell counter-clockwise, and its centre. */
dealii::Quadrature<2> bubble_points()
{
  return dealii::Quadrature<2>(
    std::vector<dealii::Point<2>>{{0.5, 0.}, {1., 0.5}, {0.5, 1.}, {0., 0.5}, {0.5, 0.5}});
}
} // namespace

PatchBubbles::PatchBubbles(const DisplacementSpace<2> &space,
                           const EdgeMesh &mesh,
                           const Displacement &U)
  : mesh_(mesh)
  , edges_(mesh.edges().size())
  , cells_(mesh.cells().size())
{
  PatchInterpolation<2> interpolation(space, bubble_points());
  const double rounding = 1e-13 * U.linfty_norm();
  unsigned int number = 0;
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    const std::vector<Vector2> &values = interpolation.values(U, cell);
    const EdgeCell &here = mesh.cells()[number];
    std::array<Vector2, 4> u;
    for (unsigned int a = 0; a < 4; ++a)
      for (unsigned int c = 0; c < 2; ++c)
        u[a][c] = U[mesh.dofs()[here.vertices[a]][c]];
    Vector2 in_centre = values[4] - 0.25 * (u[0] + u[1] + u[2] + u[3]);
    for (unsigned int k = 0; k < 4; ++k)
    {
      const Vector2 in_middle = values[k] - 0.5 * (u[k] + u[(k + 1) % 4]);
      in_centre -= 0.5 * in_middle;
      const Edge &edge = mesh.edges()[here.edges[k]];
      const bool is_held = edge.side != Edge::no_side && edge.freedom == EdgeFreedom::any;
      if (!is_held)
        edges_[here.edges[k]] = in_middle;
      else if (in_middle.norm() > rounding)
        held_[number][k] = in_middle;
    }
    cells_[number++] = in_centre;
  }
}

BubbleGradients bubble_gradients(const StressPoint &point)
{
  constexpr std::array<double, 4> corner_x = {{-1., 1., 1., -1.}};
  constexpr std::array<double, 4> corner_y = {{-1., -1., 1., 1.}};
  const double x = point.reference[0], y = point.reference[1];
  Vector2 d_x, d_y;
  for (unsigned int c = 0; c < 4; ++c)
  {
    d_x += corner_x[c] * point.gradients[c];
    d_y += corner_y[c] * point.gradients[c];
  }
  // With x in [-1,1], 4 s (1 - s) = 1 - x².
  const double bubble_x = 1. - x * x, bubble_y = 1. - y * y;
  return {{-x * (1. - y) * d_x - 0.5 * bubble_x * d_y,
           0.5 * bubble_y * d_x - y * (1. + x) * d_y,
           -x * (1. + y) * d_x + 0.5 * bubble_x * d_y,
           -0.5 * bubble_y * d_x - y * (1. - x) * d_y,
           -2. * x * bubble_y * d_x - 2. * y * bubble_x * d_y}};
}

Components strain_of(const BubbleGradients &gradients,
                     const PatchBubbles::Coefficients &coefficients)
{
  Components e{};
  for (unsigned int j = 0; j < 5; ++j)
  {
    e[0] += gradients[j][0] * coefficients[j][0];
    e[1] += gradients[j][1] * coefficients[j][1];
    e[2] += gradients[j][1] * coefficients[j][0] + gradients[j][0] * coefficients[j][1];
  }
  return e;
}
} // namespace Signorini
