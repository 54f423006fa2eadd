// A bracket: a foot of 80 x 20 mm and an upright of 20 x 80 mm, with a fillet of 20 mm between them.
//   gmsh -2 -order 2 bracket.geo
SetFactory("OpenCASCADE");
Point(1) = {0, 0, 0};
Point(2) = {80, 0, 0};
Point(3) = {80, 20, 0};
Point(4) = {40, 20, 0};
Point(5) = {40, 40, 0};
Point(6) = {20, 40, 0};
Point(7) = {20, 80, 0};
Point(8) = {0, 80, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Circle(4) = {4, 5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Line(7) = {8, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7};
Plane Surface(1) = {1};
Physical Curve("foot") = {1};
Physical Curve("tip") = {2};
Physical Curve("top") = {6};
Physical Curve("back") = {7};
Physical Curve("fillet") = {4};
Physical Surface("steel") = {1};
Mesh.RecombineAll = 1;
Mesh.SubdivisionAlgorithm = 1;
Mesh.MeshSizeMax = 20;
