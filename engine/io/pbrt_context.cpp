#include "engine/io/pbrt_context.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "engine/io/file_path.h"

namespace glint {
namespace {

constexpr size_t kMaxSentences = 40;

}  // namespace

void PbrtContext::fail(const PbrtPlace& at, std::string message) {
    if (error) { return; }
    const PbrtFile& file = files[at.file];
    error = Error{
        std::move(message),
        {file.path, static_cast<int>(at.line), static_cast<int>(at.column), file.text.lineText(at.line)}};
}

std::string PbrtContext::placeOf(const PbrtPlace& at) const {
    return fmt::format("{}:{}", files[at.file].path, at.line);
}

void PbrtContext::remark(const PbrtPlace& at, std::string_view kind, std::string_view detail) {
    remarks.add(
        kind, [&] { return placeOf(at); }, detail);
}

void PbrtContext::note(const PbrtPlace& at, std::string_view kind, std::string_view detail) {
    notes.add(
        kind, [&] { return placeOf(at); }, detail);
}

void PbrtContext::refuse(const PbrtPlace& at, std::string message) {
    if (options.allowMissing) {
        remark(at, sentence(std::move(message)));
    } else {
        fail(at, message + "; --allow-missing goes on without it");
    }
}

std::string_view PbrtContext::sentence(std::string text) {
    if (const auto found = sentences.find(text); found != sentences.end()) { return *found; }
    if (sentences.size() >= kMaxSentences) { return "more is left out that Glint does not have"; }
    return *sentences.insert(std::move(text)).first;
}

std::string PbrtContext::findFile(const PbrtPlace& at, std::string_view name) const {
    std::string file(name);
    std::ranges::replace(file, '\\', '/');
    const std::string beside = resolvePath(file, files[0].path);
    const std::string besideOwn = resolvePath(file, files[at.file].path);
    return !fileExists(beside) && fileExists(besideOwn) ? besideOwn : beside;
}

std::string PbrtContext::fileOf(const PbrtPlace& at, std::string_view name) const {
    namespace fs = std::filesystem;
    std::string found = findFile(at, name);
    if (fs::path(name).is_absolute()) { return found; }
    std::error_code code;
    const fs::path absolute = fs::absolute(found, code).lexically_normal();
    const fs::path folder = fs::absolute(scene.path, code).lexically_normal().parent_path();
    const fs::path relative = absolute.lexically_relative(folder);
    return relative.empty() ? found : relative.string();
}

}  // namespace glint
