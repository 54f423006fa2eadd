// SPDX-License-Identifier: LGPL-2.1-or-later
// The left-hand sides of (13), (24) and (31), in one pass over the cells.

#include <signorini/base/errors.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/postprocessing/errors/dual_norm_errors.h>
#include <signorini/postprocessing/errors/errors.h>
#include <signorini/postprocessing/fields/forces.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>
#include <signorini/postprocessing/quantities/contact_zones.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Signorini
{
namespace
{
/** The squares of the norms, of a cell or of the body. */
struct Squares
{
  double l2 = 0.;
  double h1_seminorm = 0.;
  double energy = 0.;
  double superclose = 0.;
  /** The squares with one and two generations. */
  std::array<double, 2> post = {};

  Squares &operator+=(const Squares &other)
  {
    l2 += other.l2;
    h1_seminorm += other.h1_seminorm;
    energy += other.energy;
    superclose += other.superclose;
    for (unsigned int g = 0; g < post.size(); ++g)
      post[g] += other.post[g];
    return *this;
  }
};

/** The data that all threads read. */
template <int dim>
struct Fields
{
  const DisplacementSpace<dim> &space;
  const Scene<dim> &scene;
  const Displacement &U;
  const Displacement &interpolant_minus_U;
  unsigned int n_points;
};

/** The exact solution at the quadrature points of a cell. */
template <int dim>
struct ExactValues
{
  void evaluate(const Function<dim> &exact, const std::vector<Point<dim>> &points)
  {
    values.resize(points.size(), dealii::Vector<double>(dim));
    gradients.resize(points.size(), std::vector<Tensor<1, dim>>(dim));
    exact.vector_value_list(points, values);
    exact.vector_gradient_list(points, gradients);
  }
  Tensor<1, dim> value(const unsigned int q) const
  {
    Tensor<1, dim> u;
    for (unsigned int c = 0; c < dim; ++c)
      u[c] = values[q][c];
    return u;
  }
  Tensor<2, dim> gradient(const unsigned int q) const
  {
    Tensor<2, dim> du;
    for (unsigned int c = 0; c < dim; ++c)
      du[c] = gradients[q][c];
    return du;
  }

  std::vector<dealii::Vector<double>> values;
  std::vector<std::vector<Tensor<1, dim>>> gradients;
};

/** Integrates over one cell after the other; every chunk of cells has its own object. */
template <int dim>
class ErrorIntegrals
{
public:
  using CellIterator = typename DoFHandler<dim>::active_cell_iterator;

  explicit ErrorIntegrals(const Fields<dim> &fields)
    : fields_(fields)
    , cell_values_(fields.space.mesh().mapping(),
                   fields.space,
                   fields.scene.kinks,
                   fields.n_points,
                   update_values | update_gradients | update_quadrature_points | update_JxW_values |
                     update_inverse_jacobians)
  {
    const unsigned int n_generations =
      std::min<unsigned int>(Squares().post.size(), fields.space.mesh().n_nested_ancestors());
    for (unsigned int g = 1; g <= n_generations; ++g)
      interpolations_.emplace_back(fields.space, QGauss<dim>(fields.n_points), g);
  }
  Squares integrate(const CellIterator &cell)
  {
    const FEValues<dim> &values = cell_values_.reinit(cell);
    const FEValuesExtractors::Vector displacement(0);
    const unsigned int n = values.n_quadrature_points;
    u_.resize(n);
    du_.resize(n);
    e_.resize(n);
    de_.resize(n);
    values[displacement].get_function_values(fields_.U.entries(), u_);
    values[displacement].get_function_gradients(fields_.U.entries(), du_);
    values[displacement].get_function_values(fields_.interpolant_minus_U.entries(), e_);
    values[displacement].get_function_gradients(fields_.interpolant_minus_U.entries(), de_);
    exact_.evaluate(*fields_.scene.exact_displacement, values.get_quadrature_points());
    Squares squares;
    for (unsigned int q = 0; q < n; ++q)
    {
      const double weight = values.JxW(q);
      const Tensor<2, dim> gradient = exact_.gradient(q) - du_[q];
      const SymmetricTensor<2, dim> strain = symmetrize(gradient);
      squares.l2 += (exact_.value(q) - u_[q]).norm_square() * weight;
      squares.h1_seminorm += gradient.norm_square() * weight;
      squares.energy +=
        (fields_.scene.material->hooke(values.quadrature_point(q)) * strain) * strain * weight;
      squares.superclose += (e_[q].norm_square() + de_[q].norm_square()) * weight;
    }
    for (unsigned int g = 0; g < interpolations_.size(); ++g)
      squares.post[g] = distance(interpolations_[g].evaluate(fields_.U, cell, values), values);
    return squares;
  }

private:
  /** Returns ‖u - v‖_1² on the cell. */
  double distance(const FieldValues<dim> &v, const FEValues<dim> &values) const
  {
    double square = 0.;
    for (const unsigned int q : values.quadrature_point_indices())
      square += ((exact_.value(q) - v.values[q]).norm_square() +
                 (exact_.gradient(q) - v.gradients[q]).norm_square()) *
                values.JxW(q);
    return square;
  }

  const Fields<dim> &fields_;
  CellValues<dim> cell_values_;
  std::vector<PatchInterpolation<dim>> interpolations_;
  ExactValues<dim> exact_;
  std::vector<Tensor<1, dim>> u_, e_;
  std::vector<Tensor<2, dim>> du_, de_;
};

/** Returns the sum over this rank's cells, added up in their order whatever the number of threads.
 */
template <int dim>
Squares integrate_errors(const Fields<dim> &fields)
{
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
  return sum;
}
} // namespace

template <int dim>
DisplacementErrors compute_displacement_errors(const DisplacementSpace<dim> &space,
                                               const Scene<dim> &scene,
                                               const Displacement &U,
                                               const unsigned int n_points)
{
  const MPI_Comm communicator = space.mesh().communicator();
  Displacement interpolant_minus_U = interpolate_at_nodes(space, *scene.exact_displacement);
  interpolant_minus_U -= U;
  const Squares squares = integrate_errors<dim>({space, scene, U, interpolant_minus_U, n_points});
  const auto root_of_sum = [&](const double square) {
    return std::sqrt(Utilities::MPI::sum(square, communicator));
  };
  DisplacementErrors errors;
  errors.l2 = root_of_sum(squares.l2);
  errors.h1 = root_of_sum(squares.l2 + squares.h1_seminorm);
  errors.energy = root_of_sum(squares.energy);
  errors.superclose_h1 = root_of_sum(squares.superclose);
  if (space.mesh().n_nested_ancestors() >= 1)
    errors.post_h1 = root_of_sum(squares.post[0]);
  if (space.mesh().n_nested_ancestors() >= 2)
    errors.post4_h1 = root_of_sum(squares.post[1]);
  if (!std::isfinite(errors.h1))
    throw InputError("the exact displacement or its gradient has no finite value at a quadrature "
                     "point, allowed: finite values on the whole body; give 'Displacement "
                     "gradient' where differences leave the body.");
  return errors;
}

Columns<DisplacementErrors> DisplacementErrors::columns()
{
  return {{"u_h1", &DisplacementErrors::h1},
          {"u_l2", &DisplacementErrors::l2},
          {"u_superclose_h1", &DisplacementErrors::superclose_h1},
          {"u_post_h1", &DisplacementErrors::post_h1},
          {"u_post4_h1", &DisplacementErrors::post4_h1},
          {"u_energy", &DisplacementErrors::energy}};
}

template DisplacementErrors compute_displacement_errors(const DisplacementSpace<2> &,
                                                        const Scene<2> &,
                                                        const Displacement &,
                                                        unsigned int);
template DisplacementErrors compute_displacement_errors(const DisplacementSpace<3> &,
                                                        const Scene<3> &,
                                                        const Displacement &,
                                                        unsigned int);

// The left-hand side of (14) and (33).

template <int dim>
PressureErrors compute_pressure_errors(const MultiplierSpace<dim> &space,
                                       const Pressure &P,
                                       const unsigned int n_points)
{
  const RecoveredPressure<dim> recovered(space, P);
  double l2 = 0.;
  double post_l2 = 0.;
  std::vector<double> p;
  for (const Piece<dim> &piece : space.surface().pieces())
  {
    const SurfaceRule<dim> rule =
      space.surface().rule(piece, n_points + space.n_of(piece.patch) - 1, Grading::towards_kinks);
    p.resize(rule.size());
    space.surface().condition(piece).exact_pressure->value_list(rule.points, p);
    for (std::size_t q = 0; q < rule.size(); ++q)
    {
      const double difference = p[q] - space.value(P, piece.patch, rule.on_side[q]);
      const double post = p[q] - recovered(piece.patch, rule.on_side[q]);
      l2 += difference * difference * rule.weights[q];
      post_l2 += post * post * rule.weights[q];
    }
  }
  if (!std::isfinite(l2))
    throw InputError(
      "the exact pressure has no finite value at a quadrature point, allowed: finite "
      "values inside the contact sides.");
  return {std::sqrt(l2), std::sqrt(post_l2)};
}

Columns<PressureErrors> PressureErrors::columns()
{
  return {{"p_l2", &PressureErrors::l2}, {"p_post_l2", &PressureErrors::post_l2}};
}

template PressureErrors compute_pressure_errors(const MultiplierSpace<2> &,
                                                const Pressure &,
                                                unsigned int);
template PressureErrors compute_pressure_errors(const MultiplierSpace<3> &,
                                                const Pressure &,
                                                unsigned int);

// The left-hand sides of (15) and (25) on rectangles.

namespace
{
/** The points of a composite Gauss rule on an edge. */
struct EdgePoints
{
  explicit EdgePoints(const double length)
  {
    // These are two points for the half of a period of the highest mode.
    constexpr unsigned int n_intervals = RectangleNorm::n_modes / 4, n_points = 8;
    const QGauss<1> gauss(n_points);
    for (unsigned int i = 0; i < n_intervals; ++i)
      for (unsigned int q = 0; q < n_points; ++q)
      {
        positions.push_back(length * (i + gauss.point(q)[0]) / n_intervals);
        weights.push_back(length * gauss.weight(q) / n_intervals);
      }
  }

  std::vector<double> positions, weights;
};

FullMatrix<double> coefficients_on(const Side<3> &side, const Function<3> &p)
{
  const std::array<double, 2> lengths = side.lengths();
  const EdgePoints x(lengths[0]), y(lengths[1]);
  FullMatrix<double> weighted(x.positions.size(), y.positions.size());
  std::vector<Point<3>> points(y.positions.size());
  std::vector<double> values(y.positions.size());
  for (std::size_t a = 0; a < x.positions.size(); ++a)
  {
    for (std::size_t b = 0; b < points.size(); ++b)
      points[b] = side.point({x.positions[a], y.positions[b]});
    p.value_list(points, values);
    for (std::size_t b = 0; b < points.size(); ++b)
      weighted(a, b) = values[b] * x.weights[a] * y.weights[b];
  }
  return RectangleNorm(lengths).coefficients({{x.positions, y.positions}}, weighted);
}
} // namespace

template <>
ExactPressure<3>::ExactPressure(const Scene<3> &scene)
  : scene_(scene)
{
  for (const unsigned int number : scene.contact_sides())
    coefficients_[number] =
      coefficients_on(scene.geometry.sides[number], *scene.boundary[number].exact_pressure);
}

template <>
DualNormErrors ExactPressure<3>::errors(const MultiplierSpace<3> &space, const Pressure &P) const
{
  dealii::Vector<double> difference = project(space);
  difference -= P;
  DualNormErrors sum = {0., {}, 0., {}};
  for (const PatchGrid &grid : patch_grids(space.surface().patches()))
  {
    const RectangleNorm norm = rectangle_norm_on(grid);
    sum.spectral =
      std::hypot(sum.spectral, norm.distance(coefficients_.at(grid.side), values_on(grid, P)));
    sum.superclose_spectral =
      std::hypot(sum.superclose_spectral, norm.norm(values_on(grid, difference)));
  }
  return sum;
}

// The ends of contact, in the exact and in the discrete solution.

namespace
{
/** Returns the arc lengths at which the sign of the exact pressure changes from 0 to negative or
 * back. */
std::vector<double> exact_ends(const Scene<2> &scene, const unsigned int number)
{
  const Side<2> &side = scene.geometry.sides[number];
  const Function<2> &p = *scene.boundary[number].exact_pressure;
  const std::vector<double> cuts = scene.kinks.cut(side, 0., side.length());
  std::vector<double> ends;
  for (std::size_t i = 1; i + 1 < cuts.size(); ++i)
  {
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
std::vector<double> discrete_ends(const MultiplierSpace<2> &space,
                                  const unsigned int number,
                                  const Pressure &P)
{
  const std::vector<Patch<2>> &patches = space.surface().patches();
  const double threshold = pressing_threshold(P);
  std::vector<double> ends;
  if (!space.is_piecewise_constant())
  {
    for (const ContactBracket &bracket : contact_brackets(space, P))
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
double one_sided_distance(const std::vector<double> &from, const std::vector<double> &to)
{
  double largest = 0.;
  for (const double s : from)
  {
    double nearest = std::abs(s - to.front());
    for (const double t : to)
      nearest = std::min(nearest, std::abs(s - t));
    largest = std::max(largest, nearest);
  }
  return largest;
}
} // namespace

std::optional<double> contact_end_error(const MultiplierSpace<2> &space,
                                        const Scene<2> &scene,
                                        const Pressure &P)
{
  std::optional<double> largest;
  for (const unsigned int number : scene.contact_sides())
  {
    const std::vector<double> exact = exact_ends(scene, number);
    const std::vector<double> discrete = discrete_ends(space, number, P);
    if (exact.empty() != discrete.empty())
      return {};
    if (!exact.empty())
      largest = std::max({largest.value_or(0.),
                          one_sided_distance(exact, discrete),
                          one_sided_distance(discrete, exact)});
  }
  return largest;
}
} // namespace Signorini
