// SPDX-License-Identifier: LGPL-2.1-or-later
// What u_h lacks on sides with prescribed displacements.

#include <signorini/bound/prescribed_rest.h>
#include <signorini/mesh/cut_quadrature.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using dealii::GeometryInfo;
using dealii::Point;
using dealii::Tensor;
using CellIterator = dealii::DoFHandler<2>::active_cell_iterator;

constexpr unsigned int n_parts = 16, n_depths = 7;

/** rho on one edge of a cell. */
class Rest
{
public:
  Rest(const Scene<2> &scene,
       const CellIterator &cell,
       const unsigned int face_no,
       const NodalVector &U)
    : data_(*scene.boundary[cell->face(face_no)->boundary_id()].data)
  {
    for (unsigned int end = 0; end < 2; ++end)
    {
      const unsigned int v = GeometryInfo<2>::face_to_cell_vertices(face_no, end);
      ends_[end] = cell->vertex(v);
      for (unsigned int d = 0; d < 2; ++d)
        u_[end][d] = U[cell->vertex_dof_index(v, d)];
    }
    std::vector<double> cuts = scene.kinks.cut(ends_[0], ends_[1]);
    for (unsigned int i = 1; i < n_parts; ++i)
      cuts.push_back(static_cast<double>(i) / n_parts);
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(),
                           cuts.end(),
                           [](const double a, const double b) { return b - a < 1e-9; }),
               cuts.end());
    rule = split_quadrature(dealii::QGauss<1>(4), cuts);
    for (const Point<1> &t : rule.get_points())
    {
      values.push_back(value(t[0]));
      // Closer than the first and last points are to the ends of parts.
      constexpr double step = 1e-6;
      slopes.push_back((value(t[0] + step) - value(t[0] - step)) / (2. * step));
    }
  }

  Tensor<1, 2> value(const double t) const
  {
    const Point<2> x = ends_[0] + t * (ends_[1] - ends_[0]);
    dealii::Vector<double> prescribed(2);
    data_.vector_value(x, prescribed);
    Tensor<1, 2> rho = -(1. - t) * u_[0] - t * u_[1];
    for (unsigned int d = 0; d < 2; ++d)
      rho[d] += prescribed[d];
    return rho;
  }
  double largest() const
  {
    double largest = 0.;
    for (const Tensor<1, 2> &rho : values)
      largest = std::max(largest, rho.norm());
    return largest;
  }

  dealii::Quadrature<1> rule;
  std::vector<Tensor<1, 2>> values, slopes;

private:
  const dealii::Function<2> &data_;
  std::array<Point<2>, 2> ends_;
  std::array<Tensor<1, 2>, 2> u_;
};

/** int_K eps(z):E:eps(z) with a given depth. */
double energy(const Material<2> &material,
              const CellIterator &cell,
              const unsigned int face_no,
              const Rest &rest,
              const double depth)
{
  static const dealii::QGauss<1> gauss(3);
  const unsigned int normal = face_no / 2, tangent = 1 - normal;
  const double inwards = face_no % 2 == 0 ? 1. : -1.;
  double sum = 0.;
  for (unsigned int i = 0; i < rest.rule.size(); ++i)
    for (unsigned int q = 0; q < gauss.size(); ++q)
    {
      const double eta = depth * gauss.point(q)[0], psi = 1. - eta / depth;
      Point<2> x, place;
      x[tangent] = rest.rule.point(i)[0];
      x[normal] = face_no % 2 == 0 ? eta : 1. - eta;
      Tensor<2, 2> J;
      for (const unsigned int v : cell->vertex_indices())
      {
        J += outer_product(Tensor<1, 2>(cell->vertex(v)),
                           GeometryInfo<2>::d_linear_shape_function_gradient(x, v));
        place += GeometryInfo<2>::d_linear_shape_function(x, v) * cell->vertex(v);
      }
      Tensor<1, 2> along, across;
      along[tangent] = psi;
      across[normal] = -inwards / depth;
      const Tensor<2, 2> gradient =
        outer_product(rest.slopes[i], along) + outer_product(rest.values[i], across);
      const auto strain = symmetrize(gradient * invert(J));
      sum += strain * (material.hooke(place) * strain) * std::abs(determinant(J)) *
             rest.rule.weight(i) * depth * gauss.weight(q);
    }
  return sum;
}
} // namespace

PrescribedRest make_prescribed_rest(const DisplacementSpace<2> &space,
                                    const Scene<2> &scene,
                                    const NodalVector &U)
{
  PrescribedRest result;
  const double rounding = 1e-13 * U.linfty_norm(), jump = 1e-9 * U.linfty_norm();
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    double norm = 0.;
    for (const unsigned int face_no : cell->face_indices())
    {
      const auto face = cell->face(face_no);
      if (!face->at_boundary() || scene.boundary[face->boundary_id()].role != Role::displacement)
        continue;
      const Rest rest(scene, cell, face_no, U);
      result.jumps = result.jumps || std::max(rest.value(0.).norm(), rest.value(1.).norm()) > jump;
      if (rest.largest() <= rounding)
        continue;
      double least = energy(*scene.material, cell, face_no, rest, 1.);
      for (unsigned int k = 1; k < n_depths; ++k)
        least = std::min(least, energy(*scene.material, cell, face_no, rest, std::pow(0.5, k)));
      norm += std::sqrt(least);
    }
    result.norms.push_back(norm);
    result.square += norm * norm;
  }
  return result;
}
} // namespace Signorini
