#pragma once
#include "frame/image.hpp"
#include "golden/result.hpp"
#include "golden/suite/check_values.hpp"
#include "scene/scene.hpp"
#include "sim/world/world.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace simreel::golden {

/// Evaluates the checks of a scene as its frames are made.
class Checker {
 public:
  /// Throws UserError(usage) for a check that names an object, array, component or quantity that the scene
  /// does not have, listing what there is, and for a "not-blank" at a frame without picture.
  /// `testedFrames`: those at which frame() will be called with a picture, ascending.
  Checker(const scene::Scene& scene, const sim::World& world, std::span<const int> testedFrames);
  /// Frames, besides the tested ones, that some check wants; ascending.
  [[nodiscard]] std::vector<int> frames() const;
  /// The world stands at this frame. Waits for the GPU and reads state back, only where a check of this
  /// frame needs it. Frames must ascend.
  void state(int frame, const sim::World& world);
  /// The picture of a tested frame, before or after its state.
  void picture(int frame, const frame::Image& image);
  /// What an earlier run of the scene came to at frames that this one does not make again.
  void resume(const std::vector<CheckResult>& earlier);
  /// One result for each check and frame so far: by frame, then in the scene's order. Of a check with drift
  /// `least` and `most` are the tighter ones of its bounds and the drift's.
  [[nodiscard]] std::vector<CheckResult> results() const;

 private:
  /// A check and what it means in this world.
  struct Item {
    enum class Kind { notBlank, noNan, statistic, quantity };
    scene::Check check;
    Kind kind = Kind::quantity;
    std::string label;                 ///< "max of flag positions.y"
    std::vector<std::size_t> objects;  ///< whose state it looks at
    std::size_t index = 0;             ///< of the state array, or of the quantity
    Statistic statistic = Statistic::mean;
    Component component = Component::x;
    std::vector<int> frames;                     ///< ascending
    std::optional<double> first = std::nullopt;  ///< value at the first of the frames
    bool told = false;                           ///< that there is none
  };
  class Resolver;
  class StateOfFrame;

  template <class Look>
  void evaluate(int frame, const Look& look);
  static void checkContrast(const frame::Image& image, CheckResult& result);
  void checkFinite(const Item& item, StateOfFrame& state, CheckResult& result) const;
  /// Whether it could be judged: drift counts from the first of the check's frames.
  static bool checkBounds(Item& item, double value, CheckResult& result);

  std::vector<std::string> names_;  ///< of the scene's objects
  std::vector<int> tested_;
  std::vector<Item> items_;
  std::map<std::pair<int, std::size_t>, CheckResult> results_;  ///< by frame and check
  int lastFrame_ = -1;
};

}  // namespace simreel::golden
