// Walks the text of a pbrt file: blanks and comments, words, strings, numbers and lists. Internal to the pbrt
// importer (pbrt_*.cpp).
//
// Lines are counted on from the place asked for before, so that all places together cost one look at the
// text. The text is NUL-terminated, so that one character may be looked at beyond any position.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

struct PbrtPlace {
    uint32_t file = 0;  ///< its number
    uint32_t line = 0, column = 0;
};

class PbrtText {
  public:
    PbrtText(std::string text, uint32_t file);
    PbrtText(const PbrtText&) = delete;
    PbrtText& operator=(const PbrtText&) = delete;

    /// What follows blanks and comments; 0 at the end.
    char peek() {
        skipBlanks();
        return at_ == end_ ? '\0' : *at_;
    }
    bool atEnd() { return peek() == '\0' && at_ == end_; }
    /// Where what follows stands.
    PbrtPlace place();

    /// What follows up to a blank, quote, bracket or comment; a lone one of these otherwise. Empty at
    /// the end.
    std::string_view word();
    /// False, and nothing read, where no string follows that ends on its line or a later one.
    bool readString(std::string* out);
    /// False, and nothing read, where no finite number follows.
    bool readNumber(double* out);
    /// One, or a list in brackets, appended. False where something else follows or stands in it; `at` is
    /// then there.
    bool readFloats(std::vector<float>* out);
    bool readInts(std::vector<int>* out);
    bool readStrings(std::vector<std::string>* out);
    /// Whether a string follows, alone or as the first of a list.
    bool isStringNext();
    /// Goes beyond a string, a list in brackets or a word.
    void skipValue();

    const std::string& text() const { return text_; }
    uint32_t file() const { return file_; }
    /// The line of a number that counts from 1.
    std::string lineText(uint32_t line) const;
    /// Forgets a long text.
    void drop();

  private:
    void skipBlanks();
    bool isEndOfWord(const char* p) const;
    template <class Number>
    bool readOne(Number* out);
    template <class Read>
    bool readList(const Read& read);

    std::string text_;
    uint32_t file_;
    const char* at_;
    const char* end_;
    const char* countedTo_;
    const char* lineBegin_;
    uint32_t line_ = 1;
};

}  // namespace glint
