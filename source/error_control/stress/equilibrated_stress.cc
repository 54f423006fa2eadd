// SPDX-License-Identifier: LGPL-2.1-or-later
// The stress of the bound, from the residuals of the discrete solution.

#include <signorini/base/parallel.h>
#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/error_control/loads/cell_loads.h>
#include <signorini/error_control/loads/cell_rule.h>
#include <signorini/error_control/stress/balance.h>
#include <signorini/error_control/stress/equilibrated_stress.h>
#include <signorini/problem/scene/corners.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Signorini
{
namespace
{
using Vector2 = Tensor<1, 2>;

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
  if (data.space.max_element_degree() > 1)
    return "the displacement has a degree above one, and the bound is for bilinear elements";
  std::string mesh_objection = EdgeMesh::objection(data.space.mesh());
  if (!mesh_objection.empty())
    return mesh_objection;
  std::string support_objection = find_contradiction(data.scene);
  if (!support_objection.empty())
    return support_objection;
  const auto prescribes = [](const BoundaryCondition<2> &condition) {
    return condition.role == Role::displacement;
  };
  const auto &boundary = data.scene.boundary;
  if (std::none_of(boundary.begin(), boundary.end(), prescribes))
    return "";
  const EdgeMesh mesh(data.space, data.scene);
  const PrescribedLift lift(data.scene, mesh, data.U);
  if (lift.max_misfit() > 0.02)
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
  if (data.space.mesh().has_parents() && !mesh_.is_curved())
  {
    bubbles_ = std::make_unique<const PatchBubbles>(data.space, mesh_, data.U);
    forms_ = std::make_unique<const BubbleForms>(table_);
  }
  const auto R = residuals();
  const std::vector<double> guess = mean_tractions();
  if (mesh_.is_curved())
  {
    balance_couples(R);
    give_to_contact(mesh_, data.scene, EdgeMoments(mesh_, R, given_.moments, guess).rest(), given_);
  }
  const EdgeMoments start(mesh_, R, given_.moments, guess);
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
  CellEnergies energies(table_, mesh_.cells().size());
  const std::vector<CellIntegrals> integrals = integrate_all(energies);
  const std::vector<double> change = improve(options, integrals, energies);
  update(integrals, energies, change);
}

void EquilibratedStress::balance_couples(const std::vector<EdgeMoments::CornerForces> &R)
{
  loads_.resize(mesh_.cells().size());
  couples_.assign(mesh_.cells().size(), 0.);
  for (unsigned int c = 0; c < mesh_.cells().size(); ++c)
  {
    const EdgeCell &cell = mesh_.cells()[c];
    if (!cell.is_curved)
      continue;
    double moment = 0.;
    for (unsigned int a = 0; a < 4; ++a)
      moment -= cross(cell.corners[a] - cell.corners[0], R[c][a] + loads_[c].nodal[a]);
    couples_[c] = add_couple(CellShape(cell.corners), moment, loads_[c]);
  }
}

double EquilibratedStress::geometry(const unsigned int cell, const double min_eigenvalue) const
{
  const EdgeCell &here = mesh_.cells()[cell];
  if (!here.is_curved)
    return 0.;
  const CellShape shape(here.corners);
  const auto points = edge_points(shape);
  const CornerValues u = displacement(here);
  double sum = OscillationConstants(shape).body * couples_[cell];
  for (unsigned int k = 0; k < 4; ++k)
  {
    const Edge &edge = mesh_.edges()[here.edges[k]];
    if (edge.side == Edge::no_side || edge.freedom == EdgeFreedom::any)
      continue;
    const Vector2 t = (here.corners[(k + 1) % 4] - here.corners[k]) / edge.length;
    const EdgePoint &point = points[k][0];
    const Components s =
      table_.law(here.corners[0] + point.offset).stress(strain_of(point.gradients, u));
    const Vector2 along({s[0] * t[0] + s[2] * t[1], s[2] * t[0] + s[1] * t[1]});
    sum += 4. * here.bulges[k].norm() / edge.length * along.norm() *
           turning_constant(edge.length, shape.area() / edge.length);
  }
  return sum / std::sqrt(min_eigenvalue);
}

unsigned int EquilibratedStress::n_threads() const
{
  return n_available_threads(data_.space.mesh().communicator());
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

std::vector<EdgeMoments::CornerForces> EquilibratedStress::residuals()
{
  constexpr std::array<unsigned int, 4> vertex_in_circle = {{0, 1, 3, 2}};
  const double unit = stiffness_unit(data_.space, *data_.scene.material);
  const auto cells = cells_in_order(data_.space);
  std::vector<EdgeMoments::CornerForces> R(cells.size());
  std::vector<double> energies(cells.size(), 0.);
  work_on_ranges(n_threads(), cells.size(), [&](const std::size_t begin, const std::size_t end) {
    CellStiffness<2> stiffness(data_.space, data_.scene);
    for (std::size_t i = begin; i < end; ++i)
    {
      const FullMatrix<double> &K = stiffness(cells[i]);
      const CornerValues u = deformation(mesh_.cells()[i]);
      for (unsigned int a = 0; a < 4; ++a)
        for (unsigned int c = 0; c < 2; ++c)
        {
          double sum = 0.;
          for (unsigned int b = 0; b < 4; ++b)
            for (unsigned int d = 0; d < 2; ++d)
              sum += K(2 * vertex_in_circle[a] + c, 2 * vertex_in_circle[b] + d) * u[b][d];
          energies[i] += unit * sum * u[a][c];
          R[i][a][c] = unit * sum - (loads_.empty() ? 0. : loads_[i].nodal[a][c]);
        }
    }
  });
  energy_ = std::accumulate(energies.begin(), energies.end(), 0.);
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
  const CellMoments load_moments = loads_[cell].moments(data.shape);
  for (unsigned int j = 0; j < moments.size(); ++j)
    moments[j] -= load_moments[j];
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

double EquilibratedStress::oscillation(const unsigned int cell,
                                       const double min_eigenvalue,
                                       OscillationTable &table) const
{
  const auto &edges = mesh_.cells()[cell].edges;
  double force_rest = loads_.empty() ? 0. : loads_[cell].rest, edge_rest = 0.;
  for (const unsigned int edge : edges)
    edge_rest += given_.normal_rest[edge] + given_.shear_rest[edge];
  if (force_rest == 0. && edge_rest == 0.)
    return 0.;
  const OscillationConstants &constants = table(table_.shape_of(cell), mesh_.cells()[cell].corners);
  double sum = constants.body * force_rest;
  for (unsigned int k = 0; k < 4; ++k)
    sum += constants.normal[k] * given_.normal_rest[edges[k]] +
           constants.edge[k] * given_.shear_rest[edges[k]];
  return sum / std::sqrt(min_eigenvalue);
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
  OscillationTable constants(table_.n_shapes());
  double lift_square = 0., patch_square = 0., patch_lift_square = 0.;
  for (unsigned int c = 0; c < mesh_.cells().size(); ++c)
  {
    const CellSquares &squares = squares_[c];
    const double misfit = std::sqrt(squares.misfit);
    const double rest = oscillation(c, squares.min_eigenvalue, constants);
    result.misfit.push_back(misfit);
    result.oscillation.push_back(rest);
    const double geometry_part = geometry(c, squares.min_eigenvalue);
    result.geometry_square += geometry_part * geometry_part;
    result.square += std::pow(misfit + rest + geometry_part, 2);
    result.oscillation_square += rest * rest;
    const double norm = std::sqrt(squares.stress);
    const double work = support_work(c, result.translation, result.support_force);
    result.complementary_energy.lower += 0.5 * std::pow(std::max(0., norm - rest), 2) - work;
    result.complementary_energy.upper += 0.5 * std::pow(norm + rest, 2) - work;
    lift_square += squares.lift;
    if (bubbles_)
    {
      const double interpolated_part = std::sqrt(squares.interpolated_part) + rest;
      patch_square += interpolated_part * interpolated_part;
      patch_lift_square += squares.interpolated_lift;
    }
  }
  result.lift = std::sqrt(lift_square);
  if (bubbles_)
    result.interpolated_part = {patch_square, std::sqrt(patch_lift_square)};
  return result;
}
} // namespace Signorini
