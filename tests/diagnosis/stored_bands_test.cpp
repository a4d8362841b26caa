#include "diagnosis/stored_bands.hpp"

#include <gtest/gtest.h>

#include "diagnosis/stored.hpp"
#include "support/errors.hpp"
#include "support/three_classes.hpp"

namespace piae::diagnosis {
namespace {

class StoredBands : public testing::Test {
 protected:
  StoredBands() {
    for (Eigen::Index i = 0; i < bands_.size(); ++i)
      bands_.data()[i] = 0.1 * static_cast<double>(i);
  }
  [[nodiscard]] artefact::Reader with_labels(const std::vector<Label>& labels) const {
    artefact::Writer writer("bands");
    writer.numbers("/some/labels", labels);
    return stored(writer, folder_);
  }

  const Folder folder_;
  BandPowers bands_{2, number_of_bands};
};

TEST_F(StoredBands, ComeBackAsTheyWere) {
  artefact::Writer writer("bands");
  write_bands(writer, "/some", bands_, {2, 0});
  const artefact::Reader reader = stored(writer, folder_);
  EXPECT_EQ(read_labels(reader, "/some", three_classes()), (std::vector<Label>{2, 0}));
  EXPECT_EQ(read_bands(reader, "/some", 2), bands_);
  EXPECT_ERROR(read_bands(reader, "/some", 3), Exit::bad_input, "/some/bands");
}

TEST_F(StoredBands, HaveALabelOfAClassEach) {
  for (const Label none : {-1, 3}) {
    EXPECT_ERROR(read_labels(with_labels({0, none}), "/some", three_classes()), Exit::bad_input,
                 "/some/labels has a label that no class has");
  }
  EXPECT_ERROR(read_labels(with_labels({}), "/some", three_classes()), Exit::bad_input,
               "/some/labels is empty");
}

}  // namespace
}  // namespace piae::diagnosis
