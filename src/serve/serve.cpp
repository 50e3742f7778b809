#include "serve/serve.hpp"

#include "base/log.hpp"
#include "frame/interrupt.hpp"
#include "scene/texts/schema_text.hpp"
#include "serve/net/guard.hpp"
#include "serve/net/hub.hpp"
#include "serve/net/page.hpp"
#include "serve/net/server.hpp"
#include "sim/world/list.hpp"

#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <unistd.h>
#include <utility>

namespace simreel::serve {

namespace {

/// Returns all content that has a fixed address: the files of the page and the schema. No address gives
/// access to the file system.
std::map<std::string, Content, std::less<>> contents() {
  std::map<std::string, Content, std::less<>> all;
  for (const PageFile& file : pageFiles())
    all[file.path] = {mediaType(file.path), std::make_shared<const std::string>(file.text)};
  all["schema.json"] = {mediaType("schema.json"),
                        std::make_shared<const std::string>(scene::schemaText(sim::kinds().list))};
  return all;
}

std::string machineName() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 && name[0] != '\0' ? name.data() : "MACHINE";
}

}  // namespace

int serveScene(ServeOptions options, const gl::Context& context) {
  const Guard guard(options.token.empty() ? randomToken() : options.token, options.address);
  const auto all = contents();
  Hub hub;
  Player player(std::move(options.player), context, hub);
  const Server server(
      {options.address, options.port, options.embed,
       [&](std::string_view name) -> std::unique_ptr<Content> {
         const auto found = all.find(name);
         if (found != all.end()) return std::make_unique<Content>(found->second);
         const auto bytes = hub.offered(std::string(name));
         return bytes == nullptr ? nullptr : std::make_unique<Content>(Content{mediaType(name), bytes});
       }},
      guard, hub);
  printText("Open " + pageAddress(options.address, server.port(), guard.token()) + "\n" +
            "From another machine, first: " + tunnelCommand(options.address, server.port(), machineName()) +
            "\n" + "Ctrl-C ends it.\n");
  std::fflush(stdout);  // A program that reads the address through a pipe needs it immediately.
  player.run();
  return frame::interruptSignal();
}

}  // namespace simreel::serve
