#include "raw/npy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::raw {
namespace {

using testing::ElementsAre;

/// Returns a file of version 1.0 of numpy.lib.format.
template <class T>
std::string npy(const std::string& type, const std::string& order, const std::string& shape,
                const std::vector<T>& values) {
  std::string header =
      "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
  header.resize((10 + header.size() + 64) / 64 * 64 - 11, ' ');
  header += '\n';
  std::string bytes = "\x93NUMPY" + std::string("\x01\x00", 2);
  bytes += static_cast<char>(header.size() & 0xFF);
  bytes += static_cast<char>(header.size() >> 8);
  bytes += header;
  const std::size_t begin = bytes.size();
  bytes.resize(begin + values.size() * sizeof(T));
  std::memcpy(bytes.data() + begin, values.data(), values.size() * sizeof(T));
  return bytes;
}

TEST(Npy, HoldsAVectorOfAnyNumberType) {
  const Folder folder;
  const auto of = [&](const std::string& bytes) {
    return read_here(folder.write("a.npy", bytes), "1");
  };
  EXPECT_THAT(of(npy<double>("<f8", "False", "(3,)", {1.5, -2, 3e-9})), ElementsAre(1.5, -2, 3e-9));
  EXPECT_THAT(of(npy<float>("<f4", "False", "(2, 1)", {0.5F, 1})), ElementsAre(0.5, 1));
  EXPECT_THAT(of(npy<std::int16_t>("<i2", "False", "(2,)", {-32768, 7})), ElementsAre(-32768, 7));
  EXPECT_THAT(of(npy<std::uint8_t>("|u1", "False", "(2,)", {0, 255})), ElementsAre(0, 255));
  EXPECT_THAT(of(npy<std::uint16_t>(">i2", "False", "(2,)", {0x0100, 0xFEFF})), ElementsAre(1, -2));
  // 1, -2, the smallest positive and the largest 16-bit number (IEEE 754)
  EXPECT_THAT(of(npy<std::uint16_t>("<f2", "False", "(4,)", {0x3C00, 0xC000, 0x0001, 0x7BFF})),
              ElementsAre(1, -2, 5.9604644775390625e-08, 65504));
}

TEST(Npy, HoldsRowsAndColumns) {
  const Folder folder;
  const std::vector<float> six{1, 2, 3, 4, 5, 6};
  const auto rows = folder.write("a.npy", npy<float>("<f4", "False", "(2, 3)", six));
  EXPECT_THAT(read_here(rows, "(2,:)"), ElementsAre(4, 5, 6));
  EXPECT_THAT(read_here(rows, "(:,1)"), ElementsAre(1, 4));
  const auto columns = folder.write("b.npy", npy<float>("<f4", "True", "(2, 3)", six));
  EXPECT_THAT(read_here(columns, "(2,:)"), ElementsAre(2, 4, 6));
  EXPECT_ERROR(read_here(rows, "1"), Exit::bad_input,
               "is not a vector, but a matrix of 2 x 3; name a row of it: (1,:)");
  const auto cube = folder.write("c.npy", npy<float>("<f4", "False", "(3, 1, 2)", six));
  EXPECT_ERROR(
      read_here(cube, "1"), Exit::bad_input,
      "is not a vector, but an array of 3 x 1 x 2; save the samples as a vector or matrix");
  EXPECT_ERROR(read_here(rows, "(3,:)"), Exit::bad_input, "has 2 rows; number 3 does not exist");
  EXPECT_ERROR(read_here(rows, "x"), Exit::bad_input, "a.npy: has no variable x");
}

TEST(Npy, IsRefusedIfDamagedOrWithoutNumbers) {
  const Folder folder;
  const auto expect_refused = [&](const std::string& bytes, const std::string& why) {
    EXPECT_ERROR(read_here(folder.write("a.npy", bytes), "1"), Exit::bad_input, why);
  };
  expect_refused(npy<double>("<c16", "False", "(1,)", {1, 2}),
                 "holds complex numbers (NumPy type 'c16'), which is not supported; save its real "
                 "part: np.save(");
  expect_refused(npy<double>("|O", "False", "(1,)", {1}), "holds Python objects (NumPy type 'O')");
  const std::string whole = npy<double>("<f8", "False", "(3,)", {1, 2, 3});
  expect_refused(whole.substr(0, whole.size() - 1),
                 "truncated or damaged: 23 bytes of values, 24 expected");
  expect_refused(whole + "x", "truncated or damaged");
  for (const std::size_t size : {6, 9, 11, 60})
    expect_refused(whole.substr(0, size), "its header cannot be read");
  expect_refused(npy<double>("<f8", "False", "(99999999999,)", {1}), "declares 99999999999 values");
}

}  // namespace
}  // namespace piae::raw
