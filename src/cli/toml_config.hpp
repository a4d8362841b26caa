#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace piae::cli {

/// Lets CLI11 read a program's options from a TOML file, whose keys are the long option names.
/// toml_options.hpp defines the tables. The command line overrides the file.
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
