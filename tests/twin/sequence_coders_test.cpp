// Tests coders that are chains of sequence layers; the slow tests compare their results with
// LibTorch.

#include <gtest/gtest.h>

#include "nets/row_array.hpp"
#include "support/errors.hpp"
#include "twin/coder.hpp"

namespace piae::twin {
namespace {

using Numbers = nets::RowArray<float>;

Numbers random_rows(const std::string& name, std::int64_t rows, std::int64_t columns) {
  Stream stream(name);
  Numbers numbers(rows, columns);
  for (float& x : numbers.reshaped()) x = static_cast<float>(stream.normal(0, 1));
  return numbers;
}

class SequenceCoders : public testing::TestWithParam<CoderKind> {};

/// The first generated windows must not depend on the number requested. The frames of the longer
/// windows do not fill the vectors of any processor.
TEST_P(SequenceCoders, TreatEachWindowIndependently) {
  for (const std::int64_t samples : {96, 544}) {
    SCOPED_TRACE(samples);
    const auto coder = make_coder(GetParam(), {.samples = samples, .classes = 3}, TwinOptions{});
    const auto parameters = std::make_shared<Coder::Parameters>(coder->specs(), Stream("initial"));
    const auto expect_the_same = [](Coder::Network& network, const Numbers& all,
                                    std::int64_t outputs) {
      nets::put(all, network.input());
      const Numbers together = nets::copied(network.forward(all.rows()), all.rows(), outputs);
      for (const std::int64_t rows : {1, 2, 3, 7}) {
        nets::put(Numbers(all.bottomRows(rows)), network.input());
        const Numbers some = nets::copied(network.forward(rows), rows, outputs);
        EXPECT_TRUE((some == together.bottomRows(rows)).all()) << rows;
      }
    };
    expect_the_same(*coder->encoder(parameters, 9), random_rows("windows", 9, samples), 2);
    expect_the_same(*coder->decoder(parameters, 9), random_rows("states", 9, 2 + 3), samples);
  }
}

INSTANTIATE_TEST_SUITE_P(Twin, SequenceCoders,
                         testing::Values(CoderKind::convolutional, CoderKind::recurrent,
                                         CoderKind::temporal, CoderKind::transformer));

TEST(TransformerCoder, RefusesWindowsThatAreTooLongForAttention) {
  EXPECT_NO_THROW(make_coder(CoderKind::transformer, {.samples = 32768, .classes = 3}, {}));
  EXPECT_ERROR(make_coder(CoderKind::transformer, {.samples = 65536, .classes = 3}, {}),
               Exit::usage, "windows of 65536 samples are too long for attention");
}

}  // namespace
}  // namespace piae::twin
