// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/**
 * A column of a table: its name, and a function that returns its value in a row, empty where the
 * value is unknown. The function may be a pointer to a member of Row.
 */
template <typename Row>
struct Column {
  std::string name;
  std::function<std::optional<double>(const Row &)> value;
};

template <typename Row>
using Columns = std::vector<Column<Row>>;

/** Returns the columns that a part of a row declares by Part::columns(), as columns of the row. */
template <typename Row, typename Part>
Columns<Row> columns_of(Part Row::*const part) {
  Columns<Row> columns;
  for (const Column<Part> &column : Part::columns())
    columns.push_back(
      {column.name, [column, part](const Row &row) { return column.value(row.*part); }});
  return columns;
}

/** Returns the same columns for a part that a row may lack; they are empty there. */
template <typename Row, typename Part>
Columns<Row> columns_of(std::optional<Part> Row::*const part) {
  Columns<Row> columns;
  for (const Column<Part> &column : Part::columns())
    columns.push_back({column.name, [column, part](const Row &row) {
                         return row.*part ? column.value(*(row.*part)) : std::nullopt;
                       }});
  return columns;
}

/**
 * A timer that adds the wall seconds of its life to a number. A timer that starts within another
 * one's life stops that one meanwhile, so the time of a stage within a stage counts once.
 */
class StageTimer {
public:
  explicit StageTimer(double &seconds)
    : seconds_(seconds)
    , outer_(innermost) {
    if (outer_ != nullptr)
      outer_->stop();
    innermost = this;
    start_ = Clock::now();
  }
  ~StageTimer() {
    stop();
    innermost = outer_;
    if (outer_ != nullptr)
      outer_->start_ = Clock::now();
  }
  StageTimer(const StageTimer &) = delete;
  StageTimer &operator=(const StageTimer &) = delete;

private:
  using Clock = std::chrono::steady_clock;

  void stop() {
    seconds_ += std::chrono::duration<double>(Clock::now() - start_).count();
  }

  /** The timer that runs on this thread. */
  static inline thread_local StageTimer *innermost = nullptr;

  double &seconds_;
  StageTimer *outer_;
  Clock::time_point start_;
};

/** Calls @p stage, adds its wall seconds to @p seconds, and returns its result. */
template <typename Stage>
auto timed(double &seconds, const Stage &stage) {
  const StageTimer timer(seconds);
  return stage();
}

/** Wall seconds of the stages of one level. */
struct StageTimes {
  double mesh = 0.;
  double setup = 0.;
  double assembly = 0.;
  double factor = 0.;
  double compliance = 0.;
  double qp = 0.;
  double recovery = 0.;
  double postprocess = 0.;
  double bound = 0.;
  double errors = 0.;
  double output = 0.;

  double total() const;

  static Columns<StageTimes> columns();
};

/** The resources that this process has used since it began. */
struct Resources {
  double cpu_seconds = 0.;
  double peak_memory_mb = 0.;

  static Columns<Resources> columns();
};

/** Returns the resources used until now. */
Resources measure_resources();
} // namespace Signorini
