// A beam along x, held at its left end and loaded at its right one.
SetFactory("OpenCASCADE");
DefineConstant[ fine = 0 ];
length = 1; thickness = 0.2;
Box(1) = {0, 0, 0, length, thickness, thickness};
Mesh.MeshSizeMax = fine ? 0.05 : 0.1;
Physical Volume("body") = {1};
Physical Surface("fixed") = Surface In BoundingBox {-0.001, -1, -1, 0.001, 1, 1};
Physical Surface("loaded") = Surface In BoundingBox {length - 0.001, -1, -1, length + 0.001, 1, 1};
