// The head of a small engine: a deck with a combustion chamber, two ports, bosses of four bolts and
// of a plug, ribs, and a rim. Lengths in mm; the deck's face is z = 0.
// gmsh engineHead.geo -2 -o engineHead.stl writes a closed surface; its solids bear the names below.
SetFactory("OpenCASCADE");

// Deck, and a rim round the oil space above it
Box(1) = {-32, -33.5, 0, 64, 67, 9};
Box(2) = {-32, -33.5, 9, 64, 67, 16};
Box(3) = {-29.4, -30.9, 9, 58.8, 61.8, 17};
rim() = BooleanDifference{ Volume{2}; Delete; }{ Volume{3}; Delete; };

// Bosses; ribs from the plug's to the rim, and between the bolts'
Cylinder(11) = {-24, -25, 0, 0, 0, 32, 6.5};
Cylinder(12) = {24, -25, 0, 0, 0, 32, 6.5};
Cylinder(13) = {-24, 25, 0, 0, 0, 32, 6.5};
Cylinder(14) = {24, 25, 0, 0, 0, 32, 6.5};
Cylinder(15) = {0, 0, 0, 0, 0, 35, 7.5};
Box(16) = {-1.2, -32, 8, 2.4, 64, 11};
Box(17) = {-24, -26.2, 8, 48, 2.4, 7.5};
Box(18) = {-24, 23.8, 8, 48, 2.4, 7.5};

// Tubes of the ports, above the deck's face
Cylinder(21) = {-8, 0, 4, -24, 0, 13, 9.5};
Cylinder(22) = {8, 0, 4, 24, 0, 13, 8.5};
Box(23) = {-50, -50, 1, 100, 100, 50};
tubes() = BooleanIntersection{ Volume{21, 22}; Delete; }{ Volume{23}; Delete; };
full() = BooleanUnion{ Volume{1}; Delete; }{ Volume{rim(), 11:18, tubes()}; Delete; };

// What is cut out: chamber, ports, holes for bolts and plug, passages for water
Sphere(31) = {0, 0, -21, 28};
Cylinder(32) = {-1.17, 0, 0.3, -40, 0, 21.667, 7};
Cylinder(33) = {1.17, 0, 0.3, 40, 0, 21.667, 6};
Cylinder(34) = {-24, -25, -1, 0, 0, 40, 3.5};
Cylinder(35) = {24, -25, -1, 0, 0, 40, 3.5};
Cylinder(36) = {-24, 25, -1, 0, 0, 40, 3.5};
Cylinder(37) = {24, 25, -1, 0, 0, 40, 3.5};
Cylinder(38) = {0, 0, -1, 0, 0, 40, 3};
Cylinder(39) = {-10, -27, -1, 0, 0, 20, 2};
Cylinder(40) = {10, -27, -1, 0, 0, 20, 2};
Cylinder(41) = {-10, 27, -1, 0, 0, 20, 2};
Cylinder(42) = {10, 27, -1, 0, 0, 20, 2};
head() = BooleanDifference{ Volume{full()}; Delete; }{ Volume{31:42}; Delete; };

// Names: each box holds what it names, and what is taken away again
e = 0.1;
outside() = Surface In BoundingBox{-99, -99, -99, 99, 99, 99};
deck() = Surface In BoundingBox{-99, -99, -e, 99, 99, e};
chamber() = Surface In BoundingBox{-20, -20, -1, 20, 20, 7};
chamber() -= deck();
plug() = Surface In BoundingBox{-3 - e, -3 - e, 5, 3 + e, 3 + e, 99};
intake() = Surface In BoundingBox{-99, -7 - e, -9, 3 + e, 7 + e, 99};
intake() -= plug();
exhaust() = Surface In BoundingBox{-3 - e, -6 - e, -9, 99, 6 + e, 99};
exhaust() -= plug();
bolts() = {};
water() = {};
For i In {-1:1:2}
  For j In {-1:1:2}
    bolts() += Surface In BoundingBox{24*i - 3.5 - e, 25*j - 3.5 - e, -e, 24*i + 3.5 + e, 25*j + 3.5 + e, 32 + e};
    water() += Surface In BoundingBox{10*i - 2 - e, 27*j - 2 - e, -e, 10*i + 2 + e, 27*j + 2 + e, 16};
  EndFor
EndFor
outside() -= {deck(), chamber(), plug(), intake(), exhaust(), bolts(), water()};
Physical Surface("deck") = deck();
Physical Surface("chamber") = chamber();
Physical Surface("intake") = intake();
Physical Surface("exhaust") = exhaust();
Physical Surface("plug") = plug();
Physical Surface("bolts") = bolts();
Physical Surface("water") = water();
Physical Surface("outside") = outside();

Mesh.Algorithm = 6; // frontal Delaunay
Mesh.CharacteristicLengthMin = 0.5;
Mesh.CharacteristicLengthMax = 1.58;
Mesh.ScalingFactor = 0.001; // mm to m
Mesh.StlOneSolidPerSurface = 2;
