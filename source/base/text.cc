// SPDX-License-Identifier: LGPL-2.1-or-later
// Texts of a parameter file taken apart: words, lists, numbers.

#include <signorini/base/text.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace Signorini
{
std::string trim(const std::string &text)
{
  const char *blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> split_words(const std::string &text)
{
  std::vector<std::string> words;
  std::string word;
  for (const char c : text + " ")
    if (c == ' ' || c == '\t' || c == ',')
    {
      if (!word.empty())
        words.push_back(word);
      word.clear();
    }
    else
      word += c;
  return words;
}

std::vector<std::string> split_list(const std::string &text, const char separator)
{
  std::vector<std::string> parts;
  if (trim(text).empty())
    return parts;
  int depth = 0;
  std::string part;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const bool doubled =
      (i > 0 && text[i - 1] == separator) || (i + 1 < text.size() && text[i + 1] == separator);
    const bool separates = text[i] == separator && depth == 0 && !(separator == '|' && doubled);
    if (separates)
    {
      parts.push_back(trim(part));
      part.clear();
      continue;
    }
    depth += text[i] == '(' ? 1 : (text[i] == ')' ? -1 : 0);
    part += text[i];
  }
  parts.push_back(trim(part));
  return parts;
}

bool read_number(const std::string &text, double &number)
{
  const std::string trimmed = trim(text);
  if (trimmed.empty())
    return false;
  char *end = nullptr;
  number = std::strtod(trimmed.c_str(), &end);
  return *end == '\0' && std::isfinite(number);
}

bool read_numbers(const std::string &text, std::vector<double> &numbers)
{
  numbers.clear();
  for (const std::string &part : split_list(text, ','))
  {
    double number = 0;
    if (!read_number(part, number))
      return false;
    numbers.push_back(number);
  }
  return true;
}

std::string shorten(const std::string &text)
{
  constexpr std::size_t longest = 120, beginning = 80, ending = 30;
  if (text.size() <= longest)
    return text;
  // Do not cut inside a character of UTF-8.
  const auto is_continued = [&](const std::size_t i) { return (text[i] & 0xC0) == 0x80; };
  std::size_t first = beginning, last = text.size() - ending;
  while (first > 0 && is_continued(first))
    --first;
  while (last < text.size() && is_continued(last))
    ++last;
  return text.substr(0, first) + " ... " + text.substr(last);
}

std::string shorten_path(const std::string &path)
{
  constexpr std::size_t longest = 100, ending = 60;
  if (path.size() <= longest)
    return path;
  std::size_t first = path.size() - ending;
  while (first < path.size() && (path[first] & 0xC0) == 0x80)
    ++first;
  return "..." + path.substr(first);
}

std::string quote(const std::string &text)
{
  return "'" + shorten(text) + "'";
}

std::string number_text(const double number)
{
  if (std::isnan(number))
    return "nan";
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string join(const std::vector<std::string> &words, const std::string &separator)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : separator) + words[i];
  return text;
}
} // namespace Signorini
