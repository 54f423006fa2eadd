// SPDX-License-Identifier: LGPL-2.1-or-later
// The energies of stresses on cells with arcs have their digits at high degrees: a cell that is
// turned, so that everything is rounded differently, has the same.

#include <signorini/error_control/equilibration/airy_cell.h>
#include <signorini/error_control/equilibration/triangle_parts.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <complex>

#include "tests.h"

using namespace Signorini;

namespace {
/** Returns the cell between two radii and angles, turned by a further angle. */
CellShape polar_cell(const double inner, const double outer, const double angle, const double turn,
                     const bool inner_is_arc, const bool outer_is_arc) {
  const auto at = [&](const double r, const double a) {
    return Point<2>(r * std::cos(a + turn), r * std::sin(a + turn));
  };
  ArcCentres centres;
  if (outer_is_arc)
    centres[1] = Point<2>();
  if (inner_is_arc)
    centres[3] = Point<2>();
  return CellShape({{at(inner, 0.), at(outer, 0.), at(outer, angle), at(inner, angle)}}, centres);
}

/** Young's modulus 1, Poisson's ratio 0.3, plane strain. */
Law law() {
  constexpr double nu = 0.3, mu = 0.5 / (1. + nu), lambda = nu / ((1. + nu) * (1. - 2. * nu));
  return Law(lambda * outer_product(unit_symmetric_tensor<2>(), unit_symmetric_tensor<2>()) +
             2. * mu * identity_tensor<2>());
}

AiryCell make_cell(const CellShape &shape, const unsigned int degree) {
  const Law hooke = law();
  std::array<std::vector<AiryPoint>, 4> points;
  const auto add = [&](const unsigned int k, const Tensor<1, 2> &from_crossing,
                       const double weight) {
    AiryPoint &point = points[k].emplace_back();
    point.on_diagonals = Point<2>(invert(shape.half_diagonals()) * from_crossing);
    point.weight = weight;
    point.of_stress = std::sqrt(weight) * invert(hooke.root());
  };
  const Quadrature<2> rule = triangle_rule(2 * degree + 4);
  for (unsigned int k = 0; k < 4; ++k)
    if (shape.centres[k]) {
      const ArcLift lift(shape.seen_from_crossing().edge(k), degree);
      for (const auto &[x, weight] : lift.points())
        add(k, x - Point<2>(), weight);
    } else
      for (unsigned int q = 0; q < rule.size(); ++q)
        add(k, point_of(shape.triangle(k), rule.point(q)) - shape.crossing,
            rule.weight(q) * twice_area(shape.triangle(k)));
  return AiryCell(shape, degree, std::move(points));
}

/** A load at half a million points, as on the pieces of a comb, takes the memory of the points. */
void many_points(Checks &checks) {
  constexpr unsigned int n = 500000;
  const AiryCell cell = make_cell(polar_cell(0.5, 1., 1., 0., false, false), 11);
  const std::vector<Point<2>> points(n, Point<2>(0.1, 0.2));
  const std::vector<double> weights(n, 1. / n);
  const std::vector<Tensor<1, 2>> force(n, Tensor<1, 2>({1., 0.}));
  const auto peak = [] {
    Utilities::System::MemoryStats memory;
    Utilities::System::get_memory_stats(memory);
    return memory.VmHWM / 1024.;
  };
  const double before = peak();
  double rest = 0.;
  cell.project(points, weights, force, rest);
  checks.between("MB that a load at many points takes", peak() - before, 0., 20.);
}

/** Returns P S P, where P projects onto the traces in balance that no lift changes. */
FullMatrix<double> balanced_energy(const AiryCell &cell) {
  const FullMatrix<double> &B = cell.balance(), S = cell.penalised_energy(0.);
  const unsigned int n = 8 * (cell.degree() + 1);
  FullMatrix<double> rows(3, S.m()), gram(3), weighted(rows), P(S.m()), SP(P), PSP(P);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int r = 0; r < 3; ++r)
      rows(r, i) = -B(r, i);
  rows.mTmult(gram, rows);
  gram.gauss_jordan();
  gram.mmult(weighted, rows);
  B.Tmmult(P, weighted);
  for (unsigned int i = 0; i < S.m(); ++i)
    for (unsigned int j = 0; j < S.m(); ++j)
      P(i, j) = i < n ? P(i, j) + (i == j ? 1. : 0.) : 0.;
  S.mmult(SP, P);
  P.Tmmult(PSP, SP);
  return PSP;
}

/** Returns the energy of the stress of Airy's function Re z^5, and the least one with its
 * tractions. A displacement has this stress: they are the same. */
std::array<double, 2> compatible_energies(const AiryCell &cell, const CellShape &shape) {
  Vector<double> values(3 * cell.n_points());
  std::size_t at = 0;
  for (const auto &triangle : cell.points())
    for (const AiryPoint &point : triangle) {
      const Tensor<1, 2> x = shape.half_diagonals() * point.on_diagonals;
      const auto power = std::pow(std::complex<double>(x[0], x[1]), 3);
      const Components weighted =
        point.of_stress * Components({-power.real(), power.real(), power.imag()});
      for (unsigned int c = 0; c < 3; ++c)
        values[at++] = weighted[c];
    }
  const double energy = values.norm_sqr();
  Vector<double> traces = cell.project(values);
  traces += cell.project(values);
  return {{energy, traces * cell.multiply(traces)}};
}

void curved_cells(Checks &checks) {
  struct Row {
    std::string name;
    double inner, outer, angle;
    bool inner_is_arc, outer_is_arc;
  };
  for (const Row &row :
       {Row{"ring", 0.75, 1., 0.4, false, true}, Row{"bore", 0.5, 0.75, 0.4, true, false},
        Row{"both", 0.5, 1., 0.7, true, true}, Row{"large arc", 0.3, 1., 1., false, true},
        Row{"small bore", 0.5, 2., 1., true, false}, Row{"long", 0.5, 1., 0.1, false, true},
        Row{"flat", 0.97, 1., 0.4, false, true}})
    for (const unsigned int degree : {9U, 10U, 11U}) {
      checks.about(row.name + ", degree " + std::to_string(degree));
      const auto shape = [&](const double turn) {
        return polar_cell(row.inner, row.outer, row.angle, turn, row.inner_is_arc,
                          row.outer_is_arc);
      };
      const CellShape plain = shape(0.), turned = shape(1.1);
      const AiryCell cell = make_cell(plain, degree);
      const FullMatrix<double> S = balanced_energy(cell);
      FullMatrix<double> change = balanced_energy(make_cell(turned, degree));
      change.add(-1., S);
      checks.near("turned", change.frobenius_norm() / S.frobenius_norm(), 0., 1e-7);
      const auto [energy, least] = compatible_energies(cell, plain);
      checks.near("energy", least / energy, 1., 1e-9);
    }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {many_points, curved_cells});
}
