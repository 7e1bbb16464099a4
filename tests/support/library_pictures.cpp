#include "tests/support/library_pictures.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <gif_lib.h>
#include <jpeglib.h>
#include <png.h>
#include <tiffio.h>

#include "tests/support/temp_folder.h"

namespace glint::test {
namespace {

void append(png_structp png, png_bytep bytes, size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

/// `rows` are as the colour type has them.
std::string png(int colorType, int bits, int interlace, const std::vector<std::string>& rows,
                const std::function<void(png_structp, png_infop)>& addChunks = {}) {
    std::string out;
    png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(writer);
    png_set_write_fn(writer, &out, append, nullptr);
    png_set_IHDR(writer, info, 6, 5, bits, colorType, interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (addChunks) { addChunks(writer, info); }
    png_write_info(writer, info);
    std::vector<png_bytep> pointers;
    for (const std::string& row : rows) {
        pointers.push_back(reinterpret_cast<png_bytep>(const_cast<char*>(row.data())));
    }
    png_write_image(writer, pointers.data());
    png_write_end(writer, info);
    png_destroy_write_struct(&writer, &info);
    return out;
}

std::vector<std::string> rowsOf(const Image8& image, bool withAlpha, bool wide) {
    std::vector<std::string> rows(static_cast<size_t>(image.height));
    for (size_t i = 0; i < image.rgb.size() / 3; ++i) {
        std::string& row = rows[i / static_cast<size_t>(image.width)];
        for (size_t c = 0; c < (withAlpha ? 4 : 3); ++c) {
            const uint8_t byte = c < 3 ? image.rgb[3 * i + c] : image.alpha[i];
            row += std::string(wide ? 2 : 1, static_cast<char>(byte));
        }
    }
    return rows;
}

constexpr unsigned char kColors[4][3] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {9, 8, 7}};

/// 6 x 5 pixels whose palette index is (x + y) % 4; index 3 is transparent.
Image8 paletteImage() {
    Image8 image{6, 5, {}};
    for (int i = 0; i < 30; ++i) {
        const auto index = static_cast<size_t>((i % 6 + i / 6) % 4);
        image.rgb.insert(image.rgb.end(), kColors[index], kColors[index] + 3);
        image.alpha.push_back(index == 3 ? 0 : 255);
    }
    return image;
}

std::vector<std::string> paletteRows() {
    std::vector<std::string> rows(5);
    for (int i = 0; i < 30; ++i) {
        rows[static_cast<size_t>(i / 6)] += static_cast<char>((i % 6 + i / 6) % 4);
    }
    return rows;
}

std::string jpeg(const Image8& image, bool progressive, const std::string& exif = "") {
    jpeg_compress_struct writer{};
    jpeg_error_mgr errors{};
    writer.err = jpeg_std_error(&errors);
    jpeg_create_compress(&writer);
    unsigned char* out = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&writer, &out, &size);
    writer.image_width = static_cast<unsigned>(image.width);
    writer.image_height = static_cast<unsigned>(image.height);
    writer.input_components = 3;
    writer.in_color_space = JCS_RGB;
    jpeg_set_defaults(&writer);
    jpeg_set_quality(&writer, 100, TRUE);
    writer.comp_info[0].h_samp_factor = writer.comp_info[0].v_samp_factor = 1;
    if (progressive) { jpeg_simple_progression(&writer); }
    jpeg_start_compress(&writer, TRUE);
    if (!exif.empty()) {
        jpeg_write_marker(&writer, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(exif.data()),
                          static_cast<unsigned>(exif.size()));
    }
    for (size_t y = 0; y < static_cast<size_t>(image.height); ++y) {
        auto* row = const_cast<unsigned char*>(&image.rgb[3 * y * static_cast<size_t>(image.width)]);
        jpeg_write_scanlines(&writer, &row, 1);
    }
    jpeg_finish_compress(&writer);
    const std::string bytes(reinterpret_cast<const char*>(out), size);
    jpeg_destroy_compress(&writer);
    std::free(out);
    return bytes;
}

struct TiffKind {
    int bits = 8, format = SAMPLEFORMAT_UINT, samples = 3;
    bool tiled = false, planes = false;
    int orientation = ORIENTATION_TOPLEFT;
};

/// `sample(x, y, channel)` gives the bytes of a sample; tiles are of 16 x 16.
std::string tiff(const TiffKind& kind, const std::function<std::string(int x, int y, int channel)>& sample) {
    const TempFolder folder;
    TIFF* out = TIFFOpen(folder.path("a.tif").c_str(), "w");
    TIFFSetField(out, TIFFTAG_IMAGEWIDTH, 6);
    TIFFSetField(out, TIFFTAG_IMAGELENGTH, 5);
    TIFFSetField(out, TIFFTAG_BITSPERSAMPLE, kind.bits);
    TIFFSetField(out, TIFFTAG_SAMPLEFORMAT, kind.format);
    TIFFSetField(out, TIFFTAG_SAMPLESPERPIXEL, kind.samples);
    TIFFSetField(out, TIFFTAG_PHOTOMETRIC, kind.samples == 1 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB);
    TIFFSetField(out, TIFFTAG_PLANARCONFIG, kind.planes ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
    TIFFSetField(out, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
    TIFFSetField(out, TIFFTAG_ORIENTATION, kind.orientation);
    if (kind.samples == 4) {
        const uint16_t straight = EXTRASAMPLE_UNASSALPHA;
        TIFFSetField(out, TIFFTAG_EXTRASAMPLES, 1, &straight);
    }
    kind.tiled ? TIFFSetField(out, TIFFTAG_TILEWIDTH, 16) : TIFFSetField(out, TIFFTAG_ROWSPERSTRIP, 2);
    if (kind.tiled) { TIFFSetField(out, TIFFTAG_TILELENGTH, 16); }
    uint32_t block = 0;
    for (int plane = 0; plane < (kind.planes ? kind.samples : 1); ++plane) {
        for (int top = 0; top < 5; top += kind.tiled ? 16 : 2) {
            std::string bytes;
            for (int y = top; y < (kind.tiled ? 16 : std::min(top + 2, 5)); ++y) {
                for (int x = 0; x < (kind.tiled ? 16 : 6); ++x) {
                    for (int c = 0; c < (kind.planes ? 1 : kind.samples); ++c) {
                        bytes += sample(std::min(x, 5), std::min(y, 4), plane + c);
                    }
                }
            }
            const auto size = static_cast<tmsize_t>(bytes.size());
            kind.tiled ? TIFFWriteEncodedTile(out, block++, bytes.data(), size)
                       : TIFFWriteEncodedStrip(out, block++, bytes.data(), size);
        }
    }
    TIFFClose(out);
    return TempFolder::read(folder.path("a.tif"));
}

uint8_t byteAt(const Image8& image, int x, int y, int channel) {
    const auto pixel = static_cast<size_t>(y * image.width + x);
    return channel == 3 ? image.alpha[pixel] : image.rgb[3 * pixel + static_cast<size_t>(channel)];
}

int appendGif(GifFileType* gif, const GifByteType* bytes, int count) {
    static_cast<std::string*>(gif->UserData)
        ->append(reinterpret_cast<const char*>(bytes), static_cast<size_t>(count));
    return count;
}

}  // namespace

std::string palettePng(int colors, int bits) {
    std::vector<std::string> rows = paletteRows();
    for (std::string& row : rows) {
        std::string packed(static_cast<size_t>((6 * bits + 7) / 8), '\0');
        for (size_t x = 0; x < 6; ++x) {
            const size_t bit = x * static_cast<size_t>(bits);
            const auto shift = 8 - static_cast<size_t>(bits) - bit % 8;
            packed[bit / 8] = static_cast<char>(packed[bit / 8] | (row[x] << shift));
        }
        row = packed;
    }
    const auto addPalette = [colors](png_structp writer, png_infop info) {
        png_color palette[4];
        for (int i = 0; i < 4; ++i) {
            palette[i] = {kColors[i][0], kColors[i][1], kColors[i][2]};
        }
        const png_byte alpha[4] = {255, 255, 255, 0};
        png_set_check_for_invalid_index(writer, 0);
        png_set_PLTE(writer, info, palette, colors);
        png_set_tRNS(writer, info, alpha, colors, nullptr);
    };
    return png(PNG_COLOR_TYPE_PALETTE, bits, bits < 8 ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, rows,
               addPalette);
}

void addPng(std::vector<PictureFile>* files) {
    const Image8 colors = patternImage(), clear = transparentImage();
    files->push_back(
        {"plain.png", png(PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_NONE, rowsOf(colors, false, false)), colors});
    files->push_back(
        {"alpha.png", png(PNG_COLOR_TYPE_RGBA, 8, PNG_INTERLACE_ADAM7, rowsOf(clear, true, false)), clear});
    files->push_back(
        {"wide.png", png(PNG_COLOR_TYPE_RGBA, 16, PNG_INTERLACE_NONE, rowsOf(clear, true, true)), clear});
    files->push_back({"palette.png", palettePng(4, 8), paletteImage()});
    files->push_back({"bits.png", palettePng(4, 2), paletteImage()});
}

void addJpeg(std::vector<PictureFile>* files) {
    files->push_back({"plain.jpg", jpeg(patternImage(), false), patternImage(), 3});
    files->push_back({"progressive.jpg", jpeg(patternImage(), true), patternImage(), 3});
}

std::string jpegWithOrientation(int orientation) {
    return jpeg(halfWhiteImage(), false, std::string("Exif\0\0", 6) + exifOf(orientation));
}

void addTiff(std::vector<PictureFile>* files) {
    const Image8 colors = patternImage(), clear = transparentImage();
    const auto byteOf = [](const Image8& image) {
        return [image](int x, int y, int c) {
            return std::string(1, static_cast<char>(byteAt(image, x, y, c)));
        };
    };
    const auto wide = [colors](int x, int y, int c) {
        return std::string(2, static_cast<char>(byteAt(colors, x, y, c)));
    };
    const auto upsideDown = [colors](int x, int y, int c) {
        return std::string(1, static_cast<char>(byteAt(colors, x, 4 - y, c)));
    };
    files->push_back({"strips.tif", tiff({}, byteOf(colors)), colors});
    files->push_back({"tiles.tif", tiff({.tiled = true, .planes = true}, byteOf(colors)), colors});
    files->push_back({"wide.tif", tiff({.bits = 16}, wide), colors});
    Image8 multiplied = clear;  // libtiff multiplies by alpha, which leaves nothing of what is transparent
    std::fill_n(&multiplied.rgb[21], 3, uint8_t{0});
    files->push_back({"alpha.tif", tiff({.samples = 4}, byteOf(clear)), multiplied, 1});
    files->push_back({"turned.tif", tiff({.orientation = ORIENTATION_BOTLEFT}, upsideDown), colors});
}

void addGif(std::vector<PictureFile>* files) {
    for (const bool interlaced : {false, true}) {
        std::string out;
        int code = 0;
        GifFileType* gif = EGifOpen(&out, appendGif, &code);
        GifColorType colors[4];
        for (int i = 0; i < 4; ++i) {
            colors[i] = {kColors[i][0], kColors[i][1], kColors[i][2]};
        }
        ColorMapObject* map = GifMakeMapObject(4, colors);
        GraphicsControlBlock control{};
        control.TransparentColor = 3;
        GifByteType block[4];
        EGifGCBToExtension(&control, block);
        EGifPutScreenDesc(gif, 6, 5, 8, 0, map);
        EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, 4, block);
        EGifPutImageDesc(gif, 0, 0, 6, 5, interlaced, nullptr);
        const std::vector<std::string> rows = paletteRows();
        std::vector<size_t> order{0, 1, 2, 3, 4};
        if (interlaced) { order = {0, 4, 2, 1, 3}; }
        for (const size_t row : order) {
            std::vector<GifPixelType> line(rows[row].begin(), rows[row].end());
            EGifPutLine(gif, line.data(), 6);
        }
        EGifCloseFile(gif, &code);
        GifFreeMapObject(map);
        files->push_back({interlaced ? "interlaced.gif" : "plain.gif", out, paletteImage()});
    }
}

std::vector<PictureFile> floatPictureFiles() {
    const Image8 colors = patternImage();
    std::vector<PictureFile> files;
    const auto floatOf = [colors](int x, int y, int c) {
        const float value = static_cast<float>(byteAt(colors, x, y, c)) / 255.0f;
        return std::string(reinterpret_cast<const char*>(&value), sizeof value);
    };
    const TiffKind floats{.bits = 32, .format = SAMPLEFORMAT_IEEEFP};
    TiffKind tiled = floats;
    tiled.tiled = tiled.planes = true;
    files.push_back({"float.tif", tiff(floats, floatOf), colors});
    files.push_back({"tiled-float.tif", tiff(tiled, floatOf), colors});
    // An exponent of 128 makes a mantissa a share of 256.
    const auto rgbe = [&](bool bottomUp, bool columns, const std::string& order) {
        std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + order + "\n";
        for (int i = 0; i < 30; ++i) {
            const int x = columns ? i / 5 : i % 6;
            const int y = columns ? i % 5 : i / 6;
            for (int c = 0; c < 3; ++c) {
                bytes += static_cast<char>(byteAt(colors, x, bottomUp ? 4 - y : y, c));
            }
            bytes += '\x80';
        }
        return bytes;
    };
    files.push_back({"usual.hdr", rgbe(false, false, "-Y 5 +X 6"), colors, 1});
    files.push_back({"bottom-up.hdr", rgbe(true, false, "+Y 5 +X 6"), colors, 1});
    files.push_back({"columns.hdr", rgbe(false, true, "+X 6 -Y 5"), colors, 1});
    return files;
}

}  // namespace glint::test
