#include "engine/render/checkpoint_sections.h"

#include <utility>

#include <fmt/format.h>

#include "engine/base/content_hash.h"

namespace glint {
namespace {

constexpr std::string_view kMagic = "GLINTCKP";
constexpr uint32_t kFormatVersion = 2;
constexpr size_t kSizeAt = kMagic.size() + sizeof(kFormatVersion);
constexpr uint64_t kChecksumBytes = 16;

std::string checksumOf(std::string_view bytes) {
    ContentHash hash;
    hash.add(bytes);
    const Hash128 sum = hash.finish();
    ByteWriter out;
    out.write(sum.low);
    out.write(sum.high);
    return out.bytes();
}

}  // namespace

Error checkpointError(const std::string& path, std::string message) {
    return {std::move(message), {.file = path}};
}

CheckpointWriter::CheckpointWriter(size_t bytes) {
    file_.reserve(bytes);
    file_.writeRaw(kMagic);
    file_.write(kFormatVersion);
    file_.write(uint64_t{0});
}

const std::string& CheckpointWriter::finish() {
    file_.overwrite(kSizeAt, static_cast<uint64_t>(file_.bytes().size() + kChecksumBytes));
    file_.writeRaw(checksumOf(file_.bytes()));
    return file_.bytes();
}

bool looksLikeCheckpoint(std::string_view head) { return head.starts_with(kMagic); }

Result<CheckpointSections> findSections(std::string_view bytes, const std::string& path) {
    ByteReader in(bytes);
    if (in.readRaw(kMagic.size()) != kMagic) {
        return checkpointError(path, "is not a Glint checkpoint (its first bytes are not GLINTCKP)");
    }
    const uint32_t version = in.read<uint32_t>();
    const uint64_t size = in.read<uint64_t>();
    if (!in.failed() && version != kFormatVersion) {
        return checkpointError(path, fmt::format("has checkpoint format {}; this program reads format {}",
                                                 version, kFormatVersion));
    }
    if (in.failed() || size != bytes.size() || in.left() < kChecksumBytes) {
        return checkpointError(path, fmt::format("is cut off or damaged: it has {} bytes and should have {}",
                                                 bytes.size(), size));
    }
    const std::string_view summed = bytes.substr(0, bytes.size() - kChecksumBytes);
    if (bytes.substr(summed.size()) != checksumOf(summed)) {
        return checkpointError(path, "is damaged: its checksum is wrong");
    }
    CheckpointSections sections;
    while (!in.failed() && in.left() > kChecksumBytes) {
        const std::string tag(in.readRaw(4));
        sections[tag] = in.readRaw(in.read<uint64_t>());
    }
    if (in.failed() || in.left() != kChecksumBytes) {
        return checkpointError(path, "is damaged: a section is longer than the file");
    }
    return sections;
}

}  // namespace glint
