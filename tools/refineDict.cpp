// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/refineDict.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/nearestWord.h"
#include "libpolymesh/refine/octant.h"
#include "libpolymesh/refine/regionCriteria.h"
#include "libpolymesh/refine/surfaceCriteria.h"
#include "libpolymesh/surface/check.h"
#include "libpolymesh/surface/regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace polymesh::tools {

namespace {

using foam::Dictionary;
using foam::Value;

int levelOf(const Value& value, const std::string& key) {
    const bool isWhole = value.kind == Value::Kind::number && value.number >= 0 &&
                         value.number <= mostLevel && value.number == std::floor(value.number);
    if (!isWhole) value.fail(key, fmt::format("a level: a whole number from 0 to {}", mostLevel));
    return static_cast<int>(value.number);
}

int levelOf(const Dictionary& dictionary) {
    return levelOf(dictionary.entry("level").value(), "level");
}

double positive(const Dictionary& dictionary, const std::string& key) {
    const double value = dictionary.scalar(key);
    if (!(value > 0)) dictionary.entry(key).value().fail(key, "a positive number");
    return value;
}

double angleOf(const Dictionary& dictionary, const std::string& key, double standard) {
    const double degrees = dictionary.scalar(key, standard);
    if (!(degrees >= 0 && degrees <= 180))
        dictionary.entry(key).value().fail(key, "an angle from 0 to 180 [deg]");
    return degrees * std::numbers::pi / 180;
}

/// `levels ((distance level) ...)`, as snappyHexMesh's.
std::vector<Shell> shellsOf(const Dictionary& dictionary) {
    std::vector<Shell> shells;
    for (const Value& item : dictionary.list("levels")) {
        if (item.kind != Value::Kind::list || item.items.size() != 2)
            item.fail("levels", "pairs (distance level)");
        const double distance = item.items[0].scalar("levels");
        if (distance < 0) item.items[0].fail("levels", "a distance, not negative [m]");
        shells.push_back({distance, levelOf(item.items[1], "levels")});
    }
    if (shells.empty())
        dictionary.entry("levels").value().fail("levels", "at least one pair (distance level)");
    return shells;
}

/// The dictionary of an entry. Throws InputError when it is something else.
const Dictionary& inner(const foam::Entry& entry) {
    if (!entry.dictionary)
        throw InputError(fmt::format("{}: {}: expected {{...}}", entry.place.text(), entry.key));
    return *entry.dictionary;
}

/// Throws InputError when a dictionary has none of the keys: it would do nothing.
void requireOneOf(const foam::Entry& entry, const std::vector<std::string>& keys) {
    const Dictionary& dictionary = inner(entry);
    require(std::ranges::any_of(keys, [&](const std::string& key) { return dictionary.has(key); }),
            "{}: {}: says nothing, expected one of {}",
            entry.place.text(),
            entry.key,
            fmt::join(keys, ", "));
}

/// Reads the criteria of one surface.
class SurfaceReader {
public:
    SurfaceReader(const Dictionary& dictionary, TriSurface surface, RefineOptions& options)
        : dictionary_(dictionary),
          surface_(std::make_shared<const TriSurface>(std::move(surface))),
          near_(std::make_shared<const NearTriangles>(surface_)),
          options_(options) {}

    void read() {
        readRegions();
        if (dictionary_.has("level")) addShells(trianglesLeft(), {{0, levelOf(dictionary_)}});
        if (dictionary_.has("levels"))
            options_.criteria.push_back(distanceCriterion(near_, shellsOf(dictionary_)));
        if (dictionary_.has("curvature")) readCurvature(dictionary_.dictionary("curvature"));
        if (dictionary_.has("features")) readFeatures(dictionary_.dictionary("features"));
        if (dictionary_.has("gaps")) readGaps(dictionary_.dictionary("gaps"));
    }

private:
    void readRegions();
    void readCurvature(const Dictionary& curvature);
    void readFeatures(const Dictionary& features);
    void readGaps(const Dictionary& gaps);

    void addShells(std::vector<Label> triangles, std::vector<Shell> shells) {
        auto near = std::make_shared<const NearTriangles>(surface_, std::move(triangles));
        options_.criteria.push_back(distanceCriterion(std::move(near), std::move(shells)));
    }

    /// Those of the regions that have no level of their own.
    std::vector<Label> trianglesLeft() const {
        std::vector<Label> left;
        for (Label t = 0; t < surface_->triangleCount(); ++t)
            if (!hasOwnLevel_[index(surface_->region[index(t)])]) left.push_back(t);
        return left;
    }

    const Dictionary& dictionary_;
    std::shared_ptr<const TriSurface> surface_;
    std::shared_ptr<const NearTriangles> near_;
    RefineOptions& options_;
    std::vector<bool> hasOwnLevel_; // of each region of the surface
};

void SurfaceReader::readRegions() {
    const std::vector<std::string>& names = surface_->regionNames;
    hasOwnLevel_.assign(names.size(), false);
    if (!dictionary_.has("regions")) return;
    const Rows<Label> triangles = trianglesOfRegions(*surface_);
    for (const foam::Entry& entry : dictionary_.dictionary("regions").entries()) {
        const auto found = std::ranges::find(names, entry.key);
        require(found != names.end(),
                "{}: the surface has no region '{}'; the nearest is '{}'",
                entry.place.text(),
                entry.key,
                nearestWord(entry.key, names));
        const auto region = static_cast<std::size_t>(found - names.begin());
        const Dictionary& own = inner(entry);
        foam::requireKnownKeys(own, {"level", "levels"});
        requireOneOf(entry, {"level", "levels"});
        const std::span<const Label> members = triangles[toLabel(region)];
        hasOwnLevel_[region] = own.has("level");
        if (own.has("level")) addShells({members.begin(), members.end()}, {{0, levelOf(own)}});
        if (own.has("levels")) addShells({members.begin(), members.end()}, shellsOf(own));
    }
}

void SurfaceReader::readCurvature(const Dictionary& curvature) {
    foam::requireKnownKeys(curvature, {"cellsPerRadius", "level", "featureAngle"});
    options_.criteria.push_back(curvatureCriterion(near_,
                                                   {positive(curvature, "cellsPerRadius"),
                                                    levelOf(curvature),
                                                    angleOf(curvature, "featureAngle", 30)}));
}

void SurfaceReader::readFeatures(const Dictionary& features) {
    foam::requireKnownKeys(features, {"angle", "level", "distance"});
    const double distance = features.scalar("distance", 0);
    if (distance < 0)
        features.entry("distance").value().fail("distance", "a distance, not negative [m]");
    options_.criteria.push_back(featureCriterion(
        *surface_, {angleOf(features, "angle", 30), {distance, levelOf(features)}}));
}

void SurfaceReader::readGaps(const Dictionary& gaps) {
    foam::requireKnownKeys(gaps, {"cells", "level"});
    options_.criteria.push_back(gapCriterion(near_, {positive(gaps, "cells"), levelOf(gaps)}));
}

Region boxOf(const Dictionary& dictionary) {
    foam::requireKnownKeys(dictionary, {"type", "mode", "level", "min", "max"});
    const Box box{dictionary.vector("min"), dictionary.vector("max")};
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.min[axis] < box.max[axis]))
            dictionary.entry("max").value().fail("max", "a corner above min in x, y and z");
    return boxRegion(box);
}

Region sphereOf(const Dictionary& dictionary) {
    foam::requireKnownKeys(dictionary, {"type", "mode", "level", "centre", "radius"});
    return sphereRegion(dictionary.vector("centre"), positive(dictionary, "radius"));
}

Region cylinderOf(const Dictionary& dictionary) {
    foam::requireKnownKeys(dictionary, {"type", "mode", "level", "point1", "point2", "radius"});
    const Vec3 end1 = dictionary.vector("point1");
    const Vec3 end2 = dictionary.vector("point2");
    if (end1 == end2)
        dictionary.entry("point2").value().fail("point2", "a point other than point1");
    return cylinderRegion(end1, end2, positive(dictionary, "radius"));
}

Region closedSurfaceOf(const Dictionary& dictionary, const RefineFiles& files) {
    foam::requireKnownKeys(dictionary, {"type", "mode", "level", "file"});
    const foam::Entry& file = dictionary.entry("file");
    auto surface = std::make_shared<const TriSurface>(files.surface(dictionary.string("file")));
    const SurfaceDefects defects = checkSurface(*surface);
    if (!defects.isClosed()) {
        const Finding& first =
            defects.openEdges.count > 0 ? defects.openEdges : defects.misorientedEdges;
        file.value().fail("file",
                          fmt::format("a closed surface; {} edges of this one are open or turned "
                                      "the wrong way, the first at ({:.6g} {:.6g} {:.6g})",
                                      defects.openEdges.count + defects.misorientedEdges.count,
                                      first.first.x,
                                      first.first.y,
                                      first.first.z));
    }
    return surfaceRegion(std::make_shared<const NearTriangles>(std::move(surface)));
}

/// One of `words`, else InputError that names the nearest.
std::string oneOf(const Dictionary& dictionary,
                  const std::string& key,
                  const std::vector<std::string>& words,
                  const std::string& standard) {
    std::string word = standard.empty() ? dictionary.word(key) : dictionary.word(key, standard);
    if (std::ranges::find(words, word) == words.end())
        dictionary.entry(key).value().fail(key,
                                           fmt::format("one of {}; the nearest is {}",
                                                       fmt::join(words, ", "),
                                                       nearestWord(word, words)));
    return word;
}

void readRegion(const Dictionary& dictionary, const RefineFiles& files, RefineOptions& options) {
    const std::string type =
        oneOf(dictionary, "type", {"box", "sphere", "cylinder", "surface"}, "");
    const Region region = type == "box"        ? boxOf(dictionary)
                          : type == "sphere"   ? sphereOf(dictionary)
                          : type == "cylinder" ? cylinderOf(dictionary)
                                               : closedSurfaceOf(dictionary, files);
    const bool inside = oneOf(dictionary, "mode", {"inside", "outside"}, "inside") == "inside";
    options.criteria.push_back(regionCriterion(
        region, inside ? RegionSide::inside : RegionSide::outside, levelOf(dictionary)));
}

void readSurface(const foam::Entry& entry, const RefineFiles& files, RefineOptions& options) {
    const Dictionary& dictionary = inner(entry);
    const std::string name = dictionary.string("file", entry.key);
    foam::requireKnownKeys(dictionary,
                           {"file", "level", "levels", "curvature", "features", "gaps", "regions"});
    requireOneOf(entry, {"level", "levels", "curvature", "features", "gaps", "regions"});
    SurfaceReader(dictionary, files.surface(name), options).read();
}

void readCellSet(const foam::Entry& entry, const RefineFiles& files, RefineOptions& options) {
    const Dictionary& dictionary = inner(entry);
    foam::requireKnownKeys(dictionary, {"level"});
    options.criteria.push_back(cellCriterion(files.cellSet(entry.key), levelOf(dictionary)));
}

/// Runs `read` for the entries of a dictionary, when it is there; errors of files that are read
/// begin with the place that names them.
template<class Read>
void forEntries(const Dictionary& dictionary, const std::string& key, Read&& read) {
    if (!dictionary.has(key)) return;
    for (const foam::Entry& entry : inner(dictionary.entry(key)).entries())
        read(entry);
}

/// Puts the place in front of what reading a file says.
template<class Read>
auto named(const foam::Entry& entry, Read&& read) {
    return [&](const std::string& name) {
        try {
            return read(name);
        } catch (const InputError& error) {
            throw InputError(
                fmt::format("{}: {}: {}", entry.place.text(), entry.key, error.what()));
        }
    };
}

} // namespace

RefineOptions readRefinement(const Dictionary& refinement, const RefineFiles& files) {
    foam::requireKnownKeys(refinement, {"nCellsBetweenLevels", "surfaces", "regions", "cellSets"});
    RefineOptions options;
    if (refinement.has("nCellsBetweenLevels")) {
        constexpr Label mostLayers = 20;
        const Label layers = refinement.label("nCellsBetweenLevels");
        if (layers < 1 || layers > mostLayers)
            refinement.entry("nCellsBetweenLevels")
                .value()
                .fail("nCellsBetweenLevels",
                      fmt::format("a whole number from 1 to {}", mostLayers));
        options.bufferLayers = static_cast<int>(layers);
    }
    const auto filesOf = [&](const foam::Entry& entry) {
        return RefineFiles{named(entry, files.surface), named(entry, files.cellSet)};
    };
    forEntries(refinement, "surfaces", [&](const foam::Entry& entry) {
        readSurface(entry, filesOf(entry), options);
    });
    forEntries(refinement, "regions", [&](const foam::Entry& entry) {
        readRegion(inner(entry), filesOf(entry), options);
    });
    forEntries(refinement, "cellSets", [&](const foam::Entry& entry) {
        readCellSet(entry, filesOf(entry), options);
    });
    return options;
}

} // namespace polymesh::tools
