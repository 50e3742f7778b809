#include "kernels/source/derivatives.hpp"

#include "kernels/source/remedies.hpp"
#include "kernels/source/scan.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace simreel::kernels {

bool usesDerivatives(const std::string& text) {
  const Scan scan(text);
  return std::any_of(scan.all.begin(), scan.all.end(), [](const Token& one) {
    return one.text.starts_with("dFdx") || one.text.starts_with("dFdy") || one.text.starts_with("fwidth");
  });
}

std::string derivativeFunctions() {
  std::string text = R"(
int simreel_run = 0, simreel_number = 0, simreel_numbers[2];
ivec2 simreel_side;
vec4 simreel_seen[2][64];
vec4 simreel_slope(vec4 own, int number, int axis) {
  if (number >= min(simreel_numbers[axis], 64)) return vec4(0.0);
  return (simreel_seen[axis][number] - own) * float(simreel_side[axis]);
}
vec4 simreel_derivative(vec4 own, int what) {
  int number = simreel_number++;
  if (simreel_run < 2) {
    if (number < 64) simreel_seen[simreel_run][number] = own;
    return vec4(0.0);
  }
  if (what < 2) return simreel_slope(own, number, what);
  return abs(simreel_slope(own, number, 0)) + abs(simreel_slope(own, number, 1));
}
)";
  static constexpr std::string_view names[] = {"dFdx", "dFdy", "fwidth"};
  static constexpr std::string_view whole[] = {"vec4(v, 0.0, 0.0, 0.0)", "vec4(v, 0.0, 0.0)",
                                               "vec4(v, 0.0)", "v"};
  static constexpr std::string_view types[] = {"float", "vec2", "vec3", "vec4"};
  static constexpr std::string_view taken[] = {"x", "xy", "xyz", "xyzw"};
  for (int what = 0; what < 3; ++what) {
    for (int i = 0; i < 4; ++i)
      text += fmt::format("{0} simreel_{1}({0} v) {{ return simreel_derivative({2}, {3}).{4}; }}\n",
                          types[i], names[what], whole[i], what, taken[i]);
    for (const std::string_view kind : {"", "Coarse", "Fine"})
      text += fmt::format("#define {0}{1} simreel_{0}\n", names[what], kind);
  }
  return text;
}

std::string threeRuns(const std::string& text) {
  const Scan scan(text);
  const auto assigned = assignedNames(scan.all);
  std::string saved, restored;
  for (const Declaration& one : scan.declared) {
    std::string_view lead =
        std::string_view(scan.code).substr(0, static_cast<std::size_t>(one.type.data() - scan.code.data()));
    lead = lead.substr(0, lead.find_last_not_of(" \t\n") + 1);
    if (one.constant || lead.ends_with("uniform")) continue;
    for (const Declarator& name : one.names) {
      if (assigned.find(name.name) == assigned.end()) continue;
      saved += fmt::format("  {0} simreel_first_{1}{2} = {1};\n", one.type, name.name, name.lengths);
      restored += fmt::format("    {0} = simreel_first_{0};\n", name.name);
    }
  }
  return fmt::format(R"({}  simreel_side = 1 - 2 * (simreel_at & 1);
  for (simreel_run = 0; simreel_run < 3; ++simreel_run) {{
{}    simreel_number = 0;
    simreel_color = vec4(0.0, 0.0, 0.0, 1.0);
    ivec2 simreel_of = simreel_at ^ ivec2(simreel_run == 0 ? 1 : 0, simreel_run == 1 ? 1 : 0);
    mainImage(simreel_color, vec2(simreel_of) + 0.5);
    if (simreel_run < 2) simreel_numbers[simreel_run] = simreel_number;
  }}
)",
                     saved, restored);
}

}  // namespace simreel::kernels
