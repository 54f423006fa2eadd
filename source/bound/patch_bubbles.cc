// SPDX-License-Identifier: LGPL-2.1-or-later
// What pi^{2h} u_h has more than u_h.

#include <signorini/bound/patch_bubbles.h>
#include <signorini/postprocess/patch_interpolation.h>

namespace Signorini
{
namespace
{
using Vector2 = dealii::Tensor<1, 2>;

/** The middles of the edges of a cell counter-clockwise, and its centre. */
dealii::Quadrature<2> bubble_points()
{
  return dealii::Quadrature<2>(
    std::vector<dealii::Point<2>>{{0.5, 0.}, {1., 0.5}, {0.5, 1.}, {0., 0.5}, {0.5, 0.5}});
}
} // namespace

PatchBubbles::PatchBubbles(const DisplacementSpace<2> &space,
                           const EdgeMesh &mesh,
                           const NodalVector &U)
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
