// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/methods/solver_choice.h>

#include <mpi.h>

#include <string>

namespace Signorini {
/**
 * Refuses levels that cannot fit into memory before hours of work end in the kernel's out-of-memory
 * killer, which leaves no message. Compares a low estimate for a direct factorisation and for the
 * dense matrices on the contact boundary with the memory that this process may have: that of the
 * machine, or less where RLIMIT_AS or a control group limits it. The ranks on a machine share it,
 * and each has its part of a shared level. V-cycles are held against an estimate without a factor.
 */
template <int dim>
class MemoryLimit {
public:
  /**
   * Checks the finest level. With a target error the finest level need not be reached, so the
   * coarsest is checked. Allocates no more than the coarse mesh, if that fits.
   * @throws InputError with the estimated need.
   */
  MemoryLimit(const Parameters &parameters, const Scene<dim> &scene, MPI_Comm communicator);

  /** Returns the size of the level that is checked, a low estimate of the memory that it needs, and
   * the memory of the machine: "level 6 has 4096 cells and 32 patches, which need more than 0.1 GiB
   * of 23 GiB". */
  std::string forecast() const {
    return describe(judged_) + " of " + describe_available();
  }
  /** Returns about how many unknowns that level has. */
  double n_unknowns() const {
    return dim * n_nodes(judged_);
  }
  /** Checks that a level fits. @throws ComputationError if it does not. */
  void check(unsigned int level) const;

private:
  /** The numbers of cells and of contact faces on level 0. */
  double n_coarse_cells_;
  double n_coarse_contact_faces_ = 0.;
  double n_given_patches_;
  /** The unknowns of a patch. */
  double n_components_;
  const Parameters &parameters_;
  const Scene<dim> &scene_;
  unsigned int n_ranks_;
  /** The level that is checked first. */
  unsigned int judged_;
  /** The solvers, and whether the factor holds the dense Schur complement of the contact unknowns.
   */
  SolverChoice solvers_;
  bool condensed_;
  double available_;

  double n_cells(unsigned int level) const;
  /** Returns about how many nodes a level has: those of 2^dim cells of degree one for every cell of
   * degree two. */
  double n_nodes(unsigned int level) const;
  double n_contact_faces(unsigned int level) const;
  double n_patches(unsigned int level) const;
  double needed(unsigned int level) const;
  /** Returns "level 14 has 1e9 cells and 16384 patches, which need more than 12 GiB". */
  std::string describe(unsigned int level) const;
  std::string describe_available() const;
};
} // namespace Signorini
