#include "zero/made.hpp"

#include "signal/made_windows.hpp"

namespace piae::zero {

signal::WindowSet make_windows(const Machine& machine, std::size_t count, const Stream& stream,
                               const Make& make) {
  const bool told_apart = !machine.info().conditions.empty();
  signal::WindowSet said;
  const auto make_one = [&](Label label, std::size_t index, Stream& random) {
    const Scene scene = machine.draw_scene(label, index, random);
    Made made = make(scene, random);
    said.strikes_s.push_back(std::move(made.strikes_s));
    if (made.ring) said.parameters.push_back(*made.ring);
    if (told_apart) {
      said.condition.push_back(scene.condition);
      said.shaft_speed_rpm.push_back(scene.shaft_speed_rpm);
    }
    return std::move(made.samples);
  };
  signal::WindowSet made =
      signal::make_windows(machine.info(), machine.length(), count, stream, make_one);
  made.strikes_s = std::move(said.strikes_s);
  made.parameters = std::move(said.parameters);
  made.condition = std::move(said.condition);
  made.shaft_speed_rpm = std::move(said.shaft_speed_rpm);
  return made;
}

}  // namespace piae::zero
