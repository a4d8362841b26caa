#include "twin/outcome.hpp"

#include <gtest/gtest.h>

#include "artefact/writer.hpp"
#include "support/checkpoints.hpp"

namespace piae::twin {
namespace {

using Column = std::vector<double> Curves::*;

Curves two_epochs() {
  Curves curves;
  for (const Column column :
       {&Curves::reconstruction, &Curves::differential, &Curves::twin, &Curves::total,
        &Curves::alpha, &Curves::beta, &Curves::gamma, &Curves::learning_rate}) {
    curves.*column = {1, 2};
  }
  return curves;
}

bool is_refused(const Curves& curves) {
  artefact::Writer writer("model");
  curves.write(writer);
  const auto file = scratch_file("outcome.h5");
  writer.save(file, {});
  try {
    read_outcome(artefact::Reader(file, "model"));
  } catch (const artefact::Refusal& refusal) {
    const std::string line = refusal.what();
    return line.find("has no epoch") != std::string::npos ||
           line.find("is not as long as") != std::string::npos;
  }
  return false;
}

TEST(Outcome, IsRefusedIfALossOrWeightLacksAnEpoch) {
  for (const Column column : {&Curves::reconstruction, &Curves::differential, &Curves::twin,
                              &Curves::alpha, &Curves::beta, &Curves::gamma}) {
    Curves curves = two_epochs();
    (curves.*column).pop_back();
    EXPECT_TRUE(is_refused(curves));
  }
  EXPECT_TRUE(is_refused(Curves()));
  EXPECT_FALSE(is_refused(two_epochs()));  // only its space is missing
}

}  // namespace
}  // namespace piae::twin
