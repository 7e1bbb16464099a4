#include "engine/io/mitsuba_object.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

namespace glint {
namespace {

constexpr int kMaxNesting = 64;

bool isObject(std::string_view tag) {
    static constexpr std::string_view kTags[] = {"bsdf",   "texture", "emitter",   "shape",      "sensor",
                                                 "film",   "rfilter", "sampler",   "integrator", "medium",
                                                 "volume", "phase",   "subsurface"};
    return std::ranges::find(kTags, tag) != std::end(kTags);
}

}  // namespace

bool MitsubaElement::has(std::string_view name) const {
    return std::ranges::any_of(attributes, [name](const auto& a) { return a.name == name; });
}

std::string_view MitsubaElement::attribute(std::string_view name) const {
    for (const MitsubaAttribute& attribute : attributes) {
        if (attribute.name == name) { return attribute.value; }
    }
    return {};
}

std::vector<std::string_view> mitsubaWords(std::string_view list) {
    constexpr std::string_view kBetween = " \t\r\n,;";
    std::vector<std::string_view> words;
    for (size_t at = list.find_first_not_of(kBetween); at != std::string_view::npos;) {
        const size_t end = std::min(list.find_first_of(kBetween, at), list.size());
        words.push_back(list.substr(at, end - at));
        at = list.find_first_not_of(kBetween, end);
    }
    return words;
}

double mitsubaNumber(MitsubaContext* context, const MitsubaElement& at, std::string_view word) {
    const std::vector<std::string_view> words = mitsubaWords(word);
    const std::string_view digits =
        words.size() == 1 ? words[0].substr(words[0].starts_with('+') ? 1 : 0) : std::string_view();
    double number = 0.0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (problem != std::errc() || end != digits.data() + digits.size() || !std::isfinite(number)) {
        context->fail(at, fmt::format("\"{}\" is no finite number", word.substr(0, 40)));
        return 0.0;
    }
    return std::clamp(number, -kMaxCoordinateD, kMaxCoordinateD);
}

std::vector<double> mitsubaNumbers(MitsubaContext* context, const MitsubaElement& at, std::string_view list,
                                   std::initializer_list<size_t> counts) {
    const std::vector<std::string_view> words = mitsubaWords(list);
    if (counts.size() > 0 && std::ranges::find(counts, words.size()) == counts.end()) {
        context->fail(at, fmt::format("<{}> has {} numbers; expected {}", at.tag, words.size(),
                                      fmt::join(counts, " or ")));
        return {};
    }
    std::vector<double> numbers;
    numbers.reserve(words.size());
    for (const std::string_view word : words) {
        numbers.push_back(mitsubaNumber(context, at, word));
    }
    return numbers;
}

MitsubaObject::MitsubaObject(MitsubaContext* context, const MitsubaElement& element)
    : context_(context), element_(element), used_(element.children.size(), false) {
    if (++context_->nesting > kMaxNesting) {
        context_->fail(element, fmt::format("objects refer to each other in a circle, or more than {} deep",
                                            kMaxNesting));
    }
}

const MitsubaElement* MitsubaObject::resolved(size_t child) {
    const MitsubaElement& at = element_.children[child];
    if (at.tag != "ref") { return &at; }
    const MitsubaElement* named = context_->xml.find(at.attribute("id"));
    if (named == nullptr) {
        context_->fail(at, fmt::format("there is no object with the id \"{}\"", at.attribute("id")));
    }
    return named;
}

const MitsubaElement* MitsubaObject::property(std::string_view name) {
    if (context_->failed()) { return nullptr; }
    for (size_t i = 0; i < used_.size(); ++i) {
        if (element_.children[i].attribute("name") == name) {
            used_[i] = true;
            return resolved(i);
        }
    }
    return nullptr;
}

const MitsubaElement* MitsubaObject::next(std::initializer_list<std::string_view> tags) {
    for (size_t i = 0; i < used_.size() && !context_->failed(); ++i) {
        if (used_[i]) { continue; }
        const MitsubaElement& child = element_.children[i];
        if (child.tag != "ref" && std::ranges::find(tags, child.tag) == tags.end()) { continue; }
        const MitsubaElement* found = resolved(i);
        if (found == nullptr || std::ranges::find(tags, found->tag) == tags.end()) { continue; }
        used_[i] = true;
        return found;
    }
    return nullptr;
}

float MitsubaObject::number(std::string_view name, float otherwise, float least, float most) {
    const MitsubaElement* at = property(name);
    if (at == nullptr) { return otherwise; }
    const auto number = static_cast<float>(mitsubaNumber(context_, *at, at->attribute("value")));
    if (number < least || number > most) {
        context_->remark(*at, context_->sentence(fmt::format("\"{}\" is taken for the nearest number from "
                                                             "{:g} to {:g}",
                                                             name, least, most)));
    }
    return std::clamp(number, least, most);
}

int MitsubaObject::integer(std::string_view name, int otherwise, int least, int most) {
    return static_cast<int>(
        number(name, static_cast<float>(otherwise), static_cast<float>(least), static_cast<float>(most)));
}

bool MitsubaObject::flag(std::string_view name, bool otherwise) {
    const MitsubaElement* at = property(name);
    if (at == nullptr) { return otherwise; }
    const std::string_view value = at->attribute("value");
    const bool isTrue = value == "true" || value == "True" || value == "1";
    if (!isTrue && value != "false" && value != "False" && value != "0") {
        context_->fail(*at, fmt::format("\"{}\" is neither true nor false", value.substr(0, 40)));
    }
    return isTrue;
}

std::string_view MitsubaObject::text(std::string_view name, std::string_view otherwise) {
    const MitsubaElement* at = property(name);
    return at != nullptr ? at->attribute("value") : otherwise;
}

Vec3 MitsubaObject::vector(std::string_view name, const Vec3& otherwise) {
    const MitsubaElement* at = property(name);
    return at != nullptr ? mitsubaVector(context_, *at, 0.0f) : otherwise;
}

Affine MitsubaObject::transform(std::string_view name) {
    const MitsubaElement* at = property(name);
    return at != nullptr ? mitsubaTransform(context_, *at) : Affine();
}

void MitsubaObject::passOver(std::initializer_list<std::string_view> names) {
    for (size_t i = 0; i < used_.size(); ++i) {
        const std::string_view name = element_.children[i].attribute("name");
        used_[i] = used_[i] || (!name.empty() && std::ranges::find(names, name) != names.end());
    }
}

std::string_view MitsubaObject::nameForMessages() const {
    const std::string_view id = element_.attribute("id");
    return id.empty() ? type() : id;
}

void MitsubaObject::finish() {
    for (size_t i = 0; i < used_.size() && !context_->failed(); ++i) {
        const MitsubaElement& child = element_.children[i];
        if (used_[i] || child.tag == "alias") { continue; }
        const std::string_view name = child.attribute("name");
        const std::string what =
            child.tag == "ref"    ? fmt::format("the reference to \"{}\"", child.attribute("id"))
            : isObject(child.tag) ? fmt::format("{} \"{}\"", child.tag, child.attribute("type"))
                                  : fmt::format("\"{}\"", name.empty() ? child.tag : name);
        context_->remark(child, context_->sentence(
                                    fmt::format("{} of {} \"{}\" is left out", what, element_.tag, type())));
    }
}

}  // namespace glint
