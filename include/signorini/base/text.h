// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace Signorini {
/** Removes blanks at both ends. */
std::string trim(const std::string &text);

/** Returns the words of a text, which blanks or commas separate. */
std::vector<std::string> split_words(const std::string &text);

/**
 * Splits at every @p separator outside of parentheses and trims the parts. A separator '|' is not
 * found in the operator `||`. An empty text has no parts; behind a separator at the end there is
 * none.
 */
std::vector<std::string> split_list(const std::string &text, char separator);

/** Reads a whole text as one finite number; returns false if it is not one. */
bool read_number(const std::string &text, double &number);

/** Reads numbers separated by commas; returns false if one of them is not a finite number. */
bool read_numbers(const std::string &text, std::vector<double> &numbers);

/** Returns the beginning and the end of a long text, for messages. */
std::string shorten(const std::string &text);

/** Returns the last 60 characters of a long path, after "...", for messages. */
std::string shorten_path(const std::string &path);

/** Returns 'text', shortened, for messages. */
std::string quote(const std::string &text);

/** Returns " (did you mean 'top'?)" if a name differs from @p found in capital letters only. */
std::string hint_for(const std::string &found, const std::vector<std::string> &names);

/** Returns a number as text, for messages: 0.5, 1e+300, nan. */
std::string number_text(double number);

/** Returns the words joined by the separator: "a, b, c". */
std::string join(const std::vector<std::string> &words, const std::string &separator = ", ");
/** Returns "0.834876 +- 0.000006": a number to the first digit of its margin, which is rounded up,
 * six digits at most. @param unit follows both: " %". */
std::string text_with_margin(double value, double margin, const std::string &unit = "");
} // namespace Signorini
