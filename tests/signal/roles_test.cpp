#include "signal/roles.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "signal/counting.hpp"
#include "signal/split.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::signal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Returns a role with windows of ten samples in the records "one" and "two".
RoleSet role(Role role, Protocol protocol,
             const std::vector<std::pair<std::int32_t, std::int64_t>>& places) {
  RoleSet set{.file = to_string(role) + ".h5",
              .role = role,
              .protocol = protocol,
              .seed = 0,
              .records_digest = "digest",
              .windows = {}};
  set.windows.length = 10;
  set.windows.record_names = {"one", "two"};
  for (const auto& [record, first] : places) {
    set.windows.labels.push_back(0);
    set.windows.record.push_back(record);
    set.windows.first_sample.push_back(first);
  }
  return set;
}

TEST(Roles, MayOverlapButNotShareAWindowInARandomSplit) {
  EXPECT_THAT(check_roles({role(Role::test, Protocol::random, {{0, 0}, {0, 5}}),
                           role(Role::hidden, Protocol::random, {{0, 6}})}),
              IsEmpty());
  EXPECT_THAT(check_roles({role(Role::test, Protocol::random, {{0, 0}, {0, 5}}),
                           role(Role::hidden, Protocol::random, {{0, 5}})}),
              ElementsAre("record one: roles A and D share a window at sample 5 (1 places)"));
}

TEST(Roles, DoNotConflictInDifferentRecords) {
  EXPECT_THAT(check_roles({role(Role::test, Protocol::random, {{0, 5}}),
                           role(Role::hidden, Protocol::random, {{1, 5}})}),
              IsEmpty());
}

TEST(Roles, ConflictByRecordNameNotByIndex) {
  RoleSet d = role(Role::hidden, Protocol::random, {{1, 5}});
  d.windows.record_names = {"two", "one"};
  EXPECT_THAT(check_roles({role(Role::test, Protocol::random, {{0, 5}}), d}),
              ElementsAre(HasSubstr("record one: roles A and D share a window")));
}

TEST(Roles, AreAWindowLengthApartInABlockedSplit) {
  const RoleSet a = role(Role::test, Protocol::blocked, {{0, 0}, {0, 5}});
  EXPECT_THAT(check_roles({a, role(Role::known, Protocol::blocked, {{0, 25}, {0, 28}})}),
              IsEmpty());
  EXPECT_THAT(
      check_roles({a, role(Role::known, Protocol::blocked, {{0, 24}, {0, 28}})}),
      ElementsAre("record one: roles A and C lie 9 samples apart at sample 24 (1 places); a "
                  "blocked split keeps 10"));
  EXPECT_THAT(check_roles({a, role(Role::known, Protocol::blocked, {{0, 3}})}),
              ElementsAre(HasSubstr("lie -7 samples apart at sample 3 (2 places)")));
  EXPECT_THAT(check_roles({a, role(Role::known, Protocol::blocked, {{0, 5}})}),
              ElementsAre(HasSubstr("share a window at sample 5")));
}

TEST(Roles, MustBelongToOneSplit) {
  const RoleSet a = role(Role::test, Protocol::random, {{0, 0}});
  RoleSet d = role(Role::hidden, Protocol::random, {{0, 20}});
  d.seed = 1;
  EXPECT_THAT(check_roles({a, d}),
              ElementsAre("D.h5: has seed 1, but A.h5 has 0; they do not belong to one split"));
  d = role(Role::hidden, Protocol::blocked, {{0, 20}});
  EXPECT_THAT(check_roles({a, d}), ElementsAre(HasSubstr("has protocol blocked")));
  d = role(Role::hidden, Protocol::random, {{0, 20}});
  d.records_digest = "other";
  EXPECT_THAT(check_roles({a, d}), ElementsAre(HasSubstr("has records_digest other")));
  d = role(Role::hidden, Protocol::random, {{0, 20}});
  d.windows.length = 20;
  EXPECT_THAT(check_roles({a, d}), ElementsAre(HasSubstr("has window length 20")));
}

TEST(Roles, HoldOnlyWindowsOfPermittedConditions) {
  RoleSet a = role(Role::test, Protocol::random, {{0, 0}});
  RoleSet c = role(Role::known, Protocol::random, {{1, 5}});
  for (RoleSet* set : {&a, &c}) {
    set->windows.info.conditions = {{.name = "900 rpm", .test = false},
                                    {.name = "1200 rpm", .known = false}};
    set->windows.condition = {set == &a ? 1 : 0};
  }
  EXPECT_THAT(check_roles({a, c}), IsEmpty());
  a.windows.condition = {every_condition};
  EXPECT_THAT(check_roles({a, c}), IsEmpty());
  a.windows.condition = {0};
  EXPECT_THAT(check_roles({a, c}),
              ElementsAre("A.h5: has windows of condition '900 rpm', which role A must not have"));
  a.windows.condition = {1};
  c.windows.condition = {1};
  EXPECT_THAT(check_roles({a, c}), ElementsAre(HasSubstr("C.h5: has windows of condition '1200 ")));
  c.windows.info.conditions[0].name = "700 rpm";
  EXPECT_THAT(check_roles({a, c}), ElementsAre(HasSubstr("C.h5: has other conditions than A.h5")));
}

TEST(Roles, AreValidWithoutFiles) { EXPECT_THAT(check_roles({}), IsEmpty()); }

void save(const Folder& folder, const Split& split, Role role, const SplitOptions& options) {
  artefact::Writer writer("windows");
  write(writer, split, role, options, "the digest");
  writer.save(folder / (to_string(role) + ".h5"), {"split", "", {}});
}

TEST(Roles, AreReadBack) {
  const Folder folder;
  SplitOptions options;
  options.seed = 7;
  const Split s = split(counting_recordings(80000), options);
  std::vector<RoleSet> sets;
  for (const Role role : split_roles) {
    save(folder, s, role, options);
    const artefact::Reader reader(folder / (to_string(role) + ".h5"), "windows");
    sets.push_back(read_role_set(reader));
    EXPECT_EQ(sets.back().role, role);
    EXPECT_EQ(sets.back().protocol, Protocol::random);
    EXPECT_EQ(sets.back().seed, 7);
    EXPECT_EQ(sets.back().records_digest, "the digest");
    EXPECT_EQ(sets.back().windows.samples, s.of(role).samples);
    EXPECT_EQ(sets.back().windows.first_sample, s.of(role).first_sample);
    EXPECT_EQ(reader.numbers<std::int64_t>("/classes/stride", {3}).values, s.strides);
  }
  EXPECT_THAT(check_roles(sets), IsEmpty());
}

/// Without known faults, C keeps all its other data.
TEST(Roles, MayBeEmptyForKnownWindowsOnly) {
  const Folder folder;
  const Recordings recordings = counting_recordings(80000);
  SplitOptions options{.seed = 3};
  options.known_per_class = 0;
  const Split s = split(recordings, options);
  const auto stored = [&](Role role, const WindowSet& windows) {
    Split other = s;
    other.of(role) = windows;
    artefact::Writer writer("windows");
    write(writer, other, role, options, "digest");
    writer.save(folder / "set.h5", {"test", "", {}});
    return artefact::Reader(folder / "set.h5", "windows");
  };
  const artefact::Reader c = stored(Role::known, s.of(Role::known));
  const RoleSet known = read_role_set(c);
  EXPECT_NO_THROW(require_belonging(c, Role::known, known.windows));
  EXPECT_EQ(known.windows.size(), 0U);
  EXPECT_EQ(known.windows.length, 1024U);
  EXPECT_EQ(known.windows.info.classes.size(), 3U);
  EXPECT_EQ(known.windows.record_names, s.of(Role::known).record_names);
  EXPECT_EQ(known.seed, 3);
  EXPECT_EQ(known.records_digest, "digest");
  for (const Role role : {Role::test, Role::healthy, Role::hidden}) {
    const artefact::Reader empty = stored(role, s.of(Role::known));
    EXPECT_ERROR(require_belonging(empty, role, read_window_set(empty)), Exit::bad_input,
                 "has no window of class");
  }
  WindowSet some = s.of(Role::known);
  const WindowSet& hidden = s.of(Role::hidden);
  some.append(hidden, hidden.indices_of(1).front());
  const artefact::Reader half = stored(Role::known, some);
  EXPECT_ERROR(require_belonging(half, Role::known, read_window_set(half)), Exit::bad_input,
               "has no window of class R");
}

TEST(Roles, CannotBeReadFromGeneratedWindows) {
  const Folder folder;
  WindowSet generated;
  generated.info = counting_recordings(10).info;
  generated.length = 2;
  generated.samples = {1, 2};
  generated.labels = {1};
  artefact::Writer writer("windows");
  write(writer, generated);
  writer.attribute("/", "role", std::string("E"));
  writer.attribute("/", "protocol", std::string("random"));
  writer.attribute("/", "seed", std::int64_t{0});
  writer.attribute("/", "records_digest", std::string("d"));
  writer.save(folder / "E.h5", {});
  const artefact::Reader reader(folder / "E.h5", "windows");
  EXPECT_ERROR(read_role_set(reader), Exit::bad_input,
               "the places of the windows in the records are unknown");
}

TEST(Roles, AreStoredAsLetters) {
  const std::string letters = to_string(Role::test) + to_string(Role::healthy) +
                              to_string(Role::known) + to_string(Role::hidden) +
                              to_string(Role::generated);
  EXPECT_EQ(letters, "ABCDE");
}

TEST(Roles, AreRefusedWithUnknownWords) {
  const Folder folder;
  artefact::Writer writer("windows");
  writer.attribute("/", "role", std::string("F"));
  writer.attribute("/", "protocol", std::string("ordered"));
  writer.save(folder / "F.h5", {});
  const artefact::Reader reader(folder / "F.h5", "windows");
  EXPECT_ERROR(read_role(reader), Exit::bad_input, "has role F; it must be A, B, C, D or E");
  EXPECT_ERROR(require_role(reader, Role::test), Exit::bad_input, "has role F");
  EXPECT_ERROR(read_protocol(reader), Exit::bad_input,
               "is 'ordered'; it must be random or blocked");
}

}  // namespace
}  // namespace piae::signal
