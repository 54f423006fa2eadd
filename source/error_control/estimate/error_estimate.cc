// SPDX-License-Identifier: LGPL-2.1-or-later
// Distances between interpolations of the nodal values; (24) and (31) make the first an estimate of
// the error of the mesh.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/cell_evaluator.h>
#include <signorini/discretization/space/cell_stiffness.h>
#include <signorini/error_control/estimate/error_estimate.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/polynomials_piecewise.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor_product_polynomials.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace Signorini {
namespace {
/** The squares of norms of v - w, of a cell or of the body: of the values and the gradients of the
 * first displacement, and the energy of the last; in 2-D the energy of v itself of the first. */
using Squares = Tensor<1, 4>;

/** Integrates v - w, where v is the patch interpolation over @p fine generations and w that over
 * one less. Every chunk of cells has its own object. */
template <int dim>
class Distance {
public:
  using CellIterator = typename DoFHandler<dim>::active_cell_iterator;

  // Three points are exact on parallelograms for products of functions of degree two per direction.
  // Those of degree four are smooth on a quarter of their length, and only compared.
  Distance(const DisplacementSpace<dim> &space, const Scene<dim> *const scene,
           const std::vector<const Displacement *> &displacements, const unsigned int fine)
    : scene_(scene)
    , n_displacements_(displacements.size())
    , n_points_(2 * space.element().degree + 1)
    , u_(space, fields_of(displacements, fine)) {
    if (scene != nullptr)
      energy_.emplace(*scene);
  }
  Squares integrate(const CellIterator &cell) {
    u_.reinit(cell, n_points_);
    Squares sum;
    for (unsigned int k = 0; k < n_displacements_; ++k) {
      const FieldValues<dim> &v = u_.on_reference_cell(2 * k), &w = u_.on_reference_cell(2 * k + 1);
      for (unsigned int q = 0; q < u_.size(); ++q)
        add(k, q, v.values[q] - w.values[q], u_.in_body(v.gradients[q] - w.gradients[q], q), sum);
    }
    for (unsigned int q = 0; dim == 2 && q < u_.size() && scene_ != nullptr; ++q)
      sum[3] += energy_->at(u_.points()[q]).density(u_.value(q), u_.gradient(q)) * u_.measure(q);
    return sum;
  }

private:
  /** Returns v and w of the first displacement, of the second, ... */
  static std::vector<EvaluatedField>
  fields_of(const std::vector<const Displacement *> &displacements, const unsigned int fine) {
    std::vector<EvaluatedField> fields;
    for (const Displacement *const U : displacements)
      fields.insert(fields.end(), {{U, fine}, {U, fine - 1}});
    return fields;
  }
  /** Adds the contribution of a point to the integrals of a displacement. */
  void add(const unsigned int k, const unsigned int q, const Tensor<1, dim> &value,
           const Tensor<2, dim> &gradient, Squares &sum) {
    const Point<dim> &x = u_.points()[q];
    const double dx = u_.measure(q);
    if (k == 0) {
      sum[0] += value.norm_square() * dx;
      sum[1] += (scene_ == nullptr ? gradient.norm_square()
                                   : gradient_square(scene_->geometry, x, value, gradient)) *
                dx;
    }
    if (scene_ != nullptr && k + 1 == n_displacements_)
      sum[2] += energy_->at(x).density(value, gradient) * dx;
  }

  /** Null, and empty, if energies are not wanted. */
  const Scene<dim> *const scene_;
  std::optional<EnergyMeasure<dim>> energy_;
  const unsigned int n_displacements_, n_points_;
  CellEvaluator<dim> u_;
};

/** Integrals over the reference cell of products of two functions, and of their derivatives. */
struct Products {
  double values = 0.;
  Tensor<2, 3> gradients;
};

/** Returns, at 27 a + b, those of φ_a - I_h φ_a and φ_b - I_h φ_b: φ_a are the functions of π^{2h}
 * on a parent, and I_h interpolates them by degree one on its children. */
std::vector<Products> products_of_differences() {
  using Basis = TensorProductPolynomials<3, Polynomials::PiecewisePolynomial<double>>;
  using Polynomials::generate_complete_Lagrange_basis_on_subdivisions;
  const Basis smooth(generate_complete_Lagrange_basis_on_subdivisions(1, 2)),
    interpolation(generate_complete_Lagrange_basis_on_subdivisions(2, 1));
  const QIterated<3> rule(QGauss<1>(3), 2);
  const auto n = smooth.n();
  std::vector<Products> products(n * n);
  std::vector<double> values(n);
  std::vector<Tensor<1, 3>> gradients(n);
  for (unsigned int q = 0; q < rule.size(); ++q)
    for (unsigned int a = 0; a < n; ++a) {
      const Point<3> &x = rule.point(q);
      values[a] = smooth.compute_value(a, x) - interpolation.compute_value(a, x);
      gradients[a] = smooth.compute_grad(a, x) - interpolation.compute_grad(a, x);
      // The other triangle counts, too.
      for (unsigned int b = 0; b <= a; ++b) {
        const double weight = (a == b ? 1. : 2.) * rule.weight(q);
        products[n * a + b].values += weight * values[a] * values[b];
        products[n * a + b].gradients += weight * outer_product(gradients[a], gradients[b]);
      }
    }
  return products;
}

/** Integrates the same over parents that are parallelepipeds, for elements of degree one and one
 * law of Hooke: quadratic forms of nodal values, linear in their products, which are summed over
 * parents of one shape first. */
class ParentDistance {
public:
  using Cell = DoFHandler<3>::active_cell_iterator;

  ParentDistance(const DisplacementSpace<3> &space, const Scene<3> &scene,
                 const std::vector<const Displacement *> &displacements,
                 const std::vector<Products> &products)
    : products_(products)
    , law_(scene.material->hooke(Point<3>()))
    , values_(displacements.size(), FullMatrix<double>(max_parents, 3 * nodes_.size())) {
    for (const Displacement *const U : displacements)
      interpolations_.emplace_back(space, *U);
  }
  /** Takes the parent of a cell, with its first child. @return whether it is one of these. */
  bool take(const Cell &cell) {
    const auto parent = cell->parent();
    if (!is_affine<3>(parent))
      return false;
    if (parent->child_index(0) != cell->index())
      return true;
    Tensor<2, 3> edges;
    for (unsigned int d = 0; d < 3; ++d)
      edges[d] = parent->vertex(1U << d) - parent->vertex(0);
    if (n_parents_ == max_parents || (edges - edges_).norm() > 1e-12 * edges.norm())
      add_integrals();
    edges_ = edges;
    for (std::size_t k = 0; k < values_.size(); ++k) {
      const std::vector<Tensor<1, 3>> &u = interpolations_[k].nodal_values(cell);
      double *value = &values_[k](n_parents_, 0);
      for (unsigned int a = 0; a < nodes_.size(); ++a) {
        // v - w has no part of a linear function but its rounding.
        const Point<3> &x = nodes_[a];
        const Tensor<1, 3> rest =
          u[a] - u[0] - x[0] * (u[2] - u[0]) - x[1] * (u[6] - u[0]) - x[2] * (u[18] - u[0]);
        value = std::copy_n(rest.begin_raw(), 3, value);
      }
    }
    ++n_parents_;
    return true;
  }
  /** Returns the integrals over all parents taken. */
  const Squares &sum() {
    add_integrals();
    return sum_;
  }

private:
  /** Adds the integrals over the last parents, which have one shape. */
  void add_integrals() {
    for (std::size_t k = 0; k < values_.size() && n_parents_ > 0; ++k) {
      const Tensor<2, 3> inverse = invert(edges_);
      FullMatrix<double> sums(values_[k].n(), values_[k].n());
      values_[k].Tmmult(sums, values_[k]);
      sums *= determinant(edges_);
      values_[k] = 0.;
      for (unsigned int a = 0; a < nodes_.size(); ++a)
        for (unsigned int b = 0; b <= a; ++b) {
          const Products &products = products_[nodes_.size() * a + b];
          const Tensor<2, 3> gradients = inverse * products.gradients * transpose(inverse);
          for (unsigned int i = 0; i < 3; ++i) {
            const double square = sums(3 * a + i, 3 * b + i);
            sum_[0] += k == 0 ? square * products.values : 0.;
            sum_[1] += k == 0 ? square * trace(gradients) : 0.;
            for (unsigned int j = 0; j < 3 && k + 1 == values_.size(); ++j)
              for (unsigned int d = 0; d < 3; ++d)
                sum_[2] += sums(3 * a + i, 3 * b + j) * (law_[i][d][j] * gradients[d]);
          }
        }
    }
    n_parents_ = 0;
  }

  static constexpr unsigned int max_parents = 64;
  const std::vector<Products> &products_;
  const Tensor<4, 3> law_;
  const std::vector<Point<3>> nodes_ = QIterated<3>(QTrapezoid<1>(), 2).get_points();
  std::vector<PatchInterpolation<3>> interpolations_;
  /** Those of each displacement, a row for every parent since the last sum. */
  std::vector<FullMatrix<double>> values_;
  unsigned int n_parents_ = 0;
  /** The edges of these parents along the coordinates, by rows. */
  Tensor<2, 3> edges_;
  Squares sum_;
};

/** Returns the sums over all ranks; the parts of the threads are added up in the order of cells. */
template <int dim>
Squares integrate(const DisplacementSpace<dim> &space, const Scene<dim> *const scene,
                  const std::vector<const Displacement *> &displacements, const unsigned int fine) {
  Squares sum;
  std::vector<Products> products;
  if (dim == 3 && scene != nullptr && space.element().degree == 1 &&
      !space.mesh().has_bent_parents() && scene->material->is_constant())
    products = products_of_differences();
  integrate_by_chunks<Squares, dim>(
    space,
    [&](const Cells<dim> &cells) {
      Distance<dim> distance(space, scene, displacements, fine);
      Squares chunk_result;
      if constexpr (dim == 3)
        if (!products.empty()) {
          ParentDistance of_parents(space, *scene, displacements, products);
          for (const auto &cell : cells)
            if (!of_parents.take(cell))
              chunk_result += distance.integrate(cell);
          return chunk_result + of_parents.sum();
        }
      for (const auto &cell : cells)
        chunk_result += distance.integrate(cell);
      return chunk_result;
    },
    [&sum](const Squares &chunk_result) { sum += chunk_result; });
  const ArrayView<double> numbers(sum.begin_raw(), Squares::dimension);
  Utilities::MPI::sum<double>(numbers, space.mesh().communicator(), numbers);
  return sum;
}

/** Returns ‖.‖_1 with lengths in the given unit, up to that unit's own power. */
double norm_1(const Squares &squares, const double unit_of_length) {
  return std::sqrt(squares[0] / (unit_of_length * unit_of_length) + squares[1]);
}
} // namespace

template <int dim>
ErrorEstimate estimate_error(const DisplacedBody<dim> &body, const EnergyScale &scale,
                             const PressureCorrection &correction, const OtherErrors &others) {
  const Displacement &U = body.U;
  const bool is_corrected = correction.z.size() > 0;
  Displacement corrected(U);
  if (is_corrected)
    corrected += correction.z;
  const Squares squares = integrate<dim>(
    body.space, &body.scene,
    is_corrected ? std::vector<const Displacement *>{&U, &corrected} : std::vector{&U}, 1);
  ErrorEstimate estimate;
  estimate.h1 = norm_1(squares, 1.);
  estimate.mesh = std::sqrt(squares[2]);
  if (dim == 2)
    estimate.post_strain = squares[3];
  estimate.pressure = correction.energy_norm;
  estimate.algebra = others.algebra;
  estimate.contact = others.contact;
  // z_h and the misfit of contact show the same error in two ways.
  estimate.energy = std::hypot(std::sqrt(squares[2]),
                               std::max(correction.energy_norm, others.contact), others.algebra);
  if (estimate.energy > 0.)
    estimate.relative = estimate.energy / scale.of(estimate.energy);
  return estimate;
}

template <int dim>
unsigned int best_interpolation(const DisplacementSpace<dim> &space, const Displacement &U) {
  if (space.mesh().n_nested_ancestors() < 2)
    return space.mesh().n_nested_ancestors();
  const auto change = [&](const unsigned int fine) {
    return norm_1(integrate<dim>(space, nullptr, {&U}, fine), space.mesh().size());
  };
  return change(2) < 2. / 3. * change(1) ? 2 : 1;
}

Columns<ErrorEstimate> ErrorEstimate::columns() {
  return {{"estimated_h1", &ErrorEstimate::h1},
          {"estimated_energy", &ErrorEstimate::energy},
          {"estimated_relative", &ErrorEstimate::relative},
          {"estimated_mesh", &ErrorEstimate::mesh},
          {"estimated_pressure", &ErrorEstimate::pressure},
          {"estimated_algebra", &ErrorEstimate::algebra},
          {"estimated_contact", &ErrorEstimate::contact}};
}

INSTANTIATE_FUNCTION(estimate_error);
INSTANTIATE_FUNCTION(best_interpolation);
} // namespace Signorini
