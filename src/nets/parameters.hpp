#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/random.hpp"
#include "nets/parameter_spec.hpp"

namespace piae::nets {

/// Parameters of dense networks with their moments in Adam. Each row of a weight [outputs, inputs],
/// and each bias, is padded with zeros to whole vectors; the padding stays zero. copy(), read() and
/// write() use float32 in the order of the specs, without the padding.
template <class T>
class Parameters {
 public:
  /// Initial values come from the stream, by initial_values(); moments are zero.
  Parameters(std::vector<ParameterSpec> specs, const Stream& stream);

  /// One parameter, and its position in each of the arrays of data().
  struct Parameter {
    ParameterSpec spec;
    std::int64_t begin;         ///< index of its first number
    std::int64_t rows;          ///< 1 for a bias
    std::int64_t columns;       ///< numbers in a row
    std::int64_t held_columns;  ///< distance from one row to the next
  };
  /// Throws std::logic_error if no parameter has that name.
  [[nodiscard]] const Parameter& find(const std::string& name) const;
  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }

  /// The three arrays: values of all parameters, and both moments of Adam.
  enum class Kept { value, first_moment, second_moment };
  [[nodiscard]] T* data(Kept kept) { return numbers(kept).data(); }
  [[nodiscard]] const T* data(Kept kept) const { return numbers(kept).data(); }

  /// Return the numbers of the parameters whose names begin with `prefix`, one parameter after
  /// another.
  void copy(Kept kept, std::span<float> to, const std::string& prefix = "") const;
  [[nodiscard]] std::vector<float> read(Kept kept, const std::string& prefix = "") const;
  /// Sets the numbers that read() returns for the same arguments.
  void write(Kept kept, std::span<const float> all, const std::string& prefix = "");

 private:
  using Numbers = Eigen::ArrayX<T>;  // starts at the boundary of a vector register
  Numbers& numbers(Kept kept) { return kept_[static_cast<std::size_t>(kept)]; }
  [[nodiscard]] const Numbers& numbers(Kept kept) const {
    return kept_[static_cast<std::size_t>(kept)];
  }

  std::vector<Parameter> parameters_;
  std::array<Numbers, 3> kept_;
};

/// Writes the moments of the parameters whose names begin with `prefix`, and Adam's step count, as
/// an AdamState (stored_parameters.hpp).
void write_moments(artefact::Writer& writer, const std::string& group,
                   const Parameters<float>& parameters, const std::string& prefix,
                   std::int64_t steps);
/// Reads these moments back; returns the number of steps.
std::int64_t read_moments(const artefact::Reader& reader, const std::string& group,
                          Parameters<float>& parameters, const std::string& prefix);

extern template class Parameters<float>;
extern template class Parameters<double>;

}  // namespace piae::nets
