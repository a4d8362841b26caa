#include "twin/coder.hpp"

#include <stdexcept>

#include "twin/convolutional_coder.hpp"
#include "twin/dense_coder.hpp"
#include "twin/recurrent_coder.hpp"
#include "twin/temporal_coder.hpp"
#include "twin/transformer_coder.hpp"

namespace piae::twin {

std::unique_ptr<Coder> make_coder(CoderKind kind, const NetworkShape& shape,
                                  const TwinOptions& options) {
  switch (kind) {
    case CoderKind::dense:
      return std::make_unique<DenseCoder>(shape, options);
    case CoderKind::temporal:
      return std::make_unique<TemporalCoder>(shape, options);
    case CoderKind::transformer:
      return std::make_unique<TransformerCoder>(shape, options);
    case CoderKind::convolutional:
      return std::make_unique<ConvolutionalCoder>(shape, options);
    case CoderKind::recurrent:
      return std::make_unique<RecurrentCoder>(shape, options);
  }
  throw std::logic_error("unknown coder");
}

}  // namespace piae::twin
