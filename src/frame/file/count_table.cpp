#include "frame/file/count_table.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace simreel::frame {

namespace {

/// Formats one cell. For a float, uses the shortest text that is read back as the same float.
std::string cell(const sim::World::CountNames& names, const glm::uvec4* row, std::size_t column) {
  const unsigned word = row[column / 4][static_cast<int>(column % 4)];
  return names.measured ? fmt::format("{}", std::bit_cast<float>(word)) : fmt::format("{}", word);
}

}  // namespace

CountTable::CountTable(double fps, std::vector<sim::World::CountNames> names)
    : fps_(fps), names_(std::move(names)) {
  text_ = "step,time";
  for (const auto& object : names_)
    for (const std::string& column : object.columns) text_ += "," + object.object + "." + column;
  text_ += "\n";
}

void CountTable::add(const sim::World::Summary& summary) {
  SIMREEL_CHECK_EQ(summary.counts.size(), names_.size());
  const auto count = [&](std::size_t i) {
    return static_cast<long>(summary.counts[i].size()) / names_[i].elements;
  };
  if (rows_ == 0) {  // Frame 0 has one row with the counts of every object.
    std::vector<const glm::uvec4*> row;
    for (const auto& counts : summary.counts) row.push_back(counts.empty() ? nullptr : counts.data());
    addRow(summary.frame / fps_, row);
    return;
  }
  // An object with n rows in this frame has row j (from 1) at the fraction j / n of the frame. The loop
  // merges the rows of all objects in time order. Fractions are compared by cross-multiplication, so equal
  // times match exactly.
  std::vector<long> next(names_.size(), 1);
  while (true) {
    long top = 0;
    long bottom = 0;
    for (std::size_t i = 0; i < next.size(); ++i)
      if (next[i] <= count(i) && (bottom == 0 || next[i] * bottom < top * count(i))) {
        top = next[i];
        bottom = count(i);
      }
    if (bottom == 0) return;
    std::vector<const glm::uvec4*> row(next.size(), nullptr);
    for (std::size_t i = 0; i < next.size(); ++i)
      if (next[i] <= count(i) && next[i] * bottom == top * count(i))
        row[i] = &summary.counts[i][static_cast<std::size_t>(next[i]++ - 1) *
                                    static_cast<std::size_t>(names_[i].elements)];
    addRow((summary.frame - 1 + static_cast<double>(top) / static_cast<double>(bottom)) / fps_, row);
  }
}

void CountTable::resume(std::string_view text) {
  if (text.empty()) return;
  text_ = text;
  rows_ = std::count(text.begin(), text.end(), '\n') - 1;
}

std::string_view CountTable::header() const {
  return std::string_view(text_).substr(0, text_.find('\n'));
}

std::string_view CountTable::lastRow() const {
  const std::string_view all = std::string_view(text_).substr(0, text_.size() - 1);
  return all.substr(all.rfind('\n') + 1);
}

void CountTable::addRow(double time, const std::vector<const glm::uvec4*>& counts) {
  text_ += fmt::format("{},{:.6f}", rows_++, time);
  for (std::size_t i = 0; i < counts.size(); ++i)
    for (std::size_t c = 0; c < names_[i].columns.size(); ++c)
      text_ += counts[i] == nullptr ? std::string(",") : "," + cell(names_[i], counts[i], c);
  text_ += "\n";
}

}  // namespace simreel::frame
