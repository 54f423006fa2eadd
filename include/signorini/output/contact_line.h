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
/** What is known at one point of the contact boundary of a plane body. */
struct ContactPoint
{
  std::string side;
  /** Arc length along the side. */
  double s;
  dealii::Point<2> x;
  double p_H;
  double p_recovered;
  double u_n;
  double g;
  std::optional<double> p_exact;
};

/** The ends and the middle of a piece face ∩ patch. */
struct ContactSegment
{
  ContactPoint start, middle, end;
};

/** The contact boundary piece by piece, side after side, in the order of arc length. */
std::vector<ContactSegment> trace_contact_line(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const NodalVector &U,
                                               const dealii::Vector<double> &P);

/** contact-LL.csv: one row per middle of a piece. */
void write_contact_csv(std::ostream &stream, const std::vector<ContactSegment> &line);

/** contact-LL.vtu: pressure, gap and opening along the contact boundary. */
void write_contact_vtu(std::ostream &stream, const std::vector<ContactSegment> &line);
} // namespace Signorini
