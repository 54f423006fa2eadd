// SPDX-License-Identifier: LGPL-2.1-or-later
// The misfit of a cell as a matrix, which congruent cells share.

#include <signorini/error_control/stress/cell_table.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>

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

/** Returns the lower triangular L with L Lᵀ = C. */
Tensor<2, 3> cholesky(const Tensor<2, 3> &C) {
  Tensor<2, 3> L;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j <= i; ++j) {
      const double rest = C[i][j] - L[i] * L[j];
      L[i][j] = i == j ? std::sqrt(rest) : rest / L[j][j];
    }
  return L;
}

/** Returns the lines that run through the interior of a cell. */
std::vector<KinkLine<2>> crossing(const std::vector<KinkLine<2>> &lines, const EdgeCell &cell) {
  std::vector<KinkLine<2>> result;
  for (const KinkLine<2> &line : lines) {
    double low = 0., high = 0., size = 0.;
    for (const auto &corner : cell.corners) {
      low = std::min(low, line.signed_distance(corner));
      high = std::max(high, line.signed_distance(corner));
      size = std::max(size, corner.distance(cell.corners[0]));
    }
    if (low < -Kinks<2>::tolerance * size && high > Kinks<2>::tolerance * size)
      result.push_back(line);
  }
  return result;
}

/** Returns the parts of triangles on both sides of a line, as triangles. */
std::vector<Triangle> cut(const std::vector<Triangle> &triangles, const KinkLine<2> &line) {
  std::vector<Triangle> parts;
  for (const Triangle &x : triangles)
    for (const double sign : {1., -1.}) {
      std::vector<Point<2>> polygon;
      for (unsigned int i = 0; i < 3; ++i) {
        const auto &a = x[i], &b = x[(i + 1) % 3];
        const double da = sign * line.signed_distance(a), db = sign * line.signed_distance(b);
        if (da >= 0.)
          polygon.push_back(a);
        if (da * db < 0.)
          polygon.push_back(a + (da / (da - db)) * (b - a));
      }
      for (unsigned int i = 2; i < polygon.size(); ++i) {
        const Triangle part = {{polygon[0], polygon[i - 1], polygon[i]}};
        if (twice_area(part) > 1e-14 * twice_area(x))
          parts.push_back(part);
      }
    }
  return parts;
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
  root = cholesky(stiffness);
  inverse_root = invert(root);
  min_eigenvalue = min_eigenvalue_of(stiffness);
}

CellBasis::CellBasis(const CellShape &shape, const Quadrature<2> &rule,
                     const std::array<std::vector<TrianglePart>, 4> &parts,
                     const PrescribedLift *const lift, const unsigned int cell) {
  const CompositeCell composite(shape);
  points.reserve(rule.size() *
                 (parts[0].size() + parts[1].size() + parts[2].size() + parts[3].size()));
  for (unsigned int k = 0; k < 4; ++k)
    for (const TrianglePart &part : parts[k]) {
      const std::size_t begin = points.size();
      const Triangle &x = part.corners;
      for (unsigned int q = 0; q < rule.size(); ++q) {
        const Point<2> &at = rule.point(q);
        add_point(shape, composite, k,
                  (x[0] - shape.corners[0]) + at[0] * (x[1] - x[0]) + at[1] * (x[2] - x[0]),
                  rule.weight(q) * twice_area(x));
      }
      if (!part.resolved)
        unresolved.push_back({begin, points.size()});
    }
  if (lift != nullptr)
    for (PointOfCell &point : points) {
      const Components z = lift->strain(cell, shape, shape.reference(point.offset));
      for (unsigned int i = 0; i < 3; ++i)
        point.components[i][CellColumns::lift] = z[i];
    }
}

CellBasis::CellBasis(const CellShape &shape, const Quadrature<2> &rule)
  : CellBasis(shape, rule, whole_triangles(shape)) {}

void CellBasis::add_point(const CellShape &shape, const CompositeCell &composite,
                          const unsigned int triangle, const Tensor<1, 2> &offset,
                          const double weight) {
  const Point<2> at = shape.reference(offset);
  const CellFunctions functions(at);
  const Tensor<2, 2> jacobian = shape.jacobian(functions, true);
  PointOfCell &point = points.emplace_back();
  point.offset = offset;
  point.weight = weight;
  if (shape.is_curved) {
    point.offset = shape.offset(functions, true);
    point.weight *= determinant(jacobian) / determinant(shape.jacobian(functions, false));
  }
  const Tensor<2, 2> inverse = invert(jacobian);
  auto &[s11, s22, s12] = point.components;
  for (unsigned int i = 0; i < CellFunctions::n_functions; ++i) {
    const Tensor<1, 2> gradient = functions.gradients[i] * inverse;
    s11[2 * i] = s12[2 * i + 1] = gradient[0];
    s12[2 * i] = s22[2 * i + 1] = gradient[1];
  }
  const auto lambda = barycentric(shape.triangle(triangle), shape.corners[0] + offset);
  for (unsigned int c = 0; c < 3; ++c)
    for (unsigned int m = 0; m < 3; ++m)
      for (unsigned int j = 0; j < CompositeCell::n_data; ++j)
        point.components[c][CellColumns::moments + j] -=
          lambda[m] * composite(9 * triangle + 3 * m + c, j);
  if (!shape.affine)
    return;
  for (unsigned int q = 0; q < 4; ++q) {
    CellLoad load;
    load.slope[q / 2][q % 2] = 1.;
    const CellMoments moments = load.moments(shape);
    const Components s = load.stress(shape, at);
    for (unsigned int c = 0; c < 3; ++c) {
      auto &row = point.components[c];
      row[CellColumns::slope + q] = -s[c];
      for (unsigned int j = 0; j < moments.size(); ++j)
        row[CellColumns::slope + q] -= row[CellColumns::moments + j] * moments[j];
    }
  }
}

CellMatrix::CellMatrix(const CellBasis &basis, const std::vector<Law> &laws)
  : rows_(3 * basis.points.size())
  , unresolved_(basis.unresolved)
  , min_eigenvalue_(laws[0].min_eigenvalue) {
  for (std::size_t i = 0; i < basis.points.size(); ++i) {
    const CellBasis::PointOfCell &point = basis.points[i];
    const Law &law = laws[laws.size() == 1 ? 0 : i];
    weights_.push_back(point.weight);
    min_eigenvalue_ = std::min(min_eigenvalue_, law.min_eigenvalue);
    const Tensor<2, 3> of_strain = std::sqrt(point.weight) * transpose(law.root),
                       of_stress = std::sqrt(point.weight) * law.inverse_root;
    for (unsigned int r = 0; r < 3; ++r) {
      CellVector &row = rows_[3 * i + r];
      row.fill(0.);
      // G is lower triangular.
      for (unsigned int c = r; c < 3; ++c)
        for (unsigned int j = 0; j < CellColumns::moments; ++j)
          row[j] += of_strain[r][c] * point.components[c][j];
      for (unsigned int c = 0; c <= r; ++c)
        for (unsigned int j = CellColumns::moments; j < CellColumns::end; ++j)
          row[j] += of_stress[r][c] * point.components[c][j];
    }
  }
}

void CellMatrix::compress() {
  constexpr unsigned int n = CellColumns::end;
  // With columns of the norm one, small columns keep their digits.
  CellVector norms{};
  for (const CellVector &row : rows_)
    for (unsigned int j = 0; j < n; ++j)
      norms[j] = std::hypot(norms[j], row[j]);
  LAPACKFullMatrix<double> matrix(rows_.size(), n);
  for (unsigned int i = 0; i < rows_.size(); ++i)
    for (unsigned int j = 0; j < n; ++j)
      matrix(i, j) = norms[j] > 0. ? rows_[i][j] / norms[j] : 0.;
  matrix.compute_svd();
  rows_.resize(n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      rows_[i][j] = matrix.singular_value(i) * matrix.get_svd_vt()(i, j) * norms[j];
}

void CellMatrix::add(const CellVector &v, const unsigned int begin, const unsigned int end,
                     Values &y) const {
  for (std::size_t i = 0; i < y.size(); ++i)
    for (unsigned int j = begin; j < end; ++j)
      y[i] += rows_[i][j] * v[j];
}

CellMoments CellMatrix::moments_of(const Values &y) const {
  CellMoments result{};
  for (std::size_t i = 0; i < y.size(); ++i)
    for (unsigned int j = 0; j < result.size(); ++j)
      result[j] += rows_[i][CellColumns::moments + j] * y[i];
  return result;
}

CellEnergy CellMatrix::energy() const {
  CellEnergy S{};
  for (const CellVector &row : rows_)
    for (unsigned int i = 0; i < S.size(); ++i)
      for (unsigned int j = 0; j < S.size(); ++j)
        S[i][j] += row[CellColumns::moments + i] * row[CellColumns::moments + j];
  return S;
}

double CellMatrix::square(const Values &y, const bool from_above) const {
  double sum = 0.;
  for (const double value : y)
    sum += value * value;
  if (!from_above)
    return sum;
  for (const CellBasis::Range &part : unresolved_) {
    double area = 0., largest = 0.;
    for (std::size_t i = part.begin; i < part.end; ++i) {
      const double at_point =
        y[3 * i] * y[3 * i] + y[3 * i + 1] * y[3 * i + 1] + y[3 * i + 2] * y[3 * i + 2];
      sum -= at_point;
      area += weights_[i];
      largest = std::max(largest, at_point / weights_[i]);
    }
    sum += area * largest;
  }
  return sum;
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
  if (here.is_curved || lift_.cells()[cell] || !crossing(lines_, here).empty() || varies(cell))
    return alone;
  const std::array<Tensor<1, 2>, 3> edges = {{x[1] - x[0], x[2] - x[0], x[3] - x[0]}};
  const auto is_same = [&](const Shape &other) {
    for (unsigned int i = 0; i < 3; ++i)
      if ((edges[i] - other.edges[i]).norm() > 1e-12 * edges[1].norm())
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
    Shape{edges, CellBasis(shape, exact ? exact_rule_ : rule_), OscillationConstants(shape), {}});
  if (constant_law_) {
    added.matrix.emplace(added.basis, std::vector<Law>{*constant_law_});
    added.matrix->compress();
  }
  return shapes_.size() - 1;
}

bool CellTable::varies(const unsigned int cell) const {
  return sampling_ && LawSampling::varies(sampling_->scan(mesh_.cells()[cell].corners));
}

CellBasis CellTable::own_basis(const unsigned int cell) const {
  const EdgeCell &here = mesh_.cells()[cell];
  const CellShape shape(here);
  const bool has_lift = lift_.cells()[cell];
  std::vector<KinkLine<2>> lines = crossing(lines_, here);
  if (has_lift) {
    const std::vector<KinkLine<2>> of_lift = lift_.lines(cell, here);
    lines.insert(lines.end(), of_lift.begin(), of_lift.end());
  }
  LawSampling::Samples samples;
  if (sampling_)
    samples = sampling_->scan(here.corners);
  const bool divide = sampling_ && LawSampling::varies(samples);
  std::array<std::vector<TrianglePart>, 4> parts;
  for (unsigned int k = 0; k < 4; ++k) {
    std::vector<Triangle> triangles = {shape.triangle(k)};
    for (const KinkLine<2> &line : lines)
      triangles = cut(triangles, line);
    for (const Triangle &triangle : triangles)
      if (divide)
        sampling_->divide(triangle, samples, shape.diameter() / sampling_->intervals(), parts[k]);
      else
        parts[k].push_back({triangle});
  }
  return {shape, has_lift ? lift_rule_ : rule_, parts, has_lift ? &lift_ : nullptr, cell};
}

const CellMatrix &CellTable::matrix(const unsigned int cell, std::optional<CellMatrix> &own) const {
  const bool shares_basis = shape_of_[cell] < shapes_.size();
  if (shares_basis && constant_law_)
    return *shapes_[shape_of_[cell]].matrix;
  std::optional<CellBasis> own_points;
  if (!shares_basis)
    own_points.emplace(own_basis(cell));
  const CellBasis &basis = shares_basis ? shapes_[shape_of_[cell]].basis : *own_points;
  std::vector<Law> laws;
  if (constant_law_)
    laws = {*constant_law_};
  else
    for (const CellBasis::PointOfCell &point : basis.points)
      laws.emplace_back(material_.hooke(mesh_.cells()[cell].corners[0] + point.offset));
  return own.emplace(basis, laws);
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
    for (unsigned int i = 0; i < b.size(); ++i)
      y[i] += S[j][i] * b[j];
  return y;
}
} // namespace Signorini
