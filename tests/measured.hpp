#pragma once
#include "scene/value/fields.hpp"

#include <string>
#include <vector>

#include <doctest/doctest.h>

/// Returns the value of the quantity `name` from `measured`, which is in the order of the parameters'
/// quantities.
inline double named(const simreel::scene::Parameters& parameters, const std::vector<double>& measured,
                    const std::string& name) {
  const auto table = parameters.quantities();
  REQUIRE(table.size() == measured.size());
  for (std::size_t i = 0; i < table.size(); ++i)
    if (name == table[i].name) return measured[i];
  FAIL("no quantity " << name);
  return 0;
}
