// SPDX-License-Identifier: LGPL-2.1-or-later
// What a body does that neither supports nor contact stop.

#include <signorini/motions/escape.h>

namespace Signorini
{
std::string word_for_escape(const RigidMotion &motion, const bool opens)
{
  if (!opens)
    return "it slides";
  return motion.is_translation() ? "it lifts off" : "it tips over";
}

RigidMotion rigid_part(const MotionModes<2> &modes, const dealii::Vector<double> &v)
{
  std::vector<RigidMotion> rigid;
  std::vector<double> weights;
  for (unsigned int j = 0; j < modes.size(); ++j)
    if (modes.motions[j].rigid)
    {
      rigid.push_back(*modes.motions[j].rigid);
      weights.push_back(v[j]);
    }
  return combine(rigid, weights);
}

bool opens(const dealii::FullMatrix<double> &B, const dealii::Vector<double> &v)
{
  constexpr double negligible = 1e-8;
  dealii::Vector<double> opening(B.m());
  B.vmult(opening, v);
  return opening.linfty_norm() > negligible * B.linfty_norm() * v.linfty_norm();
}
} // namespace Signorini
