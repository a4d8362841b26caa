#include "inspection/common_factor.hpp"

#include <algorithm>
#include <cmath>

#include "spectra/floors.hpp"

namespace piae::inspection {

namespace {

constexpr double agreement = 0.02;  // on either side, as in the search for fault lines
constexpr double places = 20;       // 2 ln(3 / 2) / (2 * agreement)
constexpr double chance_of_agreement = 0.01;

/// Returns the line of the record's own class.
const FaultLine& own_line(const signal::DatasetInfo& info, const RecordCheck& record) {
  return line_of(record.lines, info.class_of(record.source.label).defect);
}

/// Returns the log probability that this many of `all` records agree by chance.
double log_chance(double agreeing, double all) {
  const double choices =
      std::lgamma(all + 1) - std::lgamma(agreeing + 1) - std::lgamma(all - agreeing + 1);
  return choices - (agreeing - 1) * std::log(places);
}

}  // namespace

std::optional<CommonFactor> common_factor(const signal::DatasetInfo& info,
                                          const std::vector<const RecordCheck*>& records) {
  const auto factor_of = [&](const RecordCheck* record) {
    const FaultLine& line = own_line(info, *record);
    return line.stands_out ? 0 : line.farthest_factor;
  };
  CommonFactor most;
  for (const RecordCheck* centre : records) {
    if (factor_of(centre) <= 0) continue;
    std::vector<const RecordCheck*> agreeing;
    std::ranges::copy_if(records, std::back_inserter(agreeing), [&](const RecordCheck* record) {
      const double factor = factor_of(record);
      return factor > 0 && std::abs(std::log(factor / factor_of(centre))) <= agreement;
    });
    if (agreeing.size() > most.records.size()) most.records = std::move(agreeing);
  }
  if (2 * most.records.size() <= records.size()) return std::nullopt;
  const auto all = static_cast<double>(records.size());
  const auto m = static_cast<double>(most.records.size());
  if (log_chance(m, all) >= std::log(chance_of_agreement)) return std::nullopt;
  const signal::Defect fault_type = own_line(info, *most.records.front()).fault_type;
  const bool one_type = std::ranges::all_of(most.records, [&](const RecordCheck* record) {
    return own_line(info, *record).fault_type == fault_type;
  });
  if (one_type) return std::nullopt;
  std::vector<double> factors;
  for (const RecordCheck* record : most.records) factors.push_back(factor_of(record));
  most.factor = spectra::median(std::move(factors));
  if (std::abs(std::log(most.factor)) <= agreement) return std::nullopt;
  return most;
}

}  // namespace piae::inspection
