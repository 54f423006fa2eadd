// SPDX-License-Identifier: LGPL-2.1-or-later
// The errors of a level against the exact solution: the left-hand sides of (13), (14), (24), (31)
// and (33), and the ends of contact.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/body_measure.h>
#include <signorini/discretization/space/cell_values.h>
#include <signorini/discretization/space/nodes.h>
#include <signorini/discretization/space/patch_interpolation.h>
#include <signorini/postprocessing/fields/recovered_pressure.h>
#include <signorini/postprocessing/quantities/contact_zones.h>
#include <signorini/verification/norms/errors.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Signorini {
namespace {
/** The squares of norms of the differences between u and u_h (value, gradient, energy), I^h u and
 * u_h, and u and the patch interpolations over one and two generations. */
enum Norm : unsigned int {
  of_value,
  of_gradient,
  of_energy,
  of_superclose,
  of_post,
  of_post4,
  n_norms
};
using Squares = Tensor<1, n_norms>;

/** The data that all threads read. */
template <int dim>
struct Fields : DisplacedBody<dim> {
  const Displacement &interpolant_minus_U;
  unsigned int n_points;
};

/** Computes a function of V^h at the points of a cell. */
template <int dim>
void evaluate(const Displacement &U, const FEValues<dim> &values, FieldValues<dim> &u) {
  const FEValuesExtractors::Vector displacement(0);
  u.values.resize(values.n_quadrature_points);
  u.gradients.resize(values.n_quadrature_points);
  values[displacement].get_function_values(U.entries(), u.values);
  values[displacement].get_function_gradients(U.entries(), u.gradients);
}

/** Integrates over one cell after the other; every chunk of cells has its own object. */
template <int dim>
class ErrorIntegrals {
public:
  explicit ErrorIntegrals(const Fields<dim> &fields)
    : fields_(fields)
    , cell_values_(fields.space.mesh().mapping(), fields.space, fields.scene.kinks, fields.n_points,
                   update_values | update_gradients | update_quadrature_points | update_JxW_values |
                     update_inverse_jacobians)
    , energy_(fields.scene) {
    const unsigned int n_generations = std::min(2U, fields.space.mesh().n_nested_ancestors());
    for (unsigned int g = 1; g <= n_generations; ++g)
      interpolations_.emplace_back(fields.space, fields.U, QGauss<dim>(fields.n_points), g);
  }
  Squares integrate(const typename DoFHandler<dim>::active_cell_iterator &cell) {
    const FEValues<dim> &values = cell_values_.reinit(cell);
    evaluate_exact(values.get_quadrature_points());
    evaluate(fields_.U, values, u_h_);
    evaluate(fields_.interpolant_minus_U, values, e_);
    Squares squares;
    for (const unsigned int q : values.quadrature_point_indices()) {
      const Point<dim> &x = values.quadrature_point(q);
      const Tensor<1, dim> value = u_.values[q] - u_h_.values[q];
      const Tensor<2, dim> gradient = u_.gradients[q] - u_h_.gradients[q];
      const double dx = measure_at(values, q);
      squares[of_value] += value.norm_square() * dx;
      squares[of_gradient] += gradient_square(fields_.scene.geometry, x, value, gradient) * dx;
      squares[of_energy] += energy_.at(x).density(value, gradient) * dx;
      squares[of_superclose] += norm_1_square(x, e_.values[q], e_.gradients[q]) * dx;
    }
    for (unsigned int g = 0; g < interpolations_.size(); ++g)
      squares[of_post + g] = distance(u_, interpolations_[g].evaluate(cell, values), values);
    return squares;
  }

private:
  /** Computes the exact solution at points. */
  void evaluate_exact(const std::vector<Point<dim>> &points) {
    values_.resize(points.size(), dealii::Vector<double>(dim));
    gradients_.resize(points.size(), std::vector<Tensor<1, dim>>(dim));
    fields_.scene.exact_displacement->vector_value_list(points, values_);
    fields_.scene.exact_displacement->vector_gradient_list(points, gradients_);
    u_.values.resize(points.size());
    u_.gradients.resize(points.size());
    for (std::size_t q = 0; q < points.size(); ++q)
      for (unsigned int c = 0; c < dim; ++c) {
        u_.values[q][c] = values_[q][c];
        u_.gradients[q][c] = gradients_[q][c];
      }
  }
  double norm_1_square(const Point<dim> &x, const Tensor<1, dim> &value,
                       const Tensor<2, dim> &gradient) const {
    return value.norm_square() + gradient_square(fields_.scene.geometry, x, value, gradient);
  }
  /** Returns ‖u - v‖_1² on the cell. */
  double distance(const FieldValues<dim> &u, const FieldValues<dim> &v,
                  const FEValues<dim> &values) const {
    double square = 0.;
    for (const unsigned int q : values.quadrature_point_indices())
      square += norm_1_square(values.quadrature_point(q), u.values[q] - v.values[q],
                              u.gradients[q] - v.gradients[q]) *
                measure_at(values, q);
    return square;
  }

  const Fields<dim> &fields_;
  CellValues<dim> cell_values_;
  EnergyMeasure<dim> energy_;
  std::vector<PatchInterpolation<dim>> interpolations_;
  /** The exact solution, u_h and I^h u - u_h at the points of a cell. */
  FieldValues<dim> u_, u_h_, e_;
  std::vector<dealii::Vector<double>> values_;
  std::vector<std::vector<Tensor<1, dim>>> gradients_;
};

/** Returns the sums over all ranks; on each rank cells are added up in their order whatever the
 * number of threads. */
template <int dim>
Squares integrate_errors(const Fields<dim> &fields) {
  Squares sum;
  integrate_by_chunks<Squares, dim>(
    fields.space,
    [&](const Cells<dim> &cells) {
      ErrorIntegrals<dim> integrals(fields);
      Squares squares;
      for (const auto &cell : cells)
        squares += integrals.integrate(cell);
      return squares;
    },
    [&sum](const Squares &squares) { sum += squares; });
  const ArrayView<double> numbers(sum.begin_raw(), n_norms);
  Utilities::MPI::sum<double>(numbers, fields.space.mesh().communicator(), numbers);
  return sum;
}
} // namespace

template <int dim>
DisplacementErrors compute_displacement_errors(const DisplacedBody<dim> &body,
                                               const unsigned int n_points) {
  const DisplacementSpace<dim> &space = body.space;
  Displacement interpolant_minus_U = interpolate_at_nodes(space, *body.scene.exact_displacement);
  interpolant_minus_U -= body.U;
  const Squares sum = integrate_errors<dim>({body, interpolant_minus_U, n_points});
  DisplacementErrors errors;
  errors.l2 = std::sqrt(sum[of_value]);
  errors.h1 = std::sqrt(sum[of_value] + sum[of_gradient]);
  errors.energy = std::sqrt(sum[of_energy]);
  errors.superclose_h1 = std::sqrt(sum[of_superclose]);
  if (space.mesh().n_nested_ancestors() >= 1)
    errors.post_h1 = std::sqrt(sum[of_post]);
  if (space.mesh().n_nested_ancestors() >= 2)
    errors.post4_h1 = std::sqrt(sum[of_post4]);
  if (!std::isfinite(errors.h1))
    throw InputError("the exact displacement or its gradient has no finite value at a quadrature "
                     "point, allowed: finite values on the whole body; give 'Displacement "
                     "gradient' where differences leave the body.");
  return errors;
}

INSTANTIATE_FUNCTION(compute_displacement_errors);

template <int dim>
PressureErrors compute_pressure_errors(const MultiplierSpace<dim> &space, const Pressure &P,
                                       const unsigned int n_points,
                                       FunctionPointer<dim> ContactCondition<dim>::*const exact) {
  const RecoveredPressure<dim> recovered(space, P);
  double l2 = 0.;
  double post_l2 = 0.;
  std::vector<double> p;
  for (const Piece<dim> &piece : space.surface().pieces()) {
    const SurfaceRule<dim> rule =
      space.surface().rule(piece, n_points + space.n_of(piece.patch) - 1, Grading::towards_kinks);
    p.resize(rule.size());
    (space.surface().condition(piece).*exact)->value_list(rule.points, p);
    for (std::size_t q = 0; q < rule.size(); ++q) {
      const double difference = p[q] - space.value(P, piece.patch, rule.on_side[q]);
      const double post = p[q] - recovered(piece.patch, rule.on_side[q]);
      l2 += difference * difference * rule.weights[q];
      post_l2 += post * post * rule.weights[q];
    }
  }
  l2 = Utilities::MPI::sum(l2, space.surface().communicator());
  post_l2 = Utilities::MPI::sum(post_l2, space.surface().communicator());
  if (!std::isfinite(l2))
    throw InputError(
      "the exact pressure has no finite value at a quadrature point, allowed: finite "
      "values inside the contact sides.");
  return {std::sqrt(l2), std::sqrt(post_l2)};
}

INSTANTIATE_FUNCTION(compute_pressure_errors);

namespace {
/** Returns the arc lengths at which the sign of the exact pressure changes from 0 to negative or
 * back. */
std::vector<double> exact_ends(const Scene<2> &scene, const ContactCondition<2> &contact) {
  const Side<2> &side = scene.geometry.sides[contact.side];
  const Function<2> &p = *contact.exact_pressure;
  const std::vector<double> cuts = scene.kinks.crossings(side, 0., side.length());
  std::vector<double> ends;
  for (std::size_t i = 1; i + 1 < cuts.size(); ++i) {
    const double s = cuts[i], step = 1e-6 * side.length();
    const bool before = p.value(side.point(s - step)) < 0.;
    const bool after = p.value(side.point(s + step)) < 0.;
    if (before != after)
      ends.push_back(s);
  }
  return ends;
}

/** Returns the arc lengths between a pressing patch and one that does not press; where patches have
 * several nodes, the middle between a pressing node and one that does not. */
std::vector<double> discrete_ends(const MultiplierSpace<2> &space, const unsigned int number,
                                  const Pressure &P) {
  const std::vector<Patch<2>> &patches = space.surface().patches();
  const double threshold = pressing_threshold(P);
  std::vector<double> ends;
  if (!space.is_piecewise_constant()) {
    for (const ZoneBracket &bracket : zone_brackets(space, Multiplier(P).states()))
      if (bracket.side == number)
        ends.push_back(0.5 * (bracket.from + bracket.to));
    return ends;
  }
  for (std::size_t tau = 0; tau + 1 < patches.size(); ++tau)
    if (patches[tau].side == number && patches[tau + 1].side == number &&
        (P[tau] < threshold) != (P[tau + 1] < threshold))
      ends.push_back(patches[tau].upper[0]);
  return ends;
}

/** Returns the largest distance of a point of @p from to the nearest of @p to. */
double one_sided_distance(const std::vector<double> &from, const std::vector<double> &to) {
  double largest = 0.;
  for (const double s : from) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const double t : to)
      nearest = std::min(nearest, std::abs(s - t));
    largest = std::max(largest, nearest);
  }
  return largest;
}
} // namespace

std::optional<double> contact_end_error(const MultiplierSpace<2> &space, const Scene<2> &scene,
                                        const Pressure &P) {
  std::optional<double> largest;
  for (const ContactCondition<2> &contact : scene.contacts) {
    const std::vector<double> exact = exact_ends(scene, contact);
    const std::vector<double> discrete = discrete_ends(space, contact.side, P);
    if (exact.empty() != discrete.empty())
      return {};
    if (!exact.empty())
      largest = std::max({largest.value_or(0.), one_sided_distance(exact, discrete),
                          one_sided_distance(discrete, exact)});
  }
  return largest;
}
} // namespace Signorini
