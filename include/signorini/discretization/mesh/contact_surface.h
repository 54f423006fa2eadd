// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/mesh.h>
#include <signorini/problem/scene/scene.h>

#include <deal.II/grid/cell_id.h>

#include <array>
#include <optional>
#include <vector>

namespace Signorini {
/** A face of the mesh on a contact side. */
template <int dim>
struct ContactFace {
  /** The cell, if it is on this rank. */
  typename Triangulation<dim>::active_cell_iterator cell;
  unsigned int face_no;
  /** The number of the side in the geometry. */
  unsigned int side;
  std::array<Point<dim>, 1U << (dim - 1)> vertices;
  /** The identity of the cell, which all ranks know. */
  CellId identity = {};

  bool is_on_this_rank() const {
    return cell.state() == IteratorState::valid;
  }
};

/** A face of a cell of a coarser mesh, whose children are faces of this mesh. */
struct AncestralFace {
  CellId cell;
  unsigned int face_no = 0;
  FaceCorners corners;
};

/**
 * A patch τ, an element of Γ_c^H: an interval of arc length in 2-D, in space a face of a coarser
 * mesh. Its coordinates are the arc length, or the reference coordinates of that face.
 */
template <int dim>
struct Patch {
  /** The number of the contact in Scene::contacts, and that of its side in the geometry. */
  unsigned int contact, side;
  /** The ends of the interval (length), or the corners of the unit square. */
  Point<dim - 1> lower, upper;
  /** The measure |τ| (length^{dim-1}). */
  double measure;
  /** Whether contact acts along several directions on it, one on each piece. */
  bool mixes = false;
  /** The share of a face of the carrier that lies in the patch, where patches are such faces. */
  double share = 1.;
  /** In space only. */
  AncestralFace face = {};

  Point<dim - 1> centre() const {
    return lower + 0.5 * (upper - lower);
  }
  /** Returns the length, or the longer diagonal (length). */
  double diameter() const;
};

/** The patches of one contact as a grid: in 2-D intervals of arc length in one row, in space rows
 * and columns along the edges of a side that is a rectangle. */
struct PatchGrid {
  /** The number of the contact in Scene::contacts, and that of its side in the geometry. */
  unsigned int contact = 0, side = 0;
  /** The beginnings of the patches, sorted, and the end of the last one, in both directions. */
  std::array<std::vector<double>, 2> ends = {{{}, {0., 1.}}};
  /** The numbers of the patches; that of column i and row j at i + n(0) j. */
  std::vector<unsigned int> patches;

  /** Returns the number of patches along one coordinate. */
  unsigned int n(const unsigned int d) const {
    return ends[d].size() - 1;
  }
  unsigned int at(const unsigned int i, const unsigned int j) const {
    return patches[i + n(0) * j];
  }
  double length(const unsigned int d) const {
    return ends[d].back() - ends[d].front();
  }
  double middle(const unsigned int d, const unsigned int i) const {
    return 0.5 * (ends[d][i] + ends[d][i + 1]);
  }
};

/** A patch next to another one, and its interval in the coordinate of the first one in which it
 * follows; around a closed side as if the side went on. */
struct Neighbour {
  unsigned int patch;
  double lower, upper;

  double middle() const {
    return 0.5 * (lower + upper);
  }
};

/** The patches before and after a patch in each coordinate; empty where its side ends, or has a
 * corner. */
template <int dim>
using Neighbours = std::array<std::array<std::optional<Neighbour>, 2>, dim - 1>;

/** The points on a piece of Γ_c, with the data for integrals over it. */
template <int dim>
struct SurfaceRule {
  /** The points in the reference coordinates of the face. */
  std::vector<Point<dim - 1>> on_face;
  /** The points in the coordinates of the patch: on the side (length), or on a face. */
  std::vector<Point<dim - 1>> on_side;
  /** The points themselves. */
  std::vector<Point<dim>> points;
  /** The outward unit normals. */
  std::vector<Tensor<1, dim>> normals;
  /** The directions m of contact, mostly the normals: u.m <= g, and p m is the traction. */
  std::vector<Tensor<1, dim>> directions;
  /** The quadrature weights times the surface element (length^{dim-1}). */
  std::vector<double> weights;
  /** In a pair: the points along the normals, in the reference coordinates of the face of the other
   * body. */
  std::vector<Point<dim - 1>> on_opposite;

  std::size_t size() const {
    return points.size();
  }
};

/** A face as an interval of arc length of its side. */
struct FaceSpan {
  double start, end;
  /** Whether the face's own parameter runs against the arc length. */
  bool reversed;

  /** Returns the face's own parameter of the point at arc length @p s, between 0 and 1; exactly
   * these at the ends. */
  Point<1> parameter(double s) const;
};

/** A piece face ∩ τ, in a pair of bodies face ∩ face ∩ τ: traces of V^h are polynomials on it, and
 * so are multipliers. It lies in one part of ContactDirections. */
template <int dim>
struct Piece {
  /** The numbers of the contact face and of the patch. */
  unsigned int face, patch;
  /** The corners of the box of the piece in the coordinates of the patch, and the same points in
   * the reference coordinates of the face. */
  Point<dim - 1> lower, upper;
  Point<dim - 1> lower_on_face, upper_on_face;
  /** The Gauss points on the face of the mesh. They integrate products of a trace of V^h, a
   * multiplier and, on parabolas, a component of the normal exactly. */
  SurfaceRule<dim> on_mesh;
  /** In a pair: the number of the face of the other body, and its interval. */
  std::optional<std::pair<unsigned int, FaceSpan>> opposite = {};
};

/** A face at a piece, and its part of the closing u.n: u of the body itself, -u of the other
 * one. */
template <int dim>
struct FaceOfPiece {
  const ContactFace<dim> &face;
  const std::vector<Point<dim - 1>> &points;
  double sign;
};

/** The rule by which Γ_c^H is made. */
struct Partition {
  /** The ratio H/h: faces per patch and direction. In 2-D the last patch is the longer one where it
   * does not divide the faces of a side; in space it is a power of two. */
  unsigned int ratio = 2;
  /** The number of equal patches by contact, aligned with nothing, where it is positive. */
  std::vector<unsigned int> patches_by_contact = {};
  /** Whether patches are the faces of the carrier (ContactPair::carrier()) instead, cut at the ends
   * of the overlap. */
  bool by_carrier = false;
};

/** The refinement of a rule. */
enum class Grading {
  none,
  /** The rule is refined geometrically towards kinks, for functions that are only continuous there.
   * Pieces near a kink have at least eight points on each part. */
  towards_kinks
};

/**
 * The discrete Γ_c: the contact faces of the mesh, the patches of Γ_c^H and the pieces face
 * ∩ patch with their points. Integrals over Γ_c are sums over pieces and need nothing else of
 * the geometry.
 *
 * The order is contact after contact; in 2-D each in the order of arc length. Every rank knows all
 * faces and patches; the pieces are those of its own cells.
 */
template <int dim>
class ContactSurface {
public:
  /**
   * Divides the contact sides by a partition. Mesh and scene must outlive the object.
   * @throws ComputationError in space for a partition by other ratios, and where the mesh is too
   * coarse for it.
   */
  ContactSurface(const Mesh<dim> &mesh, const Scene<dim> &scene, const Partition &partition);
  /**
   * Makes every face of the carrier a patch. For 2-D only.
   * @param n_points on every piece, by active cell; of two bodies the larger number counts.
   */
  ContactSurface(const Mesh<dim> &mesh, const Scene<dim> &scene,
                 const std::vector<unsigned int> &n_points);

  const Scene<dim> &scene() const {
    return scene_;
  }
  const std::vector<ContactFace<dim>> &faces() const {
    return faces_;
  }
  const std::vector<Patch<dim>> &patches() const {
    return patches_;
  }
  const std::vector<Piece<dim>> &pieces() const {
    return pieces_;
  }
  const Side<dim> &side(const Patch<dim> &patch) const {
    return scene_.geometry.sides[patch.side];
  }
  /** Returns the point of a side with the coordinates @p s of a patch. */
  Point<dim> point(const Patch<dim> &patch, const Point<dim - 1> &s) const;
  /** Returns the point in the middle of a patch, and the outward normal. */
  SurfacePoint<dim> middle(const Patch<dim> &patch) const;
  /** Returns the contact to which a piece belongs. */
  const ContactCondition<dim> &condition(const Piece<dim> &piece) const {
    return scene_.contacts[patches_[piece.patch].contact];
  }

  /** Returns the face of a piece with the points of a rule, and in a pair that of the other body.
   */
  std::vector<FaceOfPiece<dim>> faces_at(const Piece<dim> &piece,
                                         const SurfaceRule<dim> &rule) const {
    std::vector<FaceOfPiece<dim>> found = {{faces_[piece.face], rule.on_face, 1.}};
    if (piece.opposite)
      found.push_back({faces_[piece.opposite->first], rule.on_opposite, -1.});
    return found;
  }

  /** Returns the face of the carrier at a piece. */
  const ContactFace<dim> &face_of_carrier(const Piece<dim> &piece) const;

  /** Returns a rule on the side itself for functions of the position: @p n_points Gauss points per
   * direction on every part into which kinks cut the piece. */
  SurfaceRule<dim> rule(const Piece<dim> &piece, unsigned int n_points,
                        Grading grading = Grading::none) const;

  /** Returns the i-th of n equal parts of a piece, without its points on the mesh. For 2-D only. */
  Piece<dim> part(const Piece<dim> &piece, unsigned int i, unsigned int n) const;

  /** Returns the points of the piece with the given positions between lower (0) and upper (1),
   * without weights. */
  SurfaceRule<dim> at(const Piece<dim> &piece, const std::vector<Point<dim - 1>> &positions) const;

  /** Returns the neighbours of all patches. */
  std::vector<Neighbours<dim>> neighbours() const;

  /** Returns H: the largest diameter of a patch (length). */
  double longest_patch() const;
  /** Returns whether a patch lies in a single face (H = h), in a pair of either body: it contains
   * no interior node of the trace mesh, and such partitions are not inf-sup stable. */
  bool has_unstable_patch() const {
    return has_unstable_patch_;
  }
  /** Returns the ranks that share the mesh: integrals over Γ_c are sums over their pieces. */
  MPI_Comm communicator() const {
    return mesh_.communicator();
  }

private:
  /** Sorts the faces and makes patches and pieces. */
  void divide(const Partition &partition);
  /** Sets has_unstable_patch_, and keeps the pieces of this rank only. */
  void keep_own_pieces();
  /** Fills SurfaceRule::on_side. */
  void set_coordinates(const Piece<dim> &piece, SurfaceRule<dim> &rule) const;
  /** Fills SurfaceRule::directions and on_opposite. */
  void complete(const Piece<dim> &piece, SurfaceRule<dim> &rule) const;
  /** Fills Piece::on_mesh with the given numbers of points, by active cell. */
  void place_points(const std::vector<unsigned int> &n_points);

  const Mesh<dim> &mesh_;
  const Scene<dim> &scene_;
  std::vector<ContactFace<dim>> faces_;
  std::vector<Patch<dim>> patches_;
  std::vector<Piece<dim>> pieces_;
  bool has_unstable_patch_;
};

/** Returns one grid for each contact, in the order of the patches; m log m operations for m
 * patches. */
std::vector<PatchGrid> patch_grids(const std::vector<Patch<2>> &patches);
/** Returns the same for the patches of a surface. @throws ComputationError where they are no grid
 * on a rectangle. */
std::vector<PatchGrid> patch_grids(const ContactSurface<2> &surface);
std::vector<PatchGrid> patch_grids(const ContactSurface<3> &surface);
} // namespace Signorini
