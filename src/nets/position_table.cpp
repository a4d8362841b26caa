#include "nets/position_table.hpp"

#include <algorithm>
#include <stdexcept>

namespace piae::nets {

std::vector<ParameterSpec> position_table_specs(const std::string& name,
                                                const SequenceShape& shape) {
  return {{.name = name, .shape = {shape.length, shape.width}, .bound = 1}};
}

template <class T>
PositionTable<T>::PositionTable(GradientArray<T>& parameters, const std::string& name)
    : SequenceLayer<T>(
          {.length = parameters.find(name).rows, .width = parameters.find(name).columns},
          {.length = parameters.find(name).rows, .width = parameters.find(name).columns}),
      table_(parameters.find(name)) {
  if (table_.columns != table_.held_columns) {
    throw std::logic_error("the width of " + name + " does not fill whole rows");
  }
}

template <class T>
void PositionTable<T>::forward(std::int64_t windows, const T* x, T* y) {
  const std::int64_t size = this->input().size();
  as_matrix(y, windows, size) =
      as_matrix(x, windows, size).rowwise() + as_matrix(table_.values, 1, size).row(0);
}

template <class T>
void PositionTable<T>::backward(const SignalBatch& batch, const T*, const T* dy, T* dx) {
  const std::int64_t size = this->input().size();
  as_matrix(table_.gradient, 1, size) = as_matrix(dy, batch.windows, size).colwise().sum();
  if (dx != nullptr) std::copy_n(dy, batch.all() * size, dx);
}

template class PositionTable<float>;
template class PositionTable<double>;

}  // namespace piae::nets
