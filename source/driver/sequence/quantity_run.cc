// SPDX-License-Identifier: LGPL-2.1-or-later
// Guaranteed means: functionals of u_h and τ, and the norms of their linear scenes.

#include <signorini/driver/sequence/quantity_run.h>
#include <signorini/driver/sequence/reference_run.h>
#include <signorini/error_control/reference/probe_mean.h>
#include <signorini/postprocessing/quantities/side_forces.h>
#include <signorini/problem/scene/contradictions.h>
#include <signorini/problem/scene/functions.h>
#include <signorini/problem/scene/rigid_motions.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace Signorini {
namespace {
const std::array<std::string, 2> axes = {{"x", "y"}};

/** A field φ on a side, by its polynomials on stretches; zero elsewhere. */
using SideField = std::vector<BoundaryTrace>;

SideField constant_field(const unsigned int side, const double length, const Tensor<1, 2> &value) {
  return {{side, 0., length, {value, value}}};
}

/** Returns n times the weight of a stretch of a straight side. */
SideField weighted_normal(const unsigned int number, const Side<2> &side,
                          const std::array<double, 2> &ends) {
  const double quarter = 0.25 * (ends[1] - ends[0]);
  const Tensor<1, 2> n = side.normal(0.);
  BoundaryTrace rise = {number, ends[0], ends[0] + quarter, {}},
                fall = {number, ends[1] - quarter, ends[1], {}};
  const QGaussLobatto<1> nodes(6);
  for (const Point<1> &node : nodes.get_points()) {
    const double r = node[0], weight = r * r * r * (10. - 15. * r + 6. * r * r);
    rise.values.push_back(weight * n);
    fall.values.insert(fall.values.begin(), weight * n);
  }
  return {rise, {number, rise.to, fall.from, {n, n}}, fall};
}

/** Returns the scene without loads, motions and contact; contact sides are free. */
Scene<2> unloaded(Scene<2> scene) {
  for (BoundaryCondition<2> &condition : scene.boundary) {
    if (condition.role == Role::traction || condition.role == Role::contact)
      condition.role = Role::free;
    if (condition.role == Role::displacement)
      condition.role = Role::clamped;
    condition.data = nullptr;
  }
  for (Plate<2> &plate : scene.plates) {
    plate.force = plate.travel = plate.cross_force = plate.moment = 0.;
    scene.boundary[plate.side] = {Role::displacement, plate_displacement<2>(plate, {})};
  }
  scene.contacts.clear();
  scene.contact_law = {};
  scene.is_held_by_contact = false;
  scene.load_cases.clear();
  scene.probes.clear();
  scene.body_force = nullptr;
  scene.exact_displacement = nullptr;
  return scene;
}

/** Returns the scene in which a traction e_i/|side| acts alone. */
Scene<2> with_unit_load(const Scene<2> &scene, const unsigned int side, const unsigned int i) {
  Scene<2> loaded = unloaded(scene);
  std::vector<double> t(2, 0.);
  t[i] = 1. / scene.geometry.sides[side].length();
  loaded.boundary[side] = {Role::traction, std::make_shared<Functions::ConstantFunction<2>>(t)};
  return loaded;
}

/** Returns the scene whose displacement is φ on a side, and zero where tractions are not known. */
Scene<2> with_motion(const Scene<2> &scene, const unsigned int side, const SideField &phi) {
  Scene<2> moved = unloaded(scene);
  const auto hold = [&](const unsigned int other, const bool slides) {
    moved.boundary[other].role =
      slides && scene.geometry.sides[other].is_flat() && !scene.contact_law.has_tangential_part()
        ? Role::roller
        : Role::clamped;
  };
  for (const ContactCondition<2> &contact : scene.contacts) {
    hold(contact.side, contact.directions.are_normals());
    if (contact.opposite)
      hold(*contact.opposite, true);
  }
  moved.plates.erase(std::remove_if(moved.plates.begin(), moved.plates.end(),
                                    [&](const Plate<2> &plate) { return plate.side == side; }),
                     moved.plates.end());
  const Side<2> curve = scene.geometry.sides[side];
  const auto value = [phi, curve](const Point<2> &x) {
    const double s = curve.arc_length(x);
    for (const BoundaryTrace &trace : phi)
      if (s >= trace.from && s <= trace.to)
        return trace.value(s);
    return Tensor<1, 2>();
  };
  moved.boundary[side] = {Role::displacement, std::make_shared<FieldFunction<2>>(value)};
  std::vector<KinkLine<2>> lines;
  for (const BoundaryTrace &trace : phi)
    if (phi.size() > 1)
      for (const double s : {trace.from, trace.to}) {
        const Tensor<1, 2> t = curve.tangent(s, curve.length());
        lines.push_back({t, t * (curve.point(s) - Point<2>()), false});
      }
  moved.kinks = moved.kinks.with_lines(lines);
  return moved;
}

/** The means of one level. */
class GuaranteedMeans {
public:
  GuaranteedMeans(const Parameters &parameters, const Scene<2> &scene, const LevelResult<2> &level,
                  const Progress &progress)
    : parameters_(parameters)
    , scene_(scene)
    , level_(level)
    , bound_(level.solution.record.bound.value_or(ErrorBound()))
    , progress_(progress) {}

  std::vector<BoundedValue> of(const Probe<2> &probe) const {
    if (!bound_.absolute || !bound_.is_guaranteed())
      return {{"means", 0., {}, "there is no guaranteed bound of the error"}};
    if (level_.discretization->mesh.is_shared())
      return {{"means", 0., {}, "processes share the level: take one, or graded meshes"}};
    std::vector<BoundedValue> means;
    if (probe.stretch)
      add_weighted_force(probe.sides[0], *probe.stretch, means);
    else if (probe.sides.empty())
      add_stress(probe, means);
    else
      for (const unsigned int side : probe.sides)
        add_side(side, means);
    return means;
  }

private:
  void add_stress(const Probe<2> &probe, std::vector<BoundedValue> &means) const {
    const ProbeMean mean = mean_stress(level_.solved(), probe);
    for (const auto &[i, j] : {std::pair(0, 0), {1, 1}, {0, 1}}) {
      BoundedValue &value =
        means.emplace_back(BoundedValue{"mean stress_" + axes[i] + axes[j], mean.value[i][j]});
      value.missing = mean.missing;
      if (mean.missing.empty())
        value.error =
          std::sqrt(mean.hooke[i][j][i][j] / mean.measure) * *bound_.absolute + mean.margin[i][j];
    }
  }

  void add_side(const unsigned int side, std::vector<BoundedValue> &means) const {
    const Role role = scene_.boundary[side].role;
    const bool is_held = holds(role);
    for (unsigned int i = 0; i < 2; ++i) {
      Tensor<1, 2> e;
      e[i] = 1.;
      const bool slides = role == Role::roller ||
                          (role == Role::contact && !scene_.contact_law.has_tangential_part());
      const Side<2> &curve = scene_.geometry.sides[side];
      // Along a side that slides there is no force.
      const bool is_zero = slides && curve.is_flat() && std::abs(curve.normal(0.)[i]) < 1e-12;
      if ((is_held || role == Role::contact) && !is_zero)
        add_force(side, "force_" + axes[i], constant_field(side, curve.length(), e), means);
      if (!is_held)
        add_displacement(side, i, means);
    }
  }

  void add_weighted_force(const unsigned int side, const std::array<double, 2> &stretch,
                          std::vector<BoundedValue> &means) const {
    const Side<2> &curve = scene_.geometry.sides[side];
    const std::string name = "weighted force_n";
    const Role role = scene_.boundary[side].role;
    if (!curve.is_flat() || role == Role::free || role == Role::traction)
      means.push_back({name, 0., {}, curve.is_flat() ? "its traction is given" : "it is curved"});
    else
      add_force(side, name, weighted_normal(side, curve, stretch), means);
  }

  void add_displacement(const unsigned int side, const unsigned int i,
                        std::vector<BoundedValue> &means) const {
    const ProbeMean mean = mean_displacement(level_.solved(), side);
    BoundedValue &value = means.emplace_back(BoundedValue{"mean u_" + axes[i], mean.value[0][i]});
    const Scene<2> loaded = with_unit_load(scene_, side, i);
    if (!free_rigid_motions(scene_, Plates::released).empty())
      value.missing = "supports do not hold the body alone";
    else
      set_error(loaded, *bound_.absolute, mean.margin[0][i], value);
  }

  void add_force(const unsigned int side, const std::string &name, const SideField &phi,
                 std::vector<BoundedValue> &means) const {
    const std::optional<ReferenceStress> &stress = level_.solution.reference;
    const double thickness = scene_.geometry.thickness;
    BoundedValue &value = means.emplace_back(BoundedValue{name, 0.});
    if (!stress) {
      value.missing = "there is no stress of a graded mesh";
      return;
    }
    for (const BoundaryTrace &trace : phi)
      value.value += thickness * stress->traction.work(trace, stress->sides);
    const Scene<2> moved = with_motion(scene_, side, phi);
    if (!find_contradiction(moved).empty())
      value.missing = "it meets another side that may hold the body: the energy is infinite";
    else
      set_error(moved, thickness * stress->stress_error,
                rounding * thickness * stress->energy_norm * std::sqrt(scene_.material->modulus()),
                value);
  }

  /** Sets the error to |||u||| of a linear scene times a factor, and a margin. */
  void set_error(const Scene<2> &linear, const double factor, const double margin,
                 BoundedValue &value) const {
    // Ten per cent of the norm are ten per cent of a bound.
    const auto [found, missing] =
      run_reference(parameters_, linear, {0.05},
                    [&](const std::string &stage) { progress_(value.name + ": " + stage); });
    if (found)
      value.error =
        factor * (found->energy_norm + found->misfit_with_rest + found->stress_error) + margin;
    else
      value.missing = missing;
  }

  /** The share of the size of all forces, |||u||| E_0^{1/2}, that rounding leaves of a balance. */
  static constexpr double rounding = 1e-11;
  const Parameters &parameters_;
  const Scene<2> &scene_;
  const LevelResult<2> &level_;
  const ErrorBound bound_;
  const Progress &progress_;
};
} // namespace

void add_guaranteed_means(const Parameters &parameters, const Scene<2> &scene,
                          LevelResult<2> &level, const Progress &progress) {
  LevelRecord &record = level.solution.record;
  const StageTimer timer(record.times.postprocess);
  const GuaranteedMeans means(parameters, scene, level, progress);
  for (std::size_t i = 0; i < scene.probes.size(); ++i)
    if (scene.probes[i].is_guaranteed)
      record.answer.reports[i].means = means.of(scene.probes[i]);
}
} // namespace Signorini
