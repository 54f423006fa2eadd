// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/formulas/formula.h>
#include <signorini/problem/parameters/options.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Signorini {
/** The name and the origin of an entry of the parameter file, for messages. */
struct Entry {
  /** The subsection and the name: "Solver/Tolerance". */
  std::string name;
  /** The origin, "scene.prm:12", "--set" or "--sweep"; for a default the file alone. */
  std::string origin;
  /** Whether the value is given, and whether it differs from the default. */
  bool is_given = false, changed = false;
  /** The constants that numbers of the entry may be made of. */
  std::shared_ptr<const Constants> constants = std::make_shared<const Constants>();

  /** Returns "scene.prm:12: Solver/Tolerance", the beginning of every message about the entry. */
  std::string where() const {
    return origin + ": " + name;
  }
};

/** The value of an entry, with its origin. It converts to the value. */
template <typename T>
struct Given : Entry {
  T value = T();

  Given() = default;
  /** Stores a default. */
  explicit Given(T default_value)
    : value(std::move(default_value)) {}
  operator const T &() const {
    return value;
  }
};

/** The scene that is solved: `described` by expressions, or one of the catalogue. */
struct SceneParameters {
  Given<std::string> name{"described"};
};

/** Subsection Constants: names that expressions may use. */
struct ConstantsParameters {
  Given<std::string> values;
};

/** Subsection Geometry: the body before it is meshed (lengths). */
struct GeometryParameters {
  /** The names of the bodies; empty for one body. */
  Given<std::string> bodies;
  Given<Shape> shape{Shape::rectangle};
  Given<std::string> lower_left{"0, 0"};
  Given<std::string> upper_right{"1, 1"};
  Given<std::string> cells{"1, 1"};
  Given<std::string> vertices;
  Given<std::string> holes;
  Given<double> mesh_size{0.};
  Given<std::string> centre{"0, 0"};
  Given<double> radius{1.};
  Given<double> inner_radius{0.5};
  Given<std::string> file;
  /** The mesh of the file as text of Gmsh, where it has been read already. */
  std::string mesh;
  /** The name of the body, where the file holds several. */
  std::string part;
  Given<std::string> arcs;
  Given<std::string> surfaces;
  /** The folder of the parameter file, in which files are looked for first; empty if the parameters
   * come from no file. */
  std::string folder;
  Given<double> distortion{0.};
  Given<double> thickness{1.};
};

/** Subsection Material: Hooke's tensor. */
struct MaterialParameters {
  Given<MaterialLaw> law{MaterialLaw::isotropic};
  Given<std::string> youngs_modulus{"1"};
  Given<std::string> poissons_ratio{"0.3"};
  Given<std::string> hooke_tensor;
  Given<std::string> orthotropic_moduli;
  Given<double> orientation{0.};
  Given<std::string> moduli_across;
  Given<PlaneState> plane_state{PlaneState::strain};
};

/** Subsection Boundary: one role per side. */
struct BoundaryParameters {
  /** The beginning of messages about the whole subsection: "scene.prm: Boundary". */
  std::string where;
  Given<std::string> clamped;
  Given<std::string> rollers;
  Given<std::string> contact;
  Given<std::string> displacement;
  Given<std::string> traction;
  Given<std::string> plates;
};

/** Subsection Load. */
struct LoadParameters {
  Given<std::string> body_force{"0; 0"};
  Given<std::string> plate_force;
  Given<std::string> plate_moment;
  Given<std::string> plate_cross_force;
  Given<std::string> plate_travel;
};

/** Subsection Contact. */
struct ContactParameters {
  Given<std::string> gap{"0"};
  /** The rigid obstacles instead of the gap. */
  Given<std::string> foundation;
  Given<std::string> foundation_position{"0, 0"};
  Given<ContactDirection> direction{ContactDirection::foundation};
  Given<Friction> law{Friction::none};
  Given<std::string> friction_coefficient;
  Given<std::string> friction_bound;
  Given<std::string> foundation_shift;
};

/** Subsection Load cases. */
struct LoadCasesParameters {
  Given<std::string> cases;
  Given<CaseSequence> sequence{CaseSequence::independent};
  Given<std::string> fields;
};

/** Subsection Exact solution: turns the error columns on. */
struct ExactSolutionParameters {
  Given<std::string> displacement;
  Given<std::string> displacement_gradient;
  Given<std::string> pressure;
};

/** Subsection Discretization. */
struct DiscretizationParameters {
  Given<Strategy> strategy{Strategy::automatic};
  Given<unsigned int> coarsest_level{2};
  Given<unsigned int> finest_level{6};
  Given<Element> element{Element::q1};
  Given<unsigned int> patch_ratio{2};
  Given<std::string> patches{"0"};
  Given<double> target_error{0.};
  Given<unsigned int> maximum_unknowns{200000};
  Given<unsigned int> maximum_degree{9};
  Given<unsigned int> quadrature_points{3};
  /** The positions of kinks. */
  Given<std::vector<double>> kinks_at_x;
  Given<std::vector<double>> kinks_at_y;
};

/** Subsection Solver. */
struct SolverParameters {
  Given<ContactSolver> contact_solver{ContactSolver::automatic};
  Given<double> relaxation{1.1};
  Given<double> tolerance{1e-10};
  Given<unsigned int> maximum_iterations{100000};
  Given<LinearSolver> linear_solver{LinearSolver::automatic};
  Given<bool> warm_start{true};
  Given<double> tolerated_error{0.2};
  Given<bool> require_stability{false};
};

/** Subsection Output. */
struct OutputParameters {
  Given<std::string> report;
  Given<VtuLevels> vtu{VtuLevels::finest};
  Given<Choice> inf_sup_constant{Choice::automatic};
  Given<WantedBound> bound{WantedBound::automatic};
  Given<bool> compliance{false};
  Given<bool> errors{true};
  Given<bool> lemmas{false};
  Given<bool> pictures{false};
};

/** Subsection Verify: the displacement of another program. */
struct VerifyParameters {
  Given<std::string> file;
  Given<std::string> field{"displacement"};
  Given<double> factor{1.};
  Given<double> tolerance{1e-5};
  Given<double> tolerated_error{0.};
};

/**
 * Everything a user can set, as plain values: checked for their form, not yet for their meaning
 * (names of sides and expressions are checked when the scene is made). Every value stores the line
 * where it was given.
 */
struct Parameters {
  Given<unsigned int> dimension{2};
  SceneParameters scene;
  ConstantsParameters constants;
  GeometryParameters geometry;
  /** The same for every one of several bodies. */
  std::vector<GeometryParameters> bodies;
  MaterialParameters material;
  BoundaryParameters boundary;
  LoadParameters load;
  ContactParameters contact;
  LoadCasesParameters load_cases;
  ExactSolutionParameters exact;
  DiscretizationParameters discretization;
  SolverParameters solver;
  OutputParameters output;
  VerifyParameters verify;

  /** All parameters as used, in the format of the parameter file. */
  std::string echo;
  /** The file the parameters were read from. */
  std::string file_name;
  /** The entries from Constants to Exact solution that are not at their defaults. A catalogue scene
   * allows none. */
  std::vector<Entry> changes_of_scene;
};

/**
 * Reads a parameter file and overrides of the form `Subsection/Parameter=value`. The override
 * `Constants/NAME=value` changes one constant of the list `Constants/Values`.
 * @throws InputError with one sentence for everything that is wrong.
 */
Parameters read_parameters(const std::string &file_name,
                           const std::vector<std::string> &overrides = {});

/**
 * Reads the same from a text; @p file_name is used in messages only. Files that the text names are
 * looked for in @p folder, then in the working folder; their names become absolute, so that the
 * echo works everywhere. @param swept further overrides, which messages call values of --sweep.
 */
Parameters parse_parameters(const std::string &text, const std::string &file_name,
                            const std::vector<std::string> &overrides = {},
                            const std::string &folder = "",
                            const std::vector<std::string> &swept = {});

/** Writes another value of an entry into the echo of parameters: one that the program decides. */
void set_in_echo(const std::string &path, const std::string &value, std::string &echo);

/** Returns all parameters, or those of some subsections, with their defaults, allowed values, units
 * and one line of help each. @throws InputError for other names. */
std::string describe_parameters(const std::vector<std::string> &sections = {});
} // namespace Signorini
