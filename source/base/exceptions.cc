// SPDX-License-Identifier: LGPL-2.1-or-later
// One sentence, on one line.

#include <signorini/base/exceptions.h>

#include <algorithm>
#include <cctype>

namespace Signorini
{
std::string one_line(std::string sentence)
{
  std::replace_if(
    sentence.begin(),
    sentence.end(),
    [](const unsigned char c) { return std::iscntrl(c) != 0; },
    '?');
  return sentence;
}
} // namespace Signorini
