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

/// Evaluates the checks of a scene while its frames are made.
class Checker {
 public:
  /// Resolves the names in the checks. Throws UserError(usage) if a check names an unknown object, array,
  /// component or quantity. The message lists the known names. Also throws it if a "not-blank" check is at
  /// a frame without a picture. `testedFrames`: frames (ascending) for which picture() will be called.
  Checker(const scene::Scene& scene, const sim::World& world, std::span<const int> testedFrames);
  /// Returns the frames, in ascending order, that checks need in addition to the tested ones.
  [[nodiscard]] std::vector<int> frames() const;
  /// Evaluates the state checks of `frame`, which must be the world's current frame. Waits for the GPU and
  /// reads back state only if a check of this frame needs it. Call with ascending frames.
  void state(int frame, const sim::World& world);
  /// Evaluates the picture checks of a tested frame. May be called before or after state().
  void picture(int frame, const frame::Image& image);
  /// Takes the results of an earlier run for frames that this run does not make again.
  void resume(const std::vector<CheckResult>& earlier);
  /// Returns one result for each check and frame so far, sorted by frame and then by the order of the
  /// checks in the scene. For checks with drift, the result's min and max are the tighter of the check's
  /// bounds and the drift's bounds.
  [[nodiscard]] std::vector<CheckResult> results() const;

 private:
  /// A check with its names resolved for this world.
  struct Item {
    enum class Kind { notBlank, noNan, statistic, quantity };
    scene::Check check;
    Kind kind = Kind::quantity;
    std::string label;                 ///< description: "max of flag positions.y"
    std::vector<std::size_t> objects;  ///< indices of the objects whose state is checked
    std::size_t index = 0;             ///< index of the state array or quantity within its object
    Statistic statistic = Statistic::mean;
    Component component = Component::x;
    std::vector<int> frames;                     ///< frames to check, ascending
    std::optional<double> first = std::nullopt;  ///< value at the first of the check's frames
    /// true if the warning about a missing first value was printed
    bool reported = false;
  };
  class Resolver;
  class StateOfFrame;

  template <class Look>
  void evaluate(int frame, const Look& look);
  static void checkContrast(const frame::Image& image, CheckResult& result);
  void checkFinite(const Item& item, StateOfFrame& state, CheckResult& result) const;
  /// Checks a value against min, max and drift. Returns false if drift cannot be checked, because the value
  /// at the first of the check's frames is unknown.
  static bool checkBounds(Item& item, double value, CheckResult& result);

  std::vector<std::string> names_;  ///< names of the scene's objects
  std::vector<int> tested_;
  std::vector<Item> items_;
  /// results by frame number and index of the check
  std::map<std::pair<int, std::size_t>, CheckResult> results_;
  int lastFrame_ = -1;
};

}  // namespace simreel::golden
