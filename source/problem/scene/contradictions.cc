// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides that prescribe different displacements where they meet.

#include <signorini/base/text.h>
#include <signorini/problem/scene/contradictions.h>
#include <signorini/problem/scene/corners.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** The share of the prescribed displacements, and of the directions of plates and normals, below
 * which a difference is rounding. */
constexpr double rounding = 1e-6;

/** A point that two sides have in common. */
template <int dim>
struct Meeting
{
  dealii::Point<dim> x;
  std::array<unsigned int, 2> sides;
};

std::vector<Meeting<2>> meetings(const Geometry<2> &geometry)
{
  std::vector<Meeting<2>> found;
  for (const Corner &corner : corners(geometry))
    if (corner.sides[0] != corner.sides[1])
      found.push_back({corner.position, corner.sides});
  return found;
}

/** Returns points inside the common edges of a box. */
std::vector<Meeting<3>> meetings(const Geometry<3> &geometry)
{
  std::vector<Meeting<3>> found;
  const double close = 1e-8 * geometry.diameter();
  for (unsigned int i = 0; i < geometry.sides.size(); ++i)
    for (unsigned int j = 0; j < i; ++j)
      for (const double s : {1e-3, 0.13, 0.3, 0.5, 0.71, 0.9, 1. - 1e-3})
        for (const auto &[r, t] :
             {std::pair{s, 0.}, std::pair{s, 1.}, std::pair{0., s}, std::pair{1., s}})
        {
          const auto lengths = geometry.sides[i].lengths();
          const dealii::Point<3> x = geometry.sides[i].point({r * lengths[0], t * lengths[1]});
          if (x.distance(geometry.sides[j].point(geometry.sides[j].coordinates(x))) < close)
            found.push_back({x, {{i, j}}});
        }
  return found;
}

std::vector<dealii::Point<2>> samples(const Side<2> &side)
{
  std::vector<dealii::Point<2>> points;
  for (const double share : {0., 0.2, 0.37, 0.5, 0.71, 0.9, 1.})
    points.push_back(side.point(share * side.length()));
  return points;
}

std::vector<dealii::Point<3>> samples(const Side<3> &side)
{
  std::vector<dealii::Point<3>> points;
  for (const double r : {0., 0.2, 0.5, 0.71, 1.})
    for (const double s : {0., 0.2, 0.5, 0.71, 1.})
      points.push_back(side.point({r * side.lengths()[0], s * side.lengths()[1]}));
  return points;
}

template <int dim>
std::string text_of(const dealii::Tensor<1, dim> &vector)
{
  std::vector<std::string> numbers;
  for (unsigned int d = 0; d < dim; ++d)
    numbers.push_back(number_text(vector[d] + 0.)); // no -0
  return "(" + join(numbers) + ")";
}

/** Checks the points where two sides meet. */
template <int dim>
class MeetingJudge
{
public:
  using Vector = dealii::Tensor<1, dim>;

  explicit MeetingJudge(const Scene<dim> &scene)
    : scene_(scene)
    , size_(1e-14 * scene.geometry.diameter())
  {
    for (unsigned int i = 0; i < scene.boundary.size(); ++i)
      if (prescribes_all(i))
        for (const dealii::Point<dim> &x : samples(scene.geometry.sides[i]))
          size_ = std::max(size_, displacement(i, x).norm());
  }

  /** Returns why the second side contradicts the first one, or nothing. */
  std::string judge(const dealii::Point<dim> &x, const unsigned int i, const unsigned int j) const
  {
    if (!prescribes_all(i) || !(prescribes_all(j) || scene_.boundary[j].role == Role::roller))
      return "";
    for (const auto &[mover, holder] : {std::pair{i, j}, std::pair{j, i}})
      for (const auto &[motion, name] : motions(mover, x))
        if (restricted(motion, x, j).norm() > rounding * motion.norm())
          return "the plate " + name_of(mover) + " cannot " + name + ", because the side " +
                 name_of(holder) + " holds their common point " + text_of(x) +
                 ", allowed: plates whose neighbours let them move";
    const Vector a = displacement(i, x);
    const Vector b = prescribes_all(j) ? displacement(j, x) : Vector();
    if (restricted(a - b, x, j).norm() <= rounding * size_)
      return "";
    return "the side " + name_of(i) + " prescribes u = " + text_of(a) + " at " + text_of(x) +
           ", where the side " + name_of(j) + " prescribes " +
           (prescribes_all(j) ? "u = " + text_of(b) : "u.n = 0 with n = " + text_of(normal(j, x))) +
           ", and no displacement of finite energy jumps; allowed: values that agree where sides "
           "meet";
  }

private:
  std::string name_of(const unsigned int i) const
  {
    return "'" + scene_.geometry.sides[i].name() + "'";
  }
  /** Returns whether all components of u are prescribed, not u.n alone. */
  bool prescribes_all(const unsigned int i) const
  {
    return scene_.boundary[i].role == Role::clamped ||
           scene_.boundary[i].role == Role::displacement;
  }
  Vector normal(const unsigned int i, const dealii::Point<dim> &x) const
  {
    const Side<dim> &side = scene_.geometry.sides[i];
    return side.normal(side.coordinates(x));
  }
  /** Returns the given part of the displacement. */
  Vector displacement(const unsigned int i, const dealii::Point<dim> &x) const
  {
    Vector u;
    if (scene_.boundary[i].role == Role::displacement)
      for (unsigned int c = 0; c < dim; ++c)
        u[c] = scene_.boundary[i].data->value(x, c);
    return u;
  }
  /** Returns N u. */
  Vector restricted(const Vector &u, const dealii::Point<dim> &x, const unsigned int j) const
  {
    return prescribes_all(j) ? u : (u * normal(j, x)) * normal(j, x);
  }
  /** Returns the velocities at a point of the plate on this side that forces and moments drive. */
  std::vector<std::pair<Vector, std::string>> motions(const unsigned int side,
                                                      const dealii::Point<dim> &x) const
  {
    std::vector<std::pair<Vector, std::string>> found;
    if constexpr (dim == 2)
      for (const Plate &plate : scene_.plates)
        if (plate.side == side)
        {
          if (plate.is_pushed)
            found.emplace_back(plate.direction, "move along " + text_of(plate.direction));
          if (plate.turns)
            found.emplace_back(plate.displacement({0., 1.}, x), "turn");
        }
    return found;
  }
  const Scene<dim> &scene_;
  /** The largest prescribed displacement. */
  double size_;
};
} // namespace

template <int dim>
std::string find_contradiction(const Scene<dim> &scene)
{
  const MeetingJudge<dim> judge(scene);
  for (const auto &[x, sides] : meetings(scene.geometry))
    for (const auto &[i, j] : {std::pair{sides[0], sides[1]}, std::pair{sides[1], sides[0]}})
    {
      const std::string contradiction = judge.judge(x, i, j);
      if (!contradiction.empty())
        return contradiction;
    }
  return "";
}

template std::string find_contradiction(const Scene<2> &);
template std::string find_contradiction(const Scene<3> &);
} // namespace Signorini
