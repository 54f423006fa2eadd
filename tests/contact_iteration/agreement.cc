// SPDX-License-Identifier: LGPL-2.1-or-later
#include <signorini/contact_iteration/contact_iteration.h>

#include "one_level.h"
#include "stand_in.h"
#include "tests.h"

using namespace Signorini;

namespace
{
const char *const block = R"(
subsection Boundary
 set Clamped = top
 set Contact = bottom
end
subsection Load
 set Body force = 0; -0.2
end
subsection Contact
 set Gap = 0.05*(x-0.4)^2
end
)";

void run(const std::string &text, const unsigned int level, const double e)
{
  const OneLevel problem(text, level);
  const Discretization<2> &d = problem.discretization;
  const LevelSolution<2> exact = problem.solve();
  const LinearSystem<2> system = assemble_linear_system(d.space, problem.scene, d.n_points);
  const StandIn<2> A(d.space, system, e);
  const NodalVector f(system.f);
  dealii::Vector<double> gap(d.G);
  gap -= d.D.transpose_product(d.space.prescribed(problem.scene));
  const auto model = make_boundary_model(d.multipliers);
  const ContactSystem contact = {A, f, d.condensed_D, gap, *model};
  ContactIterationOptions options;
  for (const double scale : {0., 1., 1.2, 1.4, 1.7})
  {
    options.scale = scale;
    const auto result = solve_contact_by_cycles(
      contact, NodalVector(A.size()), dealii::Vector<double>(d.G.size()), options);
    const NodalVector U = [&]() {
      DistributedVector free = d.space.make_vector();
      for (unsigned int i = 0; i < A.size(); ++i)
        free(i) = result.U[i];
      return d.space.complete(free);
    }();
    unsigned int active = 0;
    for (const double p : result.P)
      active += p < 0.;
    std::cerr << "level " << level << " e " << e << " t " << result.scale << " cycles "
              << result.cycles << " kkt " << result.kkt_residual << " stat " << result.stationarity
              << (result.stalled ? " STALLED" : "") << " U " << distance(U, exact.U) / exact.U.linfty_norm()
              << " P " << distance(result.P, exact.P) / exact.P.linfty_norm() << " active " << active
              << " of " << d.G.size() << std::endl;
  }
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  for (unsigned int level = 3; level < 7; ++level)
    run(block, level, 0.15);
  return checks.exit_code();
}
