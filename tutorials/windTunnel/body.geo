// A simple car: a long box with a round nose and a back that slants by 25 degrees, on four stilts.
// Lengths in m; x goes downstream, z up, the ground is z = 0. The stilts go through the ground.
// gmsh body.geo -2 -o body.stl writes a closed surface.
SetFactory("OpenCASCADE");
length = 1.044;
width = 0.389;
height = 0.288;
clearance = 0.05;
nose = 0.1;   // radius
slant = 0.222;

Box(1) = {0, -width/2, clearance, length, width, height};
e = 0.001;
front() = Curve In BoundingBox{-e, -1, -1, e, 1, 1};
body() = Fillet{1}{front()}{nose};

// The wedge above the slant
drop = slant*Sin(25*Pi/180);
back = slant*Cos(25*Pi/180);
top = clearance + height;
Point(101) = {length - back, -1, top};
Point(102) = {length + back, -1, top - 2*drop};
Point(103) = {length + back, -1, top};
Line(101) = {101, 102};
Line(102) = {102, 103};
Line(103) = {103, 101};
Curve Loop(101) = {101:103};
Plane Surface(101) = {101};
wedge[] = Extrude {0, 2, 0} { Surface{101}; };
cut() = BooleanDifference{ Volume{body()}; Delete; }{ Volume{wedge[1]}; Delete; };

For i In {0:1}
  For j In {0:1}
    Cylinder(201 + 2*i + j) = {0.2 + 0.47*i, 0.3272*(j - 0.5), -0.05, 0, 0, 0.15, 0.015};
  EndFor
EndFor
car() = BooleanUnion{ Volume{cut()}; Delete; }{ Volume{201:204}; Delete; };
Physical Surface("car") = Surface{:};

Mesh.Algorithm = 6; // frontal Delaunay
Mesh.CharacteristicLengthMin = 0.005;
Mesh.CharacteristicLengthMax = 0.025;
Mesh.CharacteristicLengthFromCurvature = 1;
Mesh.StlOneSolidPerSurface = 2;
