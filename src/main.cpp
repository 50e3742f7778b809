#include "cli/commands.hpp"

int main(int argc, char** argv) {
  return simreel::cli::run(argc, argv);
}
