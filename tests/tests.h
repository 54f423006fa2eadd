// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <iostream>
#include <string>

/**
 * Assertions with names. Each prints one line, "name: ok" or what was found instead; a test returns
 * exit_code() from main. Numbers are not printed when they are right, so that the stored output
 * does not depend on rounding.
 */
class Checks
{
public:
  /** Starts without failures. @param speak false on ranks other than the first, whose lines would
   * repeat. */
  explicit Checks(const bool speak = true)
    : speak_(speak)
  {
  }

  void that(const std::string &name, const bool condition)
  {
    report(name, condition, "the condition does not hold");
  }

  /** Checks that |value - expected| ≤ tolerance. */
  void
  near(const std::string &name, const double value, const double expected, const double tolerance)
  {
    report(name,
           std::abs(value - expected) <= tolerance,
           "found " + std::to_string(value) + ", expected " + std::to_string(expected) +
             ", difference " + std::to_string((value - expected) / tolerance) + " tolerances");
  }

  /** Checks that low ≤ value ≤ high. */
  void between(const std::string &name, const double value, const double low, const double high)
  {
    report(name,
           value >= low && value <= high,
           "found " + std::to_string(value) + ", expected " + std::to_string(low) + " to " +
             std::to_string(high));
  }

  /** Checks that the call throws an Exception whose message contains @p fragment. */
  template <typename Exception, typename Call>
  void throws(const std::string &name, const std::string &fragment, const Call &call)
  {
    std::string found = "nothing was thrown";
    try
    {
      call();
    }
    catch (const Exception &exception)
    {
      found = exception.what();
    }
    report(name, found.find(fragment) != std::string::npos, found);
  }

  int exit_code() const
  {
    return n_failures_ == 0 ? 0 : 1;
  }

private:
  void report(const std::string &name, const bool passed, const std::string &found)
  {
    n_failures_ += passed ? 0 : 1;
    if (speak_ || !passed)
      std::cout << name << ": " << (passed ? "ok" : "FAILED, " + found) << std::endl;
  }

  bool speak_;
  unsigned int n_failures_ = 0;
};
