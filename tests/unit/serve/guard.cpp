#include "serve/net/guard.hpp"

#include <set>
#include <string>
#include <string_view>

#include <doctest/doctest.h>

using simreel::serve::Guard;

namespace {

const std::string token = "0123456789abcdef0123456789abcdef";

/// Returns the rest of the path after the token, or "no" if the path is refused.
std::string restOf(const Guard& guard, std::string_view path) {
  std::string_view rest;
  return guard.splitPath(path, rest) ? std::string(rest) : "no";
}

}  // namespace

TEST_CASE("serve: tokens are 32 hexadecimal digits and never repeat") {
  std::set<std::string> all;
  for (int i = 0; i < 64; ++i) {
    const std::string one = simreel::serve::randomToken();
    CHECK_EQ(one.size(), 32);
    CHECK_EQ(one.find_first_not_of("0123456789abcdef"), std::string::npos);
    all.insert(one);
  }
  CHECK_EQ(all.size(), 64);
}

TEST_CASE("serve: request paths must start with the complete token") {
  const Guard guard(token, "127.0.0.1");
  CHECK_EQ(restOf(guard, "/" + token + "/"), "");
  CHECK_EQ(restOf(guard, "/" + token + "/app.js"), "app.js");
  CHECK_EQ(restOf(guard, "/" + token + "/../x"),
           "../x");  // The path "../x" is harmless, because names are looked up in a table.
  for (const std::string& path :
       {std::string(), std::string("/"), "/" + token, token + "/", "//" + token + "/", "/" + token + "x/",
        "/" + token.substr(1) + "/", "/" + token.substr(0, 31) + "/app.js"})
    CHECK_EQ(restOf(guard, path), "no");
  for (std::size_t i = 0; i < token.size(); ++i) {
    std::string wrong = token;
    wrong[i] = wrong[i] == 'a' ? 'b' : 'a';
    CHECK_EQ(restOf(guard, "/" + wrong + "/"), "no");
  }
}

TEST_CASE("serve: the Host header must name this machine") {
  const Guard guard(token, "127.0.0.1");
  for (const char* host :
       {"localhost", "localhost:1", "127.0.0.1", "127.0.0.1:65535", "127.1.2.3:80", "[::1]", "[::1]:8000"})
    CHECK_MESSAGE(guard.allowsHost(host), host);
  for (const char* host : {"", ":80", "example.org", "localhost.example.org", "127.0.0.1.example.org",
                           "127.example.org", "127.0.0.1:", "127.0.0.1:80x", "127.0.0.1:123456", "10.0.0.1",
                           "[::2]", "[::1", "[localhost]", "::1", "[::1]x", "127.0.0.1 "})
    CHECK_MESSAGE(!guard.allowsHost(host), host);
}

TEST_CASE("serve: if other machines can connect, the Host header must be an IP address or localhost") {
  const Guard guard(token, "0.0.0.0");
  for (const char* host : {"10.0.0.1", "192.168.1.7:8000", "[fe80::1]:8000", "localhost:8000"})
    CHECK_MESSAGE(guard.allowsHost(host), host);
  for (const char* host : {"example.org", "10.0.0.1.example.org:80", "10.0.0", "[10.0.0.1]"})
    CHECK_MESSAGE(!guard.allowsHost(host), host);
}

TEST_CASE("serve: the Origin header must be the page's own origin") {
  CHECK(Guard::allowsOrigin("http://127.0.0.1:8000", "127.0.0.1:8000"));
  for (const char* origin :
       {"", "null", "http://", "https://127.0.0.1:8000", "http://127.0.0.1", "http://127.0.0.1:8001",
        "http://127.0.0.1:8000/", "http://127.0.0.1:8000.example.org", "http://localhost:8000"})
    CHECK_MESSAGE(!Guard::allowsOrigin(origin, "127.0.0.1:8000"), origin);
  CHECK_FALSE(Guard::allowsOrigin("http://", ""));
}

TEST_CASE("serve: an SSH tunnel command targets the listening address") {
  using simreel::serve::tunnelCommand;
  CHECK_EQ(tunnelCommand("127.0.0.1", 80, "node7"), "ssh -N -L 80:127.0.0.1:80 node7");
  CHECK_EQ(tunnelCommand("0.0.0.0", 80, "node7"), "ssh -N -L 80:127.0.0.1:80 node7");
  CHECK_EQ(tunnelCommand("10.0.0.5", 80, "node7"), "ssh -N -L 80:10.0.0.5:80 node7");
}
