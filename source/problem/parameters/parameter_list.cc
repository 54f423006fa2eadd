// SPDX-License-Identifier: LGPL-2.1-or-later
// Every parameter: its name, its default (from parameters.h), its unit, the values allowed, its
// use.

#include <signorini/base/text.h>

#include <limits>

#include "declarations.h"

namespace Signorini {
Declarations::Declarations(Parameters &parameters)
  : file_name_(parameters.file_name) {
  parameters.boundary.where = file_name_ + ": Boundary";
  declare_scene(parameters);
  declare_geometry(parameters.geometry);
  declare_material(parameters.material);
  declare_boundary(parameters.boundary);
  declare_load(parameters.load);
  declare_contact(parameters.contact);
  declare_load_cases(parameters.load_cases);
  declare_exact_solution(parameters.exact);
  declare_discretization(parameters.discretization);
  declare_solver(parameters.solver);
  declare_output(parameters.output);
  declare_verify(parameters.verify);
}

void Declarations::declare_scene(Parameters &parameters) {
  add("Dimension", parameters.dimension, "Of the body. A scene of the catalogue has its own.", 2U,
      3U, "2 or 3");
  add("Scene/Name", parameters.scene.name,
      "'described', or a scene of the catalogue (see --list-scenes), which then fixes everything "
      "from Geometry to Exact solution.");
  add("Constants/Values", parameters.constants.values,
      "Names for the expressions: E=1, nu=0.3 (separated by commas; pi is known).");
}

void Declarations::declare_material(MaterialParameters &material) {
  add("Material/Law", material.law, "Hooke's law.");
  add("Material/Young's modulus", material.youngs_modulus,
      "Expression in x, y (in 3-D x, y, z) (force/area), positive everywhere; for regions of a "
      "mesh file 'steel: 210000 | rubber: 5', as for all moduli.");
  add("Material/Poisson's ratio", material.poissons_ratio,
      "Expression in x, y (in 3-D x, y, z), between -1 and 0.5 (both excluded) everywhere.");
  add("Material/Hooke tensor", material.hooke_tensor,
      "General law: C11; C12; C13; C22; C23; C33 (force/area), expressions in Voigt's notation "
      "with the strains e11, e22, 2*e12. In 3-D the 21 entries C11; C12; ... C16; C22; ... C66 "
      "of the upper triangle, row by row, with the strains e11, e22, e33, 2*e23, 2*e13, 2*e12.");
  add("Material/Orthotropic moduli", material.orthotropic_moduli,
      "Orthotropic law: Q11; Q22; Q12; Q66 (force/area), expressions in the material's own axes.");
  add("Material/Orientation", material.orientation,
      "Degrees from the x-axis to the first axis of an orthotropic material.",
      std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max(), "a number");
  add("Material/Moduli across the plane", material.moduli_across,
      "Orthotropic law in plane strain: Q31; Q32 (force/area), sigma_zz = Q31*e11 + Q32*e22 in the "
      "material's own axes. General law: Z1; Z2; Z3, sigma_zz = Z1*e11 + Z2*e22 + Z3*2*e12. Only "
      "the stresses that are written need them. Empty: plane stress, sigma_zz = 0.");
  add("Material/Plane state", material.plane_state,
      "What the third direction does (isotropic law; the others are given for the plane). "
      "axisymmetric: a body of revolution about x = 0; forces are those on the whole "
      "circumference, and a side on the axis needs no entry.");
}

void Declarations::declare_boundary(BoundaryParameters &boundary) {
  add("Boundary/Clamped", boundary.clamped, "Sides that do not move: names separated by blanks.");
  add("Boundary/Rollers", boundary.rollers,
      "Sides with zero normal displacement and zero shear: names separated by blanks.");
  add(
    "Boundary/Contact", boundary.contact,
    "Sides that may touch the foundation: names separated by blanks; at least one. With several "
    "bodies, in the plane, pairs of sides that may touch each other, separated by '|' from each "
    "other and from sides on the foundation: block.bottom with base.top | base.bottom. A side may "
    "be in several pairs: table.top with foot.fillet0 foot.side0; '*' stands for all sides of "
    "other bodies that it sees and that have no other role: table.top with *. Gap, Friction "
    "coefficient "
    "and other data of one of several pairs on a side: table.top with foot.side0: 0.1 | ...");
  add("Boundary/Displacement", boundary.displacement,
      "Prescribed displacement (length) by side: top: 0; -0.1 | left: 0; 0. In 3-D three "
      "components: top: 0; 0; -0.1.");
  add("Boundary/Traction", boundary.traction,
      "Surface traction (force/area) by side: left: tx; ty | right: tx; ty; in 3-D tx; ty; tz. "
      "Sides without a role are free.");
  add("Boundary/Plates", boundary.plates,
      "Sides to which rigid plates are bonded, with the direction in which each travels, in 3-D "
      "three numbers: "
      "top: 0, -1 | right: 1, 0 turning. A plate that is turning may also rotate about its middle, "
      "on a hole about the centre.");
}

void Declarations::declare_load(LoadParameters &load) {
  add("Load/Body force", load.body_force,
      "Force per volume: fx; fy, in 3-D fx; fy; fz, expressions in x, y, z (force/volume); for "
      "bodies "
      "or regions of a mesh file 'upper: 0; -1 | lower: 0; 0'.");
  add("Load/Plate force", load.plate_force,
      "Force on a plate along its direction (force per thickness) by side: top: 35.");
  add(
    "Load/Plate cross force", load.plate_cross_force,
    "Force on a plate across its direction (force per thickness) by side, in the direction turned "
    "counter-clockwise by a right angle; in 3-D a vector fx, fy, fz at right angles to it. The "
    "plate "
    "may then move across, too.");
  add("Load/Plate moment", load.plate_moment,
      "Moment on a turning plate about its middle, on a hole about the centre, counter-clockwise "
      "(force x length per thickness) by side, in 3-D a vector mx, my, mz; zero where nothing is "
      "given.");
  add("Load/Plate travel", load.plate_travel,
      "Travel of a plate along its direction (length) by side, in the place of a force.");
}

void Declarations::declare_contact(ContactParameters &contact) {
  add("Contact/Gap", contact.gap,
      "Initial gap along the outward normal (length), an expression for all contact sides, or "
      "per side: bottom: ... | left: ...");
  add("Contact/Foundation", contact.foundation,
      "Rigid things in place of the gap, separated by '|': plane x,y normal nx,ny; circle x,y "
      "radius r; circle x,y radius r inside (the body lies in a round hole); parabola x,y normal "
      "nx,ny curvature k (with k < 0 it bends away from the body). In space: plane x,y,z normal "
      "a,b,c; sphere x,y,z radius r [inside]; cylinder x,y,z axis a,b,c radius r [inside]. Numbers "
      "may be formulas of the "
      "constants. Normals point towards the body and may have any length. 'bottom: circle ...' is "
      "for one contact side, others are for all that touch no other body. The gap is the distance "
      "along the direction of contact, at most ten diameters of the body.");
  add("Contact/Foundation position", contact.foundation_position,
      "dx, dy (in space dx, dy, dz) by which the whole foundation is moved (length).");
  add("Contact/Direction", contact.direction,
      "The direction along which planes of a Foundation act. foundation: their own normal, so that "
      "without friction a plane exerts no force along itself, whatever the shape of the body. "
      "body: the outward normal of the body, as everywhere else.");
  add(
    "Contact/Friction", contact.law,
    "Law of friction of the tangential traction q: none (q = 0), tresca (|q| <= Friction bound), "
    "coulomb (|q| <= Friction coefficient times the pressure). Bilinear or trilinear elements with "
    "at least two faces per patch and direction, or Strategy = hp.");
  add("Contact/Friction coefficient", contact.friction_coefficient,
      "Coulomb: f >= 0, an expression for all contact sides, or per side: bottom: ... | left: ...");
  add("Contact/Friction bound", contact.friction_bound,
      "Tresca: s >= 0 (force/area), an expression in the same way.");
  add("Contact/Foundation shift", contact.foundation_shift,
      "With friction: the motion of the foundation along the counter-clockwise tangent of the side "
      "(length), an expression in the same way; in 3-D a vector u1; u2; u3 whose tangential part "
      "counts; empty: 0.");
}

void Declarations::declare_load_cases(LoadCasesParameters &load_cases) {
  add("Load cases/Cases", load_cases.cases,
      "Other loads that the finest level is solved for, from the same factorisation: factors of "
      "force (tractions, plates), weight (body force), travel (prescribed displacements), gap and "
      "slide (Foundation shift), and shift x, shift y, shift z of the foundation (length): force "
      "0.5, weight "
      "2 | force 0 to 3 in 100 cases. What is not named keeps the factor 1 and the shift 0.");
  add("Load cases/Sequence", load_cases.sequence,
      "independent: every case begins with a body that has not slipped. steps: with friction, each "
      "case goes on from the slip of the one before, in their order, on every nested level.");
  add("Load cases/Fields", load_cases.fields,
      "Numbers of the cases for which VTU files are written, separated by blanks; the first is 1.");
}

void Declarations::declare_exact_solution(ExactSolutionParameters &exact) {
  add("Exact solution/Displacement", exact.displacement,
      "u1; u2, in 3-D u1; u2; u3, as expressions (length); turns the columns u_... on.");
  add("Exact solution/Displacement gradient", exact.displacement_gradient,
      "du1/dx; du1/dy; du2/dx; du2/dy, in 3-D all nine derivatives in this order; without it "
      "fourth-order differences are taken.");
  add("Exact solution/Pressure", exact.pressure,
      "p = sigma_n, negative in compression (force/area), an expression for all contact sides or "
      "per side; turns the columns p_... on.");
}

void Declarations::declare_discretization(DiscretizationParameters &discretization) {
  add("Discretization/Strategy", discretization.strategy,
      "automatic: hp, unless levels or an exact solution are given, or something else needs nested "
      "meshes; the run says which and why. nested: every cell is split from level to level, with "
      "patches of length H. hp: meshes are "
      "graded to ends of contact and other singularities, and the degree rises away from them; "
      "Finest level, Element, Patch ratio and Patches have no meaning then. One process.");
  add(
    "Discretization/Coarsest level", discretization.coarsest_level,
    "Refinements of the coarse mesh on the first level. Where none is given, hp begins with "
    "the first that has at least 24 cells, and pairs of bodies choose both levels by the number of "
    "cells.",
    0U, 14U);
  add("Discretization/Finest level", discretization.finest_level,
      "Refinements of the coarse mesh on the last level.", 0U, 14U);
  add("Discretization/Element", discretization.element,
      "Q1: bilinear displacement. Q1 B-bar: its dilatation is averaged over cells, which keeps the "
      "order for nearly incompressible bodies (Poisson's ratio near 0.5), where plain Q1 locks. "
      "Q2: biquadratic, stable with Patch ratio = 1.");
  add("Discretization/Patch ratio", discretization.patch_ratio,
      "H/h: faces per contact patch; where it does not divide the faces of a side, the last patch "
      "is the longer one.",
      1U, 16384U);
  add("Discretization/Patches", discretization.patches,
      "If positive: this many equal patches per contact side, aligned with nothing; or per side: "
      "bottom: 8 | left: 5. In a pair they divide the overlap.");
  add("Discretization/Target error", discretization.target_error,
      "If positive: stop refining when the relative error of u_h in the energy norm is below it: "
      "its guaranteed bound, or, where there is no bound, its estimate. Where none is given, hp "
      "aims at 1e-3.",
      0., 1.);
  add("Discretization/Maximum unknowns", discretization.maximum_unknowns,
      "hp: no mesh with more unknowns is solved.", 100U, 100000000U);
  add("Discretization/Maximum degree", discretization.maximum_degree,
      "hp: the highest degree of an element.", 2U, 12U);
  add("Discretization/Quadrature points", discretization.quadrature_points,
      "Gauss points per direction for loads; errors take one more. Meshes of at most 16384 cells "
      "take one more, of at most 1024 cells three more, of at most 64 cells six more.",
      1U, 16U);
  add("Discretization/Kinks at x", discretization.kinks_at_x,
      "Positions x where the data is not smooth (length): cells and patches crossed by one are "
      "integrated on the pieces.");
  add("Discretization/Kinks at y", discretization.kinks_at_y, "The same for positions y.");
}

void Declarations::declare_solver(SolverParameters &solver) {
  add("Solver/Contact solver", solver.contact_solver,
      "Method for contact. psor (projected SOR) and active set (primal-dual) solve the dual "
      "problem. multigrid forms none: every V-cycle is followed by a small problem on the contact "
      "sides (nested meshes, Linear solver = multigrid or automatic). automatic is multigrid on "
      "levels with 1e5 unknowns and more (in 3-D 5e3, on irregular meshes such as split triangles "
      "2e6), where nothing forbids it, else active set.");
  add("Solver/Relaxation", solver.relaxation, "Relaxation parameter omega of projected SOR.",
      std::numeric_limits<double>::min(), 2. - 1e-15, "a number between 0 and 2 (both excluded)");
  add("Solver/Tolerance", solver.tolerance, "On the relative KKT residual of the dual problem.",
      1e-15, 1e-2);
  add("Solver/Maximum iterations", solver.maximum_iterations,
      "Sweeps of projected SOR, steps of the active set, or V-cycles before giving "
      "up; a level that needs more is the last one, and is not certified.",
      1U, 2147483647U, "a positive integer");
  add("Solver/Linear solver", solver.linear_solver,
      "How systems with the stiffness matrix are solved. condensed (CHOLMOD, one process only) "
      "eliminates the contact unknowns last and reads the compliance C from the factor; "
      "amesos_mumps (on all processes) and amesos_klu (gathered on one) take one solve for every "
      "contact patch that can touch. multigrid (nested meshes) assembles and "
      "factorises nothing: conjugate gradients with V-cycles. automatic is multigrid where Contact "
      "solver is that, else condensed on one process and amesos_mumps on several.");
  add("Solver/Warm start", solver.warm_start,
      "Start a level from the pressure of the level before.");
  add(
    "Solver/Tolerated error", solver.tolerated_error,
    "Relative error in the energy norm up to which an answer is certified: the bound on the finest "
    "level, or its estimate where there is no bound, must not be larger.",
    0., 10.);
  add("Solver/Require stability", solver.require_stability,
      "Refuse patches of a single face (H = h), which are not inf-sup stable, instead of warning.");
}

void Declarations::declare_output(OutputParameters &output) {
  add("Output/Report", output.report,
      "Places separated by '|' for which the answer has the largest von Mises and principal "
      "stresses and displacement: the name of a side or of a region, 'SIDE from s to s' (arc "
      "lengths), 'x,y radius r', 'x,y box x,y', a point 'x,y', or a line 'x,y to x,y', along which "
      "line-N.csv has them. With 'guaranteed' behind a place in 2-D, not behind a point or a line, "
      "also mean stresses over it, or for a side the mean displacement and the force, with bounds "
      "of their errors that hold for certain.");
  add("Output/VTU", output.vtu, "Levels for which solution-LL.vtu and contact-LL.vtu are written.");
  add(
    "Output/Inf-sup constant", output.inf_sup_constant,
    "Whether the constant beta of Lemma 1 is measured (automatic: where the exact displacement is "
    "known, on nested meshes of up to 1e5 unknowns, in 3-D 5000; it needs its own factorisation).");
  add(
    "Output/Bound", output.bound,
    "Whether the guaranteed bound of the error is computed (automatic: in 2-D, on the finest mesh "
    "and where a run may end); without it the estimate decides.");
  add("Output/Compliance", output.compliance,
      "Write the dual problem and its solution as Matrix Market files: C, F, P, and A, D, f, G "
      "behind them.");
  add("Output/Errors", output.errors,
      "Compute the errors in the norms of the theorems where the exact solution is known; without "
      "them a run takes the time of its solution.");
  add(
    "Output/Lemmas", output.lemmas,
    "Fill the columns lemma_... and bound_...: the left-hand sides of Lemmas 2, 3, 5 and of (26), "
    "(27), (30), where the exact solution is known.");
  add(
    "Output/Pictures", output.pictures,
    "Draw the finest level with signorini-plot if Python's matplotlib is installed; that needs and "
    "writes the VTU files of this level.");
}

void Declarations::declare_verify(VerifyParameters &verify) {
  add("Verify/File", verify.file,
      "Displacement of another program on a plane mesh (.vtu): after the run its error is told and "
      "written. With Strategy = automatic meshes are graded then, and without a target they aim at "
      "1e-6. Looked for like Geometry/File.");
  add("Verify/Field", verify.field, "Name of the displacement among the point data of the file.");
  add("Verify/Factor", verify.factor, "Multiplies the displacement: 0.001 if it is in millimetres.",
      -1e30, 1e30);
  add("Verify/Tolerance", verify.tolerance,
      "Boundary points of the file this close to the body's boundary (share of its size) are moved "
      "onto it.",
      0., 0.1);
  add(
    "Verify/Tolerated error", verify.tolerated_error,
    "If positive: exit code 2 unless the relative error of the displacement in the energy norm is "
    "at most this.",
    0., 1e30);
}

void Declarations::declare_geometry(GeometryParameters &geometry) {
  add(
    "Geometry/Bodies", geometry.bodies,
    "Names of several bodies, separated by blanks. Every entry of Geometry may then have a value "
    "for each, 'upper: 1 | lower: 2', and so may moduli; a side is called upper.bottom. Bodies of "
    "one mesh file are its surfaces of these names. At most 500.");
  add("Geometry/Shape", geometry.shape,
      "Shape of the body. A rectangle has the sides left, right, bottom, top; a polygon side0, "
      "side1, ... in the order of its vertices; a half disc (the lower half) flat and arc, a disc "
      "arc, a ring inner and outer; a file those that are named in it. In 3-D: a box has left, "
      "right (x), front, back (y), bottom, top (z), a ball or a cylinder round, a tube inner and "
      "outer; their planes have the names of a box's sides.");
  add("Geometry/Lower left", geometry.lower_left,
      "Corner of the rectangle: x, y; of the box: x, y, z (length).");
  add("Geometry/Upper right", geometry.upper_right,
      "Opposite corner of the rectangle: x, y; of the box: x, y, z (length).");
  add("Geometry/Cells", geometry.cells,
      "Coarse cells per direction, of the rectangle: nx, ny; of the box: nx, ny, nz.");
  add(
    "Geometry/Vertices", geometry.vertices,
    "Polygon: x0,y0; x1,y1; ... (length). 'x,y fillet r' rounds the corner with a side of its own, "
    "fillet<number of the vertex>; between two vertices, 'arc cx,cy ccw' (or cw) makes an arc "
    "about (cx,cy) of the edge, 'arc radius r ccw' (or cw) one of at most 180 degrees, and 'arc "
    "through x,y' one through a third point. A convex polygon without arcs has one coarse cell if "
    "it has four "
    "vertices, otherwise one per vertex; all others are filled with triangles, which are split "
    "into quadrilaterals.");
  add("Geometry/Holes", geometry.holes,
      "Polygon: holes separated by '|', each 'circle cx,cy,r' or vertices as above (length). Their "
      "sides are hole0, hole1, ...");
  add(
    "Geometry/Mesh size", geometry.mesh_size,
    "Polygon, and shapes from files (.step, .geo, ...): longest edge of the elements that level 0 "
    "is made from (length); 0: as coarse as the shape allows, or a tenth of the diagonal of a "
    "file's shape.",
    0., 1e30);
  add("Geometry/Centre", geometry.centre,
      "Of a half disc, a disc or a ring: x, y; of a ball: x, y, z; of a cylinder or a tube: the "
      "middle of its end at the lower coordinate (length).");
  add("Geometry/Radius", geometry.radius, "Of a round body (length).", 1e-30, 1e30);
  add("Geometry/Inner radius", geometry.inner_radius, "Of a ring or a tube (length).", 1e-30, 1e30);
  add("Geometry/Length", geometry.length, "Of a cylinder or a tube, along its axis (length).",
      1e-30, 1e30);
  add("Geometry/Axis", geometry.axis, "Direction of the axis of a cylinder or a tube.");
  add("Geometry/Sector", geometry.sector,
      "Part of a ball, a cylinder or a tube between planes of symmetry through its centre: half is "
      "z < 0 (side top), quarter x > 0, too (left), octant, of a ball, y > 0 (front). Where the "
      "axis is in the way, the next one takes its place: half of a cylinder along z is x > 0, a "
      "quarter y > 0, too.");
  add("Geometry/File", geometry.file,
      "Coarse mesh or shape that Gmsh reads (.msh, .geo, .step, .brep, .unv, ...); all but text of "
      ".msh, version 2 or 4.1, goes through the program gmsh. Looked for in the folder of the "
      "parameter file, then in the working folder. Sides are the physical names of curves, in "
      "space of surfaces, or their numbers where none has a name; the others are the side rest.");
  add(
    "Geometry/Arcs", geometry.arcs,
    "Mesh file: sides that are circular arcs, so that refinement follows the circle through their "
    "nodes, which may lie beside it by 1e-4 of the radius and are moved onto it: names separated "
    "by "
    "blanks. Edges with a node in the middle need no entry.");
  add(
    "Geometry/Surfaces", geometry.surfaces,
    "Mesh file in space: the kind of surface of sides, as in 'hole: cylinder | ball: sphere | lid: "
    "plane | cone: faces'. Nodes may lie beside it by 1e-3 of the radius or of the plane's extent "
    "and are moved onto it, and a side that is not a plane is not divided where its faces turn. "
    "Sides without an entry are what their nodes lie on to 1e-6, or else faces as they are.");
  add("Geometry/Distortion", geometry.distortion,
      "Interior vertices of the coarsest level are moved at random by this share of h.", 0., 0.45);
  add("Geometry/Thickness", geometry.thickness,
      "Of a plane body (length): forces, moments, work and energies are those of it; plate forces "
      "and moments act on all of it.",
      1e-30, 1e30);
}
} // namespace Signorini
