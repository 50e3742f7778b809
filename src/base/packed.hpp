#pragma once
#include "base/error.hpp"

#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace simreel {

/// Serializes values to bytes for another process of the same program (runIsolated). A list or text is
/// written as its length followed by its items. A struct declares its members once for both directions in a
/// member function: `template <class A> void pack(A& a)`.
class Packer {
 public:
  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_trivially_copyable_v<T>)
      bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    else
      value.pack(*this);
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    length(list.size());
    if constexpr (std::is_trivially_copyable_v<T>)
      bytes_.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T));
    else
      for (T& item : list) (*this)(item);
  }
  void operator()(std::string& text) {
    length(text.size());
    bytes_ += text;
  }
  [[nodiscard]] std::string release() { return std::move(bytes_); }

 private:
  void length(std::size_t size) { bytes_.append(reinterpret_cast<const char*>(&size), sizeof size); }
  std::string bytes_;
};

/// Restores values from the bytes of a Packer, in the same order.
class Unpacker {
 public:
  explicit Unpacker(const std::string& bytes) : bytes_(bytes) {}

  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_trivially_copyable_v<T>)
      copy(&value, sizeof value);
    else
      value.pack(*this);
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    list.resize(length());
    if constexpr (std::is_trivially_copyable_v<T>)
      copy(list.data(), list.size() * sizeof(T));
    else
      for (T& item : list) (*this)(item);
  }
  void operator()(std::string& text) {
    text.resize(length());
    copy(text.data(), text.size());
  }

 private:
  std::size_t length() {
    std::size_t size = 0;
    copy(&size, sizeof size);
    SIMREEL_CHECK(size <= bytes_.size());
    return size;
  }
  void copy(void* to, std::size_t size) {
    SIMREEL_CHECK(size <= bytes_.size() - at_);
    if (size > 0) std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }
  const std::string& bytes_;
  std::size_t at_ = 0;
};

/// packed() converts a value to bytes, and unpacked() converts the bytes back.
template <class T>
[[nodiscard]] std::string packed(T value) {
  Packer packer;
  packer(value);
  return packer.release();
}
template <class T>
[[nodiscard]] T unpacked(const std::string& bytes) {
  T value;
  Unpacker unpacker(bytes);
  unpacker(value);
  return value;
}

}  // namespace simreel
