#include "engine/io/image_formats.h"

#include <vector>

#include "engine/base/nearest_name.h"
#include "engine/io/file_kind.h"

namespace glint {

extern const ImageFormat kImagePng, kImageJpeg, kImageBmp, kImageTga, kImageTiff, kImageWebp, kImageDds,
    kImageHdr, kImageExr, kImageGif, kImagePnm, kImagePfm, kImagePsd, kImageSoftimage;

namespace {

std::string_view savedExtension(const ImageFormat& format) {
    return format.extensions.substr(0, format.extensions.find(' '));
}

}  // namespace

std::span<const ImageFormat> imageFormats() {
    static const ImageFormat kAll[] = {kImagePng,  kImageJpeg, kImageBmp, kImageTga,      kImageTiff,
                                       kImageWebp, kImageDds,  kImageHdr, kImageExr,      kImageGif,
                                       kImagePnm,  kImagePfm,  kImagePsd, kImageSoftimage};
    return kAll;
}

const ImageFormat* imageFormatOf(const std::string& path, std::string_view bytes) {
    return kindOf(imageFormats(), path, headOf(bytes));
}

const ImageFormat* savedFormatOf(const std::string& path) {
    for (const ImageFormat& format : imageFormats()) {
        if (format.save != nullptr && extensionOf(path) == savedExtension(format)) { return &format; }
    }
    return nullptr;
}

std::string listReadableImages() {
    std::vector<std::string_view> names;
    for (const ImageFormat& format : imageFormats()) {
        names.push_back(format.name);
    }
    return joinNames(names);
}

std::string listSavedExtensions() {
    std::vector<std::string_view> extensions;
    for (const ImageFormat& format : imageFormats()) {
        if (format.save != nullptr) { extensions.push_back(savedExtension(format)); }
    }
    return joinNames(extensions);
}

}  // namespace glint
