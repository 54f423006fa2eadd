// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>
#include <signorini/multiplier/multiplier_space.h>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace Signorini
{
/** What is known at one point of the contact boundary. */
template <int dim>
struct ContactPoint
{
  std::string side;
  /** Arc length along the side. */
  double s;
  dealii::Point<dim> x;
  double p_H;
  double p_recovered;
  double u_n;
  double g;
  std::optional<double> p_exact;
};

/** The ends and the middle of a piece face ∩ patch. */
template <int dim>
struct ContactSegment
{
  ContactPoint<dim> start, middle, end;
};

/** The contact boundary piece by piece, side after side, in the order of arc length. */
template <int dim>
std::vector<ContactSegment<dim>> trace_contact_line(const DisplacementSpace<dim> &space,
                                                    const MultiplierSpace<dim> &multipliers,
                                                    const NodalVector &U,
                                                    const dealii::Vector<double> &P);

/** contact-LL.csv: one row per middle of a piece. */
template <int dim>
void write_contact_csv(std::ostream &stream, const std::vector<ContactSegment<dim>> &line);

/** contact-LL.vtu: pressure, gap and opening along the contact boundary. */
template <int dim>
void write_contact_vtu(std::ostream &stream, const std::vector<ContactSegment<dim>> &line);
} // namespace Signorini
