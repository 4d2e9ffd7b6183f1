#!/usr/bin/python3
# SPDX-FileCopyrightText: The polymesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the mesh of a case as a PNG, cut open along whole cells; hexahedra are
blue, all other shapes orange.

Needs python3-vtk9; without a screen run it as:  xvfb-run -a /usr/bin/python3 docs/picture.py CASE OUT.png
With --surface FILE (STL, also .gz) the surface is drawn on the left and the mesh on the right.
With --closeUp X Y Z SIZE, all as fractions of the mesh's box, a part of the cut is drawn on the right.
The tutorials' pictures are drawn by  docs/tutorialPictures FOLDER  from cases that have been run.
docs/flange.png is the flange tutorial, run in CASE=build/flange (./Allrun does), drawn by:
    xvfb-run -a /usr/bin/python3 docs/picture.py build/flange docs/flange.png --cut x --azimuth -50 \\
        --surface build/flange/constant/triSurface/flange.stl.gz --size 1400 600"""
import argparse
import gzip
import pathlib
import struct
import tempfile
import zlib

import numpy
import vtk
from vtk.util import numpy_support

STEEL, SKY, ORANGE, INK = (0.72, 0.75, 0.79), (0.80, 0.88, 0.96), (0.96, 0.68, 0.38), (0.15, 0.2, 0.3)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("case", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--surface", type=pathlib.Path, help="drawn on the left")
    parser.add_argument("--closeUp", type=float, nargs=4, metavar=("X", "Y", "Z", "SIZE"))
    parser.add_argument("--cut", choices=["x", "y", "z", "none"], default="y")
    parser.add_argument("--at", type=float, default=0.5, help="place of the cut, 0 to 1")
    parser.add_argument("--azimuth", type=float, default=30, help="[deg]")
    parser.add_argument("--elevation", type=float, default=25, help="[deg]")
    parser.add_argument("--zoom", type=float, default=1.6)
    parser.add_argument("--stacked", action="store_true", help="parts one above the other, not side by side")
    parser.add_argument("--size", type=int, nargs=2, default=[1400, 620], help="[pixel]")
    return parser.parse_args()


def readMesh(case):
    """The volume mesh of the case as a vtkUnstructuredGrid whose polyhedra stay whole."""
    with tempfile.NamedTemporaryFile(dir=case, suffix=".foam") as marker:
        reader = vtk.vtkOpenFOAMReader()
        reader.SetFileName(marker.name)
        reader.CreateCellToPointOff()
        reader.DecomposePolyhedraOff()
        reader.Update()
    return reader.GetOutput().GetBlock(0)


def readSurface(file):
    reader = vtk.vtkSTLReader()
    if file.suffix != ".gz":
        reader.SetFileName(str(file))
        reader.Update()
        return reader.GetOutput()
    with tempfile.NamedTemporaryFile(suffix=".stl") as plain:
        plain.write(gzip.open(file).read())
        plain.flush()
        reader.SetFileName(plain.name)
        reader.Update()
    return reader.GetOutput()


def cutOpen(grid, axis, at):
    """The cells on the far side of a plane across `axis`, whole."""
    if axis == "none":
        return grid
    low_high = grid.GetBounds()
    a = "xyz".index(axis)
    origin = [0.0, 0.0, 0.0]
    origin[a] = low_high[2 * a] + at * (low_high[2 * a + 1] - low_high[2 * a])
    plane = vtk.vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal([float(i == a) for i in range(3)])
    keep = vtk.vtkExtractGeometry()
    keep.SetInputData(grid)
    keep.SetImplicitFunction(plane)
    keep.ExtractInsideOff()
    keep.ExtractBoundaryCellsOff()
    keep.Update()
    return keep.GetOutput()


def markShapes(grid):
    """A cell array `other`: 0 for plain hexahedra, 1 for all others."""
    marks = vtk.vtkIntArray()
    marks.SetName("other")
    for cell in range(grid.GetNumberOfCells()):
        marks.InsertNextValue(int(grid.GetCellType(cell) not in (vtk.VTK_HEXAHEDRON, vtk.VTK_VOXEL)))
    grid.GetCellData().SetScalars(marks)


def meshActor(grid):
    markShapes(grid)
    skin = vtk.vtkDataSetSurfaceFilter()
    skin.SetInputData(grid)
    colours = vtk.vtkLookupTable()
    colours.SetNumberOfTableValues(2)
    colours.SetTableValue(0, *SKY, 1)
    colours.SetTableValue(1, *ORANGE, 1)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(skin.GetOutputPort())
    mapper.SetLookupTable(colours)
    mapper.SetScalarRange(0, 1)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(*INK)
    actor.GetProperty().SetLineWidth(1)
    actor.GetProperty().SetAmbient(0.35)
    actor.GetProperty().SetDiffuse(0.75)
    return actor


def surfaceActor(surface):
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SetFeatureAngle(30)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*STEEL)
    actor.GetProperty().SetSpecular(0.3)
    return actor


def aim(renderer, bounds, options):
    """Looks along +y from the front, turned by azimuth and elevation; z is up."""
    centre = [(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)]
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(centre)
    camera.SetPosition(centre[0], centre[1] - 1, centre[2])
    camera.SetViewUp(0, 0, 1)
    camera.Azimuth(options.azimuth)
    camera.Elevation(options.elevation)
    renderer.ResetCamera(bounds)
    camera.Zoom(options.zoom)


def writePng(file, image):
    """Writes an RGB image with at most 256 colours, a third of the bytes of one with all of them."""
    for bits in (4, 5):
        colours, indices = numpy.unique(image.reshape(-1, 3) >> bits, axis=0, return_inverse=True)
        if len(colours) <= 256:
            break
    palette = numpy.round(colours * (255 / (255 >> bits))).astype(numpy.uint8)
    height, width, _ = image.shape
    rows = numpy.zeros((height, width + 1), numpy.uint8)  # each begins with 0: no filter
    rows[:, 1:] = indices.reshape(height, width)

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"PLTE", palette.tobytes())
                     + chunk(b"IDAT", zlib.compress(rows.tobytes(), 9)) + chunk(b"IEND", b""))


def closeUpBounds(bounds, place):
    """The box round a place that is `place[3]` times as large as the longest side of the bounds."""
    sides = [bounds[2 * i + 1] - bounds[2 * i] for i in range(3)]
    half = place[3] * max(sides) / 2
    middle = [bounds[2 * i] + place[i] * sides[i] for i in range(3)]
    return [middle[i] + sign * half for i in range(3) for sign in (-1, 1)]


def viewport(place, count, isStacked):
    """The corners of a panel in the window, from 0 to 1: from the left, or from the top."""
    if isStacked:
        return 0, 1 - (place + 1) / count, 1, 1 - place / count
    return place / count, 0, (place + 1) / count, 1


def main():
    options = arguments()
    mesh = readMesh(options.case)
    bounds = mesh.GetBounds()
    cut = cutOpen(mesh, options.cut, options.at)
    panels = [(meshActor(cut), bounds)]
    if options.surface:
        panels.insert(0, (surfaceActor(readSurface(options.surface)), bounds))
    if options.closeUp:
        panels.append((meshActor(cut), closeUpBounds(bounds, options.closeUp)))
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*options.size)
    for place, (actor, seen) in enumerate(panels):
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(*viewport(place, len(panels), options.stacked))
        renderer.SetBackground(1, 1, 1)
        renderer.AddActor(actor)
        aim(renderer, seen, options)
        window.AddRenderer(renderer)
    window.Render()
    shot = vtk.vtkWindowToImageFilter()
    shot.SetInput(window)
    shot.Update()
    image = shot.GetOutput()
    width, height, _ = image.GetDimensions()
    values = numpy_support.vtk_to_numpy(image.GetPointData().GetScalars())
    writePng(options.out, values.reshape(height, width, 3)[::-1])


main()
