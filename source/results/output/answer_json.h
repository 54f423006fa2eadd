// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/results/verdict/judge.h>

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace Signorini {
using Json = nlohmann::ordered_json;

/** Returns the content of answer.json. */
Json answer_of(const std::vector<LevelRecord> &levels, const StudyVerdict &verdict);
} // namespace Signorini
