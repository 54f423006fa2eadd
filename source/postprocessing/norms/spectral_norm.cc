// SPDX-License-Identifier: LGPL-2.1-or-later
// The norm of V^h as a matrix, and dual norms by eigenvectors.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/postprocessing/norms/rectangle_norm.h>
#include <signorini/postprocessing/norms/slobodeckij_norm.h>
#include <signorini/postprocessing/norms/spectral_norm.h>
#include <signorini/solvers/contact/compliance.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <memory>
#include <vector>

namespace Signorini {
namespace {
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
unsigned int points_for_ratio(const double r, const unsigned int degree) {
  constexpr double most = 39.;
  const double root = std::sqrt(std::max(r, 1.));
  const double logarithm = std::log((root + 1.) / (root - 1.));
  const double n = std::min(most, std::ceil(0.5 * std::log(1e10) / logarithm));
  return degree + std::max(2U, static_cast<unsigned int>(n));
}

/** The shape functions at as many Gauss points as the shape of a cell needs. */
template <int dim>
class ValuesByShape {
public:
  explicit ValuesByShape(const Mapping<dim> &mapping)
    : mapping_(mapping) {}

  const FEValues<dim> &reinit(const typename DoFHandler<dim>::active_cell_iterator &cell) {
    const FiniteElement<dim> &element = cell->get_fe();
    const unsigned int n = points_for_ratio(ratio_of_determinants(cell), element.degree);
    std::unique_ptr<FEValues<dim>> &values = values_[{element.degree, n}];
    if (values == nullptr)
      values = std::make_unique<FEValues<dim>>(
        mapping_, element, QGauss<dim>(n), update_values | update_gradients | update_JxW_values);
    values->reinit(cell);
    return *values;
  }

private:
  /** Returns the ratio of the largest to the smallest determinant at the vertices. */
  static double
  ratio_of_determinants(const typename Triangulation<dim>::active_cell_iterator &cell) {
    using Geometry = GeometryInfo<dim>;
    Point<dim> vertices[Geometry::vertices_per_cell];
    Tensor<0, dim> determinants[Geometry::vertices_per_cell];
    for (const unsigned int v : cell->vertex_indices())
      vertices[v] = cell->vertex(v);
    Geometry::alternating_form_at_vertices(vertices, determinants);
    const auto [smallest, largest] =
      std::minmax_element(std::begin(determinants), std::end(determinants));
    return *largest / *smallest;
  }

  const Mapping<dim> &mapping_;
  /** The values by the degree and the number of points per direction. */
  std::map<std::pair<unsigned int, unsigned int>, std::unique_ptr<FEValues<dim>>> values_;
};
} // namespace

template <int dim>
TrilinosWrappers::SparseMatrix assemble_h1_gram_matrix(const DisplacementSpace<dim> &space) {
  TrilinosWrappers::SparseMatrix A_1 = make_matrix(space);
  DistributedVector unused = space.make_vector();
  ValuesByShape<dim> values_by_shape(space.mesh().mapping());
  FullMatrix<double> cell_matrix;
  for (const auto &cell : space.dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const FEValues<dim> &values = values_by_shape.reinit(cell);
    const FiniteElement<dim> &element = cell->get_fe();
    const unsigned int n = element.n_dofs_per_cell();
    cell_matrix.reinit(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j <= i; ++j) {
        if (element.system_to_component_index(i).first !=
            element.system_to_component_index(j).first)
          continue;
        double product = 0.;
        for (const unsigned int q : values.quadrature_point_indices())
          product += (values.shape_value(i, q) * values.shape_value(j, q) +
                      values.shape_grad(i, q) * values.shape_grad(j, q)) *
                     values.JxW(q);
        cell_matrix(i, j) = cell_matrix(j, i) = product;
      }
    add_cell(space, cell_matrix, space.cell_dofs(cell), A_1, unused);
  }
  A_1.compress(VectorOperation::add);
  return A_1;
}

INSTANTIATE_FUNCTION(assemble_h1_gram_matrix);

// |||.|||_{-1/2,Γ_c} by cosine or Fourier series, side by side.

namespace {
using numbers::PI;

using Complex = std::complex<double>;
using ComplexMatrix = LAPACKFullMatrix<Complex>;

/** Returns e^{i j step θ}, j = 0, ..., n - 1 in rows, for the angles θ in columns. The numbers are
 * rotated by step θ from row to row; their errors add up to 1e-16 per row only. */
ComplexMatrix powers(const std::vector<double> &theta, const std::size_t first,
                     const std::size_t last, const unsigned int step, const unsigned int n) {
  ComplexMatrix result(n, last - first);
  for (std::size_t q = first; q < last; ++q) {
    const Complex rotation = std::polar(1., step * theta[q]);
    Complex power = 1.;
    for (unsigned int j = 0; j < n; ++j, power *= rotation)
      result(j, q - first) = power;
  }
  return result;
}

/**
 * Returns Σ amount e^{i k θ} for k = 0, ..., n_modes. With k = a + A b,
 *
 *     e^{i k θ} = e^{i a θ} e^{i A b θ},
 *
 * and the sums over θ for all a and b are a product of matrices.
 */
SpectralNorm::Modes sum_of_waves(const std::vector<double> &theta,
                                 const std::vector<double> &amount, const unsigned int n_modes) {
  constexpr unsigned int A = 128, chunk = 256;
  const unsigned int n_blocks = n_modes / A + 1;
  ComplexMatrix sums(n_blocks, A);
  for (std::size_t first = 0; first < theta.size(); first += chunk) {
    const std::size_t last = std::min<std::size_t>(first + chunk, theta.size());
    ComplexMatrix coarse = powers(theta, first, last, A, n_blocks);
    for (unsigned int b = 0; b < n_blocks; ++b)
      for (std::size_t q = first; q < last; ++q)
        coarse(b, q - first) *= amount[q];
    coarse.mTmult(sums, powers(theta, first, last, 1, A), true);
  }
  SpectralNorm::Modes modes(n_modes + 1);
  for (unsigned int k = 0; k <= n_modes; ++k)
    modes[k] = sums(k / A, k % A);
  return modes;
}
} // namespace

SpectralNorm::SpectralNorm(const double length, const bool closed)
  : length_(length)
  , closed_(closed)
  , omega_((closed ? 2. : 1.) * PI / length)
  // The highest frequency is the same for both kinds.
  , n_modes_(closed ? 4096 : 8192) {}

double SpectralNorm::weight(const unsigned int k) const {
  const double frequency = k * omega_;
  return 1. / std::sqrt(1. + frequency * frequency);
}

unsigned int SpectralNorm::n_tail_modes(const unsigned int m) const {
  // S_k has this period on equal intervals.
  const unsigned int period = std::max(1U, (closed_ ? 1U : 2U) * m);
  return period < n_modes_ / 2 ? period * ((n_modes_ / 2) / period) : n_modes_ / 2;
}

double SpectralNorm::weight_with_tail(const unsigned int k, const unsigned int m) const {
  // q_k = (2/L)^{1/2} S_k/(k ω): the mean of S_k² over the last modes gives the rest of the sum.
  const unsigned int n_last = n_tail_modes(m);
  const double tail = 1. / (omega_ * 2. * double(n_modes_) * (n_modes_ + 1.));
  return weight(k) + (k > n_modes_ - n_last ? tail * k * k / n_last : 0.);
}

SpectralNorm::Modes SpectralNorm::normalised(Modes modes) const {
  modes[0] /= std::sqrt(2.);
  for (Complex &mode : modes)
    mode = std::sqrt(2. / length_) * (closed_ ? mode : mode.real());
  return modes;
}

SpectralNorm::Modes SpectralNorm::coefficients(const std::vector<double> &arc_lengths,
                                               const std::vector<double> &weighted_values) const {
  std::vector<double> theta = arc_lengths;
  for (double &angle : theta)
    angle *= omega_;
  return normalised(sum_of_waves(theta, weighted_values, n_modes_));
}

SpectralNorm::Modes SpectralNorm::coefficients_of_constants(const std::vector<double> &ends,
                                                            const Vector &values) const {
  // ∫ q e^{i k ω s} is -Σ jump e^{i k ω s}/(i k ω), with the jumps at both ends of the side.
  std::vector<double> theta, jumps;
  for (unsigned int i = 0; i <= values.size(); ++i) {
    const double jump = (i < values.size() ? values[i] : 0.) - (i > 0 ? values[i - 1] : 0.);
    if (jump == 0.)
      continue;
    theta.push_back(omega_ * ends[i]);
    jumps.push_back(jump);
  }
  Modes modes = sum_of_waves(theta, jumps, n_modes_);
  modes[0] = 0.;
  for (unsigned int k = 1; k <= n_modes_; ++k)
    modes[k] *= Complex(0., 1. / (k * omega_));
  for (unsigned int i = 0; i < values.size(); ++i)
    modes[0] += values[i] * (ends[i + 1] - ends[i]);
  return normalised(std::move(modes));
}

double SpectralNorm::distance(const Modes &f, const std::vector<double> &ends,
                              const Vector &values) const {
  const Modes q_H = coefficients_of_constants(ends, values);
  double square = 0.;
  for (unsigned int k = 0; k < q_H.size(); ++k)
    square += weight(k) * std::norm(f[k] - q_H[k]) +
              (weight_with_tail(k, values.size()) - weight(k)) * std::norm(q_H[k]);
  return std::sqrt(square);
}

double SpectralNorm::primal_norm(const Modes &f, const unsigned int n_pieces) const {
  const unsigned int n_last = n_tail_modes(n_pieces);
  double square = 0., mean = 0.;
  for (unsigned int k = 0; k < f.size(); ++k) {
    square += std::norm(f[k]) / weight(k);
    if (k > n_modes_ - n_last)
      mean += std::pow(k, 4) * std::norm(f[k]) / n_last;
  }
  // The sum of (k ω) k^-4 over k > K is about ω/(2 K²).
  return std::sqrt(square + omega_ * mean / (2. * double(n_modes_) * (n_modes_ + 1.)));
}

FullMatrix<double> SpectralNorm::gram_matrix(const std::vector<double> &ends) const {
  const unsigned int m = ends.size() - 1, n = n_modes_ + 1;
  FullMatrix<double> weighted(m, closed_ ? 2 * n : n), gram(m, m);
  Vector unit(m);
  for (unsigned int i = 0; i < m; ++i) {
    unit = 0.;
    unit[i] = 1.;
    const Modes q = coefficients_of_constants(ends, unit);
    for (unsigned int k = 0; k < n; ++k) {
      const double root = std::sqrt(weight_with_tail(k, m));
      weighted(i, k) = root * q[k].real();
      if (closed_)
        weighted(i, n + k) = root * q[k].imag();
    }
  }
  weighted.mTmult(gram, weighted);
  return gram;
}

template <int dim>
FullMatrix<double> dual_gram_matrix(const ContactSurface<dim> &surface) {
  FullMatrix<double> gram(surface.patches().size(), surface.patches().size());
  for (const PatchGrid &grid : patch_grids(surface.patches())) {
    FullMatrix<double> on_side;
    if constexpr (dim == 2)
      on_side =
        spectral_norm_on(surface.scene().geometry.sides[grid.side]).gram_matrix(grid.ends[0]);
    else
      on_side = rectangle_norm_on(grid).gram_matrix(equal_cells(grid));
    for (unsigned int k = 0; k < on_side.m(); ++k)
      for (unsigned int l = 0; l < on_side.n(); ++l)
        gram(grid.patches[k], grid.patches[l]) = on_side(k, l);
  }
  return gram;
}
INSTANTIATE_FUNCTION(dual_gram_matrix);

FullMatrix<double> dual_gram_matrix(const MultiplierSpace<3> &multipliers) {
  return dual_gram_matrix(multipliers.surface());
}

// Lemma 1 as a number: a generalised eigenvalue problem on the contact boundary.

template <int dim>
double measure_inf_sup(const DisplacementSpace<dim> &space, const MultiplierSpace<dim> &multipliers,
                       const Coupling &condensed_D, const LinearSolver linear_solver) {
  const TrilinosWrappers::SparseMatrix A_1 = assemble_h1_gram_matrix(space);
  const auto inverse = factorise(A_1, 1., linear_solver, contact_unknowns(condensed_D));
  const unsigned int m = multipliers.n_multipliers();
  LAPACKFullMatrix<double> DA_1D(m), S(m);
  DA_1D = make_compliance(*inverse, condensed_D)->dense();
  S = dual_gram_matrix(multipliers);
  std::vector<dealii::Vector<double>> no_eigenvectors;
  DA_1D.compute_generalized_eigenvalues_symmetric(S, no_eigenvectors);
  double smallest = DA_1D.eigenvalue(0).real();
  for (unsigned int i = 1; i < m; ++i)
    smallest = std::min(smallest, DA_1D.eigenvalue(i).real());
  return std::sqrt(std::max(smallest, 0.));
}

INSTANTIATE_FUNCTION(measure_inf_sup);
} // namespace Signorini
