// SPDX-License-Identifier: LGPL-2.1-or-later
// contacts.csv: the force of each contact and of each of its zones.

#include <signorini/results/output/answer_output.h>
#include <signorini/results/output/tables.h>

namespace Signorini {
namespace {
/** A contact, or a zone of one. */
struct ForceRow {
  const ContactForce &force;
  const ContactZone *zone;
  /** The number of the zone on its contact, from 1. */
  unsigned int number;
};

/** Returns a column for each component of a vector that a row may lack. */
void add_components(const std::string &name, const std::size_t n,
                    const std::function<const AnswerVector *(const ForceRow &)> &vector,
                    Columns<ForceRow> &columns) {
  for (std::size_t d = 0; d < n; ++d)
    columns.push_back({name + (n == 1 ? "" : std::string("_") + "xyz"[d]),
                       [vector, d](const ForceRow &row) -> std::optional<double> {
                         const AnswerVector *const found = vector(row);
                         return found != nullptr ? std::optional((*found)[d]) : std::nullopt;
                       }});
}

Columns<ForceRow> force_columns(const unsigned int dim) {
  using Row = ForceRow;
  const auto of_zone = [](const auto &value) {
    return [value](const Row &row) {
      return row.zone != nullptr ? std::optional<double>(value(row)) : std::nullopt;
    };
  };
  Columns<Row> columns = {{"zone", of_zone([](const Row &row) { return row.number; })}};
  if (dim == 2) {
    columns.push_back(
      {"start", of_zone([](const Row &row) { return row.zone->start.at.arc_length; })});
    columns.push_back({"end", of_zone([](const Row &row) { return row.zone->end.at.arc_length; })});
  }
  columns.push_back(
    {dim == 2 ? "length" : "area", of_zone([](const Row &row) { return row.zone->length; })});
  const auto force = [](const Row &row) { return &row.force.resultant.force; };
  const auto moment = [](const Row &row) { return &row.force.resultant.moment; };
  const auto through = [](const Row &row) {
    return row.force.through ? &*row.force.through : nullptr;
  };
  const auto at_peak = [](const Row &row) {
    return row.force.peak ? &row.force.peak->at.point : nullptr;
  };
  add_components("force", dim, force, columns);
  add_components("moment", dim == 2 ? 1 : dim, moment, columns);
  add_components("through", dim, through, columns);
  columns.push_back({"peak_pressure", [](const Row &row) {
                       return row.force.peak ? std::optional(row.force.peak->value) : std::nullopt;
                     }});
  add_components("peak", dim, at_peak, columns);
  return columns;
}
} // namespace

void write_contacts_csv(std::ostream &stream, const Answer &answer) {
  const Columns<ForceRow> columns = force_columns(answer.dimension);
  const auto write = [&](const ForceRow &row) {
    stream << row.force.side << "," << row.force.other << "," << csv_row(columns, row) << "\n";
  };
  stream << "side,with," << csv_header(columns) << "\n";
  unsigned int contact = 0;
  for (const ContactForce &force : answer.contact_by_side) {
    if (force.acts_on == PairSide::second)
      continue;
    write({force, nullptr, 0});
    unsigned int number = 0;
    for (std::size_t i = 0; i < answer.zones.size(); ++i)
      if (answer.zones[i].contact == contact)
        write({answer.zone_forces[i], &answer.zones[i], ++number});
    ++contact;
  }
}
} // namespace Signorini
