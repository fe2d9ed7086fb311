// A flat gear of twelve teeth, held at its bore and loaded at the flank of one tooth.
SetFactory("OpenCASCADE");
DefineConstant[ fine = 0 ];
teeth = 12; root = 0.08; tip = 0.1; bore = 0.03;
For k In {0 : teeth - 1}
  a = 2 * Pi * k / teeth; quarter = 2 * Pi / teeth / 4;
  Point(4 * k + 1) = {root * Cos(a - 1.3 * quarter), root * Sin(a - 1.3 * quarter), 0};
  Point(4 * k + 2) = {tip * Cos(a - 0.6 * quarter), tip * Sin(a - 0.6 * quarter), 0};
  Point(4 * k + 3) = {tip * Cos(a + 0.6 * quarter), tip * Sin(a + 0.6 * quarter), 0};
  Point(4 * k + 4) = {root * Cos(a + 1.3 * quarter), root * Sin(a + 1.3 * quarter), 0};
EndFor
For k In {1 : 4 * teeth}
  Line(k) = {k, k % (4 * teeth) + 1};
EndFor
Curve Loop(1) = {1 : 4 * teeth};
Circle(1001) = {0, 0, 0, bore, 0, 2 * Pi};
Curve Loop(2) = {1001};
Plane Surface(1) = {1, 2};
Mesh.MeshSizeMax = fine ? 0.006 : 0.012;
Physical Surface("body") = {1};
Physical Curve("fixed") = {1001};
Physical Curve("loaded") = {1};
