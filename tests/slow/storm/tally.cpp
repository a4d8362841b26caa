#include "storm/tally.hpp"

#include <cstdio>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "storm/files.hpp"

namespace piae::storm {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point time) {
  return std::chrono::duration<double>(Clock::now() - time).count();
}

}  // namespace

Requested requested_by(int argc, char** argv) {
  if (argc != 6) {
    throw std::runtime_error("usage: " + std::string(argv[0]) + " CORPUS FOLDER COUNT SEED BIN");
  }
  return {argv[1], argv[2], std::stoul(argv[3]), std::stoul(argv[4]), argv[5]};
}

Tally::Tally(std::string part, const Requested& requested)
    : part_(std::move(part)), folder_(requested.folder), count_(requested.count) {
  std::filesystem::create_directories(folder_);
  if (!std::filesystem::exists(folder_ / "count")) return;
  std::istringstream(bytes_of(folder_ / "count")) >> done_ >> refused_ >> accepted_ >> missed_;
  done_before_ = done_;
}

void Tally::keep() {
  std::ostringstream text;
  text << done_ << ' ' << refused_ << ' ' << accepted_ << ' ' << missed_ << '\n';
  write_bytes(folder_ / "count.new", text.str());
  std::filesystem::rename(folder_ / "count.new", folder_ / "count");
  kept_ = Clock::now();
}

void Tally::add(Result result) {
  ++done_;
  ++(result == Result::refused ? refused_ : result == Result::accepted ? accepted_ : missed_);
  if (seconds_since(kept_) > 1) keep();
  if (seconds_since(told_) < 20) return;
  told_ = Clock::now();
  const auto here = static_cast<double>(done_ - done_before_);
  const double left = seconds_since(started_) / here * static_cast<double>(count_ - done_);
  std::fprintf(stderr, "%s: %zu of %zu, %zu missed, %.0f minutes left\n", part_.c_str(), done_,
               count_, missed_, left / 60);
}

void Tally::keep_finding(const std::string& name, const std::string& bytes,
                         const std::string& what) {
  const std::filesystem::path findings = folder_ / "findings";
  std::filesystem::create_directories(findings);
  const std::string file = std::to_string(done_) + "-" + name;
  write_bytes(findings / file, bytes);
  write_bytes(findings / (file + ".txt"), what + "\n");
  std::cerr << part_ << " " << done_ << ": " << what.substr(0, 400)
            << "\n  kept: " << (findings / file).string() << '\n';
}

int Tally::finish() {
  keep();
  std::cout << part_ << ": " << done_ << " done, " << refused_ << " refused, " << accepted_
            << " accepted, " << missed_ << " missed\n";
  return missed_ == 0 ? 0 : 1;
}

}  // namespace piae::storm
