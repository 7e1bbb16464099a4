// Walks a text file word by word and line by line, and says where in it something is wrong. For OBJ, MTL
// and PLY.
//
// A backslash at the end of a line joins it with the next one, also with blanks behind it; `#` at the start
// of a word begins a comment. Reading counts no lines: a place is found only when there is something to
// report, so that large files read fast, and counted on from the place found before, so that many remarks
// do, too.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/io/remarks.h"

namespace glint {

class TextCursor {
  public:
    /// Both must outlive the cursor.
    TextCursor(const std::string& text, const std::string& file);

    const char* position() const { return at_; }
    void setPosition(const char* at) { at_ = at; }
    const char* end() const { return end_; }

    /// True at the end of the text.
    bool atEnd() const { return at_ == end_; }
    /// Skips blanks; true when nothing but a comment is left on the line.
    bool atLineEnd();
    /// Goes to the first character of the next line, whatever is left on this one.
    void nextLine();

    /// The next run of characters without blanks; empty at the line's end.
    std::string_view word();
    /// What is left of the line, without blanks around it; a comment is not cut off.
    std::string_view restOfLine();

    /// Reads a number into `out`, a finite one unless `mayBeInfinite`, which also lets NaN through. False,
    /// with error() set, when the next word is none; `what` names it there.
    bool readFloat(const char* what, float* out, bool mayBeInfinite = false);
    /// Also takes 3.0 for 3, with a remark.
    bool readInt(const char* what, int64_t* out);
    /// Reads numbers up to the line's end or the first word that is none, at most `most`, and says how many;
    /// what is not finite becomes 0, with a remark.
    int readSomeFloats(int most, float* out);
    /// False, with error() set, when there is something left on the line.
    bool expectLineEnd(const char* after);

    /// Sets error() and returns false.
    bool fail(const char* where, std::string message);
    const Error& error() const { return *error_; }

    /// The line and column of a position in the text, with the whole line.
    SourcePlace placeOf(const char* where) const;
    int lineOf(const char* where) const;
    /// Notes what was repaired at a position (Remarks::add).
    void remark(const char* where, std::string_view kind, std::string_view detail = {});
    const Remarks& remarks() const { return remarks_; }
    /// How many characters the look-ups of lines have gone over: for tests of linear time.
    uint64_t charactersCounted() const { return charactersCounted_; }

  private:
    bool atBlank() const;
    bool isWordEnd(const char* p) const;
    std::string_view wordAt(const char* p) const;

    const char* begin_;
    const char* end_;
    const char* at_;
    const std::string& file_;
    std::optional<Error> error_;
    Remarks remarks_;
    mutable const char* countedTo_;  ///< the last position whose line was asked for
    mutable int countedLine_ = 1;    ///< its line
    mutable uint64_t charactersCounted_ = 0;
};

}  // namespace glint
