// Judges healthy windows of CWRU's 97.mat one by one, each by a reference that did not see it, if
// the environment variable DATA_DIR is set, and prints how many are called healthy: the numbers of
// docs/any-bearing.md.
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <cstdlib>
#include <iostream>
#include <memory>

#include "diagnosis/any_bearing.hpp"
#include "diagnosis/line_rules.hpp"
#include "signal/ingest.hpp"

namespace piae::diagnosis {
namespace {

namespace fs = std::filesystem;

const fs::path project = fs::path(__FILE__).parent_path().parent_path().parent_path();

constexpr std::size_t length = 4096;
constexpr std::size_t guard = length;  // samples unused on both sides of a tested window
constexpr std::size_t stride = 512;    // between reference windows

/// The healthy record, cut into windows.
class Healthy {
 public:
  Healthy(const signal::DatasetInfo& info, const signal::Record& record)
      : info_(info), record_(record) {}

  /// Returns the number of windows that do not overlap.
  [[nodiscard]] std::size_t count() const { return record_.signal.size() / length; }
  [[nodiscard]] signal::WindowSet tested(std::size_t i) const {
    signal::WindowSet set = empty();
    add(i * length, set);
    return set;
  }
  /// Returns all windows that lie apart from a tested one.
  [[nodiscard]] signal::WindowSet reference(std::size_t tested) const {
    signal::WindowSet set = empty();
    for (std::size_t first = 0; first + length <= record_.signal.size(); first += stride) {
      const bool is_before = first + length + guard <= tested * length;
      const bool is_after = first >= (tested + 1) * length + guard;
      if (is_before || is_after) add(first, set);
    }
    return set;
  }

 private:
  [[nodiscard]] signal::WindowSet empty() const {
    signal::WindowSet set;
    set.info = info_;
    set.length = length;
    set.record_names = {record_.name};
    return set;
  }
  void add(std::size_t first, signal::WindowSet& set) const {
    const auto start = record_.signal.begin() + static_cast<std::ptrdiff_t>(first);
    set.samples.insert(set.samples.end(), start, start + static_cast<std::ptrdiff_t>(length));
    set.labels.push_back(info_.healthy_label());
    set.record.push_back(0);
    set.first_sample.push_back(static_cast<std::int64_t>(first));
  }

  const signal::DatasetInfo& info_;
  const signal::Record& record_;
};

using Fit = std::function<std::unique_ptr<Trained>(const signal::WindowSet& reference)>;

std::size_t called_healthy(const Healthy& record, const signal::DatasetInfo& info, const Fit& fit) {
  std::size_t healthy = 0;
  for (std::size_t i = 0; i < record.count(); ++i) {
    const Outputs outputs = fit(record.reference(i))->outputs(record.tested(i), "tested");
    const Label named = most_likely(outputs.scores, info.classes.size()).front();
    if (named == info.healthy_label()) ++healthy;
  }
  return healthy;
}

TEST(Cwru97, UnseenHealthyWindowsAreCalledHealthy) {
  const signal::Description description =
      signal::read_description(project / "pipeline/datasets/cwru-types-zero.toml");
  const char* data_dir = std::getenv("DATA_DIR");
  if (data_dir == nullptr || !fs::exists(fs::path(data_dir) / "cwru/97.mat")) {
    GTEST_SKIP() << "DATA_DIR does not have the recordings";
  }
  const signal::Record record =
      signal::RecordReader(description, data_dir).read(description.records.front());
  ASSERT_EQ(record.source, "cwru/97.mat");
  const Healthy healthy(description.info, record);
  ASSERT_EQ(healthy.count(), 14U);

  const artefact::Reader network(project / "results/reference/any-bearing.h5", "any-bearing");
  const auto by_rule = [](Rule rule) {
    return [rule](const signal::WindowSet& reference) -> std::unique_ptr<Trained> {
      return std::make_unique<TrainedRule>(reference, rule, prewhitening_of_rules);
    };
  };
  const std::vector<std::pair<std::string, Fit>> judges{
      {"envelope-rule", by_rule(Rule::envelope)},
      {"exclusion-rule", by_rule(Rule::exclusion)},
      {"any-bearing",
       [&](const signal::WindowSet& reference) { return fit_any_bearing(network, reference); }}};
  for (const auto& [name, fit] : judges) {
    const std::size_t named = called_healthy(healthy, description.info, fit);
    std::cout << fmt::format("{}: {} of {} unseen windows of 97.mat are healthy\n", name, named,
                             healthy.count());
    EXPECT_EQ(named, healthy.count()) << name;
  }
}

}  // namespace
}  // namespace piae::diagnosis
