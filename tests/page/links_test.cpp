#include <gmock/gmock.h>

#include "page/html.hpp"

namespace piae::page {
namespace {

TEST(Links, PointBelowThePageForAnyFileName) {
  EXPECT_EQ(address_of("cwru/seed0/A.h5"), "./cwru/seed0/A.h5");
  EXPECT_EQ(address_of("javascript:alert(1)/seed0"), "./javascript%3Aalert%281%29/seed0");
  EXPECT_EQ(address_of("100 %?#\".svg"), "./100%20%25%3F%23%22.svg");
}

TEST(Links, ShowThePathOfTheFile) {
  EXPECT_EQ(file_link("a&b/c.h5").text(), "<a href=\"./a%26b/c.h5\">a&amp;b/c.h5</a>");
}

TEST(Links, EscapeTextInDataAddresses) {
  EXPECT_EQ(data_address("text/csv", "a,b\n1,\"50 %\"\n#&<>"),
            "data:text/csv;charset=utf-8,a,b%0A1,%2250 %25%22%0A%23%26%3C%3E");
}

TEST(Links, UseLettersDigitsAndHyphensInAnchors) {
  EXPECT_EQ(anchor("Fig 07/losses@IR007\""), "fig-07-losses-ir007-");
}

}  // namespace
}  // namespace piae::page
