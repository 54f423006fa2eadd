// SPDX-License-Identifier: LGPL-2.1-or-later
// Q^H, and G of (22).

#include <signorini/base/errors.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/discretization/multiplier/multiplier_space.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>

namespace Signorini
{
namespace
{
/** The maximal number of nodes of a patch. */
constexpr unsigned int max_nodes = 24;

/** Returns the Gauss points of every number from 1 on, between 0 and 1, with their weights. */
const Quadrature<1> &gauss_rule(const unsigned int n_points)
{
  static const std::vector<Quadrature<1>> rules = []() {
    std::vector<Quadrature<1>> all;
    for (unsigned int n = 1; n <= max_nodes; ++n)
      all.emplace_back(QGauss<1>(n));
    return all;
  }();
  return rules.at(n_points - 1);
}

/** Returns the points with the ends (Gauss and Lobatto), from two points on. */
const Quadrature<1> &lobatto_rule(const unsigned int n_points)
{
  static const std::vector<Quadrature<1>> rules = []() {
    std::vector<Quadrature<1>> all;
    for (unsigned int n = 2; n <= max_nodes; ++n)
      all.emplace_back(QGaussLobatto<1>(n));
    return all;
  }();
  return rules.at(n_points - 2);
}

template <typename Nodes>
const Quadrature<1> &rule_of(const Nodes nodes, const unsigned int n_points)
{
  return nodes == Nodes::lobatto ? lobatto_rule(n_points) : gauss_rule(n_points);
}

/** Returns the position of a point of the side on a patch, between 0 and 1. */
template <int dim>
double position(const Patch<dim> &patch, const Point<dim - 1> &s)
{
  return (s[0] - patch.lower[0]) / (patch.upper[0] - patch.lower[0]);
}
} // namespace

template <int dim>
MultiplierSpace<dim>::MultiplierSpace(const ContactSurface<dim> &surface)
  : MultiplierSpace(surface, std::vector<unsigned int>(surface.patches().size(), 1))
{
}

template <int dim>
MultiplierSpace<dim>::MultiplierSpace(const ContactSurface<dim> &surface,
                                      const std::vector<unsigned int> &n_nodes,
                                      const Nodes nodes,
                                      const std::vector<unsigned int> &without)
  : surface_(surface)
  , nodes_(nodes)
  , first_({0})
{
  AssertDimension(n_nodes.size(), surface.patches().size());
  number(n_nodes, without);
}

template <int dim>
void MultiplierSpace<dim>::number(const std::vector<unsigned int> &n_nodes,
                                  const std::vector<unsigned int> &without)
{
  const std::vector<Patch<dim>> &patches = surface_.patches();
  unsigned int n_all = 0;
  const auto next_unknown = [&](const unsigned int patch, const unsigned int node) {
    if (std::binary_search(without.begin(), without.end(), n_all++))
      return no_unknown;
    patch_of_.push_back(patch);
    node_of_.push_back(node);
    return static_cast<unsigned int>(patch_of_.size()) - 1;
  };
  unsigned int first_on_side = 0;
  for (unsigned int patch = 0; patch < n_nodes.size(); ++patch)
  {
    Assert(dim == 2 || n_nodes[patch] == 1, ExcNotImplemented());
    const bool starts_side = patch == 0 || patches[patch - 1].side != patches[patch].side;
    const bool ends_side =
      patch + 1 == patches.size() || patches[patch + 1].side != patches[patch].side;
    if (starts_side)
      first_on_side = patch;
    // On both faces of a corner the pressures have different directions.
    const bool is_alone = starts_side || starts_at_corner(patches[patch]);
    unknowns_.emplace_back();
    Unknowns &unknowns = unknowns_.back();
    for (unsigned int node = 0; node < n_nodes[patch]; ++node)
      if (nodes_ == Nodes::lobatto && node == 0 && !is_alone)
        unknowns.push_back(unknowns_[patch - 1].back());
      else if (nodes_ == Nodes::lobatto && node + 1 == n_nodes[patch] && ends_side &&
               closes(patches[patch]))
        unknowns.push_back(unknowns_[first_on_side].front());
      else
        unknowns.push_back(next_unknown(patch, node));
    first_.push_back(patch_of_.size());
  }
}

template <int dim>
bool MultiplierSpace<dim>::closes(const Patch<dim> &last) const
{
  if constexpr (dim == 2)
    return surface_.side(last).is_closed() && !surface_.side(last).has_corner(0.);
  else
    return false;
}

template <int dim>
bool MultiplierSpace<dim>::starts_at_corner(const Patch<dim> &patch) const
{
  if constexpr (dim == 2)
    return surface_.side(patch).has_corner(patch.lower[0]);
  else
    return false;
}

template <int dim>
Point<dim - 1> MultiplierSpace<dim>::node(const unsigned int unknown) const
{
  const Patch<dim> &patch = surface_.patches()[patch_of(unknown)];
  const auto n = static_cast<unsigned int>(unknowns_[patch_of(unknown)].size());
  if (n == 1)
    return patch.centre();
  const double t = rule_of(nodes_, n).point(node_of_[unknown])[0];
  return patch.lower + t * (patch.upper - patch.lower);
}

template <int dim>
double MultiplierSpace<dim>::shape_value(const unsigned int patch,
                                         const unsigned int i,
                                         const Point<dim - 1> &s) const
{
  const auto n = static_cast<unsigned int>(unknowns_[patch].size());
  if (n == 1)
    return 1.;
  const auto &nodes = rule_of(nodes_, n).get_points();
  const double t = position(surface_.patches()[patch], s);
  double value = 1.;
  for (unsigned int j = 0; j < n; ++j)
    if (j != i)
      value *= (t - nodes[j][0]) / (nodes[i][0] - nodes[j][0]);
  return value;
}

template <int dim>
double MultiplierSpace<dim>::shape_value(const unsigned int unknown, const Point<dim - 1> &s) const
{
  return shape_value(patch_of(unknown), node_of_[unknown], s);
}

template <int dim>
double MultiplierSpace<dim>::value(const Pressure &P,
                                   const unsigned int patch,
                                   const Point<dim - 1> &s) const
{
  const Unknowns &unknowns = unknowns_[patch];
  double p = 0.;
  for (unsigned int i = 0; i < unknowns.size(); ++i)
    if (unknowns[i] != no_unknown)
      p += P[unknowns[i]] * shape_value(patch, i, s);
  return p;
}

template <int dim>
dealii::Vector<double> MultiplierSpace<dim>::upper_bounds() const
{
  return Vector(n_multipliers());
}

template <int dim>
dealii::Vector<double> MultiplierSpace<dim>::integrals() const
{
  Vector integrals(n_multipliers());
  for (unsigned int patch = 0; patch < unknowns_.size(); ++patch)
  {
    const Unknowns &unknowns = unknowns_[patch];
    const Quadrature<1> &rule = rule_of(nodes_, unknowns.size());
    for (unsigned int i = 0; i < unknowns.size(); ++i)
      if (unknowns[i] != no_unknown)
        integrals[unknowns[i]] += surface_.patches()[patch].measure * rule.weight(i);
  }
  return integrals;
}

template <int dim>
dealii::Vector<double> MultiplierSpace<dim>::project(const Vector &moments) const
{
  // ∫ ψ_j ψ_k = δ_jk ∫ ψ_k: Gauss' rule integrates the product exactly. At nodes of
  // Lobatto this is the projection by their rule.
  Vector coefficients = moments;
  const Vector squares = integrals();
  for (unsigned int k = 0; k < n_multipliers(); ++k)
    coefficients[k] /= squares[k];
  return coefficients;
}

template <int dim>
dealii::Vector<double> assemble_gap(const MultiplierSpace<dim> &space,
                                    const std::vector<BoundaryCondition<dim>> &boundary,
                                    const unsigned int n_points,
                                    const Grading grading)
{
  const auto gap_on = [&](const Piece<dim> &piece, const SurfaceRule<dim> &rule) {
    std::vector<double> g(rule.size());
    boundary[space.surface().patches()[piece.patch].side].data->value_list(rule.points, g);
    for (std::size_t q = 0; q < rule.size(); ++q)
      if (!std::isfinite(g[q]))
      {
        std::ostringstream message;
        message << "the gap has the value " << g[q] << " at (" << rule.points[q]
                << "), allowed: finite values on the whole side.";
        throw InputError(message.str());
      }
    return g;
  };
  // g contains u_n, which may have a fractional power at an end of contact.
  return integrate_against_multipliers(space, n_points, grading, gap_on);
}

template class MultiplierSpace<2>;
template class MultiplierSpace<3>;
template dealii::Vector<double> assemble_gap(const MultiplierSpace<2> &,
                                             const std::vector<BoundaryCondition<2>> &,
                                             unsigned int,
                                             Grading);
template dealii::Vector<double> assemble_gap(const MultiplierSpace<3> &,
                                             const std::vector<BoundaryCondition<3>> &,
                                             unsigned int,
                                             Grading);

// D of (22): the normal trace B tested with the basis of Q^H.

namespace
{
/** The sums of a column during the assembly. */
using Sums = std::map<types::global_dof_index, double>;

Coupling to_coupling(const std::vector<Sums> &sums)
{
  std::vector<Coupling::Column> columns;
  columns.reserve(sums.size());
  for (const Sums &column : sums)
    columns.emplace_back(column.begin(), column.end());
  return Coupling(std::move(columns));
}
} // namespace

Coupling::Coupling(std::vector<Column> columns)
  : columns_(std::move(columns))
{
}

void Coupling::add_product(const dealii::Vector<double> &P, DistributedVector &vector) const
{
  AssertDimension(P.size(), n_columns());
  for (unsigned int tau = 0; tau < n_columns(); ++tau)
    if (P[tau] != 0.)
      for (const auto &entry : columns_[tau])
        if (vector.in_local_range(entry.first))
          vector(entry.first) += entry.second * P[tau];
}

namespace
{
/** Returns Dᵀ U from the rows of U that this rank owns. */
template <typename VectorType>
dealii::Vector<double> product_of_rows(const Coupling &D, const VectorType &U)
{
  dealii::Vector<double> product(D.n_columns());
  for (unsigned int tau = 0; tau < D.n_columns(); ++tau)
    for (const auto &entry : D.column(tau))
      if (U.in_local_range(entry.first))
        product[tau] += entry.second * U(entry.first);
  return product;
}
} // namespace

dealii::Vector<double> Coupling::transpose_product(const dealii::Vector<double> &U) const
{
  return product_of_rows(*this, U);
}

dealii::Vector<double> Coupling::transpose_product(const Displacement &U) const
{
  dealii::Vector<double> product = product_of_rows(*this, U);
  Utilities::MPI::sum(product, U.get_mpi_communicator(), product);
  return product;
}

dealii::Vector<double> Coupling::local_transpose_product(const DistributedVector &U) const
{
  return product_of_rows(*this, U);
}

template <int dim>
Coupling assemble_coupling(const DisplacementSpace<dim> &space,
                           const MultiplierSpace<dim> &multipliers)
{
  const ContactSurface<dim> &surface = multipliers.surface();
  const FEValuesExtractors::Vector displacement(0);
  TraceValues<dim> traces(space);
  std::vector<Sums> columns(multipliers.n_multipliers());
  for (const Piece<dim> &piece : surface.pieces())
  {
    const ContactFace<dim> &face = surface.faces()[piece.face];
    const SurfaceRule<dim> &rule = piece.on_mesh;
    const auto &values = traces.reinit(face, rule.on_face);
    const auto indices = space.cell_dofs(face.cell);
    const double measure = std::accumulate(rule.weights.begin(), rule.weights.end(), 0.);
    const auto &unknowns = multipliers.unknowns_on(piece.patch);
    for (unsigned int k = 0; k < unknowns.size(); ++k)
      for (unsigned int j = 0; j < indices.size() && unknowns[k] != multipliers.no_unknown; ++j)
      {
        double integral = 0.;
        for (std::size_t q = 0; q < rule.size(); ++q)
          integral += values[displacement].value(j, q) * rule.normals[q] *
                      multipliers.shape_value(piece.patch, k, rule.on_side[q]) * rule.weights[q];
        if (std::abs(integral) > 1e-15 * measure)
          columns[unknowns[k]][indices[j]] += integral;
      }
  }
  return to_coupling(columns);
}

Coupling condense(const Coupling &D, const AffineConstraints<double> &constraints)
{
  std::vector<Sums> columns(D.n_columns());
  for (unsigned int tau = 0; tau < D.n_columns(); ++tau)
    for (const auto &entry : D.column(tau))
    {
      if (!constraints.is_constrained(entry.first))
        columns[tau][entry.first] += entry.second;
      else if (const auto *line = constraints.get_constraint_entries(entry.first))
        for (const auto &other : *line)
          columns[tau][other.first] += other.second * entry.second;
    }
  return to_coupling(columns);
}

template Coupling assemble_coupling(const DisplacementSpace<2> &, const MultiplierSpace<2> &);
template Coupling assemble_coupling(const DisplacementSpace<3> &, const MultiplierSpace<3> &);
} // namespace Signorini
