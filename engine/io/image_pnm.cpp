// The pictures of Netpbm: black and white (P1, P4), grey (P2, P5) and colour (P3, P6), as text and binary,
// and with alpha (P7).
#include <algorithm>
#include <charconv>
#include <optional>

#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"

namespace glint {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

bool looksLike(std::string_view head) {
    return head.size() > 2 && head[0] == 'P' && head[1] >= '1' && head[1] <= '7' &&
           std::string_view(" \t\r\n#").find(head[2]) != std::string_view::npos;
}

/// Words and numbers written as text, with comments between them.
class Words {
  public:
    explicit Words(std::string_view text) : rest_(text) {}

    std::string_view next() {
        skip();
        return take(std::min(rest_.find_first_of(kBlanks), rest_.size()));
    }
    /// 0 at the end, or where there is something else.
    uint32_t number() {
        skip();
        uint32_t number = 0;
        const auto [end, code] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
        failed_ |= code != std::errc();
        take(static_cast<size_t>(end - rest_.data()));
        return failed_ ? 0 : number;
    }
    /// 0 or 1, which the next one may follow without a blank.
    uint32_t digit() {
        skip();
        failed_ |= rest_.empty() || (rest_[0] != '0' && rest_[0] != '1');
        return failed_ ? 0 : static_cast<uint32_t>(take(1)[0] - '0');
    }
    bool failed() const { return failed_; }
    /// What follows the one blank behind the last number.
    std::string_view rest() const { return rest_.substr(std::min<size_t>(1, rest_.size())); }

  private:
    std::string_view take(size_t count) {
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }
    void skip() {
        while (!rest_.empty()) {
            take(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
            if (!rest_.starts_with('#')) { return; }
            take(std::min(rest_.find('\n'), rest_.size()));
        }
    }

    std::string_view rest_;
    bool failed_ = false;
};

struct Header {
    uint32_t width = 0, height = 0;
    uint32_t most = 1;      ///< the value of white
    uint32_t channels = 1;  ///< grey, grey and alpha, colour, or colour and alpha
    bool isText = false;
    bool isBits = false;  ///< 1 is black
    std::string_view pixels;

    bool hasAlpha() const { return channels % 2 == 0; }
};

/// P7's lines, in any order.
bool readLines(Words* words, Header* header) {
    for (std::string_view key = words->next(); key != "ENDHDR"; key = words->next()) {
        uint32_t ignored = 0;
        uint32_t* value = key == "WIDTH"    ? &header->width
                          : key == "HEIGHT" ? &header->height
                          : key == "DEPTH"  ? &header->channels
                          : key == "MAXVAL" ? &header->most
                                            : &ignored;
        if (key == "TUPLTYPE") {
            words->next();
        } else if (key.empty() || value == &ignored) {
            return false;
        } else {
            *value = words->number();
        }
    }
    return true;
}

std::optional<Header> readHeader(std::string_view bytes) {
    const char kind = bytes[1];
    Header header{.channels = kind == '3' || kind == '6' ? 3u : 1u,
                  .isText = kind <= '3',
                  .isBits = kind == '1' || kind == '4',
                  .pixels = {}};
    Words words(bytes.substr(2));
    if (kind == '7') {
        if (!readLines(&words, &header)) { return std::nullopt; }
    } else {
        header.width = words.number();
        header.height = words.number();
        if (!header.isBits) { header.most = words.number(); }
    }
    header.pixels = words.rest();
    const bool isKnown =
        header.most > 0 && header.most <= 65535 && header.channels > 0 && header.channels <= 4;
    return words.failed() || !isKnown ? std::nullopt : std::optional(header);
}

/// The samples of the picture, one after the other, as shares of 255.
class Samples {
  public:
    explicit Samples(const Header& header) : header_(header), text_(header.pixels), bytes_(header.pixels) {}

    void beginRow() { bit_ = 0; }
    uint8_t next() {
        if (header_.isBits) { return (header_.isText ? text_.digit() : nextBit()) == 0 ? 255 : 0; }
        uint32_t value = header_.isText ? text_.number() : nextByte();
        if (!header_.isText && header_.most > 255) { value = value << 8 | nextByte(); }
        return static_cast<uint8_t>((std::min(value, header_.most) * 255 + header_.most / 2) / header_.most);
    }
    bool failed() const { return failed_ || text_.failed(); }

  private:
    uint32_t nextByte() {
        failed_ |= bytes_.empty();
        if (failed_) { return 0; }
        const auto byte = static_cast<uint8_t>(bytes_.front());
        bytes_.remove_prefix(1);
        return byte;
    }
    uint32_t nextBit() {
        if (bit_ == 0) {
            bits_ = nextByte();
            bit_ = 8;
        }
        return bits_ >> --bit_ & 1;
    }

    const Header& header_;
    Words text_;
    std::string_view bytes_;
    uint32_t bits_ = 0, bit_ = 0;
    bool failed_ = false;
};

Result<SceneImage> decode(const std::string& bytes, const std::string& path) {
    if (!looksLike(bytes)) { return brokenImage(path, "it does not begin with P1 to P7"); }
    const std::optional<Header> header = readHeader(bytes);
    if (!header) { return brokenImage(path, "its header is wrong"); }
    const double pixelsPerByte = header->isBits && !header->isText ? 8.0 : 1.0;
    if (Status size = checkStatedSize(path, header->width, header->height, bytes.size(), pixelsPerByte);
        !size) {
        return size.error();
    }
    Samples samples(*header);
    Image8Builder builder({static_cast<int>(header->width), static_cast<int>(header->height)});
    std::vector<uint8_t> rgba(size_t{4} * header->width, 255);
    for (uint32_t row = 0; row < header->height; ++row) {
        samples.beginRow();
        for (size_t x = 0; x < header->width; ++x) {
            const uint8_t first = samples.next();
            rgba[4 * x] = first;
            rgba[4 * x + 1] = header->channels < 3 ? first : samples.next();
            rgba[4 * x + 2] = header->channels < 3 ? first : samples.next();
            if (header->hasAlpha()) { rgba[4 * x + 3] = samples.next(); }
        }
        builder.setRow(static_cast<int>(row), rgba);
    }
    return samples.failed() ? Result<SceneImage>(brokenImage(path, "the file ends too early"))
                            : builder.take();
}

}  // namespace

extern const ImageFormat kImagePnm;
const ImageFormat kImagePnm{
    .name = "PNM", .extensions = ".pgm .ppm .pbm .pam .pnm", .looksLike = looksLike, .decode = decode};

}  // namespace glint
