// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/level/level.h>
#include <signorini/driver/sequence/reference_run.h>
#include <signorini/results/verdict/judge.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Signorini {
/** The data that all levels of a study share. */
template <int dim>
struct StudyContext {
  const Parameters &parameters;
  const Scene<dim> &scene;
  MPI_Comm communicator;
  const Judge &judge;
  /** Called for every level; empty: no exact solution is known. */
  Verify<dim> verify;
  /** The graded runs that are known; null: none. */
  std::shared_ptr<ReferenceRuns> references = {};
  /** Whether graded steps keep the stresses of their bounds. */
  bool keeps_stress = false;
};

/** The meshes of a study, one after the other, each started from the solution on the one before. */
template <int dim>
class Sequence {
public:
  virtual ~Sequence() = default;

  /** Returns the name of the next level for the user to watch: "level 3". */
  virtual std::string name_of_next() const = 0;
  /** Returns the scene as this sequence integrates it. */
  virtual const Scene<dim> &scene() const = 0;
  /** Solves on the next mesh. The result shares its large objects with the sequence until the next
   * call at most. @throws ComputationError */
  virtual LevelResult<dim> solve_next(const Progress &progress) = 0;
};

/** Makes the sequence T^h, T^{h/2}, ... from Coarsest level to Finest level, or until the target
 * error is reached.
 * @throws InputError for levels that cannot fit into memory. */
template <int dim>
std::unique_ptr<Sequence<dim>> make_nested_sequence(const StudyContext<dim> &context);

/** Makes a sequence of graded meshes, which ends when the target error is reached or the next mesh
 * has too many unknowns. */
std::unique_ptr<Sequence<2>> make_hp_sequence(const StudyContext<2> &context);

/** Returns the first level of graded meshes with enough cells to show where the solution is
 * singular. From the five cells of a disc, they take up to six times as long as from level 2.
 * @param n_graded_cells Geometry::n_graded_cells(). */
unsigned int first_graded_level(double n_graded_cells);

/** Makes the sequence that the parameters choose. */
template <int dim>
std::unique_ptr<Sequence<dim>> make_sequence(const StudyContext<dim> &context) {
  if constexpr (dim == 2)
    if (context.parameters.discretization.strategy == Strategy::hp)
      return make_hp_sequence(context);
  return make_nested_sequence(context);
}

/** A callback that gets the number of a load case, from one on, and its solution. */
template <int dim>
using CaseFields = std::function<void(unsigned int, const Solved<dim> &)>;

/**
 * Solves the load cases of the scene on a level that is solved, on the last level with estimates of
 * their errors, and adds the summary to the record. Collective.
 * @param use_fields is called on the last level for each case whose fields are wanted, as soon as
 * it is solved.
 */
template <int dim>
std::vector<CaseResult> solve_load_cases(const Parameters &parameters, const Scene<dim> &scene,
                                         LevelResult<dim> &level, const CaseFields<dim> &use_fields,
                                         const Progress &progress);
} // namespace Signorini
