#include "source_folder.hpp"

std::string sourceFolder() {
  return SOURCE_FOLDER;
}
