#include "engine/io/pbrt_parser.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "engine/io/file_kind.h"
#include "engine/io/gzip_file.h"
#include "engine/io/plain_text.h"

namespace glint {
namespace {

constexpr size_t kMaxLevels = 64;
constexpr size_t kMaxFiles = 65536;
constexpr size_t kMaxBytes = size_t{8} << 30;

/// What stands behind a directive's name: numbers, then strings, then parameters.
struct Form {
    std::string_view name;
    int numbers = 0;
    int texts = 0;
    bool hasParams = false;
};

constexpr Form kForms[] = {{"Accelerator", 0, 1, true},
                           {"ActiveTransform", 0, 0, false},
                           {"AreaLightSource", 0, 1, true},
                           {"Attribute", 0, 1, true},
                           {"AttributeBegin"},
                           {"AttributeEnd"},
                           {"Camera", 0, 1, true},
                           {"ColorSpace", 0, 1, false},
                           {"ConcatTransform", 16},
                           {"CoordSysTransform", 0, 1, false},
                           {"CoordinateSystem", 0, 1, false},
                           {"Film", 0, 1, true},
                           {"Identity"},
                           {"Import", 0, 1, false},
                           {"Include", 0, 1, false},
                           {"Integrator", 0, 1, true},
                           {"LightSource", 0, 1, true},
                           {"LookAt", 9},
                           {"MakeNamedMaterial", 0, 1, true},
                           {"MakeNamedMedium", 0, 1, true},
                           {"Material", 0, 1, true},
                           {"MediumInterface", 0, 1, false},
                           {"NamedMaterial", 0, 1, false},
                           {"ObjectBegin", 0, 1, false},
                           {"ObjectEnd"},
                           {"ObjectInstance", 0, 1, false},
                           {"Option", 0, 0, true},
                           {"PixelFilter", 0, 1, true},
                           {"ReverseOrientation"},
                           {"Rotate", 4},
                           {"Sampler", 0, 1, true},
                           {"Scale", 3},
                           {"Shape", 0, 1, true},
                           {"Texture", 0, 3, true},
                           {"Transform", 16},
                           {"TransformBegin"},
                           {"TransformEnd"},
                           {"TransformTimes", 2},
                           {"Translate", 3},
                           {"WorldBegin"},
                           {"WorldEnd"}};

/// What is no text is not read to its end.
Result<std::string> readPbrtText(const std::string& path) {
    const auto isText = [](std::string_view head) {
        return head.starts_with("\x1f\x8b") || looksLikeText(head);
    };
    const bool isOther = !isText(readHead(path));
    Result<std::string> bytes = isOther ? Result<std::string>(std::string()) : readUnpacked(path);
    if (isOther || (bytes && !looksLikeText(headOf(*bytes)))) {
        return Error{"is no text; expected a pbrt scene", {.file = path}};
    }
    return bytes;
}

constexpr bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// As many numbers as `count`, in brackets or without.
bool readNumbers(PbrtText* text, int count, std::vector<double>* out) {
    const bool isList = text->peek() == '[';
    if (isList) { text->word(); }
    for (int i = 0; i < count; ++i) {
        double number = 0.0;
        if (!text->readNumber(&number)) { return false; }
        out->push_back(number);
    }
    return !isList || (text->peek() == ']' && text->word() == "]");
}

}  // namespace

void PbrtParser::open(const std::string& path) { openFile(path, {}, false); }

bool PbrtParser::openFile(const std::string& path, const PbrtPlace& from, bool isImport) {
    const std::string key = std::filesystem::path(path).lexically_normal().string();
    const bool isFirst = open_.empty();
    if (std::ranges::find(open_, key, &Open::key) != open_.end()) {
        context_.fail(from, fmt::format("\"{}\" includes itself", path));
        return false;
    }
    if (open_.size() >= kMaxLevels || context_.files.size() >= kMaxFiles || bytes_ > kMaxBytes) {
        context_.fail(from,
                      fmt::format("the scene includes files more than {} deep, more than {} of them, or "
                                  "more than 8 GiB",
                                  kMaxLevels, kMaxFiles));
        return false;
    }
    Result<std::string> bytes = readPbrtText(path);
    if (!bytes && isFirst) {
        context_.error = bytes.error();
    } else if (!bytes) {
        context_.refuse(from, fmt::format("cannot include \"{}\": {}", path, bytes.error().message));
    }
    if (!bytes) { return false; }
    bytes_ += bytes->size();
    if (std::optional<PlainText> plain = asPlainText(*bytes)) { *bytes = std::move(plain->text); }
    const auto file = static_cast<uint32_t>(context_.files.size());
    context_.files.emplace_back(path, std::move(*bytes), file);
    open_.push_back({file, key, isImport, from});
    return true;
}

/// Leaves the file that is at its end; true where that is a directive.
bool PbrtParser::close(PbrtDirective* out) {
    const Open closed = open_.back();
    open_.pop_back();
    context_.files[closed.file].text.drop();
    if (closed.isImport) { *out = {"AttributeEnd", closed.from, {}, {}, {}}; }
    return closed.isImport;
}

bool PbrtParser::include(const PbrtDirective& directive) {
    return openFile(context_.findFile(directive.place, directive.texts[0]), directive.place,
                    directive.name == "Import");
}

bool PbrtParser::next(PbrtDirective* out) {
    while (!context_.failed() && !open_.empty()) {
        PbrtText& text = context_.files[open_.back().file].text;
        if (text.atEnd()) {
            if (close(out)) { return true; }
            continue;
        }
        const PbrtPlace at = text.place();
        const std::string_view word = text.word();
        const auto form = std::ranges::find(kForms, word, &Form::name);
        if (form == std::end(kForms)) {
            passUnknown(&text, at, word);
            continue;
        }
        *out = {form->name, at, {}, {}, {}};
        if (!readArguments(&text, out)) { return false; }
        const bool isImport = out->name == "Import";
        if (!isImport && out->name != "Include") { return true; }
        if (include(*out) && isImport) {
            *out = {"AttributeBegin", at, {}, {}, {}};
            return true;
        }
    }
    return false;
}

bool PbrtParser::readArguments(PbrtText* text, PbrtDirective* out) {
    const Form& form = *std::ranges::find(kForms, out->name, &Form::name);
    if (form.numbers > 0 && !readNumbers(text, form.numbers, &out->numbers)) {
        context_.fail(text->place(),
                      fmt::format("expected {} finite numbers behind {}", form.numbers, form.name));
        return false;
    }
    for (int i = 0; i < form.texts; ++i) {
        out->texts.emplace_back();
        if (!text->readString(&out->texts.back())) {
            context_.fail(text->place(), fmt::format("expected {} in quotes behind {}",
                                                     form.texts == 1 ? "a name" : "three names", form.name));
            return false;
        }
    }
    if (form.name == "MediumInterface") {  // one name is that of both sides
        std::string outside;
        out->texts.push_back(text->readString(&outside) ? outside : out->texts[0]);
    }
    if (form.name == "ActiveTransform") { out->texts.emplace_back(text->word()); }
    if (form.hasParams) {
        out->params = readPbrtParams(&context_, text, out->place, space_);
        out->params.setOwner(std::string(form.name), out->texts.empty() ? "" : out->texts.back());
    }
    return !context_.failed();
}

void PbrtParser::passUnknown(PbrtText* text, const PbrtPlace& at, std::string_view word) {
    if (word.empty() || !isLetter(word[0])) {
        context_.fail(at, fmt::format("expected a directive, but found \"{}\"", word.substr(0, 40)));
        return;
    }
    context_.remark(at, "directives that pbrt does not have are left out", word);
    while (!text->atEnd() && !isLetter(text->peek())) {
        text->skipValue();
    }
}

}  // namespace glint
