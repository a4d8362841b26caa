#include "cli/toml_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::cli {
namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(TomlFile, IsReadCompletely) {
  const Folder folder;
  EXPECT_EQ(parse_toml_file(folder.write("a.toml", "[a.b]\nc = 3\n"))["a"]["b"]["c"], 3);
}

TEST(TomlFile, ReportsErrorsInOneLineWithTheirPlace) {
  const Folder folder;
  EXPECT_ERROR(parse_toml_file(folder.write("a.toml", "a = 1\nb = \n")), Exit::bad_input,
               "a.toml, line 2: not valid TOML: ");
}

TEST(TomlFile, IsRefusedIfNestedTooDeeply) {
  const Folder folder;
  const auto refused = [&](const std::string& text) {
    EXPECT_ERROR(parse_toml_file(folder.write("a.toml", text)), Exit::bad_input, "a.toml, line ");
  };
  refused("\n" + repeated("a.", 200'000) + "a = 1\n");
  refused("[" + repeated("a.", 200'000) + "a]\n");
  refused("a = " + repeated("[", 200'000));
  refused("a = " + repeated("{a = ", 190'000));
  // the deepest permitted nesting
  const std::string most = repeated("a.", 100) + "a";
  EXPECT_NO_THROW((void)parse_toml_file(
      folder.write("a.toml", "[" + most + "]\n" + most + " = [\n{" + most + " = 1}]\n")));
}

TEST(TomlFile, IsRefusedIfHuge) {
  const Folder folder;
  EXPECT_ERROR(parse_toml_file(folder.write("a.toml", repeated("# a comment\n", 100'000))),
               Exit::bad_input, "a.toml: is larger than 1 MB");
}

TEST(TomlFile, IsRefusedIfAPipe) {
  const Folder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe.toml").c_str(), 0600), 0);
  EXPECT_ERROR(parse_toml_file(folder / "pipe.toml"), Exit::input_missing, "not a file");
}

}  // namespace
}  // namespace piae::cli
