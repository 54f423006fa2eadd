// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/methods/contact_method.h>

#include <mpi.h>

namespace Signorini
{
/**
 * Refuses levels that cannot fit into memory before hours of work end in the kernel's out-of-memory
 * killer, which leaves no message. Compares a low estimate for a direct factorisation and for the
 * dense matrices on the contact boundary with the memory that this process may have: that of the
 * machine, or less where RLIMIT_AS or a control group says so. An iterative solver needs an
 * estimate of its own.
 */
template <int dim>
class MemoryLimit
{
public:
  /**
   * Judges the finest level; with a target error, where that is a limit that need not be reached,
   * the coarsest. Allocates no more than the coarse mesh, if that fits.
   * @throws InputError with the estimated need.
   */
  MemoryLimit(const Parameters &parameters, const Scene<dim> &scene, MPI_Comm communicator);

  /** @throws ComputationError if the level does not fit. */
  void check(unsigned int level) const;

private:
  /** On level 0. */
  double n_coarse_cells_;
  double n_coarse_contact_faces_ = 0.;
  double n_contact_sides_;
  const DiscretizationParameters &given_;
  /** Whether the factor holds the dense Schur complement of the contact unknowns. */
  SolverChoice solvers_;
  bool condensed_;
  double available_;

  double n_cells(unsigned int level) const;
  double n_contact_faces(unsigned int level) const;
  double n_patches(unsigned int level) const;
  double needed(unsigned int level) const;
  /** "level 14 makes 1e9 cells and 16384 contact patches, which need more than 12 GiB". */
  std::string describe(unsigned int level) const;
  std::string describe_available() const;
};
} // namespace Signorini
