// Packs what is new of a scene into device blocks, and points a SceneView at the copies.

#include "cuda/device_scene.h"

#include <cstring>
#include <set>

#include "cuda/device_memory.h"
#include "cuda/scene_arrays.h"

namespace glint {
namespace {

/// Arrays from this size on get a block of their own, which is freed as soon as they are replaced; smaller
/// ones share a block, since a driver takes long to allocate one and rounds its size up.
constexpr size_t kOwnBlockBytes = 256 * 1024;

size_t aligned(size_t bytes) {
    return (bytes + Device::kArrayAlignment - 1) / Device::kArrayAlignment * Device::kArrayAlignment;
}

size_t meshTableBytes(const SceneView& host) {
    return aligned(host.geometry.meshes.count * sizeof(MeshView));
}
size_t tableBytes(const SceneView& host) {
    return meshTableBytes(host) + aligned(host.textures.count * sizeof(TextureView));
}

std::vector<MeshView> copyOf(const View<MeshView>& table) { return {table.data, table.data + table.count}; }
std::vector<TextureView> copyOf(const View<TextureView>& table) {
    return {table.data, table.data + table.count};
}

/// Calls visit(pointer, count) for every array of the scene, those of its meshes and textures included.
template <class Visit>
void forEachArrayOfScene(SceneView view, Visit&& visit) {
    for (MeshView& mesh : copyOf(view.geometry.meshes)) {
        forEachArray(mesh, visit);
    }
    for (TextureView& texture : copyOf(view.textures)) {
        forEachArray(texture, visit);
    }
    forEachArray(view, visit);
}

}  // namespace

Status DeviceScene::update(std::shared_ptr<const BuiltScene> scene) {
    const SceneView host = scene->view();
    if (Status s = updateFrom(host); !s) {
        clear();
        return s;
    }
    // Only now may the addresses of the scene before be used again.
    source_ = std::move(scene);
    hostView_ = host;
    return {};
}

Status DeviceScene::updateFrom(const SceneView& host) {
    report_ = {};
    const std::vector<ArrayKey> fresh = keepShared(host);
    const bool tablesKept =
        fresh.empty() && source_ && host.geometry.meshes.data == hostView_.geometry.meshes.data &&
        host.geometry.meshes.count == hostView_.geometry.meshes.count &&
        host.textures.data == hostView_.textures.data && host.textures.count == hostView_.textures.count;
    if (!tablesKept) { tables_ = {}; }

    const std::vector<BlockPlan> plans = planBlocks(fresh);
    size_t needed = tablesKept ? 0 : tableBytes(host);
    for (const BlockPlan& plan : plans) {
        needed += plan.bytes;
    }
    if (Status s = checkFits(device_, "The scene needs", needed); !s) { return s; }
    for (const BlockPlan& plan : plans) {
        if (Status s = copyBlock(plan); !s) { return s; }
    }
    if (!tablesKept) {
        if (Status s = copyTables(host); !s) { return s; }
    }

    view_ = host;
    forEachArray(view_, [&](auto& pointer, size_t count) { redirect(pointer, count); });
    view_.geometry.meshes.data = reinterpret_cast<const MeshView*>(tables_.data());
    view_.textures.data = reinterpret_cast<const TextureView*>(tables_.data() + meshTableBytes(host));
    return {};
}

/// Frees the copies that `host` does not use, and answers the arrays that have no copy yet.
std::vector<DeviceScene::ArrayKey> DeviceScene::keepShared(const SceneView& host) {
    std::set<ArrayKey> used;
    forEachArrayOfScene(host, [&](const auto* pointer, size_t count) {
        if (pointer && count != 0) { used.insert({pointer, count * sizeof(*pointer)}); }
    });
    std::erase_if(copies_, [&](const auto& entry) { return !used.contains(entry.first); });
    std::vector<ArrayKey> fresh;
    for (const ArrayKey& key : used) {
        if (!copies_.contains(key)) {
            fresh.push_back(key);
            continue;
        }
        ++report_.arraysKept;
        report_.bytesKept += key.bytes;
    }
    return fresh;
}

std::vector<DeviceScene::BlockPlan> DeviceScene::planBlocks(const std::vector<ArrayKey>& arrays) {
    std::vector<BlockPlan> plans;
    BlockPlan shared;
    for (const ArrayKey& key : arrays) {
        if (key.bytes >= kOwnBlockBytes) {
            plans.push_back({aligned(key.bytes), {{key, 0}}});
        } else {
            shared.arrays.emplace_back(key, shared.bytes);
            shared.bytes += aligned(key.bytes);
        }
    }
    if (!shared.arrays.empty()) { plans.push_back(std::move(shared)); }
    return plans;
}

Status DeviceScene::copyBlock(const BlockPlan& plan) {
    Result<DeviceBuffer> buffer = DeviceBuffer::allocate(device_, plan.bytes);
    if (!buffer) { return buffer.error(); }
    const auto block = std::make_shared<DeviceBuffer>(std::move(*buffer));
    std::vector<std::byte> packed(plan.arrays.size() > 1 ? plan.bytes : 0);
    for (const auto& [key, offset] : plan.arrays) {
        if (!packed.empty()) { std::memcpy(packed.data() + offset, key.host, key.bytes); }
        copies_[key] = {block, offset};
        ++report_.arraysCopied;
        report_.bytesCopied += key.bytes;
    }
    if (!packed.empty()) { return device_.upload(block->data(), packed.data(), packed.size()); }
    const ArrayKey& only = plan.arrays.front().first;
    return device_.upload(block->data(), only.host, only.bytes);
}

/// Meshes first, then textures, in one block.
Status DeviceScene::copyTables(const SceneView& host) {
    const size_t bytes = tableBytes(host);
    if (bytes == 0) { return {}; }
    std::vector<MeshView> meshes = copyOf(host.geometry.meshes);
    std::vector<TextureView> textures = copyOf(host.textures);
    const auto redirectArray = [&](auto& pointer, size_t count) { redirect(pointer, count); };
    for (MeshView& mesh : meshes) {
        forEachArray(mesh, redirectArray);
    }
    for (TextureView& texture : textures) {
        forEachArray(texture, redirectArray);
    }

    std::vector<std::byte> packed(bytes);
    if (!meshes.empty()) { std::memcpy(packed.data(), meshes.data(), meshes.size() * sizeof(MeshView)); }
    if (!textures.empty()) {
        std::memcpy(packed.data() + meshTableBytes(host), textures.data(),
                    textures.size() * sizeof(TextureView));
    }
    Result<DeviceBuffer> buffer = DeviceBuffer::allocate(device_, bytes);
    if (!buffer) { return buffer.error(); }
    tables_ = std::move(*buffer);
    return device_.upload(tables_.data(), packed.data(), bytes);
}

/// From the host's array to its copy; null for an array without elements.
template <class T>
void DeviceScene::redirect(const T*& pointer, size_t count) const {
    if (!pointer || count == 0) {
        pointer = nullptr;
        return;
    }
    pointer = reinterpret_cast<const T*>(copies_.at({pointer, count * sizeof(T)}).address());
}

size_t DeviceScene::bytes() const {
    std::set<const DeviceBuffer*> blocks;
    size_t sum = tables_.bytes();
    for (const auto& [key, copy] : copies_) {
        if (blocks.insert(copy.block.get()).second) { sum += copy.block->bytes(); }
    }
    return sum;
}

void DeviceScene::clear() {
    copies_.clear();
    tables_ = {};
    source_ = nullptr;
    hostView_ = {};
    view_ = {};
}

}  // namespace glint
