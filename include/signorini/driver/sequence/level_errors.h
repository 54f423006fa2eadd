// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/sequence/reference_run.h>
#include <signorini/driver/sequence/sequence.h>

#include <map>
#include <optional>
#include <vector>

namespace Signorini {
/**
 * The errors of all nested levels of a 2-D body, from the stress of one graded run of the same
 * scene (ReferenceStress). The run starts when the first level asks for its error, and aims at
 * three digits of it. Bodies in space and of revolution have none.
 */
template <int dim>
class LevelErrors {
public:
  explicit LevelErrors(const StudyContext<dim> &context)
    : context_(context) {
    if (!context_.references)
      context_.references = std::make_shared<ReferenceRuns>();
  }

  /** Keeps the works of a level, which may be solved and added again. Collective. */
  void add(const Discretization<dim> &discretization, const LevelSolution<dim> &solution);
  /** Returns whether the error of the last level is known to a third at least. Makes the graded run
   * first, if that is still to be done. */
  bool know_last(const LevelRecord &record, const Progress &progress);
  /** Returns the stress of the run. */
  const std::optional<ReferenceStress> &stress() const {
    return run_->stress;
  }
  /** Returns the errors of all levels by their numbers, after know_last() has made the run. */
  std::map<unsigned int, ErrorBound> all() const;

private:
  /** A level, as far as its error needs it. */
  struct Level {
    std::vector<FieldWorks> works;
    /** The penetration, without errors. */
    ErrorBound bound;
    EnergyScale scale;
    /** ∫ p_H over Γ_c. */
    double contact_force;
  };

  bool are_wanted() const;
  /** Returns the works of a level. Those of a fine one are its own sums; their rest of quadrature
   * is that of the last coarser level, where both were computed, since it falls with h. */
  std::vector<FieldWorks> works_of_level(const Solved<2> &solved, const Energies &energies,
                                         const LevelRecord &record);
  ErrorBound error_of(const Level &level) const;

  StudyContext<dim> context_;
  std::map<unsigned int, Level> levels_;
  /** The rests of the quadrature of a level's own sums, relative to |||v|||², by field. */
  std::vector<double> rests_;
  /** The graded run; null before it is made. */
  const ReferenceRun *run_ = nullptr;
};
} // namespace Signorini
