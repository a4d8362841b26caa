#include "augment/oracle.hpp"

#include <spdlog/fmt/fmt.h>

#include <utility>

#include "augment/stored_model.hpp"
#include "base/error.hpp"
#include "base/label.hpp"
#include "signal/made_windows.hpp"

namespace piae::augment {

namespace {

/// Returns for each class the indices of its windows in random order; empty for the healthy class.
std::vector<std::vector<std::size_t>> shuffled_classes(const signal::WindowSet& real,
                                                       std::size_t count, const Stream& stream) {
  std::vector<std::vector<std::size_t>> all(real.info.classes.size());
  for (Label label = 0; index_of(label) < all.size(); ++label) {
    const signal::ClassInfo& c = real.info.classes[index_of(label)];
    if (c.defect == signal::Defect::none) continue;
    const std::vector<std::size_t> own = real.indices_of(label);
    if (count > own.size()) {
      throw Error(
          Exit::usage,
          fmt::format("--count {}: class {} has {} real windows, and oracle cannot make more; "
                      "give at most --count {}",
                      count, c.name, own.size(), own.size()));
    }
    for (const std::size_t i : stream.child(c.name).permutation(own.size())) {
      all[index_of(label)].push_back(own[i]);
    }
  }
  return all;
}

}  // namespace

void Oracle::bind(const cli::Options& /*command*/) {}

void Oracle::train(const signal::WindowSet& real, const Stream& /*stream*/,
                   const Compute& /*compute*/, const nets::Checkpoint& /*checkpoint*/,
                   artefact::Writer& model) {
  signal::write(model, real);
}

signal::WindowSet Oracle::generate(const artefact::Reader& model, std::size_t count,
                                   const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSet real = read_learned(model, signal::Role::hidden);
  const auto order = shuffled_classes(real, count, stream);
  const auto take = [&](Label label, std::size_t index, Stream& /*random*/) {
    const std::size_t i = order[index_of(label)][index];
    const auto window = real.window(i);
    signal::MadeWindow taken(std::vector<float>(window.begin(), window.end()));
    if (!real.shaft_speed_rpm.empty()) taken.shaft_speed_rpm = real.shaft_speed_rpm[i];
    return taken;
  };
  return signal::make_windows(real.info, real.length, count, stream, take);
}

}  // namespace piae::augment
