// What each directive does.
#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "engine/io/pbrt_reader.h"

namespace glint {
namespace {

constexpr size_t kMaxObjects = 4'000'000;

}  // namespace

void PbrtReader::begin(PbrtDirective* directive) {
    static constexpr std::pair<std::string_view, std::string_view> kEnds[] = {
        {"AttributeBegin", "AttributeEnd"}, {"TransformBegin", "TransformEnd"}, {"ObjectBegin", "ObjectEnd"}};
    const auto* ends =
        std::ranges::find(kEnds, directive->name, &std::pair<std::string_view, std::string_view>::first);
    if (directive->name == "ObjectBegin") {
        if (!objectName_.empty()) {
            context_.fail(directive->place, "objects cannot be within objects");
            return;
        }
        objectName_ = directive->texts[0].empty() ? " " : directive->texts[0];
        objects_[objectName_].clear();
        shapes_.endCurves();
    }
    stack_.push_back({ends->first, ends->second, directive->place, state_});
}

void PbrtReader::end(PbrtDirective* directive) {
    if (stack_.empty() || stack_.back().end != directive->name) {
        context_.fail(directive->place, stack_.empty() ? fmt::format("{} ends nothing", directive->name)
                                                       : fmt::format("expected {} before {}",
                                                                     stack_.back().end, directive->name));
        return;
    }
    if (directive->name == "ObjectEnd") {
        objectName_.clear();
        shapes_.endCurves();
    }
    const Saved saved = std::move(stack_.back());
    stack_.pop_back();
    if (directive->name == "TransformEnd") {
        state_.transform = saved.state.transform;
        state_.look = saved.state.look;
        state_.movesStart = saved.state.movesStart;
    } else {
        state_ = saved.state;
        parser_.setColorSpace(state_.space);
    }
}

void PbrtReader::transform(PbrtDirective* directive) {
    if (!state_.movesStart) { return; }
    const glm::dmat4 one(1.0);
    const bool isFirst = state_.transform == one || state_.transform == glm::scale(one, glm::dvec3(-1, 1, 1));
    state_.look.clear();
    if (directive->name == "LookAt" && isFirst) { state_.look = directive->numbers; }
    if (directive->name == "Identity") {
        state_.transform = glm::dmat4(1.0);
        return;
    }
    const glm::dmat4 step = transformOf(&context_, directive->place, directive->name, directive->numbers);
    state_.transform = directive->name == "Transform" ? step : state_.transform * step;
}

void PbrtReader::remember(PbrtDirective* directive) { coordinates_[directive->texts[0]] = state_.transform; }

void PbrtReader::recall(PbrtDirective* directive) {
    const auto found = coordinates_.find(directive->texts[0]);
    if (found == coordinates_.end()) {
        context_.fail(directive->place,
                      fmt::format("there is no coordinate system \"{}\"", directive->texts[0]));
        return;
    }
    state_.transform = found->second;
    state_.look.clear();
}

void PbrtReader::activate(PbrtDirective* directive) {
    const std::string& when = directive->texts[0];
    if (when != "All" && when != "StartTime" && when != "EndTime") {
        context_.fail(directive->place, fmt::format("expected StartTime, EndTime or All, but found \"{}\"",
                                                    when.substr(0, 40)));
    }
    if (when != "All") {
        context_.remark(directive->place, "motion is left out: all stands as at its first time");
    }
    state_.movesStart = when != "EndTime";
}

void PbrtReader::setDefaults(PbrtDirective* directive) {
    static constexpr std::string_view kTargets[] = {"shape", "light", "material", "medium", "texture"};
    const auto* target = std::ranges::find(kTargets, directive->texts[0]);
    if (target == std::end(kTargets)) {
        context_.fail(directive->place,
                      fmt::format("\"{}\" has no attributes; expected {}", directive->texts[0],
                                  "shape, light, material, medium or texture"));
        return;
    }
    auto& defaults = state_.defaults[static_cast<size_t>(target - kTargets)];
    if (defaults) { directive->params.addDefaults(*defaults); }
    if (directive->params.isLong()) {
        context_.fail(directive->place, "Attribute sets more than 64 parameters or numbers");
        return;
    }
    defaults = std::make_shared<const PbrtParams>(std::move(directive->params));
}

void PbrtReader::setColorSpace(PbrtDirective* directive) {
    const auto space = pbrtColorSpace(directive->texts[0]);
    if (!space) {
        context_.fail(directive->place, fmt::format("\"{}\" is no colour space; expected srgb, rec2020, "
                                                    "aces2065-1 or dci-p3",
                                                    directive->texts[0]));
        return;
    }
    state_.space = *space;
    parser_.setColorSpace(*space);
}

void PbrtReader::beginWorld(PbrtDirective* directive) {
    if (isWorld_) {
        context_.fail(directive->place, "the world begins twice");
        return;
    }
    view_.finish();
    isWorld_ = true;
    state_.transform = glm::dmat4(1.0);
    state_.look.clear();
    state_.movesStart = true;
    coordinates_["world"] = state_.transform;
}

void PbrtReader::setMedium(PbrtDirective* directive) {
    if (directive->name == "MakeNamedMedium") {
        materials_.defineMedium(directive->texts[0], paramsOf(directive, PbrtTarget::Medium));
        return;
    }
    state_.interior = directive->texts[0];
    if (!directive->texts[1].empty()) {
        context_.remark(directive->place, "media around shapes are left out");
    }
}

void PbrtReader::setView(PbrtDirective* directive) {
    const std::string& kind = directive->texts[0];
    PbrtParams& params = directive->params;
    if (isWorld_) {
        context_.remark(directive->place, "cameras, films and integrators within the world are left out");
    } else if (directive->name == "Camera") {
        coordinates_["camera"] = glm::inverse(state_.transform);
        view_.setCamera(kind, std::move(params), state_);
    } else if (directive->name == "Film") {
        view_.setFilm(kind, std::move(params));
    } else if (directive->name == "PixelFilter") {
        view_.setFilter(kind, params);
    } else {
        view_.setIntegrator(kind, params);
    }
}

PbrtParams& PbrtReader::paramsOf(PbrtDirective* directive, PbrtTarget target) {
    if (const auto& defaults = state_.defaults[static_cast<size_t>(target)]) {
        directive->params.addDefaults(*defaults);
    }
    return directive->params;
}

void PbrtReader::setMaterial(PbrtDirective* directive) {
    const std::string& name = directive->texts[0];
    if (directive->name == "NamedMaterial") {
        state_.material = materials_.numberOf(name, directive->place);
        return;
    }
    PbrtParams& params = paramsOf(directive, PbrtTarget::Material);
    if (directive->name == "Material") {
        state_.material = materials_.define(name, std::move(params));
    } else {
        materials_.defineNamed(name, std::move(params));
    }
}

void PbrtReader::setTexture(PbrtDirective* directive) {
    const std::vector<std::string>& texts = directive->texts;
    textures_.define(texts[0], texts[1], texts[2], std::move(paramsOf(directive, PbrtTarget::Texture)));
}

void PbrtReader::setAreaLight(PbrtDirective* directive) {
    state_.areaLight =
        lights_.defineArea(directive->texts[0], std::move(paramsOf(directive, PbrtTarget::Light)));
}

void PbrtReader::placeLight(PbrtDirective* directive) {
    lights_.place(directive->texts[0], paramsOf(directive, PbrtTarget::Light), state_);
}

void PbrtReader::placeShape(PbrtDirective* directive) {
    const bool isObject = !objectName_.empty();
    std::vector<Object> objects;
    shapes_.place(directive->texts[0], paramsOf(directive, PbrtTarget::Shape), state_, !isObject, &objects);
    if (!isObject) {
        place(std::move(objects), Affine(), directive->place);
        return;
    }
    std::vector<Object>& own = objects_[objectName_];
    own.insert(own.end(), std::make_move_iterator(objects.begin()), std::make_move_iterator(objects.end()));
}

void PbrtReader::placeObject(PbrtDirective* directive) {
    const auto found = objects_.find(directive->texts[0]);
    if (!objectName_.empty()) {
        context_.fail(directive->place, "instances cannot be within objects");
    } else if (found == objects_.end()) {
        context_.fail(directive->place, fmt::format("there is no object \"{}\"", directive->texts[0]));
    }
    if (context_.failed()) { return; }
    place(found->second, affineOf(&context_, directive->place, state_.transform), directive->place);
}

void PbrtReader::place(std::vector<Object> objects, const Affine& toWorld, const PbrtPlace& at) {
    if (context_.scene.objects.size() + objects.size() > kMaxObjects) {
        context_.fail(at, fmt::format("the scene places more than {} objects", kMaxObjects));
        return;
    }
    for (Object& object : objects) {
        object.objectToWorld = context_.world * toWorld * object.objectToWorld;
        if (isInvertible(object.objectToWorld)) {
            context_.scene.objects.push_back(std::move(object));
        } else {
            context_.remark(at, "shapes that are flattened are left out");
        }
    }
}

}  // namespace glint
