#include "figures/twin_space.hpp"

#include <algorithm>

#include "augment/catalogue.hpp"
#include "signal/window_set.hpp"
#include "twin/physics.hpp"
#include "twin/space.hpp"

namespace piae::figures {

namespace {

/// Largest number of generated windows of a class; more would hide the known ones.
constexpr std::size_t shown_of_a_class = 50;

class SpaceRows {
 public:
  explicit SpaceRows(std::string method) : method_(std::move(method)) {}

  /// Adds the joint histogram, then its marginals, whose bins cover all values of the other
  /// parameter.
  void bins(const twin::TwinSpace& space) {
    const std::vector<double>& k = space.k_edges();
    const std::vector<double>& c = space.c_edges();
    const std::size_t across = c.size() - 1;
    std::vector<std::int64_t> of_k(k.size() - 1);
    std::vector<std::int64_t> of_c(across);
    for (std::size_t i = 0; i < space.counts().size(); ++i) {
      const std::size_t row = i / across;
      const std::size_t column = i % across;
      of_k[row] += space.counts()[i];
      of_c[column] += space.counts()[i];
      bin("bin", {k[row], c[column]}, {k[row + 1], c[column + 1]}, space.counts()[i]);
    }
    for (std::size_t i = 0; i < of_k.size(); ++i) {
      bin("k-bin", {k[i], c.front()}, {k[i + 1], c.back()}, of_k[i]);
    }
    for (std::size_t i = 0; i < of_c.size(); ++i) {
      bin("c-bin", {k.front(), c[i]}, {k.back(), c[i + 1]}, of_c[i]);
    }
  }

  void point(const std::string& kind, const std::string& class_name,
             const signal::DynamicParameters& at) {
    numbers_.row({method_, kind, class_name, digits(at.stiffness_n_per_m),
                  digits(at.damping_ns_per_m), "", "", ""});
  }

  void method(const std::string& name) { method_ = name; }
  [[nodiscard]] const Numbers& numbers() const { return numbers_; }

 private:
  void bin(const std::string& kind, const twin::TwinPoint& from, const twin::TwinPoint& to,
           std::int64_t windows) {
    const signal::DynamicParameters low = twin::in_units(from);
    const signal::DynamicParameters high = twin::in_units(to);
    numbers_.row({method_, kind, "", digits(low.stiffness_n_per_m), digits(low.damping_ns_per_m),
                  digits(high.stiffness_n_per_m), digits(high.damping_ns_per_m),
                  std::to_string(windows)});
  }

  std::string method_;
  Numbers numbers_{{"method", "kind", "class", "k_n_per_m", "c_ns_per_m", "k_to_n_per_m",
                    "c_to_ns_per_m", "windows"}};
};

std::string class_of(const signal::WindowSet& windows, std::size_t i) {
  return windows.info.class_of(windows.labels[i]).name;
}

void add_generated(SpaceRows& rows, const signal::WindowSet& generated) {
  for (const Label label : generated.info.fault_labels()) {
    const std::vector<std::size_t> all = generated.indices_of(label);
    for (std::size_t i = 0; i < std::min(all.size(), shown_of_a_class); ++i) {
      rows.point("generated", class_of(generated, all[i]), generated.parameters.at(all[i]));
    }
  }
}

}  // namespace

Numbers twin_space(Source& source) {
  const std::int64_t seed = source.shown_seed();
  const signal::WindowSet known =
      signal::read_window_set({source.layout().known_windows(seed), "windows"});
  SpaceRows rows("");
  for (const std::string& method : source.inferring_methods()) {
    rows.method(method);
    const twin::TwinSpace space(source.model(method, seed));
    rows.bins(space);
    add_generated(rows, signal::read_window_set(
                            {source.layout().generated_windows(method, seed), "windows"}));
    for (std::size_t i = 0; i < space.points().size(); ++i) {
      rows.point("known", class_of(known, i), twin::in_units(space.points()[i]));
    }
    for (std::size_t i = 0; i < known.parameters.size(); ++i) {
      rows.point("true", class_of(known, i), known.parameters[i]);
    }
  }
  return rows.numbers();
}

}  // namespace piae::figures
