// pbrt's textures as Glint's. Internal to the pbrt importer. engine/io/README.md says what becomes what.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/io/asset_cache.h"
#include "engine/io/pbrt_color.h"
#include "engine/io/pbrt_params.h"

namespace glint {

/// What a parameter says: a constant, or an image that Glint can show.
struct PbrtValue {
    Vec3 value{0.5f};
    std::optional<Texture> image = {};  ///< in place of the value; not in the scene yet
};

class PbrtTextures {
  public:
    PbrtTextures(PbrtContext* context, AssetCache* assets) : context_(*context), assets_(*assets) {}

    /// A Texture directive: its name, "float" or "spectrum", its kind.
    void define(const std::string& name, const std::string& type, const std::string& kind, PbrtParams params);

    /// The parameter, which may be a texture; nothing: there is none.
    std::optional<PbrtValue> color(const PbrtParams& params, std::string_view name, SpectrumRole role);
    std::optional<PbrtValue> number(const PbrtParams& params, std::string_view name);
    /// An image file as a colour, or as the numbers that are in it.
    PbrtValue imageFile(const PbrtParams& params, std::string_view name, ColorEncoding encoding);

    /// `a` times `b`, and `a` where amount is 0 to `b` where it is 1.
    PbrtValue scaled(const PbrtParams& at, const PbrtValue& a, const PbrtValue& b);
    PbrtValue mixed(const PbrtParams& at, const PbrtValue& a, const PbrtValue& b, const PbrtValue& amount);
    /// change(x) of each number of an image, in texels of its own; what is no image stays.
    PbrtValue changed(const PbrtParams& at, const PbrtValue& value,
                      const std::function<float(float)>& change);
    /// (base + gain x)^exponent; exponent: above 0.
    static PbrtValue adjusted(PbrtValue value, float base, float gain, float exponent);
    /// What a projection of that image sends to the plane at a distance of 1, for an intensity as the image
    /// has it: the image times the cube of the cosine to the axis, where the plane's shorter side reaches
    /// `tangent`. Nothing: it cannot be read.
    std::optional<PbrtValue> projected(const PbrtParams& at, const PbrtValue& image, float tangent,
                                       float* aspect);
    /// A goniometric light's image: its grey mean of the channels, in a square of equal areas, as it is or,
    /// from pbrt-v3, of longitude and latitude. Nothing: it cannot be read, or it is no square.
    std::optional<PbrtValue> goniometric(const PbrtParams& at, const PbrtValue& image, bool isLatLong);
    /// The mean over the image.
    Vec3 meanOf(const PbrtValue& value);

    /// What a material holds. An image that was asked for before is the same texture.
    ColorInput colorInput(const PbrtValue& value);
    NumberInput numberInput(const PbrtValue& value);

  private:
    struct Definition {
        std::string kind;
        PbrtParams params;
        std::optional<PbrtValue> value = {};  ///< once it has been asked for
        bool isOpen = false;                  ///< while it is
    };
    using Key = std::pair<bool, std::string>;  ///< whether it is of numbers, and its name

    PbrtValue named(const PbrtParams& at, const std::string& name, bool isNumber);
    PbrtValue make(const Definition& definition, bool isNumber);
    PbrtValue makeImage(const PbrtParams& params, bool isNumber);
    PbrtValue makeCheckerboard(const PbrtParams& params, bool isNumber);
    PbrtValue makeScale(const PbrtParams& params, bool isNumber);
    PbrtValue makeMix(const PbrtParams& params, bool isNumber);
    PbrtValue makeFourCorners(const PbrtParams& params, bool isNumber);
    PbrtValue makeDots(const PbrtParams& params, bool isNumber);
    PbrtValue makeNoise(const PbrtParams& params, std::string_view kind);
    PbrtValue part(const PbrtParams& params, std::string_view name, bool isNumber, float otherwise);
    void place(const PbrtParams& params, Texture* texture);
    void setEncoding(const PbrtParams& params, float scale, bool isInverted, Texture* texture);
    /// What the image shows, texel by texel; null, with a remark, where it cannot be read.
    std::shared_ptr<const ImageF> pixelsOf(const PbrtParams& at, const Texture& texture);
    /// The texture as one of numbers: the alpha of its image, or the mean of its channels.
    PbrtValue ofNumbers(const PbrtParams& at, const Texture& texture);
    /// One with the place of `texture` and texels of its own.
    PbrtValue baked(const Texture& texture, const ImageF& pixels);
    int add(const Texture& texture);

    PbrtContext& context_;
    AssetCache& assets_;
    std::map<Key, Definition> definitions_;
    std::map<std::string, int> added_;
    size_t baked_ = 0;
    int nesting_ = 0;
};

}  // namespace glint
