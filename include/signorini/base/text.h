// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
/** Removes blanks at both ends. */
std::string trim(const std::string &text);

/** The words of a text, separated by blanks or commas. */
std::vector<std::string> split_words(const std::string &text);

/**
 * Splits at every @p separator outside of parentheses and trims the parts. A separator '|' is not
 * found in the operator `||`. An empty text has no parts.
 */
std::vector<std::string> split_list(const std::string &text, char separator);

/** Reads a whole text as one finite number; returns false if it is not one. */
bool read_number(const std::string &text, double &number);

/** Numbers separated by commas. Returns false if one of them is not a finite number. */
bool read_numbers(const std::string &text, std::vector<double> &numbers);

/** For messages: of a long text the beginning and the end. */
std::string shorten(const std::string &text);

/** For messages: of a path that is longer than a line the last 60 characters, after "...". */
std::string shorten_path(const std::string &path);

/** 'text' for messages, shortened. */
std::string quote(const std::string &text);

/** A number for messages: 0.5, 1e+300, nan. */
std::string number_text(double number);

/** "a, b, c" for messages. */
std::string join(const std::vector<std::string> &words, const std::string &separator = ", ");
} // namespace Signorini
