#include "golden/baseline/profile.hpp"

#include <algorithm>

#include <doctest/doctest.h>

using namespace simreel::golden;

namespace {

std::string profile(const char* renderer) {
  return profileName(renderer, true);
}

}  // namespace

TEST_CASE("profiles of software drivers are named by driver") {
  CHECK(profileName("llvmpipe (LLVM 15.0.6, 256 bits)", true) == "llvmpipe-fma");
  CHECK(profileName("llvmpipe (LLVM 15.0.6, 256 bits)", false) == "llvmpipe");
  CHECK(profileName("Gallium 0.4 on llvmpipe (LLVM 3.5, 256 bits)", false) == "llvmpipe");
  CHECK(profile("softpipe") == "softpipe");
}

TEST_CASE("profiles of NVIDIA devices are named by architecture") {
  const auto all = [](const char* family, std::initializer_list<const char*> renderers) {
    for (const char* renderer : renderers) {
      INFO(renderer);
      CHECK(profile(renderer) == std::string("nvidia-") + family);
    }
  };
  all("blackwell", {"NVIDIA B200/PCIe/SSE2", "NVIDIA GB200/PCIe", "NVIDIA B100", "NVIDIA Tegra NVIDIA GB10",
                    "NVIDIA GeForce RTX 5070 Ti Laptop GPU/PCIe/SSE2", "NVIDIA GeForce RTX 5090/PCIe/SSE2",
                    "NVIDIA RTX PRO 6000 Blackwell Workstation Edition/PCIe/SSE2"});
  all("hopper", {"NVIDIA H200/PCIe/SSE2", "NVIDIA H100 80GB HBM3/PCIe/SSE2", "NVIDIA H100 PCIe/PCIe/SSE2",
                 "NVIDIA GH200 480GB/PCIe"});
  all("ada", {"NVIDIA L4/PCIe/SSE2", "NVIDIA L40S/PCIe/SSE2", "NVIDIA L40/PCIe/SSE2",
              "NVIDIA GeForce RTX 4090/PCIe/SSE2", "NVIDIA GeForce RTX 4060 Laptop GPU/PCIe/SSE2",
              "NVIDIA RTX 6000 Ada Generation/PCIe/SSE2", "NVIDIA RTX 5000 Ada Generation/PCIe/SSE2"});
  all("ampere", {"NVIDIA A100-SXM4-40GB/PCIe/SSE2", "NVIDIA A10G/PCIe/SSE2", "NVIDIA A10/PCIe/SSE2",
                 "NVIDIA A30/PCIe/SSE2", "NVIDIA A40-48Q/PCIe/SSE2", "NVIDIA RTX A6000/PCIe/SSE2",
                 "NVIDIA RTX A1000 Laptop GPU/PCIe/SSE2", "NVIDIA GeForce RTX 3050 Ti Laptop GPU/PCIe/SSE2",
                 "NVIDIA GeForce RTX 3080 Ti/PCIe/SSE2", "NVIDIA GeForce RTX 2050/PCIe/SSE2"});
  all("turing", {"Tesla T4/PCIe/SSE2", "NVIDIA GeForce RTX 2060/PCIe/SSE2", "Quadro RTX 6000/PCIe/SSE2",
                 "Quadro RTX 4000/PCIe/SSE2", "Quadro RTX 5000/PCIe/SSE2", "GeForce GTX 1650/PCIe/SSE2",
                 "NVIDIA GeForce GTX 1660 SUPER/PCIe/SSE2", "NVIDIA TITAN RTX/PCIe/SSE2",
                 "NVIDIA T1000/PCIe/SSE2", "GRID T4-8Q/PCIe/SSE2"});
  all("volta", {"Tesla V100-SXM2-16GB/PCIe/SSE2", "Quadro GV100/PCIe/SSE2", "NVIDIA TITAN V/PCIe/SSE2"});
  all("pascal",
      {"Tesla P100-PCIE-16GB/PCIe/SSE2", "GeForce GTX 1080/PCIe/SSE2", "GeForce GTX 1050 Ti/PCIe/SSE2",
       "GeForce GT 1030/PCIe/SSE2", "Quadro P2000/PCIe/SSE2", "TITAN X (Pascal)/PCIe/SSE2"});
  all("geforce-gtx-970", {"GeForce GTX 970/PCIe/SSE2", "NVIDIA GeForce GTX 970/PCIe/SSE2"});
  all("tesla-m60", {"Tesla M60/PCIe/SSE2"});
  all("tegra-xavier-nvgpu", {"NVIDIA Tegra Xavier (nvgpu)/integrated"});
}

TEST_CASE("profiles of AMD devices are named by chip") {
  CHECK(profile("AMD Radeon RX 6800 (radeonsi, navi21, LLVM 15.0.7, DRM 3.49)") == "amd-navi21");
  CHECK(profile("AMD Radeon RX 6700 XT (navi22, LLVM 15.0.7, DRM 3.49, 6.1.0)") == "amd-navi22");
  CHECK(profile("AMD Radeon (TM) RX 480 Graphics (POLARIS10, DRM 3.35.0, 5.4.0-70-generic, LLVM 10.0.0)") ==
        "amd-polaris10");
  CHECK(profile("NAVI22 (navi22, LLVM 14.0.6, DRM 3.48, 6.0.1-arch2-1)") == "amd-navi22");
  CHECK(profile("AMD Radeon Graphics (radeonsi, raphael, ACO, DRM 3.54)") == "amd-raphael");
  CHECK(profile("AMD Radeon Graphics (radeonsi, gfx1151, LLVM 20.1.8)") == "amd-gfx1151");
  CHECK(profile("AMD RAVEN (DRM 3.38.0, 5.8.0-7630-generic, LLVM 11.0.0)") == "amd-raven");
  CHECK(profile("AMD Radeon RX 6800 XT") == "amd-radeon-rx-6800-xt");
}

TEST_CASE("profiles of Intel devices are named by device") {
  CHECK(profile("Mesa Intel(R) UHD Graphics 630 (CFL GT2)") == "intel-uhd-630");
  CHECK(profile("Intel(R) UHD Graphics 630") == "intel-uhd-630");
  CHECK(profile("Mesa Intel(R) HD Graphics 530 (SKL GT2)") == "intel-hd-530");
  CHECK(profile("Mesa Intel(R) UHD Graphics (TGL GT1)") == "intel-uhd-tgl-gt1");
  CHECK(profile("Mesa Intel(R) UHD Graphics (CML GT2)") == "intel-uhd-cml-gt2");
  CHECK(profile("Mesa Intel(R) Graphics (ADL GT2)") == "intel-adl-gt2");
  CHECK(profile("Mesa Intel(R) Iris(R) Xe Graphics (TGL GT2)") == "intel-xe");
  CHECK(profile("Mesa Intel(R) Arc(tm) A770 Graphics (DG2)") == "intel-arc");
  CHECK(profile("Mesa DRI Intel(R) HD Graphics 4000 (IVB GT2)") == "intel-hd-4000");
}

TEST_CASE("profiles of layered and unknown drivers are named") {
  CHECK(profile("zink Vulkan 1.3(AMD Radeon RX 7800 XT (RADV NAVI32))") ==
        "zink-amd-radeon-rx-7800-xt-radv");
  CHECK(profile("zink Vulkan 1.3(NVIDIA GeForce GTX 1070 (NVK GP104-A) (MESA_NVK))") ==
        "zink-nvidia-pascal");
  CHECK(profile("zink Vulkan 1.3(llvmpipe (LLVM 22.1.8, 256 bits) (MESA_LLVMPIPE))") ==
        "zink-llvmpipe-fma");
  CHECK(profile("D3D12 (NVIDIA GeForce RTX 3060)") == "d3d12-nvidia-ampere");
  CHECK(profile("virgl (Mesa Intel(R) UHD Graphics 620 (KBL GT2))") == "virgl-intel-uhd-620");
  CHECK(profile("V3D 4.2") == "v3d-4-2");
  CHECK(profile("Mali-G78 MC20") == "mali-g78-mc20");
  CHECK(profile("NV136") == "nv136");
  CHECK(profile("") == "unknown");
  CHECK(profile("(((") == "unknown");
  CHECK(profile("zink(") == "zink-unknown");
  CHECK(profile("zink )(") == "zink-unknown");
}

TEST_CASE("a profile name is a valid folder name for any renderer string") {
  std::uint32_t random = 7;
  const std::string pieces[] = {"NVIDIA ", "AMD ", "Intel(R) ",         "/",    "..",   "(",    ")", ", ",
                                "\xFF",    "\n",   "A very long name ", "zink", "UHD ", "Arc ", " 9"};
  for (int round = 0; round < 500; ++round) {
    std::string renderer;
    for (int i = 0; i < 7; ++i)
      renderer += pieces[(random = random * 747796405U + 2891336453U) % std::size(pieces)];
    const std::string name = profileName(renderer, true);
    INFO(renderer, " -> ", name);
    CHECK(!name.empty());
    CHECK(name.size() <= 32);
    CHECK(name.front() != '-');
    CHECK(name.back() != '-');
    CHECK(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos);
  }
  CHECK(profile("The Longest Name That Ever A Driver Gave") == "the-longest-name-that-ever-a-dri");
  CHECK(ownProfile("llvmpipe") == profileName("llvmpipe", processorHasFma()));
}
