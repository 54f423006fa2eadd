// SPDX-License-Identifier: LGPL-2.1-or-later
// A body on separate springs.

#include <signorini/qp/bedding.h>
#include <signorini/qp/small_matrix.h>

#include <algorithm>

namespace Signorini
{
namespace
{
using Vector = dealii::Vector<double>;
using Matrix = dealii::FullMatrix<double>;

Vector pressure_at(const SeenMotions &motions, const Vector &F, const Vector &c, const Vector &z)
{
  Vector P = times(motions.B, z);
  for (unsigned int i = 0; i < P.size(); ++i)
    P[i] = std::min(0., F[i] - P[i]) / c[i];
  return P;
}

double energy_at(const SeenMotions &motions, const Vector &F, const Vector &c, const Vector &z)
{
  const Vector P = pressure_at(motions, F, c, z);
  double energy = 0.5 * (times(motions.K, z) * z) - motions.b * z;
  for (unsigned int i = 0; i < P.size(); ++i)
    energy += 0.5 * c[i] * P[i] * P[i];
  return energy;
}

/** K + sum of B_i B_i^T/c_i, where springs are open only the given part of it. */
Matrix stiffness_at(const SeenMotions &motions, const Vector &c, const Vector &P, const double open)
{
  Matrix H = motions.K;
  for (unsigned int r = 0; r < P.size(); ++r)
    for (unsigned int i = 0; i < H.m(); ++i)
      for (unsigned int j = 0; j < H.m(); ++j)
        H(i, j) += (P[r] < 0. ? 1. : open) / c[r] * motions.B(r, i) * motions.B(r, j);
  return H;
}
} // namespace

MotionState solve_on_bedding(const SeenMotions &motions, const Vector &F, const Vector &c)
{
  // As if all springs pressed.
  Vector load = F;
  for (unsigned int i = 0; i < F.size(); ++i)
    load[i] /= c[i];
  Vector z = transpose_times(motions.B, load);
  z += motions.b;
  z = SmallCholesky(stiffness_at(motions, c, load, 1.)).solve(z);
  Vector P = pressure_at(motions, F, c, z);
  for (unsigned int step = 0; step < 50; ++step)
  {
    const Vector missing = motions.imbalance(P, z);
    Vector direction = SmallCholesky(stiffness_at(motions, c, P, 1e-6)).solve(missing);
    const double slope = direction * missing, before = energy_at(motions, F, c, z);
    unsigned int halvings = 0;
    Vector next = z;
    for (next += direction; halvings < 40 && energy_at(motions, F, c, next) > before - 1e-4 * slope;
         ++halvings)
    {
      direction *= 0.5;
      next = z;
      next += direction;
    }
    if (halvings == 40)
      break;
    z = next;
    P = pressure_at(motions, F, c, z);
    if (missing.l2_norm() <= 1e-9 * std::max(motions.b.l2_norm(), P.l2_norm()))
      break;
  }
  return {P, z};
}
} // namespace Signorini
