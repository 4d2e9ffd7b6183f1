// The flow round a poppet valve that is open by 3.5 mm. Lengths in mm; the z axis is the valve's.
// gmsh valve.geo -2 -o valve.stl writes a closed surface whose solids bear the names below.
SetFactory("OpenCASCADE");

// Valve: half a section, turned round the z axis
Point(1) = {0, 0, -6};
Point(2) = {16.2, 0, -6};
Point(3) = {17, 0, -5.2};
Point(4) = {17, 0, -3.5};
Point(5) = {14, 0, -0.5};
Point(6) = {14, 0, 10.5};   // centre of the arc
Point(7) = {3, 0, 10.5};
Point(8) = {3, 0, 40};
Point(9) = {0, 0, 40};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Circle(5) = {5, 6, 7};
Line(6) = {7, 8};
Line(7) = {8, 9};
Line(8) = {9, 1};
Curve Loop(1) = {1:8};
Plane Surface(1) = {1};
valve[] = Extrude {{0, 0, 1}, {0, 0, 0}, 2*Pi} { Surface{1}; };

// Cylinder, a little beside the valve; seat, a cone of 45 degrees; throat
Cylinder(11) = {3, 0, -10.5, 0, 0, 10.5, 26.3};
Cone(12) = {0, 0, 0, 0, 0, 2.5, 17, 14.5};
Cylinder(13) = {0, 0, 2.5, 0, 0, 2.5, 14.5};

// Port: up from the throat, through a bend, and out along x
Cone(14) = {0, 0, 5, 0, 0, 1, 14.5, 11.5};
Disk(100) = {0, 0, 6, 11.5};
bend[] = Extrude {{0, 1, 0}, {13, 0, 6}, Pi/2} { Surface{100}; };
Cylinder(16) = {13, 0, 19, 21.5, 0, 0, 11.5};

fluid() = BooleanUnion{ Volume{11}; Delete; }{ Volume{12, 13, 14, bend[1], 16}; Delete; };
flow() = BooleanDifference{ Volume{fluid()}; Delete; }{ Volume{valve[1]}; Delete; };

Recursive Delete { Surface{1}; } // the half section

// Names: each box holds what it names, and what is taken away again
e = 0.01;
rest() = Surface In BoundingBox{-99, -99, -99, 99, 99, 99};
inlet() = Surface In BoundingBox{34.5 - e, -99, -99, 34.5 + e, 99, 99};
outlet() = Surface In BoundingBox{-99, -99, -10.5 - e, 99, 99, -10.5 + e};
seat() = Surface In BoundingBox{-17 - e, -17 - e, -e, 17 + e, 17 + e, 2.5 + e};
stem() = Surface In BoundingBox{-3 - e, -3 - e, 10.5 - e, 3 + e, 3 + e, 99};
port() = Surface In BoundingBox{-15, -15, 2.5 - e, 99, 99, 99};
port() -= {inlet(), stem()};
valve() = Surface In BoundingBox{-17 - e, -17 - e, -6 - e, 17 + e, 17 + e, 10.5 + e};
valve() -= {seat(), port()};
rest() -= {inlet(), outlet(), seat(), stem(), port(), valve()};
Physical Surface("inlet") = inlet();
Physical Surface("outlet") = outlet();
Physical Surface("seat") = seat();
Physical Surface("valve") = {valve(), stem()};
Physical Surface("port") = port();
Physical Surface("cylinder") = rest();

Mesh.Algorithm = 6; // frontal Delaunay
Mesh.CharacteristicLengthMin = 1;
Mesh.CharacteristicLengthMax = 1.325;
Mesh.ScalingFactor = 0.001; // mm to m
Mesh.StlOneSolidPerSurface = 2;
