// One block of device memory, freed with its owner.
#pragma once

#include <utility>

#include "cuda/device.h"

namespace glint {

class DeviceBuffer {
  public:
    DeviceBuffer() = default;
    DeviceBuffer(const DeviceBuffer&) = delete;
    DeviceBuffer& operator=(const DeviceBuffer&) = delete;
    DeviceBuffer(DeviceBuffer&& other) noexcept { swap(other); }
    DeviceBuffer& operator=(DeviceBuffer&& other) noexcept {
        DeviceBuffer(std::move(other)).swap(*this);
        return *this;
    }
    ~DeviceBuffer() {
        if (data_) { device_->release(data_); }
    }

    /// `bytes` > 0. The device must outlive the buffer. Error: not as much is free.
    static Result<DeviceBuffer> allocate(Device& device, size_t bytes) {
        Result<std::byte*> block = device.allocate(bytes);
        if (!block) { return block.error(); }
        DeviceBuffer buffer;
        buffer.device_ = &device;
        buffer.data_ = *block;
        buffer.bytes_ = bytes;
        return buffer;
    }

    /// Makes it at least so large; keeps what is large enough, and frees the rest before it takes more.
    Status reserve(Device& device, size_t bytes) {
        if (bytes <= bytes_) { return {}; }
        *this = DeviceBuffer();
        Result<DeviceBuffer> larger = allocate(device, bytes);
        if (!larger) { return larger.error(); }
        *this = std::move(*larger);
        return {};
    }

    /// The block as an array.
    template <class T>
    T* as() const {
        return reinterpret_cast<T*>(data_);
    }
    std::byte* data() const { return data_; }
    size_t bytes() const { return bytes_; }

  private:
    void swap(DeviceBuffer& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(data_, other.data_);
        std::swap(bytes_, other.bytes_);
    }

    Device* device_ = nullptr;
    std::byte* data_ = nullptr;
    size_t bytes_ = 0;
};

}  // namespace glint
