// A scene in device memory: the flat arrays of a BuiltScene, copied, and a SceneView that points to
// the copies.
//
// Owned by the CUDA back end. The parts of a BuiltScene are immutable and shared between builds, so an
// array at the same address as in the scene before, which is still alive, holds the same values and is not
// copied again.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "cuda/device_buffer.h"
#include "engine/base/result.h"
#include "engine/builders/built_scene.h"

namespace glint {

struct UploadReport {
    size_t arraysCopied = 0;
    size_t bytesCopied = 0;
    size_t arraysKept = 0;
    size_t bytesKept = 0;
};

class DeviceScene {
  public:
    /// The device must outlive the scene.
    explicit DeviceScene(Device& device) : device_(device) {}

    /// Copies what is new and frees what is no longer used. Error: it does not fit (said before anything is
    /// allocated), or the device failed; the device then holds no scene, and view() is empty.
    Status update(std::shared_ptr<const BuiltScene> scene);

    /// Device pointers, valid until the next update.
    const SceneView& view() const { return view_; }
    bool empty() const { return source_ == nullptr; }
    const UploadReport& lastUpload() const { return report_; }
    /// Device memory held, as allocated.
    size_t bytes() const;

  private:
    /// An array in host memory. Its address names it while the scene it belongs to lives.
    struct ArrayKey {
        const void* host;
        size_t bytes;
        auto operator<=>(const ArrayKey&) const = default;
    };
    /// Where an array's copy is. Small arrays share blocks.
    struct Copy {
        std::shared_ptr<DeviceBuffer> block;
        size_t offset = 0;
        std::byte* address() const { return block->data() + offset; }
    };
    /// A block to be allocated and what goes where in it.
    struct BlockPlan {
        size_t bytes = 0;
        std::vector<std::pair<ArrayKey, size_t>> arrays;  ///< with their offsets
    };

    Status updateFrom(const SceneView& host);
    std::vector<ArrayKey> keepShared(const SceneView& host);
    static std::vector<BlockPlan> planBlocks(const std::vector<ArrayKey>& arrays);
    Status copyBlock(const BlockPlan& plan);
    Status copyTables(const SceneView& host);
    template <class T>
    void redirect(const T*& pointer, size_t count) const;
    void clear();

    Device& device_;
    std::shared_ptr<const BuiltScene> source_;  ///< keeps the addresses in copies_ from being used again
    std::map<ArrayKey, Copy> copies_;
    DeviceBuffer tables_;  ///< of meshes and textures, with device pointers
    SceneView hostView_;   ///< of source_
    SceneView view_;
    UploadReport report_;
};

}  // namespace glint
