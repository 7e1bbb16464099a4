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

#include "engine/io/spectrum_colors.h"
#include "engine/io/text_cursor.h"

namespace glint {
namespace {

enum class Form { Color, Number, Map, UnusedMap, Silent };

struct Key {
    std::string_view name;  ///< as tinyobjloader knows it
    Form form;
};

/// First those of MtlKey, in its order.
constexpr Key kKeys[] = {{"Kd", Form::Color},       {"Ks", Form::Color},         {"Ke", Form::Color},
                         {"Tf", Form::Color},       {"Ns", Form::Number},        {"Ni", Form::Number},
                         {"d", Form::Number},       {"Tr", Form::Number},        {"illum", Form::Number},
                         {"Pr", Form::Number},      {"Pm", Form::Number},        {"Ps", Form::Number},
                         {"Pc", Form::Number},      {"Pcr", Form::Number},       {"aniso", Form::Number},
                         {"anisor", Form::Number},  {"map_Kd", Form::Map},       {"map_Ke", Form::Map},
                         {"map_d", Form::Map},      {"map_Bump", Form::Map},     {"bump", Form::Map},
                         {"norm", Form::Map},       {"map_Pr", Form::Map},       {"map_Pm", Form::Map},
                         {"Kt", Form::Color},       {"map_Ka", Form::Silent},    {"Ka", Form::Silent},
                         {"Km", Form::Silent},      {"sharpness", Form::Silent}, {"map_aat", Form::Silent},
                         {"disp", Form::UnusedMap}, {"decal", Form::UnusedMap},  {"refl", Form::UnusedMap}};

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

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

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
            if (word != "newmtl") { cursor_.remark(where, kOtherCase, word); }
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
            if (!isUsual) { cursor_.remark(where, kOtherCase, word); }
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
        if (key.form == Form::Map) {
            file_.entries.back().mapLines.emplace_back(static_cast<MtlKey>(bit), cursor_.lineOf(where));
        }
        const bool isTint = key.name == "Kt";
        file_.entries.back().given |= 1u << (isTint ? static_cast<uint32_t>(MtlKey::Tf) : bit);
        file_.entries.back().lines += fmt::format("{} {}\n", key.name, *line);
    }

    std::optional<std::string> readColor(const char* where) {
        cursor_.atLineEnd();
        const char* begin = cursor_.position();
        const bool isXyz = sameWord(cursor_.word(), "xyz");
        if (!isXyz) { cursor_.setPosition(begin); }
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
        const Vec3 color = isXyz ? rgbOfXyz({rgb[0], rgb[1], rgb[2]}) : Vec3(rgb[0], rgb[1], rgb[2]);
        return fmt::format("{} {} {}", color.x, color.y, color.z);
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
            behind.word();
            float ignored = 0.0f;
            // "a -s 2.png" is a name.
            if (option.numbers > 0 && behind.readSomeFloats(1, &ignored) == 0) { continue; }
            behind.setPosition(rest.data());
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
                                             [&](const auto& known) { return sameWord(known.name, word); });
            if (option != std::end(kOptions)) {
                out += option->numbers == 0 ? readWordOption(where, *option, cursor)
                                            : readNumberOption(where, *option, cursor);
            } else if (word.size() > 1 && word[0] == '-' && !cursor.atLineEnd() && isLetter(word[1])) {
                cursor_.remark(where, kUnknownOption, word);
                float ignored[3];
                cursor.readSomeFloats(3, ignored);
            } else {
                cursor.setPosition(begin);
                break;
            }
        }
        return out;
    }

    /// A word that the option cannot have is the file's name: -clamp alone is on, other options are left out.
    std::string readWordOption(const char* where, const MapOption& option, TextCursor& cursor) {
        cursor.atLineEnd();
        const char* begin = cursor.position();
        std::string_view value = cursor.word();
        const auto isOneOf = [&](std::initializer_list<std::string_view> words) {
            return std::ranges::any_of(words, [&](std::string_view word) { return sameWord(word, value); });
        };
        const bool isSwitch = option.name == "-clamp";
        const bool isKnown = isSwitch                    ? isOneOf({"on", "off"})
                             : option.name == "-imfchan" ? isOneOf({"r", "g", "b", "m", "l", "z"})
                                                         : true;
        if (!isKnown) {
            cursor.setPosition(begin);
            cursor_.remark(where, kNoValue, option.name);
            value = "on";
        }
        const bool counts = option.counts && (isKnown || isSwitch);
        return counts ? fmt::format("{} {} ", option.name, value) : "";
    }

    std::string readNumberOption(const char* where, const MapOption& option, TextCursor& cursor) {
        float values[3] = {option.missing, option.missing, option.missing};
        if (cursor.readSomeFloats(option.numbers, values) == 0) {
            cursor_.remark(where, kNoValue, option.name);
        } else if (option.counts) {
            return fmt::format("{} {} ", option.name, fmt::join(values, values + option.numbers, " "));
        } else if (option.name == "-t") {
            cursor_.remark(where, kUnknownOption, option.name);
        }
        return "";
    }

    void leaveOutRest(const char* where) {
        if (!cursor_.atLineEnd()) {
            cursor_.remark(where, "more on a line than it can have is left out", cursor_.restOfLine());
        }
    }

    static constexpr std::string_view kOtherCase = "keywords in other case";
    static constexpr std::string_view kNoValue = "options of maps without a value are left out";
    static constexpr std::string_view kUnknownOption =
        "options of maps that Glint does not know are left out";
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
