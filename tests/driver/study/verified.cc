// SPDX-License-Identifier: LGPL-2.1-or-later
// The errors of displacements of other programs: their intervals against exact ones and against
// numbers from elsewhere.

#include <signorini/driver/sequence/reference_run.h>
#include <signorini/error_control/verify/verification.h>

#include <deal.II/base/quadrature_lib.h>

#include "../../error_control/verify/verified_scenes.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
ReferenceStress reference_of(const Parameters &parameters, const Scene<2> &scene) {
  return run_reference(parameters, scene, ReferenceTarget(), [](const std::string &) {})
    .stress.value();
}

/** Five files of three programs and of own elements. */
void check_files(Checks &checks) {
  std::optional<ReferenceStress> reference;
  std::string prm;
  for (const VerifiedFile &file : verified_files) {
    checks.about(file.name);
    const Parameters parameters = parameters_of(file);
    const Scene<2> scene = make_scene<2>(parameters);
    if (!reference || prm.empty() || file.prm != prm)
      reference = reference_of(parameters, scene);
    prm = file.prm;
    const ForeignField field(read_vtu(file_text(path_of(file)), file.name, "displacement"),
                             scene.geometry, 1., 1e-5);
    const FieldWorks works = works_of(field, scene);
    const WithMargin distance = reference->distance(works);
    checks.near("distance", distance.value, file.distance, 1e-7 * file.distance);
    checks.between("margin", distance.margin, 0., 1e-3 * distance.value);
    checks.that("it contains the true error",
                std::abs(distance.value - file.distance) <= distance.margin);
    FieldWorks rest = works;
    rest.strain = rest.load = 0.;
    for (BoundaryTrace &trace : rest.traces)
      trace.values.assign(trace.values.size(), Tensor<1, 2>());
    const double norm = reference->distance(rest).value,
                 factor =
                   0.5 * (1. + (norm * norm - distance.value * distance.value) / works.strain);
    checks.near("best factor", factor, file.factor, 1e-6);
  }
}

/** Returns n x n squares of two triangles each, with the middles of their edges and the values of a
 * function. */
VtuMesh triangles(const unsigned int n, const Function<2> &function) {
  VtuMesh mesh;
  mesh.name = "own";
  mesh.n_components = 2;
  const unsigned int row = 2 * n + 1;
  dealii::Vector<double> value(2);
  for (unsigned int j = 0; j < row; ++j)
    for (unsigned int i = 0; i < row; ++i) {
      const Point<2> x(0.5 * i / n, 0.5 * j / n);
      function.vector_value(x, value);
      mesh.points.emplace_back(x[0], x[1], 0.);
      mesh.values.insert(mesh.values.end(), {value[0], value[1]});
    }
  for (unsigned int j = 0; j < row - 1; j += 2)
    for (unsigned int i = 0; i < row - 1; i += 2) {
      const unsigned int a = j * row + i;
      mesh.cells.push_back({22, {a, a + 2, a + 2 * row + 2, a + 1, a + row + 2, a + row + 1}});
      mesh.cells.push_back(
        {22, {a, a + 2 * row + 2, a + 2 * row, a + row + 1, a + 2 * row + 1, a + row}});
    }
  return mesh;
}

/** Returns |||v - u||| of the exact solution by many points of each cell. */
double exact_error(const ForeignField &field, const Scene<2> &scene) {
  const QIterated<2> rule(QGauss<1>(4), 24);
  double square = 0.;
  for (const ForeignCell &cell : field.cells())
    for (unsigned int q = 0; q < rule.size(); ++q) {
      const ForeignCell::Values at = cell.at(rule.point(q)[0], rule.point(q)[1]);
      Tensor<2, 2> difference = at.gradient;
      for (unsigned int c = 0; c < 2; ++c)
        difference[c] -= scene.exact_displacement->gradient(at.x, c);
      const SymmetricTensor<2, 2> strain = symmetrize(difference);
      square += rule.weight(q) * at.determinant * (scene.material->hooke(at.x) * strain * strain);
    }
  return std::sqrt(square);
}

/** Interpolated exact solutions, some of them made wrong: with loads that have kinks inside of
 * cells, plain rules miss the error by far more than the interval is wide. */
void check_known_solutions(Checks &checks) {
  for (const std::string name : {"A1", "B1"}) {
    checks.about(name);
    const Parameters parameters = parse_parameters(named_scene(name), "test");
    const Scene<2> scene = make_scene<2>(parameters, named_scenes());
    const ReferenceStress reference = reference_of(parameters, scene);
    for (const unsigned int n : {2, 5})
      for (const double factor : {1., 1.05}) {
        const ForeignField field(triangles(n, *scene.exact_displacement), scene.geometry, factor,
                                 1e-5);
        const double exact = exact_error(field, scene);
        const WithMargin distance = reference.distance(works_of(field, scene));
        checks.that("the interval contains the error",
                    std::abs(distance.value - exact) <= distance.margin + 1e-7 * exact);
        checks.between("its width as a share", distance.margin / distance.value, 0., 1e-3);
      }
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {check_files, check_known_solutions});
}
