#include "run/layout.hpp"

#include "support/errors.hpp"
#include "support/stored_run.hpp"

namespace piae::run {
namespace {

class OldLayout : public StoredRun {
 protected:
  [[nodiscard]] Layout layout_now() const { return {folder_.path() / "run", dataset_}; }
  void expect_refused(const std::string& cell) const {
    folder_.write("run/cwru/" + cell, "");
    const std::string run = (folder_.path() / "run").string();
    EXPECT_ERROR(layout_now(), Exit::bad_input,
                 run + "/cwru: its cells are laid out as before 0.1.0 (" + cell +
                     "); pipeline/new_layout.sh " + run + " moves them");
    std::filesystem::remove(folder_.path() / "run/cwru" / cell);
    EXPECT_NO_THROW((void)layout_now());
  }
};

TEST_F(OldLayout, IsRefused) {
  add_all();
  expect_refused("seed1/vae/2to1/diagnosis.h5");
  expect_refused("seed0/sweep/batch-1/1to1/diagnosis.h5");
  expect_refused("seed0/sweep@vae/latent-2/1to1/diagnosis.h5");
  expect_refused("seed100/readings/base/10to1/diagnosis.h5");
}

TEST_F(OldLayout, HasDiagnosesInTheFolderOfARatio) {
  add_all();
  folder_.write("run/cwru/seed0/vae/2to1/diagnose.log", "");  // allowed: not a cell
  folder_.write("run/cwru/seed0/vae/diagnosis.h5", "");
  folder_.write("run/cwru/seed0/vae/best/diagnosis.h5", "");
  folder_.write("run/cwru/other/vae/2to1/diagnosis.h5", "");
  folder_.write("run/cwru/seed0/sweep/batch-1/1to1/wdcnn/diagnosis.h5", "");
  EXPECT_NO_THROW((void)layout_now());
}

}  // namespace
}  // namespace piae::run
