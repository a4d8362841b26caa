#include "report/counterpart.hpp"

#include <utility>

namespace piae::report {

namespace {

constexpr PaperDataset cwru{"cwru", "CWRU", 6, 8, 10, 13, 16};
constexpr PaperDataset hfhp{"hfhp", "HFHP", 7, 9, 11, 14, 17};

const std::pair<const char*, Counterpart> counterparts[] = {
    {"cwru", {cwru, true, "", ""}},
    {"hfhp", {hfhp, true, "", ""}},
    {"hit-sm",
     {hfhp, false, "stands in for HFHP",
      "HFHP, the paper's second dataset, is private; hit-sm stands in for it. What the paper "
      "publishes of HFHP is shown for orientation only: it is of another rig, of other defects, "
      "and nothing here can agree or disagree with it."}},
    {"cwru-as-published",
     {cwru, false, "is CWRU with its sample rates mixed",
      "Here the healthy record, which was made at 48 kHz, is taken for one of 12 kHz. Whether the "
      "paper did so is not known: what it publishes of CWRU is shown for orientation only."}},
};

}  // namespace

std::optional<Counterpart> counterpart(const std::string& dataset) {
  for (const auto& [name, each] : counterparts) {
    if (dataset == name) return each;
  }
  return std::nullopt;
}

}  // namespace piae::report
