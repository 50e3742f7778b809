#pragma once
#include "scene/value/fields.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

/// States for each end of a colour range whether the scene gives it as "auto". A first run of the scene
/// measures such ends.
struct AutoEnds {
  bool low = false, high = false;
  [[nodiscard]] bool any() const { return low || high; }
};

/// Declares one end of a colour range in the scene format: a number, or "auto". While the end is "auto",
/// `value` keeps its default.
template <class Number>
void describeEnd(scene::Fields& fields, const char* name, Number& value, bool& isAuto, const char* unit,
                 const char* doc) {
  std::optional<double> end;
  // Uses the shortest decimal form of the float; the exact value as a double would have more digits.
  if (!isAuto) end = std::stod(fmt::format("{}", value));
  scene::Spec spec{doc, unit, scene::anyNumber};
  spec.none = "auto";
  fields.field(name, &end, spec);
  isAuto = !end;
  if (end) value = static_cast<Number>(*end);
}

/// Colour range with at least one end to be measured.
struct MeasuredRange {
  std::string path;  ///< name of the parameter group that contains the range, such as "display"; empty if
                     ///< the range is not in a group
  const char* lowKey;
  const char* highKey;
  AutoEnds ends;
  double low, high;  ///< current ends; an end that is still to be measured has its default value
  /// Sets both ends, which are then no longer "auto".
  std::function<void(double low, double high)> set;
};

/// Returns a range whose ends are members of an object's parameters, or nothing if neither end is "auto".
template <class Number>
[[nodiscard]] std::vector<MeasuredRange> measuredRange(std::string path, const char* lowKey,
                                                       const char* highKey, AutoEnds& ends, Number& low,
                                                       Number& high) {
  if (!ends.any()) return {};
  return {{std::move(path), lowKey, highKey, ends, static_cast<double>(low), static_cast<double>(high),
           [&ends, &low, &high](double first, double last) {
             low = static_cast<Number>(first);
             high = static_cast<Number>(last);
             ends = {};
           }}};
}

/// Parameters of objects that are coloured by a value through a colour range.
struct HasColorRange {
  virtual ~HasColorRange() = default;
  /// Returns the colour ranges with an "auto" end.
  [[nodiscard]] virtual std::vector<MeasuredRange> measuredRanges() = 0;

 protected:
  HasColorRange() = default;
  HasColorRange(const HasColorRange&) = default;
  HasColorRange& operator=(const HasColorRange&) = default;
  HasColorRange(HasColorRange&&) = default;
  HasColorRange& operator=(HasColorRange&&) = default;
};

}  // namespace simreel::sim
