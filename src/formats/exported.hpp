#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::formats {

/// Exported windows, with facts that hold for all of them.
struct Exported {
  signal::WindowSet windows;
  std::vector<std::size_t> rows;  ///< [n] index of each window in the artefact, from 0
  std::string role;               ///< "A" to "E"
  std::string method;             ///< method that made them, for E; else empty
};

/// Selects the first `count` windows of each of these classes, in the order of the artefact: of all
/// classes if none is named, and all windows if `count` is 0. Throws Error(usage) for a class that
/// the windows do not have, and Error(bad_input) if no window remains.
Exported select(const signal::WindowSet& windows, const std::vector<std::string>& classes,
                std::size_t count);

using Texts = std::vector<std::string>;
using Numbers = std::vector<double>;
using Lists = std::vector<std::vector<double>>;

/// A fact about windows, under its name in every format: "class_name".
struct Fact {
  std::string name;
  std::variant<Texts, Numbers, Lists> values;
};

/// Facts in addition to the samples. Indices count from 0, as in the artefacts.
struct Facts {
  std::vector<Fact> of_all;   ///< one value for all windows
  std::vector<Fact> of_each;  ///< a value for each window
};

/// Returns for all windows: data set, role, method, sampling rate, unit. For each window: its
/// index, its class, and what WindowSet records, such as record, condition, speed, (k, c) and
/// parents.
Facts facts_of(const Exported& exported);

}  // namespace piae::formats
