#pragma once
#include "base/error.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "unit/help.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::scene::toy {

enum class Shape { round, flat };

struct Pin {
  int row = 0;
  float weight = 1.0F;
};

/// Parameters whose description uses every function of Fields once.
struct Cloth final : Parameters {
  bool torn = false;
  int threads = 3;
  float stretch = 0.05F;
  double slack = 0.25;
  std::optional<double> fray;
  Animated<float> gust = 1.0F;
  glm::vec3 wind{0, 0, 0};
  Animated<glm::vec3> lift = glm::vec3(0, 1, 0);
  glm::ivec2 grid{8, 4};
  std::vector<glm::ivec2> holes{{1, 1}};
  std::string note = "plain";
  std::optional<int> passes;
  std::vector<int> cuts{1, 2};
  Shape shape = Shape::flat;
  std::vector<int> sides{0};
  std::filesystem::path picture;
  bool hasWear = false;
  float wear = 0.5F;
  float seam = 0.1F;
  std::vector<Pin> pins;

  [[nodiscard]] std::span<const Quantity> quantities() const override {
    static const Quantity table[] = {{"mass", "kg", "Of it all."}, {"energy", "", "Sum."}};
    return table;
  }
  void describe(Fields& fields) override {
    fields.boolean("torn", torn, "Torn.");
    fields.integer("threads", threads, {1, 10}, "", "Threads.");
    fields.number("stretch", stretch, {0, 1}, "m/N", "Stretch.");
    fields.number("slack", slack, notNegative, "m", "Slack.");
    fields.optionalNumber("fray", fray, {0, 3}, "mm", "Fray.");
    fields.number("gust", gust, {0, 5}, "m/s", "Gust.");
    fields.vector("wind", wind, anyNumber, "m/s", "Wind.");
    fields.vector("lift", lift, {-9, 9}, "N", "Lift.");
    fields.pair("grid", grid, {2, 64}, "threads", "Grid.");
    fields.pairs("holes", holes, {0, 64}, "", "Holes.");
    fields.text("note", note, "Note.");
    fields.integerOr("passes", passes, "auto", {1, 99}, "", "Passes.");
    fields.integers("cuts", cuts, {0, 9}, "", "Cuts.");
    fields.choice("shape", shape, {"round", "flat"}, "Shape.");
    fields.someOf("sides", sides, {"left", "right"}, "Sides.");
    fields.asset("picture", picture, "Picture.");
    fields.optionalGroup("worn", hasWear, "Wear.", [&](Fields& inner) {
      inner.number("amount", wear, {0, 1}, "", "Amount.");
    });
    fields.group("seam", "Seam.",
                 [&](Fields& inner) { inner.number("width", seam, positive, "m", "Width."); });
    fields.list(
        "pins", pins, "Pins.",
        [](Fields& inner, Pin& pin) {
          inner.integer("row", pin.row, {0, 9}, "", "Row.");
          inner.number("weight", pin.weight, notNegative, "kg", "Weight.");
        },
        4);
    if (threads == 7) fields.error("threads", "seven threads tangle");
  }
};

struct Capsule final : Parameters {
  float radius = 0.5F;
  void describe(Fields& fields) override { fields.number("radius", radius, positive, "m", "Radius."); }
};

inline const Kinds& toyKinds() {
  static const Kind all[] = {{"cloth", "A toy cloth.", [] { return std::make_unique<Cloth>(); }},
                             {"capsule", "A toy capsule.", [] { return std::make_unique<Capsule>(); }}};
  static const Kinds kinds{all};
  return kinds;
}

inline Scene parse(std::string_view text, const std::vector<std::string>& changes = {},
                   const std::filesystem::path& file = "s.json") {
  std::vector<Override> overrides;
  for (const std::string& change : changes) overrides.push_back(parseOverride(change));
  return parseScene(text, file, overrides, toyKinds());
}

/// Returns the report of a scene's errors, or "" for a valid scene.
inline std::string mistakes(std::string_view text, const std::vector<std::string>& changes = {},
                            const std::filesystem::path& file = "s.json") {
  try {
    static_cast<void>(parse(text, changes, file));
    return "";
  } catch (const UserError& error) {
    return error.code() == ExitCode::usage ? error.what() : "wrong exit code";
  }
}

/// Returns a scene with one cloth that has the given members.
inline std::string withCloth(const std::string& members) {
  return "{\"version\": 1,\n\"objects\": {\"flag\": {\"cloth\":\n{" + members + "}}}}";
}
inline const Cloth& clothOf(const Scene& scene) {
  return dynamic_cast<const Cloth&>(*scene.objects.at(0).parameters);
}

using simreel::test::has;

}  // namespace simreel::scene::toy
