// SPDX-License-Identifier: LGPL-2.1-or-later
// Every catalogue scene with an exact solution: values from an independent program, and the
// equations of (1) by differences.

#include <signorini/problem/catalogue/catalogue.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>

#include <algorithm>
#include <cmath>

#include "tests.h"

using namespace Signorini;

namespace
{
using Point = dealii::Point<2>;
using Stress = dealii::SymmetricTensor<2, 2>;

Stress stress(const Scene<2> &scene, const Point &x)
{
  const auto du1 = scene.exact_displacement->gradient(x, 0);
  const auto du2 = scene.exact_displacement->gradient(x, 1);
  Stress strain;
  strain[0][0] = du1[0];
  strain[1][1] = du2[1];
  strain[0][1] = 0.5 * (du1[1] + du2[0]);
  return scene.material->hooke(x) * strain;
}

struct Sample
{
  std::string name;
  /** u1, u2, f1, f2, s11, s22, s12 at (0.3, 0.4); p and g at x = 0.3 and x = 0.8 of the bottom. */
  std::vector<double> values;
};

/** D1 stands in scenes.cc. */
const std::vector<Sample> samples = {
  {"A1",
   {-0.00588,
    -0.0646488880953,
    -2.17232035206,
    1.15442425325,
    0.208648149376,
    -0.314855551871,
    0.540072729128,
    -0.674722215136,
    -0.021,
    0,
    -0.00737084989848}},
  {"A1L",
   {-0.00588,
    -0.0646488880953,
    -2.17232035206,
    1.15442425325,
    0.208648149376,
    -0.314855551871,
    0.540072729128,
    -0.674722215136,
    -0.021,
    0,
    0.011867965644}},
  {"A2",
   {-0.00588,
    0.01092,
    -0.448666666667,
    0.038,
    0.3256,
    0.036,
    -0.0168,
    0,
    0.0592198245486,
    -0.926963042709,
    -0.016}},
  {"A3",
   {-0.0527558053156,
    -0.0262739529623,
    -1.08919655128,
    -1.57581525154,
    -0.51587398312,
    -0.653707246416,
    -0.455639808669,
    -0.814213562373,
    -0.0553409176183,
    0,
    0.0405212555028}},
  {"B1",
   {-0.0242181967967,
    -0.0489067511214,
    -0.449707404221,
    -1.30772681059,
    -0.624968917664,
    -0.363422684223,
    -0.18275869189,
    -0.63804919966,
    0,
    0,
    0}},
  {"B2",
   {0.108667866821,
    0.0255254554876,
    0.331108627282,
    0.0110794390296,
    -1.38853987912,
    -0.162833625409,
    -0.0654960106995,
    0,
    0,
    0,
    0}},
  {"B3",
   {0.00892671459183,
    -0.0327479012783,
    0.0936296934029,
    -0.405158823584,
    0.0109585558963,
    0.003661679636,
    0.0294955628521,
    0,
    0.0293730437689,
    0,
    0.0684487100945}},
  {"B4",
   {-0.309224568007,
    -0.17075419907,
    -1.32080288746,
    -2.46768441376,
    -0.52019932991,
    -0.167336930511,
    -0.0123912173283,
    -0.945741609003,
    0.11348899308,
    0,
    -0.116429809617}},
  {"C1",
   {-0.00588,
    -0.278911948257,
    -1.32975530667,
    -6.82241989175,
    -0.122949443731,
    -1.30964833119,
    0.26785940677,
    -2.58778525229,
    -0.021,
    -1.19098300563,
    -0.016}},
  {"C2", {-0.00588, 0.01092, -0.448666666667, 0.038, 0.3256, 0.036, -0.0168, 0, 0.079, 0, 0.084}},
  {"C3",
   {-0.00588,
    0.0109191788861,
    -0.449512251017,
    0.0985766069012,
    0.325598729228,
    0.0359961876853,
    -0.0165268112098,
    -7.33137435857e-06,
    -0.021,
    0,
    -0.00737084989848}},
  {"C4",
   {-0.0843648,
    0.100493568,
    6.1840896,
    -5.8545024,
    -0.68812224,
    0.18536128,
    1.71035136,
    -1.102736,
    0,
    0,
    0.00862915010152}},
  {"O1",
   {0.0519840763419,
    -0.153492000207,
    -5.35358622862,
    1.80077819027,
    -0.572594268675,
    -0.298526627941,
    0.71608600489,
    -0.674722215136,
    -0.021,
    0,
    -0.00737084989848}},
  {"V1",
   {-0.00588,
    -0.0646488880953,
    -3.34492697171,
    1.43338755934,
    0.296433831243,
    -0.447326457523,
    0.767300494751,
    -0.865210625341,
    -0.021,
    0,
    -0.00737084989848}}};

void test_sample(Checks &checks, const Sample &sample)
{
  const Scene<2> scene =
    make_scene<2>(parse_parameters("", "a.prm", {"Scene/Name=" + sample.name}));
  const Point x(0.3, 0.4);
  const Stress s = stress(scene, x);
  const BoundaryCondition<2> &bottom = scene.boundary.at(scene.geometry.find_side("bottom"));
  const auto force = [&](const unsigned int c) {
    return scene.body_force == nullptr ? 0. : scene.body_force->value(x, c);
  };
  const std::vector<double> found = {scene.exact_displacement->value(x, 0),
                                     scene.exact_displacement->value(x, 1),
                                     force(0),
                                     force(1),
                                     s[0][0],
                                     s[1][1],
                                     s[0][1],
                                     bottom.exact_pressure->value(Point(0.3, 0.)),
                                     bottom.data->value(Point(0.3, 0.)),
                                     bottom.exact_pressure->value(Point(0.8, 0.)),
                                     bottom.data->value(Point(0.8, 0.))};
  // Twelve digits are known.
  double off = 0.;
  for (unsigned int i = 0; i < found.size(); ++i)
    off = std::max(
      off, std::abs(found[i] - sample.values[i]) / std::max(1e-2, std::abs(sample.values[i])));
  checks.near(sample.name + ": sample values", off, 0., 2e-11);
}

/** Fourth-order difference of a vector in direction d. */
template <typename Function>
auto difference(const Function &f, const Point &x, const unsigned int d)
{
  const double h = 5e-4;
  const dealii::Tensor<1, 2> step = h * Point::unit_vector(d);
  return (8. * (f(x + step) - f(x - step)) - (f(x + 2. * step) - f(x - 2. * step))) / (12. * h);
}

/** grad u and -div sigma = f at points away from kinks. */
void test_interior(Checks &checks, const Scene<2> &scene)
{
  const auto u = [&](const Point &x) {
    return Point(scene.exact_displacement->value(x, 0), scene.exact_displacement->value(x, 1));
  };
  const auto sigma = [&](const Point &x) { return stress(scene, x); };
  double gradient = 0., balance = 0.;
  const std::vector<Point> in_square = {
    Point(0.3, 0.4), Point(0.62, 0.23), Point(0.85, 0.7), Point(0.1, 0.9)};
  const std::vector<Point> in_circle = {
    Point(1.2, 0.4), Point(0.45, -0.7), Point(-0.15, -0.95), Point(0.1, -0.8), Point(-0.9, 1.2)};
  for (const Point &x : scene.geometry.curved ? in_circle : in_square)
  {
    const Stress ds[2] = {difference(sigma, x, 0), difference(sigma, x, 1)};
    for (unsigned int c = 0; c < 2; ++c)
    {
      const auto du = scene.exact_displacement->gradient(x, c);
      for (unsigned int d = 0; d < 2; ++d)
        gradient = std::max(gradient, std::abs(du[d] - difference(u, x, d)[c]));
      const double f = scene.body_force == nullptr ? 0. : scene.body_force->value(x, c);
      balance = std::max(balance, std::abs(ds[0][c][0] + ds[1][c][1] + f));
    }
  }
  checks.near(scene.name + ": gradient", gradient, 0., 1e-8);
  checks.near(scene.name + ": -div sigma = f", balance, 0., 1e-7);
}

/** What each role of a side asks of the exact solution. */
void test_sides(Checks &checks, const Scene<2> &scene)
{
  double held = 0., loaded = 0., pressed = 0., product = 0., sign = -1.;
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
  {
    const BoundaryCondition<2> &condition = scene.boundary[i];
    const Side<2> &side = scene.geometry.sides[i];
    for (const double share : {0.01, 0.21, 0.4, 0.55, 0.76, 0.99})
    {
      const double s = share * side.length();
      const Point x = side.point(s);
      const auto t = stress(scene, x) * side.normal(s);
      const Point u(scene.exact_displacement->value(x, 0), scene.exact_displacement->value(x, 1));
      if (condition.role == Role::clamped)
        held = std::max(held, u.norm());
      if (condition.role == Role::free)
        loaded = std::max(loaded, t.norm());
      if (condition.role == Role::traction)
        loaded = std::max(
          loaded, (t - Point(condition.data->value(x, 0), condition.data->value(x, 1))).norm());
      if (condition.role != Role::contact)
        continue;
      const double p = condition.exact_pressure->value(x);
      const double w = u * side.normal(s) - condition.data->value(x);
      pressed = std::max(pressed, (t - p * side.normal(s)).norm());
      product = std::max(product, std::abs(p * w));
      sign = std::max({sign, p, w});
    }
  }
  checks.near(scene.name + ": clamped", held, 0., 1e-14);
  checks.near(scene.name + ": tractions", loaded, 0., 1e-13);
  checks.near(scene.name + ": sigma n = p n", pressed, 0., 1e-13);
  checks.near(scene.name + ": p w = 0", product, 0., 1e-14);
  checks.between(scene.name + ": p <= 0, w <= 0", sign, -1., 1e-14);
}
/** E2 at r = 1.5, theta = 0.7 and on its circle, from an independent program. */
void test_e2(Checks &checks)
{
  const Scene<2> scene = make_scene<2>(parse_parameters("", "a.prm", {"Scene/Name=E2"}));
  const auto at = [](const double r, const double theta) {
    return Point(r * std::cos(theta), r * std::sin(theta));
  };
  const Point x = at(1.5, 0.7);
  const auto near = [&](const std::string &name, const double value, const double expected) {
    checks.near("E2: " + name, value, expected, 1e-11);
  };
  near("u1", scene.exact_displacement->value(x, 0), 0.0263044093388);
  near("u2", scene.exact_displacement->value(x, 1), 0.0453764564707);
  near("f1", scene.body_force->value(x, 0), 0.666834800541);
  near("f2", scene.body_force->value(x, 1), 0.818676393806);
  const BoundaryCondition<2> &contact = scene.boundary[scene.geometry.find_side("outer")];
  near("p(0.7)", contact.exact_pressure->value(at(2., 0.7)), -0.301326871725);
  near("g(0.7)", contact.data->value(at(2., 0.7)), 0.00849835714501);
  near("g(2)", contact.data->value(at(2., 2.)), 0.223750964705);
}
} // namespace

int main()
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  for (const Sample &sample : samples)
    test_sample(checks, sample);
  test_e2(checks);
  for (const CatalogueEntry<2> &entry : catalogue<2>())
  {
    const Scene<2> scene =
      make_scene<2>(parse_parameters("", "a.prm", {"Scene/Name=" + entry.name}));
    if (scene.exact_displacement == nullptr)
      continue;
    test_interior(checks, scene);
    test_sides(checks, scene);
  }
  return checks.exit_code();
}
