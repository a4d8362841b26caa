#include "nets/parameters.hpp"

#include <algorithm>
#include <stdexcept>

#include "base/vector.hpp"
#include "nets/stored_parameters.hpp"

namespace piae::nets {

namespace {

/// Calls f(held, flat) for each row of a parameter. `held` is the start of the row in the arrays of
/// Parameters::data(), `flat` its start among the parameter's own numbers without padding.
template <class Parameter, class F>
void for_each_row(const Parameter& parameter, const F& f) {
  for (std::int64_t row = 0; row < parameter.rows; ++row) {
    f(parameter.begin + row * parameter.held_columns, row * parameter.columns);
  }
}

}  // namespace

template <class T>
Parameters<T>::Parameters(std::vector<ParameterSpec> specs, const Stream& stream) {
  std::int64_t begin = 0;
  for (ParameterSpec& spec : specs) {
    const std::int64_t rows = spec.shape.size() > 1 ? spec.shape.front() : 1;
    const std::int64_t columns = spec.size() / rows;
    parameters_.push_back({.spec = std::move(spec),
                           .begin = begin,
                           .rows = rows,
                           .columns = columns,
                           .held_columns = whole_rows(columns)});
    begin += rows * whole_rows(columns);
  }
  for (Numbers& numbers : kept_) numbers = Numbers::Zero(begin);
  for (const Parameter& parameter : parameters_) {
    const std::vector<double> initial = initial_values(parameter.spec, stream);
    for_each_row(parameter, [&](std::int64_t held, std::int64_t flat) {
      std::copy_n(initial.begin() + flat, parameter.columns, data(Kept::value) + held);
    });
  }
}

template <class T>
const typename Parameters<T>::Parameter& Parameters<T>::find(const std::string& name) const {
  const auto found =
      std::ranges::find(parameters_, name, [](const Parameter& p) { return p.spec.name; });
  if (found == parameters_.end()) throw std::logic_error("no parameter is called " + name);
  return *found;
}

template <class T>
void Parameters<T>::copy(Kept kept, std::span<float> to, const std::string& prefix) const {
  for (const Parameter& parameter : parameters_) {
    if (!parameter.spec.name.starts_with(prefix)) continue;
    for_each_row(parameter, [&](std::int64_t held, std::int64_t flat) {
      std::copy_n(data(kept) + held, parameter.columns, to.data() + flat);
    });
    to = to.subspan(static_cast<std::size_t>(parameter.spec.size()));
  }
}

template <class T>
std::vector<float> Parameters<T>::read(Kept kept, const std::string& prefix) const {
  std::size_t size = 0;
  for (const Parameter& parameter : parameters_) {
    if (parameter.spec.name.starts_with(prefix)) {
      size += static_cast<std::size_t>(parameter.spec.size());
    }
  }
  std::vector<float> all(size);
  copy(kept, all, prefix);
  return all;
}

template <class T>
void Parameters<T>::write(Kept kept, std::span<const float> all, const std::string& prefix) {
  for (const Parameter& parameter : parameters_) {
    if (!parameter.spec.name.starts_with(prefix)) continue;
    for_each_row(parameter, [&](std::int64_t held, std::int64_t i) {
      std::copy_n(all.data() + i, parameter.columns, data(kept) + held);
    });
    all = all.subspan(static_cast<std::size_t>(parameter.spec.size()));
  }
}

void write_moments(artefact::Writer& writer, const std::string& group,
                   const Parameters<float>& parameters, const std::string& prefix,
                   std::int64_t steps) {
  using Kept = Parameters<float>::Kept;
  write(writer, group,
        AdamState{.first_moment = parameters.read(Kept::first_moment, prefix),
                  .second_moment = parameters.read(Kept::second_moment, prefix),
                  .steps = steps});
}

std::int64_t read_moments(const artefact::Reader& reader, const std::string& group,
                          Parameters<float>& parameters, const std::string& prefix) {
  using Kept = Parameters<float>::Kept;
  const std::size_t size = parameters.read(Kept::value, prefix).size();
  const AdamState state = read_adam_state(reader, group, size);
  parameters.write(Kept::first_moment, state.first_moment, prefix);
  parameters.write(Kept::second_moment, state.second_moment, prefix);
  return state.steps;
}

template class Parameters<float>;
template class Parameters<double>;

}  // namespace piae::nets
