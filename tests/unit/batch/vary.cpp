#include "batch/plan/vary.hpp"

#include "base/error.hpp"
#include "unit/help.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::batch;

namespace {

std::vector<std::string> valuesOf(const std::string& text) {
  return simreel::batch::parseVary(text).values;
}

/// Returns the jobs as text, such as "a=1 b=x".
std::vector<std::string> jobsOf(const std::vector<std::string>& texts, Combination how,
                                std::size_t samples = 0, std::uint64_t seed = 1) {
  std::vector<Vary> varied;
  for (const std::string& text : texts) varied.push_back(simreel::batch::parseVary(text));
  std::vector<std::string> lines;
  for (const auto& job : combine(varied, how, samples, seed)) {
    std::string line;
    for (const scene::Override& value : job)
      line += (line.empty() ? "" : " ") + value.path + "=" + value.value;
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

TEST_CASE("vary: lists and ranges are parsed; commas inside brackets do not separate values") {
  using List = std::vector<std::string>;
  CHECK(valuesOf("a.b=1,2,4") == List{"1", "2", "4"});
  CHECK(valuesOf("a=0:1:0.1") ==
        List{"0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1"});
  CHECK(valuesOf("a=0:1:0.3") == List{"0", "0.3", "0.6", "0.9"});
  CHECK(valuesOf("a=3:1:-1") == List{"3", "2", "1"});
  CHECK(valuesOf("a=1:3:1,10") == List{"1", "2", "3", "10"});
  CHECK(valuesOf("render.size=[320,180],[640,360]") == List{"[320,180]", "[640,360]"});
  CHECK(valuesOf(R"(a={"x":[1,2]},"b,c",d)") == List{R"({"x":[1,2]})", R"("b,c")", "d"});
  CHECK(valuesOf("a=silk") == List{"silk"});
  const Vary range = simreel::batch::parseVary("a=-1.5:2");
  CHECK(range.isRange());
  CHECK(range.low == -1.5);
  CHECK(range.high == 2);
  for (const char* wrong : {"", "a", "a=", "=1", "a=1,,2", "a=1,1", "a=0:1:0", "a=0:1:-0.1",
                            "a=0:9:0.00001", "a=2:1", "a=0:1,5"})
    CHECK_THROWS_AS(static_cast<void>(simreel::batch::parseVary(wrong)), UserError);
}

TEST_CASE("vary: grid combines all values, zip pairs them") {
  using List = std::vector<std::string>;
  CHECK(jobsOf({"a=1,2", "b=x,y,z"}, Combination::grid) ==
        List{"a=1 b=x", "a=1 b=y", "a=1 b=z", "a=2 b=x", "a=2 b=y", "a=2 b=z"});
  CHECK(jobsOf({"a=1,2", "b=x,y"}, Combination::zip) == List{"a=1 b=x", "a=2 b=y"});
  CHECK_THROWS_WITH_AS(static_cast<void>(jobsOf({"a=1,2", "b=x,y,z"}, Combination::zip)),
                       doctest::Contains("a has 2 values and b has 3"), UserError);
  CHECK_THROWS_WITH_AS(static_cast<void>(jobsOf({"a=1,2", "a=3"}, Combination::grid)),
                       doctest::Contains("given twice"), UserError);
  CHECK_THROWS_WITH_AS(static_cast<void>(jobsOf({"a=1:2"}, Combination::grid)),
                       doctest::Contains("has no step"), UserError);
  CHECK_THROWS_WITH_AS(static_cast<void>(jobsOf({"a=1:1000:1", "b=1:1000:1"}, Combination::grid)),
                       doctest::Contains("more than"), UserError);
}

TEST_CASE("vary: samples are spread evenly and depend only on their seed") {
  const std::vector<std::string> varied = {"a=0:1", "b=x,y,z"};
  const auto jobs = jobsOf(varied, Combination::sample, 12, 7);
  CHECK(jobs == jobsOf(varied, Combination::sample, 12, 7));
  CHECK(jobs != jobsOf(varied, Combination::sample, 12, 8));
  std::set<int> parts;
  std::map<std::string, int> counts;
  for (const std::string& job : jobs) {
    const double a = std::stod(job.substr(2));
    CHECK(a >= 0);
    CHECK(a < 1);
    parts.insert(static_cast<int>(a * 12));
    ++counts[job.substr(job.find("b="))];
  }
  CHECK(parts.size() == 12);
  for (const auto& [value, count] : counts) CHECK(count == 4);
}
