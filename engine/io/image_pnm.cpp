// The pictures of Netpbm: grey (P2, P5) and colour (P3, P6), as text and binary.
#include <algorithm>
#include <charconv>

#include "engine/io/image_builder.h"
#include "engine/io/image_formats.h"

namespace glint {
namespace {

bool looksLike(std::string_view head) {
    return head.size() > 2 && head[0] == 'P' &&
           std::string_view("2356").find(head[1]) != std::string_view::npos &&
           std::string_view(" \t\r\n#").find(head[2]) != std::string_view::npos;
}

/// Numbers written as text, with comments between them.
class Numbers {
  public:
    explicit Numbers(std::string_view text) : rest_(text) {}

    /// The next number; 0 at the end, or where there is something else.
    uint32_t next() {
        skip();
        uint32_t number = 0;
        const auto [end, code] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
        failed_ |= code != std::errc();
        rest_.remove_prefix(static_cast<size_t>(end - rest_.data()));
        return failed_ ? 0 : number;
    }
    bool failed() const { return failed_; }
    /// What follows the one blank behind the last number.
    std::string_view rest() const { return rest_.substr(std::min<size_t>(1, rest_.size())); }

  private:
    void skip() {
        while (!rest_.empty()) {
            rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n\v\f"), rest_.size()));
            if (!rest_.starts_with('#')) { return; }
            rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
        }
    }

    std::string_view rest_;
    bool failed_ = false;
};

/// The samples of the picture, one after the other, as shares of 255.
class Samples {
  public:
    Samples(const Numbers& header, bool text, uint32_t most)
        : text_(header.rest()), bytes_(header.rest()), most_(most), isText_(text) {}

    uint8_t next() {
        uint32_t value = 0;
        if (isText_) {
            value = text_.next();
            failed_ |= text_.failed();
        } else {
            for (int i = 0; i < (most_ > 255 ? 2 : 1); ++i) {
                failed_ |= bytes_.empty();
                value = value << 8 | (failed_ ? 0 : static_cast<uint8_t>(bytes_.front()));
                bytes_.remove_prefix(failed_ ? 0 : 1);
            }
        }
        return static_cast<uint8_t>((std::min(value, most_) * 255 + most_ / 2) / most_);
    }
    bool failed() const { return failed_; }

  private:
    Numbers text_;
    std::string_view bytes_;
    uint32_t most_;
    bool isText_;
    bool failed_ = false;
};

Result<SceneImage> decode(const std::string& bytes, const std::string& path) {
    if (!looksLike(bytes)) { return brokenImage(path, "it does not begin with P2, P3, P5 or P6"); }
    const bool isText = bytes[1] == '2' || bytes[1] == '3';
    const bool isGrey = bytes[1] == '2' || bytes[1] == '5';
    Numbers header(std::string_view(bytes).substr(2));
    const uint32_t width = header.next();
    const uint32_t height = header.next();
    const uint32_t most = header.next();
    if (header.failed() || most == 0 || most > 65535) { return brokenImage(path, "its header is wrong"); }
    if (Status size = checkStatedSize(path, width, height, bytes.size(), 1.0); !size) { return size.error(); }
    Samples samples(header, isText, most);
    Image8Builder builder({static_cast<int>(width), static_cast<int>(height)});
    std::vector<uint8_t> rgba(size_t{4} * width, 255);
    for (uint32_t row = 0; row < height; ++row) {
        for (size_t x = 0; x < width; ++x) {
            const uint8_t first = samples.next();
            rgba[4 * x] = first;
            rgba[4 * x + 1] = isGrey ? first : samples.next();
            rgba[4 * x + 2] = isGrey ? first : samples.next();
        }
        builder.setRow(static_cast<int>(row), rgba);
    }
    return samples.failed() ? Result<SceneImage>(brokenImage(path, "the file ends too early"))
                            : builder.take();
}

}  // namespace

extern const ImageFormat kImagePnm;
const ImageFormat kImagePnm{.name = "PNM",
                            .extensions = ".pgm .ppm .pnm",
                            .looksLike = looksLike,
                            .decode = decode,
                            .isListed = false};

}  // namespace glint
