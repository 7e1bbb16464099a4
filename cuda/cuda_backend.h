// The CUDA back end: the path and photon kernels of engine/kernels on a GPU, behind the renderer's Backend.
//
// Made by viewer/base/make_backend.cpp. Nothing else of Glint needs nvcc or knows that there is a GPU.
#pragma once

#include <memory>

#include "engine/base/result.h"
#include "engine/render/backend.h"

namespace glint {

class Device;

/// On the first GPU. Error: this machine has none that can be used; why, as a clause without full stop.
Result<std::unique_ptr<Backend>> makeCudaBackend();

/// On any device: how tests run it without a GPU.
std::unique_ptr<Backend> makeCudaBackend(std::unique_ptr<Device> device);

}  // namespace glint
