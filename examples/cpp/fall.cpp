// Example of the library libsimreel: simulates a falling cloth, prints its height, and writes its picture.
#include <cstdio>
#include <fstream>
#include <simreel/simreel.hpp>

constexpr const char* scene = R"({
  "version": 2,
  "render": {"size": [320, 180]},
  "objects": {"sheet": {"cloth": {"size": [40, 30], "spacing": 0.05, "position": [0, 2, 0]}}}
})";

int main() {
  try {
    const simreel::Device device = simreel::Device::open();
    simreel::Scene run = simreel::Scene::parse(device, scene);
    std::printf("%s: %d frames at %g per second\n", device.name().c_str(), run.frameCount(), run.fps());

    for (int frame = 0; frame <= 20; frame += 10) {
      run.advanceTo(frame);
      const simreel::Array positions = run.read("sheet", "positions");  // shape: rows, columns, 3; in
                                                                        // metres
      std::printf("frame %2d: height of the middle %.3f m\n", frame,
                  positions.at<float>({positions.shape[0] / 2, positions.shape[1] / 2, 1}));
    }

    const std::vector<std::byte> png = simreel::encodePng(run.picture());
    std::ofstream("fall.png", std::ios::binary)
        .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));

    // An error is an exception. It contains the location of each mistake and the probable correction.
    simreel::Scene::parse(device, R"({"version": 2, "objects": {"a": {"cloth": {"fabrik": "silk"}}}})");
  } catch (const simreel::Error& error) {
    for (const simreel::Mistake& one : error.mistakes())
      std::printf("line %d, column %d, %s: \"%s\" is meant\n", one.line, one.column, one.path.c_str(),
                  one.suggestion.c_str());
    return error.kind() == simreel::ErrorKind::scene ? 0 : 1;
  }
}
