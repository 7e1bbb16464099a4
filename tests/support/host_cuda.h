// The CUDA back end on a device of host memory, and scenes built for it. Header only, as host_device.h.
#pragma once

#include <memory>

#include <gtest/gtest.h>

#include "cuda/cuda_backend.h"
#include "engine/builders/scene_builder.h"
#include "tests/support/host_device.h"

namespace glint::test {

inline std::shared_ptr<const BuiltScene> build(const SceneDescription& description) {
    const SceneEdit edit{std::make_shared<SceneDescription>(description), EditKind::Everything};
    auto scene = buildScene(edit, nullptr, 0, nullptr, nullptr);
    EXPECT_TRUE(scene) << scene.error().message;
    return *scene;
}

struct HostCuda {
    std::shared_ptr<HostDeviceControl> control = std::make_shared<HostDeviceControl>();
    std::unique_ptr<Backend> backend = makeCudaBackend(std::make_unique<HostDevice>(control));
};

}  // namespace glint::test
