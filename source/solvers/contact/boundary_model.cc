// SPDX-License-Identifier: LGPL-2.1-or-later
// Ĉ: the functions that all models share, and the choice of a model for a surface.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/solvers/contact/boundary_model.h>
#include <signorini/solvers/contact/kernel_models.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/numbers.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

namespace Signorini {
namespace {
using Vector = ComplianceOperator::Vector;
using Indices = ComplianceOperator::Indices;

/** The part Ĉ_SS of a model, or (Ĉ⁻¹)_SS. */
struct PartOfModel {
  const BoundaryModel &model;
  const Indices &set;
  bool inverse;

  void vmult(Vector &y, const Vector &x) const {
    Vector all(model.size());
    all.add(set, x);
    const Vector product = inverse ? model.apply_inverse(all) : model.apply(all);
    product.extract_subvector_to(set.begin(), set.end(), y.begin());
  }
};
} // namespace

BoundaryModel::BoundaryModel(const unsigned int max_factorised_size)
  : max_factorised_size_(max_factorised_size) {}

Vector BoundaryModel::solve(const Indices &set, const Vector &rhs) const {
  if (set.empty())
    return Vector();
  return set.size() <= max_factorised_size_ ? solve_by_factor(set, rhs)
                                            : solve_by_gradients(set, rhs);
}

Vector BoundaryModel::solve_by_factor(const Indices &set, const Vector &rhs) const {
  if (set != factorised_set_) {
    const auto n = static_cast<unsigned int>(set.size());
    factorised_set_.clear();
    factor_.reinit(n, n);
    for (unsigned int r = 0; r < n; ++r)
      for (unsigned int c = 0; c <= r; ++c) {
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

Vector BoundaryModel::solve_by_gradients(const Indices &set, const Vector &rhs) const {
  Vector x(rhs.size());
  SolverControl control(500, 1e-10 * rhs.l2_norm(), false, false);
  SolverCG<Vector>(control).solve(PartOfModel{*this, set, false}, x, rhs,
                                  PartOfModel{*this, set, true});
  return x;
}

Vector BoundaryModel::diagonal() const {
  Vector values(size());
  for (unsigned int k = 0; k < size(); ++k)
    values[k] = entry(k, k);
  return values;
}

namespace {
/** Returns the size of sets of patches up to which they are factorised. In 2-D a product with m
 * patches costs m², as a solve with factors does; in 3-D only m^{3/2}. */
constexpr unsigned int max_factorised_set_size(const unsigned int dim) {
  return dim == 2 ? 3000 : 500;
}

/** The maximal number of patches of a dense kernel: 300 MB with its factor. */
constexpr unsigned int max_kernel_patches = 6000;

template <int dim>
void require_constants(const MultiplierSpace<dim> &multipliers) {
  if (!multipliers.is_piecewise_constant())
    throw ComputationError(
      "The model of the compliance of the contact sides needs one multiplier per patch.");
}

/** Returns E'/E_0 at the middle of a patch. */
template <int dim>
double relative_contact_modulus(const ContactSurface<dim> &surface, const Patch<dim> &patch) {
  const auto &[x, n] = surface.middle(patch);
  const auto hooke = surface.scene().material->relative_hooke(x);
  // Σ_j H(n, e_j, n, e_j) is M and one μ for each direction on the surface.
  double M = 0., sum = 0.;
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = 0; b < dim; ++b)
      for (unsigned int j = 0; j < dim; ++j) {
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
Vector scaling_of(const ContactSurface<dim> &surface) {
  const double unit = surface.scene().material->modulus();
  Vector scaling(surface.patches().size());
  for (unsigned int k = 0; k < scaling.size(); ++k)
    scaling[k] = std::sqrt(2. / (unit * relative_contact_modulus(surface, surface.patches()[k])));
  return scaling;
}

/** Returns the corners of a patch on a flat side: its arc lengths, or in space the coordinates
 * along the edges of the first patch, if it is a rectangle with such edges. */
std::optional<std::array<Point<1>, 2>> box_of(const Patch<2> &patch, const Patch<2> & /*first*/) {
  return {{patch.lower, patch.upper}};
}
std::optional<std::array<Point<2>, 2>> box_of(const Patch<3> &patch, const Patch<3> &first) {
  const FaceCorners &corners = first.face.corners;
  std::vector<Point<2>> points(4);
  for (unsigned int d = 0; d < 2; ++d) {
    const Tensor<1, 3> edge = corners[1 + d] - corners[0];
    for (unsigned int v = 0; v < 4; ++v)
      points[v][d] = (patch.face.corners[v] - corners[0]) * edge / edge.norm();
  }
  const auto [lower, upper] = BoundingBox<2>(points).get_boundary_points();
  const Tensor<1, 2> extent = upper - lower;
  if (std::abs(extent[0] * extent[1] - patch.measure) > 1e-6 * patch.measure)
    return {};
  return {{lower, upper}};
}

/** Returns the patches of one contact as a grid of equal boxes; none if they are not. */
template <int dim>
std::optional<CosineGrid> grid_of(const ContactSurface<dim> &surface,
                                  const std::vector<unsigned int> &patches, const double omega_0) {
  const Patch<dim> &first = surface.patches()[patches.front()];
  if (!surface.side(first).is_flat())
    return {};
  std::vector<std::array<Point<dim - 1>, 2>> boxes;
  for (const unsigned int k : patches) {
    const auto box = box_of(surface.patches()[k], first);
    if (!box)
      return {};
    boxes.push_back(*box);
  }
  const Tensor<1, dim - 1> extent = boxes[0][1] - boxes[0][0];
  auto [lower, upper] = boxes[0];
  for (const auto &box : boxes)
    for (unsigned int d = 0; d < dim - 1; ++d) {
      lower[d] = std::min(lower[d], box[0][d]);
      upper[d] = std::max(upper[d], box[1][d]);
      if (std::abs(box[1][d] - box[0][d] - extent[d]) > 1e-6 * extent[d])
        return {};
    }
  std::array<unsigned int, 2> sizes = {1, 1};
  std::array<double, 2> lengths = {0., 0.};
  for (unsigned int d = 0; d < dim - 1; ++d) {
    lengths[d] = upper[d] - lower[d];
    sizes[d] = static_cast<unsigned int>(std::lround(lengths[d] / extent[d]));
  }
  if (sizes[0] * sizes[1] != patches.size())
    return {};
  std::vector<unsigned int> multipliers(patches.size());
  for (std::size_t i = 0; i < patches.size(); ++i) {
    unsigned int number = 0;
    for (unsigned int d = dim - 1; d-- > 0;)
      number = number * sizes[d] +
               static_cast<unsigned int>(std::lround((boxes[i][0][d] - lower[d]) / extent[d]));
    multipliers[number] = patches[i];
  }
  return CosineGrid(sizes, lengths, omega_0, multipliers);
}
} // namespace

template <int dim>
std::shared_ptr<const BoundaryModel> make_boundary_model(const MultiplierSpace<dim> &multipliers) {
  require_constants(multipliers);
  const ContactSurface<dim> &surface = multipliers.surface();
  // Waves longer than the body is thick do not behave as on a half-space. Of 1, 1.5, 2 and 2.5 this
  // factor gave the smallest conditions.
  const double omega_0 = 1.5 / surface.scene().geometry.shortest_extent();
  std::map<unsigned int, std::vector<unsigned int>> patches_by_contact;
  for (unsigned int k = 0; k < surface.patches().size(); ++k)
    patches_by_contact[surface.patches()[k].contact].push_back(k);
  std::vector<CosineGrid> blocks;
  for (const auto &[contact, patches] : patches_by_contact) {
    std::optional<CosineGrid> block = grid_of(surface, patches, omega_0);
    if (!block)
      return make_kernel_model(multipliers);
    blocks.push_back(std::move(*block));
  }
  return std::make_shared<const CosineModel>(std::move(blocks), scaling_of(surface),
                                             max_factorised_set_size(dim));
}

template <int dim>
std::shared_ptr<const BoundaryModel> make_kernel_model(const MultiplierSpace<dim> &multipliers) {
  require_constants(multipliers);
  const ContactSurface<dim> &surface = multipliers.surface();
  const std::vector<Patch<dim>> &patches = surface.patches();
  const auto m = static_cast<unsigned int>(patches.size());
  if (m > max_kernel_patches)
    throw ComputationError("The kernel of the half space is a dense matrix: found " +
                           std::to_string(m) + " contact patches, allowed: at most " +
                           std::to_string(max_kernel_patches) + ".");
  // The logarithm is definite where R exceeds the capacity of the surface.
  const double radius = surface.scene().geometry.diameter();
  const Vector scaling = scaling_of(surface);
  std::vector<Point<dim>> centres;
  // Charges at these heights above the surface and below it act on each other like two patches, in
  // a way that is definite. An alternating pressure on equal patches has the energy that it should.
  std::vector<double> heights;
  for (const Patch<dim> &patch : patches) {
    centres.push_back(surface.middle(patch).x);
    heights.push_back(dim == 2 ? 0.145 * patch.measure : 0.2 * std::sqrt(patch.measure));
  }
  FullMatrix<double> C(m, m);
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j <= i; ++j) {
      const double r = std::hypot(centres[i].distance(centres[j]), heights[i] + heights[j]);
      C(i, j) = C(j, i) = scaling[i] * scaling[j] / numbers::PI * patches[i].measure *
                          patches[j].measure * (dim == 2 ? -std::log(r / radius) : 0.5 / r);
    }
  return std::make_shared<const KernelModel>(std::move(C));
}

INSTANTIATE_FUNCTION(make_boundary_model);
INSTANTIATE_FUNCTION(make_kernel_model);
} // namespace Signorini
