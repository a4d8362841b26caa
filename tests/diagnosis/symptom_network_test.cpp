#include "diagnosis/symptom_network.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/stored.hpp"
#include "support/errors.hpp"

namespace piae::diagnosis {
namespace {

/// Points whose class depends on whether the first two numbers have the same sign. No line
/// separates these classes, so the hidden layer must learn, too.
struct Quadrants {
  Quadrants(const std::string& name, Eigen::Index count) : rows(count, 17) {
    Stream stream(name);
    for (Eigen::Index i = 0; i < count; ++i) {
      for (double& x : rows.row(i)) x = stream.normal(0, 0.1);
      for (const Eigen::Index j : {0, 1}) rows(i, j) += stream.uniform(0, 1) < 0.5 ? -1 : 1;
      labels.push_back(rows(i, 0) * rows(i, 1) > 0 ? 1 : 2);
    }
  }
  SymptomRows rows;
  std::vector<Label> labels;
};

TEST(SymptomNetwork, LearnsWhatALinearOneCannot) {
  const Quadrants training("training", 64);
  const Quadrants test("test", 64);
  SymptomNetwork network(3, 64, Stream("initial"));
  Stream dropped("dropped");
  for (int step = 0; step < 300; ++step) {
    (void)network.step(training.rows, training.labels, 1e-2, dropped);
  }
  const SymptomNetwork::Outputs outputs = network.outputs(test.rows);
  for (Eigen::Index i = 0; i < 64; ++i) {
    Eigen::Index named = 0;
    outputs.logits.row(i).maxCoeff(&named);
    EXPECT_EQ(named, test.labels[static_cast<std::size_t>(i)]) << i;
  }
}

TEST(SymptomNetwork, ReportsTheLossOfABatchBeforeItsStep) {
  const Quadrants batch("batch", 16);
  SymptomNetwork network(2, 16, Stream("initial"));
  Stream dropped("dropped");
  std::vector<Label> labels(16, 0);
  // Nearly the uniform distribution's ln 2, as the initial weights are small.
  EXPECT_NEAR(network.step(batch.rows, labels, 1e-3, dropped).loss / 16, std::log(2), 0.3);
}

TEST(SymptomNetwork, PredictsWithReluAndWithoutDropout) {
  const Quadrants batch("batch", 16);
  SymptomNetwork network(2, 16, Stream("initial"));
  const SymptomNetwork::Outputs once = network.outputs(batch.rows);
  EXPECT_EQ(once.hidden.cols(), 48);
  EXPECT_GE(once.hidden.minCoeff(), 0);
  EXPECT_GT(once.hidden.maxCoeff(), 0);
  EXPECT_TRUE((network.outputs(batch.rows).logits == once.logits).all());
}

TEST(SymptomNetwork, IsStoredInSinglePrecision) {
  const Folder folder;
  const Quadrants batch("batch", 16);
  SymptomNetwork network(3, 16, Stream("initial"));
  SymptomNetwork other(3, 16, Stream("other"));
  EXPECT_FALSE(other.outputs(batch.rows).logits.isApprox(network.outputs(batch.rows).logits, 0.1));
  artefact::Writer writer("network");
  network.write(writer, "/net");
  const artefact::Reader reader = stored(writer, folder);
  other.read(reader, "/net");
  const Eigen::ArrayXXd difference =
      other.outputs(batch.rows).logits - network.outputs(batch.rows).logits;
  EXPECT_LT(difference.abs().maxCoeff(), 1e-6);
  SymptomNetwork of_four(4, 16, Stream("initial"));
  EXPECT_ERROR(of_four.read(reader, "/net"), Exit::bad_input, "/net/classes/0/weight");
}

}  // namespace
}  // namespace piae::diagnosis
