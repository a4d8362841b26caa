#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace piae::cli {

/// Lets CLI11 read its options from a TOML file (by toml++): keys are the long option names.
/// Of a file with tables, such as pipeline/protocol.toml, a program reads its own table, [train],
/// and below it the table of the chosen variant, [train.piae-dt]. A file without that table is read
/// from the top, so that a file for one program alone needs none. An option given on the command
/// line wins over the file, the variant's table over the program's. A variant that differs little
/// from another names it, like = "piae-dt", and stands on top of its table.
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
