// Tells kinds of files apart by their names and first bytes, for any table of kinds.
//
// A kind has `extensions` (as hasExtension() takes them) and `looksLike`, which is asked about a file's first
// bytes. A table is a span of kinds.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/io/atomic_file.h"
#include "engine/io/file_path.h"

namespace glint {

/// As many of a file's first bytes as kinds are asked about.
constexpr size_t kHeadBytes = 4096;

/// The first bytes of a regular file; empty where there is none or it cannot be read.
std::string readHead(const std::string& path, size_t bytes = kHeadBytes);

/// The same of a file in memory.
inline std::string_view headOf(std::string_view bytes) { return bytes.substr(0, kHeadBytes); }

/// What is left of a text file's first bytes behind a byte order mark and blanks.
std::string_view firstText(std::string_view head);

/// Whether first bytes can be text of any encoding: few control characters, or UTF-16.
bool looksLikeText(std::string_view head);

/// As readFile() (atomic_file.h), but of a file that is longer than its head and of another kind by
/// `isOfKind` only this head, so that its reader says what is wrong.
Result<std::string> readFileOfKind(const std::string& path,
                                   const std::function<bool(std::string_view head)>& isOfKind,
                                   uint64_t most = kMaxFileBytes);

/// The kind that the file's name says; null: none.
template <class Kind>
const Kind* kindByName(std::span<const Kind> kinds, const std::string& path) {
    for (const Kind& kind : kinds) {
        if (hasExtension(path, kind.extensions)) { return &kind; }
    }
    return nullptr;
}

/// The kind that the name says and the bytes do not contradict. Else the first kind of the table that they
/// look like; else what the name says, whose reader tells what is wrong; null: neither says anything.
template <class Kind>
const Kind* kindOf(std::span<const Kind> kinds, const std::string& path, std::string_view head) {
    const Kind* named = kindByName(kinds, path);
    if (named != nullptr && named->looksLike(head)) { return named; }
    for (const Kind& kind : kinds) {
        if (kind.looksLike(head)) { return &kind; }
    }
    return named;
}

}  // namespace glint
