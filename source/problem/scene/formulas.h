// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <muParser.h>

#include <string>

namespace Signorini
{
/** The functions that muParser lacks. */
void define_functions(mu::Parser &parser);

/**
 * Writes (...)^2 and (...)^3 with operators of our own behind the bracket: muParser multiplies out
 * the powers of a plain coordinate only and takes the library's pow for all else, which costs more
 * than the rest of a typical formula. Expects a formula that muParser accepts.
 */
std::string rewrite_powers(const std::string &text);

/** The operators that rewrite_powers() puts in. */
constexpr const char *square_operator = "'";
constexpr const char *cube_operator = "~";

/** Lets a parser know these operators. */
void define_powers(mu::Parser &parser);
} // namespace Signorini
