// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/outputFile.h"
#include "libpolymesh/base/parallel.h"

#include <filesystem>
#include <string>
#include <vector>

namespace polymesh::star {

/// Files that are written beside those that they replace, and take their places together.
class FileSet {
public:
    explicit FileSet(std::filesystem::path prefix) : prefix_(std::move(prefix)) {}

    /// Removes the files that did not get into place.
    ~FileSet();
    FileSet(const FileSet&) = delete;
    FileSet& operator=(const FileSet&) = delete;

    /// Writes prefix + ending; `writeBody` gets a foam::OutputFile. Throws WorkError.
    template<class WriteBody>
    void write(const char* ending, WriteBody&& writeBody) {
        const std::filesystem::path path = finalPath(ending);
        endings_.emplace_back(ending);
        foam::OutputFile file(temporaryPath(ending), path, false);
        writeBody(file);
        file.close();
    }

    /// Puts all files in their places. Throws WorkError.
    void commit();

    std::filesystem::path finalPath(const std::string& ending) const;

private:
    std::filesystem::path temporaryPath(const std::string& ending) const;

    std::filesystem::path prefix_;
    std::vector<std::string> endings_;
};

/// Writes the texts of elements 0 ... count - 1 one after the other: append(text, i) adds that of
/// element i; many run at the same time, the bytes are the same for any number of threads.
template<class Append>
void writeElements(foam::OutputFile& file, Label count, Append&& append) {
    constexpr Label blockSize = 2048;
    constexpr Label batchSize = 64 * blockSize; // as much text as is held at a time
    std::vector<std::string> blocks(index(batchSize / blockSize));
    for (Label start = 0; start < count; start += batchSize) {
        const Label size = std::min(batchSize, count - start);
        parallelBlocks(size, blockSize, [&](Label block, Label first, Label last) {
            std::string& text = blocks[index(block)];
            text.clear();
            for (Label i = first; i < last; ++i)
                append(text, start + i);
        });
        for (Label block = 0; block * blockSize < size; ++block)
            file.write(blocks[index(block)]);
    }
}

} // namespace polymesh::star
