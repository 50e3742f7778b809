#include "kernels/text/loops.hpp"

#include <string>

#include <doctest/doctest.h>

namespace {

std::string moved(std::string text) {
  simreel::kernels::moveIncrements(text);
  return text;
}

}  // namespace

TEST_CASE("user kernels: several increments of a loop are made in its body") {
  CHECK(moved(R"(    for (int k = 0; k < 9; a = b, k++)
    {
        if (a > 3u)
        {
            break;
        }
        if (a > 2u)
        {
            continue;
        }
        b = a * 3u;
    }
)") == R"(    for (int k = 0; k < 9;)
    {
        if (a > 3u)
        {
            break;
        }
        if (a > 2u)
        {
            a = b;
            k++;
            continue;
        }
        b = a * 3u;
        a = b;
        k++;
    }
)");
}

TEST_CASE("user kernels: continue of an inner loop does not make the outer loop's increments") {
  const std::string inner = R"(        for (;;)
        {
            continue;
        }
        break;
)";
  CHECK(moved("    for (; x; a = b, k++)\n    {\n" + inner + "    }\n") ==
        "    for (; x;)\n    {\n" + inner + "        a = b;\n        k++;\n    }\n");
}

TEST_CASE("user kernels: loops with one increment keep their header") {
  const std::string one = "    for (int k = 0; k < 9; k++)\n    {\n        break;\n    }\n";
  CHECK(moved(one) == one);
}
