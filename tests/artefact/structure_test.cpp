#include "artefact/structure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "stages/doctor.hpp"
#include "support/folder.hpp"

/// Tests of HDF5 files that no stage writes, but with correct digests.
namespace piae::artefact {
namespace {

using hdf5::check;
using hdf5::Handle;
using testing::HasSubstr;

class Structure : public testing::Test {
 protected:
  Structure() {
    Writer writer("example");
    writer.numbers("/values", std::vector<double>{1, 2, 3});
    writer.numbers("/group/labels", std::vector<std::int32_t>{0, 1, 2});
    writer.attribute("/", "seed", std::int64_t{3});
    writer.save(file_, {"tester", "", {}});
  }

  void expect_refused(const std::function<void(hid_t)>& change, const std::string& what) const {
    stages::doctor(file_, change);
    try {
      const Reader reader(file_, "");
      ADD_FAILURE() << "was not refused";
    } catch (const Refusal& refusal) {
      EXPECT_EQ(refusal.exit(), Exit::bad_input);
      EXPECT_THAT(refusal.what(), HasSubstr(file_.string()));
      EXPECT_THAT(refusal.what(), HasSubstr(what));
    }
  }

  Folder folder_;
  std::filesystem::path file_ = folder_ / "a.h5";
};

/// Replaces an attribute's single value by an array.
void make_array(hid_t file, const std::string& name, hid_t type, std::size_t count) {
  if (H5Aexists(file, name.c_str()) > 0) check(H5Adelete(file, name.c_str()), name.c_str());
  const hsize_t extent = count;
  const Handle space(H5Screate_simple(1, &extent, nullptr), "space");
  const Handle attribute(H5Acreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         "attribute");
  const std::vector<char> values(count * H5Tget_size(type), 'x');
  check(H5Awrite(attribute, type, values.data()), "values");
}

void make_dataset(hid_t file, const std::string& path, hid_t type, hsize_t count, hid_t creation) {
  const Handle space(H5Screate_simple(1, &count, nullptr), "space");
  const Handle dataset(
      H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), "dataset");
}

TEST_F(Structure, AcceptsFilesOfStages) {
  stages::doctor(file_, [](hid_t) {});
  EXPECT_EQ(Reader(file_, "example").integer("/", "seed"), 3);
}

/// Attributes beyond the eighth go to a heap, which has a list of its free space.
TEST_F(Structure, RefusesDamageInAnUnusedBlock) {
  Writer writer("example");
  writer.numbers("/values", std::vector<double>{1, 2, 3});
  for (int i = 0; i < 12; ++i) writer.attribute("/", "a" + std::to_string(i), std::int64_t{i});
  writer.save(file_, {"tester", "", {}});
  const std::string good = bytes_of(file_);
  for (const char* block : {"FSHD", "FRHP", "FHDB", "BTHD", "BTLF"}) {
    std::string damaged = good;
    const std::size_t at = damaged.find(block);
    ASSERT_NE(at, std::string::npos) << block;
    damaged[at + 8] ^= 1;
    folder_.write("a.h5", damaged);
    EXPECT_THROW(Reader(file_, ""), Refusal) << block;
  }
}

TEST_F(Structure, RefusesArraysAsAttributes) {
  expect_refused([](hid_t file) { make_array(file, "seed", H5T_STD_I64LE, 7000); },
                 "an array of values at /, attribute seed");
}

TEST_F(Structure, RefusesAnArrayOfKinds) {
  const Handle foreign(H5Fcreate(file_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), "create");
  const Handle type(H5Tcopy(H5T_C_S1), "type");
  check(H5Tset_size(type, 7), "type");
  make_array(foreign, "kind", type, 8000);
  check(H5Fflush(foreign, H5F_SCOPE_GLOBAL), "flush");
  try {
    const Reader reader(file_, "windows");
    ADD_FAILURE() << "was not refused";
  } catch (const Refusal& refusal) {
    EXPECT_EQ(refusal.reason(), RefusalReason::wrong_kind);
  }
}

TEST_F(Structure, RefusesSoftLinks) {
  expect_refused(
      [](hid_t file) {
        check(H5Lcreate_soft("/values", file, "soft", H5P_DEFAULT, H5P_DEFAULT), "link");
      },
      "a soft link at /soft");
}

TEST_F(Structure, RefusesLinksToOtherFiles) {
  expect_refused(
      [](hid_t file) {
        check(H5Lcreate_external("b.h5", "/x", file, "out", H5P_DEFAULT, H5P_DEFAULT), "link");
      },
      "a link to another file at /out");
}

TEST_F(Structure, RefusesSecondLinks) {
  expect_refused(
      [](hid_t file) {
        check(H5Lcreate_hard(file, "/values", file, "/group/again", H5P_DEFAULT, H5P_DEFAULT),
              "link");
      },
      "a second link to one object");
}

TEST_F(Structure, RefusesCycles) {
  expect_refused(
      [](hid_t file) {
        check(H5Lcreate_hard(file, "/", file, "/group/root", H5P_DEFAULT, H5P_DEFAULT), "link");
      },
      "a second link to one object");
}

TEST_F(Structure, RefusesNamesWithLineBreaks) {
  expect_refused([](hid_t file) { hdf5::make_group(file, "/two\nlines"); },
                 "a name that no file should have");
}

TEST_F(Structure, RefusesDatasetsLargerThanTheFile) {
  expect_refused(
      [](hid_t file) {
        const Handle creation(H5Pcreate(H5P_DATASET_CREATE), "creation");
        make_dataset(file, "/huge", H5T_IEEE_F64LE, 4096, creation);
      },
      "/huge claims more bytes than the file has");
}

TEST_F(Structure, RefusesExtentsWhoseProductOverflows) {
  const Handle open(H5Fopen(file_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "open");
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), "creation");
  const hsize_t one = 1;
  check(H5Pset_chunk(creation, 1, &one), "chunk");
  make_dataset(open, "/huge", H5T_IEEE_F64LE, hsize_t{1} << 61U, creation);
  EXPECT_THROW(require_our_structure(open, 1 << 20), std::runtime_error);
}

TEST_F(Structure, RefusesCompressedDatasets) {
  expect_refused(
      [](hid_t file) {
        const Handle creation(H5Pcreate(H5P_DATASET_CREATE), "creation");
        const hsize_t all = 16;
        check(H5Pset_chunk(creation, 1, &all), "chunk");
        check(H5Pset_shuffle(creation), "filter");
        make_dataset(file, "/small", H5T_IEEE_F64LE, all, creation);
      },
      "compressed or filtered");
}

TEST_F(Structure, RefusesDatasetsInOtherFiles) {
  expect_refused(
      [this](hid_t file) {
        const Handle creation(H5Pcreate(H5P_DATASET_CREATE), "creation");
        const std::string raw = folder_.write("raw.bin", std::string(80, '\0'));
        check(H5Pset_external(creation, raw.c_str(), 0, 80), "external");
        make_dataset(file, "/elsewhere", H5T_IEEE_F64LE, 10, creation);
      },
      "kept in other files");
}

TEST_F(Structure, RefusesOtherTypes) {
  expect_refused([](hid_t file) { make_dataset(file, "/big", H5T_IEEE_F64BE, 2, H5P_DEFAULT); },
                 "values of this type at /big");
}

}  // namespace
}  // namespace piae::artefact
