#include "engine/io/gzip_file.h"

#include <algorithm>

#include <zlib.h>

#include "engine/io/atomic_file.h"

namespace glint {
namespace {

constexpr size_t kMostUnpacked = size_t{1} << 30;
constexpr size_t kChunk = size_t{1} << 20;
constexpr int kGzipOnly = 16 + MAX_WBITS;

/// False: broken, or more than kMostUnpacked. Members that follow each other are one text.
bool unpack(const std::string& packed, std::string* out) {
    z_stream stream{};
    if (inflateInit2(&stream, kGzipOnly) != Z_OK) { return false; }
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));  // zlib only reads it
    size_t left = packed.size();
    std::string chunk(kChunk, '\0');
    int state = Z_OK;
    while (state == Z_OK) {
        if (stream.avail_in == 0) {
            stream.avail_in = static_cast<uInt>(std::min<size_t>(left, kChunk));
            left -= stream.avail_in;
        }
        stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
        stream.avail_out = static_cast<uInt>(chunk.size());
        state = inflate(&stream, Z_NO_FLUSH);
        const size_t got = chunk.size() - stream.avail_out;
        if (out->size() + got > kMostUnpacked) { state = Z_MEM_ERROR; }
        if (state == Z_OK || state == Z_STREAM_END) { out->append(chunk, 0, got); }
        if (state == Z_STREAM_END && left + stream.avail_in > 0) { state = inflateReset(&stream); }
    }
    inflateEnd(&stream);
    return state == Z_STREAM_END;
}

}  // namespace

Result<std::string> readUnpacked(const std::string& path) {
    Result<std::string> bytes = readFile(path);
    if (!bytes || !bytes->starts_with("\x1f\x8b")) { return bytes; }
    std::string out;
    if (!unpack(*bytes, &out)) {
        return Error{"is broken or cut off as gzip has it, or holds more than 1 GiB", {.file = path}};
    }
    return out;
}

}  // namespace glint
