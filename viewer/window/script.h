// Scripts that play the viewer's input. The language is described in README.md here.
//
// Parsing checks every statement's words before anything runs; what a statement does is
// script_player's business.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace glint {

struct ScriptWord {
    std::string text;
    int column = 1;
    bool quoted = false;
};

struct ScriptStatement {
    std::string verb;
    std::vector<ScriptWord> words;  ///< without the verb
    SourcePlace place;              ///< of the verb

    /// `message` at the n-th word.
    Error errorAt(size_t word, std::string message) const;
    Error error(std::string message) const { return {std::move(message), place}; }
    /// The word as a number; the parser has checked that it is one.
    float number(size_t word) const;
};

/// Error: an unknown verb (with the nearest), or words that the verb does not take, with line, column
/// and caret.
Result<std::vector<ScriptStatement>> parseScript(std::string_view text, const std::string& file);
Result<std::vector<ScriptStatement>> loadScript(const std::string& file);

}  // namespace glint
