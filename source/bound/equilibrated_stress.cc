// SPDX-License-Identifier: LGPL-2.1-or-later
// The stress of the bound, from the residuals of the discrete solution.

#include <signorini/bound/balance.h>
#include <signorini/bound/best_change.h>
#include <signorini/bound/equilibrated_stress.h>
#include <signorini/bound/oscillation.h>
#include <signorini/bound/pointwise.h>
#include <signorini/elasticity/cell_stiffness.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using Vector2 = dealii::Tensor<1, 2>;

/** Adds half of the moments of a traction that is sampled at the points of an edge. */
void add_edge(const std::array<EdgePoint, 2> &points,
              const std::array<Vector2, 2> &tractions,
              const unsigned int k,
              CellMoments &moments)
{
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int c = 0; c < 2; ++c)
    {
      moments[4 * k + c] += 0.25 * (1. - points[i].position) * tractions[i][c];
      moments[4 * k + 2 + c] += 0.25 * points[i].position * tractions[i][c];
    }
}
} // namespace

std::string EquilibratedStress::objection(const StressData &data)
{
  const std::string of_mesh = EdgeMesh::objection(data.space.mesh());
  if (!of_mesh.empty())
    return of_mesh;
  const EdgeMesh mesh(data.space, data.scene);
  const PrescribedLift lift(data.scene, mesh, data.U);
  if (lift.largest_jump() > 1e-10)
    return "the prescribed displacements jump at a corner, and no displacement of finite energy "
           "takes them";
  if (lift.largest_misfit() > 0.02)
    return "the prescribed displacements jump, or vary too fast within the edge of a cell";
  return "";
}

EquilibratedStress::EquilibratedStress(const StressData &data, const ImprovementOptions &options)
  : data_(data)
  , mesh_(data.space, data.scene)
  , lift_(data.scene, mesh_, data.U)
  , table_(mesh_, data.scene, data.scene.body_force != nullptr, lift_)
  , loads_(make_loads(data.space, data.scene, mesh_, data.n_points))
  , given_(given_tractions(data.space, data.scene, mesh_, data.multipliers, data.P, data.n_points))
{
  if (data.space.mesh().has_parents())
    bubbles_ = std::make_unique<const PatchBubbles>(data.space, mesh_, data.U);
  const auto R = residuals();
  const EdgeMoments start(mesh_, R, given_.moments, mean_tractions());
  moments_ = start.moments();
  double largest = 0.;
  for (const auto &forces : R)
    for (const Vector2 &force : forces)
      largest = std::max(largest, force.norm());
  for (std::size_t v = 0; v < start.rest().size(); ++v)
    if (largest > 0.)
      algebra_ =
        std::max(algebra_, start.rest()[v].norm() * mesh_.stars()[v].cells.size() / largest);
  balanced_ = balance_cells(mesh_, start.rest(), moments_);
  improve(options);
}

CellLoad EquilibratedStress::load(const unsigned int cell) const
{
  return loads_.empty() ? CellLoad() : loads_[cell];
}

EquilibratedStress::CornerValues EquilibratedStress::displacement(const EdgeCell &cell) const
{
  CornerValues values;
  for (unsigned int a = 0; a < 4; ++a)
    for (unsigned int c = 0; c < 2; ++c)
      values[a][c] = data_.U[mesh_.dofs()[cell.vertices[a]][c]];
  return values;
}

EquilibratedStress::CornerValues EquilibratedStress::deformation(const EdgeCell &cell) const
{
  CornerValues values = displacement(cell);
  for (unsigned int a = 4; a-- > 0;)
    values[a] -= values[0];
  return values;
}

std::vector<EdgeMoments::CornerForces> EquilibratedStress::residuals() const
{
  constexpr std::array<unsigned int, 4> vertex_in_circle = {{0, 1, 3, 2}};
  CellStiffness<2> stiffness(data_.space, data_.scene);
  const double unit = stiffness_unit(data_.space, *data_.scene.material);
  std::vector<EdgeMoments::CornerForces> R(mesh_.cells().size());
  unsigned int number = 0;
  for (const auto &cell : data_.space.mesh().triangulation().active_cell_iterators())
  {
    const dealii::FullMatrix<double> &K = stiffness(cell);
    const CornerValues u = deformation(mesh_.cells()[number]);
    for (unsigned int a = 0; a < 4; ++a)
      for (unsigned int c = 0; c < 2; ++c)
      {
        double sum = 0.;
        for (unsigned int b = 0; b < 4; ++b)
          for (unsigned int d = 0; d < 2; ++d)
            sum += K(2 * vertex_in_circle[a] + c, 2 * vertex_in_circle[b] + d) * u[b][d];
        R[number][a][c] = unit * sum;
      }
    if (!loads_.empty())
      for (unsigned int a = 0; a < 4; ++a)
        R[number][a] -= loads_[number].nodal[a];
    ++number;
  }
  return R;
}

std::vector<double> EquilibratedStress::mean_tractions() const
{
  std::vector<double> moments(mesh_.n_moments(), 0.);
  for (unsigned int c = 0; c < mesh_.cells().size(); ++c)
  {
    const EdgeCell &cell = mesh_.cells()[c];
    const auto on_edges = table_.on_edges(c);
    const CornerValues u = deformation(cell);
    CellMoments here{};
    for (unsigned int k = 0; k < 4; ++k)
    {
      const Vector2 d = cell.corners[(k + 1) % 4] - cell.corners[k];
      std::array<Vector2, 2> tractions;
      for (unsigned int i = 0; i < 2; ++i)
      {
        const EdgePoint &point = on_edges[k][i];
        const Components s =
          table_.law(cell.corners[0] + point.offset).stress(strain_of(point.gradients, u));
        tractions[i] = Vector2({s[0] * d[1] - s[2] * d[0], s[2] * d[1] - s[1] * d[0]});
        // At the boundary there is no other side.
        if (mesh_.edges()[cell.edges[k]].side != Edge::no_side)
          tractions[i] *= 2.;
      }
      add_edge(on_edges[k], tractions, k, here);
    }
    add_moments(cell, here, moments);
  }
  return moments;
}

CompositeCell::Stresses EquilibratedStress::stresses(const unsigned int cell,
                                                     const CellData &data) const
{
  CellMoments moments = moments_on(mesh_.cells()[cell], moments_);
  if (loads_.empty())
    return data.composite.stress(moments);
  const CellMoments of_load = loads_[cell].moments(data.shape);
  for (unsigned int j = 0; j < moments.size(); ++j)
    moments[j] -= of_load[j];
  return data.composite.stress(moments, loads_[cell].constant);
}

std::vector<Components> EquilibratedStress::stress(const unsigned int cell,
                                                   const CellData &data) const
{
  const CompositeCell::Stresses linear = stresses(cell, data);
  std::vector<Components> values;
  values.reserve(data.points.size());
  for (const StressPoint &point : data.points)
  {
    Components s = stress_at(linear, point.triangle, point.psi);
    if (!loads_.empty() && data.shape.affine)
    {
      const Components more = loads_[cell].stress(data.shape, point.reference);
      for (unsigned int i = 0; i < 3; ++i)
        s[i] += more[i];
    }
    values.push_back(s);
  }
  return values;
}

Components EquilibratedStress::strain(const unsigned int cell,
                                      const StressPoint &point,
                                      const CornerValues &u) const
{
  const Components of_u_h = strain_of(point.gradients, u);
  if (!lift_.cells()[cell])
    return of_u_h;
  return sum(of_u_h, lift_.strain(cell, point));
}

EquilibratedStress::CellSquares EquilibratedStress::integrate(const unsigned int cell,
                                                              const CellData &data) const
{
  const std::vector<Law> &laws = table_.laws(cell, data);
  const std::vector<Components> tau = stress(cell, data);
  const CornerValues u = deformation(mesh_.cells()[cell]);
  UpperSum misfit_square, stress_square, lift_square;
  double smallest_eigenvalue = laws[0].smallest_eigenvalue;
  for (std::size_t i = 0; i < data.points.size(); ++i)
  {
    const StressPoint &point = data.points[i];
    const Law &law = law_at(laws, i);
    const Components misfit = difference(law.stress(strain(cell, point, u)), tau[i]);
    misfit_square.add(point, contraction(misfit, law.strain(misfit)));
    stress_square.add(point, contraction(tau[i], law.strain(tau[i])));
    if (lift_.cells()[cell])
    {
      const Components e = lift_.strain(cell, point);
      lift_square.add(point, contraction(e, law.stress(e)));
    }
    smallest_eigenvalue = std::min(smallest_eigenvalue, law.smallest_eigenvalue);
  }
  return {misfit_square.value(), stress_square.value(), lift_square.value(), smallest_eigenvalue};
}

double EquilibratedStress::oscillation(const unsigned int cell,
                                       const CellShape &shape,
                                       const double smallest_eigenvalue) const
{
  const auto &edges = mesh_.cells()[cell].edges;
  double of_force = loads_.empty() ? 0. : loads_[cell].rest, of_edges = 0.;
  for (const unsigned int edge : edges)
    of_edges += given_.normal_rest[edge] + given_.shear_rest[edge];
  if (of_force == 0. && of_edges == 0.)
    return 0.;
  const OscillationConstants constants(shape);
  double sum = constants.body * of_force;
  for (unsigned int k = 0; k < 4; ++k)
    sum += constants.normal[k] * given_.normal_rest[edges[k]] +
           constants.edge[k] * given_.shear_rest[edges[k]];
  return sum / std::sqrt(smallest_eigenvalue);
}

double EquilibratedStress::support_work(const unsigned int number,
                                        const Vector2 &c,
                                        Vector2 &force) const
{
  const EdgeCell &cell = mesh_.cells()[number];
  const auto is_held = [&](const unsigned int k) {
    const Edge &edge = mesh_.edges()[cell.edges[k]];
    return edge.side != Edge::no_side && edge.freedom == EdgeFreedom::any;
  };
  if (!is_held(0) && !is_held(1) && !is_held(2) && !is_held(3))
    return 0.;
  const CellMoments moments = moments_on(cell, moments_);
  const CornerValues u = displacement(cell);
  double work = lift_.work(number, moments);
  for (unsigned int k = 0; k < 4; ++k)
    if (is_held(k))
      for (unsigned int end = 0; end < 2; ++end)
        for (unsigned int d = 0; d < 2; ++d)
        {
          const double moment = moments[4 * k + 2 * end + d];
          work += moment * (u[(k + end) % 4][d] - c[d]);
          force[d] += moment;
        }
  return work;
}

StressBound EquilibratedStress::bound() const
{
  StressBound result;
  result.algebra = algebra_;
  result.balanced = balanced_;
  result.steps = steps_;
  result.restarts = restarts_;
  result.translation = displacement(mesh_.cells()[0])[0];
  double lift_square = 0., patch_square = 0., patch_lift_square = 0.;
  for (unsigned int c = 0; c < mesh_.cells().size(); ++c)
  {
    const CellData &data = table_(c);
    const CellSquares squares = integrate(c, data);
    const double misfit = std::sqrt(squares.misfit);
    const double rest = oscillation(c, data.shape, squares.smallest_eigenvalue);
    result.misfit.push_back(misfit);
    result.oscillation.push_back(rest);
    result.square += (misfit + rest) * (misfit + rest);
    result.oscillation_square += rest * rest;
    const double norm = std::sqrt(squares.stress);
    const double work = support_work(c, result.translation, result.support_force);
    result.complementary_energy.lower += 0.5 * std::pow(std::max(0., norm - rest), 2) - work;
    result.complementary_energy.upper += 0.5 * std::pow(norm + rest, 2) - work;
    lift_square += squares.lift;
    if (bubbles_)
    {
      const double of_patches = std::sqrt(patch_misfit_square(c, data, squares.misfit)) + rest;
      patch_square += of_patches * of_patches;
      patch_lift_square += bubbles_->holds_back(c) ? patch_lift_energy(c, data) : squares.lift;
    }
  }
  result.lift = std::sqrt(lift_square);
  if (bubbles_)
    result.of_patches = {patch_square, std::sqrt(patch_lift_square)};
  return result;
}
} // namespace Signorini
