#include "base/text.hpp"

#include "base/error.hpp"
#include "gl/program.hpp"

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("text: terminal control characters are escaped") {
  CHECK(oneLine("plain, Grüße, 日本, 🙂") == "plain, Grüße, 日本, 🙂");
  CHECK(oneLine("a\nb\r\tc") == "a\\nb\\r\\tc");
  CHECK(oneLine(std::string_view("\x1b[31m\a\0\x7f", 8)) == "\\x1b[31m\\x07\\x00\\x7f");
  CHECK(oneLine("\xC2\x9B"
                "31m") == "\\u009b31m");
  CHECK(oneLine("\u202Egnp.exe\u2066\u200F\u061C\u2028") == "\\u202egnp.exe\\u2066\\u200f\\u061c\\u2028");
  CHECK(oneLine("\xFF\xC3(") == "\\xff\\xc3(");
  CHECK(severalLines("a\n\tb\r\x1b") == "a\n\tb\\r\\x1b");
}

TEST_CASE("text: no output line can be read as a GitHub workflow command") {
  CHECK(withoutCommands("::error::x\n  ::notice::y\na ::b\n") == ": :error::x\n  : :notice::y\na ::b\n");
  CHECK(withoutCommands("x ##[error]y") == "x # #[error]y");
  CHECK(withoutCommands("") == "");
}

TEST_CASE("dispatches are checked against the limit of each dimension") {
  gl::Limits limits;
  limits.groupsX = 2147483647;
  limits.groupsY = 65535;
  CHECK_NOTHROW(gl::checkGroups("life", 100000, 65535, limits));
  CHECK_THROWS_WITH_AS(gl::checkGroups("life", 3, 65536, limits),
                       "life needs 3x65536 work groups, this device allows 2147483647x65535 "
                       "(GL_MAX_COMPUTE_WORK_GROUP_COUNT)",
                       UserError);
}
