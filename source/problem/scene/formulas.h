// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <muParser.h>

#include <string>

namespace Signorini
{
/** Defines the functions that muParser lacks. */
void define_functions(mu::Parser &parser);

/**
 * Returns the formula with own operators behind the bracket in place of (...)^2 and (...)^3:
 * muParser multiplies out the powers of a plain coordinate only and calls the library's pow for all
 * else, which costs more than the rest of a typical formula. The formula must be one that muParser
 * accepts.
 */
std::string rewrite_powers(const std::string &text);

/** The operators that rewrite_powers() puts in. */
constexpr const char *square_operator = "'";
constexpr const char *cube_operator = "~";

/** Defines these operators in a parser. */
void define_powers(mu::Parser &parser);
} // namespace Signorini
