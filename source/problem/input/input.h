// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/formulas/expression.h>
#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/contact_pair.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Signorini {
/** The names of sides, and the texts that belong to them. */
using SideTexts = std::vector<std::pair<std::string, std::string>>;

/**
 * A text taken apart at the words that it may contain: "circle 0,1 radius 2" has the form "circle
 * radius" and the parts "0,1" and "2" of these words. The first part is the text before them,
 * "..." in the form; "0,1 fillet 2" has the form "... fillet".
 */
struct Phrase {
  struct Part {
    std::string word, text;
  };

  /** @param words separated by '|'. */
  Phrase(const std::string &text, const std::string &words);

  std::vector<Part> parts;
  std::string form;
};

/** Returns the side of this name, or the sides name.1, name.2, ... that a name of a mesh file has
 * become, or the contacts "name with ..." on it; empty if there is none. */
std::vector<std::string> sides_called(const std::string &name,
                                      const std::vector<std::string> &sides);

/** Reads "left: tx; ty | right: tx; ty". @throws InputError if an entry names no side. */
SideTexts read_side_list(const std::string &text, const std::string &where,
                         const std::vector<std::string> &sides);

/** Returns whether a text begins with a word and ':', so that it is for one side. */
bool begins_with_a_name(const std::string &text);

/** Makes a body one of revolution if its plane state says so. @throws InputError where a part of it
 * is not beside the axis, or where no side of its own lies on it. */
void revolve(const Given<PlaneState> &given, Geometry<2> &geometry);

/** Holds a body of revolution on its axis, where a side needs no entry.
 * @param entries that named the sides. @throws InputError for another role there, and for plates
 * that leave the axis. */
void hold_on_axis(const std::vector<const Entry *> &entries, Scene<2> &scene);

/** Two sides that may touch each other, the second one given by its name or by '*'. */
struct SidePair {
  unsigned int first;
  std::optional<unsigned int> second;

  bool has(const unsigned int side) const {
    return side == first || side == second;
  }
};

/** Reads the pairs of Boundary/Contact. @param sides their names. @param assign gives a side its
 * role. @throws InputError */
std::vector<SidePair> read_pairs(const Given<std::string> &given, unsigned int dimension,
                                 const std::vector<std::string> &sides,
                                 const std::function<void(const std::string &)> &assign);

/** Adds the contacts of pairs behind those that the scene has, with the parts on which they lie:
 * where one lies behind another one, the nearer partner counts. Partners of '*' are all sides of
 * other bodies without another role that the side sees.
 * @param may_exchange whether no formula belongs to the side that is named first.
 * @throws InputError */
void add_pairs(const std::vector<SidePair> &pairs, bool may_exchange, const Entry &entry,
               Scene<2> &scene);

/** The smallest -m.n that two sides must have somewhere: 30 degrees. */
constexpr double facing = 0.8660254037844386;

/** The share of the body's size by which bodies may overlap as they are drawn. */
constexpr double small_overlap = 0.01;

/** Returns the names by which entries call the contacts: that of the side, or "side with other"
 * where Γ_c of several lies on it. */
template <int dim>
std::vector<std::string> contact_names(const Scene<dim> &scene) {
  std::vector<std::string> names;
  for (const ContactPair<dim> &pair : contact_pairs(scene)) {
    const auto n = std::count_if(scene.contacts.begin(), scene.contacts.end(),
                                 [&](const auto &other) { return other.side == pair.side(); });
    names.push_back(n > 1 ? pair.name() : scene.geometry.sides[pair.side()].name());
  }
  return names;
}

/** Returns these names in place of their sides, and the names of all other sides. */
template <int dim>
std::vector<std::string> names_with_contacts(const Scene<dim> &scene) {
  const std::vector<std::string> of_contacts = contact_names(scene);
  std::vector<std::string> names;
  for (unsigned int side = 0; side < scene.geometry.sides.size(); ++side) {
    for (std::size_t i = 0; i < of_contacts.size(); ++i)
      if (scene.contacts[i].side == side)
        names.push_back(of_contacts[i]);
    if (!scene.has_contact_on(side))
      names.push_back(scene.geometry.sides[side].name());
  }
  return names;
}

/**
 * Reads "expression" for all of @p called or "bottom: ... | left: ...", one for each of these
 * sides.
 * @throws InputError if one of them has none or two, or another side is named.
 */
SideTexts read_list_for(const std::vector<std::string> &called, const std::string &text,
                        const std::string &where, const std::vector<std::string> &sides);

/** Returns the number of the contact with a name of contact_names(). */
template <int dim>
unsigned int find_contact(const std::string &name, const Scene<dim> &scene) {
  const std::vector<std::string> names = contact_names(scene);
  return std::find(names.begin(), names.end(), name) - names.begin();
}

/** Reads the same for the contacts; the name of a side is that of all contacts on it. @return their
 * numbers, with their texts. */
template <int dim>
std::vector<std::pair<unsigned int, std::string>> read_contact_list(const Given<std::string> &given,
                                                                    const Scene<dim> &scene) {
  std::vector<std::pair<unsigned int, std::string>> texts;
  for (const auto &[name, text] :
       read_list_for(contact_names(scene), given.value, given.where(), names_with_contacts(scene)))
    texts.emplace_back(find_contact(name, scene), text);
  return texts;
}

/** Reads Boundary/Plates with Load/Plate force, Plate moment and Plate travel. @throws InputError.
 */
template <int dim>
std::vector<Plate<dim>> read_plates(const Given<std::string> &given, const LoadParameters &load,
                                    const Geometry<dim> &geometry);

/**
 * Reads "plane x,y normal nx,ny | bottom: circle x,y radius r" and gives the named contact sides
 * their foundation and gap. An obstacle that no normal can meet is refused, in its position or,
 * where load cases make it move, in all.
 * @throws InputError
 */
template <int dim>
void read_foundation(const ContactParameters &given, bool moves, Scene<dim> &scene);

/**
 * Returns the contacts that read_foundation() left without a gap, with their texts in
 * Contact/Gap; without those of pairs that this does not name.
 * @throws InputError if a side has both, or one on rigid ground neither.
 */
template <int dim>
SideTexts gaps_without_foundation(const ContactParameters &given, const Scene<dim> &scene);

/** Reads "x, y" or "x, y, z": n numbers. @p text is all of the entry or a part of it. @throws
 * InputError */
std::vector<double> read_coordinates(const std::string &text, unsigned int n, const Entry &entry);

/** Reads a point, too. Coordinates beyond max_magnitude, whose squares would overflow before the
 * size of the body is checked, are refused. @throws InputError */
template <int dim>
Point<dim> read_point(const std::string &text, const Entry &entry);

/** Refuses a body that is too large, too small or too far away to compute with; @p where is the
 * parameter that made it. */
template <int dim>
void check_size(const Geometry<dim> &geometry, const std::string &where);

/** Reads the probes of Output/Report. @throws InputError */
template <int dim>
std::vector<Probe<dim>> read_probes(const Given<std::string> &given, const Geometry<dim> &geometry);

/** Refuses entries that are given, unless they @p belong to the choice that is @p found. @throws
 * InputError */
void refuse_foreign_entries(bool belong, const std::vector<const Entry *> &entries,
                            const std::string &owner, const std::string &found);

/** Refuses, with Dimension = 3, entries that exist in 2-D only. @throws InputError */
void refuse_2d_entries(const Parameters &parameters);

/** Returns the body that the entries describe. @throws InputError */
template <int dim>
Geometry<dim> make_geometry(const GeometryParameters &given);
template <>
Geometry<2> make_geometry(const GeometryParameters &given);
template <>
Geometry<3> make_geometry(const GeometryParameters &given);

/** Returns the body, or the bodies of Geometry/Bodies as one geometry. @throws InputError */
Geometry<2> make_geometry_of_bodies(const Parameters &parameters);

/** Makes the gaps of all pairs of sides. @throws InputError if two sides do not face each other, or
 * bodies overlap. */
void close_pairs(const std::string &where, Scene<2> &scene);

/** Reads the body of Shape = polygon. */
Geometry<2> read_polygon(const GeometryParameters &given);

/** Refuses moduli that are far too large or too small, at points all over the body.
 * @throws InputError */
template <int dim>
void check_moduli(const std::vector<Expression<dim>> &moduli, const Geometry<dim> &geometry);

/** Evaluates everything once where the integrals will, to find data without values and an exact
 * solution that contradicts itself before the computation starts. @throws InputError */
template <int dim>
void check_described_scene(const Parameters &parameters, const Scene<dim> &scene);

/** Reads the subsection Load cases. @throws InputError. */
template <int dim>
std::vector<LoadCase> read_load_cases(const LoadCasesParameters &given, const Scene<dim> &scene);
} // namespace Signorini
