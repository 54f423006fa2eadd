// The lower half of a disc of the radius 1.
//   gmsh -2 -order 2 half_disc.geo
SetFactory("OpenCASCADE");
Point(1) = {-1, 0, 0};
Point(2) = {0, 0, 0};
Point(3) = {1, 0, 0};
Point(4) = {0, -1, 0};
Circle(1) = {1, 2, 4};
Circle(2) = {4, 2, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Physical Curve("arc") = {1, 2};
Physical Curve("flat") = {3};
Physical Surface("disc") = {1};
Mesh.RecombineAll = 1;
Mesh.SubdivisionAlgorithm = 1;
Mesh.MeshSizeMax = 0.8;
