// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>

#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>

namespace Signorini
{
/** Goes through the words of a mesh file and knows the line of the last one. */
class GmshScanner
{
public:
  /** The text must outlive the scanner. */
  GmshScanner(const std::string &text, std::string name)
    : text_(text)
    , name_(std::move(name))
  {
  }

  /** Whether no word is left. */
  bool is_at_end()
  {
    skip_blanks();
    return position_ == text_.size();
  }

  /** The next word; @p what is what it should be. @throws InputError at the end of the file. */
  std::string_view word(const char *what)
  {
    if (is_at_end())
      throw InputError(name_ + ": the file ends where " + what + " should be.");
    const std::size_t start = position_;
    while (position_ < text_.size() && !is_blank(text_[position_]))
      ++position_;
    return std::string_view(text_).substr(start, position_ - start);
  }

  /** The next word as a number. @throws InputError if it is none. */
  template <typename Number>
  Number number(const char *what)
  {
    const std::string_view found = word(what);
    Number value = 0;
    const auto [end, error] = std::from_chars(found.data(), found.data() + found.size(), value);
    if (error != std::errc() || end != found.data() + found.size())
      refuse(found,
             std::string(what) + (std::is_unsigned_v<Number>   ? " (0, 1, 2, ...)"
                                  : std::is_integral_v<Number> ? " (an integer)"
                                                               : " (a number)"));
    return value;
  }

  /** How many of something follow: a number that the rest of the file can hold. */
  std::size_t count(const char *what)
  {
    const auto n = number<std::size_t>(what);
    if (n > text_.size() - position_)
      throw InputError(place() + ": found the number " + std::to_string(n) + " as " + what +
                       ", but the rest of the file has " +
                       std::to_string(text_.size() - position_) + " characters.");
    return n;
  }

  /** The next words between quotation marks. */
  std::string quoted(const char *what)
  {
    if (is_at_end() || text_[position_] != '"')
      refuse(word(what), what);
    const std::size_t end = text_.find_first_of("\"\n", position_ + 1);
    if (end == std::string::npos || text_[end] == '\n')
      refuse(text_.substr(position_, end - position_), what);
    const std::string found = text_.substr(position_ + 1, end - position_ - 1);
    position_ = end + 1;
    return found;
  }

  /** The next word must be this one. */
  void expect(const std::string &expected)
  {
    const std::string_view found = word(expected.c_str());
    if (found != expected)
      refuse(found, expected.c_str());
  }

  /** Goes on behind the next @p mark. */
  void skip_behind(const std::string &mark)
  {
    const std::string opened = place();
    while (!is_at_end())
      if (word("a word") == mark)
        return;
    throw InputError(opened + ": this section is not closed by " + mark + ".");
  }

  std::size_t line() const
  {
    return line_;
  }
  /** "part.msh:12", the line of the last word. */
  std::string place() const
  {
    return name_ + ":" + std::to_string(line_);
  }

  [[noreturn]] void refuse(const std::string_view found, const std::string &allowed) const
  {
    throw InputError(place() + ": found " + quote(std::string(found)) + ", allowed: " + allowed +
                     ".");
  }

private:
  static bool is_blank(const char c)
  {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
  }

  void skip_blanks()
  {
    for (; position_ < text_.size() && is_blank(text_[position_]); ++position_)
      line_ += text_[position_] == '\n' ? 1 : 0;
  }

  const std::string &text_;
  std::string name_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
};
} // namespace Signorini
