// SPDX-License-Identifier: LGPL-2.1-or-later
// Energies and works of files of other programs, against exact integrals.

#include <signorini/error_control/verify/foreign_works.h>
#include <signorini/problem/input/make_scene.h>

#include "tests.h"
#include "verified_scenes.h"

using namespace Signorini;

namespace {
void check_files(Checks &checks) {
  for (const VerifiedFile &file : verified_files) {
    checks.about(file.name);
    const Scene<2> scene = make_scene<2>(parameters_of(file));
    const VtuMesh mesh = read_vtu(file_text(path_of(file)), file.name, "displacement");
    const ForeignField field(mesh, scene.geometry, 1., 1e-5);
    const FieldWorks works = works_of(field, scene);
    checks.near("|||v|||^2", works.strain, file.strain, 1e-10 * file.strain);
    checks.near("work of loads", works.load, file.load, 1e-10 * file.load);
    checks.between("rest of the rules", works.margin, 0., 1e-12 * file.strain);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {check_files});
}
