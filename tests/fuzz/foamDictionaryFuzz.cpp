// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes are a dictionary or an InputError, and so is every entry as any type.

#include "formats/foam/dictionary.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace {

using namespace polymesh;
using foam::Dictionary;
using foam::Directives;
using foam::Entry;

template<class Get>
void attempt(Get&& get) {
    try {
        (void)get();
    } catch (const InputError&) { // as it should be
    }
}

void readEveryEntry(const Dictionary& dictionary) {
    attempt([&] {
        requireKnownKeys(dictionary, {"cellSize", "margin"});
        return 0;
    });
    for (const Entry& entry : dictionary.entries()) {
        attempt([&] { return dictionary.word(entry.key); });
        attempt([&] { return dictionary.label(entry.key); });
        attempt([&] { return dictionary.flag(entry.key); });
        attempt([&] { return dictionary.vector(entry.key); });
        attempt([&] { return dictionary.labels(entry.key); });
        attempt([&] { return dictionary.words(entry.key); });
        attempt([&] { return namedDictionaries(entry); });
        if (entry.dictionary) readEveryEntry(*entry.dictionary);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const Directives directives : {Directives::refuse, Directives::skip})
        attempt([&] {
            readEveryEntry(foam::parseDictionary(text, "/nowhere/fuzz", directives));
            return 0;
        });
    return 0;
}
