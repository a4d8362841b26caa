#include "figures/critical_difference.hpp"

#include <algorithm>
#include <numeric>

#include "report/rank_table.hpp"

namespace piae::figures {

namespace {

/// Methods that the test cannot distinguish, as places in their order from the best.
struct Alike {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Returns the groups that are not part of a larger group. `ranks` ascend.
std::vector<Alike> groups_within(const std::vector<double>& ranks, double difference) {
  std::vector<Alike> groups;
  for (std::size_t first = 0; first < ranks.size(); ++first) {
    const auto beyond =
        std::ranges::find_if(ranks, [&](double rank) { return rank - ranks[first] > difference; });
    const auto last = static_cast<std::size_t>(beyond - ranks.begin()) - 1;
    if (last > first && (groups.empty() || groups.back().last < last))
      groups.push_back({first, last});
  }
  return groups;
}

class RankRows {
 public:
  void add(const std::string& ratio, const std::vector<std::string>& methods,
           const scoring::AverageRanks& ranks) {
    std::vector<std::size_t> order(methods.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return ranks.average[i]; });
    const std::vector<std::string> test{std::to_string(ranks.blocks),
                                        ranks.p ? digits(*ranks.p) : "",
                                        ranks.p ? digits(*ranks.critical_difference) : ""};
    std::vector<double> ascending;
    for (const std::size_t i : order) {
      ascending.push_back(ranks.average[i]);
      row({ratio, "method", methods[i], std::to_string(ascending.size()), digits(ranks.average[i]),
           ""},
          test);
    }
    if (!ranks.p) return;
    std::size_t place = 0;
    for (const Alike& group : groups_within(ascending, *ranks.critical_difference)) {
      row({ratio, "alike", "", std::to_string(++place), digits(ascending[group.first]),
           digits(ascending[group.last])},
          test);
    }
  }
  [[nodiscard]] const Numbers& numbers() const { return numbers_; }

 private:
  void row(std::vector<std::string> fields, const std::vector<std::string>& test) {
    fields.insert(fields.end(), test.begin(), test.end());
    numbers_.row(fields);
  }

  Numbers numbers_{{"ratio", "kind", "method", "place", "rank", "rank_to", "seeds", "friedman_p",
                    "critical_difference"}};
};

}  // namespace

Numbers critical_differences(Source& /*source*/, const report::ClassifierRows& shown) {
  const report::RankTable table = report::rank_methods(shown.rows);
  if (table.ratios.empty()) {
    throw LeftOut("fewer than two methods, without ceilings, have the same ratio");
  }
  RankRows rows;
  for (const auto& [column, ranks] : table.ratios) rows.add(column.ratio, table.methods, ranks);
  return rows.numbers();
}

}  // namespace piae::figures
