// `glint beside`: a picture that another program made of a scene, and Glint's, side by side at equal tone.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/base/console.h"
#include "engine/io/file_path.h"
#include "engine/io/image_io.h"
#include "engine/render/render_session.h"
#include "engine/render/snapshot.h"
#include "engine/render/tonemap.h"
#include "viewer/base/interrupt.h"
#include "viewer/base/make_backend.h"
#include "viewer/base/progress.h"
#include "viewer/base/run_files.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/scene_opening.h"
#include "viewer/commands/scene_overrides.h"

namespace glint {
namespace {

constexpr const char* kBesideFooter =
    R"(The scene is rendered at the picture's size with --as-original, which other options change. Where a channel of the
picture is full, Glint's counts as full, too, so that noise darkens it: --reduce, and more passes, help. What is
printed: the mean of each channel and the stops between the two.

Example:
  glint beside published/scene18_dof_0.pt.png testcases/scene18_dof_0.txt -o dof.png --depth 4)";

struct BesideOptions {
    std::string image, scene, output;
    uint32_t passes = 64;
    int reduce = 1;
    bool isSrgb = false;
    int threads = 0;
    SceneOverrides overrides;
    LoadOptions load;
};

/// Linear, as stored unless `isSrgb`.
Result<ImageF> readImage(const std::string& path, bool isSrgb) {
    const Result<SceneImage> image = loadImage(path);
    if (!image) { return image.error(); }
    if (isSrgb || image->floats) { return *linearColors(*image); }
    ImageF out{image->bytes->width, image->bytes->height, {}};
    for (const uint8_t byte : image->bytes->rgb) {
        out.rgb.push_back(static_cast<float>(byte) / 255.0f);
    }
    return out;
}

/// Means of squares of `side` pixels; what is left at the right and the bottom is cut off.
ImageF reduced(const ImageF& image, int side) {
    ImageF out{image.width / side, image.height / side, {}};
    const float weight = 1.0f / static_cast<float>(side * side);
    for (int i = 0; i < 3 * out.width * out.height; ++i) {
        const int channel = i % 3, x = i / 3 % out.width * side, y = i / 3 / out.width * side;
        float sum = 0.0f;
        for (int pixel = 0; pixel < side * side; ++pixel) {
            const int at = (y + pixel / side) * image.width + x + pixel % side;
            sum += image.rgb[3 * static_cast<size_t>(at) + static_cast<size_t>(channel)];
        }
        out.rgb.push_back(sum * weight);
    }
    return out;
}

/// What there is when the user interrupts, too.
Result<ImageF> render(std::shared_ptr<const SceneDescription> scene, const BesideOptions& o,
                      const InterruptGuard& interrupt) {
    auto backend = makeBackend("cpu", o.threads);
    if (!backend) { return backend.error(); }
    RenderSession session(std::move(*backend), {.previews = false, .snapshots = false, .threads = o.threads});
    const StopLimits limits{.passes = o.passes};
    session.request({.limits = limits});
    session.post({std::move(scene), EditKind::Everything});
    ProgressLine progress;
    SessionState state = SessionState::Empty;
    while (state != SessionState::Finished && state != SessionState::Failed && !interrupt.interrupted()) {
        state = session.wait(0.1);
        progress.update(session.status(), limits);
    }
    progress.finish();
    const auto capture = session.capture();
    if (!capture || state == SessionState::Failed) { return Error{"nothing was rendered", {}}; }
    const auto image = makeSnapshot(*capture, {}, o.threads);
    return ImageF{image->width, image->height, image->radiance};
}

Vec3 meanOf(const ImageF& image, float gain) {
    double sums[3] = {};
    for (size_t i = 0; i < image.rgb.size(); ++i) {
        sums[i % 3] += std::min(1.0, static_cast<double>(image.rgb[i] * gain));
    }
    const double pixels = static_cast<double>(image.rgb.size()) / 3.0;
    return {static_cast<float>(sums[0] / pixels), static_cast<float>(sums[1] / pixels),
            static_cast<float>(sums[2] / pixels)};
}

/// The exposure that gives `image`, cut to white, that mean luminance.
float stopsTo(float mean, const ImageF& image) {
    float low = -24.0f, high = 24.0f;
    for (int i = 0; i < 40; ++i) {
        const float middle = 0.5f * (low + high);
        (luminance(meanOf(image, std::exp2(middle))) < mean ? low : high) = middle;
    }
    return 0.5f * (low + high);
}

Image8 besideEachOther(const ImageF& left, const ImageF& right, float rightStops) {
    constexpr int kGap = 4;
    Image8 out{left.width + kGap + right.width, left.height, {}};
    out.rgb.assign(size_t{3} * static_cast<size_t>(out.width) * static_cast<size_t>(out.height), 0);
    const auto draw = [&out](const ImageF& image, int atX, float stops) {
        for (size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
            const size_t width = static_cast<size_t>(image.width), pixel = i / 3;
            const size_t to = 3 * (pixel / width * static_cast<size_t>(out.width) + pixel % width +
                                   static_cast<size_t>(atX));
            const Vec3 shown =
                toneMapped({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]}, stops, ToneMap::Srgb);
            for (int c = 0; c < 3; ++c) {
                out.rgb[to + static_cast<size_t>(c)] = displayByte(shown[c]);
            }
        }
    };
    draw(left, 0, 0.0f);
    draw(right, left.width + kGap, rightStops);
    return out;
}

int runBeside(BesideOptions* o) {
    if (!hasExtension(o->output, ".png")) {
        return reportError({fmt::format("-o {}: expected a name that ends in .png", o->output), {}},
                           kExitBadInput);
    }
    RunFiles files;
    files.reads("the picture", o->image);
    files.reads("the scene", o->scene);
    if (Status writable = files.writes(o->output); !writable) {
        return reportError(writable.error(), kExitBadInput);
    }
    Result<ImageF> image = readImage(o->image, o->isSrgb);
    if (!image) { return reportError(image.error(), kExitBadInput); }
    if (o->reduce > std::min(image->width, image->height)) {
        return reportError({"--reduce leaves nothing of the picture", {.file = o->image}}, kExitBadInput);
    }
    if (o->reduce > 1) { *image = reduced(*image, o->reduce); }
    auto scene = openScene(o->scene, o->load);
    if (!scene) { return reportError(scene.error(), kExitBadInput); }
    files.readsScene(*scene);
    if (Status checked = files.check(); !checked) { return reportError(checked.error(), kExitBadInput); }
    o->overrides.asOriginal = true;
    Status applied = applyTo(o->overrides, &*scene);
    if (!applied) { return reportError(applied.error(), kExitBadInput); }
    scene->resolution = {image->width, image->height};
    const InterruptGuard interrupt;
    const auto rendered = render(std::make_shared<SceneDescription>(std::move(*scene)), *o, interrupt);
    if (!rendered) { return reportError(rendered.error(), kExitFailed); }
    const Vec3 theirs = meanOf(*image, 1.0f), ours = meanOf(*rendered, 1.0f);
    const float stops = stopsTo(luminance(theirs), *rendered);
    put("{}: mean {:.3f} {:.3f} {:.3f}; Glint {:.3f} {:.3f} {:.3f}, shown {:+.2f} stops brighter\n", o->image,
        theirs.x, theirs.y, theirs.z, ours.x, ours.y, ours.z, stops);
    const Status saved = savePng(o->output, besideEachOther(*image, *rendered, stops));
    if (!saved) { return reportError(saved.error(), kExitFailed); }
    return interrupt.interrupted() ? kExitInterrupted : kExitDone;
}

}  // namespace

void addBesideCommand(const Command& program) {
    const Command command = program.subcommand(
        "beside", "Puts a picture that another program made of a scene beside Glint's, at equal tone");
    const auto o = std::make_shared<BesideOptions>();
    command.option("picture", &o->image, "The picture; 8-bit files are linear without a gamma")
        .required()
        .typeName("PICTURE");
    command.option("scene", &o->scene, "The scene").required().typeName("SCENE");
    command.option("-o,--output", &o->output, "The PNG to write").required().typeName("OUT");
    command.option("--passes", &o->passes, "Samples per pixel").range(1u, 1'000'000u).showDefault();
    command.option("--reduce", &o->reduce, "Reduce the picture to means of squares of so many pixels a side")
        .range(1, 64)
        .showDefault();
    command.flag("--srgb", &o->isSrgb, "The picture's bytes are sRGB-encoded");
    command.option("--threads", &o->threads, "Render threads; all by default").range(1, 1024);
    addSceneOverrides(command, &o->overrides);
    addLoadOptions(command, &o->load);
    command.footer(kBesideFooter);
    command.onRun([o] { return runBeside(o.get()); });
}

}  // namespace glint
