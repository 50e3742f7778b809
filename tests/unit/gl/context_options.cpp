#include "base/error.hpp"
#include "gl/context.hpp"

#include <doctest/doctest.h>

using simreel::gl::ContextOptions;

TEST_CASE("context options: each process takes the next device of the list") {
  const ContextOptions two{.device = "0,1", .debug = true, .memoryPath = "texel"};
  CHECK(two.deviceCount() == 2);
  CHECK(two.ofWorker(0).device == "0");
  CHECK(two.ofWorker(1).device == "1");
  CHECK(two.ofWorker(4).device == "0");
  CHECK(two.ofWorker(1).debug);
  CHECK(two.ofWorker(1).memoryPath == "texel");
  CHECK(ContextOptions{}.deviceCount() == 1);
  CHECK(ContextOptions{}.ofWorker(3).device.empty());
  ContextOptions named;
  named.device = "llvmpipe (LLVM 15.0.6, 256 bits),NVIDIA";
  CHECK(named.deviceCount() == 2);
  CHECK(named.ofWorker(2).device == "llvmpipe (LLVM 15.0.6, 256 bits)");
}

TEST_CASE("context options: hardware drivers refuse the texel path") {
  using simreel::gl::MemoryPath;
  ContextOptions options;
  CHECK(options.memoryPathOn(true, "llvmpipe") == MemoryPath::texel);
  CHECK(options.memoryPathOn(false, "NVIDIA H200") == MemoryPath::storage);
  options.memoryPath = "storage";
  CHECK(options.memoryPathOn(true, "llvmpipe") == MemoryPath::storage);
  options.memoryPath = "texel";
  CHECK(options.memoryPathOn(true, "llvmpipe") == MemoryPath::texel);
  CHECK_THROWS_WITH_AS(
      static_cast<void>(options.memoryPathOn(false, "NVIDIA H200")),
      doctest::Contains("is for software drivers; on NVIDIA H200 its results would be wrong"),
      simreel::UserError);
  options.memoryPath = "both";
  CHECK_THROWS_AS(static_cast<void>(options.memoryPathOn(true, "llvmpipe")), simreel::UserError);
}
