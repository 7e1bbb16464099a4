// The only file that sees cairo: painting a drawing into pixels, and the widths of texts.
#include <cmath>
#include <memory>

#include <cairo.h>

#include "engine/report/drawing.h"

namespace glint {
namespace {

struct CairoDeleter {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, CairoDeleter>;
using Context = std::unique_ptr<cairo_t, CairoDeleter>;

void selectFont(cairo_t* context, double size, bool bold) {
    // Cairo asks fontconfig for a medium weight where it says normal; the SVG says 500 to look the same.
    cairo_select_font_face(context, "Roboto", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, size);
    // Without hinting a text is as wide at every scale, so that what was laid out still fits.
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(context, options);
    cairo_font_options_destroy(options);
}

double advance(cairo_t* context, const std::string& text) {
    cairo_text_extents_t extents;
    cairo_text_extents(context, text.c_str(), &extents);
    return extents.x_advance;
}

class Painter {
  public:
    explicit Painter(cairo_t* context) : context_(context) {
        cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    }

    void operator()(const Polyline& line) const {
        trace(line.points);
        use(line.ink);
        cairo_set_line_width(context_, line.width);
        cairo_set_dash(context_, &line.dash, line.dash > 0.0 ? 1 : 0, 0.0);
        cairo_stroke(context_);
    }
    void operator()(const Polygon& polygon) const {
        trace(polygon.points);
        cairo_close_path(context_);
        use(polygon.fill);
        cairo_fill_preserve(context_);
        if (polygon.outlineWidth > 0.0) {
            use(polygon.outline);
            cairo_set_line_width(context_, polygon.outlineWidth);
            cairo_set_dash(context_, nullptr, 0, 0.0);
            cairo_stroke_preserve(context_);
        }
        cairo_new_path(context_);
    }
    void operator()(const Label& label) const {
        cairo_save(context_);
        selectFont(context_, label.size, label.bold);
        use(label.ink);
        const double share = label.anchor == TextAnchor::Start    ? 0.0
                             : label.anchor == TextAnchor::Middle ? 0.5
                                                                  : 1.0;
        cairo_translate(context_, static_cast<double>(label.position.x),
                        static_cast<double>(label.position.y));
        if (label.upwards) { cairo_rotate(context_, -std::acos(0.0)); }
        cairo_move_to(context_, -share * advance(context_, label.text), 0.0);
        cairo_show_text(context_, label.text.c_str());
        cairo_restore(context_);
    }

  private:
    void trace(const std::vector<Vec2>& points) const {
        cairo_new_path(context_);
        for (const Vec2& point : points) {
            cairo_line_to(context_, static_cast<double>(point.x), static_cast<double>(point.y));
        }
    }
    void use(const Ink& ink) const {
        cairo_set_source_rgba(context_, ink.red / 255.0, ink.green / 255.0, ink.blue / 255.0, ink.opacity);
    }

    cairo_t* context_;
};

/// CAIRO_FORMAT_RGB24: one native-endian word a pixel, 0x00rrggbb.
Image8 copyOf(cairo_surface_t* surface, int width, int height) {
    cairo_surface_flush(surface);
    Image8 image{.width = width, .height = height, .rgb = {}};
    image.rgb.reserve(3 * static_cast<size_t>(width) * static_cast<size_t>(height));
    const unsigned char* data = cairo_image_surface_get_data(surface);
    const auto stride = static_cast<size_t>(cairo_image_surface_get_stride(surface));
    for (int y = 0; y < height; ++y) {
        const auto* row = reinterpret_cast<const uint32_t*>(data + static_cast<size_t>(y) * stride);
        for (int x = 0; x < width; ++x) {
            for (const int shift : {16, 8, 0}) {
                image.rgb.push_back(static_cast<uint8_t>(row[x] >> shift));
            }
        }
    }
    return image;
}

}  // namespace

Image8 drawingImage(const Drawing& drawing, double scale) {
    const double wide = std::round(drawing.width * scale);
    const double high = std::round(drawing.height * scale);
    if (!(wide >= 1.0 && high >= 1.0 && wide * high <= kMaxDrawingPixels && wide < 32767 && high < 32767)) {
        return {};
    }
    const int width = static_cast<int>(wide);
    const int height = static_cast<int>(high);
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
    const Context context(cairo_create(surface.get()));
    cairo_set_source_rgb(context.get(), 1.0, 1.0, 1.0);
    cairo_paint(context.get());
    cairo_scale(context.get(), scale, scale);
    const Painter painter(context.get());
    for (const auto& shape : drawing.shapes) {
        std::visit(painter, shape);
    }
    if (cairo_status(context.get()) != CAIRO_STATUS_SUCCESS) { return {}; }
    return copyOf(surface.get(), width, height);
}

double textWidth(const std::string& text, double size, bool bold) {
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
    const Context context(cairo_create(surface.get()));
    selectFont(context.get(), size, bold);
    return advance(context.get(), text);
}

}  // namespace glint
