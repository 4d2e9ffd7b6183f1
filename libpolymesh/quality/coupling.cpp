// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/checkParts.h"

namespace polymesh {

namespace {

/// The index of the patch that a cyclic patch is coupled to, or -1.
Label partnerOf(const PolyMesh& mesh, const Patch& patch) {
    if (patch.type != "cyclic") return -1;
    for (const auto& [key, value] : patch.entries)
        for (std::size_t p = 0; key == "neighbourPatch" && p < mesh.patches.size(); ++p)
            if (mesh.patches[p].name == value && mesh.patches[p].size == patch.size)
                return toLabel(p);
    return -1;
}

/// Sum of the distances of the points of a pair of faces; the second runs the other way round.
double mismatch(const PolyMesh& mesh, Label face, Label other, const Vec3& shift) {
    const std::span<const Label> a = mesh.faces[face];
    const std::span<const Label> b = mesh.faces[other];
    double sum = 0;
    for (std::size_t i = 0; a.size() == b.size() && i < a.size(); ++i) {
        const Vec3& p = mesh.points[index(a[i])];
        const Vec3& q = mesh.points[index(b[i == 0 ? 0 : b.size() - i])];
        sum += norm(p - (q + shift));
    }
    return sum;
}

} // namespace

Coupling coupleFaces(const PolyMesh& mesh, const MeshGeometry& geometry) {
    const Label internal = mesh.internalFaceCount();
    Coupling coupling;
    coupling.isCoupled.assign(index(mesh.faceCount() - internal), 0);
    coupling.isMaster = coupling.isCoupled;
    double mismatchSum = 0;
    Label coupledPoints = 0;
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        const Patch& patch = mesh.patches[p];
        const Label partner = partnerOf(mesh, patch);
        if (partner < 0 || patch.size == 0) continue;
        coupling.cellCentres.resize(coupling.isCoupled.size());
        coupling.cellVolumes.resize(coupling.isCoupled.size());
        const Label otherStart = mesh.patches[index(partner)].start;
        const Vec3 shift =
            geometry.faceCentres[index(patch.start)] - geometry.faceCentres[index(otherStart)];
        for (Label i = 0; i < patch.size; ++i) {
            const std::size_t at = index(patch.start + i - internal);
            const std::size_t cell = index(mesh.owner[index(otherStart + i)]);
            coupling.isCoupled[at] = 1;
            coupling.isMaster[at] = toLabel(p) < partner ? 1 : 0;
            coupling.cellCentres[at] = geometry.cellCentres[cell] + shift;
            coupling.cellVolumes[at] = geometry.cellVolumes[cell];
            if (coupling.isMaster[at] == 0) continue;
            mismatchSum += mismatch(mesh, patch.start + i, otherStart + i, shift);
            coupledPoints += mesh.faces.rowSize(patch.start + i);
        }
    }
    if (coupledPoints > 0)
        coupling.averageMismatch = mismatchSum / static_cast<double>(coupledPoints);
    return coupling;
}

} // namespace polymesh
