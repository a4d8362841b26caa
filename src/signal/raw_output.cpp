#include "signal/raw_output.hpp"

#include <fcntl.h>
#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.hpp"
#include "base/write_all.hpp"

namespace piae::signal {

RawOutput::RawOutput(const std::filesystem::path& path)
    : path_(path),
      descriptor_(path == "-" ? STDOUT_FILENO
                              : ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666)) {
  if (descriptor_ < 0) fail();
}

RawOutput::~RawOutput() {
  if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
}

void RawOutput::write(std::span<const float> samples) const {
  if (!write_all(descriptor_, std::as_bytes(samples))) fail();
}

void RawOutput::close() {
  if (::close(std::exchange(descriptor_, -1)) != 0) fail();
}

void RawOutput::fail() const {
  throw Error(Exit::failed,
              fmt::format("{}: {}; choose another --output",
                          path_ == "-" ? "standard output" : path_.string(), std::strerror(errno)));
}

}  // namespace piae::signal
