// SPDX-License-Identifier: LGPL-2.1-or-later
// The common functions of every Ĉ: entries, and solves on sets of multipliers.

#include <signorini/base/errors.h>
#include <signorini/solvers/cycles/boundary_model.h>
#include <signorini/solvers/cycles/kernel_models.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace Signorini
{
namespace
{
using Vector = ComplianceOperator::Vector;
using Indices = ComplianceOperator::Indices;

/** Returns the vector of all multipliers, zero outside of the set. */
Vector extended(const Vector &x, const Indices &set, const unsigned int n)
{
  Vector all(n);
  for (unsigned int r = 0; r < set.size(); ++r)
    all[set[r]] = x[r];
  return all;
}

Vector restricted(const Vector &all, const Indices &set)
{
  Vector x(set.size());
  for (unsigned int r = 0; r < set.size(); ++r)
    x[r] = all[set[r]];
  return x;
}
} // namespace

BoundaryModel::BoundaryModel(const unsigned int max_factorised_size)
  : max_factorised_size_(max_factorised_size)
{
}

Vector BoundaryModel::solve(const Indices &set, const Vector &rhs) const
{
  if (set.empty())
    return Vector();
  return set.size() <= max_factorised_size_ ? solve_by_factor(set, rhs)
                                            : solve_by_gradients(set, rhs);
}

Vector BoundaryModel::solve_by_factor(const Indices &set, const Vector &rhs) const
{
  if (set != factorised_set_)
  {
    const auto n = static_cast<unsigned int>(set.size());
    factorised_set_.clear();
    factor_.reinit(n, n);
    for (unsigned int r = 0; r < n; ++r)
      for (unsigned int c = 0; c <= r; ++c)
      {
        const double value = entry(set[r], set[c]);
        factor_(r, c) = value;
        factor_(c, r) = value;
      }
    factor_.set_property(LAPACKSupport::symmetric);
    factor_.compute_cholesky_factorization();
    factorised_set_ = set;
  }
  Vector x(rhs);
  factor_.solve(x);
  return x;
}

Vector BoundaryModel::solve_by_gradients(const Indices &set, const Vector &rhs) const
{
  constexpr unsigned int max_steps = 500;
  constexpr double tolerance = 1e-10;
  const auto inverse = [&](const Vector &r) {
    return restricted(apply_inverse(extended(r, set, size())), set);
  };
  Vector x(rhs.size()), r(rhs), z = inverse(r), direction(z);
  const double wanted = tolerance * r.l2_norm();
  double r_z = r * z;
  for (unsigned int k = 0; k < max_steps && r.l2_norm() > wanted; ++k)
  {
    const Vector product = restricted(apply(extended(direction, set, size())), set);
    const double step = r_z / (direction * product);
    x.add(step, direction);
    r.add(-step, product);
    z = inverse(r);
    const double next = r * z;
    direction.sadd(next / r_z, 1., z);
    r_z = next;
  }
  return x;
}

Vector BoundaryModel::diagonal() const
{
  Vector values(size());
  for (unsigned int k = 0; k < size(); ++k)
    values[k] = entry(k, k);
  return values;
}

BoundaryModel::Matrix BoundaryModel::columns(const Indices &numbers) const
{
  Matrix values(size(), numbers.size());
  for (unsigned int i = 0; i < size(); ++i)
    for (unsigned int j = 0; j < numbers.size(); ++j)
      values(i, j) = entry(i, numbers[j]);
  return values;
}

const BoundaryModel::Matrix &BoundaryModel::dense() const
{
  if (dense_.m() != size())
  {
    dense_.reinit(size(), size());
    for (unsigned int i = 0; i < size(); ++i)
      for (unsigned int j = 0; j < size(); ++j)
        dense_(i, j) = entry(i, j);
  }
  return dense_;
}

bool BoundaryModel::is_explicit() const
{
  return true;
}

// The choice of Ĉ for a surface.

namespace
{
using Vector = ComplianceOperator::Vector;

/** Returns the size of sets of patches up to which they are factorised. In 2-D a product with m
 * patches costs m², as a solve with factors does; in 3-D only m^{3/2}. */
constexpr unsigned int max_factorised_set_size(const unsigned int dim)
{
  return dim == 2 ? 3000 : 500;
}

/** The maximal number of patches of a dense kernel: 300 MB with its factor. */
constexpr unsigned int max_kernel_patches = 6000;

template <int dim>
void require_constants(const MultiplierSpace<dim> &multipliers)
{
  if (!multipliers.is_piecewise_constant())
    throw ComputationError(
      "The model of the compliance of the contact sides needs one multiplier per patch.");
}

/** Returns E'/E_0 at the middle of a patch. */
template <int dim>
double relative_contact_modulus(const ContactSurface<dim> &surface, const Patch<dim> &patch)
{
  const Side<dim> &side = surface.side(patch);
  const Tensor<1, dim> n = side.normal(patch.centre());
  const auto hooke = surface.scene().material->relative_hooke(side.point(patch.centre()));
  // Σ_j H(n, e_j, n, e_j) is M and one μ for each direction on the surface.
  double M = 0., sum = 0.;
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = 0; b < dim; ++b)
      for (unsigned int j = 0; j < dim; ++j)
      {
        sum += n[a] * n[b] * hooke[a][j][b][j];
        for (unsigned int k = 0; k < dim; ++k)
          M += n[a] * n[b] * n[j] * n[k] * hooke[a][j][b][k];
      }
  const double mu = (sum - M) / (dim - 1);
  // Anisotropic bodies may have μ > M.
  return 4. * mu * (1. - std::min(mu / M, 0.75));
}

/** Returns (2/E')^{1/2} for every patch. */
template <int dim>
Vector scaling_of(const ContactSurface<dim> &surface, const std::vector<Patch<dim>> &patches)
{
  const double unit = surface.scene().material->modulus();
  Vector scaling(patches.size());
  for (unsigned int k = 0; k < scaling.size(); ++k)
    scaling[k] = std::sqrt(2. / (unit * relative_contact_modulus(surface, patches[k])));
  return scaling;
}

/** Returns the patches of one side as a grid of equal boxes; none if they are not. */
template <int dim>
std::optional<GridBlock> grid_of(const ContactSurface<dim> &surface,
                                 const std::vector<unsigned int> &patches,
                                 const double omega_0)
{
  const Patch<dim> &first = surface.patches()[patches.front()];
  if (!surface.side(first).is_flat())
    return {};
  const auto extent = first.upper - first.lower;
  Point<dim - 1> lower = first.lower, upper = first.upper;
  for (const unsigned int k : patches)
    for (unsigned int d = 0; d < dim - 1; ++d)
    {
      const Patch<dim> &patch = surface.patches()[k];
      lower[d] = std::min(lower[d], patch.lower[d]);
      upper[d] = std::max(upper[d], patch.upper[d]);
      if (std::abs(patch.upper[d] - patch.lower[d] - extent[d]) > 1e-6 * extent[d])
        return {};
    }
  std::array<unsigned int, 2> sizes = {1, 1};
  std::array<double, 2> lengths = {0., 0.};
  for (unsigned int d = 0; d < dim - 1; ++d)
  {
    lengths[d] = upper[d] - lower[d];
    sizes[d] = static_cast<unsigned int>(std::lround(lengths[d] / extent[d]));
  }
  if (sizes[0] * sizes[1] != patches.size())
    return {};
  GridBlock block = {CosineGrid(sizes, lengths, omega_0),
                     std::vector<unsigned int>(patches.size(), 0)};
  std::vector<bool> taken(patches.size());
  for (const unsigned int k : patches)
  {
    std::array<unsigned int, 2> place = {0, 0};
    for (unsigned int d = 0; d < dim - 1; ++d)
    {
      const double steps = (surface.patches()[k].lower[d] - lower[d]) / extent[d];
      place[d] = static_cast<unsigned int>(std::lround(steps));
      if (std::abs(steps - place[d]) > 1e-3 || place[d] >= sizes[d])
        return {};
    }
    const unsigned int number = place[0] + sizes[0] * place[1];
    if (taken[number])
      return {};
    taken[number] = true;
    block.multipliers[number] = k;
  }
  return block;
}

/** Returns the numbers of the patches of each side that has some. */
template <int dim>
std::vector<std::vector<unsigned int>> patches_by_side(const ContactSurface<dim> &surface)
{
  std::vector<std::vector<unsigned int>> side_data(surface.scene().geometry.sides.size());
  for (unsigned int k = 0; k < surface.patches().size(); ++k)
    side_data[surface.patches()[k].side].push_back(k);
  side_data.erase(std::remove_if(side_data.begin(),
                                 side_data.end(),
                                 [](const std::vector<unsigned int> &s) { return s.empty(); }),
                  side_data.end());
  return side_data;
}

template <int dim>
FlatPatch<dim> flat_patch(const ContactSurface<dim> &surface, const Patch<dim> &patch)
{
  const Side<dim> &side = surface.side(patch);
  FlatPatch<dim> flat = {side.point(patch.lower), {}, patch.measure};
  for (unsigned int d = 0; d < dim - 1; ++d)
  {
    Point<dim - 1> end = patch.lower;
    end[d] = patch.upper[d];
    flat.edges[d] = side.point(end) - flat.corner;
  }
  return flat;
}
} // namespace

template <int dim>
std::shared_ptr<const BoundaryModel> make_boundary_model(const MultiplierSpace<dim> &multipliers)
{
  require_constants(multipliers);
  const ContactSurface<dim> &surface = multipliers.surface();
  // Waves longer than the body is thick do not behave as on a half-space. Of 1, 1.5, 2 and 2.5 this
  // factor gave the smallest conditions.
  const double omega_0 = 1.5 / surface.scene().geometry.shortest_extent();
  std::vector<GridBlock> blocks;
  for (const std::vector<unsigned int> &patches : patches_by_side(surface))
  {
    std::optional<GridBlock> block = grid_of(surface, patches, omega_0);
    if (!block)
      return make_kernel_model(multipliers);
    blocks.push_back(std::move(*block));
  }
  return std::make_shared<const CosineModel>(
    std::move(blocks), scaling_of(surface, surface.patches()), max_factorised_set_size(dim));
}

template <int dim>
std::shared_ptr<const BoundaryModel> make_kernel_model(const MultiplierSpace<dim> &multipliers)
{
  require_constants(multipliers);
  return make_kernel_model(multipliers.surface(), multipliers.surface().patches());
}

template <int dim>
std::shared_ptr<const BoundaryModel> make_kernel_model(const ContactSurface<dim> &surface,
                                                       const std::vector<Patch<dim>> &patches)
{
  const auto m = static_cast<unsigned int>(patches.size());
  if (m > max_kernel_patches)
    throw ComputationError("The kernel of the half space is a dense matrix: found " +
                           std::to_string(m) + " contact patches, allowed: at most " +
                           std::to_string(max_kernel_patches) + ".");
  // The logarithm is definite where R exceeds the capacity of the surface.
  const double radius = surface.scene().geometry.diameter();
  const Vector scaling = scaling_of(surface, patches);
  std::vector<FlatPatch<dim>> flat;
  for (const Patch<dim> &patch : patches)
    flat.push_back(flat_patch(surface, patch));
  FullMatrix<double> C(m, m);
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j <= i; ++j)
    {
      C(i, j) = scaling[i] * scaling[j] / numbers::PI * patch_interaction(flat[i], flat[j], radius);
      C(j, i) = C(i, j);
    }
  return std::make_shared<const KernelModel>(std::move(C));
}

template std::shared_ptr<const BoundaryModel> make_boundary_model(const MultiplierSpace<2> &);
template std::shared_ptr<const BoundaryModel> make_boundary_model(const MultiplierSpace<3> &);
template std::shared_ptr<const BoundaryModel> make_kernel_model(const MultiplierSpace<2> &);
template std::shared_ptr<const BoundaryModel> make_kernel_model(const MultiplierSpace<3> &);
template std::shared_ptr<const BoundaryModel> make_kernel_model(const ContactSurface<2> &,
                                                                const std::vector<Patch<2>> &);
template std::shared_ptr<const BoundaryModel> make_kernel_model(const ContactSurface<3> &,
                                                                const std::vector<Patch<3>> &);
} // namespace Signorini
