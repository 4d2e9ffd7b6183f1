#!/usr/bin/python3
# SPDX-FileCopyrightText: The polymesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the mesh of a case as a PNG, cut open along whole cells; hexahedra are
blue, all other shapes orange.

Needs python3-vtk9; without a screen run it as:  xvfb-run -a /usr/bin/python3 docs/picture.py CASE OUT.png
With --surface FILE (STL, also .gz) the surface is drawn on the left and the mesh on the right.
docs/flange.png is the flange tutorial, run in CASE=build/flange (./Allrun does), drawn by:
    xvfb-run -a /usr/bin/python3 docs/picture.py build/flange docs/flange.png --cut x --azimuth -50 \\
        --surface build/flange/constant/triSurface/flange.stl.gz --size 1400 600"""
import argparse
import gzip
import pathlib
import tempfile

import vtk

STEEL, SKY, ORANGE, INK = (0.72, 0.75, 0.79), (0.80, 0.88, 0.96), (0.96, 0.68, 0.38), (0.15, 0.2, 0.3)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("case", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--surface", type=pathlib.Path, help="drawn on the left")
    parser.add_argument("--cut", choices=["x", "y", "z", "none"], default="y")
    parser.add_argument("--at", type=float, default=0.5, help="place of the cut, 0 to 1")
    parser.add_argument("--azimuth", type=float, default=30, help="[deg]")
    parser.add_argument("--elevation", type=float, default=25, help="[deg]")
    parser.add_argument("--zoom", type=float, default=1.6)
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


def main():
    options = arguments()
    mesh = readMesh(options.case)
    bounds = mesh.GetBounds()
    actors = [meshActor(cutOpen(mesh, options.cut, options.at))]
    if options.surface:
        actors.insert(0, surfaceActor(readSurface(options.surface)))
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*options.size)
    for place, actor in enumerate(actors):
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(place / len(actors), 0, (place + 1) / len(actors), 1)
        renderer.SetBackground(1, 1, 1)
        renderer.AddActor(actor)
        aim(renderer, bounds, options)
        window.AddRenderer(renderer)
    window.Render()
    shot = vtk.vtkWindowToImageFilter()
    shot.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(options.out))
    writer.SetInputConnection(shot.GetOutputPort())
    writer.Write()


main()
