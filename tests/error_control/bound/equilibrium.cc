// SPDX-License-Identifier: LGPL-2.1-or-later
// The stress of the bound balances its loads against every smooth field, on all meshes and for all
// laws; patch tests are exact; and the bound is a bound.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/stress/equilibrated_stress.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace
{
using Vector2 = dealii::Tensor<1, 2>;

/** A level with its answer and the data of the bound. */
struct Answer
{
  Answer(const std::string &text, const unsigned int number)
    : level(text, number)
    , solution(level.solve())
  {
  }
  StressData data() const
  {
    return {level.space(),
            level.scene,
            level.multipliers(),
            solution.U,
            solution.P,
            level.discretization.n_points};
  }
  /** Disturbs the displacement as a careless solver would. */
  void disturb(const double size)
  {
    RandomNumbers random(7);
    const auto &constraints = level.space().constraints();
    const double scale = size * solution.U.linfty_norm();
    DistributedVector free_values = level.space().make_vector();
    for (unsigned int i = 0; i < solution.U.size(); ++i)
    {
      const double change = constraints.is_constrained(i) ? 0. : scale * random();
      if (level.space().locally_owned().is_element(i))
        free_values(i) = solution.U[i] + change;
    }
    free_values.compress(dealii::VectorOperation::insert);
    solution.U = level.space().complete(free_values);
  }
  OneLevel level;
  LevelSolution<2> solution;
};

/** A polynomial of degree three in each component with random coefficients, times what makes it
 * vanish on clamped and prescribed sides; its normal component vanishes on the first roller. */
class TestField
{
public:
  TestField(const Scene<2> &scene, const int seed)
  {
    RandomNumbers random(seed);
    for (auto &component : coefficients_)
      for (double &c : component)
        c = random();
    for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    {
      const auto &side = scene.geometry.sides[i];
      const Role role = scene.boundary[i].role;
      if (role == Role::clamped || role == Role::displacement)
        zero_at_.emplace_back(side.start(), side.normal(0.));
      else if (role == Role::roller)
        rollers_.emplace_back(side.start(), side.normal(0.));
    }
  }
  Vector2 value(const dealii::Point<2> &x) const
  {
    Vector2 v;
    for (unsigned int c = 0; c < 2; ++c)
    {
      unsigned int i = 0;
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; a + b < 3; ++b)
          v[c] += coefficients_[c][i++] * std::pow(x[0] - 0.3, a) * std::pow(x[1] - 0.4, b);
    }
    for (const auto &line : zero_at_)
      v *= (x - line.first) * line.second;
    for (const auto &line : rollers_)
      v += (v * line.second) * ((x - line.first) * line.second - 1.) * line.second;
    return v;
  }
  /** (e11, e22, 2 e12), by differences: exact for polynomials of the degree five. */
  Components strain(const dealii::Point<2> &x) const
  {
    std::array<Vector2, 2> d;
    constexpr double step = 0.1;
    for (unsigned int j = 0; j < 2; ++j)
    {
      Vector2 e;
      e[j] = step;
      d[j] = (45. * (value(x + e) - value(x - e)) - 9. * (value(x + 2. * e) - value(x - 2. * e)) +
              (value(x + 3. * e) - value(x - 3. * e))) /
             (60. * step);
    }
    return Components({d[0][0], d[1][1], d[0][1] + d[1][0]});
  }

private:
  std::array<std::array<double, 6>, 2> coefficients_;
  std::vector<std::pair<dealii::Point<2>, Vector2>> zero_at_, rollers_;
};

/** A sum and the sum of the sizes of its terms. */
struct Work
{
  double sum = 0., size = 0.;
  void add(const double term)
  {
    sum += term;
    size += std::abs(term);
  }
};

/** int_K tau:eps(v) - f_h.v, with products of polynomials integrated exactly. */
void add_cell(const EquilibratedStress &stress,
              const unsigned int c,
              const TestField &field,
              Work &work)
{
  const EdgeCell &cell = stress.mesh().cells()[c];
  const CellShape shape(cell.corners);
  const dealii::QWitherdenVincentSimplex<2> rule(6);
  const CellBasis basis(shape, rule);
  const CellLoad load = stress.load(c);
  const std::vector<Components> tau = stress.stress(c, basis);
  for (std::size_t i = 0; i < tau.size(); ++i)
  {
    const CellBasis::PointOfCell &point = basis.points[i];
    const dealii::Point<2> x = cell.corners[0] + point.offset;
    const Vector2 xi = 2. * shape.reference(point.offset) - dealii::Point<2>(1., 1.);
    const Vector2 f = load.constant[i / rule.size()] + shape.half_edges() * (load.slope * xi);
    const Components e = field.strain(x);
    for (unsigned int l = 0; l < 3; ++l)
      work.add(point.weight * tau[i][l] * e[l]);
    work.add(-point.weight * (f * field.value(x)));
  }
}

bool is_free_contact(const EquilibratedStress &stress,
                     const Scene<2> &scene,
                     const unsigned int number)
{
  const Edge &edge = stress.mesh().edges()[number];
  return edge.freedom == EdgeFreedom::normal && scene.boundary[edge.side].role == Role::contact;
}

/** -int_e t_h.v on edges where tractions are given, t_h with the moments of the scene's data, and
 * on contact edges whose normal traction is free. */
void add_edges(const EquilibratedStress &stress,
               const GivenTractions &given,
               const Mesh<2> &mesh,
               const Scene<2> &scene,
               const TestField &field,
               Work &work)
{
  const dealii::QGauss<1> rule(6);
  const auto &vertices = mesh.triangulation().get_vertices();
  for (unsigned int e = 0; e < stress.mesh().edges().size(); ++e)
  {
    const Edge &edge = stress.mesh().edges()[e];
    const bool is_free = is_free_contact(stress, scene, e);
    if (edge.freedom != EdgeFreedom::none && !is_free)
      continue;
    const std::vector<double> &moments = is_free ? stress.moments() : given.moments;
    const dealii::Point<2> a = vertices[edge.vertices[0]], b = vertices[edge.vertices[1]];
    for (unsigned int i = 0; i < rule.size(); ++i)
    {
      const double s = rule.point(i)[0];
      const Vector2 v = field.value(a + s * (b - a));
      work.add(-(linear_traction(&moments[4 * e], s) * v) * rule.weight(i));
    }
  }
}

/** The work of the stress minus that of its loads, relative to the sum of all terms' sizes. */
double imbalance(const Answer &answer, const ImprovementOptions &options, const int seed)
{
  const StressData data = answer.data();
  const EquilibratedStress stress(data, options);
  const GivenTractions given =
    given_tractions(data.space, data.scene, stress.mesh(), data.multipliers, data.P, data.n_points);
  const TestField field(data.scene, seed);
  Work work;
  for (unsigned int c = 0; c < stress.mesh().cells().size(); ++c)
    add_cell(stress, c, field, work);
  add_edges(stress, given, data.space.mesh(), data.scene, field, work);
  return std::abs(work.sum) / work.size;
}

std::string section(const std::string &name, const std::string &lines)
{
  return "subsection " + name + "\n" + lines + "\nend\n";
}

const std::string rectangle_sides = section("Boundary",
                                            "set Clamped = top\nset Contact = bottom\n"
                                            "set Traction = right: 0.1; 0.2*y*y");
const std::string body_force = entry("Load", "Body force", "0.1+x*y; -0.5*x-sin(3*y)");
const std::string gap = entry("Contact", "Gap", "-0.05+0.1*x");
const std::string loaded = rectangle_sides + body_force + gap;

const std::vector<std::pair<std::string, std::string>> &scenes()
{
  static const std::vector<std::pair<std::string, std::string>> list = {
    {"rectangles", loaded},
    {"thin cells", loaded + section("Geometry", "set Upper right = 20, 1")},
    {"distorted", loaded + section("Geometry", "set Distortion = 0.2")},
    {"patches that end inside faces", loaded + section("Discretization", "set Patches = 3")},
    {"plane stress, E(x)",
     loaded + section("Material",
                      "set Young's modulus = 2+sin(5*x)*y\nset Poisson's ratio = 0.3\n"
                      "set Plane state = stress")},
    {"orthotropic",
     loaded + section("Material",
                      "set Law = orthotropic\nset Orthotropic moduli = 10; 1; 0.4; 0.7\n"
                      "set Orientation = 30")},
    {"B-bar", loaded + section("Discretization", "set Element = Q1 B-bar")},
    {"quadrilateral",
     section("Geometry", "set Shape = polygon\nset Vertices = 0,0; 1.2,0; 1,0.9; 0.1,1.1") +
       section("Boundary",
               "set Clamped = side2\nset Contact = side0\n"
               "set Traction = side1: -0.05; 0.02*y | side3: 0.03; -0.01") +
       body_force + gap},
    {"pentagon with an oblique roller and a prescribed side",
     section("Geometry", "set Shape = polygon\nset Vertices = 0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1") +
       section("Boundary",
               "set Contact = side0 side4\nset Rollers = side1\n"
               "set Displacement = side3: 0.01; -0.02") +
       entry("Load", "Body force", "-0.1; -0.2") + entry("Contact", "Gap", "0")},
    {"two rollers",
     section("Boundary",
             "set Rollers = left top\nset Contact = bottom\nset Traction = right: -0.2; 0.1*y") +
       body_force + gap}};
  return list;
}

/** On contact edges whose traction is free it has no shear and does not pull. */
void contact_tractions(Checks &checks, const std::string &name, const Answer &answer)
{
  const EquilibratedStress stress(answer.data());
  unsigned int n_free = 0;
  double shear = 0., largest = 0., pull = 0.;
  for (unsigned int e = 0; e < stress.mesh().edges().size(); ++e)
  {
    const Edge &edge = stress.mesh().edges()[e];
    if (!is_free_contact(stress, answer.level.scene, e))
      continue;
    ++n_free;
    for (const double end : {0., 1.})
    {
      const Vector2 t = linear_traction(&stress.moments()[4 * e], end);
      largest = std::max(largest, t.norm());
      shear = std::max(shear, std::abs(cross(edge.normal, t)));
      pull = std::max(pull, t * edge.normal);
    }
  }
  checks.that(name + ": free contact edges", n_free > 0);
  checks.near(name + ": no shear", shear, 0., 1e-14 * largest);
  checks.that(name + ": no pull", pull == 0.);
}

void equilibrium(Checks &checks)
{
  for (const auto &scene : scenes())
    try
    {
      Answer answer(scene.second, 3);
      checks.near(scene.first + ": at the start", imbalance(answer, {0, 0.01}, 1), 0., 1e-12);
      checks.near(scene.first + ": improved", imbalance(answer, {5, 0.}, 2), 0., 1e-12);
      const EquilibratedStress stress(answer.data());
      checks.near(scene.first + ": algebra", stress.bound().algebra, 0., 1e-11);
      contact_tractions(checks, scene.first, answer);
      answer.disturb(1e-4);
      const StressBound disturbed = EquilibratedStress(answer.data()).bound();
      checks.that(scene.first + ": disturbed and balanced",
                  disturbed.algebra > 1e-6 && disturbed.balanced);
      checks.near(scene.first + ": disturbed", imbalance(answer, {0, 0.01}, 3), 0., 1e-12);
    }
    catch (const std::exception &exception)
    {
      checks.that(scene.first + ": " + exception.what(), false);
    }
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);
  equilibrium(checks);
  return checks.exit_code();
}
