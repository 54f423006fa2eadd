// SPDX-License-Identifier: LGPL-2.1-or-later
//
// @sect1{The Lagrange multiplier method of Luo and Liang for the Signorini problem}
//
// This program is a tutorial: it computes the example of a paper with the method of the paper, from
// the mesh to the tables of errors, in the order of the paper and on deal.II alone. The paper is
//
//   P. Luo and G.-P. Liang, Error analysis and global superconvergences for the Signorini problem
//   with Lagrange multiplier methods, Journal of Computational Mathematics 20 (2002).
//
// Formulas have its numbers. Whoever knows deal.II's tutorial (step-8 for elasticity, step-7 for
// tables of errors, step-42 for contact) can read this file from top to bottom. This folder is a
// project of its own, and makes a page of this file. It shares no line with the program `signorini`
// above it, which treats many more bodies with faster methods; a test compares the numbers of both.
//
// The commented program has eleven stages and two appendices. `signorini` has rooms for the same:
//
//   stage                                    folder of source and include/signorini
//    1  the example                          verification/catalogue; by formulas: problem/input
//    2  parameters                           problem/parameters
//    3  V^h and Q^H                          discretization/mesh, discretization/space
//    4  A and f                              discretization/space
//    5  D and G                              discretization/space
//    6  A^{-1}; C, F and P; U                solvers/stiffness; solvers/contact; solvers/methods
//    7  pi^{2h}                              postprocessing/fields
//    8  errors                               verification/norms
//    9  the inf-sup constant                 verification/norms
//   10  tables and files                     results/verdict, results/output
//   11  all levels                           driver/level, driver/sequence, driver/study
//    A  quadrature at the end of contact     discretization/mesh
//    B  the norm of order -1/2               verification/norms
//
//
// @sect2{Introduction}
//
// @sect3{Signorini's problem}
//
// An elastic body Omega is held on the part Gamma_D of its boundary. Tractions t act on Gamma_F and
// forces f in its interior. On the part Gamma_c it may come to touch a rigid foundation without
// friction. Let n be the outward normal, u_n = u.n, and let g be the gap, the distance to the
// foundation along n. The stress sigma(u) is given by Hooke's law, sigma_ij = E_ijkl u_{k,l}; its
// normal part on the boundary is sigma_n = n.sigma n. Signorini's problem is
//
//   -div sigma(u) = f            in Omega,
//               u = 0            on Gamma_D,
//      sigma(u) n = t            on Gamma_F,                                               (1)
//   u_n - g <= 0,  sigma_n <= 0,  sigma_n (u_n - g) = 0,  sigma_T = 0       on Gamma_c.
//
// The last line says, in this order: the body does not penetrate the foundation; the foundation
// presses, but does not pull; it presses only where the body touches it; there is no friction.
// *Pressures are negative in compression*, as in the paper. Which part of Gamma_c is in contact is
// not known beforehand, so the problem is nonlinear although elasticity is linear.
//
//
// @sect3{The multiplier}
//
// With the energy product and the work of the loads
//
//   a(u, v) = int_Omega E_ijkl u_{k,l} v_{i,j},     f(v) = int_Omega f.v + int_{Gamma_F} t.v,
//
// the displacement u minimises 1/2 a(v,v) - f(v) over all v that vanish on Gamma_D and do not
// penetrate. The method turns the condition "does not penetrate" into an equation and an unknown
// pressure. Let B v = v.n on Gamma_c, and write [q, v] for the integral of q v over Gamma_c. The
// supremum of -[q, B v - g] over all q <= 0 is zero if B v <= g, and infinite otherwise. So
// the problem is to find the saddle point of 1/2 a(v,v) - f(v) - [q, B v - g]. It satisfies
//
//   a(u, v) - [p, B v]   = f(v)     for all v in V,
//   [q - p, B u - g]    >= 0        for all q <= 0,  with p <= 0.                          (3)
//
// Integration by parts shows that the multiplier is the contact pressure, p = sigma_n (Theorem 1).
// Contact is all in the second line: with q = 0 and q = 2 p it says [p, B u - g] = 0, and then
// [q, B u - g] >= 0 for all q <= 0, which is B u <= g.
//
//
// @sect3{Two meshes}
//
// The body has a mesh T^h of squares of the size h. The space V^h consists of the bilinear
// displacements on it that vanish on Gamma_D. The contact boundary has a *second, coarser* mesh,
// Gamma_c^H = {tau}: its elements, the patches, are H long. The space Q^H consists of the pressures
// that are constant on every patch, and N^H of those that are nowhere positive. The method is (3)
// on these spaces: find u_h in V^h and p_H in N^H with
//
//   a(u_h, v_h) - [p_H, B v_h]    = f(v_h)     for all v_h in V^h,
//   [q_H - p_H, B u_h - g]       >= 0          for all q_H in N^H.                         (5)
//
// Why two meshes? A pressure that no displacement sees cannot be computed. The method needs the
// inf-sup condition of Lemma 1,
//
//   sup over v_h of [q_H, B v_h]/||v_h||_1  >=  beta |||q_H|||_{-1/2},  beta > 0,           (6)
//
// for all q_H in Q^H, with a beta that does not depend on the meshes. With H = h it fails: the
// pressure +1, -1, +1, ... does nearly no work on continuous, piecewise linear displacements, and
// beta falls like h. The paper therefore assumes that h/H is small. For patches of whole edges less
// is enough: each must have a node of T^h in its interior. So H = 2h, the default here, is stable.
// Stage 9 computes beta for both.
//
// The second line of (5) tests with constants on patches. So it is the mean of B u_h - g on each
// patch that must not be positive. At single points u_h may penetrate a little.
//
//
// @sect3{Matrices, and the dual problem}
//
// Let phi_j be the basis of V^h, and phi_tau that of Q^H: one on tau and zero elsewhere. Put
//
//   A_ij = a(phi_j, phi_i),         D_{j tau} = int_tau phi_j.n,
//   f_j  = f(phi_j),                G_tau     = int_tau g.
//
// The paper writes g for the vector G. In these terms the saddle point is that of
//
//   J(U, P) = 1/2 U^T A U - U^T D P - U^T f + P^T G,                                       (22)
//
// and (5) is a system of one equation and three conditions, where W holds the integrals of
// B u_h - g over the patches:
//
//   A U - D P = f,     W = D^T U - G,     P <= 0,   W <= 0,   P^T W = 0.
//
// The equation can be solved for U if P is known,
//
//   U = A^{-1} (D P + f).                                                                  (23)
//
// Inserted into J this leaves a problem for P alone, whose size m is the number of patches:
//
//   minimise 1/2 P^T C P - P^T F over P <= 0,   C = D^T A^{-1} D,   F = G - D^T A^{-1} f,
//
// up to the sign and a constant the paper's J~. C_ij is the normal displacement, integrated over
// patch i, that a unit pressure on patch j causes, and W = C P - F. C is symmetric, and positive
// definite by (6). The algorithm is projected successive over-relaxation (PSOR):
//
//   (i)   Choose 0 < omega < 2, and P^0 <= 0.
//   (ii)  For i = 1, ..., m:
//           lambda_i  = -(sum_{j<i} C_ij P_j^{k+1} + sum_{j>i} C_ij P_j^k - F_i)/C_ii,
//           P_i^{k+1} = min(0, (1 - omega) P_i^k + omega lambda_i).
//   (iii) Stop when |P^{k+1} - P^k| is small.
//   (iv)  Compute U by (23).
//
// By Theorem 4 it converges for every 0 < omega < 2. (To the solution of (5). The paper says (3).)
//
//
// @sect3{What the theorems promise}
//
// Let I^h be the interpolation at the nodes of T^h, R^H p the mean of p on every patch, and
// |||.|||_{-1/2} the norm of pressures, the dual of the norm of order 1/2 on Gamma_c. With an
// epsilon that is as small as one likes,
//
//   ||u - u_h||_1               <= c (h + H^{1-eps}),                                      (13)
//   ||p - p_H||_0               <= c (h H^{-1/2} + H^{1/2-eps}),                           (14)
//   |||p - p_H|||_{-1/2}        <= c (h + H^{1-eps})                                       (15)
//
// if u is in H^2 and contact ends at finitely many points (Theorem 3). If, moreover, u is in H^3
// and the mesh is almost uniform,
//
//   ||I^h u - u_h||_1           <= c (h^{3/2} + H^{5/4}),                                  (24)
//   |||R^H p - p_H|||_{-1/2}    <= c (h^{3/2} + H^{5/4})                                   (25)
//
// (Theorem 5). So u_h is closer to the interpolant of u than to u itself, whose distance from every
// function of V^h is of order one. Interpolation of degree two on cells of the size 2h makes a
// better solution of it: with the operator pi^{2h} of stage 7, Theorem 6 says
//
//   ||u - pi^{2h} u_h||_1       <= c (h^{3/2} + H^{5/4}),                                  (31)
//   |||p - p_H|||_{-1/2}        <= c (h^{3/2} + H^{5/4}),                                  (32)
//   ||p - p_H||_0               <= c (h^{3/2} H^{-1/2} + H^{3/4}).                         (33)
//
// The paper prints further terms h^{3/4} H^{3/4} in (24), (25), (31), (32) and h^{3/4} H^{1/4} in
// (33). They are not needed: h^{3/4} H^{3/4} <= (h^{3/2} + H^{3/2})/2.
//
// All of these orders are promises. The results at the end of this file are better.
//
//
// @sect3{The example}
//
// Errors need a solution that is known. Here Omega is the unit square, Gamma_D its upper side,
// Gamma_F are its upright sides, and Gamma_c is the lower side, where n = (0, -1), u_n = -u_2 and
// sigma_n = sigma_22. The body is in plane strain with the moduli lambda = mu = 1. We choose what
// we like on the lower side, with (s)_+ = max(s, 0) and xi = 1/sqrt(2):
//
//   p(x)  = -10 (xi - x)_+^3,    u_1(x, 0) = V(x) = 0.1 x^2,    u_2(x, 0) = U(x) = 0.1 x (1 - x),
//
// and continue it into the square so that sigma_12 = 0 and sigma_22 = p on the lower side and u = 0
// on the upper one:
//
//   u_1 = (V(x) - y U'(x)) (1 - y^2),
//   u_2 = (U(x) + y (p(x) - lambda V'(x))/(lambda + 2 mu)) (1 - y^2).
//
// The factor 1 - y^2 is one at y = 0, with the slope zero, and does not disturb the conditions
// there. Forces and tractions are what this u needs. Where p < 0 the body must touch the
// foundation. Beyond, it may open:
//
//   g = u_n + (x - xi)_+^2.
//
// So contact ends at x = xi. The body presses to the left of it and has lifted off to the right. As
// xi is irrational, contact ends inside a patch on every level: this is the case that costs work in
// the proofs. The displacement is in H^{7/2-eps}, smooth enough for Theorems 5 and 6.
//
//
// @sect3{Running the program}
//
//   luo_liang                  runs the example on the levels 2 to 6 (4 x 4 to 64 x 64 cells),
//   luo_liang parameters.prm   reads parameters. All of them with their defaults:
//
//     set Length         = 1        # of the lower side, in squares
//     set Coarsest level = 2        # refinements of the squares
//     set Finest level   = 6
//     set Patch ratio    = 2        # H/h
//     set Relaxation     = 1        # omega
//     set Tolerance      = 1e-10    # of step (iii), relative
//     set Digits         = 3        # of the tables
//     set Write VTU      = false    # solution-LL.vtu of every level, in the working folder
//     set Write figures  = false    # pressure.svg and deformed.svg of the finest level
//
// The target `luo_liang_page` of CMake runs it with figures, and makes a page of this file.

#include <deal.II/base/convergence_table.h>
#include <deal.II/base/function.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/utilities.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/hp/q_collection.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/matrix_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {
using namespace dealii;

// The paper treats bodies in the plane.
constexpr int dim = 2;

// @sect2{The commented program}
//
// @sect3{Stage 1: the example}
//
// The formulas of the introduction. They are polynomials on either side of the line x = xi.
namespace Example {
constexpr double lambda = 1.;
constexpr double mu = 1.;
constexpr double xi = numbers::SQRT1_2;

double pressure(const double x) {
  return -10. * std::pow(std::max(xi - x, 0.), 3);
}

double gap(const double x) {
  return -0.1 * x * (1. - x) + std::pow(std::max(x - xi, 0.), 2);
}

// Here and below M is (xi - x)_+, so that p = -10 M^3 and p' = 30 M^2.
Tensor<1, dim> displacement(const Point<dim> &point) {
  const double x = point[0], y = point[1], M = std::max(xi - x, 0.);
  Tensor<1, dim> u;
  u[0] = (0.1 * x * x - y * (0.1 - 0.2 * x)) * (1. - y * y);
  u[1] = (0.1 * x * (1. - x) - y * (10. * M * M * M + 0.2 * x) / 3.) * (1. - y * y);
  return u;
}

// u_{i,j} in row i and column j.
Tensor<2, dim> displacement_gradient(const Point<dim> &point) {
  const double x = point[0], y = point[1], M = std::max(xi - x, 0.);
  const double slope_1 = -(0.1 - 0.2 * x), slope_2 = -(10. * M * M * M + 0.2 * x) / 3.;
  Tensor<2, dim> gradient;
  gradient[0][0] = (0.2 * x + 0.2 * y) * (1. - y * y);
  gradient[0][1] = slope_1 * (1. - y * y) - 2. * y * (0.1 * x * x + y * slope_1);
  gradient[1][0] = (0.1 - 0.2 * x + y * (30. * M * M - 0.2) / 3.) * (1. - y * y);
  gradient[1][1] = slope_2 * (1. - y * y) - 2. * y * (0.1 * x * (1. - x) + y * slope_2);
  return gradient;
}

// Hooke's law: sigma = lambda tr(eps) I + 2 mu eps.
SymmetricTensor<2, dim> stress(const SymmetricTensor<2, dim> &strain) {
  return lambda * trace(strain) * unit_symmetric_tensor<dim>() + 2. * mu * strain;
}

// f = -div sigma(u).
Tensor<1, dim> body_force(const Point<dim> &point) {
  const double x = point[0], y = point[1], M = std::max(xi - x, 0.);
  Tensor<1, dim> f;
  f[0] = M * M * (60. * y * y - 20.) + 0.2 * x * x + 0.4 * x * y + 0.2 * y * y - 0.2 * y - 7. / 15.;
  f[1] = -60. * M * M * M * y + 20. * M * (y - y * y * y) - 0.6 * x * x - 0.4 * x * y + 0.6 * x +
         y * y - 0.2;
  return f;
}

// t = sigma(u) n.
Tensor<1, dim> traction(const Point<dim> &point, const Tensor<1, dim> &normal) {
  return stress(symmetrize(displacement_gradient(point))) * normal;
}
} // namespace Example

// The displacement as deal.II's functions for interpolation and for errors want it.
class ExactDisplacement : public Function<dim> {
public:
  ExactDisplacement()
    : Function<dim>(dim) {}

  double value(const Point<dim> &point, const unsigned int component) const override {
    return Example::displacement(point)[component];
  }
  Tensor<1, dim> gradient(const Point<dim> &point, const unsigned int component) const override {
    return Example::displacement_gradient(point)[component];
  }
};

// The sides of the body have the numbers that GridGenerator gives them.
constexpr types::boundary_id contact_side = 2; // y = 0
constexpr types::boundary_id clamped_side = 3; // y = 1

// @sect3{Stage 2: parameters}
//
// In-class defaults make the program run without a file. The contact side is the interval
// (0, Length). The formulas of the example hold for every length, and the body is a row of squares.
struct Parameters {
  unsigned int length = 1;
  unsigned int coarsest_level = 2;
  unsigned int finest_level = 6;
  unsigned int patch_ratio = 2;
  double relaxation = 1.;
  double tolerance = 1e-10;
  unsigned int digits = 3;
  bool write_vtu = false;
  bool write_figures = false;

  void read(const std::string &file_name) {
    ParameterHandler prm;
    prm.add_parameter("Length", length, "in squares", Patterns::Integer(1, 100));
    prm.add_parameter("Coarsest level", coarsest_level, "", Patterns::Integer(1, 10));
    prm.add_parameter("Finest level", finest_level, "", Patterns::Integer(1, 10));
    prm.add_parameter("Patch ratio", patch_ratio, "H/h", Patterns::Integer(1));
    prm.add_parameter("Relaxation", relaxation, "omega");
    prm.add_parameter("Tolerance", tolerance, "of step (iii)", Patterns::Double(1e-14, 1e-2));
    prm.add_parameter("Digits", digits, "of the tables", Patterns::Integer(1, 16));
    prm.add_parameter("Write VTU", write_vtu);
    prm.add_parameter("Write figures", write_figures);
    prm.parse_input(file_name);
    AssertThrow(coarsest_level <= finest_level, ExcMessage("Coarsest level > Finest level."));
    AssertThrow(0. < relaxation && relaxation < 2.,
                ExcMessage("Theorem 4 needs a Relaxation between 0 and 2, both excluded."));
    AssertThrow((length << coarsest_level) % patch_ratio == 0,
                ExcMessage("Patches consist of whole edges: the Patch ratio must divide the number "
                           "of edges on the contact side, Length 2^level."));
  }
};

// @sect3{The class of the method}
//
// One object holds one level after the other. The function run() calls the stages in the order of
// the paper; everything that a later stage needs is a member with the name that it has there.
class LuoLiang {
public:
  explicit LuoLiang(const Parameters &parameters);
  void run();

private:
  void make_spaces();
  void assemble_A_and_f();
  void assemble_D(unsigned int n_patches, SparsityPattern &sparsity, SparseMatrix<double> &D) const;
  void assemble_G();
  void compute_C_and_F();
  unsigned int solve_by_psor();
  void recover_U();
  void interpolate_on_2h();
  double inf_sup_constant(unsigned int ratio) const;

  double h1_distance(const Function<dim> &w, const DoFHandler<dim> &dofs,
                     const Vector<double> &v) const;
  double l2_error_of_pressure() const;
  Vector<double> means_of_pressure() const;

  // The first appendix: sums over cells that are exact for polynomials on either side of x = xi. A
  // reader may think of QGauss(4) in their place.
  static Quadrature<1> gauss_split_at_xi(double a, double b);
  hp::QCollection<dim> cell_rules() const;
  static unsigned int rule_on(const CellAccessor<dim> &cell);
  // The second one: the norm of order -1/2.
  using Pressures = std::vector<std::function<double(double)>>;
  LAPACKFullMatrix<double> gram_matrix(unsigned int n_cells) const;
  std::vector<double> dual_norms(const Pressures &pressures, unsigned int n_cells) const;
  std::vector<double> extrapolated_dual_norms(const Pressures &pressures) const;
  LAPACKFullMatrix<double> dual_gram_matrix(unsigned int n_patches) const;

  double mesh_size() const;
  double patch_length() const;
  double energy() const;
  double kkt_residual() const;
  unsigned int patches_of(unsigned int ratio) const;
  void add_to_tables(unsigned int level, unsigned int n_sweeps);
  void write_vtu(unsigned int level) const;
  void write_pressure() const;
  void write_deformed_mesh() const;
  void print_tables();

  const Parameters parameters;

  Triangulation<dim> triangulation;
  // V^h, and the functions of degree two in which pi^{2h} has its values.
  const FESystem<dim> fe;
  const FESystem<dim> fe_post;
  DoFHandler<dim> dof_handler;
  DoFHandler<dim> dof_handler_post;
  AffineConstraints<double> constraints;
  // The number of patches.
  unsigned int m;

  SparsityPattern sparsity_A, sparsity_D;
  SparseMatrix<double> A, D;
  Vector<double> f, G;
  SparseDirectUMFPACK A_inverse;
  FullMatrix<double> C;
  Vector<double> F;
  Vector<double> P, U;
  // pi^{2h} u_h.
  Vector<double> U_post;

  TableHandler computation, stability;
  ConvergenceTable convergence;
};

LuoLiang::LuoLiang(const Parameters &parameters)
  : parameters(parameters)
  , fe(FE_Q<dim>(1), dim)
  , fe_post(FE_Q<dim>(2), dim)
  , dof_handler(triangulation)
  , dof_handler_post(triangulation)
  , m(0) {
  GridGenerator::subdivided_hyper_rectangle(triangulation, {parameters.length, 1},
                                            Point<dim>(0., 0.), Point<dim>(parameters.length, 1.),
                                            /*colorize*/ true);
  triangulation.refine_global(parameters.coarsest_level);
}

double LuoLiang::mesh_size() const {
  return triangulation.begin_active()->extent_in_direction(0);
}

// The patches are the intervals (i H, (i + 1) H) of the lower side.
double LuoLiang::patch_length() const {
  return parameters.patch_ratio * mesh_size();
}

unsigned int LuoLiang::patches_of(const unsigned int ratio) const {
  return static_cast<unsigned int>(std::lround(parameters.length / (ratio * mesh_size())));
}

// @sect3{Stage 3: V^h and Q^H}
//
// V^h needs a DoFHandler and the condition u = 0 on Gamma_D. Q^H needs neither: its functions are
// vectors with one entry per patch.
void LuoLiang::make_spaces() {
  dof_handler.distribute_dofs(fe);
  constraints.clear();
  VectorTools::interpolate_boundary_values(dof_handler, clamped_side,
                                           Functions::ZeroFunction<dim>(dim), constraints);
  constraints.close();

  m = patches_of(parameters.patch_ratio);
}

// @sect3{Stage 4: A and f}
//
// This is linear elasticity as in step-8. No contact enters. The condition on Gamma_D is eliminated
// when cells are added to the matrix: rows of nodes on Gamma_D have an entry on the diagonal only.
// hp::FEValues chooses one of two quadrature rules for each cell (appendix A): f is a polynomial on
// either side of x = xi only.
void LuoLiang::assemble_A_and_f() {
  DynamicSparsityPattern dynamic(dof_handler.n_dofs());
  DoFTools::make_sparsity_pattern(dof_handler, dynamic, constraints, /*keep_constrained*/ false);
  sparsity_A.copy_from(dynamic);
  A.reinit(sparsity_A);
  f.reinit(dof_handler.n_dofs());

  const FEValuesExtractors::Vector displacement(0);
  hp::FEValues<dim> cell_values(dof_handler.get_fe_collection(), cell_rules(),
                                update_values | update_gradients | update_quadrature_points |
                                  update_JxW_values);
  FEFaceValues<dim> face_values(fe, QGauss<dim - 1>(4),
                                update_values | update_quadrature_points | update_normal_vectors |
                                  update_JxW_values);
  const unsigned int n = fe.n_dofs_per_cell();
  FullMatrix<double> cell_matrix(n, n);
  Vector<double> cell_rhs(n);
  std::vector<types::global_dof_index> indices(n);
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    cell_matrix = 0.;
    cell_rhs = 0.;
    cell_values.reinit(cell, rule_on(*cell));
    const FEValues<dim> &values = cell_values.get_present_fe_values();
    for (const unsigned int q : values.quadrature_point_indices()) {
      const Tensor<1, dim> force = Example::body_force(values.quadrature_point(q));
      for (unsigned int i = 0; i < n; ++i) {
        const auto stress = Example::stress(values[displacement].symmetric_gradient(i, q));
        for (unsigned int j = 0; j < n; ++j)
          cell_matrix(i, j) +=
            stress * values[displacement].symmetric_gradient(j, q) * values.JxW(q);
        cell_rhs[i] += force * values[displacement].value(i, q) * values.JxW(q);
      }
    }
    // Gamma_F: all sides but the clamped one and the contact side.
    for (const auto &face : cell->face_iterators()) {
      if (!face->at_boundary() || face->boundary_id() == contact_side ||
          face->boundary_id() == clamped_side)
        continue;
      face_values.reinit(cell, face);
      for (const unsigned int q : face_values.quadrature_point_indices()) {
        const Tensor<1, dim> t =
          Example::traction(face_values.quadrature_point(q), face_values.normal_vector(q));
        for (unsigned int i = 0; i < n; ++i)
          cell_rhs[i] += t * face_values[displacement].value(i, q) * face_values.JxW(q);
      }
    }
    cell->get_dof_indices(indices);
    constraints.distribute_local_to_global(cell_matrix, cell_rhs, indices, A, f);
  }
}

// @sect3{Stage 5: D and G}
//
// D couples the two meshes: its rows belong to V^h, its columns to the patches. On each edge of the
// contact side only the patch around it is concerned, because patches consist of whole edges. A row
// has entries for the nodes on the contact side only, and a node between two patches belongs to
// both. Since Gamma_c keeps a distance from Gamma_D, constraints play no role.
//
// The normal comes from deal.II, not from the knowledge that it is (0, -1) here: on another body
// these lines remain the same. The trace phi_j.n is linear on an edge, so that two points make no
// error in D.
void LuoLiang::assemble_D(const unsigned int n_patches, SparsityPattern &sparsity,
                          SparseMatrix<double> &D) const {
  const auto on_contact_edges = [&](const auto &visit) {
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == contact_side)
          visit(cell, face,
                static_cast<unsigned int>(cell->face(face)->center()[0] / parameters.length *
                                          n_patches));
  };
  std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());

  DynamicSparsityPattern dynamic(dof_handler.n_dofs(), n_patches);
  on_contact_edges([&](const auto &cell, const unsigned int face, const unsigned int tau) {
    cell->get_dof_indices(indices);
    for (unsigned int i = 0; i < indices.size(); ++i)
      if (fe.has_support_on_face(i, face))
        dynamic.add(indices[i], tau);
  });
  sparsity.copy_from(dynamic);
  D.reinit(sparsity);

  const FEValuesExtractors::Vector displacement(0);
  FEFaceValues<dim> values(fe, QGauss<dim - 1>(2),
                           update_values | update_normal_vectors | update_JxW_values);
  on_contact_edges([&](const auto &cell, const unsigned int face, const unsigned int tau) {
    values.reinit(cell, face);
    cell->get_dof_indices(indices);
    for (const unsigned int q : values.quadrature_point_indices())
      for (unsigned int i = 0; i < indices.size(); ++i)
        if (fe.has_support_on_face(i, face))
          D.add(indices[i], tau,
                values[displacement].value(i, q) * values.normal_vector(q) * values.JxW(q));
  });
}

// The gap is a function on the interval (0, Length), and a polynomial on either side of xi. Patch
// tau is the interval (tau H, (tau + 1) H).
void LuoLiang::assemble_G() {
  const double H = patch_length();
  G.reinit(m);
  for (unsigned int tau = 0; tau < m; ++tau) {
    const Quadrature<1> rule = gauss_split_at_xi(tau * H, (tau + 1) * H);
    for (unsigned int q = 0; q < rule.size(); ++q)
      G[tau] += Example::gap((tau + rule.point(q)[0]) * H) * rule.weight(q) * H;
  }
}

// @sect3{Stage 6: the dual problem and its solution}
//
// The product D^T A^{-1} D has one column after the other: D e_i is the force of a unit pressure on
// patch i, z = A^{-1} D e_i the displacement that answers it, and D^T z its normal part, integrated
// over all patches. D e_i is column i of D, which a matrix stored by rows gives away by a product
// only; beside the solve it costs nothing. C is symmetric: its entries with j >= i would be enough,
// but the solves are what takes the time, and they give whole columns.
FullMatrix<double> compliance(const SparseDirectUMFPACK &A_inverse, const SparseMatrix<double> &D) {
  FullMatrix<double> C(D.n(), D.n());
  Vector<double> e(D.n()), column(D.n());
  Vector<double> d(D.m()), z(D.m());
  for (unsigned int i = 0; i < D.n(); ++i) {
    e = 0.;
    e[i] = 1.;
    D.vmult(d, e);
    A_inverse.vmult(z, d);
    D.Tvmult(column, z);
    for (unsigned int j = 0; j < D.n(); ++j)
      C(j, i) = column[j];
  }
  return C;
}

// A is factorised once, by a sparse direct solver. C costs m solves with the factors,
// and F one more, with the loads. This is the expensive part. After these m + 1 solves the body's
// mesh plays no role: PSOR works with a matrix of the size m x m.
void LuoLiang::compute_C_and_F() {
  A_inverse.initialize(A);
  C = compliance(A_inverse, D);

  Vector<double> z(dof_handler.n_dofs());
  A_inverse.vmult(z, f);
  F.reinit(m);
  D.Tvmult(F, z);
  F.sadd(-1., G);
}

// Algorithm (i) to (iii), from P^0 = 0: the body without contact. A sweep overwrites P_i at once,
// so that one loop over the row of C meets the new values for j < i and the old ones for j > i.
//
// The increments are compared with tolerance |P^{k+1}|. This does not depend on the units of the
// pressure. A small increment is no proof of a small error: if the error falls by the factor rho
// per sweep, it is rho/(1 - rho) increments. So the program also prints a residual, see
// kkt_residual().
unsigned int LuoLiang::solve_by_psor() {
  constexpr unsigned int max_sweeps = 100000;
  const double omega = parameters.relaxation;
  P.reinit(m);
  Vector<double> increment(m);
  for (unsigned int sweep = 1; sweep <= max_sweeps; ++sweep) {
    for (unsigned int i = 0; i < m; ++i) {
      double lambda = F[i];
      for (unsigned int j = 0; j < m; ++j)
        if (j != i)
          lambda -= C(i, j) * P[j];
      lambda /= C(i, i);
      const double projected = std::min(0., (1. - omega) * P[i] + omega * lambda);
      increment[i] = projected - P[i];
      P[i] = projected;
    }
    if (increment.l2_norm() <= parameters.tolerance * P.l2_norm())
      return sweep;
  }
  AssertThrow(false, ExcMessage("PSOR needs too many sweeps: take a Relaxation near 1."));
  return max_sweeps;
}

// P solves the dual problem if and only if P = min(0, P - W/diag C), entry by entry: either P_i < 0
// and W_i = 0, or P_i = 0 and W_i <= 0. The residual of this equation judges any method that claims
// to have found P. It is named after Karush, Kuhn and Tucker, whose conditions it expresses, and is
// divided by the larger one of |P| and |F/diag C|, so that it has no unit.
double LuoLiang::kkt_residual() const {
  Vector<double> residual(m), scale(m), W(m);
  C.vmult(W, P);
  W -= F;
  for (unsigned int i = 0; i < m; ++i) {
    residual[i] = P[i] - std::min(0., P[i] - W[i] / C(i, i));
    scale[i] = F[i] / C(i, i);
  }
  return residual.l2_norm() / std::max(P.l2_norm(), scale.l2_norm());
}

// Step (iv), one more solve: U = A^{-1} (D P + f).
void LuoLiang::recover_U() {
  Vector<double> forces(f);
  D.vmult_add(forces, P);
  U.reinit(dof_handler.n_dofs());
  A_inverse.vmult(U, forces);
  constraints.distribute(U);
}

// J(U, P) of (22), with W = D^T U - G put together. At the solution P^T W = 0, so that this is the
// potential energy of the body.
double LuoLiang::energy() const {
  Vector<double> W(G);
  W *= -1.;
  D.Tvmult_add(W, U);
  Vector<double> AU(U);
  A.vmult(AU, U);
  return 0.5 * (U * AU) - (U * f) - (P * W);
}

// @sect3{Stage 7: pi^{2h}}
//
// T^h comes from T^{2h} by cutting every cell into four. The nine nodes of T^h in a cell K of
// T^{2h} are its corners, the middles of its edges and its centre. These are the nodes of the
// element of degree two on K. pi^{2h} v is the function of degree two in x and in y on K that has
// the values of v there:
//
//   pi^{2h} v = sum over the nine nodes x_k of v(x_k) L_k,    L_k(x_l) = delta_kl.
//
// It costs no solve. Because it sees nodal values only, pi^{2h} I^h = pi^{2h}, and because it is
// bounded on V^h, ||pi^{2h} v||_1 <= c ||v||_1 (30),
//
//   ||u - pi^{2h} u_h||_1 <= ||u - pi^{2h} u||_1 + ||pi^{2h} (I^h u - u_h)||_1.
//
// The first term is of order two for u in H^3, and the second one is at most c times (24). This is
// the proof of Theorem 6. (The paper prints (30) with c = 1. On squares c = 1.5539 for the
// seminorm.)
//
// FETools::extrapolate() does precisely this. It writes v on T^h with the element of degree two,
// asks the parent of four cells for the values at its own nine nodes, and writes the result down on
// the four cells again. For this every cell needs a parent: there is no level 0.
void LuoLiang::interpolate_on_2h() {
  dof_handler_post.distribute_dofs(fe_post);
  U_post.reinit(dof_handler_post.n_dofs());
  FETools::extrapolate(dof_handler, U, dof_handler_post, U_post);
}

// @sect3{Stage 8: errors}
//
// The norm ||.||_1 is the full norm of H^1, with (||v||_0^2 + ||grad v||_0^2)^{1/2} for both
// components. This is ||w - v||_1 for a function w and a function v of a finite element space. The
// function VectorTools::integrate_difference() has one rule for all cells and cannot split some at
// xi.
double LuoLiang::h1_distance(const Function<dim> &w, const DoFHandler<dim> &dofs,
                             const Vector<double> &v) const {
  const FEValuesExtractors::Vector displacement(0);
  hp::FEValues<dim> cell_values(dofs.get_fe_collection(), cell_rules(),
                                update_values | update_gradients | update_quadrature_points |
                                  update_JxW_values);
  double square = 0.;
  std::vector<Tensor<1, dim>> v_q;
  std::vector<Tensor<2, dim>> dv_q;
  for (const auto &cell : dofs.active_cell_iterators()) {
    cell_values.reinit(cell, rule_on(*cell));
    const FEValues<dim> &values = cell_values.get_present_fe_values();
    v_q.resize(values.n_quadrature_points);
    dv_q.resize(values.n_quadrature_points);
    values[displacement].get_function_values(v, v_q);
    values[displacement].get_function_gradients(v, dv_q);
    for (const unsigned int q : values.quadrature_point_indices()) {
      const Point<dim> &x = values.quadrature_point(q);
      for (unsigned int c = 0; c < dim; ++c)
        square +=
          (std::pow(w.value(x, c) - v_q[q][c], 2) + (w.gradient(x, c) - dv_q[q][c]).norm_square()) *
          values.JxW(q);
    }
  }
  return std::sqrt(square);
}

// The pressures are functions on an interval, which needs no mesh: patches are (i H, (i + 1) H).
double LuoLiang::l2_error_of_pressure() const {
  const double H = patch_length();
  double square = 0.;
  for (unsigned int tau = 0; tau < m; ++tau) {
    const Quadrature<1> rule = gauss_split_at_xi(tau * H, (tau + 1) * H);
    for (unsigned int q = 0; q < rule.size(); ++q)
      square +=
        std::pow(Example::pressure((tau + rule.point(q)[0]) * H) - P[tau], 2) * rule.weight(q) * H;
  }
  return std::sqrt(square);
}

// R^H p, the mean of p on each patch, see (12).
Vector<double> LuoLiang::means_of_pressure() const {
  const double H = patch_length();
  Vector<double> means(m);
  for (unsigned int tau = 0; tau < m; ++tau) {
    const Quadrature<1> rule = gauss_split_at_xi(tau * H, (tau + 1) * H);
    for (unsigned int q = 0; q < rule.size(); ++q)
      means[tau] += Example::pressure((tau + rule.point(q)[0]) * H) * rule.weight(q);
  }
  return means;
}

// @sect3{Stage 9: the inf-sup constant}
//
// The beta of (6) can be computed. Let A_1 be the Gram matrix of V^h in the scalar product of H^1,
// D the matrix of stage 5, and M the Gram matrix of Q^H in |||.|||_{-1/2} (appendix B). The largest
// [q, B v]/||v||_1 is (Q^T D^T A_1^{-1} D Q)^{1/2}. Hence
//
//   beta^2 = min over Q of (Q^T D^T A_1^{-1} D Q)/(Q^T M Q),
//
// the smallest eigenvalue of a pair of m x m matrices. The tables show beta for H = h and H = 2h,
// whatever the Patch ratio of the run is.
double LuoLiang::inf_sup_constant(const unsigned int ratio) const {
  SparseMatrix<double> gram(sparsity_A);
  MatrixCreator::create_mass_matrix(dof_handler, QGauss<dim>(2), gram,
                                    static_cast<const Function<dim> *>(nullptr), constraints);
  MatrixCreator::create_laplace_matrix(dof_handler, QGauss<dim>(2), gram,
                                       static_cast<const Function<dim> *>(nullptr), constraints);
  SparseDirectUMFPACK A_1_inverse;
  A_1_inverse.initialize(gram);

  SparsityPattern sparsity;
  SparseMatrix<double> D_ratio;
  assemble_D(patches_of(ratio), sparsity, D_ratio);
  LAPACKFullMatrix<double> numerator(D_ratio.n(), D_ratio.n());
  numerator = compliance(A_1_inverse, D_ratio);
  LAPACKFullMatrix<double> denominator = dual_gram_matrix(D_ratio.n());
  std::vector<Vector<double>> no_eigenvectors;
  numerator.compute_generalized_eigenvalues_symmetric(denominator, no_eigenvectors);
  return std::sqrt(numerator.eigenvalue(0).real());
}

// @sect3{Stage 10: tables and files}
//
// Columns have the names that they have in `convergence.csv` of the program signorini. The contact
// force is the integral of -p_H over Gamma_c, and the largest pressure is positive here, too.
void LuoLiang::add_to_tables(const unsigned int level, const unsigned int n_sweeps) {
  const auto add = [&](TableHandler &table, const std::string &column, const double value) {
    table.add_value(column, value);
    table.set_precision(column, parameters.digits);
    table.set_scientific(column, true);
  };
  const auto active = std::count_if(P.begin(), P.end(), [](const double p) { return p < 0.; });
  computation.add_value("level", level);
  computation.add_value("cells", triangulation.n_active_cells());
  computation.add_value("dofs", dof_handler.n_dofs());
  computation.add_value("multipliers", m);
  computation.add_value("active", static_cast<unsigned int>(active));
  computation.add_value("qp_iterations", n_sweeps);
  add(computation, "kkt", kkt_residual());
  add(computation, "energy", energy());
  add(computation, "contact_force_n", -P.mean_value() * m * patch_length());
  add(computation, "max_pressure", -*std::min_element(P.begin(), P.end()));
  add(computation, "contact_length", active * patch_length());

  const ExactDisplacement u;
  Vector<double> superclose(dof_handler.n_dofs());
  VectorTools::interpolate(dof_handler, u, superclose);
  superclose -= U;
  const Vector<double> means = means_of_pressure();
  const auto patch_of = [&](const double x) {
    return static_cast<unsigned int>(x / patch_length());
  };
  const std::vector<double> dual =
    extrapolated_dual_norms({[&](const double x) { return Example::pressure(x) - P[patch_of(x)]; },
                             [&](const double x) { return means[patch_of(x)] - P[patch_of(x)]; }});
  convergence.add_value("level", level);
  add(convergence, "u_h1", h1_distance(u, dof_handler, U));
  add(convergence, "p_l2", l2_error_of_pressure());
  add(convergence, "p_dual", dual[0]);
  add(convergence, "u_superclose_h1",
      h1_distance(Functions::ZeroFunction<dim>(dim), dof_handler, superclose));
  add(convergence, "p_superclose_dual", dual[1]);
  add(convergence, "u_post_h1", h1_distance(u, dof_handler_post, U_post));

  stability.add_value("h", "1/" + std::to_string(1u << level));
  for (const unsigned int ratio : {1u, 2u}) {
    const std::string column = ratio == 1 ? "beta, H = h" : "beta, H = 2h";
    stability.add_value(column, inf_sup_constant(ratio));
    stability.set_precision(column, 3);
  }
}

void LuoLiang::write_vtu(const unsigned int level) const {
  DataOut<dim> data_out;
  const std::vector<DataComponentInterpretation::DataComponentInterpretation> vector(
    dim, DataComponentInterpretation::component_is_part_of_vector);
  data_out.add_data_vector(dof_handler, U, std::vector<std::string>(dim, "u_h"), vector);
  data_out.add_data_vector(dof_handler_post, U_post, std::vector<std::string>(dim, "post_u_h"),
                           vector);
  data_out.build_patches(2);
  std::ofstream file("solution-" + Utilities::int_to_string(level, 2) + ".vtu");
  data_out.write_vtu(file);
}

// Both figures are drawn in SVG, a text that browsers show, so that no other program is needed. The
// unit is 1/600 of the body's height. p is a curve, p_H a step on each patch.
constexpr double unit = 600.;

std::ofstream open_figure(const std::string &name, const double width, const double height) {
  std::ofstream svg(name);
  svg << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-20 -20 " << width + 40. << " "
      << height + 40. << "' fill='none' stroke-width='2'>\n";
  return svg;
}

void LuoLiang::write_pressure() const {
  const double width = unit * parameters.length, height = 0.5 * unit;
  const double scale =
    height / std::max(-*std::min_element(P.begin(), P.end()), -Example::pressure(0.));
  std::ofstream svg = open_figure("pressure.svg", width, height);
  const auto line_through = [&](const char *colour, const auto &points) {
    svg << "<polyline stroke='" << colour << "' points='";
    for (const auto &[x, p] : points)
      svg << unit * x << "," << height + scale * p << " ";
    svg << "'/>\n";
  };
  std::vector<std::pair<double, double>> exact, steps;
  constexpr unsigned int n_points = 500;
  for (unsigned int i = 0; i <= n_points; ++i) {
    const double x = double(i) * parameters.length / n_points;
    exact.emplace_back(x, Example::pressure(x));
  }
  for (unsigned int tau = 0; tau < m; ++tau) {
    steps.emplace_back(tau * patch_length(), P[tau]);
    steps.emplace_back((tau + 1) * patch_length(), P[tau]);
  }
  line_through("#888888",
               std::vector<std::pair<double, double>>{{0., 0.}, {parameters.length, 0.}});
  line_through("#c02020", exact);
  line_through("#2040c0", steps);
  svg << "</svg>\n";
}

// The cells, moved by u_h, and the foundation: the contact side has come to rest on it, or has a
// distance from it still. A fourth of u_h and of the gap is drawn: displacements are small in (1),
// but not in this example.
void LuoLiang::write_deformed_mesh() const {
  constexpr double share = 0.25;
  std::ofstream svg = open_figure("deformed.svg", unit * parameters.length, unit);
  svg << "<polyline stroke='#c02020' stroke-width='4' points='";
  constexpr unsigned int n_points = 500;
  for (unsigned int i = 0; i <= n_points; ++i) {
    const double x = double(i) * parameters.length / n_points;
    svg << unit * (x + share * Example::displacement({x, 0.})[0]) << ","
        << unit * (1. + share * Example::gap(x)) << " ";
  }
  svg << "'/>\n";
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    svg << "<polygon stroke='#2040c0' stroke-width='1' points='";
    for (const unsigned int v : {0, 1, 3, 2}) {
      const double x = cell->vertex(v)[0] + share * U[cell->vertex_dof_index(v, 0)];
      const double y = cell->vertex(v)[1] + share * U[cell->vertex_dof_index(v, 1)];
      svg << unit * x << "," << unit * (1. - y) << " ";
    }
    svg << "'/>\n";
  }
  svg << "</svg>\n";
}

void LuoLiang::print_tables() {
  convergence.omit_column_from_convergence_rate_evaluation("level");
  convergence.evaluate_all_convergence_rates(ConvergenceTable::reduction_rate_log2);
  computation.write_text(std::cout);
  std::cout << "\nErrors and their orders. The paper guarantees, for H = c h,\n"
               "  u_h1              |u - u_h|_1         (13)        1 - eps\n"
               "  p_l2              |p - p_H|_0         (14), (33)  1/2 - eps and 3/4\n"
               "  p_dual            |p - p_H|_-1/2      (15), (32)  1 - eps and 5/4\n"
               "  u_superclose_h1   |I^h u - u_h|_1     (24)        5/4\n"
               "  p_superclose_dual |R^H p - p_H|_-1/2  (25)        5/4\n"
               "  u_post_h1         |u - pi^2h u_h|_1   (31)        5/4\n\n";
  convergence.write_text(std::cout);
  std::cout << "\nThe inf-sup constant (6) on two partitions of the contact side:\n\n";
  stability.write_text(std::cout);
}

// @sect3{Stage 11: all levels}
void LuoLiang::run() {
  for (unsigned int level = parameters.coarsest_level; level <= parameters.finest_level; ++level) {
    if (level > parameters.coarsest_level)
      triangulation.refine_global();
    make_spaces();
    assemble_A_and_f();
    assemble_D(m, sparsity_D, D);
    assemble_G();
    compute_C_and_F();
    const unsigned int n_sweeps = solve_by_psor();
    recover_U();
    interpolate_on_2h();
    add_to_tables(level, n_sweeps);
    if (parameters.write_vtu)
      write_vtu(level);
  }
  if (parameters.write_figures) {
    write_pressure();
    write_deformed_mesh();
  }
  print_tables();
}

// @sect2{Appendices}
//
// @sect3{Appendix A: quadrature at the end of contact}
//
// Forces, pressure and displacement are polynomials to the left and to the right of x = xi, but not
// across it. A Gauss rule on a cell that this line crosses would leave a relative error of about
// 1e-4 in the errors of Theorem 5, and more points help little. We therefore split the interval
// (a, b) of such a cell at xi and use a rule on each part. Four points are exact for polynomials of
// degree seven, and hence for all loads, matrices and errors below: they are exact up to rounding.
Quadrature<1> LuoLiang::gauss_split_at_xi(const double a, const double b) {
  const QGauss<1> gauss(4);
  if (Example::xi <= a || b <= Example::xi)
    return gauss;
  const double cut = (Example::xi - a) / (b - a);
  std::vector<Point<1>> points;
  std::vector<double> weights;
  for (unsigned int q = 0; q < gauss.size(); ++q) {
    points.emplace_back(cut * gauss.point(q)[0]);
    weights.push_back(cut * gauss.weight(q));
    points.emplace_back(cut + (1. - cut) * gauss.point(q)[0]);
    weights.push_back((1. - cut) * gauss.weight(q));
  }
  return Quadrature<1>(points, weights);
}

// On a cell the rule is the product of such a rule in x and a Gauss rule in y. The mesh is uniform,
// so that xi cuts all cells of one column at the same place: two rules are enough, number 1 for
// this column and number 0 for all others.
hp::QCollection<dim> LuoLiang::cell_rules() const {
  const double h = mesh_size(), left = std::floor(Example::xi / h) * h;
  hp::QCollection<dim> rules;
  rules.push_back(QGauss<dim>(4));
  rules.push_back(QAnisotropic<dim>(gauss_split_at_xi(left, left + h), QGauss<1>(4)));
  return rules;
}

unsigned int LuoLiang::rule_on(const CellAccessor<dim> &cell) {
  return cell.vertex(0)[0] < Example::xi && Example::xi < cell.vertex(1)[0] ? 1 : 0;
}

// @sect3{Appendix B: the norm of order -1/2}
//
// (15), (25) and (32) measure pressures in the dual of the norm of Sobolev and Slobodeckij,
//
//   |||q|||_{-1/2}    = sup over phi of (int q phi)/||phi||_{1/2},
//   ||phi||^2_{1/2}   = ||phi||_0^2 + int int (phi(x) - phi(y))^2/(x - y)^2 dx dy,
//
// over Gamma_c, which is the interval (0, Length) here. (The square in the numerator is missing in
// the paper. If Gamma_c had several sides, the norm would be taken on each of them, and their
// squares added.) Such a supremum becomes computable when phi is taken from a finite dimensional
// space. We take the continuous, piecewise linear functions on N equal cells. With b_k = int q
// phi_k and the Gram matrix S of ||.||_{1/2} the supremum is
//
//   |||q|||_N = (b^T S^{-1} b)^{1/2}.
//
// It grows with N, and what is missing falls like N^{-2}. Richardson's extrapolation of two grids,
//
//   |||q||| ~ |||q|||_{2N} + (|||q|||_{2N} - |||q|||_N)/3,
//
// removes the leading part of it. We take N = 8 m cells on m patches.
//
// The double integral is a sum over pairs of cells. In one dimension it does not depend on the size
// of the cells, only on their distance d, counted in cells. On one cell the integrand is the square
// of the slope: the integral is (v_1 - v_0)^2. For neighbours that share the node 1 it is known in
// closed form. Let alpha = v_0 - v_1 and beta = v_2 - v_1; both orders of the two cells give
//
//   2 ((1 - ln 2) (alpha^2 + beta^2) - 2 (ln 2 - 1/2) alpha beta).
//
// For d >= 2 the integrand is smooth, and 12 x 12 Gauss points integrate it to rounding.
using PairMatrix = std::array<std::array<double, 4>, 4>;

// The quadratic form of two cells at the distance d >= 1 in the nodal values (v_0, v_1) of the
// first and (v_2, v_3) of the second one. For d = 1, v_1 and v_2 are values of the same node.
PairMatrix pair_matrix(const unsigned int d) {
  PairMatrix matrix = {};
  const auto add_square = [&](const std::array<double, 4> &w, const double weight) {
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        matrix[i][j] += weight * w[i] * w[j];
  };
  if (d == 1) {
    // 2 alpha beta = (alpha + beta)^2 - alpha^2 - beta^2.
    const double square = 2. * (1. - std::log(2.)), mixed = 2. * (std::log(2.) - 0.5);
    add_square({{1., -1., 0., 0.}}, square + mixed);
    add_square({{0., 0., -1., 1.}}, square + mixed);
    add_square({{1., -1., -1., 1.}}, -mixed);
    return matrix;
  }
  static const QGauss<1> gauss(12);
  for (unsigned int p = 0; p < gauss.size(); ++p)
    for (unsigned int q = 0; q < gauss.size(); ++q) {
      const double x = gauss.point(p)[0], y = gauss.point(q)[0];
      add_square({{1. - x, x, -(1. - y), -y}},
                 2. * gauss.weight(p) * gauss.weight(q) / std::pow(d + y - x, 2));
    }
  return matrix;
}

// S. The first loop adds ||phi||_0^2 and the pairs of each cell with itself.
LAPACKFullMatrix<double> LuoLiang::gram_matrix(const unsigned int n_cells) const {
  const double h = double(parameters.length) / n_cells;
  LAPACKFullMatrix<double> S(n_cells + 1, n_cells + 1);
  for (unsigned int c = 0; c < n_cells; ++c)
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        S(c + i, c + j) += (i == j ? 1. / 3. : 1. / 6.) * h + (i == j ? 1. : -1.);
  for (unsigned int d = 1; d < n_cells; ++d) {
    const PairMatrix pair = pair_matrix(d);
    for (unsigned int c = 0; c + d < n_cells; ++c) {
      const std::array<unsigned int, 4> nodes = {{c, c + 1, c + d, c + d + 1}};
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          S(nodes[i], nodes[j]) += pair[i][j];
    }
  }
  S.set_property(LAPACKSupport::symmetric);
  S.compute_cholesky_factorization();
  return S;
}

// |||q|||_N for several functions q. They must be polynomials of degree three at most on every cell
// of the grid, but for the cut at xi.
std::vector<double> LuoLiang::dual_norms(const Pressures &pressures,
                                         const unsigned int n_cells) const {
  const LAPACKFullMatrix<double> S = gram_matrix(n_cells);
  const double h = double(parameters.length) / n_cells;
  std::vector<double> norms;
  for (const auto &pressure : pressures) {
    Vector<double> b(n_cells + 1);
    for (unsigned int c = 0; c < n_cells; ++c) {
      const Quadrature<1> rule = gauss_split_at_xi(c * h, (c + 1) * h);
      for (unsigned int q = 0; q < rule.size(); ++q) {
        const double s = rule.point(q)[0];
        const double value = pressure((c + s) * h) * rule.weight(q) * h;
        b[c] += (1. - s) * value;
        b[c + 1] += s * value;
      }
    }
    Vector<double> x = b;
    S.solve(x);
    norms.push_back(std::sqrt(b * x));
  }
  return norms;
}

std::vector<double> LuoLiang::extrapolated_dual_norms(const Pressures &pressures) const {
  const std::vector<double> coarse = dual_norms(pressures, 8 * m);
  std::vector<double> norms = dual_norms(pressures, 16 * m);
  for (unsigned int k = 0; k < norms.size(); ++k)
    norms[k] += (norms[k] - coarse[k]) / 3.;
  return norms;
}

// The Gram matrix of Q^H in this norm, B^T S^{-1} B, where column tau of B has the entries
// int_tau phi_k. Eight cells on each patch give beta to about one per cent.
LAPACKFullMatrix<double> LuoLiang::dual_gram_matrix(const unsigned int n_patches) const {
  constexpr unsigned int n_parts = 8;
  const unsigned int n_cells = n_parts * n_patches;
  const double h = double(parameters.length) / n_cells;
  const LAPACKFullMatrix<double> S = gram_matrix(n_cells);
  LAPACKFullMatrix<double> gram(n_patches, n_patches);
  for (unsigned int tau = 0; tau < n_patches; ++tau) {
    Vector<double> x(n_cells + 1);
    for (unsigned int c = n_parts * tau; c < n_parts * (tau + 1); ++c)
      for (unsigned int i = 0; i < 2; ++i)
        x[c + i] += 0.5 * h;
    S.solve(x);
    for (unsigned int c = 0; c < n_cells; ++c)
      gram(c / n_parts, tau) += 0.5 * (x[c] + x[c + 1]) * h;
  }
  return gram;
}
} // namespace

int main(int argc, char **argv) {
  try {
    Parameters parameters;
    if (argc > 1)
      parameters.read(argv[1]);
    LuoLiang(parameters).run();
  } catch (const ExceptionBase &error) {
    std::cerr << "luo_liang:\n";
    error.print_info(std::cerr);
    return 1;
  }
  return 0;
}

// @sect2{Results}
//
// Without parameters the program prints (the lines about the paper's orders are left out here)
//
// level cells dofs multipliers active qp_iterations   kkt     energy   contact_force_n max_pressure
//     2    16   50           2      1             2 0.0e+00 -3.303e-01       7.267e-01    1.453e+00
//     3    64  162           4      3            26 2.0e-11 -3.262e-01       6.254e-01    2.323e+00
//     4   256  578           8      5            42 1.7e-11 -3.289e-01       6.250e-01    2.876e+00
//     5  1024 2178          16     11            62 8.9e-12 -3.299e-01       6.250e-01    3.192e+00
//     6  4096 8450          32     22            80 5.9e-12 -3.301e-01       6.250e-01    3.360e+00
//
// level      u_h1           p_l2          p_dual    u_superclose_h1 p_superclose_dual   u_post_h1
//   2 3.322e-01    - 7.180e-01    - 1.548e-01    - 2.919e-01    -   1.055e-01    -  3.010e-01    -
//   3 1.140e-01 1.54 4.321e-01 0.73 4.125e-02 1.91 7.481e-02 1.96   2.998e-02 1.82  7.884e-02 1.93
//   4 4.783e-02 1.25 2.150e-01 1.01 1.303e-02 1.66 2.041e-02 1.87   9.948e-03 1.59  2.149e-02 1.88
//   5 2.228e-02 1.10 1.053e-01 1.03 4.145e-03 1.65 5.314e-03 1.94   2.972e-03 1.74  5.593e-03 1.94
//   6 1.090e-02 1.03 5.186e-02 1.02 1.359e-03 1.61 1.354e-03 1.97   8.444e-04 1.82  1.425e-03 1.97
//
//    h beta, H = h beta, H = 2h
//  1/4       0.872        0.872
//  1/8       0.700        0.873
// 1/16       0.364        0.873
// 1/32       0.184        0.873
// 1/64       0.093        0.873
//
// The figures are those of the finest level.
//
// @figure{pressure.svg}{The pressures p (red) and p_H (blue) on the contact side.}
//
// @figure{deformed.svg}{The deformed mesh, and the foundation (red). A fourth of u_h and of the gap
// is drawn.}
//
// The contact force of the exact solution is 10 xi^4/4 = 0.625. Its largest pressure is
// 10 xi^3 = 3.536, at the corner; the mean over the patch there tends to it with order one.
//
// * The orders are 1 in (13), 1 in (14) and (33), and 3/2 in (15) and (32); they tend to 2 in (24),
//   (25) and (31). All are higher than those that the paper guarantees.
// * 3/2 in place of 5/4 is no accident. The loss comes from the patches in which contact ends, and
//   disappears if R^H p is replaced by zero on them in the proof.
// * 2 belongs to H = 2h. With Patch ratio = 4 there are displacements in V^h with the mean zero on
//   every patch, on which p does work and p_H does none. Then (24) and (31) fall towards 3/2: 1.74
//   and 1.71 from level 6 to level 7 (`set Patch ratio = 4`, `set Finest level = 7`).
// * For H = 2h the inf-sup constant does not depend on h: 0.873 is the quotient of a smooth
//   pressure. For H = h the pressure +1, -1, +1, ... has a quotient of about 5.9 h, and (6) fails.
//   On the coarsest mesh this is still more than 0.872: the smooth pressure decides there, and both
//   columns agree. With `set Patch ratio = 1` the displacement does not suffer, nor does the smooth
//   pressure of this example. The algorithm does: 159, 615, 3200, 12996 sweeps on the levels 3 to
//   6.
// * On level 5 (`set Finest level = 5`) PSOR takes 5853, 1241, 62, 89, 1158, 5792 sweeps with
//   `set Relaxation` = 0.02, 0.1, 1, 1.5, 1.95, 1.99. The answer is the same, but a small omega
//   stops too early: with the same tolerance in step (iii) the residual is 1.3e-9 for omega = 0.02
//   and 8.9e-12 for omega = 1.
//
// What one could do next: replace PSOR, whose sweeps grow with m, by an active set method, which
// needs two steps on most levels here; replace the factors of A by multigrid; take curved sides and
// other bodies; bound the error without knowing u. The program `signorini` does all of this, and
// doc/paper.md has the proofs of what is said above about 3/2 and 2.
