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
  Member member;  ///< int* or std::optional<double>*
  Spec spec;
  /// What scenes, baselines and reports called it before: "max_diff_ratio".
  [[nodiscard]] std::string formerName() const;
};

/// How far a picture may be from its baseline where the numerics are others. Every bound that is
/// given must hold. Field names are those of the scene file.
struct Tolerance {
  int maxChannelDiff = 12;              ///< a pixel differs when a channel is further apart, 0 to 255
  std::optional<double> maxDiffPixels;  ///< pixels that may differ
  std::optional<double>
      maxDiffRatio;     ///< fraction of all pixels that may differ; 0.02 when neither is given
  int windowSize = 16;  ///< N of the densest N x N window
  std::optional<double> maxWindowRatio;  ///< fraction of the densest window's pixels that may differ
  std::optional<double> maxFlipMean;     ///< mean FLIP error, 0 to 1
  std::optional<double> hardFail;        ///< no channel of any pixel may ever be further apart than this
  void describe(Fields& fields);
  /// All fields, in their order; they point into this tolerance.
  [[nodiscard]] std::vector<Bound> bounds();
};

/// "test" of a scene: what `simreel test` compares.
struct Test {
  std::vector<int> frames;     ///< ascending, without repeats; empty: first, middle and last
  glm::ivec2 size{320, 180};   ///< pixels
  std::optional<int> samples;  ///< per pixel; empty: the scene's
  Tolerance tolerance;
  /// Who gave a tolerance: field name -> file as it was named, or "-D"; absent: the default holds.
  std::map<std::string, std::string> toleranceOrigin;
  std::string xfail;  ///< why the scene is expected to fail; empty: it is expected to pass
  void describe(Fields& fields);
};

/// One invariant of "checks".
struct Check {
  /// "not-blank", "no-nan", or a statistic of an array's component ("mean", "min", "max", "sum" with `of`),
  /// or a quantity that the simulation measures ("mass", "energy", "population", ...).
  std::string what;
  std::string object;       ///< name; empty: the only object that has it
  std::string of;           ///< "positions.y": state array and component (x y z w, or "length" of xyz)
  std::vector<int> frames;  ///< empty: every tested frame
  std::optional<double> min, max;
  std::optional<double> drift;  ///< most relative change from the value at the first of the check's frames
  void describe(Fields& fields);

  /// "mean", "min", "max" or "sum".
  [[nodiscard]] bool isStatistic() const;
  /// Whether `what` is one that a simulation measures.
  [[nodiscard]] bool isQuantity() const;
};

}  // namespace simreel::scene
