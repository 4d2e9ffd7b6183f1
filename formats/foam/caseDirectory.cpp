// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/caseDirectory.h"

#include "formats/foam/dictionary.h"

#include <algorithm>

namespace polymesh::foam {
namespace {

constexpr int leastPrecision = 10;

WriteFormat formatFromOption(const std::string& option, WriteFormat format) {
    const bool gzip = option.ends_with(".gz");
    const std::string base = gzip ? option.substr(0, option.size() - 3) : option;
    require(base == "ascii" || base == "binary",
            "-format {}: expected ascii, binary, ascii.gz or binary.gz",
            option);
    format.format = base == "ascii" ? Format::ascii : Format::binary;
    format.compress = gzip;
    return format;
}

bool isCompressed(const Dictionary& controlDict) {
    const Value& value = controlDict.entry("writeCompression").value();
    if (value.kind == Value::Kind::word && value.text == "compressed") return true;
    if (value.kind == Value::Kind::word && value.text == "uncompressed") return false;
    return value.flag("writeCompression");
}

WriteFormat formatFromControlDict(const Dictionary& controlDict) {
    WriteFormat format;
    const std::string name = controlDict.word("writeFormat", "binary");
    if (name != "ascii" && name != "binary")
        controlDict.entry("writeFormat").value().fail("writeFormat", "ascii or binary");
    format.format = name == "ascii" ? Format::ascii : Format::binary;
    if (controlDict.has("writePrecision"))
        format.precision = std::clamp(static_cast<int>(controlDict.label("writePrecision")),
                                      leastPrecision,
                                      WriteFormat::exact);
    if (format.format == Format::ascii && controlDict.has("writeCompression"))
        format.compress = isCompressed(controlDict);
    return format;
}

} // namespace

WriteFormat writeFormat(const CaseDirectory& caseDirectory,
                        const std::optional<std::string>& option) {
    WriteFormat format;
    const std::filesystem::path controlDict = caseDirectory.controlDict();
    if (std::filesystem::exists(controlDict))
        format = formatFromControlDict(readDictionary(controlDict, Directives::skip));
    return option ? formatFromOption(*option, format) : format;
}

} // namespace polymesh::foam
