#include <fcntl.h>
#include <poll.h>
#include <spdlog/fmt/fmt.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <span>
#include <string_view>
#include <system_error>

#include "base/error.hpp"
#include "base/write_all.hpp"
#include "raw/file.hpp"
#include "raw/limits.hpp"

namespace piae::raw {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int cannot_be_run = 127;

/// Both ends of a pipe; closes them.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) {
      throw Error(Exit::failed, "cannot make a pipe: " + std::generic_category().message(errno));
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close(0);
    close(1);
  }

  [[nodiscard]] int to_read() const { return ends_[0]; }
  [[nodiscard]] int to_write() const { return ends_[1]; }
  void close_writing() { close(1); }

 private:
  void close(std::size_t end) {
    if (ends_.at(end) >= 0) ::close(ends_.at(end));
    ends_.at(end) = -1;
  }

  std::array<int, 2> ends_{-1, -1};
};

/// Gives an open file this number in the program to be started; returns false on failure. Keeps a
/// file open that already has the number, because this process may have started with the number
/// closed.
bool is_put(int file, int number) {
  return file == number ? ::fcntl(file, F_SETFD, 0) == 0 : ::dup2(file, number) >= 0;
}

/// One output of read_raw.
class Output {
 public:
  Pipe pipe;
  bool ended = false;

  /// Returns the next bytes, at most a buffer; they are valid until the next call.
  std::span<const std::byte> take() {
    const ssize_t got = ::read(pipe.to_read(), buffer_.data(), buffer_.size());
    if (got < 0 && errno == EINTR) return {};
    ended = got <= 0;
    return std::span(buffer_).first(ended ? 0 : static_cast<std::size_t>(got));
  }

 private:
  std::array<std::byte, 1 << 16> buffer_{};
};

/// Splits the output of read_raw: for each file a Piece, then its samples.
class Incoming {
 public:
  Incoming(std::size_t files, std::uint64_t most_samples)
      : files_(files), most_samples_(most_samples) {}

  void add(std::span<const std::byte> bytes) {
    while (!bytes.empty() && !is_broken_) {
      if (left_ == 0) {
        head_ += take(bytes, sizeof(Piece) - head_.size());
        if (head_.size() == sizeof(Piece)) begin_piece();
        continue;
      }
      const std::span to = std::as_writable_bytes(std::span(all_.samples)).last(left_);
      const std::string_view some = take(bytes, left_);
      std::memcpy(to.data(), some.data(), some.size());
      left_ -= some.size();
    }
  }
  /// Returns the number of complete files.
  [[nodiscard]] std::size_t whole() const { return all_.pieces.size() - (left_ > 0 ? 1 : 0); }
  [[nodiscard]] Signals take_all() { return std::move(all_); }

 private:
  static std::string_view take(std::span<const std::byte>& bytes, std::size_t most) {
    const auto some = bytes.first(std::min(most, bytes.size()));
    bytes = bytes.subspan(some.size());
    return {reinterpret_cast<const char*>(some.data()), some.size()};
  }
  void begin_piece() {
    Piece piece;
    std::memcpy(&piece, head_.data(), sizeof piece);
    head_.clear();
    const std::size_t before = all_.samples.size();
    is_broken_ = piece.samples > most_samples_ - before || all_.pieces.size() == files_;
    if (is_broken_) return;
    all_.pieces.push_back(piece);
    make_room(before + piece.samples);
    all_.samples.resize(before + piece.samples);
    left_ = piece.samples * sizeof(double);
  }
  /// Reserves memory for all files from the mean of the files so far. Without this, growth would
  /// briefly take twice the memory of the samples.
  void make_room(std::size_t samples) {
    if (samples <= all_.samples.capacity()) return;
    const double each = static_cast<double>(samples) / static_cast<double>(all_.pieces.size());
    const double alike = 1.01 * each * static_cast<double>(files_);
    const auto most = static_cast<double>(most_samples_);
    all_.samples.reserve(std::max(samples, static_cast<std::size_t>(std::min(alike, most))));
  }

  std::size_t files_;
  std::uint64_t most_samples_;
  Signals all_;
  std::string head_;      ///< received part of the next Piece
  std::size_t left_ = 0;  ///< missing bytes of the last piece
  bool is_broken_ = false;
};

/// A file in memory with names, each ended by a zero byte, positioned at its start.
class Names {
 public:
  explicit Names(const std::vector<fs::path>& names)
      : descriptor_(::memfd_create("names", MFD_CLOEXEC)) {
    std::string text;
    for (const fs::path& name : names) text += name.string() + '\0';
    const auto bytes = std::as_bytes(std::span(text));
    if (descriptor_ < 0 || !write_all(descriptor_, bytes) ||
        ::lseek(descriptor_, 0, SEEK_SET) < 0) {
      throw Error(Exit::failed, "cannot hand the names of files to read_raw: " +
                                    std::generic_category().message(errno));
    }
  }
  Names(const Names&) = delete;
  Names& operator=(const Names&) = delete;
  ~Names() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  [[nodiscard]] int to_read() const { return descriptor_; }

 private:
  int descriptor_;
};

/// One run of read_raw. The destructor kills it if it still runs.
class Reader {
 public:
  Reader(const std::vector<fs::path>& files, const std::string& variable,
         std::optional<double> sample_rate_hz, const Limits& limits)
      : files_(files),
        limits_(limits),
        names_(files),
        incoming_(files.size(), limits.most_samples) {
    program_ = (fs::read_symlink("/proc/self/exe").parent_path() / "read_raw").string();
    std::vector<std::string> words{program_, "--list=/dev/stdin", "--variable=" + variable};
    if (sample_rate_hz) words.push_back(fmt::format("--sample-rate={}", *sample_rate_hz));
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const pid_t parent = ::getpid();
    pid_ = ::fork();
    if (pid_ == 0) become(argv, parent);
    if (pid_ < 0) {
      throw Error(Exit::failed, program_ + ": " + std::generic_category().message(errno));
    }
    out_.pipe.close_writing();
    err_.pipe.close_writing();
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() {
    if (pid_ > 0) (void)wait_after(SIGKILL);
  }

  Signals signals() {
    if (!receive()) refuse_for_time();
    const int status = wait_after(0);
    if (WIFSIGNALED(status)) refuse_signal(WTERMSIG(status));
    if (WEXITSTATUS(status) != 0) refuse_as_it_does(WEXITSTATUS(status));
    if (incoming_.whole() != files_.size()) refuse("its reader returned too few samples");
    return incoming_.take_all();
  }

 private:
  /// Returns the file that read_raw was reading when it ended.
  [[nodiscard]] const fs::path& current_file() const {
    return files_[std::min(incoming_.whole(), files_.size() - 1)];
  }
  [[noreturn]] void become(const std::vector<char*>& argv, pid_t parent) const {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const bool ready = ::getppid() == parent && is_put(names_.to_read(), STDIN_FILENO) &&
                       is_put(out_.pipe.to_write(), STDOUT_FILENO) &&
                       is_put(err_.pipe.to_write(), STDERR_FILENO);
    if (ready) ::execv(argv.front(), argv.data());
    ::_exit(cannot_be_run);
  }

  /// Reads both outputs until they are closed; returns false on timeout.
  bool receive() {
    const auto end = Clock::now() + std::chrono::seconds(limits_.wall_seconds);
    while (!out_.ended || !err_.ended) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
      if (left.count() <= 0) return false;
      std::array<pollfd, 2> ready{pollfd{out_.ended ? -1 : out_.pipe.to_read(), POLLIN, 0},
                                  pollfd{err_.ended ? -1 : err_.pipe.to_read(), POLLIN, 0}};
      if (::poll(ready.data(), ready.size(), static_cast<int>(left.count())) <= 0) continue;
      if (ready[0].revents != 0) incoming_.add(out_.take());
      if (ready[1].revents != 0) note_error(err_.take());
    }
    return true;
  }

  void note_error(std::span<const std::byte> bytes) {
    constexpr std::size_t most = 1 << 16;
    error_.append(reinterpret_cast<const char*>(bytes.data()),
                  std::min(bytes.size(), most - error_.size()));
  }

  int wait_after(int signal) {
    if (signal != 0) ::kill(pid_, signal);
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) continue;
    pid_ = -1;
    return status;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    refuse_file(current_file(),
                "cannot be read: " + what + "; the file may be damaged, get it again");
  }
  [[noreturn]] void refuse_for_time() const {
    refuse("its reader took longer than " + std::to_string(limits_.wall_seconds) +
           " s, too long for its size");
  }
  [[noreturn]] void refuse_signal(int signal) const {
    if (signal == SIGXCPU) {
      refuse("its reader was stopped after " + std::to_string(limits_.processor_seconds) +
             " s of processor time, too much for its size");
    }
    refuse("its reader crashed (signal " + std::to_string(signal) + ")");
  }
  /// Refuses the file with read_raw's own error line, without the program name. Finds the line
  /// among lines of libraries.
  [[noreturn]] void refuse_as_it_does(int status) const {
    if (status == cannot_be_run) {
      throw Error(Exit::failed,
                  program_ + ": cannot be run; put it next to the other programs (`make build`)");
    }
    const std::string mark = "read_raw: ";
    const std::size_t begin = error_.find(mark);
    if (begin == std::string::npos) {
      refuse("its reader ended with exit code " + std::to_string(status));
    }
    const std::size_t end = std::min(error_.find('\n', begin), error_.size());
    const std::string line = error_.substr(begin + mark.size(), end - begin - mark.size());
    if (status == static_cast<int>(Exit::failed)) {
      refuse("its reader failed with " + std::to_string(limits_.memory_bytes / 1'000'000) +
             " MB of memory (" + line + ")");
    }
    throw Error(static_cast<Exit>(status), line);
  }

  std::vector<fs::path> files_;
  Limits limits_;
  Names names_;
  std::string program_;
  Output out_;
  Output err_;
  Incoming incoming_;
  std::string error_;  ///< standard error of read_raw
  pid_t pid_ = -1;
};

}  // namespace

Signals read_all(const std::vector<fs::path>& files, const std::string& variable,
                 std::optional<double> sample_rate_hz) {
  return Reader(files, variable, sample_rate_hz, limits_of(files)).signals();
}

std::vector<double> read(const fs::path& file, const std::string& variable,
                         std::optional<double> sample_rate_hz) {
  return read_all(std::vector{file}, variable, sample_rate_hz).samples;
}

}  // namespace piae::raw
