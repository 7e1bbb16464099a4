// Where the numbers of a PLY body come from: text or bytes, behind the same few functions. For
// ply_loader.cpp only.
//
// A source reads one scalar after the other and knows the place of the last one. Nothing here knows what
// they mean.
#pragma once

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "engine/io/ply_header.h"
#include "engine/io/text_cursor.h"

namespace glint {

/// Records are lines, unless all numbers of the text are what the header promises wherever its lines end:
/// found out where a line first has too few or too many of them.
class PlyTextSource {
  public:
    struct Place {
        const char* at;
        uint64_t recordsBefore;
    };

    PlyTextSource(const std::string& bytes, const std::string& path, const PlyHeader& header)
        : header_(header), cursor_(bytes, path) {
        cursor_.setPosition(bytes.data() + header.bodyOffset);
    }

    /// The fewest bytes that `count` scalars of a type take: a digit and what parts it from the next one.
    static uint64_t leastBytes(PlyType, uint64_t count) { return 2 * count; }
    uint64_t bytesLeft() const { return 1 + static_cast<uint64_t>(cursor_.end() - cursor_.position()); }

    /// Between two records.
    Place place() const { return {cursor_.position(), recordsBefore_}; }
    void goTo(const Place& place) {
        cursor_.setPosition(place.at);
        recordsBefore_ = place.recordsBefore;
    }

    /// False, with error(), at the text's end.
    bool beginRecord() {
        skipEmptyLines(&cursor_);
        last_ = record_ = cursor_.position();
        return !cursor_.atEnd() || cursor_.fail(last_, "the file ends too early");
    }
    bool endRecord() {
        if (!cursor_.atLineEnd() && !isFree()) {
            cursor_.remark(cursor_.position(),
                           "more numbers on a line than the header promises are left out");
            cursor_.restOfLine();
        }
        ++recordsBefore_;
        return true;
    }

    bool read(PlyType type, const char* what, double* out) {
        goOn();
        last_ = cursor_.position();
        if (isFloat(type)) {
            float number = 0.0f;
            const bool ok = cursor_.readFloat(what, &number, true);
            *out = static_cast<double>(number);
            return ok;
        }
        int64_t number = 0;
        const bool ok = cursor_.readInt(what, &number);
        *out = static_cast<double>(number);
        return ok;
    }
    bool skip(PlyType) {
        goOn();
        last_ = cursor_.position();
        return !cursor_.word().empty() || cursor_.fail(last_, "expected another number, but the line ends");
    }
    bool fail(const std::string& message) { return cursor_.fail(last_, message); }
    const Error& error() const { return cursor_.error(); }
    void remark(std::string_view kind) { cursor_.remark(last_, kind); }
    const Remarks& remarks() const { return cursor_.remarks(); }

  private:
    static void skipEmptyLines(TextCursor* cursor) {
        while (!cursor->atEnd() && cursor->atLineEnd()) {
            cursor->nextLine();
        }
    }
    /// To the next line, where a record may end too early on its own.
    void goOn() {
        if (!cursor_.atLineEnd() || !isFree()) { return; }
        cursor_.remark(cursor_.position(), "elements are written over several lines");
        skipEmptyLines(&cursor_);
    }
    bool isFree() {
        if (!isFree_) { isFree_ = fitsFreely(); }
        return *isFree_;
    }
    /// Whether the text from the present record on has as many numbers as the header promises. The records
    /// before it are lines, and would be the same ones.
    bool fitsFreely() const {
        TextCursor ahead = cursor_;
        ahead.setPosition(record_);
        uint64_t passed = recordsBefore_;
        for (const PlyElement& element : header_.elements) {
            if (element.properties.empty()) { continue; }
            const uint64_t first = std::min(passed, element.count);
            passed -= first;
            for (uint64_t i = first; i < element.count; ++i) {
                for (const PlyProperty& property : element.properties) {
                    if (!skipFreely(property, &ahead)) { return false; }
                }
            }
        }
        skipEmptyLines(&ahead);
        return ahead.atEnd();
    }
    static bool skipFreely(const PlyProperty& property, TextCursor* ahead) {
        int64_t count = 1;
        skipEmptyLines(ahead);
        if (property.isList && (!ahead->readInt("", &count) || count < 0)) { return false; }
        for (int64_t i = 0; i < count; ++i) {
            skipEmptyLines(ahead);
            if (ahead->word().empty()) { return false; }
        }
        return true;
    }

    const PlyHeader& header_;
    TextCursor cursor_;
    const char* last_ = nullptr;
    const char* record_ = nullptr;  ///< where the present one begins
    uint64_t recordsBefore_ = 0;    ///< of elements that have properties
    std::optional<bool> isFree_;
};

class PlyBinarySource {
  public:
    PlyBinarySource(const std::string& bytes, const std::string& path, size_t offset, bool bigEndian)
        : bytes_(bytes), path_(path), at_(offset), last_(offset), bigEndian_(bigEndian) {}

    static uint64_t leastBytes(PlyType type, uint64_t count) { return sizeOf(type) * count; }
    uint64_t bytesLeft() const { return bytes_.size() - at_; }

    using Place = size_t;
    Place place() const { return at_; }
    void goTo(Place place) { at_ = place; }

    bool beginRecord() { return true; }
    bool endRecord() { return true; }

    bool read(PlyType type, const char* what, double* out) {
        last_ = at_;
        const size_t size = sizeOf(type);
        if (bytesLeft() < size) { return fail(fmt::format("the file ends too early, in {}", what)); }
        unsigned char raw[8] = {};
        for (size_t i = 0; i < size; ++i) {
            raw[bigEndian_ ? size - 1 - i : i] = static_cast<unsigned char>(bytes_[at_ + i]);
        }
        at_ += size;
        *out = decode(type, raw);
        return true;
    }
    bool skip(PlyType type) {
        last_ = at_;
        if (bytesLeft() < sizeOf(type)) { return fail("the file ends too early"); }
        at_ += sizeOf(type);
        return true;
    }
    bool fail(const std::string& message) {
        error_ = Error{fmt::format("byte {}: {}", last_, message), {.file = path_}};
        return false;
    }
    const Error& error() const { return error_; }
    void remark(std::string_view kind) {
        remarks_.add(kind, [&] { return fmt::format("{}: byte {}", path_, last_); });
    }
    const Remarks& remarks() const { return remarks_; }

  private:
    template <class T>
    static double as(const unsigned char* raw) {
        T value;
        std::memcpy(&value, raw, sizeof value);
        return static_cast<double>(value);
    }
    static double decode(PlyType type, const unsigned char* raw) {
        switch (type) {
            case PlyType::Int8:
                return as<int8_t>(raw);
            case PlyType::Uint8:
                return as<uint8_t>(raw);
            case PlyType::Int16:
                return as<int16_t>(raw);
            case PlyType::Uint16:
                return as<uint16_t>(raw);
            case PlyType::Int32:
                return as<int32_t>(raw);
            case PlyType::Uint32:
                return as<uint32_t>(raw);
            case PlyType::Float32:
                return as<float>(raw);
            case PlyType::Float64:
                return as<double>(raw);
        }
        return 0.0;
    }

    const std::string& bytes_;
    const std::string& path_;
    size_t at_;
    size_t last_;
    bool bigEndian_;
    Error error_;
    Remarks remarks_;
};

}  // namespace glint
