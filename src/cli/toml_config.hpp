#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace piae::cli {

/// Lets CLI11 read options from a TOML file, by toml++. The keys are the long names of the options.
/// In a file such as pipeline/protocol.toml each program reads its own table, [train], and then the
/// table of the chosen variant, [train.piae-dt], which wins over it. A file without the program's
/// table is for this program alone, and its keys stand at the top. An option of the command line
/// wins over the file. A table that says like = "piae-dt" holds only what differs from that
/// variant's table.
class TomlConfig : public CLI::Config {
 public:
  TomlConfig(std::string program, std::string variant)
      : program_(std::move(program)), variant_(std::move(variant)) {}

  std::string to_config(const CLI::App*, bool, bool, std::string) const override { return {}; }
  std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;

 private:
  std::string program_;
  std::string variant_;
};

}  // namespace piae::cli
