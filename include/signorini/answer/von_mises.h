// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/answer/answer_vector.h>
#include <signorini/elasticity/displacement_space.h>

namespace Signorini
{
/** The largest von Mises stress (force/area). */
struct VonMises
{
  double value = 0.;
  AnswerVector point;
  /** The share of the body (area, volume) in cells with a principal strain above large_strain in
   * their middle. */
  double strained_share = 0.;
};

/** Theories of small strains err by about as much as the strain. */
constexpr double large_strain = 0.1;

/**
 * Of pi^{2h} u_h, or of u_h on a mesh without T^{2h}, at the corners and the middle of every cell.
 * With mean dilatation the trace of the strain is mean_dilatations(). Points at which the
 * material's data has no value are left out. Collective.
 */
template <int dim>
VonMises largest_von_mises(const DisplacementSpace<dim> &space,
                           const Scene<dim> &scene,
                           const NodalVector &U);
} // namespace Signorini
