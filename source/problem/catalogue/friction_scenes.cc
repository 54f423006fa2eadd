// SPDX-License-Identifier: LGPL-2.1-or-later
// T1 to T4, K1: lifted tractions with friction. TS, KS, KSr, KO, KOr, CM: fields of complex
// functions, singular where stick, slip or contact ends. Unit square, contact at y = 0, lambda = mu
// = 1.

#include <deal.II/base/numbers.h>

#include <cmath>
#include <complex>

#include "catalogue_scenes.h"
#include "manufactured.h"

namespace Signorini {
namespace {
/** The data of a scene on y = 0 as functions of x: tractions p and q, f or s, the gap and g_t. */
struct FrictionData {
  Friction law = Friction::tresca;
  std::function<double(double)> p, q, friction, gap, shift = [](double) { return 0.; };
};

Scene<2> frictional_square(const FrictionData &data, const Formula<2> &u,
                           const std::vector<double> &kinks_at_x) {
  const auto of_x = [](const std::function<double(double)> &f) {
    return function_of<2>([f](const Point<2> &x) { return f(x[0]); });
  };
  Scene<2> scene = contact_scene<2>(
    make_rectangle({0., 0.}, {1., 1.}, {1, 1}), isotropic<2>(), "top", "bottom",
    [g = data.gap](const Point<2> &x) { return g(x[0]); },
    [p = data.p](const Point<2> &x) { return p(x[0]); });
  scene.friction = data.law;
  BoundaryCondition<2> &contact = scene.boundary[scene.geometry.find_side("bottom")];
  contact.friction = of_x(data.friction);
  contact.shift = of_x(data.shift);
  contact.exact_friction = of_x(data.q);
  scene.kinks = lines_at<2>({{kinks_at_x, {}}});
  set_exact_solution<2>(scene, u);
  return scene;
}

// Lifted tractions: u1 = (V - y (q + U')) c, u2 = (U + y (p - V')/3) c, c = 1 - y², U = 0.1 x
// (1-x).

using FunctionOfX = std::function<Jet2(const Jet2 &)>;
const double end_of_contact = numbers::SQRT1_2, end_of_stick = 1. / std::sqrt(5.);

Jet2 behind(const Jet2 &x, const double end) {
  return positive_part(x - end);
}
Jet2 before(const Jet2 &x, const double end) {
  return positive_part(end - x);
}
/** -10 (xi-x)_+³ */
Jet2 ending_pressure(const Jet2 &x) {
  return -10. * cube(before(x, end_of_contact));
}
Jet2 full_pressure(const Jet2 &x) {
  return -(2. + sin(numbers::PI * (x + 0.5)));
}
Jet2 bound(const Jet2 &x) {
  return 0.5 + 0.3 * x;
}
/** -s + 10 (xs-x)_+³: less than s where x < xs, which sticks. */
Jet2 ending_stick(const Jet2 &s, const Jet2 &x) {
  return 10. * cube(before(x, end_of_stick)) - s;
}
/** The slip V = (x-xs)_+⁴ and its derivative. */
Jet2 ending_slip(const Jet2 &x) {
  return behind(x, end_of_stick) * cube(behind(x, end_of_stick));
}
Jet2 slope_of_slip(const Jet2 &x) {
  return 4. * cube(behind(x, end_of_stick));
}

/** A lifted scene; contact ends at xi if it is open behind. */
struct LiftedFriction {
  FunctionOfX p, q, V, dV;
  Friction law = Friction::tresca;
  std::function<double(double)> friction = [](const double x) { return 0.5 + 0.3 * x; };
  bool opens = false;
  std::vector<double> kinks = {};
};

Scene<2> lifted_friction(const LiftedFriction &given) {
  const auto value = [](const FunctionOfX &f) {
    return [f](const double x) { return f(x).value; };
  };
  FrictionData data = {given.law, value(given.p), value(given.q), given.friction,
                       [opens = given.opens](const double x) {
                         const double slack = opens ? std::max(x - end_of_contact, 0.) : 0.;
                         return slack * slack - 0.1 * x * (1. - x);
                       }};
  return frictional_square(
    data,
    [given](const Jets2 &at) {
      const Jet2 &x = at[0], &y = at[1];
      const Jet2 cut = 1. - y * y, U = 0.1 * x * (1. - x), dU = 0.1 - 0.2 * x;
      return Jets2{(given.V(x) - y * (given.q(x) + dU)) * cut,
                   (U + y * (given.p(x) - given.dV(x)) / 3.) * cut};
    },
    given.kinks);
}

Scene<2> make_t1() {
  return lifted_friction({ending_pressure,
                          [](const Jet2 &x) { return ending_stick(bound(x), x); },
                          ending_slip,
                          slope_of_slip,
                          Friction::tresca,
                          [](const double x) { return 0.5 + 0.3 * x; },
                          true,
                          {end_of_stick, end_of_contact}});
}

Scene<2> make_t2() {
  return lifted_friction({full_pressure,
                          [](const Jet2 &x) { return ending_stick(bound(x), x); },
                          ending_slip,
                          slope_of_slip,
                          Friction::tresca,
                          [](const double x) { return 0.5 + 0.3 * x; },
                          false,
                          {end_of_stick}});
}

Scene<2> make_t3() {
  return lifted_friction({full_pressure, [](const Jet2 &x) { return -bound(x); },
                          [](const Jet2 &x) { return 0.1 + 0.05 * sin(x); },
                          [](const Jet2 &x) { return 0.05 * sin(x + 0.5 * numbers::PI); }});
}

Scene<2> make_t4() {
  return lifted_friction(
    {full_pressure, [](const Jet2 &x) { return 0.4 * sin(2. * x + 0.5 * numbers::PI); },
     [](const Jet2 &) { return Jet2(); }, [](const Jet2 &) { return Jet2(); }});
}

Scene<2> make_k1() {
  constexpr double f = 0.3;
  return lifted_friction({ending_pressure,
                          [](const Jet2 &x) { return ending_stick(-f * ending_pressure(x), x); },
                          ending_slip,
                          slope_of_slip,
                          Friction::coulomb,
                          [](const double) { return f; },
                          true,
                          {end_of_stick, end_of_contact}});
}

// Singular fields: u = (1 - y²) w, and with kappa = 2, mu = 1 w is a sum of
//   2 w1 = (kappa-c) Re F - 2 y Im F',   2 w2 = (kappa+c) Im F - 2 y Re F'.
// On y = 0:  c = 1 (F' = Z/2): s22 = Re Z, s12 = 0;   c = -1 (F' = -i Z/2): s12 = Re Z, s22 = 0;
// c = -kappa (a roller: u2 = 0): s12 = -(kappa+1) Im F', s22 = (1-kappa) Re F'.

using Complex = std::complex<double>;
constexpr double kappa = 2.;
const Complex imaginary(0., 1.);

/** F, F' and F'' at a point of the upper half-plane. */
struct ComplexJet {
  Complex F, dF, ddF;

  ComplexJet operator+(const ComplexJet &other) const {
    return {F + other.F, dF + other.dF, ddF + other.ddF};
  }
};
ComplexJet operator*(const Complex &factor, const ComplexJet &f) {
  return {factor * f.F, factor * f.dF, factor * f.ddF};
}
using ComplexFunction = std::function<ComplexJet(const Complex &)>;

/** Returns t^(1+e) with its derivatives, t = z - xi. */
ComplexJet power_of(const Complex &z, const double xi, const double e) {
  const Complex t = z - xi;
  if (t == Complex(0.))
    return {};
  return {std::pow(t, 1. + e), (1. + e) * std::pow(t, e), (1. + e) * e * std::pow(t, e - 1.)};
}

enum class Mode { opening = 1, sliding = -1, roller = -2 };

/** Returns w of one function. Its second derivatives are left out, because -div sigma(w) = 0. */
Jets2 mode_field(const ComplexFunction &F, const Mode mode, const Jets2 &at) {
  const double y = std::abs(at[1].value), c = static_cast<double>(mode);
  const ComplexJet f = F(Complex(at[0].value, y));
  // y F'' -> 0 on y = 0.
  const Complex yddF = y > 0. ? y * f.ddF : Complex(0.);
  const double less = 0.5 * (kappa - c), more = 0.5 * (kappa + c);
  return {Jet2(less * f.F.real() - y * f.dF.imag(),
               Tensor<1, 2>(
                 {less * f.dF.real() - yddF.imag(), -(less + 1.) * f.dF.imag() - yddF.real()})),
          Jet2(more * f.F.imag() - y * f.dF.real(),
               Tensor<1, 2>(
                 {more * f.dF.imag() - yddF.real(), (more - 1.) * f.dF.real() + yddF.imag()}))};
}

/** Returns u = (1 - y²) (w + constant stress s22, s12). */
Jets2 cut_off(const Jets2 &w, const double s22, const double s12, const Jets2 &at) {
  const Jet2 cut = 1. - at[1] * at[1];
  return {cut * (w[0] + s12 * at[1]), cut * (w[1] + s22 / 3. * at[1])};
}

/** Returns stick before xi and slip behind it, with F = a t^(1+e), c = -kappa, and a constant
 * stress -p0, s12. With a = |a| e^{i alpha} and e = 1/2 - alpha/pi, Re F = 0 on the side of stick.
 */
Scene<2> stick_and_slip(const Friction law, const double friction, const Complex &a, const double e,
                        const double p0, const double s12, const double xi) {
  const auto dF = [=](const double x) { return a * power_of(Complex(x, 0.), xi, e).dF; };
  return frictional_square(
    {law, [=](const double x) { return (1. - kappa) * (x > xi ? dF(x).real() : 0.) - p0; },
     [=](const double x) { return (kappa + 1.) * dF(x).imag() - s12; },
     [=](const double) { return friction; }, [](const double) { return 0.; }},
    [=](const Jets2 &at) {
      return cut_off(
        mode_field([=](const Complex &z) { return a * power_of(z, xi, e); }, Mode::roller, at), -p0,
        s12, at);
    },
    {xi});
}

Scene<2> make_ts(const double xi) {
  return stick_and_slip(Friction::tresca, 1., 0.5, 0.5, 1., 1., xi);
}

/** The angle arctan f (kappa-1)/(kappa+1). */
double angle_of(const double f) {
  return std::atan(f * (kappa - 1.) / (kappa + 1.));
}

/** KS for sign = 1: slip away from the zone of stick; KSr for sign = -1: towards it. */
Scene<2> make_ks(const double sign) {
  constexpr double f = 0.5, p0 = 2.;
  const double alpha = -sign * angle_of(f);
  return stick_and_slip(Friction::coulomb, f, sign * 0.3 * std::exp(imaginary * alpha),
                        0.5 - alpha / numbers::PI, p0, sign * f * p0, end_of_contact);
}

/** KO for sign = 1, KOr for sign = -1: sliding before xi, open behind it. */
Scene<2> make_ko(const double sign) {
  constexpr double f = 0.5;
  const double e = 0.5 - sign * angle_of(f) / numbers::PI, xi = end_of_contact;
  const auto F = [=](const Complex &z) { return 0.5 / (1. + e) * imaginary * power_of(z, xi, e); };
  const auto p = [=](const double x) {
    return x < xi ? -std::sin(numbers::PI * e) * std::pow(xi - x, e) : 0.;
  };
  return frictional_square(
    {Friction::coulomb, p, [=](const double x) { return sign * f * p(x); },
     [](const double) { return f; }, [](const double) { return 0.; }},
    [=](const Jets2 &at) {
      const Jets2 opening = mode_field(F, Mode::opening, at),
                  sliding =
                    mode_field([=](const Complex &z) { return sign * f * imaginary * F(z); },
                               Mode::sliding, at);
      // The body moves on, so that all of it slides.
      const Jets2 w = {opening[0] + sliding[0] + sign * 0.6, opening[1] + sliding[1]};
      return cut_off(w, 0., 0., at);
    },
    {xi});
}

/** Returns F = int Z/2 of Hertz' contact on (m - r, m + r): Z = 2 i (R - (z-m)). */
ComplexJet hertz(const Complex &z, const double m, const double r) {
  const Complex t = z - m, R = std::sqrt(t - r) * std::sqrt(t + r);
  return imaginary *
         ComplexJet{0.5 * (t * R - r * r * std::log((t + R) / r) - t * t), R - t, t / R - 1.};
}

} // namespace

Scene<2> make_cattaneo_mindlin(const bool unloaded) {
  constexpr double f = 0.4;
  const double a = 1. / std::sqrt(10.), b = numbers::E / 4., m = 0.5 * (a + b), r = 0.5 * (b - a);
  // q is the sum of Hertz' pressures on shares of the width.
  struct Part {
    double weight, radius;
  };
  const std::vector<Part> parts = unloaded
                                    ? std::vector<Part>{{-1., r}, {2., 0.85 * r}, {-1., 0.6 * r}}
                                    : std::vector<Part>{{1., r}, {-1., 0.6 * r}};
  const auto root = [=](const double x, const double radius) {
    return 2. * std::sqrt(std::max(radius * radius - (x - m) * (x - m), 0.));
  };
  const ComplexFunction opening = [=](const Complex &z) { return hertz(z, m, r); };
  const ComplexFunction sliding = [=](const Complex &z) {
    ComplexJet sum;
    for (const Part &part : parts)
      sum = sum + -f * part.weight * imaginary * hertz(z, m, part.radius);
    return sum;
  };
  const auto w = [=](const ComplexFunction &F, const Mode mode, const double x) {
    return mode_field(F, mode, Jets2{Jet2(x), Jet2(0.)});
  };
  std::vector<double> kinks;
  for (const Part &part : parts)
    kinks.insert(kinks.end(), {m - part.radius, m + part.radius});
  // The foundation takes the coupling of both modes.
  return frictional_square(
    {Friction::coulomb, [=](const double x) { return -root(x, r); },
     [=](const double x) {
       double q = 0.;
       for (const Part &part : parts)
         q += f * part.weight * root(x, part.radius);
       return q;
     },
     [=](const double) { return f; },
     [=](const double x) {
       return 0.75 * (x - m) * (x - m) - w(sliding, Mode::sliding, x)[1].value;
     },
     [=](const double x) {
       return w(opening, Mode::opening, x)[0].value + w(sliding, Mode::sliding, m)[0].value;
     }},
    [=](const Jets2 &at) {
      const Jets2 I = mode_field(opening, Mode::opening, at),
                  II = mode_field(sliding, Mode::sliding, at);
      return cut_off({I[0] + II[0], I[1] + II[1]}, 0., 0., at);
    },
    kinks);
}

namespace {
const std::string frame =
  "Body      the unit square 0 < x < 1, 0 < y < 1\n"
  "Material  E = 2.5, nu = 0.25 (lambda = mu = 1), plane strain\n"
  "Boundary  clamped at y = 1, contact at y = 0, traction sigma(u) n on x = 0 "
  "and x = 1\n"
  "Load      body force -div sigma(u)\n";
const std::string lifted_frame =
  frame + "Exact u   u1 = (V - y (q + U')) (1 - y^2), u2 = (U + y (p - V')/3) (1 - y^2),\n"
          "          U = 0.1 x (1-x)\n"
          "Gap       -U, behind an end of contact xi = 1/sqrt(2) plus (x-xi)^2\n"
          "Friction  ";
const std::string singular =
  "Exact u   fields of complex functions times 1 - y^2 (doc/friction.md)\n";
const std::string singular_frame = frame + singular +
                                   "Gap       0\n"
                                   "Friction  ";
} // namespace

std::vector<CatalogueEntry<2>> friction_scenes() {
  const std::string tresca = "|q| <= s = 0.5 + 0.3 x\n", coulomb = "|q| <= f |p|, f = 0.5\n";
  const std::string ends = "Exact q   -s + 10 (xs-x)_+^3, xs = 1/sqrt(5); V = (x-xs)_+^4\n";
  return {{"T1", "Tresca's friction: smooth stick, slip and opening",
           lifted_frame + tresca + "Exact p   -10 (xi-x)_+^3\n" + ends, make_t1},
          {"T2", "Tresca's friction: smooth stick and slip",
           lifted_frame + tresca + "Exact p   -2 - cos(pi x)\n" + ends, make_t2},
          {"T3", "Tresca's friction: slip everywhere",
           lifted_frame + tresca + "Exact p   -2 - cos(pi x)\nExact q   -s; V = 0.1 + 0.05 sin x\n",
           make_t3},
          {"T4", "Tresca's friction: stick everywhere",
           lifted_frame + tresca + "Exact p   -2 - cos(pi x)\nExact q   0.4 cos(2 x); V = 0\n",
           make_t4},
          {"K1", "Coulomb's friction: smooth stick, slip and opening",
           lifted_frame + "|q| <= s = f |p|, f = 0.3\nExact p   -10 (xi-x)_+^3\n" + ends, make_k1},
          {"TS", "Tresca's friction: the true singularity between stick and slip",
           singular_frame + "|q| <= 1\n"
                            "Exact p   -1 - 3/4 (x-xi)_+^(1/2), xi = 1/sqrt(2)\n"
                            "Exact q   -1 + 9/4 (xi-x)_+^(1/2)\n",
           []() { return make_ts(end_of_contact); }},
          {"TSq", "as TS, stick ends at x = 1/2",
           singular_frame + "|q| <= 1\n"
                            "Exact p   -1 - 3/4 (x-xi)_+^(1/2), xi = 1/2\n"
                            "Exact q   -1 + 9/4 (xi-x)_+^(1/2)\n",
           []() { return make_ts(0.5); }},
          {"KS", "Coulomb's friction: slip away from the zone of stick",
           singular_frame + coulomb +
             "Exact q   -f |p| + 0.9 (1+e) (xi-x)_+^e, e = 1/2 + arctan(f/3)/pi, xi = 1/sqrt(2)\n"
             "Exact p   -2 - 0.3 (1+e) cos(arctan(f/3)) (x-xi)_+^e\n",
           []() { return make_ks(1.); }},
          {"KSr", "Coulomb's friction: slip towards the zone of stick",
           singular_frame + coulomb +
             "Exact q   f |p| - 0.9 (1+e) (xi-x)_+^e, e = 1/2 - arctan(f/3)/pi, xi = 1/sqrt(2)\n"
             "Exact p   -2 + 0.3 (1+e) cos(arctan(f/3)) (x-xi)_+^e\n",
           []() { return make_ks(-1.); }},
          {"KO", "Coulomb's friction: sliding contact ends",
           singular_frame + coulomb +
             "Exact p   -sin(pi e) (xi-x)_+^e, e = 1/2 - arctan(f/3)/pi, xi = 1/sqrt(2)\n"
             "Exact q   f p\n",
           []() { return make_ko(1.); }},
          {"KOr", "Coulomb's friction: sliding contact ends, the other direction",
           singular_frame + coulomb +
             "Exact p   -sin(pi e) (xi-x)_+^e, e = 1/2 + arctan(f/3)/pi, xi = 1/sqrt(2)\n"
             "Exact q   -f p\n",
           []() { return make_ko(-1.); }},
          {"CM", "Cattaneo's and Mindlin's contact: Hertz' pressure with stick and slip",
           frame + singular +
             "Gap       3/4 (x-m)^2 plus u_n of q, m = (a+b)/2; the foundation moves by u_t of p "
             "and a constant\n"
             "Friction  |q| <= f |p|, f = 0.4\n"
             "Exact p   -2 ((x-a) (b-x))_+^(1/2), a = 1/sqrt(10), b = e/4\n"
             "Exact q   f times |p| less the same on 0.6 of the width\n",
           []() { return make_cattaneo_mindlin(false); }}};
}
} // namespace Signorini
