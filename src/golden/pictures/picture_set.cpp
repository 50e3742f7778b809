#include "golden/pictures/picture_set.hpp"

#include "base/error.hpp"
#include "golden/files/picture.hpp"
#include "golden/pictures/picture_folder.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

/// Returns the pixel hash of a file, or an empty text if it cannot be read, because the comparison reports
/// the error.
std::string hashOfFile(const fs::path& file) {
  try {
    return pictureHash(readPicture(file, "picture"));
  } catch (const UserError&) {
    return {};
  }
}

/// Pairs each picture without a baseline with an equal baseline whose picture no longer exists.
void findRenamed(std::vector<PictureCase>& cases) {
  std::multimap<std::string, PictureCase*> gone;
  const bool anyNew =
      std::any_of(cases.begin(), cases.end(), [](const auto& one) { return one.expected.empty(); });
  for (PictureCase& one : cases)
    if (anyNew && one.actual.empty())
      if (const std::string hash = hashOfFile(one.expected); !hash.empty()) gone.emplace(hash, &one);
  if (gone.empty()) return;
  for (PictureCase& one : cases) {
    if (!one.expected.empty()) continue;
    const auto found = gone.find(hashOfFile(one.actual));
    if (found == gone.end()) continue;
    one.renamedFrom = found->second->name;
    one.expected = found->second->expected;
    found->second->name.clear();
    gone.erase(found);
  }
  std::erase_if(cases, [](const PictureCase& one) { return one.name.empty(); });
}

}  // namespace

PictureSet pairPictures(const fs::path& expected, const fs::path& actual,
                        const std::function<bool(const std::string& name, bool made)>& counts) {
  const PictureFolder there = listPictures(expected), here = listPictures(actual);
  std::vector<std::string> names;
  std::set_union(there.pictures.begin(), there.pictures.end(), here.pictures.begin(), here.pictures.end(),
                 std::back_inserter(names));
  const auto fileIn = [](const fs::path& folder, const PictureFolder& list, const std::string& name) {
    return std::binary_search(list.pictures.begin(), list.pictures.end(), name) ? folder / name
                                                                                : fs::path();
  };
  PictureSet set;
  for (const std::string& name : names) {
    PictureCase one{name, fileIn(expected, there, name), fileIn(actual, here, name), {}};
    if (counts(name, !one.actual.empty())) set.cases.push_back(std::move(one));
  }
  findRenamed(set.cases);
  for (const auto& [folder, others] :
       {std::pair(&expected, &there.others), std::pair(&actual, &here.others)})
    for (const std::string& name : *others) set.passedOver.push_back((*folder / name).generic_string());
  return set;
}

}  // namespace simreel::golden
