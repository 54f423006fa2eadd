// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes by name: how a scene is made of its description. D3 and V3, the scenes in 3-D.

#include <signorini/base/instantiate.h>
#include <signorini/base/text.h>
#include <signorini/problem/geometry/shapes.h>
#include <signorini/problem/scene/functions.h>
#include <signorini/problem/scene/strain.h>
#include <signorini/verification/catalogue/catalogue.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

#include "catalogue_scenes.h"

namespace Signorini {
namespace {
/** Returns the unit square with two sides instead of the left one. */
Geometry<2> make_divided_square() {
  Geometry<2> geometry = make_rectangle({0., 0.}, {1., 1.}, {1, 1});
  std::vector<Side<2>> &sides = geometry.sides;
  const std::size_t left = geometry.find_side("left");
  const Point<2> division(0., 0.75), normal(-1., 0.);
  sides.emplace_back("upper left", Curve(division, sides[left].end(), normal));
  sides[left] = Side<2>("left", Curve(sides[left].start(), division, normal));
  geometry.number_after_refinement = [sides](Triangulation<2> &triangulation) {
    number_boundary(sides, triangulation);
  };
  return geometry;
}

template <int dim>
Geometry<dim> make_body(const std::string &name) {
  if constexpr (dim == 2)
    return name == "the ring 1 < r < 2"                ? make_ring(1., 2.)
           : name == "the half disc r < 1, y < 0"      ? make_half_disc(1.)
           : name == "the block -1 < x < 1, 0 < y < 1" ? make_rectangle({-1., 0.}, {1., 1.}, {2, 1})
           : name == "the unit square, left side up to y = 3/4"
             ? make_divided_square()
             : make_rectangle({0., 0.}, {1., 1.}, {1, 1});
  else
    return make_box({0., 0., 0.}, {1., 1., 1.}, {1, 1, 1});
}

/** Formulas as the components of a function. The scan for kinks does not know it. */
template <int dim>
class FormulaFunction : public Function<dim> {
public:
  using Points = std::vector<Point<dim>>;
  using Gradients = std::vector<Tensor<1, dim>>;

  FormulaFunction(const std::string &text, const Definitions &definitions)
    : Function<dim>(split_list(text, ';').size())
    , formulas_(text, {}, definitions) {}

  double value(const Point<dim> &x, const unsigned int component) const override {
    std::array<double, dim> all;
    formulas_.values(&x, 1, all.data());
    return all[component];
  }
  void vector_value(const Point<dim> &x, dealii::Vector<double> &values) const override {
    formulas_.values(&x, 1, values.begin());
  }
  void vector_value_list(const Points &points,
                         std::vector<dealii::Vector<double>> &values) const override {
    std::vector<double> all(points.size() * this->n_components);
    formulas_.values(points.data(), points.size(), all.data());
    for (std::size_t c = 0, i = 0; c < this->n_components; ++c)
      for (auto &value : values)
        value[c] = all[i++];
  }
  Tensor<1, dim> gradient(const Point<dim> &x, const unsigned int component) const override {
    Gradients all(this->n_components);
    formulas_.gradients(&x, 1, all.data());
    return all[component];
  }
  void vector_gradient_list(const Points &points,
                            std::vector<Gradients> &gradients) const override {
    Gradients all(points.size() * this->n_components);
    formulas_.gradients(points.data(), points.size(), all.data());
    for (std::size_t c = 0, i = 0; c < this->n_components; ++c)
      for (auto &gradient : gradients)
        gradient[c] = all[i++];
  }

private:
  FormulaTree<dim> formulas_;
};

/** The texts of a description, and the functions that they stand for. */
template <int dim>
class Description {
public:
  explicit Description(const std::string &description) {
    constexpr std::size_t width = 10;
    std::istringstream lines(description);
    std::string word;
    for (std::string line; std::getline(lines, line);) {
      const std::string first = trim(line.substr(0, width));
      word = first.empty() ? word : first;
      std::string &text = texts_[word];
      text += (text.empty() ? "" : first.empty() ? " " : "; ") + line.substr(width);
    }
    for (const auto &[name, text] : pairs("With", '='))
      definitions_[name.substr(0, name.find('('))] = text;
    const std::vector<std::string> u = split_list(texts_["Exact u"], ';');
    for (std::size_t i = 0; i < u.size(); ++i)
      definitions_["u" + std::to_string(i + 1)] = u[i];
    definitions_["p"] = texts_["Exact p"];
    definitions_["q"] = texts_["Exact q"];
  }

  /** Returns the text behind a word, or that behind another one. */
  std::string text(const std::string &word, const std::string &other = "") const {
    const auto found = texts_.find(word);
    return found != texts_.end() ? found->second : other.empty() ? "" : text(other);
  }
  /** Returns the entries "left = right; ..." behind a word. */
  std::vector<std::pair<std::string, std::string>> pairs(const std::string &word,
                                                         const char separator) const {
    std::vector<std::pair<std::string, std::string>> result;
    for (const std::string &part : split_list(text(word), ';')) {
      const std::size_t end = std::min(part.find(separator), part.size());
      result.emplace_back(trim(part.substr(0, end)), trim(part.substr(end + 1)));
    }
    return result;
  }
  /** Returns the function of a text; nothing for "none" or an empty one. */
  FunctionPointer<dim> function(const std::string &text) const {
    return text.empty() || text == "none"
             ? nullptr
             : std::make_shared<FormulaFunction<dim>>(text, definitions_);
  }
  double number(const std::string &text) const {
    return FormulaTree<dim>(text, {}, definitions_).value({});
  }

private:
  std::map<std::string, std::string> texts_;
  Definitions definitions_;
};

template <int dim>
std::shared_ptr<const Material<dim>> make_material(const Description<dim> &description) {
  std::vector<Expression<dim>> moduli;
  for (const auto &[name, text] : description.pairs("Material", '='))
    moduli.emplace_back(text, Constants(), "catalogue");
  if constexpr (dim == 2)
    if (moduli.size() == 5) {
      const double degrees = moduli.back()({});
      moduli.pop_back();
      return make_orthotropic(moduli, degrees);
    }
  return make_isotropic<dim>(moduli.at(0), moduli.at(1), PlaneState::strain);
}

/** Sets the data of a side with a role, or of its contact with the foundation. */
template <int dim>
void set_condition(const Description<dim> &description, const unsigned int number,
                   Scene<dim> &scene) {
  const Side<dim> &side = scene.geometry.sides[number];
  BoundaryCondition<dim> &condition = scene.boundary[number];
  if (condition.role == Role::displacement)
    condition.data = description.function(description.text("Moves"));
  if (condition.role == Role::traction) {
    const Tensor<1, dim> normal = side.normal_at(scene.geometry.lower);
    condition.data = std::make_shared<FieldFunction<dim>>(
      [u = scene.exact_displacement, material = scene.material, geometry = scene.geometry,
       normal](const Point<dim> &x) {
        std::vector<std::vector<Tensor<1, dim>>> gradients(1, std::vector<Tensor<1, dim>>(dim));
        u->vector_gradient_list({x}, gradients);
        Tensor<1, dim> value;
        Tensor<2, dim> gradient;
        for (unsigned int i = 0; i < dim; ++i)
          gradient[i] = gradients[0][i];
        if (geometry.axisymmetric)
          value[0] = u->value(x, 0);
        const HookesLaw<dim> law = {material->hooke(x), material->across(x)};
        return law.stress(strain_at(geometry, x, value, gradient)) * normal;
      });
  }
  if (condition.role != Role::contact)
    return;
  ContactCondition<dim> &contact = scene.contacts.emplace_back();
  contact.side = number;
  contact.gap = description.function(description.text(side.name() + " gap", "Gap"));
  contact.exact_pressure = description.function(description.text(side.name() + " p", "Exact p"));
  for (const auto &limit : scene.contact_law.limits()) {
    contact.*limit.data = description.function(description.pairs("Friction", ':')[0].second);
    const std::string moves = description.text("Moves");
    contact.shift = description.function(moves.empty() ? "0" : moves);
    contact.exact_tangential = description.function(description.text("Exact q"));
  }
}

/** Returns the lines x = ..., y = ... and those through the origin at the angles t = ... */
Kinks<2> make_kinks(const Description<2> &description) {
  std::vector<KinkLine<2>> lines;
  for (const auto &[name, text] : description.pairs("Kinks", '=')) {
    const double value = description.number(text);
    lines.push_back(name == "t" ? KinkLine<2>{Point<2>(-std::sin(value), std::cos(value)), 0.}
                                : KinkLine<2>{Point<2>::unit_vector(name == "x" ? 0 : 1), value});
  }
  return Kinks<2>(lines);
}
} // namespace

template <int dim>
Scene<dim> CatalogueEntry<dim>::make() const {
  const Description<dim> parts(description);
  Scene<dim> scene;
  scene.name = name;
  scene.title = title;
  scene.description = description;
  scene.geometry = make_body<dim>(parts.text("Body"));
  scene.geometry.axisymmetric = parts.text("Body") == "the unit cylinder";
  scene.material = make_material(parts);
  scene.exact_displacement = parts.function(parts.text("Exact u"));
  scene.body_force = parts.function(parts.text("Load"));
  for (const auto &[law, bound] : parts.pairs("Friction", ':'))
    scene.contact_law = law == "tresca" ? Friction::tresca : Friction::coulomb;
  scene.boundary.resize(scene.geometry.sides.size());
  for (const auto &[role, sides] : parts.pairs("Boundary", ':'))
    for (const std::string &side : split_words(sides)) {
      const std::size_t number = scene.geometry.find_side(side);
      scene.boundary[number].role = role == "clamped"    ? Role::clamped
                                    : role == "contact"  ? Role::contact
                                    : role == "traction" ? Role::traction
                                                         : Role::displacement;
      set_condition(parts, number, scene);
    }
  std::sort(scene.contacts.begin(), scene.contacts.end(),
            [](const auto &a, const auto &b) { return a.side < b.side; });
  for (std::size_t i = 0; i < scene.boundary.size(); ++i)
    if (scene.geometry.is_axis(scene.geometry.sides[i]))
      scene.boundary[i].role = Role::roller;
  if constexpr (dim == 2)
    scene.kinks = make_kinks(parts);
  return scene;
}

template struct CatalogueEntry<2>;
template struct CatalogueEntry<3>;

template <>
const std::vector<CatalogueEntry<2>> &catalogue() {
  static const std::vector<CatalogueEntry<2>> sorted = []() {
    std::vector<CatalogueEntry<2>> entries = smooth_scenes();
    for (const auto &more : {singular_scenes(), round_scenes()})
      entries.insert(entries.end(), more.begin(), more.end());
    std::sort(entries.begin(), entries.end(),
              [](const auto &a, const auto &b) { return a.name < b.name; });
    return entries;
  }();
  return sorted;
}

template <>
const std::vector<CatalogueEntry<3>> &catalogue() {
  // The centre of the disc and its radius coincide with lines of no mesh.
  static const std::string on_disc =
    "Body      the unit cube\n"
    "Boundary  clamped: top; contact: bottom; traction: left, right, front, back\n"
    "Load      -dx(s11) - dy(s12) - dz(s13); -dx(s12) - dy(s22) - dz(s23);\n"
    "          -dx(s13) - dy(s23) - dz(s33)\n"
    "Gap       0.5*max(0, sqrt(dd)-s)^2 - g\n"
    "Exact u   -dx(g)*B; -dy(g)*B; g*(1-z)^2*(1+2*z) + w*B\n"
    "Exact p   (lambda+2*mu)*w\n"
    "With      g = -0.05*(1 + x*(1-x) + y*(1-y)); w = -0.3*max(1-dd/s^2, 0)^3; B = z*(1-z)^2;\n"
    "          dd = (x-0.5707106781186547)^2 + (y-0.4422649730810374)^2; s = exp(-1);\n"
    "          lambda = m*0.3/0.52; mu = m/2.6; trace = lambda*(dx(u1) + dy(u2) + dz(u3));\n"
    "          s11 = trace + 2*mu*dx(u1); s22 = trace + 2*mu*dy(u2);\n"
    "          s33 = trace + 2*mu*dz(u3); s12 = mu*(dy(u1) + dx(u2));\n"
    "          s13 = mu*(dz(u1) + dx(u3)); s23 = mu*(dz(u2) + dy(u3))\n";
  static const std::vector<CatalogueEntry<3>> entries = {
    {"D3", "in 3-D: smooth contact on a disc, exact solution known",
     on_disc + "Material  E = 1; nu = 0.3\nWith      m = 1\n"},
    {"V3", "in 3-D: the contact of D3 with a material that varies in space",
     on_disc + "Material  E = 1 + x/2 + y*z; nu = 0.3\nWith      m = 1 + x/2 + y*z\n"}};
  return entries;
}

NamedScenes named_scenes() {
  NamedScenes scenes;
  const auto add = [](const auto &entries, auto &named) {
    for (const auto &entry : entries)
      named.push_back({entry.name, [&entry]() { return entry.make(); }});
  };
  add(catalogue<2>(), std::get<0>(scenes));
  add(catalogue<3>(), std::get<1>(scenes));
  return scenes;
}

std::string describe_catalogue() {
  std::ostringstream text;
  text << std::left << std::setw(20) << "described"
       << "everything by the expressions of the parameter file\n";
  const auto list = [&](const auto &entries) {
    for (const auto &entry : entries)
      text << std::setw(20) << entry.name << entry.title << "\n";
  };
  list(catalogue<2>());
  list(catalogue<3>());
  return text.str();
}
} // namespace Signorini
