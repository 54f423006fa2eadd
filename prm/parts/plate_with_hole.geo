// A plate of 2 x 1 with a round hole of the radius 0.2 in the middle.
//   gmsh -2 -order 2 plate_with_hole.geo
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 2, 1};
Disk(2) = {1, 0.5, 0, 0.2};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Physical Curve("bottom") = {1};
Physical Curve("left") = {2};
Physical Curve("right") = {3};
Physical Curve("top") = {4};
Physical Curve("hole") = {5};
Physical Surface("plate") = {3};
Mesh.RecombineAll = 1;
Mesh.SubdivisionAlgorithm = 1;
Mesh.MeshSizeMax = 0.6;
