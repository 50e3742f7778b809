#pragma once
#include <cstdint>
#include <memory>
#include <pybind11/pybind11.h>
#include <simreel/values.hpp>
#include <utility>
#include <vector>

namespace simreel::python {

// Layout of a tensor in DLPack's C interface, version 0 (dmlc/dlpack, "dlpack.h").
struct DlTensor {
  void* data;
  std::int32_t deviceType, deviceNumber;
  std::int32_t axes;
  std::uint8_t typeCode, bits;
  std::uint16_t lanes;
  std::int64_t* shape;
  std::int64_t* strides;  ///< in numbers
  std::uint64_t byteOffset;
};
struct DlManagedTensor {
  DlTensor tensor;
  void* owner;
  void (*destroy)(DlManagedTensor* self);
};

constexpr int dlpackCuda = 2;  ///< device type of CUDA

/// A tensor with what its pointers refer to.
struct DlOwned {
  simreel::DeviceArray array;
  std::vector<std::int64_t> shape, strides;
  DlManagedTensor managed{};
};

inline std::uint8_t dlpackCode(simreel::NumberType type) {
  switch (type) {
    case simreel::NumberType::int32:
      return 0;
    case simreel::NumberType::uint32:
    case simreel::NumberType::uint8:
      return 1;
    default:
      return 2;
  }
}

/// Returns a capsule "dltensor" that owns the array until a library takes it.
inline pybind11::capsule dlpackCapsule(simreel::DeviceArray array) {
  const int bytes = array.type == simreel::NumberType::float64 ? 8
                    : array.type == simreel::NumberType::uint8 ? 1
                                                               : 4;
  auto owned = std::make_unique<DlOwned>();
  owned->shape.assign(array.shape.begin(), array.shape.end());
  owned->strides.assign(owned->shape.size(), 1);
  for (std::size_t i = owned->shape.size(); i-- > 1;)
    owned->strides[i - 1] = owned->strides[i] * owned->shape[i];
  owned->array = std::move(array);
  DlTensor& tensor = owned->managed.tensor;
  tensor.data = owned->array.memory.get();
  tensor.deviceType = dlpackCuda;
  tensor.deviceNumber = owned->array.device;
  tensor.axes = static_cast<std::int32_t>(owned->shape.size());
  tensor.typeCode = dlpackCode(owned->array.type);
  tensor.bits = static_cast<std::uint8_t>(8 * bytes);
  tensor.lanes = 1;
  tensor.shape = owned->shape.data();
  tensor.strides = owned->strides.data();
  tensor.byteOffset = 0;
  owned->managed.owner = owned.get();
  owned->managed.destroy = [](DlManagedTensor* self) { delete static_cast<DlOwned*>(self->owner); };
  const auto forget = [](PyObject* capsule) {
    if (PyCapsule_IsValid(capsule, "dltensor") == 0) return;  // a library took it
    auto* untaken = static_cast<DlManagedTensor*>(PyCapsule_GetPointer(capsule, "dltensor"));
    untaken->destroy(untaken);
  };
  return pybind11::capsule(&owned.release()->managed, "dltensor", forget);
}

}  // namespace simreel::python
