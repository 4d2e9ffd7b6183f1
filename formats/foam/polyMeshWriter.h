// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/boundaryFile.h"
#include "formats/foam/listWriter.h"
#include "formats/foam/replaceDirectory.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace polymesh::foam {

/// How many of what a mesh has.
struct MeshCounts {
    Label points = 0;
    Label cells = 0;
    Label faces = 0;
    Label internalFaces = 0;
};

/// Writes a polyMesh file by file, so that a mesh larger than the memory can be written from
/// functions that compute its blocks. All files are needed except zones; nothing changes under the
/// directory's name before commit(), and an object that dies without it leaves no trace.
/// The functions may run at the same time; all throw WorkError.
class PolyMeshWriter {
public:
    PolyMeshWriter(const std::filesystem::path& polyMeshDirectory,
                   const WriteFormat& format,
                   const MeshCounts& counts);

    void writePoints(const Fill<Vec3>& fill) const;
    void writePoints(std::span<const Vec3> points) const;
    void writeFaces(const Rows<Label>& faces) const;
    void writeQuads(const Fill<Quad>& fill) const; // all faces have four points
    void writeOwner(const Fill<Label>& fill) const;
    void writeOwner(std::span<const Label> owner) const;
    void writeNeighbour(const Fill<Label>& fill) const;
    void writeNeighbour(std::span<const Label> neighbour) const;
    void writePatches(std::span<const Patch> patches) const;

    /// Writes nothing when there are no zones.
    void writeZones(ZoneKind kind, std::span<const Zone> zones) const;

    /// A list with a value a cell, point or face, such as cellLevel.
    void writeLabelList(const std::string& object, std::span<const Label> labels) const;

    /// One number with dimensions, such as level0Edge.
    void writeUniformScalar(const std::string& object,
                            const std::string& dimensions,
                            double value) const;

    /// Puts the new mesh in place of the old one.
    void commit() { replacement_.commit(); }

private:
    using WriteBody = std::function<void(OutputFile&)>;

    void writeFile(const HeaderText& header, bool compress, const WriteBody& writeBody) const;
    void writeCellLabels(const char* object, const WriteBody& writeBody) const;
    HeaderText header(std::string className, std::string object) const;

    WriteFormat format_;
    MeshCounts counts_;
    DirectoryReplacement replacement_;
};

/// As writePolyMesh of polyMeshIo.h; `writeMore` writes further files into the same directory.
void writePolyMesh(const PolyMesh& mesh,
                   const std::filesystem::path& polyMeshDirectory,
                   const WriteFormat& format,
                   const std::function<void(const PolyMeshWriter&)>& writeMore);

} // namespace polymesh::foam
