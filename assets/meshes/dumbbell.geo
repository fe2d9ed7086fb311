// Two balls on a bar: the left one is held, the right one is loaded.
SetFactory("OpenCASCADE");
DefineConstant[ fine = 0 ];
apart = 0.3; ball = 0.08; bar = 0.025;
Sphere(1) = {0, 0, 0, ball};
Sphere(2) = {apart, 0, 0, ball};
Cylinder(3) = {0, 0, 0, apart, 0, 0, bar};
BooleanUnion(4) = { Volume{1}; Delete; }{ Volume{2, 3}; Delete; };
Mesh.MeshSizeMax = fine ? 0.02 : 0.036;
Physical Volume("body") = {4};
Physical Surface("fixed") = Surface In BoundingBox {-1, -1, -1, ball + 0.001, 1, 1};
Physical Surface("loaded") = Surface In BoundingBox {apart - ball - 0.001, -1, -1, 1, 1, 1};
