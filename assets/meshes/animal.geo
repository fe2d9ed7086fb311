// A rounded animal: body, head with two ears, four legs and a tail. It stands on its feet, which are held; its nose is loaded.
SetFactory("OpenCASCADE");
DefineConstant[ fine = 0 ];
Sphere(1) = {0, 0, 0, 0.1};
Dilate {{0, 0, 0}, {1.7, 1, 0.9}} { Volume{1}; }
Sphere(2) = {0.19, 0.07, 0, 0.07};
Sphere(3) = {0.265, 0.055, 0, 0.03};
Sphere(4) = {0.17, 0.14, 0.045, 0.028};
Sphere(5) = {0.17, 0.14, -0.045, 0.028};
Cylinder(6) = {0.1, -0.17, 0.045, 0, 0.17, 0, 0.028};
Cylinder(7) = {0.1, -0.17, -0.045, 0, 0.17, 0, 0.028};
Cylinder(8) = {-0.1, -0.17, 0.045, 0, 0.17, 0, 0.028};
Cylinder(9) = {-0.1, -0.17, -0.045, 0, 0.17, 0, 0.028};
Sphere(10) = {-0.175, 0.03, 0, 0.03};
BooleanUnion(20) = { Volume{1}; Delete; }{ Volume{2 : 10}; Delete; };
Mesh.MeshSizeMax = fine ? 0.022 : 0.036;
Physical Volume("body") = {20};
Physical Surface("fixed") = Surface In BoundingBox {-1, -0.171, -1, 1, -0.169, 1};
Physical Surface("loaded") = Surface In BoundingBox {0.22, 0.02, -0.04, 0.3, 0.1, 0.04};
