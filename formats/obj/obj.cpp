// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/obj/obj.h"

#include "formats/textScanner.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/surface/regions.h"
#include "libpolymesh/surface/surfaceBuilder.h"

#include <iterator>
#include <vector>

namespace polymesh::obj {

namespace {

bool hasStatement(std::string_view text, std::string_view keyword) {
    for (std::size_t at = text.find(keyword); at != std::string_view::npos;
         at = text.find(keyword, at + 1)) {
        const bool isFirst = at == 0 || text[at - 1] == '\n' || text[at - 1] == '\r';
        const std::size_t after = at + keyword.size();
        if (isFirst && after < text.size() && (text[after] == ' ' || text[after] == '\t'))
            return true;
    }
    return false;
}

/// The statement that makes the regions of this file.
std::string_view regionKeyword(std::string_view text) {
    for (std::string_view keyword : {"g", "o"})
        if (hasStatement(text, keyword)) return keyword;
    return "usemtl";
}

class Reader {
public:
    Reader(std::string_view text, const std::string& fileName)
        : scanner_(text, fileName),
          regionKeyword_(regionKeyword(text)),
          region_(builder_.addRegion("")) {}

    TriSurface read(std::string_view name) {
        while (scanner_.findWord())
            readStatement();
        return builder_.finish(name);
    }

private:
    void readStatement() {
        const auto keyword = scanner_.word();
        if (keyword == "v") {
            labels_.push_back(builder_.addPoint(scanner_.point()));
        } else if (keyword == "f") {
            readFace();
        } else if (keyword == regionKeyword_) {
            region_ = builder_.addRegion(scanner_.findWordInLine() ? scanner_.word() : "");
        }
        scanner_.restOfLine();
    }

    void readFace() {
        corners_.clear();
        while (findCorner()) {
            corners_.push_back(readCorner());
            while (!scanner_.isAtWordEnd()) // "/texture/normal"
                scanner_.skip(scanner_.peek());
        }
        if (corners_.size() < 3) scanner_.fail("a face needs three corners or more");
        builder_.addPolygon(corners_, region_);
    }

    /// Goes to the next word of the statement, which a backslash continues on the next line.
    bool findCorner() {
        while (scanner_.findWordInLine()) {
            if (!scanner_.skip('\\')) return true;
            scanner_.restOfLine();
        }
        return false;
    }

    Label readCorner() {
        const auto count = static_cast<std::int64_t>(labels_.size());
        const std::int64_t number = scanner_.integer();
        if (!scanner_.isAtWordEnd() && scanner_.peek() != '/')
            scanner_.fail("expected a corner such as 7 or 7/1/3");
        if (number == 0 || number > count || number < -count)
            scanner_.fail(fmt::format("a face has vertex {}, of {} so far", number, count));
        return labels_[static_cast<std::size_t>(number > 0 ? number - 1 : count + number)];
    }

    TextScanner scanner_;
    std::string_view regionKeyword_;
    SurfaceBuilder builder_;
    std::vector<Label> labels_; // of the file's vertices
    std::vector<Label> corners_;
    Label region_;
};

} // namespace

TriSurface read(std::string_view text, const std::string& fileName, std::string_view name) {
    TriSurface surface = Reader(text, fileName).read(name);
    require(
        !surface.triangles.empty(), "{}: the file has no triangles: is it an OBJ file?", fileName);
    return surface;
}

std::string write(const TriSurface& surface) {
    std::string text;
    const auto out = std::back_inserter(text);
    for (const Vec3& p : surface.points)
        fmt::format_to(out, "v {} {} {}\n", p.x, p.y, p.z);
    const Rows<Label> triangles = trianglesOfRegions(surface);
    for (Label region = 0; region < triangles.size(); ++region) {
        fmt::format_to(out, "g {}\n", surface.regionNames[index(region)]);
        for (Label t : triangles[region]) {
            const auto& corners = surface.triangles[index(t)];
            fmt::format_to(out, "f {} {} {}\n", corners[0] + 1, corners[1] + 1, corners[2] + 1);
        }
    }
    return text;
}

} // namespace polymesh::obj
