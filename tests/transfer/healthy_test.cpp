#include "transfer/healthy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/checkpoints.hpp"
#include "support/errors.hpp"
#include "transfer/carried.hpp"

namespace piae::transfer {
namespace {

/// Returns healthy windows with a tone: 2 kHz in the known condition, 3 kHz in the tested one.
signal::WindowSet humming() {
  signal::WindowSet healthy;
  healthy.info = one_machine().info;
  healthy.length = 1024;
  for (std::int32_t condition : {0, 1, 1}) {
    healthy.labels.push_back(0);
    healthy.condition.push_back(condition);
    const double hz = condition == 0 ? 2000 : 3000;
    for (int i = 0; i < 1024; ++i) {
      healthy.samples.push_back(
          static_cast<float>(std::sin(2 * std::numbers::pi * hz * i / 12000)));
    }
  }
  return healthy;
}

TEST(HealthySpectra, UseTheTestedConditionOnly) {
  const std::vector<HealthySpectrum> spectra = healthy_spectra(humming());
  ASSERT_EQ(spectra.size(), 1U);
  EXPECT_EQ(spectra[0].condition, 1);
  Eigen::Index top = 0;
  spectra[0].log_amplitude.maxCoeff(&top);
  EXPECT_EQ(top, 512);  // 3 kHz of 6 in 1025 bins
  EXPECT_NEAR(spectra[0].log_amplitude.mean(), 0, 1e-9);
}

TEST(HealthySpectra, AreReadAsWrittenAndRefusedIfImpossible) {
  const signal::WindowSet known = one_machine();
  const auto stored = [](const std::vector<HealthySpectrum>& spectra) {
    artefact::Writer writer("model");
    write(writer, spectra);
    const std::filesystem::path path = scratch_file("healthy.h5");
    writer.save(path, {});
    return artefact::Reader(path, "model");
  };
  std::vector<HealthySpectrum> spectra = healthy_spectra(humming());
  const std::vector<HealthySpectrum> read = read_healthy_spectra(stored(spectra), known);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].condition, 1);
  EXPECT_TRUE((read[0].log_amplitude == spectra[0].log_amplitude).all());
  EXPECT_ERROR(read_healthy_spectra(stored({spectra[0], spectra[0]}), known), Exit::bad_input,
               "names a condition twice");
  spectra[0].condition = 0;
  EXPECT_ERROR(read_healthy_spectra(stored(spectra), known), Exit::bad_input, "is not tested");
  spectra[0] = {.condition = 1, .log_amplitude = Eigen::ArrayXd::Zero(1000)};
  EXPECT_ERROR(read_healthy_spectra(stored(spectra), known), Exit::bad_input, "log_amplitude");
}

}  // namespace
}  // namespace piae::transfer
