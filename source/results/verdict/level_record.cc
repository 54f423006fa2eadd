// SPDX-License-Identifier: LGPL-2.1-or-later
// The columns of a record in convergence.csv, the summary of load cases, and the thickness as a
// factor of forces.

#include <signorini/base/text.h>
#include <signorini/results/verdict/level_record.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <tuple>

namespace Signorini {
Columns<LevelSizes> LevelSizes::columns() {
  return {{"level", &LevelSizes::level},
          {"cells", &LevelSizes::cells},
          {"dofs", &LevelSizes::dofs},
          {"multipliers", &LevelSizes::multipliers},
          {"h", &LevelSizes::h},
          {"H", &LevelSizes::H},
          {"max_degree", &LevelSizes::max_degree},
          {"min_h", &LevelSizes::min_h}};
}

Columns<MotionRecord> MotionRecord::columns() {
  Columns<MotionRecord> columns;
  const auto add = [&](const std::string &name, const auto &number_of) {
    columns.push_back({name, [number_of](const MotionRecord &record) {
                         return record.plates.empty() ? std::nullopt
                                                      : number_of(record.plates.front());
                       }});
  };
  const auto number = [](double PlateRecord::*const part) {
    return [part](const PlateRecord &plate) { return std::optional(plate.*part); };
  };
  const auto in_plane = [](AnswerVector PlateRecord::*const part) {
    return [part](const PlateRecord &plate) {
      const AnswerVector &x = plate.*part;
      return x.size() == 1 ? std::optional(x[0]) : std::nullopt;
    };
  };
  add("plate_travel", number(&PlateRecord::travel));
  add("plate_drift", in_plane(&PlateRecord::drift));
  add("plate_rotation", in_plane(&PlateRecord::rotation));
  add("plate_force", number(&PlateRecord::force));
  add("plate_cross_force", in_plane(&PlateRecord::cross_force));
  add("plate_moment", in_plane(&PlateRecord::moment));
  return columns;
}

CaseSummary summarise(const std::vector<CaseResult> &cases, const double seconds) {
  CaseSummary summary;
  summary.n_cases = cases.size();
  summary.seconds = seconds;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (!cases[i].escape.empty())
      ++summary.n_escapes;
    else {
      summary.max_kkt = std::max(summary.max_kkt, cases[i].kkt);
      if (!cases[i].converged && summary.first_failure == 0)
        summary.first_failure = i + 1;
      if (cases[i].estimate.value_or(0.) > summary.max_estimate) {
        summary.max_estimate = *cases[i].estimate;
        summary.worst = cases[i].number;
      }
    }
  return summary;
}

namespace {
/** Multiplies the numbers of a vector, or of the optional ones those that are known. */
template <typename... Numbers>
void multiply(const double factor, Numbers &...numbers) {
  const auto one = [factor](auto &number) {
    if constexpr (std::is_same_v<std::decay_t<decltype(number)>, double>)
      number *= factor;
    else if constexpr (std::is_same_v<std::decay_t<decltype(number)>, std::optional<double>>)
      number = number ? std::optional(factor * *number) : std::nullopt;
    else
      for (double &entry : number)
        entry *= factor;
  };
  (one(numbers), ...);
}
} // namespace

void multiply_forces(const double thickness, ErrorBound &bound) {
  multiply(thickness, bound.energy_lower, bound.energy_upper, bound.force_error);
}

void multiply_forces(const double thickness, LevelRecord &record, std::vector<CaseResult> &cases) {
  Answer &answer = record.answer;
  const auto multiply_tangential = [&](std::optional<TangentialSummary> &part) {
    if (part)
      multiply(thickness, part->tangential_force, part->dissipation);
  };
  multiply(thickness, record.contact.normal_force, record.certificate.energy,
           answer.contact_force.resultant.force, answer.contact_force.resultant.moment);
  const auto multiply_side = [&](SideForce &force) {
    multiply(thickness, force.resultant.force, force.resultant.moment);
  };
  std::for_each(answer.reactions.begin(), answer.reactions.end(), multiply_side);
  for (std::vector<ContactForce> *const forces : {&answer.contact_by_side, &answer.zone_forces})
    std::for_each(forces->begin(), forces->end(), multiply_side);
  for (PlateRecord &plate : record.motions.plates)
    multiply(thickness, plate.force, plate.cross_force, plate.moment);
  multiply_tangential(record.tangential);
  if (record.bound)
    multiply_forces(thickness, *record.bound);
  answer.thickness = thickness;
  for (CaseResult &result : cases) {
    multiply(thickness, result.contact.force, result.contact.moment);
    for (auto &[name, force] : result.reactions)
      force *= thickness;
    multiply_tangential(result.tangential);
  }
}

template <int dim>
void multiply_forces(const double thickness, std::vector<Plate<dim>> &plates) {
  for (Plate<dim> &plate : plates) {
    plate.force *= thickness;
    plate.cross_force *= thickness;
    plate.moment *= thickness;
  }
}
template void multiply_forces(double, std::vector<Plate<2>> &);
template void multiply_forces(double, std::vector<Plate<3>> &);

namespace {
/** Returns the column of an estimated error divided by the true one. */
template <typename Number>
Column<LevelRecord> effectivity(const std::string &name, Number ErrorEstimate::*const estimate,
                                double DisplacementErrors::*const error) {
  return {name, [estimate, error](const LevelRecord &record) -> std::optional<double> {
            const auto &[estimated, exact] = std::tie(record.estimate, record.displacement_errors);
            if (!estimated || !exact || (*exact).*error == 0.)
              return {};
            const std::optional<double> value = (*estimated).*estimate;
            return value ? std::optional<double>(*value / ((*exact).*error)) : std::nullopt;
          }};
}

/** Returns the columns in the order of the members. */
Columns<LevelRecord> columns_of_parts() {
  Columns<LevelRecord> all;
  for (const Columns<LevelRecord> &columns :
       {columns_of(&LevelRecord::sizes), columns_of(&LevelRecord::dual),
        columns_of(&LevelRecord::contact), columns_of(&LevelRecord::certificate),
        columns_of(&LevelRecord::estimate),
        Columns<LevelRecord>{
          effectivity("effectivity", &ErrorEstimate::h1, &DisplacementErrors::h1),
          effectivity("effectivity_energy", &ErrorEstimate::energy, &DisplacementErrors::energy),
          {"inf_sup", &LevelRecord::inf_sup},
          {"inf_sup_first", &LevelRecord::inf_sup_first},
          {"inf_sup_opposite", &LevelRecord::inf_sup_opposite}},
        columns_of(&LevelRecord::displacement_errors), columns_of(&LevelRecord::pressure_errors),
        columns_of(&LevelRecord::dual_norm_errors),
        Columns<LevelRecord>{{"endpoint_error", &LevelRecord::endpoint_error}},
        columns_of(&LevelRecord::lemmas), columns_of(&LevelRecord::bound),
        columns_of(&LevelRecord::answer), columns_of(&LevelRecord::tangential),
        columns_of(&LevelRecord::motions), columns_of(&LevelRecord::times),
        columns_of(&LevelRecord::resources)})
    all.insert(all.end(), columns.begin(), columns.end());
  return all;
}

/** Returns the position of a column; those without a fixed one share that behind the others. */
std::size_t fixed_place(const Column<LevelRecord> &column) {
  const std::vector<std::string> &names = columns_with_fixed_places();
  return std::find(names.begin(), names.end(), column.name) - names.begin();
}
} // namespace

const std::vector<std::string> &columns_with_fixed_places() {
  static const std::vector<std::string> names = split_words(
    "level cells dofs multipliers h H active qp_iterations kkt inf_sup energy contact_force_n "
    "max_pressure contact_length u_h1 u_l2 u_superclose_h1 u_post_h1 p_l2 p_dual p_dual_spectral "
    "p_superclose_dual p_superclose_dual_spectral p_post_l2 endpoint_error estimated_h1 "
    "effectivity t_mesh t_setup t_assembly t_factor t_compliance t_qp t_recovery t_postprocess "
    "t_errors t_output t_total cpu_total peak_memory_mb qp_increment_iterations lemma_2_l2 "
    "lemma_2_dual lemma_3_h1 lemma_5 bound_26 bound_27 bound_30 lemma_3_trace u_post4_h1");
  return names;
}

const Columns<LevelRecord> &level_columns() {
  static const Columns<LevelRecord> columns = []() {
    Columns<LevelRecord> all = columns_of_parts();
    std::stable_sort(all.begin(), all.end(),
                     [](const auto &a, const auto &b) { return fixed_place(a) < fixed_place(b); });
    return all;
  }();
  return columns;
}

std::optional<double> value(const LevelRecord &record, const std::string &column) {
  for (const Column<LevelRecord> &known : level_columns())
    if (known.name == column)
      return known.value(record);
  throw std::invalid_argument("There is no column " + column + ".");
}
} // namespace Signorini
