// SPDX-License-Identifier: LGPL-2.1-or-later
// Data of stresses that congruent cells share.

#include <signorini/base/parallel.h>
#include <signorini/error_control/loads/cell_rule.h>
#include <signorini/error_control/stress/cell_table.h>
#include <signorini/error_control/stress/equilibrated_stress.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>

#include <algorithm>

namespace Signorini
{
namespace
{
/** Returns the lines that run through the interior of a cell. */
std::vector<KinkLine<2>> crossing(const std::vector<KinkLine<2>> &lines, const EdgeCell &cell)
{
  std::vector<KinkLine<2>> result;
  for (const KinkLine<2> &line : lines)
  {
    double low = 0., high = 0., size = 0.;
    for (const auto &corner : cell.corners)
    {
      low = std::min(low, line.signed_distance(corner));
      high = std::max(high, line.signed_distance(corner));
      size = std::max(size, corner.distance(cell.corners[0]));
    }
    if (low < -Kinks<2>::tolerance * size && high > Kinks<2>::tolerance * size)
      result.push_back(line);
  }
  return result;
}
} // namespace

CellTable::CellTable(const EdgeMesh &mesh,
                     const Scene<2> &scene,
                     const bool quadratic,
                     const PrescribedLift &lift)
  : mesh_(mesh)
  , material_(*scene.material)
  , kind_{scene.material->is_constant(), quadratic}
  , lift_(lift)
{
  if (!kind_.constant_law)
  {
    lines_ = scene.kinks.lines();
    sampling_.emplace(material_, mesh.cells().size());
    varied_.reserve(mesh.cells().size());
    for (const EdgeCell &cell : mesh.cells())
      varied_.push_back(LawSampling::varies(sampling_->scan(cell.corners)));
  }
  else
    law_.emplace_back(material_.hooke(mesh.cells()[0].corners[0]));
  shape_of_.reserve(mesh.cells().size());
  for (unsigned int c = 0; c < mesh.cells().size(); ++c)
    shape_of_.push_back(classify(c));
}

unsigned int CellTable::classify(const unsigned int cell)
{
  const auto &corners = mesh_.cells()[cell].corners;
  const std::array<Tensor<1, 2>, 3> edges = {
    {corners[1] - corners[0], corners[2] - corners[0], corners[3] - corners[0]}};
  const double tolerance = 1e-12 * edges[1].norm();
  const auto is_same = [&](const auto &others) {
    for (unsigned int i = 0; i < 3; ++i)
      if ((edges[i] - others[i]).norm() > tolerance)
        return false;
    return true;
  };
  const unsigned int alone = max_shapes + cell;
  if (mesh_.cells()[cell].is_curved || lift_.cells()[cell] || (sampling_ && varied_[cell]) ||
      !crossing(lines_, mesh_.cells()[cell]).empty())
    return alone;
  // The cell before is most likely of the same shape.
  if (cell > 0 && shape_of_[cell - 1] < edges_of_shape_.size() &&
      is_same(edges_of_shape_[shape_of_[cell - 1]]))
    return shape_of_[cell - 1];
  const auto found = std::find_if(edges_of_shape_.begin(), edges_of_shape_.end(), is_same);
  if (found != edges_of_shape_.end())
    return found - edges_of_shape_.begin();
  if (edges_of_shape_.size() == max_shapes)
    return alone;
  edges_of_shape_.push_back(edges);
  shared_.push_back(
    std::make_unique<CellData>(CellShape(corners), kind_, std::vector<KinkLine<2>>()));
  return edges_of_shape_.size() - 1;
}

const CellData &CellTable::data(const unsigned int cell, CellScratch &room) const
{
  if (shape_of_[cell] < max_shapes)
    return *shared_[shape_of_[cell]];
  const EdgeCell &here = mesh_.cells()[cell];
  RuleKind kind = kind_;
  kind.fine = lift_.cells()[cell];
  const CellShape shape(here);
  TriangleDivision divide;
  LawSampling::Samples samples;
  if (sampling_ && varied_[cell])
  {
    samples = sampling_->scan(here.corners);
    divide = [&, least = shape.diameter() / sampling_->intervals()](const auto &triangle) {
      return sampling_->divide(triangle, samples, least);
    };
  }
  std::vector<KinkLine<2>> lines = crossing(lines_, here);
  const std::vector<KinkLine<2>> lift_lines = lift_.lines(cell, here);
  lines.insert(lines.end(), lift_lines.begin(), lift_lines.end());
  room.data = std::make_unique<CellData>(shape, kind, lines, divide);
  return *room.data;
}

const std::vector<Law> &CellTable::laws(const unsigned int cell,
                                        const CellData &data,
                                        CellScratch &room) const
{
  if (kind_.constant_law)
    return law_;
  room.laws.clear();
  for (const StressPoint &point : data.points)
    room.laws.emplace_back(material_.hooke(mesh_.cells()[cell].corners[0] + point.offset));
  return room.laws;
}

CellEnergy make_energy(const CellData &data, const std::vector<Law> &laws)
{
  // Per triangle the products of the nine components.
  std::array<std::array<double, 81>, 4> products{};
  for (std::size_t i = 0; i < data.points.size(); ++i)
  {
    const StressPoint &point = data.points[i];
    const Law &law = laws[laws.size() == 1 ? 0 : i];
    for (unsigned int m = 0; m < 3; ++m)
      for (unsigned int l = 0; l < 3; ++l)
      {
        const double factor = point.weight * point.psi[m] * point.psi[l];
        for (unsigned int r = 0; r < 3; ++r)
          for (unsigned int s = 0; s < 3; ++s)
            products[point.triangle][9 * (3 * m + r) + 3 * l + s] += factor * law.compliance[r][s];
      }
  }
  // Row by row, T with the columns of the composite cell.
  constexpr unsigned int n = CompositeCell::n_moments;
  std::array<std::array<double, n>, CompositeCell::n_stresses> rows;
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < rows.size(); ++i)
      rows[i][j] = data.composite.column(j)[i];
  CellEnergy energy{};
  for (unsigned int k = 0; k < 4; ++k)
    for (unsigned int r = 0; r < 9; ++r)
    {
      std::array<double, n> strain{};
      for (unsigned int s = 0; s < 9; ++s)
        for (unsigned int j = 0; j < n; ++j)
          strain[j] += products[k][9 * r + s] * rows[9 * k + s][j];
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          energy[n * j + i] += strain[j] * rows[9 * k + r][i];
    }
  return energy;
}

// Integrals over the cells of a stress in equilibrium.

Components EquilibratedStress::strain(const unsigned int cell,
                                      const StressPoint &point,
                                      const CornerValues &u) const
{
  const Components strain_of_u_h = strain_of(point.gradients, u);
  if (!lift_.cells()[cell])
    return strain_of_u_h;
  return sum(strain_of_u_h, lift_.strain(cell, point));
}

EquilibratedStress::CellIntegrals EquilibratedStress::integrate(const unsigned int cell,
                                                                CellScratch &room,
                                                                const bool from_above,
                                                                CellEnergies *const energies) const
{
  const CellData &data = table_.data(cell, room);
  const CellState state = {cell,
                           data,
                           table_.laws(cell, data, room),
                           stress(cell, data),
                           deformation(mesh_.cells()[cell]),
                           from_above};
  CellIntegrals result;
  UpperSum misfit_square(from_above), stress_square(from_above), lift_square(from_above);
  double &min_eigenvalue = result.squares.min_eigenvalue;
  min_eigenvalue = state.laws[0].min_eigenvalue;
  CompositeCell::Stresses dual_of_misfit{}, dual_of_stress{};
  for (std::size_t i = 0; i < data.points.size(); ++i)
  {
    const StressPoint &point = data.points[i];
    const Law &law = law_at(state.laws, i);
    const Components &tau = state.tau[i];
    const Components misfit = difference(law.stress(strain(cell, point, state.u)), tau);
    const Components misfit_data = law.strain(misfit), stress_data = law.strain(tau);
    misfit_square.add(point, contraction(misfit, misfit_data));
    stress_square.add(point, contraction(tau, stress_data));
    add_dual(point, misfit_data, dual_of_misfit);
    add_dual(point, stress_data, dual_of_stress);
    if (lift_.cells()[cell])
    {
      const Components e = lift_.strain(cell, point);
      lift_square.add(point, contraction(e, law.stress(e)));
    }
    min_eigenvalue = std::min(min_eigenvalue, law.min_eigenvalue);
    result.is_resolved = result.is_resolved && point.unresolved_part == StressPoint::resolved;
  }
  result.squares.misfit = misfit_square.value();
  result.squares.stress = stress_square.value();
  result.squares.lift = lift_square.value();
  result.misfit_data = data.composite.transposed(dual_of_misfit);
  result.stress_data = data.composite.transposed(dual_of_stress);
  if (bubbles_)
    integrate_patches(state, result);
  if (energies != nullptr && energies->is_first(cell))
    energies->set(cell, make_energy(data, state.laws));
  return result;
}

std::vector<EquilibratedStress::CellIntegrals>
EquilibratedStress::integrate_all(CellEnergies &energies) const
{
  std::vector<CellIntegrals> all(mesh_.cells().size());
  work_on_ranges(n_threads(), all.size(), [&](const std::size_t begin, const std::size_t end) {
    CellScratch room;
    for (std::size_t c = begin; c < end; ++c)
      all[c] = integrate(c, room, false, &energies);
  });
  return all;
}

void EquilibratedStress::update(const std::vector<CellIntegrals> &integrals,
                                const CellEnergies &energies,
                                const std::vector<double> &change)
{
  // Where more digits than that are lost, the cell is integrated again.
  constexpr double min_share = 1e-3;
  squares_.resize(integrals.size());
  work_on_ranges(
    n_threads(), integrals.size(), [&](const std::size_t begin, const std::size_t end) {
      CellScratch room;
      for (std::size_t c = begin; c < end; ++c)
      {
        const CellIntegrals &before = integrals[c];
        CellSquares &squares = squares_[c] = before.squares;
        const CellMoments b = moments_on(mesh_.cells()[c], change), Sb = multiply(energies(c), b);
        for (unsigned int j = 0; j < b.size(); ++j)
        {
          squares.misfit += b[j] * (Sb[j] - 2. * before.misfit_data[j]);
          squares.interpolated_part += b[j] * (Sb[j] - 2. * before.interpolated_part[j]);
          squares.stress += b[j] * (Sb[j] + 2. * before.stress_data[j]);
        }
        if (!before.is_resolved || squares.misfit < min_share * before.squares.misfit ||
            squares.interpolated_part < min_share * before.squares.interpolated_part ||
            squares.stress < min_share * before.squares.stress)
          squares = integrate(c, room, true).squares;
      }
    });
}

// The square of the misfit of π^{2h} u_h, cell by cell.

namespace
{
/** Returns the strain of a function with the given gradient in one component. */
Components strain_of_component(const Tensor<1, 2> &gradient, const unsigned int component)
{
  return component == 0 ? Components{{gradient[0], 0., gradient[1]}}
                        : Components{{0., gradient[1], gradient[0]}};
}
} // namespace

BubbleForm::BubbleForm(const CellShape &shape, const Law &law)
{
  RuleKind kind = {true, false};
  kind.fine = true;
  for (const StressPoint &point : make_rule(shape, kind, {}))
  {
    const BubbleGradients gradients = bubble_gradients(point);
    std::array<Components, n_bubbles> strains;
    for (unsigned int i = 0; i < n_bubbles; ++i)
      strains[i] = strain_of_component(gradients[i / 2], i % 2);
    std::array<Components, 4> slope_stresses;
    for (unsigned int q = 0; q < 4; ++q)
    {
      CellLoad load;
      load.slope[q] = 1.;
      slope_stresses[q] = load.stress(shape, point.reference);
    }
    for (unsigned int i = 0; i < n_bubbles; ++i)
    {
      const Components &e = strains[i], s = law.stress(e);
      auto &row = rows_[i];
      for (unsigned int a = 0; a < first_stress; ++a)
        row[a] +=
          2. * point.weight * contraction(s, strain_of_component(point.gradients[a / 2], a % 2));
      for (unsigned int m = 0; m < 3; ++m)
        for (unsigned int l = 0; l < 3; ++l)
          row[first_stress + 9 * point.triangle + 3 * m + l] -=
            2. * point.weight * e[l] * point.psi[m];
      for (unsigned int q = 0; q < 4; ++q)
        row[first_slope + q] -= 2. * point.weight * contraction(e, slope_stresses[q]);
      for (unsigned int j = 0; j < n_bubbles; ++j)
        row[first_bubble + j] += point.weight * contraction(s, strains[j]);
    }
  }
}

double BubbleForm::change(const PatchBubbles::Coefficients &b, const CellMisfit &misfit) const
{
  std::array<double, n_columns> values;
  for (unsigned int a = 0; a < first_stress; ++a)
    values[a] = misfit.u[a / 2][a % 2];
  std::copy(misfit.stresses.begin(), misfit.stresses.end(), values.begin() + first_stress);
  std::copy(misfit.slope.begin(), misfit.slope.end(), values.begin() + first_slope);
  for (unsigned int i = 0; i < n_bubbles; ++i)
    values[first_bubble + i] = b[i / 2][i % 2];
  double sum = 0.;
  for (unsigned int i = 0; i < n_bubbles; ++i)
  {
    double product = 0.;
    for (unsigned int j = 0; j < n_columns; ++j)
      product += rows_[i][j] * values[j];
    sum += values[first_bubble + i] * product;
  }
  return sum;
}

CompositeCell::Stresses BubbleForm::dual(const PatchBubbles::Coefficients &b) const
{
  CompositeCell::Stresses sum{};
  for (unsigned int i = 0; i < n_bubbles; ++i)
    for (unsigned int j = 0; j < sum.size(); ++j)
      sum[j] -= 0.5 * b[i / 2][i % 2] * rows_[i][first_stress + j];
  return sum;
}

BubbleForms::BubbleForms(const CellTable &table)
  : table_(table)
{
  if (!table.constant_law())
    return;
  for (unsigned int shape = 0; shape < table.n_shapes(); ++shape)
  {
    const CellShape &cell = table.shared(shape).shape;
    forms_.push_back(
      cell.affine ? std::make_unique<const BubbleForm>(cell, table.law(cell.corners[0])) : nullptr);
  }
}

const BubbleForm *BubbleForms::of(const unsigned int cell) const
{
  const unsigned int shape = table_.shape_of(cell);
  return shape < forms_.size() ? forms_[shape].get() : nullptr;
}

// The difference between π^{2h} u_h and u_h.

namespace
{
using Vector2 = Tensor<1, 2>;

/** Returns the middles of the edges of a cell counter-clockwise, and its centre. */
Quadrature<2> bubble_points()
{
  return Quadrature<2>(
    std::vector<Point<2>>{{0.5, 0.}, {1., 0.5}, {0.5, 1.}, {0., 0.5}, {0.5, 0.5}});
}
} // namespace

PatchBubbles::PatchBubbles(const DisplacementSpace<2> &space,
                           const EdgeMesh &mesh,
                           const Displacement &U)
  : mesh_(mesh)
  , edges_(mesh.edges().size())
  , cells_(mesh.cells().size())
{
  PatchInterpolation<2> interpolation(space, bubble_points());
  const double rounding = 1e-13 * U.linfty_norm();
  unsigned int number = 0;
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    const std::vector<Vector2> &values = interpolation.values(U, cell);
    const EdgeCell &here = mesh.cells()[number];
    std::array<Vector2, 4> u;
    for (unsigned int a = 0; a < 4; ++a)
      for (unsigned int c = 0; c < 2; ++c)
        u[a][c] = U[mesh.dofs()[here.vertices[a]][c]];
    Vector2 centre_value = values[4] - 0.25 * (u[0] + u[1] + u[2] + u[3]);
    for (unsigned int k = 0; k < 4; ++k)
    {
      const Vector2 middle_value = values[k] - 0.5 * (u[k] + u[(k + 1) % 4]);
      centre_value -= 0.5 * middle_value;
      const Edge &edge = mesh.edges()[here.edges[k]];
      const bool is_held = edge.side != Edge::no_side && edge.freedom == EdgeFreedom::any;
      if (!is_held)
        edges_[here.edges[k]] = middle_value;
      else if (middle_value.norm() > rounding)
        held_[number][k] = middle_value;
    }
    cells_[number++] = centre_value;
  }
}

BubbleGradients bubble_gradients(const StressPoint &point)
{
  constexpr std::array<double, 4> corner_x = {{-1., 1., 1., -1.}};
  constexpr std::array<double, 4> corner_y = {{-1., -1., 1., 1.}};
  const double x = point.reference[0], y = point.reference[1];
  Vector2 d_x, d_y;
  for (unsigned int c = 0; c < 4; ++c)
  {
    d_x += corner_x[c] * point.gradients[c];
    d_y += corner_y[c] * point.gradients[c];
  }
  // With x in [-1,1], 4 s (1 - s) = 1 - x².
  const double bubble_x = 1. - x * x, bubble_y = 1. - y * y;
  return {{-x * (1. - y) * d_x - 0.5 * bubble_x * d_y,
           0.5 * bubble_y * d_x - y * (1. + x) * d_y,
           -x * (1. + y) * d_x + 0.5 * bubble_x * d_y,
           -0.5 * bubble_y * d_x - y * (1. - x) * d_y,
           -2. * x * bubble_y * d_x - 2. * y * bubble_x * d_y}};
}

Components strain_of(const BubbleGradients &gradients,
                     const PatchBubbles::Coefficients &coefficients)
{
  Components e{};
  for (unsigned int j = 0; j < 5; ++j)
  {
    e[0] += gradients[j][0] * coefficients[j][0];
    e[1] += gradients[j][1] * coefficients[j][1];
    e[2] += gradients[j][1] * coefficients[j][0] + gradients[j][0] * coefficients[j][1];
  }
  return e;
}
} // namespace Signorini
