// A vector drawing as a list of shapes: made once, written as SVG or painted into pixels.
//
// Charts and legends are made of it. Lengths are in units of which a PNG at scale 1 has one a pixel; x points
// right, y down. Knows nothing of data, axes or files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/math/vec.h"
#include "engine/scene/image.h"

namespace glint {

/// Display values, as in CSS.
struct Ink {
    uint8_t red = 0, green = 0, blue = 0;
    double opacity = 1.0;
};

struct Polyline {
    std::vector<Vec2> points;  ///< two or more
    Ink ink;
    double width = 1.0;
    double dash = 0.0;  ///< length of the dashes and the gaps; 0: none
};

/// Filled, and outlined where outlineWidth is above 0.
struct Polygon {
    std::vector<Vec2> points;  ///< three or more
    Ink fill;
    Ink outline = {};
    double outlineWidth = 0.0;
    std::string tip = {};  ///< SVG: what a browser shows while the pointer rests on it; empty: nothing
};

enum class TextAnchor : uint8_t { Start, Middle, End };

struct Label {
    Vec2 position;  ///< on the baseline, at the anchor
    std::string text;
    double size = 12.0;  ///< of the em
    Ink ink = {};
    TextAnchor anchor = TextAnchor::Start;
    bool bold = false;
    bool upwards = false;  ///< turned to be read from below
};

/// Painted in order.
struct Drawing {
    int width = 0;
    int height = 0;
    std::string title;  ///< for screen readers
    std::vector<std::variant<Polyline, Polygon, Label>> shapes;
};

/// A complete SVG document, which may also stand inside HTML: text stays text, no ids, no scripts,
/// nothing external.
std::string drawingSvg(const Drawing& drawing);

/// White paper, `scale` pixels a unit. Empty (0 x 0) when that is more than kMaxDrawingPixels or less
/// than one.
Image8 drawingImage(const Drawing& drawing, double scale);
constexpr int kMaxDrawingPixels = 1 << 26;

/// Advance width of a text in units, in the font that drawingImage() uses.
double textWidth(const std::string& text, double size, bool bold = false);

/// Valid UTF-8 without control characters: what is not becomes U+FFFD. Labels must have passed through it.
std::string cleanText(std::string_view text);

/// The text, or as much of its beginning as fits into `width` with an ellipsis.
std::string shortened(const std::string& text, double size, double width, bool bold = false);

}  // namespace glint
