// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The parts of readBlockMeshDict; each reads some entries into the description.

#include "tools/blockMeshDict.h"

#include <map>
#include <string>
#include <vector>

namespace polymesh::tools {

/// Reads the items of a list one by one: sequences such as `arc 0 1 (0 0 1)`.
class Items {
public:
    Items(const foam::Value& list, std::string key)
        : items_(list.list(key)), key_(std::move(key)), end_(list.place) {}

    bool atEnd() const { return at_ == items_.size(); }

    /// The next item, without moving on; null at the end.
    const foam::Value* look() const { return atEnd() ? nullptr : &items_[at_]; }

    bool nextIs(foam::Value::Kind kind) const { return !atEnd() && items_[at_].kind == kind; }

    /// The next item; `expected` is for the message when there is none.
    const foam::Value& next(const std::string& expected);

    const std::string& key() const { return key_; }

private:
    const std::vector<foam::Value>& items_;
    std::string key_;
    foam::Place end_;
    std::size_t at_ = 0;
};

struct BlockDictReader {
    const foam::Dictionary& dictionary;
    const FindSurface& findSurface;
    std::map<std::string, Label> vertexNames = {};
    std::map<std::string, Label> blockNames = {};
    std::map<std::string, Shape> shapes = {}; // those used so far
    BlockMeshDescription mesh = {};

    void readVertices();
    void readEdges();
    void readBlocks();
    void readProjectedSides();
    void readPatches();

    /// A vertex by its number or its name.
    Label vertex(const foam::Value& value, const std::string& key) const;

    /// The one surface that a list of names, or a name, means.
    const Shape& shape(const foam::Value& names);

    /// The vertices of a side: four, three (a triangle), or the numbers of a block and its side.
    BlockSide side(const foam::Value& value, const std::string& key) const;

private:
    Vec3 readVertex(Items& items);
    Block readBlock(Items& items);
    BlockEdge readEdge(Items& items);
    void readBoundary();
    void readOldPatches();
};

/// Other entries than the known ones are macros of the user, unless they look like a known one that
/// is missing: that is an InputError.
void refuseMisspelt(const foam::Dictionary& dictionary, const std::vector<std::string>& known);

/// Throws InputError when the type of a patch looks like one of OpenFOAM's misspelt. Others pass:
/// users can have their own.
void refuseMisspeltType(const foam::Value& type);

/// The list that an entry of the whole dictionary is.
const foam::Value& listOf(const foam::Dictionary& dictionary, const std::string& key);

/// A number, or sections (length cells expansion); a negative ratio is turned over.
Grading gradingOf(const foam::Value& value, const std::string& key);

/// Three numbers, none of them huge.
Vec3 pointOf(const foam::Value& value, const std::string& key);

/// A whole number, at least 1.
Label cellCount(const foam::Value& value, const std::string& key);

/// Values as they are written in a dictionary.
std::string written(const std::vector<foam::Value>& values);

} // namespace polymesh::tools
