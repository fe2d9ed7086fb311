// A square plate with a round hole, held along its lower edge and pulled along its upper one.
SetFactory("OpenCASCADE");
DefineConstant[ fine = 0 ];
half = 0.5; radius = 0.1;
Rectangle(1) = {-half, -half, 0, 2 * half, 2 * half};
Disk(2) = {0, 0, 0, radius};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Mesh.MeshSizeMax = fine ? 0.05 : 0.12;
Mesh.MeshSizeFromCurvature = fine ? 40 : 20;
Physical Surface("body") = {3};
Physical Curve("fixed") = Curve In BoundingBox {-1, -half - 0.001, -1, 1, -half + 0.001, 1};
Physical Curve("loaded") = Curve In BoundingBox {-1, half - 0.001, -1, 1, half + 0.001, 1};
Physical Curve("hole") = Curve In BoundingBox {-radius - 0.001, -radius - 0.001, -1, radius + 0.001, radius + 0.001, 1};
