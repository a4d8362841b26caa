#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::readings {

/// Ranks interpretations by mean accuracy over data sets and ratios, a line each, in percent. Then
/// lists the candidates of a stepwise search: the best one with each setting that only others have.
/// Reads tables of csv(). Interpretations that lack a data set or ratio that others have are not
/// ranked. Throws as text::read_csv() does.
std::string ranking(const std::vector<std::filesystem::path>& tables);

}  // namespace piae::readings
