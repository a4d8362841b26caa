#include <gmock/gmock.h>

#include "augment/inference_cases.hpp"

namespace piae::augment {
namespace {

INSTANTIATE_TEST_SUITE_P(Methods, Inferring,
                         testing::Values("piae-dt", "ae", "piae-dt-cnn", "piae-dt-rnn",
                                         "piae-dt-tcn", "piae-dt-transformer", "piae-dt-phase"),
                         test_name);

TEST(Inferring, IsNotForMethodsWithoutAnEncoder) {
  const signal::WindowSet known = simulated_windows(2, "known");
  artefact::Writer writer("model");
  writer.attribute("/", "method", std::string("smote"));
  writer.save(scratch_file("model.h5"), {});
  const artefact::Reader reader(scratch_file("model.h5"), "model");
  EXPECT_THAT([&] { (void)make_method("smote")->infer(reader, known, {}); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("infers neither")));
}

}  // namespace
}  // namespace piae::augment
