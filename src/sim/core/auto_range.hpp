#pragma once
#include "scene/value/fields.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

/// Ends of a range of colours that a scene gives as "auto": a first run measures them.
struct AutoEnds {
  bool low = false, high = false;
  [[nodiscard]] bool any() const { return low || high; }
};

/// Declares an end of a range: a number, or "auto". While it is "auto", `value` keeps its default.
template <class Number>
void describeEnd(scene::Fields& fields, const char* name, Number& value, bool& isAuto, const char* unit,
                 const char* doc) {
  std::optional<double> end;
  // The shortest decimal form of a float; its exact value as a double would have more digits.
  if (!isAuto) end = std::stod(fmt::format("{}", value));
  scene::Spec spec{doc, unit, scene::anyNumber};
  spec.none = "auto";
  fields.field(name, &end, spec);
  isAuto = !end;
  if (end) value = static_cast<Number>(*end);
}

/// Range of colours with ends that are measured.
struct MeasuredRange {
  std::string path;  ///< group below the object's parameters, such as "display"; empty: none
  const char* lowKey;
  const char* highKey;
  AutoEnds ends;
  double low, high;  ///< present values; of a measured end, its default
  /// Sets both ends, which are then no longer "auto".
  std::function<void(double low, double high)> set;
};

/// Returns a range whose ends are members of an object's parameters, or nothing if none of them is "auto".
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

/// Parameters of objects that are drawn in colours of a range.
struct HasColorRange {
  virtual ~HasColorRange() = default;
  /// Returns the ranges that must be measured.
  [[nodiscard]] virtual std::vector<MeasuredRange> measuredRanges() = 0;

 protected:
  HasColorRange() = default;
  HasColorRange(const HasColorRange&) = default;
  HasColorRange& operator=(const HasColorRange&) = default;
  HasColorRange(HasColorRange&&) = default;
  HasColorRange& operator=(HasColorRange&&) = default;
};

}  // namespace simreel::sim
