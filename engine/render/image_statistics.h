// What an integrator keeps of one image from pass to pass beside the film.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/io/byte_stream.h"
#include "engine/math/vec.h"
#include "engine/render/integrator_map.h"
#include "engine/render/memory_use.h"

namespace glint {

class Film;

/// A part of the picture that whole passes refine, instead of adding samples to it: the photons' of SPPM.
/// Most integrators have none. It changes only when a whole pass is committed, and goes into checkpoints as
/// it is.
class ImageStatistics {
  public:
    virtual ~ImageStatistics() = default;
    virtual std::unique_ptr<ImageStatistics> clone() const = 0;
    /// Forgets every pass; they are of an image of this size from then on.
    virtual void reset(int width, int height) = 0;

    /// Whole passes that they hold. 0: they say nothing.
    virtual uint32_t passCount() const = 0;
    /// Added to the film's mean of a pixel, this makes the picture.
    virtual Vec3 radianceOf(size_t pixel) const = 0;
    /// Of that radiance's luminance, from the spread of the passes. Infinite with fewer than two.
    virtual double standardErrorOf(size_t pixel) const = 0;
    /// Estimate of that luminance's bias, signed; its own variance is about three times the luminance's.
    virtual double biasOf(size_t pixel) const = 0;
    /// The integrator's own pictures for displays.
    virtual std::vector<IntegratorMap> maps() const = 0;

    virtual size_t bytes() const = 0;
    virtual MemoryPart memoryPart() const = 0;

    /// Their section of a checkpoint.
    struct Section {
        std::string_view tag;  ///< 4 letters
        const char* name;      ///< what messages call it
    };
    virtual Section section() const = 0;
    /// About the size of that section for a picture of so many pixels.
    virtual size_t sectionBytes(size_t pixels) const = 0;
    virtual void write(ByteWriter* out) const = 0;
    /// False when the payload is not the statistics of `film`: another size or number of passes, or values
    /// that no render leaves behind.
    virtual bool read(ByteReader in, const Film& film) = 0;

  protected:
    ImageStatistics() = default;
    ImageStatistics(const ImageStatistics&) = default;
    ImageStatistics& operator=(const ImageStatistics&) = default;
};

}  // namespace glint
