// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/solvers/contact/dual_problem.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <memory>

namespace Signorini {
/**
 * The model Ĉ of C = Dᵀ A⁻¹ D: an operator that is cheap and spectrally equivalent, c Pᵀ Ĉ P
 * ≤ Pᵀ C P ≤ t Pᵀ Ĉ P with c and t that do not depend on h. It is symmetric positive definite,
 * in the units of C.
 *
 * It depends on the surface of the body, not on its inside: the supports of the body change c and
 * t, not the order of the modes.
 */
class BoundaryModel {
public:
  using Vector = ComplianceOperator::Vector;
  using Matrix = ComplianceOperator::Matrix;
  using Indices = ComplianceOperator::Indices;

  virtual ~BoundaryModel() = default;

  /** Returns m. */
  virtual unsigned int size() const = 0;
  /** Returns Ĉ P. */
  virtual Vector apply(const Vector &P) const = 0;
  /** Returns Ĉ_ij. */
  virtual double entry(unsigned int i, unsigned int j) const = 0;
  /** Returns Ĉ⁻¹ P, or an approximation of it. */
  virtual Vector apply_inverse(const Vector &P) const = 0;
  /** Returns x with Ĉ_SS x = @p rhs for a set S of multipliers. Small sets are solved by Cholesky's
   * factorisation, which is kept for the next call with the same set; larger ones by conjugate
   * gradients, with (Ĉ⁻¹)_SS as preconditioner, to 1e-10 of the right-hand side. */
  Vector solve(const Indices &set, const Vector &rhs) const;

  /** Returns Ĉ_kk for all k. */
  Vector diagonal() const;

protected:
  /**
   * Sets the limit.
   * @param max_factorised_size size of sets that are factorised.
   */
  explicit BoundaryModel(unsigned int max_factorised_size);

private:
  Vector solve_by_factor(const Indices &set, const Vector &rhs) const;
  Vector solve_by_gradients(const Indices &set, const Vector &rhs) const;

  unsigned int max_factorised_size_;
  // Cached results. They change no result of the functions.
  mutable Indices factorised_set_;
  mutable LAPACKFullMatrix<double> factor_;
};

/**
 * Makes Ĉ for constants on the patches of a surface. Where every contact side is straight (flat)
 * and divided into a grid of equal patches, it has one CosineModel block for each side; elsewhere
 * it is the KernelModel of the half-space over all sides. Both take the moduli of the material at
 * the middle of each patch: with M = σ_nn for ε = n n and μ the mean shear modulus on the
 * surface, E' = 4 μ (1 - μ/M), which is E/(1 - ν²) (plane stress: E).
 *
 * @throws ComputationError for other multipliers than constants, and where the kernel would need
 * more than 6000 patches.
 */
template <int dim>
std::shared_ptr<const BoundaryModel> make_boundary_model(const MultiplierSpace<dim> &multipliers);

/** Makes Ĉ with the kernel on all sides. */
template <int dim>
std::shared_ptr<const BoundaryModel> make_kernel_model(const MultiplierSpace<dim> &multipliers);
} // namespace Signorini
