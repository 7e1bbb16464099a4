// Mitsuba XML, from 0.4 to 3: shapes with their materials, emitters, the first sensor, the integrator.
// engine/io/README.md says what maps to what.
#include <fmt/format.h>

#include "engine/io/asset_cache.h"
#include "engine/io/default_view.h"
#include "engine/io/file_kind.h"
#include "engine/io/importer.h"
#include "engine/io/mitsuba_lights.h"
#include "engine/io/mitsuba_sensor.h"
#include "engine/io/mitsuba_shapes.h"
#include "engine/io/used_assets.h"

namespace glint {
namespace {

class MitsubaReader {
  public:
    MitsubaReader(const MitsubaXml& xml, const std::string& path, const LoadOptions& options)
        : context_{xml, options},
          assets_(path, options.counts),
          textures_(&context_, &assets_),
          materials_(&context_, &textures_),
          meshes_(&context_),
          shapes_(&context_, &materials_, &meshes_),
          lights_(&context_, &textures_, &assets_) {
        context_.scene.path = path;
        context_.scene.title = path.substr(path.find_last_of('/') + 1);
    }

    Result<SceneDescription> read() {
        // The camera first, which says how the scene is placed.
        for (const bool isSensor : {true, false}) {
            for (const MitsubaElement& element : context_.xml.root().children) {
                if ((element.tag == "sensor") == isSensor) { place(element); }
            }
        }
        if (context_.failed()) { return *context_.error; }
        SceneDescription& scene = context_.scene;
        if (scene.materials.empty()) { materials_.take(nullptr, UvOrigin::Top); }
        const Status read = readAssets();
        if (!read) { return read.error(); }
        if (sensor_ == nullptr) { applyDefaultView(&scene, options().noStudio); }
        for (const Asset& asset : lackingAssets(scene)) {  // the studio's light
            if (Status lit = readAsset(asset, &assets_, &scene); !lit) { return lit.error(); }
        }
        for (const std::string& name : context_.xml.unusedParameters()) {
            scene.warnings.push_back(fmt::format("{}: the scene has no parameter \"{}\"", scene.path, name));
        }
        const auto append = [](const std::vector<std::string>& lines, std::vector<std::string>* to) {
            to->insert(to->end(), lines.begin(), lines.end());
        };
        append(meshes_.warnings(), &scene.warnings);
        append(context_.remarks.lines(), &scene.warnings);
        append(context_.notes.lines(), &scene.notes);
        return std::move(scene);
    }

  private:
    const LoadOptions& options() const { return context_.options; }

    void place(const MitsubaElement& element) {
        if (context_.failed()) { return; }
        if (element.tag == "shape") {
            shapes_.place(element);
        } else if (element.tag == "emitter") {
            lights_.place(element);
        } else if (element.tag == "sensor") {
            if (sensor_ == nullptr) {
                readMitsubaSensor(&context_, element);
                sensor_ = &element;
            } else {
                context_.remark(element, "sensors after the first are left out");
            }
        } else if (element.tag == "integrator") {
            readMitsubaIntegrator(&context_, element);
        } else if (element.tag == "medium" && element.attribute("id").empty()) {
            context_.remark(element, "media are left out");
        } else if (element.tag != "bsdf" && element.tag != "medium" && element.tag != "texture" &&
                   element.tag != "spectrum" && element.tag != "alias" && element.tag != "ref" &&
                   element.tag != "sampler") {
            context_.remark(element,
                            context_.sentence(fmt::format("<{}> of the scene is left out", element.tag)));
        }
    }

    Status readAssets() {
        Status first;
        readUsedAssets(&assets_, &context_.scene, [&](const Asset& asset, const Error& error) {
            if (asset.kind == AssetKind::Texture) {
                remarkUnreadImage(asset, error, &context_.scene, &context_.remarks);
                return true;
            }
            if (!options().allowMissing) { first = error; }
            context_.scene.warnings.push_back(error.format());
            return options().allowMissing;
        });
        return first;
    }

    MitsubaContext context_;
    AssetCache assets_;
    MitsubaTextures textures_;
    MitsubaMaterials materials_;
    MitsubaMeshes meshes_;
    MitsubaShapes shapes_;
    MitsubaLights lights_;
    const MitsubaElement* sensor_ = nullptr;
};

Result<SceneDescription> load(const std::string& path, const LoadOptions& options) {
    const auto xml = MitsubaXml::read(path, options.parameters);
    if (!xml) { return xml.error(); }
    return MitsubaReader(**xml, path, options).read();
}

bool looksLike(std::string_view head) {
    return firstText(head).starts_with('<') && head.find("<scene") != std::string_view::npos;
}

}  // namespace

extern const Importer kImportMitsuba;
const Importer kImportMitsuba{.name = "Mitsuba",
                              .extensions = ".xml",
                              .looksLike = looksLike,
                              .load = load,
                              .hasParameters = true,
                              .lights = "an <emitter>"};

}  // namespace glint
