// SPDX-License-Identifier: LGPL-2.1-or-later
// signorini [options] SCENE.prm ...

#include "command_line.h"

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/verification/catalogue/catalogue.h>

#include <deal.II/base/config.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <boost/program_options.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <Trilinos_version.h>
#include <algorithm>
#include <dlfcn.h>
#include <filesystem>
#include <sstream>

namespace Signorini {
namespace {
namespace po = boost::program_options;

/** Returns the library that the BLAS calls end in, which decides the speed. */
std::string blas_in_use() {
  if (void *const symbol = dlsym(RTLD_DEFAULT, "openblas_get_config")) {
    const auto get_config = reinterpret_cast<char *(*)()>(symbol);
    return get_config();
  }
  Dl_info info = {};
  void *const dgemm = dlsym(RTLD_DEFAULT, "dgemm_");
  const bool known = dgemm != nullptr && dladdr(dgemm, &info) != 0;
  return std::string(known ? info.dli_fname : "unknown") +
         " (the package libopenblas0-pthread is several times faster)";
}

std::string version_text() {
  std::ostringstream text;
  text << "signorini " << SIGNORINI_VERSION << "\n"
       << "deal.II   " << DEAL_II_PACKAGE_VERSION << "\n"
       << "Trilinos  " << TRILINOS_VERSION_STRING << "\n"
       << "BLAS      " << blas_in_use() << "\n";
  return text.str();
}

std::string help_text(const po::options_description &options) {
  std::ostringstream text;
  text
    << "Solves the Signorini problem: elastic bodies pressed against a rigid foundation or "
       "against each other, with or without friction.\n\n"
    << "usage: signorini [options] SCENE.prm ...\n\n"
    << options
    << "\nExit codes: 0 solved and certified; 1 the input is wrong; 2 not converged or not "
       "certified (results are\nwritten and marked); 3 anything else; 128 + n ended by signal n.\n";
  return text.str();
}

po::options_description describe_options(CommandLine &command_line) {
  po::options_description options("options");
  options.add_options() //
    ("set", po::value(&command_line.overrides)->value_name("'Subsection/Parameter=value'"),
     "override a parameter, or one constant by NAME=value; may be repeated") //
    ("sweep", po::value(&command_line.sweeps)->value_name("'Subsection/Parameter=v1, v2, ...'"),
     "run the scene for each value (values with commas: v1 | v2), in directories named by the "
     "values, and write one table, sweep.csv; several sweeps: all combinations") //
    ("verify", po::value<std::string>()->value_name("FILE"),
     "after the run, tell the error of the displacement of another program (.vtu): "
     "Verify/File=FILE") //
    ("verify-tolerance", po::value<std::string>()->value_name("X"),
     "exit code 2 unless its relative error is at most X: Verify/Tolerated error=X") //
    ("output", po::value<std::string>()->value_name("DIR"),
     "where results go (default: results/<name of the .prm file>); of several scenes: "
     "DIR/<name>") //
    ("check", po::bool_switch(&command_line.check),
     "solve nothing: print the sides of the body with their roles and data, and what a run may "
     "cost, and draw the scene (scene.svg)") //
    ("quiet", po::bool_switch(&command_line.quiet),
     "print nothing but warnings and errors; files and exit code say the rest") //
    ("list-scenes", "the scenes known by name")                                 //
    ("print-parameters",
     "every parameter with default, allowed values and meaning, or those of the "
     "subsections that are named")                                                //
    ("version", "versions of the program, deal.II, Trilinos and the BLAS in use") //
    ("help,h", "this text");
  return options;
}

po::variables_map parse(const int argc, char **argv, const po::options_description &visible,
                        CommandLine &command_line) {
  po::options_description all;
  all.add(visible).add_options()("scene", po::value(&command_line.parameter_files));
  po::positional_options_description positional;
  positional.add("scene", -1);
  po::variables_map values;
  // Guessing abbreviations would make new options break old command lines.
  const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
  try {
    po::store(
      po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
      values);
    po::notify(values);
  } catch (const po::error &error) {
    throw InputError(std::string("command line: ") + error.what() +
                     "; --help lists what is allowed.");
  }
  return values;
}
/** Returns one directory per file. */
std::vector<std::string> choose_directories(const std::vector<std::string> &files,
                                            const std::filesystem::path &output,
                                            const bool is_given) {
  if (output.empty())
    throw InputError("--output: found '', allowed: the name of a directory.");
  if (is_given && files.size() == 1)
    return {output.string()};
  std::vector<std::string> directories;
  for (const std::string &file : files) {
    const std::string directory = (output / std::filesystem::path(file).stem()).string();
    const auto same = std::find(directories.begin(), directories.end(), directory);
    if (same != directories.end())
      throw InputError("command line: found the parameter files " +
                       quote(files[same - directories.begin()]) + " and " + quote(file) +
                       ", whose results would both go to " + quote(directory) +
                       ", allowed: files of different names, or one at a time.");
    directories.push_back(directory);
  }
  return directories;
}
} // namespace

CommandLine read_command_line(const int argc, char **argv) {
  CommandLine command_line;
  const po::options_description options = describe_options(command_line);
  const po::variables_map values = parse(argc, argv, options, command_line);
  if (values.count("help") > 0)
    command_line.text = help_text(options);
  else if (values.count("version") > 0)
    command_line.text = version_text();
  else if (values.count("list-scenes") > 0)
    command_line.text = describe_catalogue();
  else if (values.count("print-parameters") > 0)
    command_line.text = describe_parameters(command_line.parameter_files);
  if (!command_line.text.empty())
    return command_line;

  if (command_line.parameter_files.empty())
    throw InputError("command line: no parameter file is given, allowed: signorini [options] "
                     "SCENE.prm ... (see --help).");
  // Files of the command line are those of the working folder.
  if (values.count("verify") > 0)
    command_line.overrides.push_back(
      "Verify/File=" + std::filesystem::absolute(values["verify"].as<std::string>()).string());
  if (values.count("verify-tolerance") > 0)
    command_line.overrides.push_back("Verify/Tolerated error=" +
                                     values["verify-tolerance"].as<std::string>());
  command_line.directories =
    choose_directories(command_line.parameter_files,
                       values.count("output") > 0 ? values["output"].as<std::string>() : "results",
                       values.count("output") > 0);
  return command_line;
}

std::string share_command_line(CommandLine &command_line, MPI_Comm communicator) {
  const auto packed = [](const CommandLine &given) { return Utilities::pack(given, false); };
  const std::vector<char> mine = packed(command_line);
  command_line = Utilities::MPI::broadcast(communicator, command_line);
  return list_ranks(communicator, packed(command_line) != mine);
}
} // namespace Signorini
