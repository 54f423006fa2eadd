// SPDX-License-Identifier: LGPL-2.1-or-later
// The stress of the bound, from the residuals of the discrete solution.

#include <signorini/base/parallel.h>
#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/error_control/stress/balance.h>
#include <signorini/error_control/stress/equilibrated_stress.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>
#include <signorini/problem/scene/corners.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Signorini {
namespace {
/** The corners of a cell in [0,1]². */
const std::array<Point<2>, 4> unit_corners = {{{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}}};
} // namespace

std::string EquilibratedStress::objection(const BoundData &data) {
  return find_contradiction(data.scene);
}

EquilibratedStress::EquilibratedStress(const BoundData &data)
  : data_(data)
  , mesh_(data.space, data.scene)
  , lift_(data, mesh_)
  , table_(mesh_, data.scene, lift_)
  , loads_(make_loads(data, mesh_))
  , given_(given_tractions(data, mesh_)) {
  if (data.space.mesh().has_parents() && !mesh_.is_curved())
    find_bubbles();
  const auto R = residuals();
  const std::vector<double> guess = mean_tractions();
  if (mesh_.is_curved()) {
    balance_couples(R);
    give_to_contact(mesh_, data.scene, solve_stars(mesh_, R, given_.moments, guess).rest, given_);
  }
  const EdgeMoments start = solve_stars(mesh_, R, given_.moments, guess);
  moments_ = start.moments;
  double largest = 0.;
  for (const CornerForces &forces : R)
    for (const Tensor<1, 2> &force : forces)
      largest = std::max(largest, force.norm());
  for (std::size_t v = 0; v < start.rest.size() && largest > 0.; ++v)
    algebra_ = std::max(algebra_, start.rest[v].norm() * mesh_.stars()[v].cells.size() / largest);
  balance_cells(mesh_, start.rest, moments_);
  CellEnergies energies(table_, mesh_.cells().size());
  integrals_.resize(mesh_.cells().size());
  for_each_cell(
    [&](const std::size_t cell) { integrals_[cell] = integrate(cell, false, &energies); });
  const std::vector<double> change = improve(energies);
  for_each_cell([&](const std::size_t cell) { update(energies, cell, change); });
}

void EquilibratedStress::balance_couples(const std::vector<CornerForces> &R) {
  loads_.resize(mesh_.cells().size());
  couples_.assign(mesh_.cells().size(), 0.);
  for (unsigned int c = 0; c < mesh_.cells().size(); ++c) {
    const EdgeCell &cell = mesh_.cells()[c];
    if (!cell.is_curved)
      continue;
    double moment = 0.;
    for (unsigned int a = 0; a < 4; ++a)
      moment -= cross(cell.corners[a] - cell.corners[0], R[c][a] + loads_[c].nodal[a]);
    couples_[c] = loads_[c].add_couple(CellShape(cell.corners), moment);
  }
}

double EquilibratedStress::geometry(const unsigned int cell, const double min_eigenvalue) const {
  const EdgeCell &here = mesh_.cells()[cell];
  if (!here.is_curved)
    return 0.;
  const CornerValues u = displacement(here);
  double sum = table_.constants(cell).body * couples_[cell];
  for (unsigned int k = 0; k < 4; ++k) {
    const Edge &edge = mesh_.edges()[here.edges[k]];
    if (!edge.is_boundary() || edge.is_held())
      continue;
    const Tensor<2, 2> s =
      stress_of_u(here, u, unit_corners[k] + 0.5 * (unit_corners[(k + 1) % 4] - unit_corners[k]));
    sum += 4. * here.bulges[k].norm() / edge.length * (s * here.edge_vector(k)).norm() /
           edge.length *
           turning_constant(edge.length, CellShape(here.corners).area() / edge.length);
  }
  return sum / std::sqrt(min_eigenvalue);
}

unsigned int EquilibratedStress::n_threads() const {
  return n_available_threads(data_.space.mesh().communicator());
}

EquilibratedStress::CornerValues EquilibratedStress::displacement(const EdgeCell &cell) const {
  CornerValues values;
  for (unsigned int a = 0; a < 4; ++a)
    for (unsigned int c = 0; c < 2; ++c)
      values[a][c] = data_.U[mesh_.dofs()[cell.vertices[a]][c]];
  return values;
}

EquilibratedStress::CornerValues EquilibratedStress::deformation(const EdgeCell &cell) const {
  CornerValues values = displacement(cell);
  for (unsigned int a = 4; a-- > 0;)
    values[a] -= values[0];
  return values;
}

Tensor<2, 2> EquilibratedStress::stress_of_u(const EdgeCell &cell, const CornerValues &u,
                                             const Point<2> &at) const {
  const CellShape shape(cell.corners);
  const CellFunctions functions(at);
  const Tensor<2, 2> inverse = invert(shape.jacobian(functions, false));
  std::array<Tensor<1, 2>, 4> gradients;
  for (unsigned int a = 0; a < 4; ++a)
    gradients[a] = functions.gradients[a] * inverse;
  const Law law = table_.law(cell.corners[0] + shape.offset(functions, false));
  const Components s = law.stiffness * strain_of(gradients, u);
  return Tensor<2, 2>({{s[0], s[2]}, {s[2], s[1]}});
}

std::vector<CornerForces> EquilibratedStress::residuals() {
  constexpr std::array<unsigned int, 4> vertex_in_circle = {{0, 1, 3, 2}};
  const double unit = stiffness_unit(data_.space, *data_.scene.material);
  const auto cells = cells_in_order(data_.space);
  std::vector<CornerForces> R(cells.size());
  std::vector<double> energies(cells.size(), 0.);
  work_on_ranges(n_threads(), cells.size(), [&](const std::size_t begin, const std::size_t end) {
    CellStiffness<2> stiffness(data_.space, data_.scene);
    for (std::size_t i = begin; i < end; ++i) {
      const FullMatrix<double> &K = stiffness(cells[i]);
      const CornerValues u = deformation(mesh_.cells()[i]);
      for (unsigned int a = 0; a < 4; ++a)
        for (unsigned int c = 0; c < 2; ++c) {
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

std::vector<double> EquilibratedStress::mean_tractions() const {
  std::vector<double> moments(mesh_.n_moments(), 0.);
  for (const EdgeCell &cell : mesh_.cells()) {
    const CornerValues u = deformation(cell);
    CellMoments here;
    std::array<Tensor<2, 2>, 4> s;
    // Laws may jump on edges.
    for (unsigned int a = 0; a < 4; ++a)
      s[a] = stress_of_u(cell, u, unit_corners[a] + 0.01 * (Point<2>(0.5, 0.5) - unit_corners[a]));
    for (unsigned int k = 0; k < 4; ++k) {
      const Tensor<1, 2> normal = cross_product_2d(cell.edge_vector(k));
      const Tensor<1, 2> first = s[k] * normal, last = s[(k + 1) % 4] * normal;
      // At the boundary there is no other side.
      const double share = mesh_.edges()[cell.edges[k]].is_boundary() ? 1. : 0.5;
      for (unsigned int c = 0; c < 2; ++c) {
        here[4 * k + c] = share * (2. * first[c] + last[c]) / 6.;
        here[4 * k + 2 + c] = share * (first[c] + 2. * last[c]) / 6.;
      }
    }
    add_moments(cell, here, moments);
  }
  return moments;
}

void EquilibratedStress::find_bubbles() {
  bubbles_.emplace();
  bubbles_->edges.resize(mesh_.edges().size());
  const std::vector<Point<2>> middles = {{0.5, 0.}, {1., 0.5}, {0.5, 1.}, {0., 0.5}, {0.5, 0.5}};
  PatchInterpolation<2> interpolation(data_.space, Quadrature<2>(middles));
  const double rounding = 1e-13 * data_.U.linfty_norm();
  unsigned int number = 0;
  for (const auto &cell : data_.space.dofs().active_cell_iterators()) {
    const std::vector<Tensor<1, 2>> &values = interpolation.values(data_.U, cell);
    const EdgeCell &here = mesh_.cells()[number++];
    const CornerValues u = displacement(here);
    Tensor<1, 2> in_cell = values[4] - 0.25 * (u[0] + u[1] + u[2] + u[3]);
    for (unsigned int k = 0; k < 4; ++k) {
      const Tensor<1, 2> in_middle = values[k] - 0.5 * (u[k] + u[(k + 1) % 4]);
      in_cell -= 0.5 * in_middle;
      if (!mesh_.edges()[here.edges[k]].is_held() || in_middle.norm() > rounding)
        bubbles_->edges[here.edges[k]] = in_middle;
    }
    bubbles_->cells.push_back(in_cell);
  }
}

CellVector EquilibratedStress::data_of(const unsigned int cell) const {
  const EdgeCell &here = mesh_.cells()[cell];
  CellVector data{};
  const CornerValues u = deformation(here);
  for (unsigned int i = 0; i < 8; ++i)
    data[CellColumns::corners + i] = u[i / 2][i % 2];
  if (bubbles_)
    for (unsigned int k = 0; k <= 4; ++k)
      if (k == 4 || !mesh_.edges()[here.edges[k]].is_held())
        for (unsigned int c = 0; c < 2; ++c)
          data[CellColumns::bubbles + 2 * k + c] =
            k == 4 ? bubbles_->cells[cell][c] : bubbles_->edges[here.edges[k]][c];
  data[CellColumns::lift] = lift_.cells()[cell] ? 1. : 0.;
  const CellMoments moments = moments_on(here, moments_);
  std::copy(moments.begin(), moments.end(), data.begin());
  if (!loads_.empty()) {
    for (unsigned int i = 0; i < CompositeCell::n_loads; ++i)
      data[CellColumns::loads + i] = loads_[cell].constant[i / 2][i % 2];
    for (unsigned int i = 0; i < 4; ++i)
      data[CellColumns::slope + i] = loads_[cell].slope[i / 2][i % 2];
  }
  return data;
}

CellIntegrals EquilibratedStress::integrate(const unsigned int cell, const bool from_above,
                                            CellEnergies *const energies) const {
  const CellVector data = data_of(cell);
  // u_D - π^{2h} u_h = (u_D - u_h) - b, b with the coefficients that are held back.
  CellVector held{};
  const EdgeCell &here = mesh_.cells()[cell];
  for (unsigned int k = 0; k < 4 && bubbles_; ++k)
    if (mesh_.edges()[here.edges[k]].is_held()) {
      held[CellColumns::lift] = data[CellColumns::lift];
      for (unsigned int c = 0; c < 2; ++c)
        held[CellColumns::bubbles + 2 * k + c] = -bubbles_->edges[here.edges[k]][c];
    }
  const bool is_own = energies != nullptr && !energies->is_shared(cell);
  return table_.integrate(cell, data, held, from_above, is_own ? &(*energies)(cell) : nullptr);
}

void EquilibratedStress::for_each_cell(const std::function<void(std::size_t)> &visit) const {
  work_on_ranges(n_threads(), mesh_.cells().size(),
                 [&](const std::size_t begin, const std::size_t end) {
                   for (std::size_t cell = begin; cell < end; ++cell)
                     visit(cell);
                 });
}

void EquilibratedStress::update(const CellEnergies &energies, const std::size_t cell,
                                const std::vector<double> &change) {
  // Where more digits than that are lost, the cell is integrated again.
  constexpr double min_share = 1e-6;
  CellIntegrals &here = integrals_[cell];
  const CellMoments b = moments_on(mesh_.cells()[cell], change), Sb = multiply(energies(cell), b);
  bool digits_lost = !here.is_resolved;
  for (Square *const square : {&here.misfit, &here.interpolated_part, &here.stress}) {
    const double before = square->value;
    for (unsigned int j = 0; j < b.size(); ++j)
      square->value += b[j] * (Sb[j] + 2. * square->gradient[j]);
    digits_lost = digits_lost || square->value < min_share * before;
  }
  if (digits_lost)
    here = integrate(cell, true, nullptr);
}

double EquilibratedStress::oscillation(const unsigned int cell, const double min_eigenvalue) const {
  const auto &edges = mesh_.cells()[cell].edges;
  const double force_rest = loads_.empty() ? 0. : loads_[cell].rest;
  const auto has_rest = [&](const unsigned int edge) {
    return given_.normal_rest[edge] + given_.shear_rest[edge] > 0.;
  };
  if (force_rest == 0. && std::none_of(edges.begin(), edges.end(), has_rest))
    return 0.;
  const OscillationConstants constants = table_.constants(cell);
  double sum = constants.body * force_rest;
  for (unsigned int k = 0; k < 4; ++k)
    sum += constants.normal[k] * given_.normal_rest[edges[k]] +
           constants.edge[k] * given_.shear_rest[edges[k]];
  return sum / std::sqrt(min_eigenvalue);
}

double EquilibratedStress::support_work(const unsigned int number, const Tensor<1, 2> &c,
                                        Tensor<1, 2> &force) const {
  const EdgeCell &cell = mesh_.cells()[number];
  const CellMoments moments = moments_on(cell, moments_);
  const CornerValues u = displacement(cell);
  double work = lift_.work(number, moments);
  for (unsigned int j = 0; j < moments.size(); ++j)
    if (mesh_.edges()[cell.edges[j / 4]].is_held()) {
      work += moments[j] * (u[(j / 4 + j % 4 / 2) % 4][j % 2] - c[j % 2]);
      force[j % 2] += moments[j];
    }
  return work;
}

StressBound EquilibratedStress::bound() const {
  StressBound result;
  result.lift_misfit = lift_.max_misfit();
  result.algebra = algebra_;
  result.translation = displacement(mesh_.cells()[0])[0];
  double lift_square = 0., patch_square = 0., patch_lift_square = 0.;
  for (unsigned int c = 0; c < mesh_.cells().size(); ++c) {
    const CellIntegrals &cell = integrals_[c];
    const double misfit = std::sqrt(cell.misfit.value), norm = std::sqrt(cell.stress.value);
    const double rest = oscillation(c, cell.min_eigenvalue);
    const double geometry_part = geometry(c, cell.min_eigenvalue);
    result.misfit.push_back(misfit);
    result.oscillation.push_back(rest);
    result.geometry_square += geometry_part * geometry_part;
    result.square += std::pow(misfit + rest + geometry_part, 2);
    result.oscillation_square += rest * rest;
    const double work = support_work(c, result.translation, result.support_force);
    result.complementary_energy.lower += 0.5 * std::pow(std::max(0., norm - rest), 2) - work;
    result.complementary_energy.upper += 0.5 * std::pow(norm + rest, 2) - work;
    lift_square += cell.lift;
    patch_square += std::pow(std::sqrt(cell.interpolated_part.value) + rest, 2);
    patch_lift_square += cell.interpolated_lift;
  }
  result.lift = std::sqrt(lift_square);
  if (bubbles_)
    result.interpolated_part = {patch_square, std::sqrt(patch_lift_square)};
  return result;
}
} // namespace Signorini
