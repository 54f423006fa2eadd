// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/errors.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

/**
 * Assertions with names. Each prints one line, "name: ok" or the value found instead; a test
 * returns exit_code() from main. Numbers are not printed when they are right, so that the stored
 * output does not depend on rounding. An assertion may stand in a loop: "ok" is printed once per
 * name, a check that fails every time.
 */
class Checks {
public:
  /** Starts without failures. @param speak false on ranks other than the first, whose lines would
   * repeat. @param whole_table see rows(). */
  explicit Checks(const bool speak = true, const bool whole_table = false)
    : speak_(speak)
    , whole_table_(whole_table) {}

  /** Returns @p n rows of a long table, evenly spread, which are enough for every day; all of them
   * if the test was called with the argument "long". */
  template <typename Row>
  std::vector<Row> rows(const std::vector<Row> &table, const std::size_t n) const {
    if (whole_table_ || n >= table.size())
      return table;
    std::vector<Row> some;
    for (std::size_t i = 0; i < n; ++i)
      some.push_back(table[i * table.size() / n]);
    return some;
  }

  /** Returns whether the test was called with the argument "long". */
  bool is_long() const {
    return whole_table_;
  }

  /** The names of all checks that follow begin with @p subject. */
  void about(const std::string &subject) {
    subject_ = subject.empty() ? "" : subject + ": ";
  }

  void that(const std::string &name, const bool condition) {
    report(name, condition, "the condition does not hold");
  }

  /** Checks that |value - expected| ≤ tolerance. */
  void near(const std::string &name, const double value, const double expected,
            const double tolerance) {
    report(name, std::abs(value - expected) <= tolerance,
           "found " + std::to_string(value) + ", expected " + std::to_string(expected) +
             ", difference " + std::to_string((value - expected) / tolerance) + " tolerances");
  }

  /** The same for points, vectors and tensors. */
  template <typename First, typename Second>
  auto near(const std::string &name, const First &value, const Second &expected,
            const double tolerance) -> decltype((value - expected).norm(), void()) {
    near(name, (value - expected).norm(), 0., tolerance);
  }

  /** Checks each entry of a list, and that there are as many as expected. */
  void near(const std::string &name, const std::vector<double> &values,
            const std::vector<double> &expected, const double tolerance) {
    if (values.size() != expected.size())
      return near(name + ", entries", values.size(), expected.size(), 0.);
    for (std::size_t i = 0; i < values.size(); ++i)
      near(name, values[i], expected[i], tolerance);
  }

  /** Checks that low ≤ value ≤ high. */
  void between(const std::string &name, const double value, const double low, const double high) {
    report(name, value >= low && value <= high,
           "found " + std::to_string(value) + ", expected " + std::to_string(low) + " to " +
             std::to_string(high));
  }

  /** Checks that the call throws an Exception whose message contains @p fragment. */
  template <typename Exception, typename Call>
  void throws(const std::string &name, const std::string &fragment, const Call &call) {
    std::string found = "nothing was thrown";
    try {
      call();
    } catch (const Exception &exception) {
      found = exception.what();
    }
    report(name, found.find(fragment) != std::string::npos, found);
  }

  /** Checks that the call throws an InputError with exactly this message. */
  template <typename Call>
  void refuses(const std::string &message, const Call &call) {
    std::string found = "nothing was thrown";
    try {
      call();
    } catch (const Signorini::InputError &exception) {
      found = exception.what();
    }
    report(message, found == message, found);
  }

  int exit_code() const {
    return n_failures_ == 0 ? 0 : 1;
  }

private:
  void report(const std::string &name, const bool passed, const std::string &found) {
    n_failures_ += passed ? 0 : 1;
    if (!passed || (names_.insert(subject_ + name).second && speak_))
      std::cout << subject_ << name << ": " << (passed ? "ok" : "FAILED, " + found) << std::endl;
  }

  bool speak_, whole_table_;
  std::string subject_;
  std::set<std::string> names_;
  unsigned int n_failures_ = 0;
};

/** Runs all tests of a file one after the other. @return the exit code of main. */
inline int run_tests(const std::initializer_list<void (*)(Checks &)> tests, const bool speak = true,
                     const bool whole_table = false) {
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks(speak, whole_table);
  for (const auto &test : tests) {
    checks.about("");
    test(checks);
  }
  return checks.exit_code();
}

/** The same with MPI, on all processes; the first one speaks. The argument "long" asks for whole
 * tables, see Checks::rows(). */
inline int run_tests(int argc, char **argv, const std::initializer_list<void (*)(Checks &)> tests) {
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return run_tests(tests, dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0,
                   argc > 1 && argv[1] == std::string("long"));
}

/** Returns the text of a file. */
inline std::string file_text(const std::string &name) {
  std::ostringstream text;
  text << std::ifstream(name).rdbuf();
  return text.str();
}
