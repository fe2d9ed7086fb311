// A hook of round wire: a straight shank that is held at its top, three quarters of a ring, and an end that carries the load.
SetFactory("OpenCASCADE");
DefineConstant[ fine = 0 ];
ring = 0.1; wire = 0.025; shank = 0.15;
Disk(1) = {ring, 0, 0, wire};
Rotate {{1, 0, 0}, {0, 0, 0}, Pi / 2} { Surface{1}; }
bent() = Extrude {{0, 0, 1}, {0, 0, 0}, -3 * Pi / 2} { Surface{1}; };
straight() = Extrude {0, shank, 0} { Surface{1}; };
BooleanUnion{ Volume{bent(1)}; Delete; }{ Volume{straight(1)}; Delete; }
Mesh.MeshSizeMax = fine ? 0.012 : 0.022;
all() = Volume{:};
Physical Volume("body") = all();
Physical Surface("fixed") = Surface In BoundingBox {ring - 2 * wire, shank - 0.001, -1, ring + 2 * wire, shank + 0.001, 1};
Physical Surface("loaded") = Surface In BoundingBox {-0.001, ring - 2 * wire, -1, 0.001, ring + 2 * wire, 1};
