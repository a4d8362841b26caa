#include "signal/simulation.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/random.hpp"
#include "bearing/kinematics.hpp"
#include "signal/described_conditions.hpp"
#include "signal/described_split.hpp"
#include "signal/description.hpp"
#include "signal/ranges.hpp"
#include "signal/toml_table.hpp"

namespace piae::signal {

namespace {

bearing::DynamicsOptions read_dynamics(TomlTable& table, const bearing::Variation& variation) {
  bearing::DynamicsOptions dynamics;
  dynamics.mass_kg = table.number("mass_kg", ranges::mass_kg);
  dynamics.stiffness_n_per_m = table.number("stiffness_n_per_m", ranges::nominal_stiffness_n_per_m);
  dynamics.damping_ns_per_m = table.number("damping_ns_per_m", ranges::nominal_damping_ns_per_m);
  dynamics.clearance_um = table.number("clearance_um", ranges::clearance_um);
  dynamics.load_n = table.number("load_n", ranges::load_n);
  const double lift = bearing::largest_lift_n(dynamics, variation);
  if (dynamics.load_n <= lift) {
    table.refuse("load_n", fmt::format("must exceed {:.6g} N, the largest stiffness times the "
                                       "clearance; otherwise no ball is in contact",
                                       lift));
  }
  return dynamics;
}

void read_table(TomlTable& table, Simulation& simulation) {
  simulation.seed = table.integer("seed", ranges::seed);
  constexpr Range records_per_class{.low = 1, .high = 100'000};
  constexpr Range record_s{.low = 1e-7, .high = 1e8, .unit = " s"};
  simulation.records_per_class =
      static_cast<std::size_t>(table.integer("records_per_class", records_per_class));
  const double samples =
      std::floor(table.number("record_s", record_s) * simulation.info.sample_rate_hz);
  if (samples < 1 || samples > 1e8) table.refuse("record_s", "must give 1 to 1e8 samples");
  simulation.samples = static_cast<std::size_t>(samples);
  bearing::Variation& variation = simulation.variation;
  variation.stiffness_spread = table.number("stiffness_spread", ranges::spread);
  variation.damping_spread = table.number("damping_spread", ranges::spread);
  variation.speed_spread = table.number("speed_spread", ranges::spread);
  simulation.dynamics = read_dynamics(table, variation);
  variation.slip_max = table.number("slip_max", ranges::slip);
  simulation.snr_db = table.optional_number("snr_db", ranges::snr_db);
  const bool faulty = simulation.info.classes.size() > 1;
  if (simulation.snr_db && !faulty) {
    table.refuse("snr_db",
                 "needs a faulty [[class]], whose level sets the noise; add one, or remove snr_db");
  }
}

/// Reads the conditions of a simulation and their uses from [transfer].
std::vector<Condition> described_conditions(TomlTable& root, TomlTable& table,
                                            const DatasetInfo& info, bool any_known) {
  std::vector<RecordSource> records;
  for (TomlTable& condition : table.optional_tables("condition")) {
    RecordSource record;
    record.condition = read_condition_name(condition, "name");
    record.shaft_speed_rpm = condition.number("shaft_speed_rpm", ranges::shaft_speed_rpm);
    if (std::ranges::find(records, record.condition, &RecordSource::condition) != records.end()) {
      condition.refuse("name", "'" + record.condition + "' is given twice");
    }
    condition.finish();
    for (const Label label : info.labels()) {
      record.label = label;
      records.push_back(record);
    }
  }
  return read_described_conditions(root, info, records, any_known);
}

/// Records of one class in one condition.
struct Batch {
  Label label = 0;
  std::int32_t condition = every_condition;
};

/// Returns the batches in the order of simulation.
std::vector<Batch> batches_of(const DatasetInfo& info) {
  std::vector<Batch> batches;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, info.conditions.size()); ++i) {
    const auto condition = info.conditions.empty() ? every_condition : static_cast<std::int32_t>(i);
    for (const Label label : info.labels()) batches.push_back({label, condition});
  }
  return batches;
}

std::string record_name(const Simulation& simulation, const Batch& batch, std::size_t number) {
  const std::size_t digits =
      std::max<std::size_t>(2, std::to_string(simulation.records_per_class).size());
  const DatasetInfo& info = simulation.info;
  const bool of_all = batch.condition == every_condition;
  const std::string stem =
      record_stem(info.class_of(batch.label).name,
                  of_all ? "" : info.conditions[static_cast<std::size_t>(batch.condition)].name);
  return fmt::format("{}-{:0{}}", stem, number + 1, digits);
}

Stream record_stream(const Simulation& simulation, const Record& record) {
  const std::string& class_name = simulation.info.class_of(record.label).name;
  return Stream(fmt::format("{}/seed{}/simulate/{}/{}", simulation.info.name, simulation.seed,
                            class_name, record.name));
}

/// A record without its signal, and the parameters of eq. 13 for that signal.
struct Draw {
  Record record;
  bearing::Course course;
};

Draw draw(const Simulation& simulation, const Batch& batch, std::size_t number) {
  const DatasetInfo& info = simulation.info;
  Draw draw;
  Record& record = draw.record;
  record.name = record_name(simulation, batch, number);
  record.label = batch.label;
  record.condition = batch.condition;
  record.original_sample_rate_hz = info.sample_rate_hz;
  record.source = "simulated";
  Stream stream = record_stream(simulation, record);
  bearing::DynamicsOptions& dynamics = draw.course.options;
  dynamics = bearing::draw_dynamics(stream, simulation.dynamics, simulation.variation);
  draw.course.motion = bearing::draw_motion(stream, info.class_of(batch.label).defect,
                                            info.speed_rpm(batch.condition), simulation.variation);
  record.shaft_speed_rpm = draw.course.motion.shaft_speed_rpm;
  record.parameters = DynamicParameters{dynamics.stiffness_n_per_m, dynamics.damping_ns_per_m};
  return draw;
}

/// Returns `count` records of a batch from this number on, without noise. The noise level depends
/// on all records, so noise is added at the end.
std::vector<Record> clean_records(const Simulation& simulation, const Batch& batch,
                                  std::size_t number, std::size_t count) {
  std::vector<Record> records;
  std::vector<bearing::Course> courses;
  for (std::size_t i = 0; i < count; ++i) {
    Draw drawn = draw(simulation, batch, number + i);
    records.push_back(std::move(drawn.record));
    courses.push_back(drawn.course);
  }
  const DatasetInfo& info = simulation.info;
  const ClassInfo& c = info.class_of(batch.label);
  const std::vector<double> rows =
      bearing::simulate(info.bearing, {c.defect, c.defect_size_mm}, courses,
                        {info.sample_rate_hz, simulation.samples});
  auto row = rows.begin();
  for (Record& record : records) {
    const auto end = row + static_cast<std::ptrdiff_t>(simulation.samples);
    record.signal.assign(row, end);
    row = end;
  }
  return records;
}

double power(const std::vector<double>& signal) {
  double sum = 0;
  for (const double x : signal) sum += x * x;
  return sum / static_cast<double>(signal.size());
}

double faintest_faulty_power(const Recordings& recordings) {
  std::vector<double> sums(recordings.info.classes.size(), 0);
  for (const Record& record : recordings.records)
    sums[index_of(record.label)] += power(record.signal);
  const Label healthy = recordings.info.healthy_label();
  sums.erase(sums.begin() + healthy);
  const std::size_t per_class = recordings.records.size() / recordings.info.classes.size();
  return *std::ranges::min_element(sums) / static_cast<double>(per_class);
}

/// Returns the standard deviation of the measurement noise, from all noise-free records.
double noise_deviation(const Simulation& simulation, const Recordings& clean) {
  return std::sqrt(faintest_faulty_power(clean) * std::pow(10, -*simulation.snr_db / 10));
}

void add_noise(const Simulation& simulation, Recordings& recordings) {
  const double deviation = noise_deviation(simulation, recordings);
  for (Record& record : recordings.records) {
    Stream noise = record_stream(simulation, record).child("noise");
    for (double& x : record.signal) x += noise.normal(0, deviation);
  }
}

}  // namespace

Simulation read_simulation(const std::filesystem::path& file) {
  TomlTable root(file);
  if (!root.has("simulation")) {
    root.refuse("simulation", "is missing: this data set is not simulated; run ingest instead");
  }
  Simulation simulation;
  std::vector<TomlTable> classes = root.tables("class");
  simulation.info = read_info(root, classes);
  require_possible(simulation.info, root, classes);
  require_simulable(simulation.info, classes);
  simulation.info.sample_rate_hz = root.number("sample_rate_hz", ranges::sample_rate_hz);
  TomlTable table = root.table("simulation");
  for (const TomlTable& c : classes) c.finish();
  read_table(table, simulation);
  const SplitSettings split = read_described_split(root);
  simulation.info.conditions = described_conditions(root, table, simulation.info, any_known(split));
  table.finish();
  root.finish();
  return simulation;
}

std::size_t Simulation::records() const { return batches_of(info).size() * records_per_class; }

Recordings simulate(const Simulation& simulation, const std::function<void(std::size_t)>& done) {
  Recordings recordings{simulation.info, {}};
  const std::vector<Batch> batches = batches_of(simulation.info);
  const std::size_t of_each = simulation.records_per_class;
  recordings.records.resize(batches.size() * of_each);
  std::size_t count = 0;
  parallel_for_parts(
      batches.size(), of_each, bearing::courses_at_once, [&](std::size_t first, std::size_t part) {
        const Batch& batch = batches[first / of_each];
        std::ranges::move(clean_records(simulation, batch, first % of_each, part),
                          recordings.records.begin() + static_cast<std::ptrdiff_t>(first));
#pragma omp critical(simulation_progress)
        for (std::size_t i = 0; done && i < part; ++i) done(++count);
      });
  if (simulation.snr_db) add_noise(simulation, recordings);
  std::ranges::sort(recordings.records, {}, &Record::name);
  return recordings;
}

double measurement_noise(const Simulation& simulation) {
  if (!simulation.snr_db) return 0;
  Simulation quiet = simulation;
  quiet.snr_db.reset();
  return noise_deviation(simulation, simulate(quiet));
}

}  // namespace piae::signal
