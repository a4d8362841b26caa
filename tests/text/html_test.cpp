#include "text/html.hpp"

#include <gmock/gmock.h>

namespace piae::text {
namespace {

TEST(Html, EscapesPlainTextEverywhere) {
  const std::string hostile = "<script>alert(\"1\")</script> & 'x'";
  EXPECT_EQ(Html(hostile).text(), "&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt; &amp; 'x'");
  EXPECT_EQ(element("td", hostile).text(),
            "<td>&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt; &amp; 'x'</td>");
}

TEST(Html, EscapesValuesOfAttributes) {
  EXPECT_EQ(element("a", {{"title", "\" onclick=\"alert(1)"}}, "x").text(),
            "<a title=\"&quot; onclick=&quot;alert(1)\">x</a>");
}

TEST(Html, KeepsTheOrderOfContent) {
  EXPECT_EQ(element("b", {}, {"a < b", element("i", "c"), Html(" d")}).text(),
            "<b>a &lt; b<i>c</i> d</b>");
}

TEST(Html, DoesNotCloseVoidElements) {
  EXPECT_EQ(void_element("img", {{"src", "data:,"}, {"alt", ""}}).text(),
            "<img src=\"data:,\" alt=\"\">\n");
}

}  // namespace
}  // namespace piae::text
