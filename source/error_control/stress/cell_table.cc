// SPDX-License-Identifier: LGPL-2.1-or-later
// The misfit of a cell as a matrix, which congruent cells share.

#include <signorini/error_control/stress/cell_table.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Signorini {
namespace {
/** Returns the smallest eigenvalue of Hooke's law, in the orthonormal components (s11, s22, sqrt(2)
 * s12). */
double min_eigenvalue_of(const Tensor<2, 3> &C) {
  // Most laws have axes along x and y, and they are evaluated at every point.
  if (C[0][2] == 0. && C[1][2] == 0.)
    return std::min(0.5 * (C[0][0] + C[1][1]) - std::hypot(0.5 * (C[0][0] - C[1][1]), C[0][1]),
                    2. * C[2][2]);
  const double root = std::sqrt(2.);
  return eigenvalues(SymmetricTensor<2, 3>(
    {C[0][0], C[1][1], 2. * C[2][2], C[0][1], root * C[0][2], root * C[1][2]}))[2];
}

std::array<std::vector<TrianglePart>, 4> whole_triangles(const CellShape &shape) {
  return {
    {{{shape.triangle(0)}}, {{shape.triangle(1)}}, {{shape.triangle(2)}}, {{shape.triangle(3)}}}};
}
} // namespace

Law::Law(const SymmetricTensor<4, 2> &hooke) {
  constexpr std::array<std::array<unsigned int, 2>, 3> pairs = {{{{0, 0}}, {{1, 1}}, {{0, 1}}}};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      stiffness[i][j] = hooke[pairs[i][0]][pairs[i][1]][pairs[j][0]][pairs[j][1]];
  compliance = invert(stiffness);
  min_eigenvalue = min_eigenvalue_of(stiffness);
}

Tensor<2, 3> Law::root() const {
  Tensor<2, 3> L;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j <= i; ++j) {
      const double rest = stiffness[i][j] - L[i] * L[j];
      L[i][j] = i == j ? std::sqrt(rest) : rest / L[j][j];
    }
  return L;
}

CellPoints::CellPoints(const CellShape &shape, const Quadrature<2> &rule,
                       const std::array<std::vector<TrianglePart>, 4> &parts,
                       const PrescribedLift *const lift, const unsigned int cell)
  : shape_(shape)
  , composite_(shape) {
  points_.reserve(rule.size() *
                  (parts[0].size() + parts[1].size() + parts[2].size() + parts[3].size()));
  for (unsigned int k = 0; k < 4; ++k)
    for (const TrianglePart &part : parts[k]) {
      const std::size_t begin = points_.size();
      const Triangle &x = part.corners;
      for (unsigned int q = 0; q < rule.size(); ++q) {
        const Point<2> &at = rule.point(q);
        add_point(k, (x[0] - shape.corners[0]) + at[0] * (x[1] - x[0]) + at[1] * (x[2] - x[0]),
                  rule.weight(q) * twice_area(x));
      }
      if (!part.resolved)
        unresolved_.push_back({begin, points_.size()});
    }
  if (lift != nullptr)
    for (PointOfCell &point : points_)
      point.lift = lift->strain(cell, shape, shape.reference(point.offset));
}

CellPoints::CellPoints(const CellShape &shape, const Quadrature<2> &rule)
  : CellPoints(shape, rule, whole_triangles(shape)) {}

void CellPoints::add_point(const unsigned int triangle, const Tensor<1, 2> &offset,
                           const double weight) {
  PointOfCell &point = points_.emplace_back();
  point.at = shape_.reference(offset);
  point.offset = offset;
  point.weight = weight;
  point.triangle = triangle;
  point.lambda = barycentric(shape_.triangle(triangle), shape_.corners[0] + offset);
  const CellFunctions functions(point.at);
  const Tensor<2, 2> jacobian = shape_.jacobian(functions, true), inverse = invert(jacobian);
  if (shape_.is_curved) {
    point.offset = shape_.offset(functions, true);
    point.weight *= determinant(jacobian) / determinant(shape_.jacobian(functions, false));
  }
  for (unsigned int i = 0; i < CellFunctions::n_functions; ++i)
    point.gradients[i] = functions.gradients[i] * inverse;
}

std::vector<Law> CellPoints::laws(const Material<2> &material, const Point<2> &corner) const {
  std::vector<Law> laws;
  laws.reserve(points_.size());
  for (const PointOfCell &point : points_)
    laws.emplace_back(material.hooke(corner + point.offset));
  return laws;
}

Components CellPoints::PointOfCell::strain(const CellVector &data, const unsigned int begin,
                                           const unsigned int end) const {
  Components e;
  for (unsigned int i = begin; i < end; ++i) {
    const double *const u = &data[CellColumns::corners + 2 * i];
    e[0] += gradients[i][0] * u[0];
    e[1] += gradients[i][1] * u[1];
    e[2] += gradients[i][1] * u[0] + gradients[i][0] * u[1];
  }
  return e;
}

namespace {
CellLoad load_of(const CellVector &data) {
  CellLoad load;
  for (unsigned int i = 0; i < 4; ++i)
    load.slope[i / 2][i % 2] = data[CellColumns::slope + i];
  return load;
}
} // namespace

CellPoints::CornerValues CellPoints::linear_stress(const CellVector &data,
                                                   const CellLoad &load) const {
  std::array<double, CompositeCell::n_data> loads;
  std::copy(data.begin(), data.begin() + loads.size(), loads.begin());
  if (shape_.affine) {
    const CellMoments moments = load.moments(shape_);
    for (unsigned int j = 0; j < moments.size(); ++j)
      loads[j] -= moments[j];
  }
  CornerValues result{};
  for (unsigned int i = 0; i < result.size(); ++i)
    for (unsigned int j = 0; j < loads.size(); ++j)
      result[i] += composite_(i, j) * loads[j];
  return result;
}

Components CellPoints::stress(const PointOfCell &point, const CornerValues &linear,
                              const CellLoad &load) const {
  Components s;
  for (unsigned int m = 0; m < 3; ++m)
    for (unsigned int c = 0; c < 3; ++c)
      s[c] += point.lambda[m] * linear[9 * point.triangle + 3 * m + c];
  return shape_.affine ? s + load.stress(shape_, point.at) : s;
}

CellIntegrals CellPoints::integrate(const std::vector<Law> &laws, const CellVector &data,
                                    const CellVector &held, const bool from_above,
                                    CellEnergy *const S) const {
  constexpr unsigned int n_corners = CellFunctions::n_corners, n = CellFunctions::n_functions;
  const CellLoad load = load_of(data);
  const CornerValues linear = linear_stress(data, load);
  // Of the stress and of both misfits, and the squares of these and of z and z'.
  std::array<CornerValues, 3> strains{};
  std::vector<Tensor<1, 5>> squares;
  CellIntegrals result;
  result.is_resolved = unresolved_.empty();
  result.min_eigenvalue = laws[0].min_eigenvalue;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const PointOfCell &point = points_[i];
    const Law &law = laws[laws.size() == 1 ? 0 : i];
    result.min_eigenvalue = std::min(result.min_eigenvalue, law.min_eigenvalue);
    const Components s = stress(point, linear, load), z = data[CellColumns::lift] * point.lift;
    std::array<Components, 5> e;
    e[0] = law.compliance * s;
    e[1] = point.strain(data, 0, n_corners) + z - e[0];
    e[2] = e[1] + point.strain(data, n_corners, n);
    e[3] = z;
    e[4] = held[CellColumns::lift] * point.lift + point.strain(held, n_corners, n);
    Tensor<1, 5> &square = squares.emplace_back();
    for (unsigned int q = 0; q < 5; ++q)
      square[q] = point.weight * (q == 0 ? s * e[0] : e[q] * (law.stiffness * e[q]));
    for (unsigned int q = 0; q < 3; ++q)
      for (unsigned int j = 0; j < 9; ++j)
        strains[q][9 * point.triangle + j] +=
          (q == 0 ? 1. : -1.) * point.weight * point.lambda[j / 3] * e[q][j % 3];
  }
  for (const Range &part : unresolved_) {
    double area = 0.;
    for (std::size_t i = part.begin; i < part.end; ++i)
      area += points_[i].weight;
    for (unsigned int q = 0; q < 5 && from_above; ++q) {
      double largest = 0.;
      for (std::size_t i = part.begin; i < part.end; ++i)
        largest = std::max(largest, squares[i][q] / points_[i].weight);
      for (std::size_t i = part.begin; i < part.end; ++i)
        squares[i][q] = largest * points_[i].weight;
    }
  }
  const Tensor<1, 5> sum = std::accumulate(squares.begin(), squares.end(), Tensor<1, 5>());
  const std::array<Square *, 3> parts = {
    {&result.stress, &result.misfit, &result.interpolated_part}};
  for (unsigned int q = 0; q < 3; ++q) {
    parts[q]->value = sum[q];
    for (unsigned int i = 0; i < strains[q].size(); ++i)
      for (unsigned int j = 0; j < CompositeCell::n_moments; ++j)
        parts[q]->gradient[j] += composite_(i, j) * strains[q][i];
  }
  result.lift = sum[3];
  result.interpolated_lift = sum[4];
  if (S != nullptr)
    *S = energy(laws);
  return result;
}

CellEnergy CellPoints::energy(const std::vector<Law> &laws) const {
  constexpr unsigned int n = CompositeCell::n_moments;
  // The integrals of products of barycentric coordinates and the compliance; strains of the
  // moments.
  std::array<std::array<Tensor<2, 3>, 9>, 4> integrals;
  std::array<CellMoments, CompositeCell::n_stresses> strains{};
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const PointOfCell &point = points_[i];
    const Tensor<2, 3> compliance = point.weight * laws[laws.size() == 1 ? 0 : i].compliance;
    for (unsigned int m = 0; m < 9; ++m)
      integrals[point.triangle][m] += point.lambda[m / 3] * point.lambda[m % 3] * compliance;
  }
  for (unsigned int i = 0; i < strains.size(); ++i)
    for (unsigned int k = 0; k < 9; ++k) {
      const double factor = integrals[i / 9][3 * (i % 9 / 3) + k / 3][i % 3][k % 3];
      for (unsigned int j = 0; j < n; ++j)
        strains[i][j] += factor * composite_(i - i % 9 + k, j);
    }
  CellEnergy S{};
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int k = 0; k < strains.size(); ++k)
      for (unsigned int j = 0; j < n; ++j)
        S[i][j] += composite_(k, i) * strains[k][j];
  return S;
}

CellMatrix::CellMatrix(const CellPoints &points, const Law &law)
  : min_eigenvalue_(law.min_eigenvalue) {
  const Tensor<2, 3> root = transpose(law.root());
  std::array<std::vector<double>, CellColumns::end> values;
  for (unsigned int j = 0; j < values.size(); ++j) {
    CellVector unit{};
    unit[j] = 1.;
    const CellLoad load = load_of(unit);
    const CellPoints::CornerValues linear = points.linear_stress(unit, load);
    for (const CellPoints::PointOfCell &point : points.points_) {
      const Components misfit = point.strain(unit, 0, CellFunctions::n_functions) -
                                law.compliance * points.stress(point, linear, load);
      const Components row = std::sqrt(point.weight) * (root * misfit);
      values[j].insert(values[j].end(), row.begin_raw(), row.end_raw());
    }
    // Gram-Schmidt: R is as accurate as Householder's, whatever the columns are.
    const auto product = [&](const unsigned int i) {
      return std::inner_product(values[i].begin(), values[i].end(), values[j].begin(), 0.);
    };
    for (unsigned int i = 0; i < j; ++i) {
      const double factor = columns_[j][i] = product(i);
      std::transform(values[j].begin(), values[j].end(), values[i].begin(), values[j].begin(),
                     [factor](const double a, const double b) { return a - factor * b; });
    }
    const double norm = columns_[j][j] = std::sqrt(product(j));
    for (double &value : values[j])
      value /= norm > 0. ? norm : 1.;
  }
}

template <unsigned int begin, unsigned int end>
void CellMatrix::add(const CellVector &v, CellVector &y) const {
  for (unsigned int j = begin; j < end; ++j)
    for (unsigned int i = 0; i < end; ++i)
      y[i] += columns_[j][i] * v[j];
}

Square CellMatrix::square(const CellVector &y) const {
  Square result;
  result.value = std::inner_product(y.begin(), y.end(), y.begin(), 0.);
  for (unsigned int j = 0; j < CompositeCell::n_moments; ++j)
    for (unsigned int i = 0; i <= j; ++i)
      result.gradient[j] += columns_[j][i] * y[i];
  return result;
}

CellIntegrals CellMatrix::integrate(const CellVector &data, const CellVector &held) const {
  CellIntegrals result;
  result.min_eigenvalue = min_eigenvalue_;
  CellVector y{};
  add<0, CellColumns::corners>(data, y);
  result.stress = square(y);
  add<CellColumns::corners, CellColumns::bubbles>(data, y);
  result.misfit = square(y);
  add<CellColumns::bubbles, CellColumns::lift>(data, y);
  result.interpolated_part = square(y);
  y = {};
  add<CellColumns::bubbles, CellColumns::lift>(held, y);
  result.interpolated_lift = std::inner_product(y.begin(), y.end(), y.begin(), 0.);
  return result;
}

CellEnergy CellMatrix::energy() const {
  CellEnergy S{};
  for (unsigned int i = 0; i < S.size(); ++i)
    for (unsigned int j = 0; j < S.size(); ++j)
      S[i][j] = std::inner_product(columns_[i].begin(), columns_[i].begin() + S.size(),
                                   columns_[j].begin(), 0.);
  return S;
}

CellTable::CellTable(const EdgeMesh &mesh, const Scene<2> &scene, const PrescribedLift &lift)
  : mesh_(mesh)
  , material_(*scene.material)
  , lift_(lift) {
  const std::size_t n_cells = mesh.cells().size();
  if (material_.is_constant())
    constant_law_.emplace(material_.hooke(mesh.cells()[0].corners[0]));
  else {
    lines_ = scene.kinks.lines();
    sampling_.emplace(material_, n_cells);
  }
  shape_of_.resize(n_cells, alone);
  for (unsigned int c = 0; c < n_cells; ++c)
    shape_of_[c] = classify(c);
}

unsigned int CellTable::classify(const unsigned int cell) {
  const EdgeCell &here = mesh_.cells()[cell];
  const auto &x = here.corners;
  if (here.is_curved || lift_.cells()[cell] || !crossing(lines_, CellShape(here)).empty())
    return alone;
  const std::array<Tensor<1, 2>, 3> edges = {{x[1] - x[0], x[2] - x[0], x[3] - x[0]}};
  const auto is_same = [&](const Shape &other) {
    for (unsigned int i = 0; i < 3; ++i)
      if ((edges[i] - other.edges[i]).norm_square() > 1e-24 * edges[1].norm_square())
        return false;
    return true;
  };
  const auto found = std::find_if(shapes_.begin(), shapes_.end(), is_same);
  if (found != shapes_.end() || shapes_.size() == max_shapes)
    return found != shapes_.end() ? found - shapes_.begin() : alone;
  const CellShape shape(here);
  // With a constant law on a parallelogram, products have the degree six.
  const bool exact = constant_law_ && shape.affine;
  Shape &added = shapes_.emplace_back(
    Shape{edges, CellPoints(shape, exact ? exact_rule_ : rule_), OscillationConstants(shape), {}});
  if (constant_law_)
    added.matrix.emplace(added.points, *constant_law_);
  return shapes_.size() - 1;
}

CellPoints CellTable::own_points(const unsigned int cell, const bool divide) const {
  const EdgeCell &here = mesh_.cells()[cell];
  const CellShape shape(here);
  const bool has_lift = lift_.cells()[cell];
  std::vector<KinkLine<2>> lines = lines_;
  if (has_lift) {
    const std::vector<KinkLine<2>> of_lift = lift_.lines(cell, here.corners);
    lines.insert(lines.end(), of_lift.begin(), of_lift.end());
  }
  const auto parts = triangle_parts(shape, lines, divide ? &*sampling_ : nullptr);
  return {shape, has_lift ? lift_rule_ : rule_, parts, has_lift ? &lift_ : nullptr, cell};
}

bool CellTable::varies(const unsigned int cell, const std::vector<Law> &laws) const {
  // As many points as a scan of a fine mesh would have, and the factor of LawSampling is far away.
  const auto is_close = [&](const Law &law) {
    return (law.stiffness - laws[0].stiffness).norm() * laws[0].compliance.norm() < 0.1;
  };
  return (sampling_->intervals() > LawSampling::min_intervals ||
          !std::all_of(laws.begin(), laws.end(), is_close)) &&
         LawSampling::varies(sampling_->scan(mesh_.cells()[cell].corners));
}

CellIntegrals CellTable::integrate(const unsigned int cell, const CellVector &data,
                                   const CellVector &held, const bool from_above,
                                   CellEnergy *const energy) const {
  const Shape *const shape = shape_of_[cell] < shapes_.size() ? &shapes_[shape_of_[cell]] : nullptr;
  if (shape != nullptr && constant_law_)
    return shape->matrix->integrate(data, held);
  std::optional<CellPoints> own;
  const CellPoints *points =
    shape != nullptr ? &shape->points : &own.emplace(own_points(cell, false));
  if (constant_law_)
    return points->integrate({*constant_law_}, data, held, from_above, energy);
  const Point<2> &corner = mesh_.cells()[cell].corners[0];
  std::vector<Law> laws = points->laws(material_, corner);
  if (varies(cell, laws)) {
    points = &own.emplace(own_points(cell, true));
    laws = points->laws(material_, corner);
  }
  return points->integrate(laws, data, held, from_above, energy);
}

CellEnergies::CellEnergies(const CellTable &table, const std::size_t n_cells) {
  for (const CellTable::Shape &shape : table.shapes())
    if (shape.matrix)
      matrices_.push_back(shape.matrix->energy());
  n_shared_ = matrices_.size();
  unsigned int n = n_shared_;
  for (unsigned int cell = 0; cell < n_cells; ++cell) {
    const std::optional<unsigned int> shared = table.shared(cell);
    index_.push_back(shared ? *shared : n++);
  }
  matrices_.resize(n);
}

CellMoments multiply(const CellEnergy &S, const CellMoments &b) {
  CellMoments y{};
  // The matrix is symmetric: its rows are its columns.
  for (unsigned int j = 0; j < b.size(); ++j)
    if (b[j] != 0.)
      for (unsigned int i = 0; i < b.size(); ++i)
        y[i] += S[j][i] * b[j];
  return y;
}
} // namespace Signorini
