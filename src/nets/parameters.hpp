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

/// Parameters of dense networks with their moments of Adam: what ParameterSet and Adam are over
/// tensors. Rows of a weight [outputs, inputs], and biases, are filled up with zeros to whole
/// vectors; what fills them stays zero. Everything that is read or written whole is float32 in the
/// order of the specs, without the filling.
template <class T>
class Parameters {
 public:
  /// Initial values as those of ParameterSet.
  Parameters(std::vector<ParameterSpec> specs, const Stream& stream);

  /// A parameter, and where its values begin. Throws std::logic_error.
  struct Parameter {
    ParameterSpec spec;
    std::int64_t begin;
    std::int64_t rows;
    std::int64_t columns;
    std::int64_t held_columns;
  };
  [[nodiscard]] const Parameter& find(const std::string& name) const;
  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }

  /// What is kept of each parameter.
  enum class Kept { value, first_moment, second_moment };
  [[nodiscard]] T* data(Kept kept) { return numbers(kept).data(); }
  [[nodiscard]] const T* data(Kept kept) const { return numbers(kept).data(); }

  /// Of the parameters whose names begin with `prefix`.
  void copy(Kept kept, std::span<float> to, const std::string& prefix = "") const;
  [[nodiscard]] std::vector<float> read(Kept kept, const std::string& prefix = "") const;
  /// As many as read() gives.
  void write(Kept kept, std::span<const float> all, const std::string& prefix = "");

 private:
  using Numbers = Eigen::ArrayX<T>;  // on the boundary of vectors
  Numbers& numbers(Kept kept) { return kept_[static_cast<std::size_t>(kept)]; }
  [[nodiscard]] const Numbers& numbers(Kept kept) const {
    return kept_[static_cast<std::size_t>(kept)];
  }

  std::vector<Parameter> parameters_;
  std::array<Numbers, 3> kept_;
};

/// Moments of the parameters whose names begin with `prefix`, and Adam's steps, as nets::Adam
/// writes and reads them.
void write_moments(artefact::Writer& writer, const std::string& group,
                   const Parameters<float>& parameters, const std::string& prefix,
                   std::int64_t steps);
/// Returns the steps.
std::int64_t read_moments(const artefact::Reader& reader, const std::string& group,
                          Parameters<float>& parameters, const std::string& prefix);

extern template class Parameters<float>;
extern template class Parameters<double>;

}  // namespace piae::nets
