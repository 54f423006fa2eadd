// SPDX-License-Identifier: LGPL-2.1-or-later
// Why contact cannot hold a body.

#include "escape_message.h"

#include <signorini/base/errors.h>
#include <signorini/discretization/elasticity/traces.h>
#include <signorini/solvers/kinematics/motion_modes.h>
#include <signorini/solvers/kinematics/seen_motions.h>

#include <algorithm>

namespace Signorini
{
namespace
{
/** z_j.n at the ends of all pieces of the contact boundary. */
dealii::FullMatrix<double> closing_of_points(const Discretization<2> &discretization,
                                             const MotionModes<2> &modes)
{
  const ContactSurface<2> &surface = discretization.surface;
  const std::vector<dealii::Point<1>> ends = {dealii::Point<1>(0.), dealii::Point<1>(1.)};
  TraceValues<2> traces(discretization.space);
  dealii::FullMatrix<double> closing(ends.size() * surface.pieces().size(), modes.size());
  for (std::size_t i = 0; i < surface.pieces().size(); ++i)
  {
    const Piece<2> &piece = surface.pieces()[i];
    const SurfaceRule<2> rule = surface.at(piece, ends);
    for (unsigned int j = 0; j < modes.size(); ++j)
    {
      const std::vector<double> z_n =
        traces.normal_displacement(surface.faces()[piece.face], rule, modes.Z[j]);
      for (std::size_t e = 0; e < ends.size(); ++e)
        closing(ends.size() * i + e, j) = z_n[e];
    }
  }
  return closing;
}

/** Of K; one without resistance. */
double typical_stiffness(const FreeMotions &motions)
{
  double stiffness = 0.;
  for (unsigned int j = 0; j < motions.K.m(); ++j)
    stiffness = std::max(stiffness, motions.K(j, j));
  return stiffness > 0. ? stiffness : 1.;
}

/** Whether forces at points of the contact boundary balance the loads. */
bool points_balance(const Discretization<2> &discretization,
                    const MotionModes<2> &modes,
                    const FreeMotions &motions)
{
  FreeMotions of_points = motions;
  of_points.B = closing_of_points(discretization, modes);
  return !SeenMotions(of_points, of_points.B.m(), typical_stiffness(motions)).escape;
}
} // namespace

void refuse_sliding(const Parameters &parameters, const RigidMotion &motion)
{
  throw InputError(parameters.boundary.where + ": the loads drive " + motion.name() +
                   " of the body, along which contact sides slide without friction; allowed: "
                   "loads in balance, or more sides that hold the body.");
}

void refuse_undetermined(const Parameters &parameters,
                         const MotionModes<2> &modes,
                         const FreeMotions &motions,
                         const dealii::Vector<double> &P)
{
  if (!motions.b.all_zero())
    return;
  FreeMotions of_pressing = motions;
  for (unsigned int i = 0; i < P.size(); ++i)
    for (unsigned int j = 0; j < modes.size() && P[i] == 0.; ++j)
      of_pressing.B(i, j) = 0.;
  const auto unseen = SeenMotions(of_pressing, P.size(), typical_stiffness(motions)).unseen;
  if (!unseen.empty())
    throw InputError(parameters.boundary.where +
                     ": the loads are zero, and the pressure of the "
                     "foundation, into which the body begins, leaves " +
                     rigid_part(modes, unseen.front()).name() +
                     " free; allowed: loads that press the body onto the foundation, or more sides "
                     "that hold it.");
}

void refuse_escape(const Parameters &parameters,
                   const Discretization<2> &discretization,
                   const MotionModes<2> &modes,
                   const FreeMotions &motions,
                   const dealii::Vector<double> &v)
{
  const RigidMotion motion = rigid_part(modes, v);
  if (points_balance(discretization, modes, motions))
  {
    const Given<unsigned int> &coarsest = parameters.discretization.coarsest_level;
    throw InputError(coarsest.where() + ": found '" + std::to_string(coarsest.value) +
                     "', where a contact patch carries forces in its middle only and the loads "
                     "act closer to the end of contact (the body would move " +
                     motion.direction() + "), allowed: a finer coarsest level.");
  }
  throw InputError(parameters.boundary.where + ": the loads move the body " + motion.direction() +
                   ", and no pressure of the foundation balances them (" +
                   word_for_escape(motion, opens(motions.B, v)) +
                   "); allowed: loads that press it onto the foundation, or more sides that hold "
                   "it.");
}
} // namespace Signorini
