// Numbers with two decimals: a hundredth of a pixel, and files that do not differ by rounding.
#include <fmt/format.h>

#include "engine/report/drawing.h"
#include "engine/report/html_text.h"

namespace glint {
namespace {

std::string number(double value) {
    std::string text = fmt::format("{:.2f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') { text.pop_back(); }
    return text == "-0" ? "0" : text;
}

std::string pointList(const std::vector<Vec2>& points) {
    std::string out;
    for (const Vec2& point : points) {
        out += fmt::format("{}{},{}", out.empty() ? "" : " ", number(static_cast<double>(point.x)),
                           number(static_cast<double>(point.y)));
    }
    return out;
}

/// fill="#rrggbb", with its opacity where it is not 1.
std::string paint(const char* what, const Ink& ink) {
    std::string out = fmt::format(" {}=\"#{:02x}{:02x}{:02x}\"", what, ink.red, ink.green, ink.blue);
    return ink.opacity < 1.0 ? out + fmt::format(" {}-opacity=\"{}\"", what, number(ink.opacity)) : out;
}

struct SvgWriter {
    std::string out;

    void operator()(const Polyline& line) {
        const std::string dash =
            line.dash > 0.0 ? fmt::format(" stroke-dasharray=\"{}\"", number(line.dash)) : "";
        out += fmt::format("<polyline points=\"{}\" fill=\"none\"{} stroke-width=\"{}\"{}/>\n",
                           pointList(line.points), paint("stroke", line.ink), number(line.width), dash);
    }
    void operator()(const Polygon& polygon) {
        const std::string outline = polygon.outlineWidth > 0.0 ? fmt::format("{} stroke-width=\"{}\"",
                                                                             paint("stroke", polygon.outline),
                                                                             number(polygon.outlineWidth))
                                                               : "";
        const std::string end =
            polygon.tip.empty() ? "/>" : fmt::format("><title>{}</title></polygon>", htmlText(polygon.tip));
        out += fmt::format("<polygon points=\"{}\"{}{}{}\n", pointList(polygon.points),
                           paint("fill", polygon.fill), outline, end);
    }
    void operator()(const Label& label) {
        const std::string x = number(static_cast<double>(label.position.x));
        const std::string y = number(static_cast<double>(label.position.y));
        const char* anchor = label.anchor == TextAnchor::Start    ? ""
                             : label.anchor == TextAnchor::Middle ? " text-anchor=\"middle\""
                                                                  : " text-anchor=\"end\"";
        const std::string turn = label.upwards ? fmt::format(" transform=\"rotate(-90 {} {})\"", x, y) : "";
        out += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}{}{}{}>{}</text>\n", x, y,
                           number(label.size), label.bold ? " font-weight=\"bold\"" : "", anchor,
                           paint("fill", label.ink), turn, htmlText(label.text));
    }
};

}  // namespace

std::string drawingSvg(const Drawing& drawing) {
    SvgWriter writer;
    writer.out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "role=\"img\" font-weight=\"500\" font-family=\"Roboto, 'DejaVu Sans', Arial, sans-serif\" "
        "stroke-linejoin=\"round\">\n"
        "<title>{2}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
        drawing.width, drawing.height, htmlText(drawing.title));
    for (const auto& shape : drawing.shapes) {
        std::visit(writer, shape);
    }
    return writer.out + "</svg>\n";
}

}  // namespace glint
