// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/motions/motion_modes.h>

#include <string>

namespace Signorini
{
/** "it slides", "it tips over" or "it lifts off": what a body does that nothing stops. */
std::string word_for_escape(const RigidMotion &motion, bool opens);

/** The rigid motion of a body in a combination of modes. */
RigidMotion rigid_part(const MotionModes<2> &modes, const dealii::Vector<double> &v);

/** Whether the motion v leaves contact somewhere; otherwise it slides. */
bool opens(const dealii::FullMatrix<double> &B, const dealii::Vector<double> &v);
} // namespace Signorini
