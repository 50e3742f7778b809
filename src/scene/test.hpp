#pragma once
#include "scene/value/fields.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::scene {

/// One field of a Tolerance.
struct Bound {
  const char* name;
  Member member;  ///< pointer to the field: int* or std::optional<double>*
  Spec spec;
  /// Returns the former name in scenes, baselines and reports, such as "max_diff_ratio".
  [[nodiscard]] std::string formerName() const;
};

/// Allowed difference between a picture and its baseline if they were made with different numerics. The
/// picture must satisfy all bounds that are given. The fields have the same names as in scene files.
struct Tolerance {
  int maxChannelDiff = 12;  ///< a pixel differs if one of its channels (0 to 255) differs by more than this
  std::optional<double> maxDiffPixels;  ///< maximum number of differing pixels
  /// Maximum fraction of differing pixels. It is 0.02 if neither this field nor maxDiffPixels is given.
  std::optional<double> maxDiffRatio;
  int windowSize = 16;                   ///< side N in pixels of the N x N window with the most differing
                                         ///< pixels
  std::optional<double> maxWindowRatio;  ///< max fraction of differing pixels in the window of side
                                         ///< windowSize
  std::optional<double> maxFlipMean;     ///< maximum mean FLIP error, 0 to 1
  std::optional<double> hardFail;        ///< maximum difference of any channel of any pixel
  void describe(Fields& fields);
  /// Returns all fields in their order. The entries point into this object.
  [[nodiscard]] std::vector<Bound> bounds();
};

/// Section "test" of a scene: the frames that `simreel test` compares, and the allowed differences.
struct Test {
  /// Frames to compare, in ascending order without repeats. If empty, the first, middle and last frame are
  /// compared.
  std::vector<int> frames;
  glm::ivec2 size{320, 180};   ///< width and height in pixels
  std::optional<int> samples;  ///< samples per pixel; nullopt means the scene's number
  Tolerance tolerance;
  /// Maps the name of each given tolerance to its origin, a file path or "-D". Fields that are not in the
  /// map have their default.
  std::map<std::string, std::string> toleranceOrigin;
  std::string xfail;  ///< reason why the scene is expected to fail; if empty, it is expected to pass
  void describe(Fields& fields);
};

/// One condition of "checks".
struct Check {
  /// Name of the condition. It is "not-blank", "no-nan", a statistic of an array's component ("mean",
  /// "min", "max", "sum" with `of`), or a quantity that the simulation measures ("mass", "energy",
  /// "population", ...).
  std::string what;
  std::string object;  ///< name of the object; empty means the only object that has the quantity
  std::string of;  ///< state array and component, such as "positions.y" (x, y, z, w, or "length" of xyz)
  std::vector<int> frames;  ///< frames at which the check applies; empty means all frames that the test
                            ///< compares
  std::optional<double> min, max;
  std::optional<double> drift;  ///< maximum relative change from the value at the check's first frame
  void describe(Fields& fields);

  /// True if `what` is "mean", "min", "max" or "sum".
  [[nodiscard]] bool isStatistic() const;
  /// True if `what` is a quantity that a simulation measures.
  [[nodiscard]] bool isQuantity() const;
};

}  // namespace simreel::scene
