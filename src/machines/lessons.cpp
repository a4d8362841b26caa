#include "machines/lessons.hpp"

#include <mutex>
#include <string>

#include "base/parallel.hpp"
#include "machines/healthy.hpp"
#include "symptoms/baseline.hpp"
#include "zero/twin.hpp"

namespace piae::machines {

namespace {

using signal::WindowSet;

/// Returns fault windows of a machine on another day.
WindowSet fault_windows_of(const Machine& machine, const LessonOptions& options,
                           const Stream& stream) {
  const WindowSet background = healthy_windows(machine, static_cast<std::size_t>(options.reference),
                                               Day::other, stream.child("background"));
  const zero::Machine known(background);
  const zero::Twin twin(known, options.prior);
  WindowSet faults = zero::make_windows(
      known, static_cast<std::size_t>(options.of_each_fault), stream.child("faults"),
      [&](const zero::Scene& scene, const Stream& random) { return twin.make(scene, random); });
  add_wear(machine, options.wear, options.prior, stream.child("wear"), faults);
  return faults;
}

void add_lessons(const WindowSet& windows, symptoms::Baselines& reference, Lessons& lessons) {
  const auto measures = symptoms::measure(windows, "lesson", reference.prewhitening());
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const symptoms::Baseline& baseline = reference.at(windows.speed_rpm(i));
    lessons.symptoms.push_back(
        symptoms_of(measures[i], baseline, baseline.novelty().of(measures[i].shape_db)));
    lessons.labels.push_back(windows.labels[i]);
  }
}

Lessons lessons_of_one(const LessonOptions& options, const Stream& stream) {
  const Machine machine = draw_machine(stream);
  const WindowSet healthy = healthy_windows(machine, static_cast<std::size_t>(options.reference),
                                            Day::of_reference, stream.child("reference"));
  symptoms::Baselines reference(
      healthy, symptoms::measure(healthy, "reference", options.prewhitening), options.prewhitening);
  Lessons lessons;
  add_lessons(healthy_windows(machine, static_cast<std::size_t>(options.healthy), Day::other,
                              stream.child("healthy")),
              reference, lessons);
  add_lessons(fault_windows_of(machine, options, stream), reference, lessons);
  return lessons;
}

}  // namespace

Lessons draw_lessons(const LessonOptions& options, const Stream& stream,
                     const std::function<void(std::size_t)>& machine_done) {
  std::vector<Lessons> of_machines(static_cast<std::size_t>(options.machines));
  std::mutex one_at_a_time;
  std::size_t done = 0;
  parallel_for(of_machines.size(), [&](std::size_t i) {
    of_machines[i] = lessons_of_one(options, stream.child(std::to_string(i)));
    const std::lock_guard lock(one_at_a_time);
    ++done;
    if (machine_done) machine_done(done);
  });
  Lessons all;
  for (const Lessons& one : of_machines) {
    all.symptoms.insert(all.symptoms.end(), one.symptoms.begin(), one.symptoms.end());
    all.labels.insert(all.labels.end(), one.labels.begin(), one.labels.end());
  }
  return all;
}

}  // namespace piae::machines
