// The part of KernelPlan that computes the initial contents of memory.
#include "scene/json/words.hpp"
#include "sim/kernels/plan.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr const char* elementNames[] = {"i",     "x",      "y",     "z",    "count",
                                        "width", "height", "depth", "seed", "pi"};
constexpr const char* channels[] = {"r", "g", "b", "a"};

/// Evaluates the formulas for the elements of one buffer or texture. The columns of its file are additional
/// variables.
class Starts {
 public:
  Starts(const KernelTable* table, glm::ivec3 size) : table_(table), size_(size) {
    names_.assign(std::begin(elementNames), std::end(elementNames));
    if (table != nullptr) names_.insert(names_.end(), table->columns.begin(), table->columns.end());
  }
  /// Throws scene::ExpressionMistake.
  [[nodiscard]] Expression compiled(const std::string& text) const {
    // The search runs from the end, because columns of a file take precedence over built-in variables.
    return Expression(
        text,
        [this](const std::string& name) {
          for (std::size_t i = names_.size(); i-- > 0;)
            if (names_[i] == name) return static_cast<int>(i);
          return -1;
        },
        names_);
  }
  [[nodiscard]] std::vector<double> values(std::size_t i, unsigned seed) const {
    const auto width = static_cast<std::size_t>(size_.x), height = static_cast<std::size_t>(size_.y);
    const std::size_t count = width * height * static_cast<std::size_t>(size_.z);
    const std::size_t row = i / width % height, layer = i / width / height;
    std::vector<double> all = {1.0 * i,     1.0 * (i % width),     1.0 * row,     1.0 * layer,
                               1.0 * count, 1.0 * size_.x,         1.0 * size_.y, 1.0 * size_.z,
                               1.0 * seed,  3.14159265358979323846};
    if (table_ == nullptr) return all;
    const std::size_t columns = table_->columns.size();
    for (std::size_t c = 0; c < columns; ++c)
      all.push_back(i < table_->rows() ? table_->values[i * columns + c] : 0);
    return all;
  }

 private:
  const KernelTable* table_;
  glm::ivec3 size_;
  std::vector<std::string> names_;
};

/// Returns formulas for initial values that assign the columns of a table to slots by name. A slot
/// "position" takes the column "position", or the columns position_x, position_y, ..., or the columns x, y,
/// z. Normals may also take nx, ny, nz and velocities vx, vy, vz.
scene::Formulas columnsFor(const KernelTable& table, const std::vector<KernelSlot>& slots) {
  scene::Formulas all;
  const auto has = [&](const std::string& name) {
    return std::find(table.columns.begin(), table.columns.end(), name) != table.columns.end();
  };
  for (const KernelSlot& slot : slots) {
    scene::Formulas::Named named{slot.path, {}};
    std::string plain = slot.path;
    std::replace(plain.begin(), plain.end(), '.', '_');
    std::vector<std::vector<std::string>> choices = {{plain}};
    for (const auto& axes : {std::vector<std::string>{"x", "y", "z", "w"}, {"r", "g", "b", "a"}}) {
      choices.emplace_back();
      for (const std::string& axis : axes) choices.back().push_back(fmt::format("{}_{}", plain, axis));
    }
    if (slot.path.find("os") != std::string::npos || slot.path.empty()) choices.push_back({"x", "y", "z"});
    if (slot.path.find("norm") != std::string::npos) choices.push_back({"nx", "ny", "nz"});
    if (slot.path.find("vel") != std::string::npos) choices.push_back({"vx", "vy", "vz"});
    for (const auto& choice : choices) {
      const std::size_t count = std::min(choice.size(), slot.offsets.size());
      if (!std::all_of(choice.begin(), choice.begin() + static_cast<std::ptrdiff_t>(count), has)) continue;
      for (std::size_t i = 0; i < slot.offsets.size(); ++i)
        named.formula.parts.push_back(i < count ? scene::Formula::Part{0, choice[i]}
                                                : scene::Formula::Part{});
      break;
    }
    if (!named.formula.empty()) all.list.push_back(std::move(named));
  }
  return all;
}

/// Returns the names of the first columns as text.
std::string firstOf(const std::vector<std::string>& columns) {
  constexpr std::size_t maximum = 8;
  std::string names;
  for (std::size_t i = 0; i < std::min(maximum, columns.size()); ++i)
    names += (i == 0 ? "" : ", ") + columns[i];
  return columns.size() > maximum ? names + ", ..." : names;
}

void store(const scene::Formula& formula, const KernelSlot& slot, const Starts& starts, unsigned seed,
           std::size_t count, std::size_t stride, std::byte* memory) {
  std::vector<std::optional<Expression>> parts;
  for (const scene::Formula::Part& part : formula.parts)
    parts.push_back(part.text.empty() ? std::nullopt : std::optional(starts.compiled(part.text)));
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<double> values = starts.values(i, seed);
    for (std::size_t c = 0; c < slot.offsets.size(); ++c) {
      const std::size_t part = formula.parts.size() == 1 ? 0 : c;
      const double value = parts[part] ? parts[part]->at(values, static_cast<std::uint32_t>(i), seed)
                                       : formula.parts[part].number;
      storeSlot(memory + i * stride, slot, c, value);
    }
  }
}

/// Returns the slot called `name`. A name such as "position.x" selects one component.
std::optional<KernelSlot> slotFor(const std::vector<KernelSlot>& slots, const std::string& name) {
  if (const KernelSlot* slot = slotNamed(slots, name)) return *slot;
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos || dot + 2 != name.size()) return std::nullopt;
  const KernelSlot* whole = slotNamed(slots, name.substr(0, dot));
  for (const char* axes : {"xyzw", "rgba"}) {
    const std::size_t at = std::string_view(axes).find(name[dot + 1]);
    if (whole == nullptr || at == std::string_view::npos || at >= whole->offsets.size()) continue;
    KernelSlot one = *whole;
    one.path = name;
    one.offsets = {whole->offsets[at]};
    return one;
  }
  return std::nullopt;
}

}  // namespace

void KernelPlan::planStarts() {
  for (const PlannedBuffer& buffer : buffers_)
    if (buffer.given != nullptr) planStart(buffer);
  for (const PlannedTexture& texture : textures_)
    if (texture.given != nullptr) planStart(texture);
}

/// Checks the formulas of one member or channel.
void KernelPlan::checkStartArray(const char* list, const KernelMemory& given,
                                 const scene::Formulas::Named& named, const KernelSlot& slot,
                                 glm::ivec3 size) {
  std::vector<std::string> path = {list, given.name, "start"};
  if (!named.name.empty()) path.push_back(named.name);
  if (named.formula.moving) return mistake(path, "a first value must not change with time or steps");
  if (named.formula.components() != slot.offsets.size() && named.formula.components() != 1)
    return mistake(path, fmt::format("{} is a {}: expected {} numbers, found {}",
                                     named.name.empty() ? "an element" : scene::inQuotes(named.name),
                                     slot.type, slot.offsets.size(), named.formula.components()));
  const Starts starts(tables_.read(given.file), size);
  for (std::size_t i = 0; i < named.formula.parts.size(); ++i) {
    std::vector<std::string> part = path;
    if (named.formula.parts.size() > 1) part.push_back(std::to_string(i));
    if (const std::string problem = whyTooLarge(slot, named.formula.parts[i].number); !problem.empty())
      mistake(part, problem);
    try {
      if (!named.formula.parts[i].text.empty())
        static_cast<void>(starts.compiled(named.formula.parts[i].text));
    } catch (const scene::ExpressionMistake& wrong) {
      mistake(part, wrong.message, wrong.begin, wrong.end);
    }
  }
}

void KernelPlan::planStart(const PlannedBuffer& buffer) {
  std::vector<std::string> known;
  for (const auto* slots : {&buffer.element, &buffer.fixed})
    for (const KernelSlot& slot : *slots) known.push_back(slot.path);
  for (const scene::Formulas::Named& named : buffer.given->start.list) {
    auto slot = slotFor(buffer.element, named.name);
    if (!slot) slot = slotFor(buffer.fixed, named.name);
    if (slot)
      checkStartArray("buffers", *buffer.given, named, *slot, buffer.size);
    else if (named.name.empty())
      mistake({"buffers", buffer.name, "start"},
              fmt::format("an element has the members {}; say which: {{\"{}\": ...}}",
                          scene::inQuotes(known.front()), known.front()));
    else if (known.size() == 1 && known.front().empty())
      mistake({"buffers", buffer.name, "start", named.name},
              fmt::format("an element of {} is a {} without members: give {}", buffer.name,
                          buffer.element.front().type,
                          buffer.element.front().offsets.size() == 1
                              ? "\"start\": FORMULA"
                              : fmt::format("\"start\": a list of {} formulas",
                                            buffer.element.front().offsets.size())));
    else
      unknown({"buffers", buffer.name, "start", named.name}, named.name, known, "member");
  }
  const KernelTable* table = tables_.read(buffer.given->file);
  if (table != nullptr && buffer.given->start.list.empty() &&
      columnsFor(*table, buffer.element).list.empty())
    mistake({"buffers", buffer.name, "file"},
            fmt::format(
                "no column has the name of a member of {}; add \"start\" with formulas of the columns {}",
                buffer.name, firstOf(table->columns)));
}

void KernelPlan::planStart(const PlannedTexture& texture) {
  const KernelTable* table = tables_.read(texture.given->file);
  if (table != nullptr && texture.given->start.list.empty() &&
      std::none_of(std::begin(channels), std::end(channels), [&](const char* channel) {
        return std::find(table->columns.begin(), table->columns.end(), channel) != table->columns.end();
      }))
    mistake({"textures", texture.name, "file"},
            fmt::format("no column is called r, g, b or a; give \"start\", with formulas of the columns {}",
                        firstOf(table->columns)));
  for (const scene::Formulas::Named& named : texture.given->start.list) {
    KernelSlot slot{named.name, "texel", KernelSlot::Number::real, true, {0, 4, 8, 12}};
    const std::vector<std::string> known(std::begin(channels), std::end(channels));
    if (!named.name.empty()) {
      if (std::find(known.begin(), known.end(), named.name) == known.end()) {
        unknown({"textures", texture.name, "start", named.name}, named.name, known, "channel");
        continue;
      }
      slot.offsets.resize(1);
    } else {
      slot.offsets.resize(std::max<std::size_t>(1, std::min<std::size_t>(4, named.formula.components())));
    }
    checkStartArray("textures", *texture.given, named, slot, texture.size);
  }
}

std::vector<std::byte> KernelPlan::firstBytes(const PlannedBuffer& buffer, unsigned seed) const {
  std::vector<std::byte> bytes(buffer.bytes());
  if (!buffer.counterOf.empty()) {
    const int counted = bufferNamed(buffer.counterOf);
    const KernelMemory* given = counted < 0 ? nullptr : buffers_[static_cast<std::size_t>(counted)].given;
    if (given != nullptr && !buffer.element.empty())
      storeSlot(bytes.data(), buffer.element[0], 0, given->counter);
    return bytes;
  }
  if (buffer.given == nullptr) return bytes;
  const KernelTable* table = tables_.read(buffer.given->file);
  const Starts starts(table, buffer.size);
  scene::Formulas formulas = table == nullptr ? scene::Formulas{} : columnsFor(*table, buffer.element);
  for (const scene::Formulas::Named& named : buffer.given->start.list) formulas.list.push_back(named);
  for (const scene::Formulas::Named& named : formulas.list) {
    if (const auto slot = slotFor(buffer.element, named.name))
      store(named.formula, *slot, starts, seed, buffer.count(), buffer.stride,
            bytes.data() + buffer.header);
    else if (const auto fixed = slotFor(buffer.fixed, named.name))
      store(named.formula, *fixed, starts, seed, 1, 0, bytes.data());
  }
  return bytes;
}

std::vector<double> KernelPlan::firstTexels(const PlannedTexture& texture, unsigned seed) const {
  std::vector<double> texels(4 * texture.count());
  if (texture.given == nullptr) return texels;
  const KernelTable* table = tables_.read(texture.given->file);
  const Starts starts(table, texture.size);
  std::vector<std::pair<int, std::optional<Expression>>> parts;
  std::vector<double> numbers;
  const auto add = [&](int channel, const scene::Formula::Part& part) {
    parts.emplace_back(channel,
                       part.text.empty() ? std::nullopt : std::optional(starts.compiled(part.text)));
    numbers.push_back(part.number);
  };
  if (table != nullptr && texture.given->start.list.empty())
    for (int c = 0; c < 4; ++c)
      if (std::find(table->columns.begin(), table->columns.end(), channels[c]) != table->columns.end())
        add(c, {0, channels[c]});
  for (const scene::Formulas::Named& named : texture.given->start.list) {
    if (named.name.empty()) {
      for (int c = 0; c < static_cast<int>(std::min<std::size_t>(4, named.formula.parts.size())); ++c)
        add(c, named.formula.parts[static_cast<std::size_t>(c)]);
      continue;
    }
    const auto channel =
        std::find(std::begin(channels), std::end(channels), named.name) - std::begin(channels);
    add(static_cast<int>(channel), named.formula.parts[0]);
  }
  for (std::size_t i = 0; i < texture.count() && !parts.empty(); ++i) {
    const auto width = static_cast<std::size_t>(texture.size.x);
    const std::size_t row = i / width, rows = texture.count() / width;
    const std::size_t from = texture.given->upward ? (rows - 1 - row) * width + i % width : i;
    const std::vector<double> values = starts.values(from, seed);
    for (std::size_t p = 0; p < parts.size(); ++p)
      texels[4 * i + static_cast<std::size_t>(parts[p].first)] =
          parts[p].second ? parts[p].second->at(values, static_cast<std::uint32_t>(i), seed) : numbers[p];
  }
  return texels;
}

}  // namespace simreel::sim
