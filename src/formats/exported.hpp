#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::formats {

/// Windows that leave the project, and what the artefact says of all of them.
struct Exported {
  signal::WindowSet windows;
  std::vector<std::size_t> rows;  ///< [n] where each window stands in the artefact, from 0
  std::string role;               ///< "A" to "E"
  std::string method;             ///< that made them, of E; else empty
};

/// The first `count` windows of each of these classes, in the order of the artefact: of all classes
/// where none is named, and all windows where `count` is 0. Throws Error(usage) for a class that
/// the windows do not have, and Error(bad_input) where no window is left.
Exported select(const signal::WindowSet& windows, const std::vector<std::string>& classes,
                std::size_t count);

using Texts = std::vector<std::string>;
using Numbers = std::vector<double>;
using Lists = std::vector<std::vector<double>>;

/// Something that is known of windows, by the name that it has in every format: "class_name".
struct Fact {
  std::string name;
  std::variant<Texts, Numbers, Lists> values;
};

/// What is known beside the samples. Indices count from 0, as in the artefacts.
struct Facts {
  std::vector<Fact> of_all;   ///< one value, which holds for all windows
  std::vector<Fact> of_each;  ///< a value for each window
};

/// Of all: data set, role, method, sampling rate, unit. Of each: where it stands, its class, and
/// what WindowSet says of it where it does: record, condition, speed, (k, c), parents and so on.
Facts facts_of(const Exported& exported);

}  // namespace piae::formats
