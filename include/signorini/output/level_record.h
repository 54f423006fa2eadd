// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/postprocess/certificate.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** Wall seconds of the stages of one level. */
struct StageTimes
{
  double mesh = 0.;
  double setup = 0.;
  double assembly = 0.;
  double factor = 0.;
  double compliance = 0.;
  double qp = 0.;
  double recovery = 0.;
  double postprocess = 0.;
  double errors = 0.;
  double output = 0.;

  double total() const
  {
    return mesh + setup + assembly + factor + compliance + qp + recovery + postprocess + errors +
           output;
  }
};

/** One row of convergence.csv; what is not known or not asked for in a scene is empty. */
struct LevelRecord
{
  unsigned int level = 0;
  unsigned long long cells = 0;
  unsigned long long dofs = 0;
  unsigned int multipliers = 0;
  /** h and H: longest edge, longest patch (length). */
  double h = 0.;
  double H = 0.;
  unsigned int active = 0;
  unsigned int qp_iterations = 0;
  /** Projected SOR: the sweep at which the increment alone was small enough. */
  std::optional<unsigned int> increment_iterations;
  double kkt = 0.;
  bool converged = true;
  /** Whether the pressure is the only one that solves the dual problem. */
  bool unique = true;
  /** Whether a patch is no longer than a face (H = h). */
  bool unstable = false;
  std::optional<double> inf_sup;
  /** K/mu (h/l)^2 of a nearly incompressible body on the finest level, where elements may lock. */
  std::optional<double> locking_number;
  double contact_force = 0.;
  double max_pressure = 0.;
  double contact_length = 0.;

  std::optional<double> u_h1, u_l2, u_superclose_h1, u_post_h1;
  std::optional<double> p_l2, p_post_l2;
  std::optional<double> p_dual, p_dual_spectral;
  std::optional<double> p_superclose_dual, p_superclose_dual_spectral;
  std::optional<double> endpoint_error;
  std::optional<double> lemma_2_l2, lemma_2_dual, lemma_3_h1, lemma_3_trace, lemma_5;
  std::optional<double> bound_26, bound_27, bound_30;
  std::optional<double> u_post4_h1;
  std::optional<double> estimated_h1, estimated_relative;

  /** Solves with the factors of A, and the largest |b - A x| / |b| among them. */
  unsigned int linear_solves = 0;
  double linear_residual = 0.;
  /** The relative error of U that is due to rounding, as far as it was estimated. */
  double rounding_error = 0.;

  Certificate certificate;
  StageTimes times;
  /** CPU seconds of the process so far, and its peak memory so far. */
  double cpu_total = 0.;
  double peak_memory_mb = 0.;

  /** estimated_h1 / u_h1. */
  std::optional<double> effectivity() const;
  /** What rounding makes of U or of its forces, the larger of both. */
  double rounding() const;
  /** The bound on the certificate's residuals that belongs to a tolerance of the dual problem: not
   * below what rounding makes of U. */
  double residual_bound(double tolerance) const;
  /** One sentence that says why the dual problem or the certificate is not within @p tolerance;
   * empty if they are. */
  std::string doubt(double tolerance) const;
  bool is_certified(double tolerance) const
  {
    return doubt(tolerance).empty();
  }
};

/** The largest residual_bound() of a study; that of a level without rounding if there is none. */
double largest_residual_bound(const std::vector<LevelRecord> &levels, double tolerance);
} // namespace Signorini
