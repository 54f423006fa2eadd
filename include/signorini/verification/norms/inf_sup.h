// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/displacement_space.h>
#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/problem/parameters/options.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <optional>

namespace Signorini {
/** Assembles (A_1)_ij = (φ_j, φ_i)_{1,Ω} = ∫ φ_j.φ_i + grad φ_j : grad φ_i,
 * condensed like A. Collective. */
template <int dim>
TrilinosWrappers::SparseMatrix assemble_h1_gram_matrix(const DisplacementSpace<dim> &space);

/** The constant of Lemma 1, and those of the sides of pairs by themselves: of the sides named
 * first, and of the opposite ones. */
struct InfSup {
  double both = 0.;
  std::optional<double> first, opposite;
};

/**
 * Returns the constant of Lemma 1,
 *
 *     β² = min_q (qᵀ Dᵀ A_1⁻¹ D q) / (qᵀ S q),
 *
 * where A_1 is the Gram matrix of V^h in (.,.)_{1,Ω}, and @p S that of Q^H in the cosine norm
 * |||.|||_{-1/2}. It takes one factorisation of its own and m solves. Of two
 * bodies β² >= β_1² + β_2². Collective.
 */
template <int dim>
InfSup measure_inf_sup(const DisplacementSpace<dim> &space, const MultiplierSpace<dim> &multipliers,
                       const Coupling &condensed_D, const FullMatrix<double> &S,
                       LinearSolver linear_solver);
} // namespace Signorini
