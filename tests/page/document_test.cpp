#include "page/document.hpp"

#include <gmock/gmock.h>

#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::page {
namespace {

using testing::HasSubstr;

TEST(Document, EmbedsStyleAndScriptAndForbidsEverythingElse) {
  const std::string page =
      document("a < b", {.css = "body{}", .script = "\"use strict\";"}, "text");
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
  EXPECT_THAT(page, HasSubstr("<title>a &lt; b</title>"));
  EXPECT_THAT(page, HasSubstr("<style>body{}</style>"));
  EXPECT_THAT(page, HasSubstr("<script>\"use strict\";</script>"));
  // printf 'body{}' | openssl dgst -sha256 -binary | base64; likewise for the script
  EXPECT_THAT(page,
              HasSubstr("content=\"default-src 'none'; img-src data:; "
                        "style-src 'sha256-fJgEClQWV1hGkK4qHMO0KotTsVnMYMXTq7/suurGyUo='; "
                        "script-src 'sha256-Xs8vTYPmJg2r1uxI522N3rzPlWVj80ByIhv5YNO4wlU='\""));
}

TEST(Document, TakesStyleAndScriptFromFiles) {
  const Folder folder;
  folder.write("style.css", "p { color: red }\r\n");
  folder.write("script.js", "let a;\n");
  const Style style = read_style(folder.path());
  EXPECT_EQ(style.css, "p { color: red }\n");
  EXPECT_EQ(style.script, "let a;\n");
}

TEST(Document, RefusesAScriptWithAnEndTag) {
  const Folder folder;
  EXPECT_ERROR(read_style(folder.path()), Exit::input_missing, "style.css");
  folder.write("style.css", "");
  folder.write("script.js", "let a = '</script>';");
  EXPECT_ERROR(read_style(folder.path()), Exit::bad_input, "script.js: contains '</script'");
}

}  // namespace
}  // namespace piae::page
