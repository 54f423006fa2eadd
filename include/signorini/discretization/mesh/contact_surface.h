// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/mesh/mesh.h>
#include <signorini/problem/scene/scene.h>

#include <array>
#include <vector>

namespace Signorini
{
/** A face of the mesh on a contact side. */
template <int dim>
struct ContactFace
{
  typename dealii::Triangulation<dim>::active_cell_iterator cell;
  unsigned int face_no;
  /** Number of the side in the geometry. */
  unsigned int side;
};

/** tau, an element of Gamma_c^H: an interval of arc length in the plane, a group of faces in space.
 */
template <int dim>
struct Patch
{
  /** Number of the side in the geometry. */
  unsigned int side;
  /** Corners of the smallest box around it in the coordinates of the side (length). */
  dealii::Point<dim - 1> lower, upper;
  /** |tau| (length^{dim-1}). */
  double measure;

  dealii::Point<dim - 1> centre() const
  {
    return lower + 0.5 * (upper - lower);
  }
  double diameter() const
  {
    return lower.distance(upper);
  }
};

/** Points on a piece of Gamma_c, with what integrals over it need. */
template <int dim>
struct SurfaceRule
{
  /** In the reference coordinates of the face. */
  std::vector<dealii::Point<dim - 1>> on_face;
  /** In the coordinates of the side (length). */
  std::vector<dealii::Point<dim - 1>> on_side;
  /** In space. */
  std::vector<dealii::Point<dim>> points;
  /** Outward unit normals. */
  std::vector<dealii::Tensor<1, dim>> normals;
  /** Quadrature weights times surface element (length^{dim-1}). */
  std::vector<double> weights;

  std::size_t size() const
  {
    return points.size();
  }
};

/** face ∩ tau: traces of V^h are polynomials on it, and so are multipliers. */
template <int dim>
struct Piece
{
  /** Number of the contact face, and of the patch. */
  unsigned int face, patch;
  /** Corners of its box in the coordinates of the side, and the same points in the reference
   * coordinates of the face. */
  dealii::Point<dim - 1> lower, upper;
  dealii::Point<dim - 1> lower_on_face, upper_on_face;
  /** Gauss points on the face as the mesh has it. They integrate products of a trace of V^h, a
   * multiplier and, on parabolas, a component of the normal exactly. */
  SurfaceRule<dim> on_mesh;
};

/** How Gamma_c^H is made. */
struct Partition
{
  /** H/h: faces per patch and direction. Where it does not divide the faces of a side, the last
   * patch is the longer one. */
  unsigned int ratio = 2;
  /** If positive: this many equal patches per side, aligned with nothing. */
  unsigned int patches_per_side = 0;
};

/** The points on a face as the mesh has it. */
enum class FaceRule
{
  gauss,
  /** With the ends of the face: the nodes of its trace. */
  lobatto
};

/** Where a rule is refined. */
enum class Grading
{
  none,
  /** Geometrically towards kinks: for functions that are only continuous there. Pieces near a kink
   * have at least eight points on each part. */
  towards_kinks
};

/**
 * Gamma_c as everything that happens on it sees it: the contact faces of the mesh, the patches of
 * Gamma_c^H and the pieces face ∩ patch with their points. Integrals over Gamma_c are sums over
 * pieces and need nothing else of the geometry.
 *
 * Side after side; in the plane each side in the order of arc length.
 */
template <int dim>
class ContactSurface
{
public:
  /** Mesh and scene must outlive the object. @throws ComputationError in space for a partition that
   * is aligned with nothing. */
  ContactSurface(const Mesh<dim> &mesh, const Scene<dim> &scene, const Partition &partition);
  /** In the plane: every face is a patch. @param n_points on every piece, by the active cell to
   * which it belongs. */
  ContactSurface(const Mesh<dim> &mesh,
                 const Scene<dim> &scene,
                 const std::vector<unsigned int> &n_points,
                 FaceRule rule = FaceRule::gauss);

  const Scene<dim> &scene() const
  {
    return scene_;
  }
  const std::vector<ContactFace<dim>> &faces() const
  {
    return faces_;
  }
  const std::vector<Patch<dim>> &patches() const
  {
    return patches_;
  }
  const std::vector<Piece<dim>> &pieces() const
  {
    return pieces_;
  }
  const Side<dim> &side(const Patch<dim> &patch) const
  {
    return scene_.geometry.sides[patch.side];
  }
  /** Gap and exact pressure where the piece lies. */
  const BoundaryCondition<dim> &condition(const Piece<dim> &piece) const
  {
    return scene_.boundary[patches_[piece.patch].side];
  }

  /**
   * A rule on the side itself for functions that are given in space: @p n_points Gauss points per
   * direction on every part into which kinks cut the piece.
   */
  SurfaceRule<dim> rule(const Piece<dim> &piece,
                        unsigned int n_points,
                        Grading grading = Grading::none) const;

  /** The i-th of n equal parts of a piece, without its points on the mesh. In the plane. */
  Piece<dim> part(const Piece<dim> &piece, unsigned int i, unsigned int n) const;

  /** The points of the piece with the given positions between lower (0) and upper (1), without
   * weights. */
  SurfaceRule<dim> at(const Piece<dim> &piece,
                      const std::vector<dealii::Point<dim - 1>> &positions) const;

  /** H: the largest diameter of a patch (length). */
  double longest_patch() const;
  /** Whether a patch lies in a single face (H = h): it sees no interior node of the trace mesh, and
   * such partitions are not inf-sup stable. */
  bool has_unstable_patch() const;

private:
  /** Sorts the faces and makes patches and pieces. */
  void divide(const Partition &partition);
  /** Fills Piece::on_mesh with so many points, by active cell. */
  void place_points(const std::vector<unsigned int> &n_points, FaceRule rule);

  const Mesh<dim> &mesh_;
  const Scene<dim> &scene_;
  std::vector<ContactFace<dim>> faces_;
  std::vector<Patch<dim>> patches_;
  std::vector<Piece<dim>> pieces_;
};

/** The patches of one rectangular side in space, as a grid. */
struct PatchGrid
{
  /** Number of the side in the geometry. */
  unsigned int side = 0;
  /** In both coordinates of the side: where the patches begin, sorted, and the end of the last. */
  std::array<std::vector<double>, 2> ends;
  /** Numbers of the patches; that of column i and row j at i + n(0) j. */
  std::vector<unsigned int> patches;

  /** The number of patches along one coordinate. */
  unsigned int n(const unsigned int d) const
  {
    return ends[d].size() - 1;
  }
  unsigned int at(const unsigned int i, const unsigned int j) const
  {
    return patches[i + n(0) * j];
  }
  double length(const unsigned int d) const
  {
    return ends[d].back() - ends[d].front();
  }
  double middle(const unsigned int d, const unsigned int i) const
  {
    return 0.5 * (ends[d][i] + ends[d][i + 1]);
  }
};

/** One grid for each side, in the order of the patches; m log m operations for m patches. @throws
 * ComputationError where patches are no grid. */
std::vector<PatchGrid> patch_grids(const std::vector<Patch<3>> &patches);
} // namespace Signorini
