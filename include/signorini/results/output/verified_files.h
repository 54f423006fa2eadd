// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/error_control/verify/verification.h>
#include <signorini/results/verdict/level_record.h>

#include <ostream>
#include <string>

namespace Signorini {
/** A displacement of another program with its verification by a run. All of it must outlive the
 * object. */
struct VerifiedField {
  /** The name of the file. */
  std::string name;
  const ForeignField &field;
  const Verification &found;
  /** The scene, and the level with which v was compared. */
  const Scene<2> &scene;
  const LevelRecord &level;

  /** Returns |||v - u||| as a share of |||u|||; the quotient's margin, too. */
  WithMargin relative() const;
  /** Returns the force of v on all contact sides that the contact force of the answer counts. */
  Tensor<1, 2> contact_force(Tensor<1, 2> VerifiedSide::*part = &VerifiedSide::force) const;
  /** Returns why the error may be larger than a tolerated share of |||u|||. */
  std::string objection(double tolerated) const;
};

/** Prints the certificate in lines. */
void print_verified(std::ostream &stream, const VerifiedField &verified);

/** Writes verified.json: the certificate with all digits. */
void write_verified_json(std::ostream &stream, const VerifiedField &verified);

/** Writes verified.vtu: the cells with |||v - u_h|||_K, v, and v - u_h at their nodes. */
void write_verified_vtu(std::ostream &stream, const VerifiedField &verified);
} // namespace Signorini
