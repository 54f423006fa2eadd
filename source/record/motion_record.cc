// SPDX-License-Identifier: LGPL-2.1-or-later
// What convergence.csv shows of plates.

#include <signorini/record/motion_record.h>

#include <functional>

namespace Signorini
{
Columns<MotionRecord> MotionRecord::columns()
{
  const auto of_first = [](const std::function<double(const PlateRecord &)> &number) {
    return [number](const MotionRecord &record) {
      return record.plates.empty() ? std::nullopt
                                   : std::optional<double>(number(record.plates.front()));
    };
  };
  return {
    {"plate_travel", of_first([](const PlateRecord &plate) { return plate.motion.travel; })},
    {"plate_rotation", of_first([](const PlateRecord &plate) { return plate.motion.rotation; })},
    {"plate_force", of_first([](const PlateRecord &plate) { return plate.force; })},
    {"plate_moment", of_first([](const PlateRecord &plate) { return plate.moment; })}};
}
} // namespace Signorini
