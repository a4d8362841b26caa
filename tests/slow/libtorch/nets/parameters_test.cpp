#include "libtorch/nets/parameters.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "libtorch/nets/torch.hpp"
#include "nets/parameters.hpp"
#include "nets/stored_parameters.hpp"
#include "support/checkpoints.hpp"

namespace piae::libtorch {
namespace {

std::vector<nets::ParameterSpec> small_specs() {
  return {{"a/weight", {2, 3}, 0.5}, {"a/bias", {2}, 0.25}, {"b/scale", {4}, 0, 1}};
}

ParameterSet small_set(const std::string& stream = "test") {
  return {small_specs(), Stream(stream)};
}

TEST(ParameterSet, TensorsAreViewsOfTheFlatVector) {
  const ParameterSet set = small_set();
  const torch::NoGradGuard no_grad;
  EXPECT_EQ(set.values().numel(), 6 + 2 + 4);
  set.values().copy_(torch::arange(12));
  EXPECT_TRUE(
      torch::equal(set["a/weight"].detach(), torch::arange(6).view({2, 3}).to(torch::kFloat)));
  EXPECT_TRUE(torch::equal(set["a/bias"].detach(), torch::tensor({6.0F, 7.0F})));
  torch::Tensor scale = set["b/scale"];
  scale.fill_(-1);
  EXPECT_EQ(set.values()[8].item<float>(), -1);
  EXPECT_EQ(set.values("b/").data_ptr(), scale.data_ptr());
}

TEST(ParameterSet, InitialValuesKeepTheirBoundsAndConstants) {
  const ParameterSet set({{"wide", {1000}, 0.5}, {"ones", {5}, 0, 1}, {"zeros", {5}, 0, 0}},
                         Stream("test"));
  EXPECT_LE(set["wide"].abs().max().item<float>(), 0.5F);
  EXPECT_GT(set["wide"].abs().max().item<float>(), 0.49F);
  EXPECT_NEAR(set["wide"].mean().item<float>(), 0, 0.05);
  EXPECT_TRUE(torch::equal(set["ones"].detach(), torch::ones({5})));
  EXPECT_TRUE(torch::equal(set["zeros"].detach(), torch::zeros({5})));
}

TEST(ParameterSet, InitialValuesDependOnTheirNameOnly) {
  const ParameterSet set = small_set();
  const ParameterSet more({{"other", {100}, 1}, {"a/bias", {2}, 0.25}}, Stream("test"));
  EXPECT_TRUE(torch::equal(set["a/bias"], more["a/bias"]));
  EXPECT_FALSE(torch::equal(set["a/bias"], small_set("another")["a/bias"]));
}

TEST(ParameterSet, GradientsAddUpInTheFlatVector) {
  ParameterSet set = small_set();
  const auto backward = [&] {
    // d/dw of sum(w * x) is x; d/db of sum(3 b) is 3; b/scale does not affect either.
    const torch::Tensor x = torch::arange(6).view({2, 3}).to(torch::kFloat);
    ((set["a/weight"] * x).sum() + 3 * set["a/bias"].sum()).backward();
  };
  backward();
  const torch::Tensor once =
      torch::tensor({0., 1., 2., 3., 4., 5., 3., 3., 0., 0., 0., 0.}).to(torch::kFloat);
  EXPECT_TRUE(torch::equal(set.gradients(), once));
  backward();
  EXPECT_TRUE(torch::equal(set.gradients(), 2 * once));
  set.zero_gradients();
  EXPECT_TRUE(torch::equal(set.gradients(), torch::zeros({12})));
  EXPECT_TRUE(torch::equal(set["a/weight"].grad(), torch::zeros({2, 3})));
}

TEST(ParameterSet, PutsGivenGradientsInPlace) {
  ParameterSet set = small_set();
  set.set_gradients("a/", {torch::full({2, 3}, 2.0F), torch::full({2}, 5.0F)});
  EXPECT_TRUE(torch::equal(set.gradients("a/weight"), torch::full({6}, 2.0F)));
  EXPECT_TRUE(torch::equal(set.gradients("a/bias"), torch::full({2}, 5.0F)));
  EXPECT_TRUE(torch::equal(set.gradients("b/"), torch::zeros({4})));
}

TEST(ParameterSet, RefusesUnknownNamesAndScatteredPrefixes) {
  const ParameterSet set({{"a/x", {1}, 1}, {"b/x", {1}, 1}, {"a/y", {1}, 1}}, Stream("test"));
  EXPECT_THROW((void)set["c"], std::logic_error);
  EXPECT_THROW((void)set.values("c"), std::logic_error);
  EXPECT_THROW((void)set.values("a/"), std::logic_error);
  EXPECT_EQ(set.with_prefix("a/").size(), 2U);
}

TEST(ParameterSet, ReadsStoredParameters) {
  const auto path = scratch_file("parameters.h5");
  const ParameterSet written = small_set("one");
  artefact::Writer writer("model");
  nets::write_parameters(writer, "/model", small_specs(), to_vector(written.values()));
  writer.save(path, {});
  const artefact::Reader reader(path, "model");
  EXPECT_EQ(reader.numbers<float>("/model/a/weight", {2, 3}).values,
            to_vector(written["a/weight"]));

  ParameterSet read = small_set("two");
  ASSERT_FALSE(torch::equal(read.values(), written.values()));
  read.read(reader, "/model");
  EXPECT_TRUE(torch::equal(read.values(), written.values()));

  ParameterSet other_shape({{"a/weight", {3, 2}, 0.5}}, Stream("test"));
  EXPECT_THROW(other_shape.read(reader, "/model"), artefact::Refusal);
  ParameterSet other_name({{"c", {1}, 0.5}}, Stream("test"));
  EXPECT_THROW(other_name.read(reader, "/model"), artefact::Refusal);
}

TEST(ParameterSet, StartsWithTheValuesOfTheParametersForOneCore) {
  const std::vector<nets::ParameterSpec> specs = nets::dense_chain_specs("a", 21, 3, {2, 32});
  const ParameterSet set(specs, Stream("initial"));
  const nets::Parameters<float> flat(specs, Stream("initial"));
  EXPECT_EQ(to_vector(set.values()), flat.read(nets::Parameters<float>::Kept::value));
}

}  // namespace
}  // namespace piae::libtorch
