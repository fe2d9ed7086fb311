// A bracket: a plate with two screw holes, held at its back, and an arm on a rib that carries the load at its end. In metres.
SetFactory("OpenCASCADE");
DefineConstant[ fine = 0 ];
width = 0.06; height = 0.1; reach = 0.1; thick = 0.01; hole = 0.012;
Box(1) = {0, 0, 0, thick, height, width};                       // the plate
Box(2) = {0, height - thick, 0, reach, thick, width};           // the arm
Point(101) = {thick, 0.02, width / 2 - thick / 2}; Point(102) = {thick, height - thick, width / 2 - thick / 2};
Point(103) = {0.08, height - thick, width / 2 - thick / 2};
Line(101) = {101, 102}; Line(102) = {102, 103}; Line(103) = {103, 101};
Curve Loop(101) = {101, 102, 103}; Plane Surface(101) = {101};
rib() = Extrude {0, 0, thick} { Surface{101}; };                 // the rib below the arm
Cylinder(11) = {-thick, height / 3, width / 4 - 0.005, 3 * thick, 0, 0, hole / 2};
Cylinder(12) = {-thick, height / 3, 3 * width / 4 + 0.005, 3 * thick, 0, 0, hole / 2};
whole() = BooleanUnion{ Volume{1}; Delete; }{ Volume{2, rib(1)}; Delete; };
body() = BooleanDifference{ Volume{whole()}; Delete; }{ Volume{11, 12}; Delete; };
Mesh.MeshSizeMax = fine ? 0.006 : 0.01;
Physical Volume("body") = body();
Physical Surface("fixed") = Surface In BoundingBox {-0.001, -1, -1, 0.001, 1, 1};
Physical Surface("loaded") = Surface In BoundingBox {reach - 0.001, -1, -1, reach + 0.001, 1, 1};
