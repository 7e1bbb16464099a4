#include "engine/io/mtl_reader.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tiny_obj_loader.h>

#include "engine/io/text_cursor.h"

namespace glint {
namespace {

enum class Form { Color, Number, Map, UnusedMap, Silent };

struct Key {
    std::string_view name;  ///< as tinyobjloader knows it
    Form form;
};

/// First those of MtlKey, in its order.
constexpr Key kKeys[] = {{"Kd", Form::Color},         {"Ks", Form::Color},       {"Ke", Form::Color},
                         {"Tf", Form::Color},         {"Ns", Form::Number},      {"Ni", Form::Number},
                         {"d", Form::Number},         {"Tr", Form::Number},      {"illum", Form::Number},
                         {"Pr", Form::Number},        {"Pm", Form::Number},      {"Ps", Form::Number},
                         {"Pc", Form::Number},        {"Pcr", Form::Number},     {"aniso", Form::Number},
                         {"anisor", Form::Number},    {"map_Kd", Form::Map},     {"map_Ke", Form::Map},
                         {"map_d", Form::Map},        {"map_Bump", Form::Map},   {"bump", Form::Map},
                         {"norm", Form::Map},         {"map_Pr", Form::Map},     {"Kt", Form::Color},
                         {"map_Ka", Form::Silent},    {"Ka", Form::Silent},      {"Km", Form::Silent},
                         {"sharpness", Form::Silent}, {"map_aat", Form::Silent}, {"disp", Form::UnusedMap},
                         {"decal", Form::UnusedMap},  {"refl", Form::UnusedMap}};

/// Options of maps, how many values each may have (0: a word), what a missing one is, and whether it counts.
struct MapOption {
    std::string_view name;
    int numbers;
    float missing = 0.0f;
    bool counts = false;
};
constexpr MapOption kOptions[] = {{"-s", 3, 1.0f, true},  {"-o", 3, 0.0f, true},    {"-t", 3},
                                  {"-mm", 2, 1.0f, true}, {"-bm", 1, 1.0f, true},   {"-boost", 1},
                                  {"-texres", 1},         {"-blendu", 0},           {"-blendv", 0},
                                  {"-clamp", 0, 0, true}, {"-imfchan", 0, 0, true}, {"-cc", 0},
                                  {"-type", 0},           {"-colorspace", 0}};

bool sameWord(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return lower(x) == lower(y); });
}

class MtlReader {
  public:
    MtlReader(const std::string& text, const std::string& path) : cursor_(text, path) {}

    MtlFile run() {
        for (; !cursor_.atEnd(); cursor_.nextLine()) {
            if (!cursor_.atLineEnd()) { readLine(); }
        }
        file_.remarks = cursor_.remarks();
        file_.charactersCounted = cursor_.charactersCounted();
        return std::move(file_);
    }

  private:
    void readLine() {
        const char* where = cursor_.position();
        const std::string_view word = cursor_.word();
        if (sameWord(word, "newmtl")) {
            begin(where);
            return;
        }
        const auto key = std::find_if(std::begin(kKeys), std::end(kKeys),
                                      [&](const Key& known) { return sameWord(known.name, word); });
        if (key == std::end(kKeys)) {
            const bool isMap = word.size() > 4 && sameWord(word.substr(0, 4), "map_");
            cursor_.remark(
                where, isMap ? kUnusedMap : "lines that are no statement of MTL files are left out", word);
            cursor_.restOfLine();
            return;
        }
        if (key->form == Form::Silent) {
            cursor_.restOfLine();
        } else if (key->form == Form::UnusedMap) {
            cursor_.remark(where, kUnusedMap, word);
            cursor_.restOfLine();
        } else if (file_.entries.empty()) {
            cursor_.remark(where, "what stands before the first newmtl is left out", word);
            cursor_.restOfLine();
        } else {
            const bool isUsual = key->name == word || word == "map_bump";
            if (!isUsual) { cursor_.remark(where, "keywords in other case", word); }
            readValue(where, *key);
        }
    }

    void begin(const char* where) {
        std::string name(cursor_.restOfLine());
        if (name.empty()) { cursor_.remark(where, "newmtl without a name"); }
        skips_ = !names_.insert(name).second;
        if (skips_) {
            cursor_.remark(where, "materials are defined twice; the first counts", name);
            return;
        }
        MtlEntry& entry = file_.entries.emplace_back();
        entry.name = std::move(name);
        entry.line = cursor_.lineOf(where);
    }

    void readValue(const char* where, const Key& key) {
        const auto bit = static_cast<uint32_t>(&key - kKeys);
        const auto line = key.form == Form::Color    ? readColor(where)
                          : key.form == Form::Number ? readNumber(where, bit)
                                                     : readMap(where);
        if (!line || skips_) { return; }
        const bool isTint = key.name == "Kt";
        file_.entries.back().given |= 1u << (isTint ? static_cast<uint32_t>(MtlKey::Tf) : bit);
        file_.entries.back().lines += fmt::format("{} {}\n", key.name, *line);
    }

    std::optional<std::string> readColor(const char* where) {
        float rgb[3] = {};
        const int count = cursor_.readSomeFloats(3, rgb);
        if (count == 0) {
            cursor_.remark(where, "colours that are no numbers are left out", cursor_.restOfLine());
            return std::nullopt;
        }
        if (count == 2) { cursor_.remark(where, "colours of two numbers: blue is taken as green"); }
        for (int i = count; i < 3; ++i) {
            rgb[i] = rgb[count - 1];
        }
        leaveOutRest(where);
        return fmt::format("{} {} {}", rgb[0], rgb[1], rgb[2]);
    }

    std::optional<std::string> readNumber(const char* where, uint32_t bit) {
        float number = 0.0f;
        cursor_.atLineEnd();
        const char* begin = cursor_.position();
        if (cursor_.word() != "-halo") { cursor_.setPosition(begin); }
        if (cursor_.readSomeFloats(1, &number) == 0) {
            cursor_.remark(where, "values that are no number are left out", cursor_.restOfLine());
            return std::nullopt;
        }
        leaveOutRest(where);
        if (bit == static_cast<uint32_t>(MtlKey::Tr) && !skips_) { file_.entries.back().tr = number; }
        return fmt::format("{}", number);
    }

    /// The options with all their values, then the file's name. They may stand behind the name, too.
    std::optional<std::string> readMap(const char* where) {
        std::string options = readOptions(where, cursor_);
        std::string name(cursor_.restOfLine());
        for (const MapOption& option : kOptions) {
            const size_t at = name.find(fmt::format(" {} ", option.name));
            if (at == std::string::npos || at == 0) { continue; }
            const std::string rest = name.substr(at);
            TextCursor behind(rest, rest);
            options += readOptions(where, behind);
            name.resize(at);
        }
        if (name.empty()) {
            cursor_.remark(where, "maps without a file name are left out");
            return std::nullopt;
        }
        return options + name;
    }

    std::string readOptions(const char* where, TextCursor& cursor) {
        std::string out;
        while (!cursor.atLineEnd()) {
            const char* begin = cursor.position();
            const std::string_view word = cursor.word();
            const auto option = std::find_if(std::begin(kOptions), std::end(kOptions),
                                             [&](const MapOption& known) { return known.name == word; });
            if (option == std::end(kOptions)) {
                cursor.setPosition(begin);
                break;
            }
            if (option->numbers == 0) {
                const std::string_view value = cursor.word();
                if (option->counts) { out += fmt::format("{} {} ", option->name, value); }
                continue;
            }
            float values[3] = {option->missing, option->missing, option->missing};
            if (cursor.readSomeFloats(option->numbers, values) == 0) {
                cursor_.remark(where, "options of maps without a value are left out", word);
            } else if (option->counts) {
                out += fmt::format("{} {} ", option->name, fmt::join(values, values + option->numbers, " "));
            } else if (word == "-t") {
                cursor_.remark(where, "options of maps that Glint does not know are left out", word);
            }
        }
        return out;
    }

    void leaveOutRest(const char* where) {
        if (!cursor_.atLineEnd()) {
            cursor_.remark(where, "more on a line than it can have is left out", cursor_.restOfLine());
        }
    }

    static constexpr std::string_view kUnusedMap = "maps of kinds that Glint does not draw are left out";

    TextCursor cursor_;
    MtlFile file_;
    std::set<std::string> names_;
    bool skips_ = false;  ///< the present material is a repeated one
};

}  // namespace

tinyobj::material_t MtlEntry::values() const {
    std::map<std::string, int> indices;
    std::vector<tinyobj::material_t> found;
    std::string ignoredWarning, ignoredError;
    std::istringstream stream("newmtl it\n" + lines);  // its own name may hold anything
    tinyobj::LoadMtl(&indices, &found, &stream, &ignoredWarning, &ignoredError);
    return found.at(0);
}

MtlFile readMtlEntries(const std::string& text, const std::string& path) {
    return MtlReader(text, path).run();
}

}  // namespace glint
