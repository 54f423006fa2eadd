// SPDX-License-Identifier: LGPL-2.1-or-later
// Boundary/Contact: contact sides, pairs of them, and the parts on which these may touch.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/base/text.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/problem/scene/facing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "input.h"

namespace Signorini {
std::vector<SidePair> read_pairs(const Given<std::string> &given, const unsigned int dimension,
                                 const std::vector<std::string> &sides,
                                 const std::function<void(const std::string &)> &assign) {
  std::vector<SidePair> pairs;
  const auto find = [&](const std::string &name) {
    const unsigned int side = std::find(sides.begin(), sides.end(), name) - sides.begin();
    if (std::none_of(pairs.begin(), pairs.end(),
                     [side](const SidePair &pair) { return pair.has(side); }))
      assign(name);
    return side;
  };
  for (const std::string &part : split_list(given, '|')) {
    const std::vector<std::string> words = split_words(part);
    if (std::count(words.begin(), words.end(), "with") == 0)
      continue;
    if (dimension == 3 || words.size() < 3 || words[1] != "with")
      throw error_at(given, "found ", quote(part),
                     ", allowed for a pair, in the plane: the name of a side, the word 'with' and "
                     "the names of the sides that it may touch, or '*' for all of other bodies; "
                     "pairs and other sides are separated by '|'.");
    const unsigned int first = find(words[0]);
    for (std::size_t i = 2; i < words.size(); ++i) {
      const std::vector<std::string> called = sides_called(words[i], sides);
      if (words[i] == "*")
        pairs.push_back({first, {}});
      else
        for (const std::string &name :
             called.empty() ? std::vector<std::string>{words[i]} : called) {
          const SidePair pair = {first, find(name)};
          if (pair.first == pair.second ||
              std::any_of(pairs.begin(), pairs.end(), [&](auto &other) {
                return other.second && other.has(pair.first) && other.has(*pair.second);
              }))
            throw error_at(given, "found ", quote(part),
                           ", allowed: two different sides, and each pair once.");
          pairs.push_back(pair);
        }
    }
  }
  return pairs;
}

namespace {
/** The part of a side that belongs to a contact: the arc lengths of its ends; around a closed side
 * the second may exceed the length (length). */
struct Share {
  double from, to;
  /** Whether they are the ends of Γ_c in reverse order. */
  bool is_reversed;
};

/** The contacts of bodies: their parts, and who is nearer where two lie over the same part. */
class Overlaps {
public:
  Overlaps(const Entry &entry, Scene<2> &scene)
    : entry_(entry)
    , scene_(scene)
    , small_(1e-9 * scene.geometry.diameter()) {}

  /** Finds the part of the first side on which each contact lies. @param seeks whether the contact
   * was found by '*': it is left out where others are nearer everywhere.
   * @throws InputError where neither of two is nearer. */
  void find(const std::vector<bool> &seeks);

private:
  const Side<2> &side(const unsigned int number) const {
    return scene_.geometry.sides[number];
  }
  bool is_empty(const ContactCondition<2> &contact) const {
    return contact.opposite && !(contact.to - contact.from > small_);
  }
  Share share_on(const ContactCondition<2> &contact, unsigned int number) const;
  void move(ContactCondition<2> &contact, unsigned int number, bool is_start, double s) const;
  double distance(const ContactCondition<2> &contact, unsigned int number, double s) const;
  void separate(ContactCondition<2> &a, ContactCondition<2> &b, unsigned int number);
  void remove(ContactCondition<2> &contact, double from, double to, unsigned int number,
              const ContactCondition<2> &nearer);
  std::string name(const ContactCondition<2> &contact) const {
    return "'" + side(contact.side).name() + "' with '" + side(*contact.opposite).name() + "'";
  }

  const Entry &entry_;
  Scene<2> &scene_;
  double small_;
};

/** Returns the part of either side of a contact; that of the second one lies across. */
Share Overlaps::share_on(const ContactCondition<2> &contact, const unsigned int number) const {
  if (number == contact.side)
    return {contact.from, contact.to, false};
  // At an end the line may meet a circle in two points that are equally far.
  const double inside = 1e-9 * (contact.to - contact.from);
  const auto [start, end] =
    part_across(side(contact.side), side(number), contact.from + inside, contact.to - inside);
  return {std::min(start, end), std::max(start, end), end < start};
}

/** Moves the start or the end of the part of a contact on either of its sides. */
void Overlaps::move(ContactCondition<2> &contact, const unsigned int number, const bool is_start,
                    double s) const {
  double &end = is_start != share_on(contact, number).is_reversed ? contact.from : contact.to;
  if (number != contact.side) {
    const Side<2> &first = side(contact.side);
    s = first.arc_length(side(number).point(s));
    s = first.is_closed() ? s + first.length() * std::round((end - s) / first.length())
                          : std::clamp(s, 0., first.length());
  }
  end = s;
}

/** Returns the distance of the partner from a point of a side. */
double Overlaps::distance(const ContactCondition<2> &contact, const unsigned int number,
                          const double s) const {
  const Side<2> &other = side(number == contact.side ? *contact.opposite : contact.side);
  const Point<2> x = side(number).point(s);
  double t = other.arc_length(x);
  if (!other.is_closed())
    t = std::clamp(t, 0., other.length());
  return x.distance(other.point(t));
}

/** Takes a part of a side away from a contact. */
void Overlaps::remove(ContactCondition<2> &contact, const double from, const double to,
                      const unsigned int number, const ContactCondition<2> &nearer) {
  if (!(to - from > small_))
    return;
  const Share all = share_on(contact, number);
  const bool at_start = from <= all.from + small_, at_end = to >= all.to - small_;
  if (at_start && at_end)
    contact.to = contact.from;
  else if (at_start)
    move(contact, number, true, to);
  else if (at_end)
    move(contact, number, false, from);
  else if (number == contact.side && side(number).is_closed() &&
           all.to - all.from >= side(number).length() - small_) {
    contact.from = to;
    contact.to = from + side(number).length();
  } else
    throw error_at(entry_, "the pair ", name(nearer), " lies in the middle of the pair ",
                   name(contact), " on the side '", side(number).name(),
                   "', allowed: partners beside each other; divide a side into two.");
}

/** Gives every point of a common side of two contacts to the nearer partner. */
void Overlaps::separate(ContactCondition<2> &a, ContactCondition<2> &b, const unsigned int number) {
  const double length = side(number).length();
  for (const int turn : {-1, 0, 1}) {
    if ((turn != 0 && !side(number).is_closed()) || is_empty(a) || is_empty(b))
      continue;
    const Share of_a = share_on(a, number), of_b = share_on(b, number);
    const double shift = turn * length, from = std::max(of_a.from, of_b.from + shift),
                 to = std::min(of_a.to, of_b.to + shift);
    if (!(to - from > small_))
      continue;
    const auto excess = [&](const double s) {
      return distance(a, number, s) - distance(b, number, s);
    };
    // Where the sign changes, the partners are equally far.
    constexpr unsigned int n_intervals = 32;
    std::vector<double> cuts = {from};
    int sign = 0;
    double last = from;
    for (unsigned int i = 0; i <= n_intervals; ++i) {
      const double s = from + i * (to - from) / n_intervals, e = excess(s);
      const int now = std::abs(e) <= small_ ? 0 : e > 0. ? 1 : -1;
      if (now != 0 && sign == -now) {
        double low = last, high = s;
        for (unsigned int k = 0; k < 60; ++k) {
          const double middle = 0.5 * (low + high);
          (excess(middle) * now > 0. ? high : low) = middle;
        }
        cuts.push_back(0.5 * (low + high));
      }
      if (now != 0) {
        sign = now;
        last = s;
      }
    }
    cuts.push_back(to);
    if (sign == 0 || cuts.size() > 3)
      throw error_at(entry_, "the pairs ", name(a), " and ", name(b),
                     " lie over the same part of the side '", side(number).name(),
                     "', allowed: one partner for each part of a side.");
    const auto lose = [&](const bool a_loses, const double start, const double end) {
      if (a_loses)
        remove(a, start, end, number, b);
      else
        remove(b, start - shift, end - shift, number, a);
    };
    // The last sign is that of the last part; with a cut that of the first one is the other.
    lose(sign > 0, cuts[cuts.size() - 2], to);
    if (cuts.size() == 3)
      lose(sign < 0, from, cuts[1]);
  }
}

void Overlaps::find(const std::vector<bool> &seeks) {
  std::vector<ContactCondition<2>> &contacts = scene_.contacts;
  for (ContactCondition<2> &contact : contacts) {
    if (!contact.opposite)
      continue;
    const std::vector<FacingPart> parts =
      seen_parts(side(contact.side), side(*contact.opposite), grazing, scene_.geometry);
    if (parts.empty())
      continue;
    const FacingPart overlap = hull_of(side(contact.side), parts);
    contact.from = overlap.from;
    contact.to = overlap.to;
  }
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (contacts[i].opposite && contacts[j].opposite)
        for (const unsigned int number : {contacts[i].side, *contacts[i].opposite})
          if ((number == contacts[j].side || number == *contacts[j].opposite) &&
              !is_empty(contacts[i]) && !is_empty(contacts[j]))
            separate(contacts[j], contacts[i], number);
  for (std::size_t i = contacts.size(); i-- > 0;)
    if (seeks[i] && is_empty(contacts[i]))
      contacts.erase(contacts.begin() + i);
}

/** Returns the partners of a side: all sides of other bodies without another role that it sees.
 */
std::vector<unsigned int> partners_of(const unsigned int first, const Scene<2> &scene,
                                      const std::vector<SidePair> &pairs) {
  const Geometry<2> &geometry = scene.geometry;
  std::vector<unsigned int> partners;
  for (unsigned int second = 0; second < geometry.sides.size(); ++second) {
    if (geometry.body_of_side(second) == geometry.body_of_side(first))
      continue;
    const bool is_paired = std::any_of(pairs.begin(), pairs.end(),
                                       [second](const auto &pair) { return pair.has(second); }),
               is_known = std::any_of(pairs.begin(), pairs.end(), [&](const auto &pair) {
                 return pair.second && pair.has(first) && pair.has(second);
               });
    if (is_known || (scene.boundary[second].role != Role::free && !is_paired))
      continue;
    const std::vector<FacingPart> parts =
      seen_parts(geometry.sides[first], geometry.sides[second], facing, geometry);
    if (std::any_of(parts.begin(), parts.end(), [&](const FacingPart &part) {
          return part.distance > -small_overlap * geometry.diameter();
        }))
      partners.push_back(second);
  }
  return partners;
}

/** Returns the curvature of a side, positive where its body is convex (1/length); none of chains,
 * whose curvature varies. */
std::optional<double> curvature(const Side<2> &side) {
  if (side.is_flat())
    return 0.;
  if (!(side.radius() > 0.))
    return {};
  const Point<2> x = side.centre();
  return std::copysign(1. / side.radius(),
                       (x - side.centre_of_circle()) * side.normal(side.arc_length(x)));
}

/** Exchanges the sides of pairs in which the second one bulges more, or as much and is softer. The
 * points of a pair lie on the normals of its first side: numbers do not depend on which one is
 * named first. Flat sides, and sides in several pairs, stay as they are named. */
void order_sides(Scene<2> &scene) {
  constexpr double rounding = 1e-10;
  const auto n_contacts = [&](const unsigned int side) {
    return std::count_if(scene.contacts.begin(), scene.contacts.end(), [side](const auto &contact) {
      return contact.side == side || contact.opposite == side;
    });
  };
  for (const ContactPair<2> &pair : contact_pairs(scene)) {
    ContactCondition<2> &contact = scene.contacts[pair.number()];
    if (!contact.opposite || n_contacts(contact.side) > 1 || n_contacts(*contact.opposite) > 1)
      continue;
    const auto first = curvature(scene.geometry.sides[contact.side]),
               second = curvature(scene.geometry.sides[*contact.opposite]);
    if (!first || !second || (*first == 0. && *second == 0.))
      continue;
    const double difference = *second - *first,
                 small = rounding * std::max(std::abs(*first), std::abs(*second));
    if (difference > small || (difference > -small && pair.carrier() == *contact.opposite)) {
      std::swap(contact.side, *contact.opposite);
      contact.is_exchanged = true;
    }
  }
}
} // namespace

void add_pairs(const std::vector<SidePair> &pairs, const bool may_exchange, const Entry &entry,
               Scene<2> &scene) {
  std::vector<SidePair> named;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(named),
               [](const SidePair &pair) { return pair.second.has_value(); });
  const std::size_t n_named = named.size();
  for (const SidePair &pair : pairs) {
    if (pair.second)
      continue;
    const std::vector<unsigned int> partners = partners_of(pair.first, scene, named);
    if (partners.empty())
      throw error_at(entry, "found '", scene.geometry.sides[pair.first].name(),
                     " with *', but no side of another body that has no other role lies ahead of "
                     "it; allowed: a side that can meet one.");
    for (const unsigned int second : partners) {
      named.push_back({pair.first, second});
      scene.boundary[second].role = Role::contact;
    }
  }
  const std::size_t n_before = scene.contacts.size();
  for (const SidePair &pair : named) {
    scene.contacts.emplace_back().side = pair.first;
    scene.contacts.back().opposite = pair.second;
  }
  if (may_exchange)
    order_sides(scene);
  std::vector<std::pair<ContactCondition<2>, bool>> contacts;
  for (std::size_t i = 0; i < scene.contacts.size(); ++i)
    contacts.emplace_back(scene.contacts[i], i >= n_before + n_named);
  std::stable_sort(contacts.begin(), contacts.end(),
                   [](const auto &a, const auto &b) { return a.first.side < b.first.side; });
  scene.contacts.clear();
  std::vector<bool> seeks;
  for (const auto &[contact, is_found] : contacts) {
    scene.contacts.push_back(contact);
    seeks.push_back(is_found);
  }
  Overlaps(entry, scene).find(seeks);
  // Sides that '*' found behind others are free.
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    if (scene.boundary[i].role == Role::contact &&
        std::none_of(scene.contacts.begin(), scene.contacts.end(), [i](const auto &contact) {
          return contact.side == i || contact.opposite == i;
        }))
      scene.boundary[i].role = Role::free;
}
} // namespace Signorini
