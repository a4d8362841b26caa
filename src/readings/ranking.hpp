#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::readings {

/// Ranks readings by their mean accuracy over data sets and ratios, a line each, in percent; then
/// names what a stepwise search would try next: the best one with each setting of the others that
/// it does not have. Reads tables of csv(). A reading that lacks a data set or a ratio that others
/// have cannot be compared, and is not ranked. Throws as text::read_csv() does.
std::string ranking(const std::vector<std::filesystem::path>& tables);

}  // namespace piae::readings
