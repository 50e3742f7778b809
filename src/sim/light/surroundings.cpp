#include "sim/light/surroundings.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text.hpp"

namespace simreel::sim {

std::string surroundingsLabel(const std::filesystem::path& file) {
  return "the sky's picture " + file.string();
}

LightFile readSurroundings(const std::filesystem::path& file) {
  const std::string bytes = readFile(file, "sky's picture");
  const std::string label = surroundingsLabel(file), advice = "is the file complete?";
  if (isExr(bytes)) return decodeExr(bytes, label, advice);
  if (isRadiance(bytes)) return decodeRadiance(bytes, label, advice);
  fail(ExitCode::inputOutput, "{} is neither Radiance HDR nor OpenEXR", label);
}

void checkSurroundings(const LightFile& picture, const std::string& label) {
  if (picture.size.x != 2 * picture.size.y)
    fail(ExitCode::inputOutput, "{} has {}x{} pixels; an equirectangular picture is twice as wide as high",
         label, picture.size.x, picture.size.y);
  if (!picture.unfit.empty()) fail(ExitCode::inputOutput, "{} {}", label, picture.unfit);
  if (!picture.colours.empty())
    fail(ExitCode::inputOutput, "{} has {}; convert it to those of Rec. 709 (sRGB)", label,
         picture.colours);
  constexpr float slightly = -1e-3F;  // minimum allowed value, because resampling can undershoot next to
                                      // bright pixels
  std::size_t negative = 0;
  for (std::size_t i = 0; i < picture.values.size(); ++i) {
    if (i % 4 == 3) continue;
    if (!(picture.values[i] >= slightly && picture.values[i] < 1e9F))
      fail(ExitCode::inputOutput,
           "{} has the value {:g} at column {}, row {}, which is not a valid amount of light", label,
           static_cast<double>(picture.values[i]), i / 4 % static_cast<std::size_t>(picture.size.x),
           i / 4 / static_cast<std::size_t>(picture.size.x));
    negative += picture.values[i] < 0 ? 1 : 0;
  }
  if (negative > 0)
    warnLinesOnce("simreel: warning: " +
                  oneLine(fmt::format("{} has {} value{} a little below 0, which {} as 0", label, negative,
                                      negative == 1 ? "" : "s", negative == 1 ? "counts" : "count")));
}

}  // namespace simreel::sim
