#include "engine/io/pbrt_params.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace glint {
namespace {

struct TypeName {
    std::string_view name;
    PbrtType type;
};

constexpr auto kTypes = std::to_array<TypeName>({{"float", PbrtType::Float},
                                                 {"point", PbrtType::Float},
                                                 {"point2", PbrtType::Float},
                                                 {"point3", PbrtType::Float},
                                                 {"vector", PbrtType::Float},
                                                 {"vector2", PbrtType::Float},
                                                 {"vector3", PbrtType::Float},
                                                 {"normal", PbrtType::Float},
                                                 {"normal3", PbrtType::Float},
                                                 {"integer", PbrtType::Integer},
                                                 {"bool", PbrtType::Bool},
                                                 {"string", PbrtType::String},
                                                 {"texture", PbrtType::Texture},
                                                 {"rgb", PbrtType::Rgb},
                                                 {"color", PbrtType::Rgb},
                                                 {"xyz", PbrtType::Xyz},
                                                 {"spectrum", PbrtType::Spectrum},
                                                 {"blackbody", PbrtType::Blackbody}});

constexpr std::string_view kBlanks = " \t\r\n";

bool readValue(PbrtText* text, PbrtParam* param) {
    switch (param->type) {
        case PbrtType::Integer:
            return text->readInts(&param->integers);
        case PbrtType::Bool:
        case PbrtType::String:
        case PbrtType::Texture:
            return text->readStrings(&param->texts);
        default:
            break;
    }
    if (param->type == PbrtType::Spectrum && text->isStringNext()) {
        return text->readStrings(&param->texts);
    }
    return text->readFloats(&param->numbers);
}

std::string_view whatIs(PbrtType type) {
    switch (type) {
        case PbrtType::Integer:
            return "whole numbers below 2^31";
        case PbrtType::Bool:
            return "true or false";
        case PbrtType::String:
        case PbrtType::Texture:
            return "strings in quotes";
        default:
            return "finite numbers";
    }
}

/// False where the context has failed.
bool readParam(PbrtContext* context, PbrtText* text, PbrtParams* out) {
    PbrtParam param;
    param.place = text->place();
    std::string declaration;
    if (!text->readString(&declaration)) {
        context->fail(param.place, "the string has no closing quote");
        return false;
    }
    const size_t begin = std::min(declaration.find_first_not_of(kBlanks), declaration.size());
    const size_t gap = std::min(declaration.find_first_of(kBlanks, begin), declaration.size());
    const size_t name = std::min(declaration.find_first_not_of(kBlanks, gap), declaration.size());
    const std::string type = declaration.substr(begin, gap - begin);
    param.name = declaration.substr(name, declaration.find_first_of(kBlanks, name) - name);
    if (param.name.empty()) {
        context->fail(param.place, fmt::format("\"{}\" declares no parameter; expected its type and its name",
                                               declaration.substr(0, 40)));
        return false;
    }
    const auto known = std::ranges::find(kTypes, type, &TypeName::name);
    if (known == kTypes.end()) {
        context->remark(param.place, "parameters of a type that pbrt does not have are left out",
                        declaration);
        text->skipValue();
        return true;
    }
    param.type = known->type;
    if (!readValue(text, &param)) {
        context->fail(text->place(), fmt::format("expected {} for \"{}\"", whatIs(param.type), declaration));
        return false;
    }
    out->add(std::move(param));
    return true;
}

}  // namespace

PbrtParams readPbrtParams(PbrtContext* context, PbrtText* text, const PbrtPlace& place,
                          PbrtColorSpace space) {
    PbrtParams params(context, place, space);
    while (text->peek() == '"' && readParam(context, text, &params)) {}
    return params;
}

void PbrtParams::addDefaults(const PbrtParams& defaults) {
    for (const PbrtParam& param : defaults.params_) {
        if (std::ranges::find(params_, param.name, &PbrtParam::name) != params_.end()) { continue; }
        params_.push_back(param);
        params_.back().isDefault = true;
    }
}

bool PbrtParams::isLong() const {
    constexpr size_t kLong = 64;
    return params_.size() > kLong || std::ranges::any_of(params_, [](const PbrtParam& p) {
               return p.numbers.size() + p.integers.size() + p.texts.size() > kLong;
           });
}

const PbrtParam* PbrtParams::find(std::string_view name) const {
    const auto found = std::ranges::find(params_, name, &PbrtParam::name);
    if (found == params_.end()) { return nullptr; }
    found->isUsed = true;
    return &*found;
}

/// Null, after an error where there is one of another type or number.
const PbrtParam* PbrtParams::ofType(std::string_view name, PbrtType type, size_t count) const {
    const PbrtParam* param = find(name);
    if (param == nullptr) { return nullptr; }
    const size_t values = type == PbrtType::Integer ? param->integers.size()
                          : type == PbrtType::Float ? param->numbers.size()
                                                    : param->texts.size();
    if (param->type != type || values < std::max<size_t>(count, 1)) {
        context_->fail(param->place,
                       fmt::format("expected {} {} for \"{}\"", count == 0 ? 1 : count, whatIs(type), name));
        return nullptr;
    }
    return param;
}

float PbrtParams::number(std::string_view name, float otherwise, float least, float most) const {
    const PbrtParam* param = find(name);
    if (param == nullptr) { return otherwise; }
    const bool isWhole = param->type == PbrtType::Integer && !param->integers.empty();
    if (!isWhole) { param = ofType(name, PbrtType::Float, 1); }
    if (param == nullptr) { return otherwise; }
    const float number = isWhole ? static_cast<float>(param->integers[0]) : param->numbers[0];
    if (number < least || number > most) {
        context_->remark(param->place,
                         context_->sentence(fmt::format(
                             "\"{}\" is taken for the nearest number from {:g} to {:g}", name, least, most)));
    }
    return std::clamp(number, least, most);
}

int PbrtParams::integer(std::string_view name, int otherwise, int least, int most) const {
    const PbrtParam* param = ofType(name, PbrtType::Integer, 1);
    if (param == nullptr) { return otherwise; }
    if (param->integers[0] < least || param->integers[0] > most) {
        context_->remark(param->place,
                         context_->sentence(fmt::format(
                             "\"{}\" is taken for the nearest number from {} to {}", name, least, most)));
    }
    return std::clamp(param->integers[0], least, most);
}

bool PbrtParams::flag(std::string_view name, bool otherwise) const {
    const PbrtParam* param = ofType(name, PbrtType::Bool, 1);
    if (param == nullptr) { return otherwise; }
    if (param->texts[0] != "true" && param->texts[0] != "false") {
        context_->fail(param->place, fmt::format("expected true or false for \"{}\"", name));
    }
    return param->texts[0] == "true";
}

std::string PbrtParams::text(std::string_view name, std::string_view otherwise) const {
    const PbrtParam* param = ofType(name, PbrtType::String, 1);
    return param != nullptr ? param->texts[0] : std::string(otherwise);
}

Vec3 PbrtParams::point(std::string_view name, const Vec3& otherwise) const {
    const PbrtParam* param = ofType(name, PbrtType::Float, 3);
    if (param == nullptr) { return otherwise; }
    return glm::clamp(Vec3(param->numbers[0], param->numbers[1], param->numbers[2]), -kMaxCoordinate,
                      kMaxCoordinate);
}

const std::vector<float>& PbrtParams::numbers(std::string_view name, size_t group) const {
    static const std::vector<float> kNone;
    const PbrtParam* param = has(name) ? ofType(name, PbrtType::Float, 1) : nullptr;
    if (param == nullptr) { return kNone; }
    if (param->numbers.size() % group != 0) {
        context_->fail(param->place, fmt::format("\"{}\" has {} numbers; expected a multiple of {}", name,
                                                 param->numbers.size(), group));
        return kNone;
    }
    return param->numbers;
}

const std::vector<int>& PbrtParams::integers(std::string_view name, size_t group) const {
    static const std::vector<int> kNone;
    const PbrtParam* param = has(name) ? ofType(name, PbrtType::Integer, 1) : nullptr;
    if (param == nullptr) { return kNone; }
    if (param->integers.size() % group != 0) {
        context_->fail(param->place, fmt::format("\"{}\" has {} numbers; expected a multiple of {}", name,
                                                 param->integers.size(), group));
        return kNone;
    }
    return param->integers;
}

std::vector<Vec3> PbrtParams::points(std::string_view name) const {
    const std::vector<float>& all = numbers(name, 3);
    std::vector<Vec3> points(all.size() / 3);
    float largest = 0.0f;
    for (size_t i = 0; i < points.size(); ++i) {
        points[i] = Vec3(all[3 * i], all[3 * i + 1], all[3 * i + 2]);
        largest = maxf(largest, maxComponent(absVec(points[i])));
    }
    if (largest > kMaxCoordinate) {
        context_->fail(find(name)->place, fmt::format("\"{}\" has a number above 1e18", name));
    }
    return points;
}

void PbrtParams::passOver(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names) {
        find(name);
    }
}

void PbrtParams::finish() const {
    for (const PbrtParam& param : params_) {
        if (param.isUsed || param.isDefault) { continue; }
        context_->remark(param.place, context_->sentence(fmt::format("\"{}\" of {} \"{}\" is left out",
                                                                     param.name, directive_, name_)));
    }
}

}  // namespace glint
