#pragma once
#include <ImfIO.h>
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string_view>

namespace simreel::sim {

/// Input stream for the OpenEXR library that reads bytes in memory.
class ExrStream final : public Imf::IStream {
 public:
  explicit ExrStream(std::string_view bytes) : IStream("picture"), bytes_(bytes) {}
  bool read(char to[], int count) override {
    const auto wanted = static_cast<std::size_t>(std::max(count, 0));
    if (at_ > bytes_.size() || wanted > bytes_.size() - at_) {
      beyond_ = true;
      throw std::runtime_error("unexpected end");
    }
    std::memcpy(to, bytes_.data() + at_, wanted);
    at_ += wanted;
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t position) override { at_ = position; }
  void clear() override {}
  /// Returns true if a read went beyond the end.
  [[nodiscard]] bool beyond() const { return beyond_; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  bool beyond_ = false;
};

}  // namespace simreel::sim
