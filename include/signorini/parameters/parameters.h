// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace Signorini
{
/** Which scene is solved: `described` by expressions, or one of the catalogue. */
struct SceneParameters
{
  std::string name = "described";
};

/** Subsection Constants: names that expressions may use. */
struct ConstantsParameters
{
  std::string values;
};

/** Subsection Geometry: the body before it is meshed (lengths). */
struct GeometryParameters
{
  std::string shape = "rectangle";
  std::string lower_left = "0, 0";
  std::string upper_right = "1, 1";
  std::string cells = "1, 1";
  std::string vertices;
  std::string file;
  double distortion = 0.;
};

/** Subsection Material: Hooke's tensor. */
struct MaterialParameters
{
  std::string law = "isotropic";
  std::string youngs_modulus = "1";
  std::string poissons_ratio = "0.3";
  std::string hooke_tensor;
  std::string orthotropic_moduli;
  double orientation = 0.;
  std::string plane_state = "strain";
};

/** Subsection Boundary: one role per side. */
struct BoundaryParameters
{
  std::string clamped;
  std::string rollers;
  std::string contact;
  std::string displacement;
  std::string traction;
};

/** Subsection Load. */
struct LoadParameters
{
  std::string body_force = "0; 0";
};

/** Subsection Contact. */
struct ContactParameters
{
  std::string gap = "0";
};

/** Subsection Exact solution: turns the error columns on. */
struct ExactSolutionParameters
{
  std::string displacement;
  std::string displacement_gradient;
  std::string pressure;
};

/** Subsection Discretization. */
struct DiscretizationParameters
{
  unsigned int coarsest_level = 2;
  unsigned int finest_level = 6;
  std::string element = "Q1";
  unsigned int patch_ratio = 2;
  unsigned int patches = 0;
  double target_error = 0.;
  unsigned int quadrature_points = 3;
  /** Positions of kinks, given as a list of numbers and read by check(). */
  std::vector<double> kinks_at_x;
  std::vector<double> kinks_at_y;
};

/** Subsection Solver. */
struct SolverParameters
{
  std::string contact_solver = "active set";
  double relaxation = 1.1;
  double tolerance = 1e-10;
  unsigned int maximum_iterations = 100000;
  std::string linear_solver = "automatic";
  bool warm_start = true;
  bool require_stability = false;
};

/** Subsection Output. */
struct OutputParameters
{
  std::string vtu = "finest";
  std::string inf_sup_constant = "automatic";
  bool compliance = false;
  bool errors = true;
  bool lemmas = false;
};

/**
 * Everything a user can set, as plain values: checked for their form, not yet for their meaning
 * (names of sides and expressions are judged when the scene is made).
 */
struct Parameters
{
  unsigned int dimension = 2;
  SceneParameters scene;
  ConstantsParameters constants;
  GeometryParameters geometry;
  MaterialParameters material;
  BoundaryParameters boundary;
  LoadParameters load;
  ContactParameters contact;
  ExactSolutionParameters exact;
  DiscretizationParameters discretization;
  SolverParameters solver;
  OutputParameters output;

  /** Every parameter as used, in the format of the parameter file. */
  std::string echo;
  /** The file the parameters were read from. */
  std::string file_name;
  /** Where each given parameter was set: path to "file:line" or "--set". */
  std::map<std::string, std::string> places;
  /** The paths of the parameters that are not at their default. */
  std::set<std::string> changes;

  /** "scene.prm:12: Solver/Tolerance": how every message about a parameter begins. */
  std::string where(const std::string &path) const;
  /** Whether the user gave this parameter a value other than its default. */
  bool changed(const std::string &path) const;
};

/**
 * Reads a parameter file and overrides of the form `Subsection/Parameter=value`.
 * Throws InputError with one sentence for everything that is wrong.
 */
Parameters read_parameters(const std::string &file_name,
                           const std::vector<std::string> &overrides = {});

/** The same from a text; @p file_name is used in messages only. */
Parameters parse_parameters(const std::string &text,
                            const std::string &file_name,
                            const std::vector<std::string> &overrides = {});

/** Every parameter with its default, allowed values, unit and one line of help. */
std::string describe_parameters();
} // namespace Signorini
