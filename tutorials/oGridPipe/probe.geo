// A bent tube that enters a pipe from above and looks upstream, as a Pitot tube does; it sticks out
// of the pipe. Lengths in mm; the pipe has radius 50 and lies along x.
// gmsh probe.geo -2 -o probe.stl writes a closed surface.
SetFactory("OpenCASCADE");
r = 8;     // of the tube
bend = 20; // of its middle line
Disk(1) = {150, 0, 60, r};
down[] = Extrude {0, 0, bend - 60} { Surface{1}; };
curve[] = Extrude {{0, 1, 0}, {150 - bend, 0, bend}, Pi/2} { Surface{down[0]}; };
nose[] = Extrude {-30, 0, 0} { Surface{curve[0]}; };
Sphere(100) = {150 - bend - 30, 0, 0, r};
probe() = BooleanUnion{ Volume{down[1]}; Delete; }{ Volume{curve[1], nose[1], 100}; Delete; };
Recursive Delete { Surface{1}; }
Physical Surface("probe") = Surface{:};

Mesh.Algorithm = 6; // frontal Delaunay
Mesh.CharacteristicLengthMin = 1;
Mesh.CharacteristicLengthMax = 2;
Mesh.ScalingFactor = 0.001; // mm to m
Mesh.StlOneSolidPerSurface = 2;
