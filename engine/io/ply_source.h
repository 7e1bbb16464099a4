// Where the numbers of a PLY body come from: text or bytes, behind the same few functions. For
// ply_loader.cpp only.
//
// A source reads one scalar after the other and knows the place of the last one. Nothing here knows what
// they mean.
#pragma once

#include <cstring>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "engine/io/ply_header.h"
#include "engine/io/text_cursor.h"

namespace glint {

/// Records are lines, unless the text has more lines than records, which then go on over line ends, or fewer,
/// which then hold several: what is right is found out where a line first has too few or too many numbers.
class PlyTextSource {
  public:
    /// `records`: elements that have properties.
    PlyTextSource(const std::string& bytes, const std::string& path, size_t offset, uint64_t records)
        : cursor_(bytes, path), recordsLeft_(records) {
        cursor_.setPosition(bytes.data() + offset);
    }

    /// The fewest bytes that `count` scalars of a type take: a digit and what parts it from the next one.
    static uint64_t leastBytes(PlyType, uint64_t count) { return 2 * count; }
    uint64_t bytesLeft() const { return 1 + static_cast<uint64_t>(cursor_.end() - cursor_.position()); }

    /// False, with error(), at the text's end.
    bool beginRecord() {
        skipEmptyLines();
        last_ = record_ = cursor_.position();
        return !cursor_.atEnd() || cursor_.fail(last_, "the file ends too early");
    }
    bool endRecord() {
        if (!cursor_.atLineEnd() && linesBeyondRecords() >= 0) {
            cursor_.remark(cursor_.position(),
                           "more numbers on a line than the header promises are left out");
            cursor_.restOfLine();
        }
        --recordsLeft_;
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
    void skipEmptyLines() {
        while (!cursor_.atEnd() && cursor_.atLineEnd()) {
            cursor_.nextLine();
        }
    }
    /// To the next line, where a record ends too early on its own.
    void goOn() {
        if (!cursor_.atLineEnd() || linesBeyondRecords() <= 0) { return; }
        cursor_.remark(cursor_.position(), "elements are written over several lines");
        skipEmptyLines();
    }
    /// How many more lines than records are left, with the present record's: counted once, since the two run
    /// on together afterwards.
    int64_t linesBeyondRecords() {
        if (!linesBeyondRecords_) {
            TextCursor ahead = cursor_;
            int64_t lines = 0;
            for (ahead.setPosition(record_); !ahead.atEnd(); ahead.nextLine()) {
                lines += ahead.atLineEnd() ? 0 : 1;
            }
            linesBeyondRecords_ = lines - static_cast<int64_t>(recordsLeft_);
        }
        return *linesBeyondRecords_;
    }

    TextCursor cursor_;
    const char* last_ = nullptr;
    const char* record_ = nullptr;  ///< where the present one begins
    uint64_t recordsLeft_ = 0;      ///< with the present one
    std::optional<int64_t> linesBeyondRecords_;
};

class PlyBinarySource {
  public:
    PlyBinarySource(const std::string& bytes, const std::string& path, size_t offset, bool bigEndian)
        : bytes_(bytes), path_(path), at_(offset), last_(offset), bigEndian_(bigEndian) {}

    static uint64_t leastBytes(PlyType type, uint64_t count) { return sizeOf(type) * count; }
    uint64_t bytesLeft() const { return bytes_.size() - at_; }

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
