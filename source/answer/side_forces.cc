// SPDX-License-Identifier: LGPL-2.1-or-later
// The force of the contact pressure, and lines of action.

#include <signorini/answer/side_forces.h>

#include <cmath>

namespace Signorini
{
namespace
{
/** By how much a moment moves the line of action of F: F × M / |F|². */
dealii::Tensor<1, 2> shift(const dealii::Tensor<1, 2> &F, const Moment<2> &moment)
{
  return moment[0] / F.norm_square() * dealii::Tensor<1, 2>({F[1], -F[0]});
}
dealii::Tensor<1, 3> shift(const dealii::Tensor<1, 3> &F, const Moment<3> &moment)
{
  return dealii::cross_product_3d(F, moment) / F.norm_square();
}
} // namespace

template <int dim>
std::vector<SideForce> contact_forces(const MultiplierSpace<dim> &multipliers,
                                      const Scene<dim> &scene,
                                      const dealii::Vector<double> &P)
{
  std::vector<SideForce> forces;
  const ContactSurface<dim> &surface = multipliers.surface();
  for (const unsigned int side : scene.contact_sides())
  {
    Resultant<dim> resultant;
    std::optional<AnswerVector> through;
    double total = 0.;
    dealii::Tensor<1, dim> centre;
    for (const Piece<dim> &piece : surface.pieces())
      if (surface.patches()[piece.patch].side == side)
      {
        resultant += contact_resultant(multipliers, P, piece);
        const SurfaceRule<dim> &rule = piece.on_mesh;
        for (std::size_t q = 0; q < rule.size(); ++q)
        {
          const double share = multipliers.value(P, piece.patch, rule.on_side[q]) * rule.weights[q];
          total += share;
          centre += share * rule.points[q];
        }
      }
    if (total != 0.)
      through = point_of_action(resultant, dealii::Point<dim>(centre / total), std::abs(total));
    forces.push_back(
      {scene.geometry.sides[side].name(), {resultant.force, resultant.moment}, through});
  }
  return forces;
}

template <int dim>
std::optional<dealii::Point<dim>> point_of_action(const Resultant<dim> &resultant,
                                                  const dealii::Point<dim> &centre,
                                                  const double scale)
{
  constexpr double negligible = 1e-10;
  const dealii::Tensor<1, dim> &F = resultant.force;
  if (!(F.norm() > negligible * scale))
    return {};
  // x = centre + t (F2, -F1) has the moment centre × F + t |F|²; in space F × M / |F|².
  return centre + shift(F, resultant.moment_about(centre));
}

template std::vector<SideForce> contact_forces(const MultiplierSpace<2> &,
                                               const Scene<2> &,
                                               const dealii::Vector<double> &);
template std::optional<dealii::Point<2>> point_of_action(const Resultant<2> &,
                                                         const dealii::Point<2> &,
                                                         double);
template std::vector<SideForce> contact_forces(const MultiplierSpace<3> &,
                                               const Scene<3> &,
                                               const dealii::Vector<double> &);
template std::optional<dealii::Point<3>> point_of_action(const Resultant<3> &,
                                                         const dealii::Point<3> &,
                                                         double);
} // namespace Signorini
