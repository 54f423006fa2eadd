// SPDX-License-Identifier: LGPL-2.1-or-later
// Gamma_c^H, nested in the mesh or aligned with nothing, and its common refinement with the faces.

#include <signorini/mesh/contact_partition.h>

#include <algorithm>

namespace Signorini
{
namespace
{
/** Calls @p visit(first, last) for the faces [first, last) of each side. */
template <int dim, typename Visitor>
void for_each_side(const std::vector<ContactFace<dim>> &faces, const Visitor &visit)
{
  std::size_t first = 0;
  while (first < faces.size())
  {
    std::size_t last = first;
    while (last < faces.size() && faces[last].side == faces[first].side)
      ++last;
    visit(first, last);
    first = last;
  }
}

/** All non-empty intersections of faces and patches; both are sorted by side and arc length. */
template <int dim>
std::vector<Piece> intersect(const std::vector<ContactFace<dim>> &faces,
                             const std::vector<Patch> &patches)
{
  std::vector<Piece> pieces;
  std::size_t f = 0;
  std::size_t t = 0;
  while (f < faces.size() && t < patches.size())
  {
    const ContactFace<dim> &face = faces[f];
    const Patch &patch = patches[t];
    if (face.side != patch.side)
    {
      face.side < patch.side ? ++f : ++t;
      continue;
    }
    // Ends that differ by rounding only are the same: no slivers.
    const double sliver = 1e-10 * (face.end - face.start);
    const double start = std::max(face.start, patch.start);
    const double end = std::min(face.end, patch.end);
    if (end - start > sliver)
      pieces.push_back({static_cast<unsigned int>(f), static_cast<unsigned int>(t), start, end});
    const bool face_ends = face.end <= patch.end + sliver;
    const bool patch_ends = patch.end <= face.end + sliver;
    f += face_ends ? 1 : 0;
    t += patch_ends ? 1 : 0;
  }
  return pieces;
}

template <int dim>
ContactPartition with_pieces(const std::vector<ContactFace<dim>> &faces, std::vector<Patch> patches)
{
  ContactPartition partition;
  partition.pieces = intersect(faces, patches);
  partition.patches = std::move(patches);
  return partition;
}
} // namespace

double ContactPartition::longest_patch() const
{
  double longest = 0.;
  for (const Patch &patch : patches)
    longest = std::max(longest, patch.length());
  return longest;
}

bool ContactPartition::has_unstable_patch() const
{
  // A patch with one piece only lies inside a single face: it sees no interior trace node.
  std::vector<unsigned int> n_pieces(patches.size(), 0);
  for (const Piece &piece : pieces)
    ++n_pieces[piece.patch];
  return std::any_of(n_pieces.begin(), n_pieces.end(), [](const unsigned int n) { return n < 2; });
}

template <int dim>
ContactPartition partition_by_ratio(const std::vector<ContactFace<dim>> &faces,
                                    const unsigned int ratio)
{
  std::vector<Patch> patches;
  for_each_side(faces, [&](const std::size_t first, const std::size_t last) {
    const std::size_t n = std::max<std::size_t>(1, (last - first) / ratio);
    for (std::size_t t = 0; t < n; ++t)
    {
      const std::size_t begin = first + t * ratio;
      const std::size_t end = t + 1 == n ? last : begin + ratio;
      patches.push_back({faces[begin].side, faces[begin].start, faces[end - 1].end});
    }
  });
  return with_pieces(faces, std::move(patches));
}

template <int dim>
ContactPartition partition_equally(const std::vector<ContactFace<dim>> &faces, const unsigned int n)
{
  std::vector<Patch> patches;
  for_each_side(faces, [&](const std::size_t first, const std::size_t last) {
    const double length = faces[last - 1].end;
    for (unsigned int t = 0; t < n; ++t)
      patches.push_back({faces[first].side, t * length / n, (t + 1) * length / n});
  });
  return with_pieces(faces, std::move(patches));
}

template ContactPartition partition_by_ratio(const std::vector<ContactFace<2>> &, unsigned int);
template ContactPartition partition_equally(const std::vector<ContactFace<2>> &, unsigned int);
} // namespace Signorini
