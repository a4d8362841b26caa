#include "readings/ranking.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "text/csv.hpp"

namespace piae::readings {

namespace {

using Settings = std::vector<std::string>;

struct Tried {
  std::string reading;
  double sum = 0;
  std::size_t count = 0;

  [[nodiscard]] double mean() const { return sum / static_cast<double>(count); }
};

Settings settings_in(const std::string& reading) {
  Settings settings;
  if (reading == "base") return settings;
  std::istringstream words(reading);
  for (std::string word; std::getline(words, word, '+');) settings.push_back(word);
  return settings;
}

std::string factor_of(const std::string& setting) { return setting.substr(0, setting.find('=')); }

/// Returns the settings in alphabetical order, so that each set has one name.
std::string name_of(Settings settings) {
  std::ranges::sort(settings);
  return fmt::format("{}", fmt::join(settings, "+"));
}

std::vector<Tried> read_accuracies(const std::vector<std::filesystem::path>& tables) {
  std::vector<Tried> all;
  for (const std::filesystem::path& table : tables) {
    for (const text::CsvLine& line : text::read_csv(table)) {
      const std::string& reading = line.fields[1];
      const bool counts = line.fields[2] == "accuracy" && reading != "published";
      if (!counts) continue;
      const auto mean = line.number(5);
      if (!mean) line.refuse("the mean must be a number");
      auto found = std::ranges::find(all, reading, &Tried::reading);
      if (found == all.end()) found = all.insert(all.end(), Tried{.reading = reading});
      found->sum += *mean;
      ++found->count;
    }
  }
  return all;
}

/// Suggests what to try next: the best interpretation with one more setting.
std::vector<std::string> next_to(const Tried& best, const std::vector<Tried>& all) {
  const Settings own = settings_in(best.reading);
  std::set<std::string> names;
  for (const Tried& each : all) names.insert(name_of(settings_in(each.reading)));
  std::vector<std::string> next;
  for (const Tried& each : all) {
    const Settings settings = settings_in(each.reading);
    const bool is_moved = std::ranges::any_of(own, [&](const std::string& setting) {
      return settings.size() == 1 && factor_of(setting) == factor_of(settings.front());
    });
    if (settings.size() != 1 || is_moved) continue;
    Settings more = own;
    more.push_back(settings.front());
    if (!names.contains(name_of(more))) next.push_back(name_of(more));
  }
  return next;
}

}  // namespace

std::string ranking(const std::vector<std::filesystem::path>& tables) {
  const std::vector<Tried> all = read_accuracies(tables);
  if (all.empty()) return {};
  const std::size_t most = std::ranges::max_element(all, {}, &Tried::count)->count;
  std::vector<Tried> ranked;
  std::ranges::copy_if(all, std::back_inserter(ranked),
                       [&](const Tried& each) { return each.count == most; });
  std::ranges::stable_sort(ranked, std::ranges::greater(), &Tried::mean);
  std::string text;
  for (const Tried& each : ranked) text += fmt::format("{:6.2f}  {}\n", each.mean(), each.reading);
  for (const std::string& next : next_to(ranked.front(), all))
    text += "to try next: " + next + '\n';
  return text;
}

}  // namespace piae::readings
