#include "viewer/window/script.h"

#include <cmath>
#include <cstdlib>
#include <optional>
#include <span>
#include <sstream>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/atomic_file.h"
#include "engine/io/plain_text.h"
#include "viewer/window/key_codes.h"

namespace glint {
namespace {

/// One way to write a statement: a letter for each word. n: number, c: whole number from 0 on, t: time in
/// seconds, s: text, q: text in quotes, b: mouse
/// button, k: key, u: up or down, w: a word of `choices`. A trailing '*' repeats the last letter, a '?'
/// before a letter makes it and the rest optional.
struct Form {
    std::string_view verb;
    std::string_view words;
    std::string_view usage;
    std::string_view choices = {};
};

constexpr Form kForms[] = {
    {"move", "nn", "move X Y"},
    {"move", "q?nn", "move \"LABEL\" [SHARE_X SHARE_Y]"},
    {"press", "?b", "press [left|right|middle]"},
    {"press", "nn?b", "press X Y [left|right|middle]"},
    {"release", "?b", "release [left|right|middle]"},
    {"click", "s", "click \"LABEL\""},
    {"click", "nn?b", "click X Y [BUTTON]"},
    {"drag", "snn", "drag \"LABEL\" DX DY"},
    {"drag", "nnnn?b", "drag X Y X Y [BUTTON]"},
    {"wheel", "n?nn", "wheel STEPS [X Y]"},
    {"key", "k?u", "key NAME [down|up]"},
    {"text", "s", "text \"CHARACTERS\""},
    {"open", "s", "open \"SECTION\""},
    {"close", "s", "close \"SECTION\""},
    {"set", "ss*", "set \"LABEL\" VALUE…"},
    {"wait", "wc", "wait passes|frames N", "passes frames"},
    {"wait", "wt", "wait seconds N", "seconds"},
    {"wait", "w", "wait picture|jobs|finished|paused", "picture jobs finished paused"},
    {"drop", "s", "drop \"FILE\""},
    {"screenshot", "s", "screenshot \"FILE\""},
    {"print", "s", "print status|widgets|\"LABEL\""},
    {"mark", "", "mark"},
    {"expect", "wc", "expect COUNTER N",
     "restarts allocations material-tables texture-tables light-tables feature-scans mesh-builds "
     "top-level-builds"},
    {"expect", "ww", "expect state NAME", "state empty building rendering paused finished failed"},
    {"expect", "wc", "expect passes-at-least N", "passes-at-least"},
    {"expect", "ws", "expect widget|no-widget|error|message \"TEXT\"", "widget no-widget error message"},
    {"expect", "w", "expect no-error", "no-error"},
    {"expect", "ss*", "expect \"LABEL\" VALUE…"},
    {"quit", "", "quit"},
};

std::optional<float> asNumber(const ScriptWord& word) {
    char* end = nullptr;
    const float value = std::strtof(word.text.c_str(), &end);
    if (word.quoted || word.text.empty() || *end != '\0' || !std::isfinite(value)) { return std::nullopt; }
    return value;
}

bool isCount(const ScriptWord& word) {
    constexpr float kMost = 16777216.0f;  // up to which a float holds every whole number
    const auto value = asNumber(word);
    return value && *value >= 0.0f && *value <= kMost && std::floor(*value) == *value;
}

bool isChoice(const ScriptWord& word, std::string_view choices) {
    if (word.quoted) { return false; }
    const std::string padded = fmt::format(" {} ", choices);
    return padded.find(fmt::format(" {} ", word.text)) != std::string::npos;
}

bool fits(const ScriptWord& word, char letter, const Form& form) {
    switch (letter) {
        case 'n':
            return asNumber(word).has_value();
        case 'c':
            return isCount(word);
        case 't':
            return asNumber(word).value_or(-1.0f) >= 0.0f;
        case 'q':
            return word.quoted;
        case 'b':
            return isChoice(word, "left right middle");
        case 'u':
            return isChoice(word, "down up");
        case 'k':
            return keyCode(word.text).has_value();
        case 'w':
            return isChoice(word, form.choices);
        default:
            return true;
    }
}

/// How many words of the statement fit; as many as it has when the form matches wholly.
struct Match {
    bool whole = false;
    size_t fitting = 0;
};

Match match(const ScriptStatement& statement, const Form& form) {
    size_t word = 0;
    bool optional = false;
    for (size_t i = 0; i < form.words.size(); ++i) {
        if (form.words[i] == '?') {
            optional = true;
            continue;
        }
        const bool repeats = form.words[i] == '*';
        const char letter = repeats ? form.words[i - 1] : form.words[i];
        if (word == statement.words.size()) { return {optional || repeats, word}; }
        do {
            if (!fits(statement.words[word], letter, form)) { return {false, word}; }
            ++word;
        } while (repeats && word < statement.words.size());
    }
    return {word == statement.words.size(), word};
}

Status check(const ScriptStatement& statement) {
    std::vector<std::string_view> verbs;
    size_t furthest = 0;
    bool isKeyword = false;  // then what follows must be that keyword's
    std::string usages;
    for (const Form& form : kForms) {
        verbs.push_back(form.verb);
        if (form.verb != statement.verb) { continue; }
        const bool takesKeyword = form.words.starts_with('w');
        if (isKeyword && !takesKeyword) { continue; }
        const Match matched = match(statement, form);
        if (matched.whole) { return {}; }
        isKeyword = isKeyword || (takesKeyword && matched.fitting > 0);
        furthest = std::max(furthest, matched.fitting);
        usages += (usages.empty() ? "" : "  or  ") + std::string(form.usage);
    }
    if (usages.empty()) {
        return statement.error(
            fmt::format("unknown statement \"{}\"{}", statement.verb, didYouMean(statement.verb, verbs)));
    }
    const std::string what = furthest < statement.words.size()
                                 ? fmt::format("\"{}\" does not fit here", statement.words[furthest].text)
                                 : std::string("the statement is incomplete");
    return statement.errorAt(furthest, fmt::format("{}; expected: {}", what, usages));
}

Result<std::vector<ScriptWord>> splitWords(std::string_view line, const SourcePlace& place) {
    std::vector<ScriptWord> words;
    size_t i = 0;
    while (i < line.size()) {
        if (line[i] == ' ' || line[i] == '\t' || line[i] == '\r') {
            ++i;
            continue;
        }
        if (line[i] == '#') { break; }
        ScriptWord word{.text = "", .column = static_cast<int>(i) + 1, .quoted = line[i] == '"'};
        const size_t end = word.quoted ? line.find('"', i + 1) : line.find_first_of(" \t\r", i);
        if (word.quoted && end == std::string_view::npos) {
            SourcePlace at = place;
            at.column = word.column;
            return Error{"the text has no closing \"", at};
        }
        const size_t begin = i + (word.quoted ? 1 : 0);
        word.text = std::string(line.substr(begin, end == std::string_view::npos ? end : end - begin));
        words.push_back(std::move(word));
        i = end == std::string_view::npos ? line.size() : end + (words.back().quoted ? 1 : 0);
    }
    return words;
}

}  // namespace

Error ScriptStatement::errorAt(size_t word, std::string message) const {
    SourcePlace at = place;
    if (word < words.size()) {
        at.column = words[word].column;
    } else if (!words.empty()) {
        at.column = static_cast<int>(at.lineText.size()) + 1;
    }
    return {std::move(message), at};
}

float ScriptStatement::number(size_t word) const { return asNumber(words[word]).value_or(0.0f); }

Result<std::vector<ScriptStatement>> parseScript(std::string_view text, const std::string& file) {
    std::vector<ScriptStatement> statements;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        SourcePlace place{file, number, 1, line};
        if (const size_t at = line.find('\0'); at != std::string::npos) {
            place.column = static_cast<int>(at) + 1;
            return Error{"a byte is 0; expected text", place};
        }
        auto words = splitWords(line, place);
        if (!words) { return words.error(); }
        if (words->empty()) { continue; }
        place.column = words->front().column;
        ScriptStatement statement{words->front().text, {words->begin() + 1, words->end()}, place};
        if (Status checked = check(statement); !checked) { return checked.error(); }
        statements.push_back(std::move(statement));
    }
    return statements;
}

Result<std::vector<ScriptStatement>> loadScript(const std::string& file) {
    const auto text = readFile(file);
    if (!text) { return text.error(); }
    const std::optional<PlainText> plain = asPlainText(*text);
    std::string_view script = plain ? plain->text : *text;
    if (script.starts_with("\xEF\xBB\xBF")) { script.remove_prefix(3); }
    return parseScript(script, file);
}

}  // namespace glint
