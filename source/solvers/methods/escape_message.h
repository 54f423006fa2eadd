// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/level/discretization.h>
#include <signorini/solvers/kinematics/free_motions.h>
#include <signorini/solvers/kinematics/motion_modes.h>

namespace Signorini
{
/**
 * Tells which motion of the body nothing stops. Constants of patches carry forces between the
 * middles of patches only: where pressures at points of the contact boundary would balance the
 * loads, the mesh is too coarse, and the message says that. @param v MotionResult::escape.
 * @throws InputError always.
 */
[[noreturn]] void refuse_escape(const Parameters &parameters,
                                const Discretization<2> &discretization,
                                const MotionModes<2> &modes,
                                const FreeMotions &motions,
                                const dealii::Vector<double> &v);

/** Tells that loads drive a motion along which contact sides slide. @throws InputError always. */
[[noreturn]] void refuse_sliding(const Parameters &parameters, const RigidMotion &motion);

/** Tells which motion of the body is left free by the patches that press, where no load decides it
 * and only a negative gap presses. @throws InputError if there is such a motion. */
void refuse_undetermined(const Parameters &parameters,
                         const MotionModes<2> &modes,
                         const FreeMotions &motions,
                         const dealii::Vector<double> &P);
} // namespace Signorini
