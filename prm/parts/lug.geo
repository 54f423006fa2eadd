SetFactory("OpenCASCADE");
Box(1) = {0, -15, 0, 60, 30, 10};
Cylinder(2) = {0, 0, 0, 0, 0, 10, 15};
BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(4) = {0, 0, 0, 0, 0, 10, 7};
BooleanDifference(5) = { Volume{3}; Delete; }{ Volume{4}; Delete; };
