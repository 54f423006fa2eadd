// SPDX-License-Identifier: LGPL-2.1-or-later
// convergence.csv: one row per level.

#include <signorini/output/tables.h>

#include <functional>
#include <iomanip>
#include <utility>

namespace Signorini
{
namespace
{
/** The value of a column, empty if it is not known. */
using Column = std::pair<const char *, std::function<std::optional<double>(const LevelRecord &)>>;

std::vector<Column> solution_columns()
{
  using R = const LevelRecord &;
  return {{"level", [](R r) { return r.level; }},
          {"cells", [](R r) { return r.cells; }},
          {"dofs", [](R r) { return r.dofs; }},
          {"multipliers", [](R r) { return r.multipliers; }},
          {"h", [](R r) { return r.h; }},
          {"H", [](R r) { return r.H; }},
          {"active", [](R r) { return r.active; }},
          {"qp_iterations", [](R r) { return r.qp_iterations; }},
          {"kkt", [](R r) { return r.kkt; }},
          {"inf_sup", [](R r) { return r.inf_sup; }},
          {"energy", [](R r) { return r.certificate.energy; }},
          {"contact_force_n", [](R r) { return r.contact_force; }},
          {"max_pressure", [](R r) { return r.max_pressure; }},
          {"contact_length", [](R r) { return r.contact_length; }}};
}

std::vector<Column> error_columns()
{
  using R = const LevelRecord &;
  return {{"u_h1", [](R r) { return r.u_h1; }},
          {"u_l2", [](R r) { return r.u_l2; }},
          {"u_superclose_h1", [](R r) { return r.u_superclose_h1; }},
          {"u_post_h1", [](R r) { return r.u_post_h1; }},
          {"p_l2", [](R r) { return r.p_l2; }},
          {"p_dual", [](R r) { return r.p_dual; }},
          {"p_dual_spectral", [](R r) { return r.p_dual_spectral; }},
          {"p_superclose_dual", [](R r) { return r.p_superclose_dual; }},
          {"p_superclose_dual_spectral", [](R r) { return r.p_superclose_dual_spectral; }},
          {"p_post_l2", [](R r) { return r.p_post_l2; }},
          {"endpoint_error", [](R r) { return r.endpoint_error; }},
          {"estimated_h1", [](R r) { return r.estimated_h1; }},
          {"effectivity", [](R r) { return r.effectivity(); }}};
}

std::vector<Column> cost_columns()
{
  using R = const LevelRecord &;
  return {{"t_mesh", [](R r) { return r.times.mesh; }},
          {"t_setup", [](R r) { return r.times.setup; }},
          {"t_assembly", [](R r) { return r.times.assembly; }},
          {"t_factor", [](R r) { return r.times.factor; }},
          {"t_compliance", [](R r) { return r.times.compliance; }},
          {"t_qp", [](R r) { return r.times.qp; }},
          {"t_recovery", [](R r) { return r.times.recovery; }},
          {"t_postprocess", [](R r) { return r.times.postprocess; }},
          {"t_errors", [](R r) { return r.times.errors; }},
          {"t_output", [](R r) { return r.times.output; }},
          {"t_total", [](R r) { return r.times.total(); }},
          {"cpu_total", [](R r) { return r.cpu_total; }},
          {"peak_memory_mb", [](R r) { return r.peak_memory_mb; }},
          {"qp_increment_iterations", [](R r) -> std::optional<double> {
             if (!r.increment_iterations)
               return {};
             return *r.increment_iterations;
           }}};
}

/** Filled with Output/Lemmas = true. */
std::vector<Column> lemma_columns()
{
  using R = const LevelRecord &;
  return {{"lemma_2_l2", [](R r) { return r.lemma_2_l2; }},
          {"lemma_2_dual", [](R r) { return r.lemma_2_dual; }},
          {"lemma_3_h1", [](R r) { return r.lemma_3_h1; }},
          {"lemma_5", [](R r) { return r.lemma_5; }},
          {"bound_26", [](R r) { return r.bound_26; }},
          {"bound_27", [](R r) { return r.bound_27; }},
          {"bound_30", [](R r) { return r.bound_30; }},
          {"lemma_3_trace", [](R r) { return r.lemma_3_trace; }}};
}

/** Columns that came later: places of columns never change. */
std::vector<Column> later_columns()
{
  using R = const LevelRecord &;
  return {{"u_post4_h1", [](R r) { return r.u_post4_h1; }}};
}

std::vector<Column> all_columns()
{
  std::vector<Column> columns = solution_columns();
  for (const auto &more : {error_columns(), cost_columns(), lemma_columns(), later_columns()})
    columns.insert(columns.end(), more.begin(), more.end());
  return columns;
}
} // namespace

void write_convergence_csv(std::ostream &stream, const std::vector<LevelRecord> &levels)
{
  const std::vector<Column> columns = all_columns();
  for (std::size_t c = 0; c < columns.size(); ++c)
    stream << (c == 0 ? "" : ",") << columns[c].first;
  stream << "\n" << std::setprecision(16);
  for (const LevelRecord &level : levels)
  {
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      stream << (c == 0 ? "" : ",");
      if (const std::optional<double> value = columns[c].second(level))
        stream << *value;
    }
    stream << "\n";
  }
}
} // namespace Signorini
