// SPDX-License-Identifier: LGPL-2.1-or-later
// Texts of a parameter file taken apart: words, lists, numbers.

#include <signorini/base/text.h>

#include <boost/algorithm/string.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace Signorini {
std::string trim(const std::string &text) {
  return boost::trim_copy_if(text, boost::is_any_of(" \t\r\n"));
}

std::vector<std::string> split_words(const std::string &text) {
  const auto separators = boost::is_any_of(" \t,");
  const std::string trimmed = boost::trim_copy_if(text, separators);
  std::vector<std::string> words;
  if (!trimmed.empty())
    boost::split(words, trimmed, separators, boost::token_compress_on);
  return words;
}

std::vector<std::string> split_list(const std::string &text, const char separator) {
  std::vector<std::string> parts;
  if (trim(text).empty())
    return parts;
  int depth = 0;
  std::string part;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool doubled =
      (i > 0 && text[i - 1] == separator) || (i + 1 < text.size() && text[i + 1] == separator);
    const bool separates = text[i] == separator && depth == 0 && !(separator == '|' && doubled);
    if (separates) {
      parts.push_back(trim(part));
      part.clear();
      continue;
    }
    depth += text[i] == '(' ? 1 : (text[i] == ')' ? -1 : 0);
    part += text[i];
  }
  if (!trim(part).empty() || parts.empty())
    parts.push_back(trim(part));
  return parts;
}

bool read_number(const std::string &text, double &number) {
  const std::string trimmed = trim(text);
  if (trimmed.empty())
    return false;
  char *end = nullptr;
  number = std::strtod(trimmed.c_str(), &end);
  return *end == '\0' && std::isfinite(number);
}

bool read_numbers(const std::string &text, std::vector<double> &numbers) {
  numbers.clear();
  for (const std::string &part : split_list(text, ',')) {
    double number = 0;
    if (!read_number(part, number))
      return false;
    numbers.push_back(number);
  }
  return true;
}

namespace {
/** Returns the first position from i on, in steps of +1 or -1, that is not inside a character of
 * UTF-8. */
std::size_t whole_character(const std::string &text, std::size_t i, const int step) {
  while (i > 0 && i < text.size() && (text[i] & 0xC0) == 0x80)
    i += step;
  return i;
}
} // namespace

std::string shorten(const std::string &text) {
  constexpr std::size_t longest = 120, beginning = 80, ending = 30;
  if (text.size() <= longest)
    return text;
  return text.substr(0, whole_character(text, beginning, -1)) + " ... " +
         text.substr(whole_character(text, text.size() - ending, 1));
}

std::string shorten_path(const std::string &path) {
  constexpr std::size_t longest = 100, ending = 60;
  return path.size() <= longest
           ? path
           : "..." + path.substr(whole_character(path, path.size() - ending, 1));
}

std::string quote(const std::string &text) {
  return "'" + shorten(text) + "'";
}

std::string hint_for(const std::string &found, const std::vector<std::string> &names) {
  for (const std::string &name : names)
    if (name != found && boost::iequals(name, found))
      return " (did you mean " + quote(name) + "?)";
  return "";
}

std::string number_text(const double number) {
  if (std::isnan(number))
    return "nan";
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string join(const std::vector<std::string> &words, const std::string &separator) {
  return boost::join(words, separator);
}

std::string text_with_margin(const double value, const double margin, const std::string &unit) {
  constexpr int most_digits = 6;
  const auto exponent = [](const double number) {
    return number > 0. ? static_cast<int>(std::floor(std::log10(number))) : -most_digits;
  };
  const int first = exponent(std::max(std::abs(value), margin)),
            last = std::max(exponent(margin), first - most_digits + 1), places = std::max(0, -last);
  const double step = std::pow(10., -places);
  // The number is rounded, too.
  const double rounded = std::round(value / step) * step,
               up = std::ceil((margin + std::abs(value - rounded)) / step) * step;
  std::ostringstream text;
  text << std::fixed << std::setprecision(places) << rounded << unit << " +- " << up << unit;
  return text.str();
}
} // namespace Signorini
