#include "signal/machine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/description_text.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::signal {
namespace {

const std::string machine_description = described_bearing("small") + described_normal +
                                        described_ir007 + described_or021 +
                                        described_simulation("2", "0.2");

/// The machine description without variation.
const std::string steady_description = replaced(
    replaced(
        replaced(replaced(machine_description, "stiffness_spread = 0.1", "stiffness_spread = 0"),
                 "damping_spread = 0.2", "damping_spread = 0"),
        "slip_max = 0.01", "slip_max = 0"),
    "speed_spread = 0.001", "speed_spread = 0");

Simulation simulation_of(const std::string& text) {
  const Folder folder;
  return read_simulation(folder.write("small.toml", text));
}

std::vector<float> signal_of(const std::string& description, const std::string& class_name,
                             const MachineOptions& options) {
  Machine machine(simulation_of(description), class_name, options);
  std::vector<float> signal;
  for (std::vector<float> next; !(next = machine.next()).empty();) {
    signal.insert(signal.end(), next.begin(), next.end());
  }
  return signal;
}

/// Returns the root mean square of the samples from one time to another, in s.
double level(const std::vector<float>& signal, double from_s, double to_s) {
  const auto first = signal.begin() + std::lround(from_s * 12000);
  const auto last = signal.begin() + std::lround(to_s * 12000);
  double squares = 0;
  std::for_each(first, last, [&](double x) { squares += x * x; });
  return std::sqrt(squares / static_cast<double>(last - first));
}

TEST(Machine, RunsForTheRequestedDuration) {
  EXPECT_EQ(signal_of(machine_description, "Normal", {.duration_s = 0.5}).size(), 6000U);
  EXPECT_EQ(signal_of(machine_description, "Normal", {.duration_s = 20.5}).size(), 246000U);
  EXPECT_EQ(
      signal_of(machine_description, "OR021", {.duration_s = 9.25, .appears_at_s = 0.3}).size(),
      111000U);
}

TEST(Machine, IsHealthyUntilTheDefectAppears) {
  const MachineOptions options{.duration_s = 4, .appears_at_s = 2.3, .seed = 3};
  const std::string noisy = machine_description + "snr_db = 10\n";
  const auto healthy = signal_of(noisy, "Normal", options);
  for (const char* defect : {"OR021", "IR007"}) {
    const auto faulty = signal_of(noisy, defect, options);
    ASSERT_EQ(faulty.size(), healthy.size());
    const auto [in_one, in_other] = std::ranges::mismatch(healthy, faulty);
    EXPECT_GE(in_one - healthy.begin(), 27600) << defect;
    EXPECT_LT(in_one - healthy.begin(), 27600 + 600) << defect << " is struck within a turn or two";
    EXPECT_GT(level(faulty, 2.4, 4), 1.5 * level(faulty, 0, 2.3)) << defect;
  }
}

/// The onset of the defect shifts the ends of later stretches. Long after it, the signal must equal
/// one uninterrupted solution of eq. 13.
TEST(Machine, JoinsStretchesWithoutASeam) {
  const std::string roller =
      replaced(replaced(steady_description, "IR007", "B007"), "inner\"\ndef", "roller\"\ndef");
  for (const auto& [text, defect] :
       {std::pair{steady_description, "OR021"}, {steady_description, "IR007"}, {roller, "B007"}}) {
    const auto one = signal_of(text, defect, {.duration_s = 4, .appears_at_s = 0.25});
    const auto other = signal_of(text, defect, {.duration_s = 4, .appears_at_s = 0.75});
    double difference = 0;
    for (std::size_t i = 12000; i < one.size(); ++i) {
      difference = std::max<double>(difference, std::abs(one[i] - other[i]));
    }
    EXPECT_LT(difference, 1e-3 * level(one, 1, 4)) << defect;
  }
}

TEST(Machine, DriftsSlowly) {
  const std::string loose =
      replaced(steady_description, "stiffness_spread = 0", "stiffness_spread = 0.2");
  const auto unrest = [&](double drift_s) {
    const auto signal = signal_of(loose, "OR021", {.duration_s = 40, .drift_s = drift_s});
    std::vector<double> levels;
    for (int second = 1; second < 40; ++second) {
      levels.push_back(level(signal, second, second + 1));
    }
    const auto [least, most] = std::ranges::minmax(levels);
    return most / least - 1;
  };
  EXPECT_LT(unrest(1e9), 0.01);
  EXPECT_GT(unrest(10), 0.05);
}

TEST(Machine, DiffersForAnotherSeed) {
  const auto one = signal_of(machine_description, "OR021", {.duration_s = 1, .seed = 1});
  EXPECT_EQ(one, signal_of(machine_description, "OR021", {.duration_s = 1, .seed = 1}));
  EXPECT_NE(one, signal_of(machine_description, "OR021", {.duration_s = 1, .seed = 2}));
}

TEST(Machine, HasTheMeasurementNoiseOfTheRecords) {
  const std::string noisy = machine_description + "snr_db = 10\n";
  const double noise = measurement_noise(simulation_of(noisy));
  EXPECT_EQ(measurement_noise(simulation_of(machine_description)), 0);
  const auto clean = signal_of(machine_description, "OR021", {.duration_s = 2});
  const auto measured = signal_of(noisy, "OR021", {.duration_s = 2});
  double squares = 0;
  for (std::size_t i = 0; i < clean.size(); ++i) squares += std::pow(measured[i] - clean[i], 2);
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(clean.size())) / noise, 1, 0.02);

  // A record of a healthy bearing is almost only noise.
  const Recordings records = simulate(simulation_of(noisy));
  const auto normal = std::ranges::find(records.records, "Normal-01", &Record::name);
  ASSERT_NE(normal, records.records.end());
  double power = 0;
  for (const double x : normal->signal) power += x * x;
  EXPECT_NEAR(std::sqrt(power / static_cast<double>(normal->signal.size())) / noise, 1, 0.1);
}

TEST(Machine, RefusesImpossibleOptions) {
  const Simulation simulation = simulation_of(machine_description);
  EXPECT_ERROR(Machine(simulation, "OR007", {}), Exit::usage,
               "--stream OR007: small has no such class; it has Normal, IR007, OR021");
  EXPECT_ERROR(Machine(simulation, "OR021", {.duration_s = 5, .appears_at_s = 5}), Exit::usage,
               "--appears-at-s 5: the machine runs for 5 s only");
  EXPECT_NO_THROW(Machine(simulation, "Normal", {.duration_s = 5, .appears_at_s = 5}));
}

}  // namespace
}  // namespace piae::signal
