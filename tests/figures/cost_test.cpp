#include "figures/cost.hpp"

#include "figures/stored_source.hpp"
#include "support/errors.hpp"

namespace piae::figures {
namespace {

class Cost : public StoredSource {
 protected:
  /// Adds none (50 %), smote (60 %), shift (90 %), piae-dt (40 %), vae (90 %) and oracle.
  void add_run() const {
    add(diagnosis("none", "100to1", 0, 0, 10));
    add(diagnosis("smote", "10to1", 45, 0, 12));
    add(diagnosis("shift", "10to1", 45, 0, 18));
    add(diagnosis("piae-dt", "10to1", 45, 0, 8));
    add(diagnosis("vae", "10to1", 45, 0, 18));
    add(diagnosis("oracle", "10to1", 45, 0, 20));
  }
  [[nodiscard]] Numbers numbers_of(const std::vector<run::StepCost>& costs) const {
    Source all(layout_, grid("none smote shift piae-dt vae oracle", "100to1 10to1", "0"), {}, {},
               costs);
    return costs_of_accuracy(all, all.accuracies().front());
  }
  [[nodiscard]] std::vector<run::StepCost> costs() const {
    std::vector<run::StepCost> all;
    const auto method = [&](const std::string& name, double train_s, double generate_s) {
      all.push_back({.stage = "train", .dataset = dataset_, .method = name, .seconds = train_s});
      all.push_back(
          {.stage = "generate", .dataset = dataset_, .method = name, .seconds = generate_s});
    };
    method("vae", 7, 1);
    method("shift", 1, 1);
    method("smote", 0.25, 0.25);
    method("piae-dt", 3, 1);
    method("oracle", 1, 1);
    return all;
  }
};

TEST_F(Cost, ShowsTheCheapestFirstWithItsSecondsForAPoint) {
  add_run();
  const std::string csv = numbers_of(costs()).csv();
  EXPECT_EQ(csv,
            "method,group,front,ratio,generator_s,accuracy,low,high,gain,s_per_point\n"
            "smote,paper,1,10to1,0.5,60,,,10,0.05\n"
            "shift,control,1,10to1,2,90,,,40,0.05\n"
            "piae-dt,paper,0,10to1,4,40,,,-10,\n"
            "vae,paper,0,10to1,8,90,,,40,0.2\n");
}

TEST_F(Cost, IsLeftOutWithoutCosts) {
  add_run();
  EXPECT_ERROR(numbers_of({}), Exit::input_missing, "no method of the run has a cost");
}

}  // namespace
}  // namespace piae::figures
