#include "cli/toml_advice.hpp"

#include <gtest/gtest.h>

#include "cli/toml_file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::cli {
namespace {

TEST(TomlAdvice, QuotesAWordWithoutQuotes) {
  EXPECT_EQ(toml_advice("name = rig"), "name is a text without quotes; write \"rig\"");
  EXPECT_EQ(toml_advice("name = true_rig # ours"),
            "name is a text without quotes; write \"true_rig\"");
  EXPECT_EQ(toml_advice("name = nano"), "name is a text without quotes; write \"nano\"");
  EXPECT_EQ(toml_advice("file = 97.mat"), "file is a text without quotes; write \"97.mat\"");
  EXPECT_EQ(toml_advice("  file = C:\\data\\x.csv\r"),
            "file is a text without quotes; write 'C:\\data\\x.csv'");
  EXPECT_EQ(toml_advice("known = [outer, \"inner\"]"),
            "known has outer without quotes; write \"outer\"");
}

TEST(TomlAdvice, NamesOtherCommonErrors) {
  EXPECT_EQ(toml_advice("size = 1,5"), "size has a decimal comma; write 1.5");
  EXPECT_EQ(toml_advice("rate = 12 kHz"),
            "rate has something after the number; remove it, or write a text in quotes, "
            "\"12 kHz\"");
  EXPECT_EQ(toml_advice("name ="), "name has no value");
  EXPECT_EQ(toml_advice("name = “rig”"), "name has curly quotes; write straight ones, \"...\"");
  EXPECT_EQ(toml_advice("file = \"C:\\data\""),
            "file has a backslash in the text; write it between single quotes, '...', or replace "
            "it by /");
  EXPECT_EQ(toml_advice("name = \"rig"),
            "name has a text in quotes without an end, or something after it");
  EXPECT_EQ(toml_advice("name: rig"), "has no equals sign; a line is KEY = VALUE");
}

TEST(TomlAdvice, IsEmptyForValidValues) {
  EXPECT_EQ(toml_advice("name = \"a # b\""), "");
  EXPECT_EQ(toml_advice("balls = 9"), "");
  EXPECT_EQ(toml_advice("[bearing"), "");
  EXPECT_EQ(toml_advice("balls = 09"), "");  // the parser's own message is better
  EXPECT_EQ(toml_advice(""), "");
}

TEST(TomlAdvice, NamesTheLineOfTheFile) {
  const Folder folder;
  EXPECT_ERROR(parse_toml_file(folder.write("a.toml", "a = 1\n\nname = rig\n")), Exit::bad_input,
               "a.toml, line 3: not valid TOML: name is a text without quotes; write \"rig\"");
}

}  // namespace
}  // namespace piae::cli
