// SPDX-License-Identifier: LGPL-2.1-or-later
// Penetration where nothing presses, and gaps on patches that press.

#include <signorini/base/instantiate.h>
#include <signorini/base/parallel.h>
#include <signorini/discretization/space/paired_piece.h>
#include <signorini/error_control/estimate/contact_part.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace Signorini {
template <int dim>
double softer_modulus(const Scene<dim> &scene, const Point<dim> &x) {
  const SymmetricTensor<4, dim> E = scene.material->hooke(x);
  double pressing = 0., shearing = 0.;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j < dim; ++j)
      (i == j ? pressing : shearing) = std::max(i == j ? pressing : shearing, E[i][j][i][j]);
  return std::min(pressing, 4. * shearing);
}

namespace {
/** A part of Γ_c on which d has one sign. Where d < 0, only pressing parts count. */
struct Stretch {
  /** The number of the side, that of its corners before the stretch, and the arc length where it
   * begins; in 3-D the number of the patch. */
  unsigned int side_or_patch, corners;
  double from;
  bool penetrates;
  /** The measure of the part that counts, and the integrals of modulus d² and 2 p_H d over it. */
  double measure, square, work;

  bool continues(const Stretch &before) const {
    return side_or_patch == before.side_or_patch && corners == before.corners &&
           penetrates == before.penetrates;
  }
  void operator+=(const Stretch &next) {
    measure += next.measure;
    square += next.square;
    work += next.work;
  }
  template <typename Archive>
  void serialize(Archive &archive, const unsigned int /*version*/) {
    archive &side_or_patch &corners &from &penetrates &measure &square &work;
  }
  /** Returns the least of |||w|||² + 2 ∫ p_H (d - w_n). */
  template <int dim>
  double energy() const {
    if (measure == 0.)
      return 0.;
    const double lift = 0.25 * numbers::PI / std::pow(measure, 1. / (dim - 1)) * square;
    return penetrates ? lift : std::min(lift, work);
  }
};

/** Returns the modulus of a piece, in a pair that of both bodies in series. */
template <int dim>
double modulus_at(const Scene<dim> &scene, const ContactSurface<dim> &surface,
                  const Piece<dim> &piece) {
  const auto compliance = [&](const ContactFace<dim> &face) {
    return 1. / softer_modulus(scene, face.cell->center());
  };
  const ContactFace<dim> *const other = PairedPiece<dim>(surface, piece).other_face();
  return 1. /
         (compliance(surface.faces()[piece.face]) + (other != nullptr ? compliance(*other) : 0.));
}

/** Cuts pieces into stretches. */
template <int dim>
class StretchesOfPieces {
public:
  explicit StretchesOfPieces(const BodyInContact<dim> &body)
    : body_(body)
    , threshold_(pressing_threshold(body.P.normal()))
    , traces_(body.space) {
    // Coarse meshes, which miss contact, are sampled densely.
    const double per_piece = 20000. / std::max<std::size_t>(1, body.surface().faces().size());
    n_points_ = static_cast<unsigned int>(std::clamp(std::pow(per_piece, 1. / (dim - 1)), 3., 32.));
  }

  /** Returns those of a piece; in 3-D there is one for each sign. */
  std::vector<Stretch> operator()(const Piece<dim> &piece) {
    const ContactSurface<dim> &surface = body_.surface();
    const SurfaceRule<dim> rule = surface.rule(piece, n_points_);
    const std::vector<double> depths =
      PairedPiece<dim>(surface, piece).closing(body_, rule, traces_);
    const double modulus = modulus_at(body_.scene, surface, piece);
    unsigned int n_corners = 0;
    if constexpr (dim == 2) {
      const std::vector<double> &corners = surface.side(surface.patches()[piece.patch]).corners();
      n_corners =
        std::lower_bound(corners.begin(), corners.end(), rule.on_side[0][0]) - corners.begin();
    }
    std::vector<Stretch> stretches;
    for (std::size_t q = 0; q < rule.size(); ++q) {
      const double d = depths[q],
                   p = body_.multipliers.value(body_.P.normal(), piece.patch, rule.on_side[q]),
                   weight = d > 0. || p < threshold_ ? rule.weights[q] : 0.;
      const Stretch point = {dim == 2 ? surface.patches()[piece.patch].contact : piece.patch,
                             n_corners,
                             dim == 2 ? rule.on_side[q][0] : 0.,
                             d > 0.,
                             weight / body_.scene.geometry.circumference(rule.points[q]),
                             modulus * d * d * weight,
                             2. * p * d * weight};
      add(point, stretches);
    }
    return stretches;
  }

  /** Adds a stretch to the one that it continues: in 2-D the last one. */
  static void add(const Stretch &next, std::vector<Stretch> &stretches) {
    const std::size_t n = stretches.size(),
                      n_candidates = dim == 2 ? std::min<std::size_t>(n, 1) : n;
    const auto found = std::find_if(stretches.end() - n_candidates, stretches.end(),
                                    [&](const Stretch &before) { return next.continues(before); });
    if (found != stretches.end())
      *found += next;
    else
      stretches.push_back(next);
  }

private:
  const BodyInContact<dim> &body_;
  double threshold_;
  unsigned int n_points_;
  TraceValues<dim> traces_;
};
} // namespace

template <int dim>
double contact_part(const BodyInContact<dim> &body) {
  const ContactSurface<dim> &surface = body.surface();
  StretchesOfPieces<dim> cut(body);
  std::vector<Stretch> mine;
  for (const Piece<dim> &piece : surface.pieces())
    for (const Stretch &stretch : cut(piece))
      mine.push_back(stretch);
  std::vector<Stretch> all = collect(mine, surface.communicator());
  std::stable_sort(all.begin(), all.end(), [](const Stretch &a, const Stretch &b) {
    return std::tie(a.side_or_patch, a.from, a.penetrates) <
           std::tie(b.side_or_patch, b.from, b.penetrates);
  });
  // Neighbours with the same sign are one stretch.
  double energy = 0.;
  for (std::size_t first = 0, last = 0; first < all.size(); first = last) {
    Stretch &whole = all[first];
    for (last = first + 1; last < all.size() && all[last].continues(whole); ++last)
      whole += all[last];
    energy += whole.template energy<dim>();
  }
  return std::sqrt(energy);
}

INSTANTIATE_FUNCTION(softer_modulus);
INSTANTIATE_FUNCTION(contact_part);
} // namespace Signorini
