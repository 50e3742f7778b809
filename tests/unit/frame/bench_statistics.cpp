#include "frame/statistics.hpp"

#include <limits>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel::frame;

TEST_CASE("bench: percentiles of known sets are right") {
  // numpy.percentile([15, 20, 35, 40, 50], [5, 40, 50, 95]) = 16, 29, 35, 48
  const std::vector<double> five = {15, 20, 35, 40, 50};
  CHECK(percentile(five, 0.05) == doctest::Approx(16));
  CHECK(percentile(five, 0.4) == doctest::Approx(29));
  CHECK(percentile(five, 0.5) == 35);
  CHECK(percentile(five, 0.95) == doctest::Approx(48));
  CHECK(percentile(five, 0) == 15);
  CHECK(percentile(five, 1) == 50);
  CHECK(percentile(five, 1.5) == 50);
  CHECK(percentile({}, 0.5) == 0);
  CHECK(percentile(std::vector<double>{7}, 0.05) == 7);
}

TEST_CASE("bench: statistics do not depend on the order") {
  std::vector<double> values;
  for (int i = 0; i < 101; ++i) values.push_back((i * 37) % 101);  // the numbers 0 to 100, shuffled
  const Statistics s = statisticsOf(values);
  CHECK(s.count == 101);
  CHECK(s.median == 50);
  CHECK(s.p5 == doctest::Approx(5));
  CHECK(s.p95 == doctest::Approx(95));
  CHECK(s.mean == doctest::Approx(50));
  CHECK(s.min == 0);
  CHECK(s.max == 100);
  CHECK(values[1] == 37);  // statisticsOf() does not sort its input.
  CHECK(statisticsOf(std::vector<double>{1, 2, 3, 10}).median == 2.5);
  CHECK(statisticsOf({}).count == 0);
  CHECK(statisticsOf({}).median == 0);
}

TEST_CASE("bench: outliers are values beyond three medians") {
  const Outliers found = outliersOf(std::vector<double>{2, 2, 6.5, 2, 2, 2, 40, 6, 2});
  CHECK(found.bound == 6);
  CHECK(found.count == 2);  // There are two outliers. The value 6 lies exactly on the bound and does not
                            // count.
  CHECK(found.worst == 6);
  const Outliers none = outliersOf(std::vector<double>{1, 2, 3});
  CHECK(none.count == 0);
  CHECK(none.worst == -1);
  CHECK(outliersOf({}).worst == -1);
}
