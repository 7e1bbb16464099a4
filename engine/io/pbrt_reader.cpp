#include "engine/io/pbrt_reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "engine/io/default_view.h"
#include "engine/io/used_assets.h"

namespace glint {

PbrtReader::PbrtReader(const std::string& path, const LoadOptions& options)
    : context_{options},
      parser_(&context_),
      assets_(path, options.counts),
      textures_(&context_, &assets_),
      materials_(&context_, &textures_),
      lights_(&context_, &textures_, &assets_),
      shapes_(&context_, &textures_, &materials_, &lights_),
      view_(&context_) {
    context_.scene.path = path;
    context_.scene.title = path.substr(path.find_last_of('/') + 1);
    // pbrt's own where the file says nothing.
    context_.scene.options.filter = FilterKind::Gaussian;
    context_.scene.options.maxDepth = 5;
}

Result<SceneDescription> PbrtReader::read() {
    parser_.open(context_.scene.path);
    PbrtDirective directive;
    bool isEmpty = true;
    while (parser_.next(&directive)) {
        obey(&directive);
        isEmpty = false;
    }
    if (isEmpty && !context_.failed()) {
        return Error{"holds no directive of pbrt (Camera, WorldBegin, Shape, …); is this a pbrt scene?",
                     {.file = context_.scene.path}};
    }
    shapes_.readFiles();
    if (!stack_.empty()) {
        context_.fail(stack_.back().place, fmt::format("{} is not ended", stack_.back().begin));
    }
    if (!isWorld_) { view_.finish(); }
    if (context_.failed()) { return *context_.error; }
    return finish();
}

void PbrtReader::obey(PbrtDirective* directive) {
    static const std::map<std::string_view, Obey> kKinds = {{"Accelerator", &PbrtReader::passOver},
                                                            {"ActiveTransform", &PbrtReader::activate},
                                                            {"AreaLightSource", &PbrtReader::setAreaLight},
                                                            {"Attribute", &PbrtReader::setDefaults},
                                                            {"AttributeBegin", &PbrtReader::begin},
                                                            {"AttributeEnd", &PbrtReader::end},
                                                            {"Camera", &PbrtReader::setView},
                                                            {"ColorSpace", &PbrtReader::setColorSpace},
                                                            {"CoordSysTransform", &PbrtReader::recall},
                                                            {"CoordinateSystem", &PbrtReader::remember},
                                                            {"Film", &PbrtReader::setView},
                                                            {"Integrator", &PbrtReader::setView},
                                                            {"LightSource", &PbrtReader::placeLight},
                                                            {"MakeNamedMaterial", &PbrtReader::setMaterial},
                                                            {"MakeNamedMedium", &PbrtReader::setMedium},
                                                            {"Material", &PbrtReader::setMaterial},
                                                            {"MediumInterface", &PbrtReader::setMedium},
                                                            {"NamedMaterial", &PbrtReader::setMaterial},
                                                            {"ObjectBegin", &PbrtReader::begin},
                                                            {"ObjectEnd", &PbrtReader::end},
                                                            {"ObjectInstance", &PbrtReader::placeObject},
                                                            {"Option", &PbrtReader::passOver},
                                                            {"PixelFilter", &PbrtReader::setView},
                                                            {"Sampler", &PbrtReader::passOver},
                                                            {"Shape", &PbrtReader::placeShape},
                                                            {"Texture", &PbrtReader::setTexture},
                                                            {"TransformBegin", &PbrtReader::begin},
                                                            {"TransformEnd", &PbrtReader::end},
                                                            {"TransformTimes", &PbrtReader::passOver},
                                                            {"WorldBegin", &PbrtReader::beginWorld},
                                                            {"WorldEnd", &PbrtReader::passOver}};
    if (directive->name == "ReverseOrientation") {
        state_.isReversed = !state_.isReversed;
        return;
    }
    const bool isOfWorld =
        directive->name == "Shape" || directive->name == "LightSource" || directive->name == "ObjectInstance";
    if (isOfWorld && !isWorld_ && view_.hasCamera()) {  // which decides how the world is placed
        context_.fail(directive->place, fmt::format("expected WorldBegin before {}", directive->name));
        return;
    }
    const auto found = kKinds.find(directive->name);
    (this->*(found != kKinds.end() ? found->second : &PbrtReader::transform))(directive);
}

Status PbrtReader::readAssets() {
    Status first;
    readUsedAssets(&assets_, &context_.scene, [&](const Asset& asset, const Error& error) {
        if (asset.kind == AssetKind::Texture) {
            remarkUnreadImage(asset, error, &context_.scene, &context_.remarks);
            return true;
        }
        if (!context_.options.allowMissing) { first = error; }
        context_.scene.warnings.push_back(error.format());
        return context_.options.allowMissing;
    });
    return first;
}

Result<SceneDescription> PbrtReader::finish() {
    SceneDescription& scene = context_.scene;
    if (scene.materials.empty()) { materials_.take(-1, PbrtValue{Vec3(1.0f)}, {}); }
    scaleLight(view_.exposure(), view_.balance(), &scene);
    if (Status read = readAssets(); !read) { return read.error(); }
    if (!view_.hasCamera()) { applyDefaultView(&scene, context_.options.noStudio); }
    for (const Asset& asset : lackingAssets(scene)) {  // the studio's light
        if (Status lit = readAsset(asset, &assets_, &scene); !lit) { return lit.error(); }
    }
    const auto append = [](const std::vector<std::string>& lines, std::vector<std::string>* to) {
        to->insert(to->end(), lines.begin(), lines.end());
    };
    append(context_.meshWarnings, &scene.warnings);
    append(context_.remarks.lines(), &scene.warnings);
    append(context_.notes.lines(), &scene.notes);
    return std::move(scene);
}

}  // namespace glint
