// SPDX-License-Identifier: LGPL-2.1-or-later
// The norm of V^h as a matrix.

#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/postprocessing/norms/slobodeckij_norm.h>
#include <signorini/postprocessing/norms/spectral_norm.h>
#include <signorini/solvers/contact/compliance.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <vector>

namespace Signorini
{
namespace
{
/**
 * Returns the number of points of a Gauss rule for the Gram matrix. grad φ_i . grad φ_j on a
 * cell is a polynomial divided by the determinant of the cell's map. A determinant that falls
 * linearly by the factor @p r along an edge vanishes outside of it, where the ellipse around the
 * edge on which Gauss' rule with n points converges like ρ^{-2n} has ρ = (sqrt(r) + 1)/(sqrt(r)
 * - 1).
 *
 * @return n with ρ^{-2n} below 1e-10, and as many points more for the polynomial as the element's
 * degree; from degree + 2, which is enough for r = 1, to 39 + degree.
 */
unsigned int points_for_ratio(const double r, const unsigned int degree)
{
  constexpr double most = 39.;
  const double root = std::sqrt(std::max(r, 1.));
  const double logarithm = std::log((root + 1.) / (root - 1.));
  const double n = std::min(most, std::ceil(0.5 * std::log(1e10) / logarithm));
  return degree + std::max(2U, static_cast<unsigned int>(n));
}

/** The shape functions at as many Gauss points as the shape of a cell needs. */
template <int dim>
class ValuesByShape
{
public:
  explicit ValuesByShape(const DisplacementSpace<dim> &space)
    : shape_(space.mesh().mapping(),
             no_functions_,
             QIterated<dim>(QTrapezoid<1>(), 2),
             update_jacobians)
  {
  }

  const FEValues<dim> &reinit(const typename DoFHandler<dim>::active_cell_iterator &cell)
  {
    const FiniteElement<dim> &element = cell->get_fe();
    const unsigned int n = points_for_ratio(ratio_of_determinants(cell), element.degree);
    std::unique_ptr<FEValues<dim>> &values = values_[{element.degree, n}];
    if (values == nullptr)
      values =
        std::make_unique<FEValues<dim>>(shape_.get_mapping(),
                                        element,
                                        QGauss<dim>(n),
                                        update_values | update_gradients | update_JxW_values);
    values->reinit(cell);
    return *values;
  }

private:
  /** Returns the ratio of the largest to the smallest determinant, at the vertices and the middles
   * between them. */
  double ratio_of_determinants(const typename Triangulation<dim>::active_cell_iterator &cell)
  {
    shape_.reinit(cell);
    double smallest = shape_.jacobian(0).determinant(), largest = smallest;
    for (const unsigned int q : shape_.quadrature_point_indices())
    {
      smallest = std::min(smallest, shape_.jacobian(q).determinant());
      largest = std::max(largest, shape_.jacobian(q).determinant());
    }
    return largest / smallest;
  }

  FE_Nothing<dim> no_functions_;
  FEValues<dim> shape_;
  /** The values by the degree and the number of points per direction. */
  std::map<std::pair<unsigned int, unsigned int>, std::unique_ptr<FEValues<dim>>> values_;
};
} // namespace

template <int dim>
TrilinosWrappers::SparseMatrix assemble_h1_gram_matrix(const DisplacementSpace<dim> &space)
{
  TrilinosWrappers::SparseMatrix A_1 = make_matrix(space);
  ValuesByShape<dim> values_by_shape(space);
  FullMatrix<double> cell_matrix;
  std::vector<types::global_dof_index> indices;
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    const FEValues<dim> &values = values_by_shape.reinit(cell);
    const FiniteElement<dim> &element = cell->get_fe();
    const unsigned int n = element.n_dofs_per_cell();
    cell_matrix.reinit(n, n);
    indices.resize(n);
    // The block is the same for every component.
    for (unsigned int v = 0; v < n / dim; ++v)
      for (unsigned int w = 0; w <= v; ++w)
      {
        const unsigned int i = element.component_to_system_index(0, v);
        const unsigned int j = element.component_to_system_index(0, w);
        double product = 0.;
        for (const unsigned int q : values.quadrature_point_indices())
          product += (values.shape_value(i, q) * values.shape_value(j, q) +
                      values.shape_grad(i, q) * values.shape_grad(j, q)) *
                     values.JxW(q);
        for (unsigned int d = 0; d < dim; ++d)
        {
          const unsigned int i_d = element.component_to_system_index(d, v);
          const unsigned int j_d = element.component_to_system_index(d, w);
          cell_matrix(i_d, j_d) = cell_matrix(j_d, i_d) = product;
        }
      }
    cell->get_dof_indices(indices);
    space.constraints().distribute_local_to_global(cell_matrix, indices, A_1);
  }
  A_1.compress(VectorOperation::add);
  return A_1;
}

template TrilinosWrappers::SparseMatrix assemble_h1_gram_matrix(const DisplacementSpace<2> &);
template TrilinosWrappers::SparseMatrix assemble_h1_gram_matrix(const DisplacementSpace<3> &);

// |||.|||_{-1/2,Γ_c} by cosine or Fourier series, side by side.

namespace
{
using numbers::PI;

/**
 * Sums up amount * sin(k θ) (or cos) for k = 1..n_modes over many θ. With k = a + A b,
 *
 *     cos(k θ) = cos(a θ) cos(A b θ) - sin(a θ) sin(A b θ),
 *
 * and the sums over θ for all a and b are products of matrices.
 */
template <bool sine>
class Harmonics
{
public:
  explicit Harmonics(const unsigned int n_modes)
    : n_modes_(n_modes)
    , n_blocks_(n_modes / block + 1)
    , products_(n_blocks_, block)
  {
  }
  void add(const double theta, const double amount)
  {
    theta_.push_back(theta);
    amount_.push_back(amount);
    if (theta_.size() == 256)
      flush();
  }

  /** Adds the sum of mode k to sums[first + k - 1], for all modes. */
  void add_to(dealii::Vector<double> &sums, const unsigned int first)
  {
    flush();
    for (unsigned int k = 1; k <= n_modes_ && used_; ++k)
      sums[first + k - 1] += products_(k / block, k % block);
  }

private:
  /** The number A. */
  static constexpr unsigned int block = 128;

  /** Computes cos(i step θ) and sin(i step θ), row i. Unit vectors are rotated by step
   * θ; their errors add up to 1e-16 per row only. */
  void tabulate(const unsigned int step,
                FullMatrix<double> &cosines,
                FullMatrix<double> &sines) const
  {
    for (unsigned int q = 0; q < theta_.size(); ++q)
    {
      cosines(0, q) = 1.;
      sines(0, q) = 0.;
      cosines(1, q) = std::cos(step * theta_[q]);
      sines(1, q) = std::sin(step * theta_[q]);
    }
    for (unsigned int i = 2; i < cosines.m(); ++i)
      for (unsigned int q = 0; q < theta_.size(); ++q)
      {
        cosines(i, q) = cosines(i - 1, q) * cosines(1, q) - sines(i - 1, q) * sines(1, q);
        sines(i, q) = sines(i - 1, q) * cosines(1, q) + cosines(i - 1, q) * sines(1, q);
      }
  }

  void flush()
  {
    const unsigned int n = theta_.size();
    if (n == 0)
      return;
    used_ = true;
    FullMatrix<double> fine_cos(block, n), fine_sin(block, n);
    FullMatrix<double> coarse_cos(n_blocks_, n), coarse_sin(n_blocks_, n);
    tabulate(1, fine_cos, fine_sin);
    tabulate(block, coarse_cos, coarse_sin);
    for (unsigned int b = 0; b < n_blocks_; ++b)
      for (unsigned int q = 0; q < n; ++q)
      {
        coarse_cos(b, q) *= amount_[q];
        coarse_sin(b, q) *= sine ? amount_[q] : -amount_[q];
      }
    coarse_cos.mTmult(products_, sine ? fine_sin : fine_cos, true);
    coarse_sin.mTmult(products_, sine ? fine_cos : fine_sin, true);
    theta_.clear();
    amount_.clear();
  }

  unsigned int n_modes_;
  /** The number of values of b. */
  unsigned int n_blocks_;
  bool used_ = false;
  /** The sum for k = a + A b in row b and column a. */
  FullMatrix<double> products_;
  std::vector<double> theta_, amount_;
};
} // namespace

SpectralNorm::SpectralNorm(const double length, const bool closed)
  : length_(length)
  , closed_(closed)
  , omega_((closed ? 2. : 1.) * PI / length)
  // The highest frequency is the same for both kinds.
  , n_modes_(closed ? 4096 : 8192)
{
}

unsigned int SpectralNorm::mode(const unsigned int coefficient) const
{
  return coefficient <= n_modes_ ? coefficient : coefficient - n_modes_;
}

double SpectralNorm::weight(const unsigned int k) const
{
  const double frequency = k * omega_;
  return 1. / std::sqrt(1. + frequency * frequency);
}

unsigned int SpectralNorm::n_tail_modes(const unsigned int m) const
{
  // S_k has this period on equal intervals.
  const unsigned int period = std::max(1U, (closed_ ? 1U : 2U) * m);
  return period < n_modes_ / 2 ? period * ((n_modes_ / 2) / period) : n_modes_ / 2;
}

double SpectralNorm::tail() const
{
  return 2. / length_ / std::pow(omega_, 3) / (2. * double(n_modes_) * (n_modes_ + 1.));
}

SpectralNorm::Vector SpectralNorm::coefficients(const std::vector<double> &arc_lengths,
                                                const std::vector<double> &weighted_values) const
{
  Vector sums(1 + (closed_ ? 2 : 1) * n_modes_);
  Harmonics<false> cosines(n_modes_);
  Harmonics<true> sines(n_modes_);
  for (std::size_t q = 0; q < arc_lengths.size(); ++q)
  {
    sums[0] += weighted_values[q];
    cosines.add(omega_ * arc_lengths[q], weighted_values[q]);
    if (closed_)
      sines.add(omega_ * arc_lengths[q], weighted_values[q]);
  }
  cosines.add_to(sums, 1);
  sines.add_to(sums, 1 + n_modes_);
  sums *= std::sqrt(2. / length_);
  sums[0] /= std::sqrt(2.);
  return sums;
}

SpectralNorm::Vector SpectralNorm::coefficients_of_constants(const std::vector<double> &ends,
                                                             const Vector &values) const
{
  // ∫ q cos(k ω s) = -sum of jumps times sin / (k ω): on an open side the sines vanish at
  // both ends. ∫ q sin = +sum of jumps times cos / (k ω).
  Vector sums(1 + (closed_ ? 2 : 1) * n_modes_);
  Harmonics<true> sines(n_modes_);
  Harmonics<false> cosines(n_modes_);
  for (unsigned int i = closed_ ? 0 : 1; i < values.size(); ++i)
  {
    const double jump = values[i] - (i > 0 ? values[i - 1] : values[values.size() - 1]);
    if (jump == 0.)
      continue;
    sines.add(omega_ * ends[i], -jump);
    if (closed_)
      cosines.add(omega_ * ends[i], jump);
  }
  sines.add_to(sums, 1);
  cosines.add_to(sums, 1 + n_modes_);
  for (unsigned int c = 1; c < sums.size(); ++c)
    sums[c] *= std::sqrt(2. / length_) / (mode(c) * omega_);
  for (unsigned int i = 0; i < values.size(); ++i)
    sums[0] += values[i] * (ends[i + 1] - ends[i]) / std::sqrt(length_);
  return sums;
}

double SpectralNorm::distance(const Vector &f,
                              const std::vector<double> &ends,
                              const Vector &values) const
{
  const Vector q_H = coefficients_of_constants(ends, values);
  const unsigned int n_last = n_tail_modes(values.size());
  double square = 0., mean = 0.;
  for (unsigned int c = 0; c < q_H.size(); ++c)
  {
    const unsigned int k = mode(c);
    square += weight(k) * (f[c] - q_H[c]) * (f[c] - q_H[c]);
    // q_k = (2/L)^{1/2} S_k/(k ω): the mean of S_k² gives the rest of the sum.
    if (k > n_modes_ - n_last)
      mean += std::pow(q_H[c] * k * omega_, 2) * length_ / 2. / n_last;
  }
  return std::sqrt(square + tail() * mean);
}

double SpectralNorm::primal_norm(const Vector &f, const unsigned int n_pieces) const
{
  const unsigned int n_last = n_tail_modes(n_pieces);
  double square = 0., mean = 0.;
  for (unsigned int c = 0; c < f.size(); ++c)
  {
    const unsigned int k = mode(c);
    square += f[c] * f[c] / weight(k);
    if (k > n_modes_ - n_last)
      mean += std::pow(k, 4) * f[c] * f[c] / n_last;
  }
  // The sum of (k ω) k^-4 over k > K is about ω/(2 K²).
  return std::sqrt(square + omega_ * mean / (2. * double(n_modes_) * (n_modes_ + 1.)));
}

FullMatrix<double> SpectralNorm::gram_matrix(const std::vector<double> &ends) const
{
  const unsigned int m = ends.size() - 1;
  const unsigned int n_last = n_tail_modes(m);
  FullMatrix<double> weighted(m, 1 + (closed_ ? 2 : 1) * n_modes_);
  Vector unit(m);
  for (unsigned int i = 0; i < m; ++i)
  {
    unit = 0.;
    unit[i] = 1.;
    const Vector q = coefficients_of_constants(ends, unit);
    for (unsigned int c = 0; c < q.size(); ++c)
    {
      const unsigned int k = mode(c);
      double square = weight(k);
      // The last modes count for the infinitely many after them, too.
      if (k > n_modes_ - n_last)
        square += tail() * std::pow(k * omega_, 2) * length_ / 2. / n_last;
      weighted(i, c) = std::sqrt(square) * q[c];
    }
  }
  FullMatrix<double> gram(m, m);
  weighted.mTmult(gram, weighted);
  return gram;
}

std::vector<double> patch_ends(const std::vector<Patch<2>> &patches,
                               const unsigned int first,
                               const unsigned int last)
{
  std::vector<double> ends = {patches[first].lower[0]};
  for (unsigned int t = first; t < last; ++t)
    ends.push_back(patches[t].upper[0]);
  return ends;
}

FullMatrix<double> dual_gram_matrix(const ContactSurface<2> &surface)
{
  const std::vector<Patch<2>> &patches = surface.patches();
  FullMatrix<double> gram(patches.size(), patches.size());
  for_each_side(patches, [&](const unsigned int first, const unsigned int last) {
    const SpectralNorm norm = spectral_norm_on(surface.side(patches[first]));
    gram.fill(norm.gram_matrix(patch_ends(patches, first, last)), first, first, 0, 0);
  });
  return gram;
}

// Lemma 1 as a number: a generalised eigenvalue problem on the contact boundary.

namespace
{
LAPACKFullMatrix<double> to_lapack(const FullMatrix<double> &matrix)
{
  LAPACKFullMatrix<double> copy(matrix.m(), matrix.n());
  copy = matrix;
  return copy;
}
} // namespace

template <int dim>
double measure_inf_sup(const DisplacementSpace<dim> &space,
                       const MultiplierSpace<dim> &multipliers,
                       const Coupling &condensed_D,
                       const LinearSolver linear_solver)
{
  const TrilinosWrappers::SparseMatrix A_1 = assemble_h1_gram_matrix(space);
  const auto inverse = factorise(A_1, 1., linear_solver, contact_unknowns(condensed_D));
  double seconds = 0.;
  auto DA_1D = to_lapack(make_compliance(*inverse, condensed_D, seconds)->dense());
  auto S = to_lapack(dual_gram_matrix(multipliers));
  std::vector<dealii::Vector<double>> no_eigenvectors;
  DA_1D.compute_generalized_eigenvalues_symmetric(S, no_eigenvectors);
  double smallest = DA_1D.eigenvalue(0).real();
  for (unsigned int i = 1; i < multipliers.n_multipliers(); ++i)
    smallest = std::min(smallest, DA_1D.eigenvalue(i).real());
  return std::sqrt(std::max(smallest, 0.));
}

template double measure_inf_sup(const DisplacementSpace<2> &,
                                const MultiplierSpace<2> &,
                                const Coupling &,
                                LinearSolver);
template double measure_inf_sup(const DisplacementSpace<3> &,
                                const MultiplierSpace<3> &,
                                const Coupling &,
                                LinearSolver);
} // namespace Signorini
