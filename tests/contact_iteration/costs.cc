#include <signorini/boundary_model/boundary_model.h>
#include <signorini/compliance/compliance.h>
#include <signorini/compliance/free_state.h>
#include <signorini/contact_iteration/contact_iteration.h>
#include <signorini/elasticity/cell_stiffness.h>
#include <signorini/multigrid/stiffness_multigrid.h>
#include <signorini/qp/dual_solver.h>
#include <signorini/qp/mprgp.h>
#include <set>
#include "../box/box.h"
#include "one_level.h"
#include "tests.h"
using namespace Signorini;
namespace {
unsigned int linear_cycles(const StiffnessOperator &A, const NodalVector &b)
{
  NodalVector x(A.size()), r(b), z(A.size()), p(A.size()), q(A.size());
  A.precondition(z, r);
  p = z;
  double r_z = r * z;
  for (unsigned int k = 1; k < 100; ++k)
  {
    A.apply(q, p);
    const double step = r_z / (p * q);
    x.add(step, p);
    r.add(-step, q);
    if (r.l2_norm() <= 1e-8 * b.l2_norm())
      return k;
    A.precondition(z, r);
    const double next = r * z;
    p.sadd(next / r_z, 1., z);
    r_z = next;
  }
  return 100;
}
class Counting final : public ComplianceOperator {
public:
  explicit Counting(std::shared_ptr<const ComplianceOperator> C) : C_(C) {}
  unsigned int size() const override { return C_->size(); }
  Vector apply(const Vector &P) const override { for (unsigned i=0;i<P.size();++i) if (P[i]!=0) s.insert(i); return C_->apply(P); }
  Vector diagonal() const override { for (unsigned i=0;i<size();++i) s.insert(i); return C_->diagonal(); }
  Matrix columns(const Indices &n) const override { s.insert(n.begin(), n.end()); return C_->columns(n); }
  const Matrix &dense() const override { return C_->dense(); }
  bool is_explicit() const override { return false; }
  mutable std::set<unsigned int> s;
  std::shared_ptr<const ComplianceOperator> C_;
};
template <int dim>
void run(const std::string &name, const DisplacementSpace<dim> &space, const Scene<dim> &scene, const MultiplierSpace<dim> &multipliers, const Coupling &D, const Coupling &condensed_D, const dealii::Vector<double> &G)
{
  const LinearSystem<dim> system = assemble_linear_system(space, scene, 2);
  const auto inverse = factorise(system.matrix, system.unit, LinearSolver::condensed, contact_unknowns(condensed_D));
  const FreeState free = solve_free_state(*inverse, space, system.f, D, G);
  double seconds = 0;
  const auto C = make_compliance(*inverse, condensed_D, seconds);
  const auto model = make_boundary_model(multipliers);
  const BoundConstrainedQP qp(C, free.F, dealii::Vector<double>(G.size()));
  DualSolverOptions o; o.tolerance = 1e-8;
  auto counting = std::make_shared<Counting>(C);
  const QPResult as = solve_dual_problem(counting, free.F, {}, o);
  o.method = ContactSolver::psor;
  const QPResult ps = solve_dual_problem(C, free.F, {}, o);
  const QPResult m1 = solve_by_mprgp(qp, {}, {1e-8, 100000});
  const QPResult m2 = solve_by_mprgp(qp, {}, {1e-8, 100000, [&](const std::vector<unsigned int> &set, const dealii::Vector<double> &r) { return model->solve(set, r); }});
  const StiffnessMultigrid<dim> A(space, scene);
  const NodalVector f(system.f);
  dealii::Vector<double> gap(G);
  gap -= D.transpose_product(space.prescribed(scene));
  const ContactSystem cs = {A, f, condensed_D, gap, *model};
  ContactIterationOptions options;
  options.tolerance = options.stationarity = 1e-8;
  const auto r = solve_contact_by_cycles(cs, NodalVector(A.size()), dealii::Vector<double>(gap.size()), options);
  const unsigned int lin = linear_cycles(A, cs.residual(NodalVector(A.size()), r.P));
  unsigned active = 0; for (double p : r.P) active += p < 0;
  std::cout << name << " m " << G.size() << " active " << active << " | psor sweeps " << ps.iterations << " | as steps " << as.iterations << " columns " << counting->s.size() << " | mprgp " << m1.iterations << " | pmprgp " << m2.iterations << " | linear " << lin << " cycles " << r.cycles << std::endl;
}
}
int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string block = R"(
subsection Boundary
 set Clamped = top
 set Contact = bottom
end
subsection Load
 set Body force = 0; -0.2
end
subsection Contact
 set Gap = 2*(x-0.4)^2-0.02
end
)";
  for (unsigned int level = 5; level < 9; ++level) {
    const OneLevel p(block, level);
    const auto &d = p.discretization;
    run<2>("plane " + std::to_string(1<<level), d.space, p.scene, d.multipliers, d.D, d.condensed_D, d.G);
  }
  Scene<3> scene = make_box_scene(scalar([](const dealii::Point<3> &x) {
      return 0.5 * ((x[0] - 0.57) * (x[0] - 0.57) + (x[1] - 0.44) * (x[1] - 0.44)) - 0.02;
    }), field([](const auto &) { return Vector3(); }));
  for (const char *side : {"left", "right", "front", "back"})
    scene.boundary[scene.geometry.find_side(side)].role = Role::free;
  for (unsigned int level = 3; level < 6; ++level) {
    const Box b(scene, level, 2);
    run<3>("cube " + std::to_string(1<<level), b.space, scene, b.multipliers, b.D, b.condensed_D, b.G);
  }
}
