#include "nets/parameters.hpp"

#include <gtest/gtest.h>

#include "base/vector.hpp"
#include "nets/stored_parameters.hpp"
#include "support/checkpoints.hpp"

namespace piae::nets {
namespace {

using Flat = Parameters<float>;

/// Returns specs with widths that fill whole vectors and widths that do not.
std::vector<ParameterSpec> example_specs() {
  std::vector<ParameterSpec> specs = dense_chain_specs("a", 21, 3, {2, 32});
  specs.push_back({"b/weights", {3}});
  return specs;
}

TEST(Parameters, PadRowsWithZerosThatStay) {
  Flat flat(example_specs(), Stream("initial"));
  const auto& weight = flat.find("a/0/weight");
  EXPECT_EQ(weight.held_columns, whole_rows(21));
  std::vector<float> ones(flat.read(Flat::Kept::value).size(), 1.0F);
  flat.write(Flat::Kept::value, ones);
  for (std::int64_t row = 0; row < weight.rows; ++row) {
    const float* const begin =
        flat.data(Flat::Kept::value) + weight.begin + row * weight.held_columns;
    for (std::int64_t i = 0; i < weight.held_columns; ++i) {
      EXPECT_EQ(begin[i], i < weight.columns ? 1 : 0) << row << " " << i;
    }
  }
  EXPECT_EQ(flat.read(Flat::Kept::value), ones);
}

TEST(Parameters, MomentsAreStoredWithTheSteps) {
  Flat flat(example_specs(), Stream("initial"));
  std::vector<float> moments(flat.read(Flat::Kept::value, "a/").size());
  for (std::size_t i = 0; i < moments.size(); ++i) moments[i] = static_cast<float>(i);
  flat.write(Flat::Kept::second_moment, moments, "a/");
  artefact::Writer writer("model");
  write_moments(writer, "/adam", flat, "a/", 7);
  const std::filesystem::path path = scratch_file("moments.h5");
  writer.save(path, {});

  Parameters<float> other(example_specs(), Stream("initial"));
  EXPECT_EQ(read_moments(artefact::Reader(path, "model"), "/adam", other, "a/"), 7);
  EXPECT_EQ(other.read(Flat::Kept::second_moment, "a/"), moments);
  EXPECT_EQ(other.read(Flat::Kept::first_moment, "a/"), std::vector<float>(moments.size(), 0.0F));
  EXPECT_EQ(other.read(Flat::Kept::second_moment, "b/"), std::vector<float>(3, 0.0F));
}

TEST(StoredParameters, AreReadAsWrittenAndRefusedInAnotherShape) {
  const std::vector<ParameterSpec> specs = example_specs();
  const std::vector<float> values = Parameters<float>(specs, Stream("x")).read(Flat::Kept::value);
  artefact::Writer writer("model");
  write_parameters(writer, "/final", specs, values);
  const std::filesystem::path path = scratch_file("stored.h5");
  writer.save(path, {});
  const artefact::Reader reader(path, "model");
  EXPECT_EQ(read_parameters(reader, "/final", specs), values);
  EXPECT_THROW(read_parameters(reader, "/final", dense_chain_specs("a", 20, 3, {2, 32})),
               artefact::Refusal);
}

}  // namespace
}  // namespace piae::nets
