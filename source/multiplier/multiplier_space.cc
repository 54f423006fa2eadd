// SPDX-License-Identifier: LGPL-2.1-or-later
// Q^H, and G of (22).

#include <signorini/base/exceptions.h>
#include <signorini/multiplier/multiplier_space.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini
{
namespace
{
/** With fewer, a square root between two graded positions is not integrated to 1e-8. */
constexpr unsigned int fewest_graded_points = 8;

/** Inserts positions that approach both ends of every interval by factors of four. */
std::vector<double> grade(const std::vector<double> &cuts)
{
  constexpr unsigned int n_layers = 14;
  std::vector<double> graded = {cuts.front()};
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
  {
    const double length = cuts[i + 1] - cuts[i];
    for (unsigned int k = n_layers; k > 0; --k)
      graded.push_back(cuts[i] + 0.5 * length * std::pow(0.25, k));
    graded.push_back(cuts[i] + 0.5 * length);
    for (unsigned int k = 1; k <= n_layers; ++k)
      graded.push_back(cuts[i + 1] - 0.5 * length * std::pow(0.25, k));
    graded.push_back(cuts[i + 1]);
  }
  return graded;
}
} // namespace

template <int dim>
MultiplierSpace<dim>::MultiplierSpace(const Scene<dim> &scene,
                                      std::vector<ContactFace<dim>> faces,
                                      ContactPartition partition)
  : scene_(scene)
  , kinks_(scene.kinks)
  , faces_(std::move(faces))
  , partition_(std::move(partition))
{
}

template <int dim>
dealii::Vector<double> MultiplierSpace<dim>::lengths() const
{
  dealii::Vector<double> lengths(n_multipliers());
  for (unsigned int tau = 0; tau < n_multipliers(); ++tau)
    lengths[tau] = partition_.patches[tau].length();
  return lengths;
}

template <int dim>
typename MultiplierSpace<dim>::Rule MultiplierSpace<dim>::rule(const Piece &piece,
                                                               const unsigned int n_points,
                                                               const bool graded) const
{
  const Side<dim> &side = this->side(partition_.patches[piece.patch]);
  const double length = piece.end - piece.start;
  std::vector<double> cuts = kinks_.cut(side, piece.start, piece.end);
  // A singularity less than a length away is as bad as one inside.
  const bool near_kink = kinks_.touch(side, piece.start, piece.end) ||
                         kinks_.cut(side, piece.start - length, piece.end + length).size() > 2;
  const bool refined = graded && near_kink;
  if (refined)
    cuts = grade(cuts);
  const dealii::QGauss<1> gauss(refined ? std::max(n_points, fewest_graded_points) : n_points);
  const dealii::Quadrature<1> quadrature = split_quadrature(gauss, cuts);
  Rule rule;
  rule.weights = quadrature.get_weights();
  for (const dealii::Point<1> &s : quadrature.get_points())
  {
    rule.arc_lengths.push_back(s[0]);
    rule.points.push_back(side.point(s[0]));
  }
  return rule;
}

template <int dim>
dealii::Vector<double> assemble_gap(const MultiplierSpace<dim> &space, const unsigned int n_points)
{
  dealii::Vector<double> G(space.n_multipliers());
  for (const Piece &piece : space.partition().pieces)
  {
    const auto &condition = space.condition(space.partition().patches[piece.patch]);
    const auto rule = space.rule(piece, n_points);
    for (std::size_t q = 0; q < rule.points.size(); ++q)
    {
      const double g = condition.data->value(rule.points[q]);
      if (!std::isfinite(g))
      {
        std::ostringstream message;
        message << "the gap has the value " << g << " at (" << rule.points[q]
                << "), allowed: finite values on the whole side.";
        throw InputError(message.str());
      }
      G[piece.patch] += g * rule.weights[q];
    }
  }
  return G;
}

template class MultiplierSpace<2>;
template dealii::Vector<double> assemble_gap(const MultiplierSpace<2> &, unsigned int);
} // namespace Signorini
