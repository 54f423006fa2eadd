// SPDX-License-Identifier: LGPL-2.1-or-later
// A wrong DEAL_II_NUM_THREADS gives one sentence and exit code 1, like other wrong input.
//
// deal.II reads the variable while its library is loaded, before main(), and ends the program by
// std::terminate() and a stack trace if it is not a positive number. Only functions in
// .preinit_array of the program come earlier; the C++ library is not ready for use then.

#include <cstdlib>
#include <cstring>
#include <unistd.h>

namespace
{
constexpr long largest = 1024;

void say(const char *const text)
{
  // Nothing can be done where not even this can be written.
  if (write(STDERR_FILENO, text, std::strlen(text)) < 0)
    return;
}

bool is_allowed(const char *const text)
{
  if (*text == 0 || std::strspn(text, "0123456789") != std::strlen(text))
    return false;
  const long number = std::strtol(text, nullptr, 10);
  return number >= 1 && number <= largest;
}

void check_thread_limit(int /*argc*/, char ** /*argv*/, char **environment)
{
  constexpr char name[] = "DEAL_II_NUM_THREADS=";
  constexpr std::size_t length = sizeof(name) - 1;
  for (char **entry = environment; *entry != nullptr; ++entry)
    if (std::strncmp(*entry, name, length) == 0 && !is_allowed(*entry + length))
    {
      say("signorini: The environment variable DEAL_II_NUM_THREADS: found '");
      say(*entry + length);
      say("', allowed: an integer from 1 to 1024, or to leave it unset.\n");
      _exit(1);
    }
}
} // namespace

__attribute__((section(".preinit_array"),
               used)) static void (*const check_first)(int, char **, char **) = check_thread_limit;
