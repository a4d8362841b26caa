#include "monitor/samples.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "support/errors.hpp"

namespace piae::monitor {
namespace {

using Numbers = std::vector<double>;

template <class T>
std::string as_bytes_of(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

Numbers decoded(SampleFormat format, const std::string& bytes, std::size_t piece) {
  SampleDecoder decoder(format, "raw");
  Numbers samples;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    decoder.add(std::as_bytes(std::span(bytes).subspan(at, std::min(piece, bytes.size() - at))),
                samples);
  }
  decoder.finish(samples);
  return samples;
}

TEST(Samples, AreTheSameWhateverThePieces) {
  for (const std::size_t piece : {1, 2, 3, 5, 7, 8, 11, 1000}) {
    SCOPED_TRACE(piece);
    EXPECT_EQ(decoded(SampleFormat::f32, as_bytes_of<float>({1.5F, -2.25F, 3e10F}), piece),
              (Numbers{1.5, -2.25, 3e10F}));
    EXPECT_EQ(decoded(SampleFormat::f64, as_bytes_of<double>({0.1, -1e300}), piece),
              (Numbers{0.1, -1e300}));
    EXPECT_EQ(decoded(SampleFormat::i16, as_bytes_of<std::int16_t>({1, -32768, 32767}), piece),
              (Numbers{1, -32768, 32767}));
    EXPECT_EQ(decoded(SampleFormat::i32, as_bytes_of<std::int32_t>({7, -2147483647}), piece),
              (Numbers{7, -2147483647}));
    EXPECT_EQ(decoded(SampleFormat::text, "1.5\n\n -2e3\t\r\n7", piece), (Numbers{1.5, -2000, 7}));
  }
}

TEST(Samples, TellOfOneThatHasNotComeWhole) {
  SampleDecoder decoder(SampleFormat::f32, "raw");
  Numbers samples;
  const std::string bytes(7, '\0');
  decoder.add(std::as_bytes(std::span(bytes)), samples);
  EXPECT_EQ(samples.size(), 1U);
  EXPECT_EQ(decoder.waiting(), 3U);
  decoder.restart();
  EXPECT_EQ(decoder.waiting(), 0U);
}

TEST(Samples, ALineThatIsNoNumberIsNamed) {
  EXPECT_ERROR(decoded(SampleFormat::text, "1\n2\n3,4\n", 3), Exit::bad_input,
               "raw, line 3: '3,4' is not a number");
  EXPECT_ERROR(decoded(SampleFormat::text, "1\n" + std::string(200, '1'), 9), Exit::bad_input,
               "raw, line 2: has more than 100 characters");
}

}  // namespace
}  // namespace piae::monitor
