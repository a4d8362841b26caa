#include "scoring/recall.hpp"

namespace piae::scoring {

namespace {

bool is_healthy(const signal::ClassInfo& info) { return info.defect == signal::Defect::none; }

/// Counts the healthy windows predicted as faulty, or the faulty ones predicted as healthy.
Share mistaken(const Confusion& confusion, std::span<const signal::ClassInfo> classes,
               bool truly_healthy) {
  Share share;
  for (std::size_t truth = 0; truth < confusion.classes; ++truth) {
    if (is_healthy(classes[truth]) != truly_healthy) continue;
    for (std::size_t named = 0; named < confusion.classes; ++named) {
      share.of += confusion.at(truth, named);
      if (is_healthy(classes[named]) != truly_healthy) share.count += confusion.at(truth, named);
    }
  }
  return share;
}

}  // namespace

double Share::percent() const {
  return 100.0 * static_cast<double>(count) / static_cast<double>(of);
}

Share recall_of(const Confusion& confusion, std::size_t truth) {
  Share share{.count = confusion.at(truth, truth)};
  for (std::size_t named = 0; named < confusion.classes; ++named) {
    share.of += confusion.at(truth, named);
  }
  return share;
}

Share missed_faults(const Confusion& confusion, std::span<const signal::ClassInfo> classes) {
  return mistaken(confusion, classes, false);
}

Share false_alarms(const Confusion& confusion, std::span<const signal::ClassInfo> classes) {
  return mistaken(confusion, classes, true);
}

}  // namespace piae::scoring
