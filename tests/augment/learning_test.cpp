// Trained generators approach the known windows.

#include <limits>

#include "augment/methods.hpp"

namespace piae::augment {
namespace {

double squared_distance(std::span<const float> known, std::span<const float> generated) {
  double sum = 0;
  for (std::size_t t = 0; t < known.size(); ++t) {
    const double offset = 0.5;  // of known_windows(); generators omit it
    const double difference = known[t] - offset - generated[t];
    sum += difference * difference;
  }
  return sum;
}

/// Returns the mean over generated windows of the squared distance to the nearest known window of
/// the class.
double distance_to_known(const std::string& method, const std::string& options) {
  const signal::WindowSet known = known_windows();
  const auto model = train(method, options, known, checkpoint_at("checkpoint"), "model.h5");
  const signal::WindowSet generated = generate(method, model, 20);
  double sum = 0;
  for (std::size_t i = 0; i < generated.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::size_t k : known.indices_of(generated.labels[i])) {
      nearest = std::min(nearest, squared_distance(known.window(k), generated.window(i)));
    }
    sum += nearest / static_cast<double>(generated.size());
  }
  return sum;
}

TEST(Vae, ApproachesTheKnownWindows) {
  const std::string options = "--width 32 --latent 4 --learning-rate 2e-3 --epochs ";
  EXPECT_LT(distance_to_known("vae", options + "150"),
            0.5 * distance_to_known("vae", options + "1"));
}

TEST(WganGp, ApproachesTheKnownWindows) {
  const std::string options = "--width 32 --latent 4 --batch 10 --learning-rate 2e-3 --epochs ";
  EXPECT_LT(distance_to_known("wgan-gp", options + "1200"),
            0.5 * distance_to_known("wgan-gp", options + "1"));
}

}  // namespace
}  // namespace piae::augment
