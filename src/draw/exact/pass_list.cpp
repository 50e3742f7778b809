#include "draw/exact/pass_list.hpp"

namespace simreel::draw {

const std::vector<std::string>& passNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> found;
    for (const PassEntry& entry : exactPasses)
      for (const std::string_view name : entry.kept)
        if (std::find(found.begin(), found.end(), name) == found.end()) found.emplace_back(name);
    return found;
  }();
  return names;
}

}  // namespace simreel::draw
