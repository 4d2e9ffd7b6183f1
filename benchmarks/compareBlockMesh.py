#!/usr/bin/python3
# SPDX-FileCopyrightText: The polymesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares blockInit with OpenFOAM's blockMesh on every blockMeshDict below a folder.

    benchmarks/compareBlockMesh.py [-bin build/release/bin] [-examples DIR] [-cache DIR] [PART ...]

Each dictionary is copied with its case into the cache, where OpenFOAM's mesh stays for the next
run. Two meshes are the same when their points agree to 1e-9 of the box and their faces, cells,
patches and zones agree, up to renumbering. PART limits the run to paths that contain it.
Exit status 0 when all accepted dictionaries give the same mesh or are refused by name, 1 else.
"""
import argparse
import collections
import gzip
import os
import re
import shutil
import subprocess
import sys

import numpy as np

EXAMPLES = "/usr/share/doc/openfoam-examples/examples"
BLOCK_MESH = "/usr/bin/blockMesh"
CONTROL = """FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }
application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;
writeControl timeStep; writeInterval 1; writeFormat ascii; writePrecision 17;
timeFormat general; timePrecision 6;
"""


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-bin", default="build/release/bin")
    parser.add_argument("-examples", default=EXAMPLES)
    parser.add_argument("-cache", default="/tmp/compareBlockMesh")
    parser.add_argument("parts", nargs="*")
    return parser.parse_args()


def dictionaries(root):
    """(case folder, dictionary inside the case), both relative; templates for m4 are left out."""
    for folder, _, files in sorted(os.walk(root)):
        for file in sorted(files):
            if re.fullmatch(r"blockMeshDict(\.gz)?", file):
                case = re.split(r"/(?:system|constant)(?:/|$)", folder)[0]
                yield (os.path.relpath(case, root),
                       os.path.relpath(os.path.join(folder, file.removesuffix(".gz")), case))


def copyOpened(source, target):
    """Copies a file, without its compression."""
    os.makedirs(os.path.dirname(target), exist_ok=True)
    if source.endswith(".gz"):
        with gzip.open(source) as packed, open(target.removesuffix(".gz"), "wb") as plain:
            shutil.copyfileobj(packed, plain)
    else:
        shutil.copyfile(source, target)


def makeCase(source, target, dictionary, examples):
    for part in ("system", "constant"):
        for folder, _, files in os.walk(os.path.join(source, part)):
            for file in files:
                path = os.path.join(folder, file)
                copyOpened(path, os.path.join(target, os.path.relpath(path, source)))
    shared = os.path.join(examples, "resources/geometry")  # what Allrun scripts copy
    with open(os.path.join(target, dictionary), errors="replace") as file:
        text = file.read()
    for file in os.scandir(shared) if os.path.isdir(shared) else []:
        if file.is_file() and file.name.removesuffix(".gz") in text:
            copyOpened(file.path, os.path.join(target, "constant/triSurface", file.name))
    os.makedirs(os.path.join(target, "system"), exist_ok=True)
    with open(os.path.join(target, "system/controlDict"), "w") as control:
        control.write(CONTROL)


def run(command, log):
    environment = dict(os.environ, WM_PROJECT_DIR="/usr/share/openfoam")
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace",
                              env=environment, timeout=600)
        status, text = done.returncode, done.stdout + done.stderr
    except subprocess.TimeoutExpired:
        status, text = 99, "timeout"
    with open(log, "w") as file:
        file.write(text)
    return status, text


def reference(source, case, dictionary, examples):
    """Runs OpenFOAM's blockMesh once; its mesh moves to `case`/reference. False when refused."""
    status = os.path.join(case, "reference.status")
    if not os.path.exists(status):
        shutil.rmtree(case, ignore_errors=True)
        makeCase(source, case, dictionary, examples)
        code, _ = run([BLOCK_MESH, "-case", case, "-dict", dictionary], case + "/log.blockMesh")
        mesh = os.path.join(case, "constant/polyMesh")
        made = code == 0 and os.path.exists(mesh + "/faces")
        if made:
            os.makedirs(case + "/reference")
            for file in ("points", "faces", "owner", "neighbour", "boundary", "cellZones"):
                if os.path.exists(os.path.join(mesh, file)):
                    os.rename(os.path.join(mesh, file), os.path.join(case, "reference", file))
        with open(status, "w") as file:
            file.write(f"{0 if made else 1}\n")
    with open(status) as file:
        return file.read().strip() == "0"


def body(folder, name):
    with open(os.path.join(folder, name)) as file:
        text = file.read()
    text = re.sub(r"//.*", "", re.sub(r"/\*.*?\*/", "", text, flags=re.S))
    return re.sub(r"FoamFile\s*\{.*?\}", "", text, count=1, flags=re.S)


def numbers(text, kind):
    """The numbers of a list, its length first."""
    repeated = re.fullmatch(r"\s*(\d+)\s*\{\s*(\S+?)\s*\}\s*", text)
    if repeated:
        return np.array([int(repeated[1])] + int(repeated[1]) * [kind(repeated[2])])
    return np.fromstring(text.replace("(", " ").replace(")", " "), dtype=kind, sep=" ")


class Mesh:
    def __init__(self, folder):
        self.points = numbers(body(folder, "points"), float)[1:].reshape(-1, 3)
        self.owner = numbers(body(folder, "owner"), int)[1:]
        self.neighbour = numbers(body(folder, "neighbour"), int)[1:]
        self.faces = self.readFaces(numbers(body(folder, "faces"), int))
        self.cellCount = int(max(self.owner.max(), self.neighbour.max(initial=0))) + 1
        self.patches = self.readPatches(body(folder, "boundary"))
        self.zones = self.readZones(folder)

    @staticmethod
    def readFaces(flat):
        """One row a face: its size and its points, short faces padded with -1."""
        count = flat[0]
        if len(flat) == 1 + 5 * count and (flat[1::5] == 4).all():
            return flat[1:].reshape(-1, 5)
        faces = np.full((count, 5), -1)
        at = 1
        for f in range(count):
            size = flat[at]
            faces[f, :size + 1] = flat[at:at + size + 1]
            at += size + 1
        return faces

    @staticmethod
    def readPatches(text):
        patches = []
        for name, inner in re.findall(r"(\S+)\s*\{([^}]*)\}", text[text.index("(") + 1:]):
            entries = dict(re.findall(r"(\w+)\s+(.*?)\s*;", inner, flags=re.S))
            entries = {k: re.sub(r"\s+", " ", re.sub(r"^(\d+)\(", "(", v)).replace("List<word> ", "")
                       for k, v in entries.items()}
            start = int(entries.pop("startFace"))
            count = int(entries.pop("nFaces"))
            # OpenFOAM adds groups and defaults of its own: what counts is compared
            kept = {key: entries[key] for key in ("type", "neighbourPatch") if key in entries}
            patches.append((name, start, count, kept))
        return patches

    @staticmethod
    def readZones(folder):
        if not os.path.exists(folder + "/cellZones"):
            return {}
        found = re.findall(r"(\S+)\s*\{\s*type\s+cellZone;\s*cellLabels\s+List<label>\s*(.*?);",
                           body(folder, "cellZones"), flags=re.S)
        zones = {}
        for name, text in found:
            zones[name] = sorted(int(x) for x in numbers(text, int)[1:])
        return zones


def matched(a, b, tolerance):
    """For each of the points b the point of a at the same place, or None."""
    if a.shape != b.shape:
        return None
    if len(a) == 0 or np.abs(a - b).max() <= tolerance:
        return np.arange(len(a))
    for shift in (0.0, 0.31, 0.62, 0.17, 0.83):
        keys = [np.floor(x / (1e3 * tolerance) + shift) for x in (a, b)]
        orders = [np.lexsort(k.T) for k in keys]
        if np.abs(a[orders[0]] - b[orders[1]]).max() <= tolerance:
            match = np.empty(len(a), dtype=int)
            match[orders[1]] = orders[0]
            return match
    return None


def centres(mesh):
    real = mesh.faces[:, 1:] >= 0
    middle = (mesh.points[mesh.faces[:, 1:]] * real[:, :, None]).sum(axis=1) / mesh.faces[:, :1]
    total = np.zeros((mesh.cellCount, 3))
    count = np.zeros(mesh.cellCount)
    for cells in (mesh.owner, mesh.neighbour):
        np.add.at(total, cells, middle[:len(cells)])
        np.add.at(count, cells, 1)
    return total / count[:, None]


def patchOf(mesh):
    patch = np.full(len(mesh.faces), -1)
    for number, (_, start, count, _) in enumerate(mesh.patches):
        patch[start:start + count] = number
    return patch


def faceKeys(mesh, pointMap, cellMap):
    """Rows (size, owner, neighbour or -1, patch or -1, points from the lowest on), sorted."""
    owner = cellMap[mesh.owner]
    other = np.full(len(owner), -1)
    other[:len(mesh.neighbour)] = cellMap[mesh.neighbour]
    patch = patchOf(mesh)
    rows = []
    for size in np.unique(mesh.faces[:, 0]):
        of = np.nonzero(mesh.faces[:, 0] == size)[0]
        points = pointMap[mesh.faces[of, 1:size + 1]]
        turned = (other[of] >= 0) & (other[of] < owner[of])
        points[turned] = points[turned][:, ::-1]
        order = (points.argmin(axis=1)[:, None] + np.arange(size)) % size
        points = np.take_along_axis(points, order, axis=1)
        points = np.pad(points, ((0, 0), (0, 4 - size)), constant_values=-1)
        cells = np.sort(np.stack([owner[of], other[of]], axis=1), axis=1)
        rows.append(np.column_stack([np.full(len(of), size), cells, patch[of], points]))
    rows = np.concatenate(rows)
    return rows[np.lexsort(rows.T[::-1])]


def difference(expected, found):
    """An empty text when the meshes are the same, else the first difference."""
    size = expected.points.max(axis=0) - expected.points.min(axis=0)
    tolerance = 1e-9 * float(np.linalg.norm(size))
    for what in ("points", "faces", "neighbour"):
        counts = [len(getattr(mesh, what)) for mesh in (expected, found)]
        if counts[0] != counts[1]:
            return f"{what}: {counts[1]} instead of {counts[0]}"
    if expected.cellCount != found.cellCount:
        return f"cells: {found.cellCount} instead of {expected.cellCount}"
    pointMap = matched(expected.points, found.points, tolerance)
    if pointMap is None:
        off = np.abs(expected.points - found.points).max()
        return f"points differ by up to {off / float(np.linalg.norm(size)):.3g} of the box"
    if (pointMap == np.arange(len(pointMap))).all():
        cellMap = np.arange(expected.cellCount)
    else:
        cellMap = matched(centres(expected), centres(found), 10 * tolerance)
        if cellMap is None:
            return "cells differ"
    if [(p[0], p[2], p[3]) for p in expected.patches] != [(p[0], p[2], p[3]) for p in found.patches]:
        return f"patches: {found.patches} instead of {expected.patches}"
    same = np.arange(max(len(expected.points), expected.cellCount))
    if not np.array_equal(faceKeys(expected, same, same), faceKeys(found, pointMap, cellMap)):
        return "faces differ"
    zones = {name: sorted(int(cellMap[c]) for c in cells) for name, cells in found.zones.items()}
    if expected.zones != zones:
        return f"zones: {sorted(zones)} instead of {sorted(expected.zones)}"
    return ""


def compare(case, dictionary, binaries):
    code, text = run([os.path.join(binaries, "blockInit"), "-case", case, "-dict",
                      os.path.join(case, dictionary), "-format", "ascii", "-quiet"],
                     case + "/log.blockInit")
    lines = text.strip().splitlines()
    if code == 2 and "not supported" in text:
        return "refused", lines[-1]
    if code != 0:
        return "failed", lines[-1] if lines else f"status {code}"
    text = difference(Mesh(case + "/reference"), Mesh(case + "/constant/polyMesh"))
    return ("different", text) if text else ("same", "")


def main():
    options = arguments()
    counts = collections.Counter()
    for case, dictionary in dictionaries(options.examples):
        name = os.path.join(case, dictionary)
        if options.parts and not any(part in name for part in options.parts):
            continue
        target = os.path.join(options.cache, name.replace("/", "__"))
        if reference(os.path.join(options.examples, case), target, dictionary, options.examples):
            verdict, text = compare(target, dictionary, options.bin)
        else:
            verdict, text = "not accepted", "by OpenFOAM's blockMesh"
        counts[verdict] += 1
        if verdict != "same" or options.parts:
            print(f"{verdict:12} {name}  {text}", flush=True)
    accepted = sum(counts.values()) - counts["not accepted"]
    print()
    for verdict in ("same", "refused", "different", "failed", "not accepted"):
        share = f"{100 * counts[verdict] / max(accepted, 1):6.1f} %" if verdict != "not accepted" else ""
        print(f"{verdict:14}{counts[verdict]:5} {share}")
    return 0 if counts["different"] + counts["failed"] == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
