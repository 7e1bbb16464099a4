#include "engine/io/named_files.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "engine/io/file_path.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

std::string withSlashes(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

/// Without quotes around it, backslashes before blanks, and %20 and its like.
std::string unescaped(std::string name) {
    if (name.size() > 1 && (name.front() == '"' || name.front() == '\'') && name.back() == name.front()) {
        name = name.substr(1, name.size() - 2);
    }
    std::string out;
    for (size_t i = 0; i < name.size(); ++i) {
        unsigned code = 0;
        if (name[i] == '\\' && i + 1 < name.size() && name[i + 1] == ' ') { continue; }
        if (name[i] == '%' && i + 2 < name.size() &&
            std::from_chars(&name[i + 1], &name[i + 3], code, 16).ptr == &name[i + 3] && code >= ' ') {
            out += static_cast<char>(code);
            i += 2;
            continue;
        }
        out += name[i];
    }
    return withSlashes(out);
}

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
    return text;
}

}  // namespace

std::string NamedFiles::inOtherCase(const std::string& folder, const std::string& name) {
    auto [listing, isNew] = listings_.try_emplace(folder);
    if (isNew) {
        std::error_code code;
        for (fs::directory_iterator entry(folder.empty() ? "." : folder, code), end; !code && entry != end;
             entry.increment(code)) {
            const std::string known = entry->path().filename().string();
            listing->second.try_emplace(lowerCase(known), known);
        }
    }
    const auto found = listing->second.find(lowerCase(name));
    return found == listing->second.end() ? std::string() : (fs::path(folder) / found->second).string();
}

std::string_view withoutComment(std::string_view name) {
    const size_t mark = std::min(name.find(" #"), name.find("\t#"));
    const size_t last = name.substr(0, mark).find_last_not_of(" \t\r");
    return name.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

std::optional<NamedFiles::Found> NamedFiles::find(const std::string& name, const std::string& from) {
    const std::string plain = unescaped(std::string(withoutComment(name)));
    const fs::path base = fs::path(from).parent_path();
    const std::string candidates[] = {name, withSlashes(name), unescaped(name), plain};
    for (size_t i = 0; i < std::size(candidates); ++i) {
        const std::string path = (base / candidates[i]).string();
        if (!candidates[i].empty() && fileExists(path)) { return Found{path, i > 1}; }
    }
    for (const std::string& candidate : {candidates[2], plain}) {
        const fs::path last = fs::path(candidate).filename();
        for (const fs::path& folder : {(base / candidate).parent_path(), base}) {
            const std::string path = inOtherCase(folder.string(), last.string());
            if (!path.empty() && fileExists(path)) { return Found{path, true}; }
        }
    }
    return std::nullopt;
}

}  // namespace glint
