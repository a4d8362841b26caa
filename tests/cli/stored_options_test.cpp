#include "cli/stored_options.hpp"

#include <gtest/gtest.h>

#include "support/checkpoints.hpp"
#include "support/command_line.hpp"
#include "support/errors.hpp"

namespace piae::cli {
namespace {

enum class Colour { red, green };

struct Paint {
  Colour colour = Colour::red;
  double thin_mm = 1;
  double thick_mm = 2;
  int coats = 3;
};

StoredOptions table_of(Paint& o) {
  const std::vector<Word<Colour>> colours{{"red", Colour::red}, {"green", Colour::green}};
  const Range thickness{.low = 0, .high = 10};
  StoredOptions table;
  table.in("/colour");
  table.add("paint-from", o.colour, colours, "its colour", "hue");
  table.in("/layers");
  table.add("thick-from-mm", o.thin_mm, thickness, "least");
  table.add("thick-to-mm", o.thick_mm, thickness, "largest");
  table.add("coats", o.coats, Range{.low = 1, .high = 5}, "how many");
  return table;
}

Paint paint_of(const std::string& line) {
  Paint paint;
  parse(line, [&](const Options& command) { table_of(paint).bind(command); });
  return paint;
}

artefact::Reader stored(Paint paint) {
  artefact::Writer writer("model");
  table_of(paint).write(writer);
  writer.save(scratch_file("paint.h5"), {});
  return {scratch_file("paint.h5"), "model"};
}

TEST(StoredOptions, AreReadBack) {
  const artefact::Reader reader =
      stored(paint_of("--paint-from green --thick-from-mm 0.5 --coats 5"));
  EXPECT_EQ(reader.text("/colour", "hue"), "green");
  EXPECT_EQ(reader.real("/layers", "thick_from_mm"), 0.5);
  Paint read;
  table_of(read).read(reader);
  EXPECT_EQ(read.colour, Colour::green);
  EXPECT_EQ(read.thin_mm, 0.5);
  EXPECT_EQ(read.thick_mm, 2);
  EXPECT_EQ(read.coats, 5);
}

TEST(StoredOptions, AreRefusedOutsideTheirRules) {
  EXPECT_THROW(paint_of("--paint-from blue"), Refused);
  EXPECT_THROW(paint_of("--thick-to-mm 11"), Refused);
  EXPECT_THROW(paint_of("--coats 0"), Refused);
  EXPECT_THROW(paint_of("--coats 1.5"), Refused);
  Paint read;
  EXPECT_ERROR(table_of(read).read(stored({.coats = 9})), Exit::bad_input, "coats");
  EXPECT_ERROR(table_of(read).read(stored({.thick_mm = 11})), Exit::bad_input, "thick_to_mm");
  artefact::Writer writer("model");
  writer.group("/colour");
  writer.attribute("/colour", "hue", std::string("blue"));
  writer.save(scratch_file("blue.h5"), {});
  EXPECT_ERROR(table_of(read).read({scratch_file("blue.h5"), "model"}), Exit::bad_input,
               "/colour, attribute hue is blue; it must be red or green");
}

TEST(StoredOptions, RefuseReversedRanges) {
  Paint reversed{.thin_mm = 3, .thick_mm = 2};
  EXPECT_ERROR(table_of(reversed).require_order(), Exit::usage,
               "--thick-from-mm must not be above --thick-to-mm");
  EXPECT_ERROR(table_of(reversed).read(stored(reversed)), Exit::bad_input,
               "/layers, attribute thick_from_mm is above thick_to_mm");
  Paint equal{.thin_mm = 2, .thick_mm = 2};
  EXPECT_NO_THROW(table_of(equal).require_order());
}

}  // namespace
}  // namespace piae::cli
