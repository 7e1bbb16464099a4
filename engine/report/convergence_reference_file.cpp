// A file's scene hash covers its settings too, and those a reference may have its own of (integrator, seed,
// sampler ...). They stand beside the hash as text, so the hash is formed again with them in place.
#include <charconv>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "engine/io/exr_io.h"
#include "engine/io/image_io.h"
#include "engine/report/convergence_reference.h"
#include "engine/report/convergence_variant.h"
#include "engine/scene/scene_hash.h"

namespace glint {
namespace {

using Attributes = std::map<std::string, std::string>;

std::string attribute(const Attributes& attributes, const std::string& name) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? std::string() : found->second;
}

template <class T>
bool read(const std::string& text, T* value) {
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), *value);
    return problem == std::errc() && end == text.data() + text.size();
}

template <class T>
T numberOr(const std::string& text, T otherwise) {
    T value{};
    return read(text, &value) ? value : otherwise;
}

/// The settings that change noise but not what the picture converges to.
void takeNoiseSettings(const Attributes& a, SceneDescription* scene) {
    const auto take = [&](const char* name, auto* target) {
        *target = numberOr(attribute(a, std::string("setting.") + name), *target);
    };
    const auto is = [&](const char* name, const char* value) {
        return attribute(a, std::string("setting.") + name) == value;
    };
    RenderOptions& options = scene->options;
    SppmOptions& sppm = scene->sppm;
    options.integrator =
        integratorByName(attribute(a, "setting.integrator")).value_or(IntegratorKind::PathTracing);
    options.sampler = is("sampler", "independent") ? SamplerKind::Independent : SamplerKind::Sobol;
    take("rouletteStartDepth", &options.rouletteStartDepth);
    take("seed", &options.seed);
    take("fireflyClamp", &options.fireflyClamp);
    take("photonsPerPass", &sppm.photonsPerPass);
    take("alpha", &sppm.alpha);
    take("radius", &sppm.radiusWorld);
    take("radiusFootprints", &sppm.radiusFootprints);
    take("storeRoughness", &sppm.storeRoughness);
    take("memoryBudgetMiB", &sppm.memoryBudgetMiB);
    sppm.sampleDirectLight = !is("directLight", "photons");
    sppm.lookup = is("lookup", "tree") ? PhotonLookupKind::Tree : PhotonLookupKind::Grid;
}

Error inFile(const std::string& path, std::string problem) { return {std::move(problem), {.file = path}}; }

bool hasSize(const ExrChannel* channel, size_t pixels) {
    return channel != nullptr && channel->floats.size() == pixels;
}

void readVariance(const ExrImage& exr, ReferenceImage* out) {
    const size_t pixels = out->image.rgb.size() / 3;
    const ExrChannel* luminance = exr.find("standardError.Y");
    const ExrChannel* own[3] = {exr.find("standardError.R"), exr.find("standardError.G"),
                                exr.find("standardError.B")};
    const bool each = hasSize(own[0], pixels) && hasSize(own[1], pixels) && hasSize(own[2], pixels);
    if (!each && !hasSize(luminance, pixels)) {
        out->remarks.emplace_back(
            "The reference does not say how large its own error is: no floor can be shown.");
        return;
    }
    if (!each) {
        out->remarks.emplace_back(
            "The reference's standard error is that of its luminance; it is taken for each "
            "channel's.");
    }
    out->variance.resize(3 * pixels);
    for (size_t i = 0; i < 3 * pixels; ++i) {
        const float error = (each ? own[i % 3] : luminance)->floats[i / 3];
        out->variance[i] = error * error;
        if (!std::isfinite(out->variance[i])) {
            out->variance.clear();
            out->remarks.emplace_back("The reference's own error is not finite: no floor can be shown.");
            return;
        }
    }
}

std::vector<uint32_t> seedsOf(const Attributes& attributes) {
    std::vector<uint32_t> seeds;
    const std::string list = attribute(attributes, "referenceSeeds");
    const std::string text = list.empty() ? attribute(attributes, "setting.seed") : list;
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = std::min(text.find(' ', begin), text.size());
        uint32_t seed = 0;
        if (read(text.substr(begin, end - begin), &seed)) { seeds.push_back(seed); }
        begin = end + 1;
    }
    return seeds;
}

void readMetadata(const Attributes& a, ReferenceImage* out) {
    out->integrator = integratorByName(attribute(a, "setting.integrator"));
    if (out->integrator) { out->method = integratorInfo(*out->integrator).key; }
    const std::string method = attribute(a, "referenceMethod");
    const auto variant = parseVariant(method);
    out->method = method.empty() ? out->method : variant ? variant->text : method;
    out->seeds = seedsOf(a);
    out->endedBy = attribute(a, "referenceEndedBy");
    out->timeLimitSeconds = numberOr(attribute(a, "referenceTimeLimit"), 0.0);
    out->renderSeconds =
        numberOr(attribute(a, "referenceSeconds"), numberOr(attribute(a, "renderSeconds"), 0.0));
    out->passes = numberOr(attribute(a, "referencePasses"), numberOr(attribute(a, "passes"), uint64_t{0}));
    out->remarkBias(numberOr(attribute(a, "setting.fireflyClamp"), 0.0f));
}

Attributes attributesOf(const ReferenceImage& reference, const SceneDescription& scene) {
    Attributes out{{"glintVersion", GLINT_VERSION},
                   {"sceneHash", sceneHash(scene).hex()},
                   {"passes", fmt::to_string(reference.passes)},
                   {"renderSeconds", fmt::to_string(reference.renderSeconds)},
                   {"relativeError", fmt::to_string(reference.relativeError())},
                   {"referenceMethod", reference.method},
                   {"referenceSeeds", fmt::format("{}", fmt::join(reference.seeds, " "))},
                   {"referenceSeconds", fmt::to_string(reference.renderSeconds)},
                   {"referenceTimeLimit", fmt::to_string(reference.timeLimitSeconds)},
                   {"referencePasses", fmt::to_string(reference.passes)},
                   {"referenceEndedBy", reference.endedBy},
                   {"referenceStandardError", fmt::to_string(reference.rmse())},
                   {"referenceRelativeError", fmt::to_string(reference.relativeError())},
                   {"referenceRemarks", fmt::format("{}", fmt::join(reference.remarks, " "))}};
    for (const Setting& setting : renderSettings(scene)) {
        out["setting." + setting.name] = setting.value;
    }
    return out;
}

}  // namespace

std::string referenceDifference(const Attributes& attributes, SceneDescription scene) {
    const std::vector<Setting> own = renderSettings(scene);
    for (const char* name : {"maxDepth", "filter", "filterRadius"}) {
        const std::string theirs = attribute(attributes, std::string("setting.") + name);
        for (const Setting& setting : own) {
            if (setting.name == name && setting.value != theirs) {
                return fmt::format("it was rendered with {} {}, and this scene has {}", name, theirs,
                                   setting.value);
            }
        }
    }
    takeNoiseSettings(attributes, &scene);
    return sceneHash(scene).hex() == attribute(attributes, "sceneHash") ? "" : "it shows another scene";
}

Result<ReferenceImage> loadReference(const std::string& path, const SceneDescription& scene, bool anyScene) {
    const Result<std::string> bytes = readImageFile(path);
    if (!bytes) { return bytes.error(); }
    Result<ExrColorImage> image = decodeExrColor(*bytes, path);
    if (!image) { return image.error(); }
    const Attributes& attributes = image->attributes;
    ReferenceImage out;
    out.path = path;
    out.image = std::move(image->color);
    if (Status finite = checkFinite(out.image, path); !finite) { return finite.error(); }
    const Resolution& size = scene.resolution;
    if (out.image.width != size.width || out.image.height != size.height) {
        return inFile(path, fmt::format("the reference has {}x{} pixels, and the scene is rendered at {}x{}; "
                                        "expected the same size (--size)",
                                        out.image.width, out.image.height, size.width, size.height));
    }
    if (attribute(attributes, "sceneHash").empty()) {
        out.remarks.emplace_back("The reference does not say which scene it shows: nothing vouches for it.");
    } else if (const std::string problem = referenceDifference(attributes, scene); !problem.empty()) {
        if (!anyScene) {
            return inFile(
                path, fmt::format("not a reference of this scene: {}; --any-reference compares all the same",
                                  problem));
        }
        out.remarks.push_back(fmt::format("THE REFERENCE MAY NOT SHOW THIS SCENE: {}.", problem));
    }
    const auto isUsed = [](std::string_view name) {
        return name == "R" || name.starts_with("standardError.");
    };
    const Result<ExrImage> exr = decodeExr(*bytes, path, isUsed);
    if (!exr) { return exr.error(); }
    if (const ExrChannel* red = exr->find("R"); red != nullptr && red->type == ExrPixelType::Half) {
        out.remarks.emplace_back(
            "The reference is stored in 16 bits: rounding adds a relative error of about 1e-4.");
    }
    readMetadata(attributes, &out);
    readVariance(*exr, &out);
    out.summarize();
    return out;
}

Status saveReference(const std::string& path, const ReferenceImage& reference, SceneDescription scene,
                     const VariantSettings& settings) {
    scene.options = settings.options;
    scene.sppm = settings.sppm;
    const size_t pixels = reference.image.rgb.size() / 3;
    ExrImage exr;
    exr.width = reference.image.width;
    exr.height = reference.image.height;
    const auto add = [&](const std::string& name, auto valueAt) {
        ExrChannel channel{.name = name, .type = ExrPixelType::Float, .floats = {}, .ids = {}};
        channel.floats.reserve(pixels);
        for (size_t i = 0; i < pixels; ++i) {
            channel.floats.push_back(valueAt(i));
        }
        exr.channels.push_back(std::move(channel));
    };
    const auto standardError = [&](size_t i, size_t c) { return std::sqrt(reference.variance[3 * i + c]); };
    for (size_t c = 0; c < 3; ++c) {
        add(std::string(1, "RGB"[c]), [&](size_t i) { return reference.image.rgb[3 * i + c]; });
        add(fmt::format("standardError.{}", "RGB"[c]), [&](size_t i) { return standardError(i, c); });
    }
    add("standardError.Y", [&](size_t i) {
        return 0.2126f * standardError(i, 0) + 0.7152f * standardError(i, 1) + 0.0722f * standardError(i, 2);
    });
    exr.attributes = attributesOf(reference, scene);
    return saveExr(path, exr);
}

}  // namespace glint
