#include "base/frame_check.hpp"

#include <atomic>

namespace simreel {

namespace {

std::atomic<void (*)()> present = nullptr;

}  // namespace

void setFrameCheck(void (*check)()) {
  present = check;
}

void checkFrame() {
  if (auto* check = present.load()) check();
}

}  // namespace simreel
