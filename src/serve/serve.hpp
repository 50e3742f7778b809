#pragma once
#include "gl/context.hpp"
#include "serve/play/player.hpp"

#include <string>

namespace simreel::serve {

struct ServeOptions {
  PlayerOptions player;
  std::string address = "127.0.0.1";  ///< IP address to listen on
  int port = 0;                       ///< TCP port; 0 to use any free port
  bool embed = false;                 ///< true if other pages may show the page in a frame
  std::string token;                  ///< secret token in the address; empty to generate a random one
};

/// Shows the scene until a signal ends the program. Prints the page's address. Returns the signal. Throws
/// UserError.
int serveScene(ServeOptions options, const gl::Context& context);

}  // namespace simreel::serve
