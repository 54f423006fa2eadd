// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/results/verdict/judge.h>

#include <filesystem>
#include <ostream>
#include <vector>

namespace Signorini {
/** Prints the answer of the finest level, which ends a run on the screen, in lines of at most 80
 * columns. @param directory where the results are; empty: nowhere. */
void print_answer(std::ostream &stream, const std::vector<LevelRecord> &levels,
                  const std::filesystem::path &directory);

/** Writes contacts.csv: a row for each contact, and behind it one for each of its zones. */
void write_contacts_csv(std::ostream &stream, const Answer &answer);

/** Writes answer.json: the answer with all digits. */
void write_answer(std::ostream &stream, const std::vector<LevelRecord> &levels,
                  const StudyVerdict &verdict);
} // namespace Signorini
