// SPDX-License-Identifier: LGPL-2.1-or-later
// The spaces and couplings of one level, and the partitions that are refused.

#include <signorini/base/columns.h>
#include <signorini/base/errors.h>
#include <signorini/discretization/space/discretization.h>
#include <signorini/problem/scene/contact_pair.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** Returns the number of additional points: on coarse meshes the data varies much from cell to
 * cell, and accurate integrals cost little. */
unsigned int additional_points(const unsigned int n_cells) {
  return n_cells <= 64 ? 6 : n_cells <= 1024 ? 3 : n_cells <= 16384 ? 1 : 0;
}

StrainOperator strain_operator(const Element element) {
  return element == Element::q1_b_bar ? StrainOperator::mean_dilatation
                                      : StrainOperator::symmetric_gradient;
}

unsigned int degree_of(const Element element) {
  return element == Element::q2 ? 2 : 1;
}

/** The maximal number of patches per face. C is singular anyway where patches are finer than faces;
 * those that are far finer even on the finest level only cost time. */
constexpr unsigned int max_patches_per_face = 4;

template <int dim>
void refuse_needless_patches(const Parameters &parameters, const unsigned int level,
                             const ContactSurface<dim> &surface) {
  const unsigned int finer = std::max(parameters.discretization.finest_level.value, level) - level;
  const std::size_t n_faces = surface.faces().size() << ((dim - 1) * finer);
  const std::size_t n_patches = surface.patches().size();
  if (n_patches > max_patches_per_face * n_faces)
    throw InputError(parameters.discretization.patches.where() + ": found " +
                     std::to_string(n_patches) + " patches on the " + std::to_string(n_faces) +
                     " contact faces of the finest level, allowed: at most " +
                     std::to_string(max_patches_per_face) + " per face.");
}

template <int dim>
void refuse_unstable_patches(const Parameters &parameters,
                             const Discretization<dim> &discretization) {
  if (!is_unstable(discretization))
    return;
  const bool has_tangential_part = discretization.surface.scene().contact_law.has_tangential_part();
  if (dim == 3 || has_tangential_part)
    throw InputError(parameters.discretization.coarsest_level.where() + ": found '" +
                     std::to_string(parameters.discretization.coarsest_level.value) +
                     "', where a contact patch is a single face (H = h), which is not stable " +
                     (has_tangential_part ? "with friction" : "in space") +
                     ", allowed: levels or Geometry/Cells with at least two faces per patch"
                     " and direction.");
  if (parameters.solver.require_stability)
    throw InputError(parameters.solver.require_stability.where() +
                     ": a contact patch is no longer than a face (H = h), which is not inf-sup "
                     "stable, allowed: a Patch ratio of at least 2 and levels on which every side "
                     "has at least two faces per patch.");
}

/** Returns the numbers of Gauss points on the faces of every cell, enough for a trace, a multiplier
 * and a component of the normal of a curved face. */
std::vector<unsigned int> points_on_faces(const DisplacementSpace<2> &space) {
  std::vector<unsigned int> n_points = degrees_of(space);
  for (unsigned int &n : n_points)
    n += space.mesh().is_curved() ? 3 : 0;
  return n_points;
}

/** Returns the numbers of unknowns of the patches: P_{p-2} on every face of the carrier of degree
 * p, and on the share θ of a face ⌈θ (p - 1)⌉ of them: more would leave C singular. Constants where
 * the direction of contact changes, as the gap may jump there. */
std::vector<unsigned int> nodes_of_patches(const DisplacementSpace<2> &space,
                                           const ContactSurface<2> &surface) {
  std::vector<unsigned int> n_nodes(surface.patches().size());
  for (const Piece<2> &piece : surface.pieces()) {
    constexpr double rounding = 1e-9;
    const Patch<2> &patch = surface.patches()[piece.patch];
    const double most = space.element(surface.face_of_carrier(piece).cell).degree - 1.;
    n_nodes[piece.patch] =
      patch.mixes ? 1 : static_cast<unsigned int>(std::ceil(patch.share * most - rounding));
  }
  return n_nodes;
}
} // namespace

template <int dim>
Discretization<dim>::Discretization(const Parameters &parameters, const Scene<dim> &scene,
                                    const unsigned int level, MPI_Comm communicator)
  : mesh(timed(times.mesh,
               [&]() {
                 return Mesh<dim>(scene.geometry, parameters.discretization.coarsest_level, level,
                                  communicator);
               }))
  , n_points(parameters.discretization.quadrature_points +
             additional_points(mesh.triangulation().n_global_active_cells()))
  , space(timed(times.setup,
                [&]() {
                  return DisplacementSpace<dim>(mesh, scene,
                                                strain_operator(parameters.discretization.element),
                                                degree_of(parameters.discretization.element));
                }))
  , surface(timed(times.setup,
                  [&]() {
                    return ContactSurface<dim>(
                      mesh, scene,
                      Partition{parameters.discretization.patch_ratio, scene.given_patches()});
                  }))
  , multipliers(surface)
  , n_gap_points(n_points)
  , gap_grading(Grading::towards_kinks) {
  assemble(parameters, scene);
  refuse_needless_patches(parameters, level, surface);
  refuse_unstable_patches(parameters, *this);
}

template <>
Discretization<2>::Discretization(const Parameters &parameters, const Scene<2> &scene,
                                  const MeshPlan &plan)
  : mesh(timed(times.mesh, [&]() { return make_mesh(plan, scene); }))
  , n_points(parameters.discretization.quadrature_points)
  , space(
      timed(times.setup,
            [&]() { return DisplacementSpace<2>(mesh, scene, plan_degrees(plan, scene, mesh)); }))
  , surface(
      timed(times.setup, [&]() { return ContactSurface<2>(mesh, scene, points_on_faces(space)); }))
  , multipliers(surface, nodes_of_patches(space, surface))
  , n_gap_points(n_points + 2)
  , gap_grading(Grading::none) {
  assemble(parameters, scene);
}

template <int dim>
void Discretization<dim>::assemble(const Parameters &parameters, const Scene<dim> &scene) {
  const StageTimer timer(times.setup);
  D = assemble_coupling(space, multipliers);
  K = AdmissibleSet::nonpositive(multipliers.n_multipliers());
  if (scene.contact_law.has_tangential_part()) {
    for (const Component tangent : tangents<dim>())
      D = join(D, assemble_coupling(space, multipliers, tangent));
    dealii::Vector<double> s(multipliers.n_multipliers()), f(s);
    for (const auto &limit : scene.contact_law.limits())
      (limit.follows_pressure ? f : s) = multipliers.project(moments_of(scene, limit.data));
    K = AdmissibleSet::with_tangential_part(s, f, dim - 1);
  }
  condensed_D = condense(D, space.constraints());
  G = assemble_gap_of(scene);
  if (const auto k = condensed_D.empty_column(mesh.communicator()))
    throw InputError(parameters.discretization.coarsest_level.where() + ": contact patch " +
                     std::to_string(*k % multipliers.n_multipliers()) +
                     " sees no free mesh node on the coarsest level, allowed: a finer coarsest "
                     "level, fewer patches or a larger patch ratio.");
}

template <int dim>
dealii::Vector<double> Discretization<dim>::assemble_gap_of(const Scene<dim> &scene) const {
  dealii::Vector<double> G = moments_of(scene, &ContactCondition<dim>::gap);
  if (scene.contact_law.has_tangential_part())
    for (const Component tangent : tangents<dim>())
      G = join(G, moments_of(scene, &ContactCondition<dim>::shift, tangent));
  return G;
}

template <int dim>
dealii::Vector<double> Discretization<dim>::gap_residual(const Displacement &U) const {
  dealii::Vector<double> W = D.transpose_product(U);
  W -= G;
  return W;
}

template <int dim>
dealii::Vector<double> Discretization<dim>::moments_of(
  const Scene<dim> &scene, FunctionPointer<dim> ContactCondition<dim>::*const data,
  const Component component) const {
  return assemble_gap(multipliers, scene.contacts, n_gap_points, gap_grading, data, component);
}

std::vector<unsigned int> degrees_of(const DisplacementSpace<2> &space) {
  std::vector<unsigned int> degrees;
  for (const auto &cell : space.dofs().active_cell_iterators())
    degrees.push_back(cell->get_fe().degree);
  return degrees;
}

template struct Discretization<2>;
template struct Discretization<3>;
} // namespace Signorini
