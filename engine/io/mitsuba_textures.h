// Mitsuba's textures as Glint's. Internal to the Mitsuba importer.
#pragma once

#include <functional>
#include <map>
#include <tuple>

#include "engine/io/asset_cache.h"
#include "engine/io/baked_image.h"
#include "engine/io/mitsuba_object.h"

namespace glint {

/// From where a shape's v is counted in Mitsuba's images: its texture coordinates are Mitsuba's, or have 1
/// - v.
enum class UvOrigin : uint8_t { Top, Bottom };

class MitsubaTextures {
  public:
    MitsubaTextures(MitsubaContext* context, AssetCache* assets) : context_(*context), assets_(*assets) {}

    /// A colour. `change` (may be null) is applied to each texel.
    using Change = std::function<Vec3(const Vec3&)>;
    ColorInput color(const MitsubaElement& texture, UvOrigin origin, const Change& change = nullptr);
    /// A number: the luminance of the texture, or of what `change` makes of it.
    NumberInput number(const MitsubaElement& texture, UvOrigin origin, const Change& change = nullptr);
    /// The mean of the texture, for models that cannot have one.
    Vec3 meanOf(const MitsubaElement& texture);
    /// The largest value of each channel.
    Vec3 mostOf(const MitsubaElement& texture);
    /// The name of the mesh attribute that the texture shows; empty: it is another one.
    std::string_view attributeOf(const MitsubaElement& texture);

  private:
    enum class Use : uint8_t { Color, Number };

    int take(const MitsubaElement& texture, UvOrigin origin, Use use, const Change& change);
    Texture makeBitmap(MitsubaObject* object, UvOrigin origin, Use use, const Change& change);
    Texture makeCheckerboard(MitsubaObject* object, UvOrigin origin, const Change& change);
    void place(MitsubaObject* object, UvOrigin origin, Texture* texture);
    /// The texels of a texture that is shown as it is; nothing where it cannot be read.
    std::shared_ptr<const ImageF> pixelsOf(const MitsubaElement& texture);
    /// The image's texels as linear colours; nothing, with a remark, where it cannot be read.
    std::shared_ptr<const ImageF> pixelsOf(MitsubaObject* object, const ImageSource& source, bool isRaw);

    MitsubaContext& context_;
    AssetCache& assets_;
    std::map<std::tuple<const MitsubaElement*, UvOrigin, Use>, int> taken_;
};

}  // namespace glint
