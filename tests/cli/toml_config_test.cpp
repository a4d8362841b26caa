#include "cli/toml_config.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <fstream>

namespace piae::cli {
namespace {

/// Values of an app with --epochs, --rate and --names after parsing.
struct Parsed {
  int epochs = 1;
  double rate = 0.5;
  std::vector<std::string> names{"none"};
};

Parsed parse(const std::string& toml, const std::string& variant = "",
             const std::vector<std::string>& arguments = {}) {
  Parsed parsed;
  CLI::App app;
  app.add_option("--epochs", parsed.epochs);
  app.add_option("--rate", parsed.rate);
  app.add_option("--names", parsed.names);
  app.allow_config_extras(CLI::config_extras_mode::error);
  app.set_config("--config");
  app.config_formatter(std::make_shared<TomlConfig>("train", variant));
  const std::string path = testing::TempDir() + "/toml_config_test.toml";
  std::ofstream(path) << toml;
  std::vector<std::string> all{"--config", path};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<const char*> argv{"train"};
  for (const std::string& argument : all) argv.push_back(argument.c_str());
  app.parse(static_cast<int>(argv.size()), argv.data());
  return parsed;
}

TEST(TomlConfig, ReadsTheProgramsOwnTable) {
  const Parsed parsed =
      parse("[split]\nwindow = 7\n[train]\nepochs = 20\nnames = [\"a\", \"b\"]\n");
  EXPECT_EQ(parsed.epochs, 20);
  EXPECT_EQ(parsed.rate, 0.5);
  EXPECT_EQ(parsed.names, (std::vector<std::string>{"a", "b"}));
}

TEST(TomlConfig, ReadsFromTheTopWithoutATable) { EXPECT_EQ(parse("epochs = 20\n").epochs, 20); }

TEST(TomlConfig, PrefersTheTableOfTheVariant) {
  const std::string toml =
      "[train]\nepochs = 20\nrate = 0.1\n[train.vae]\nepochs = 30\n[train.ae]\nepochs = 4\n";
  EXPECT_EQ(parse(toml).epochs, 20);
  EXPECT_EQ(parse(toml, "vae").epochs, 30);
  EXPECT_EQ(parse(toml, "vae").rate, 0.1);
  EXPECT_EQ(parse(toml, "smote").epochs, 20);
}

TEST(TomlConfig, CompletesAVariantFromAnotherOne) {
  const std::string toml =
      "[train]\nepochs = 20\nrate = 0.1\n[train.ae]\nlike = \"vae\"\nepochs = 4\n"
      "[train.vae]\nepochs = 30\nrate = 0.2\n";
  EXPECT_EQ(parse(toml, "ae").epochs, 4);
  EXPECT_EQ(parse(toml, "ae").rate, 0.2);
  EXPECT_EQ(parse(toml, "vae").epochs, 30);
}

TEST(TomlConfig, RefusesLikeWithoutATable) {
  const std::string toml =
      "[train.ae]\nlike = \"vae\"\n[train.cnn]\nlike = \"ae\"\n[train.rnn]\nlike = 3\n";
  for (const std::string variant : {"ae", "cnn", "rnn"}) {
    EXPECT_THROW(parse(toml, variant), CLI::ConfigError) << variant;
  }
}

TEST(TomlConfig, PrefersTheCommandLineToTheFile) {
  EXPECT_EQ(parse("[train]\nepochs = 20\n", "", {"--epochs", "5"}).epochs, 5);
}

TEST(TomlConfig, RefusesUnknownKeysWrongTypesAndBrokenFiles) {
  EXPECT_THROW(parse("[train]\nepoch = 20\n"), CLI::ConfigError);
  EXPECT_THROW(parse("[train]\nepochs = \"many\"\n"), CLI::ConversionError);
  try {
    parse("[train\n");
    FAIL();
  } catch (const CLI::Error& error) {
    EXPECT_NE(std::string(error.what()).find("line 1"), std::string::npos) << error.what();
  }
}

TEST(TomlConfig, KeepsSmallNumbersExact) {
  EXPECT_EQ(parse("[train]\nrate = 5e-4\n").rate, 5e-4);
  EXPECT_EQ(parse("[train]\nrate = 0.1\n").rate, 0.1);
}

}  // namespace
}  // namespace piae::cli
