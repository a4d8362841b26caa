#include "signal/split.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "signal/counting.hpp"
#include "signal/roles.hpp"
#include "support/errors.hpp"

namespace piae::signal {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

enum { A, B, C, D };

SplitOptions options_of(Protocol protocol, std::int64_t seed = 0) {
  SplitOptions options;
  options.seed = seed;
  options.protocol = protocol;
  return options;
}

/// Returns the roles of a split as verify would read them.
std::vector<RoleSet> role_sets(const Split& split, const SplitOptions& options) {
  std::vector<RoleSet> sets;
  for (const Role role : split_roles) {
    sets.push_back({.file = to_string(role) + ".h5",
                    .role = role,
                    .protocol = options.protocol,
                    .seed = options.seed,
                    .records_digest = "digest",
                    .windows = split.of(role)});
  }
  return sets;
}

class Protocols : public testing::TestWithParam<Protocol> {};

TEST_P(Protocols, CutThePapersNumbersOfWindows) {
  const Split s = split(counting_recordings(80000), options_of(GetParam()));
  EXPECT_EQ(s.sets[A].size(), 300U);
  EXPECT_EQ(s.sets[B].size(), 500U);
  EXPECT_EQ(s.sets[C].size(), 10U);
  EXPECT_EQ(s.sets[D].size(), 990U);
  for (int label = 0; label < 3; ++label) {
    const bool healthy = label == 0;
    EXPECT_EQ(s.sets[A].count_of(label), 100U);
    EXPECT_EQ(s.sets[B].count_of(label), healthy ? 500U : 0U);
    EXPECT_EQ(s.sets[C].count_of(label), healthy ? 0U : 5U);
    EXPECT_EQ(s.sets[D].count_of(label), healthy ? 0U : 495U);
  }
}

/// Speeds of records of a data set without conditions. Those of simulated records scatter less.
TEST_P(Protocols, GiveWindowsTheSpeedOfTheirRecord) {
  Recordings recordings = counting_recordings(80000);
  const auto cut = [&] { return split(recordings, options_of(GetParam())).sets[A]; };
  recordings.records[2].shaft_speed_rpm = 1800;
  EXPECT_THAT(cut().shaft_speed_rpm, IsEmpty());
  recordings.records[2].shaft_speed_rpm = 1700;
  const WindowSet set = cut();
  EXPECT_THAT(set.condition, IsEmpty());
  for (std::size_t i = 0; i < set.size(); ++i) {
    EXPECT_EQ(set.speed_rpm(i), set.labels[i] == 0 ? 1700 : 1797);
  }
}

/// Pieces of 2500, 700 and 3000 samples in turn: the second ones do not hold a window.
TEST_P(Protocols, CutNoWindowAcrossPieces) {
  Recordings recordings = counting_recordings(80000);
  for (Record& record : recordings.records) {
    std::size_t left = record.signal.size();
    for (std::size_t i = 0; left > 0; ++i) {
      record.pieces.push_back(std::min(left, std::array<std::size_t, 3>{2500, 700, 3000}[i % 3]));
      left -= record.pieces.back();
    }
  }
  const SplitOptions options = options_of(GetParam());
  const Split s = split(recordings, options);
  std::size_t windows = 0;
  for (const WindowSet& set : s.sets) {
    for (std::size_t i = 0; i < set.size(); ++i, ++windows) {
      const auto first = static_cast<std::size_t>(set.first_sample[i]);
      std::size_t begin = 0;
      for (const std::size_t length :
           recordings.records[static_cast<std::size_t>(set.record[i])].pieces) {
        if (first < begin + length) {
          EXPECT_LE(first + set.length, begin + length);
          break;
        }
        begin += length;
      }
    }
  }
  EXPECT_EQ(windows, 1800U);
  EXPECT_THAT(check_roles(role_sets(s, options)), IsEmpty());
}

/// C exists, of the same data set and records, and the other roles are unchanged.
TEST_P(Protocols, LeaveCEmptyIfNoFaultIsKnown) {
  SplitOptions options = options_of(GetParam());
  options.known_per_class = 0;
  options.windows_per_class = 595;
  const Split s = split(counting_recordings(80000), options);
  EXPECT_EQ(s.sets[A].size(), 300U);
  EXPECT_EQ(s.sets[B].size(), 495U);
  EXPECT_EQ(s.sets[C].size(), 0U);
  EXPECT_EQ(s.sets[D].size(), 990U);
  EXPECT_EQ(s.sets[C].length, 1024U);
  EXPECT_EQ(s.sets[C].record_names, s.sets[A].record_names);
  EXPECT_THAT(check_roles(role_sets(s, options)), IsEmpty());
}

TEST_P(Protocols, RefuseConstantWindows) {
  Recordings recordings = counting_recordings(80000);
  std::ranges::fill(recordings.records[1].signal, 0.5);
  EXPECT_ERROR((void)split(recordings, options_of(GetParam())), Exit::bad_input,
               "the signal is constant in the window from sample ");
}

TEST_P(Protocols, GiveNoWindowTwoRoles) {
  const Recordings recordings = counting_recordings(80000);
  for (std::int64_t seed = 0; seed < 20; ++seed) {
    const SplitOptions options = options_of(GetParam(), seed);
    const Split s = split(recordings, options);
    EXPECT_THAT(check_roles(role_sets(s, options)), IsEmpty()) << seed;
    std::set<std::pair<std::int32_t, std::int64_t>> places;
    std::size_t windows = 0;
    for (const WindowSet& set : s.sets) {
      windows += set.size();
      for (std::size_t i = 0; i < set.size(); ++i) {
        places.emplace(set.record[i], set.first_sample[i]);
      }
    }
    EXPECT_EQ(places.size(), windows) << seed;
  }
}

TEST_P(Protocols, KeepEachRoleToItsConditions) {
  const SplitOptions options = options_of(GetParam());
  const Split s = split(counting_transfer(80000), options);
  EXPECT_THAT(check_roles(role_sets(s, options)), IsEmpty());
  const auto conditions = [&](int set) {
    const auto& all = s.sets[set].condition;
    return std::set<std::int32_t>(all.begin(), all.end());
  };
  EXPECT_THAT(conditions(A), ElementsAre(1));
  EXPECT_THAT(conditions(B), ElementsAre(0, 1));
  EXPECT_THAT(conditions(C), ElementsAre(0));
  EXPECT_THAT(conditions(D), ElementsAre(1));
  EXPECT_EQ(s.sets[A].size(), 300U);
  EXPECT_EQ(s.sets[B].size(), 500U);
  EXPECT_EQ(s.sets[C].size(), 10U);
  EXPECT_EQ(s.sets[D].size(), 990U);
  EXPECT_EQ(std::ranges::count(s.sets[B].condition, 0), 250);
}

TEST_P(Protocols, GiveTheConditionAndSpeedOfEachWindow) {
  const Recordings recordings = counting_transfer(80000);
  const Split s = split(recordings, options_of(GetParam()));
  for (const WindowSet& set : s.sets) {
    ASSERT_EQ(set.condition.size(), set.size());
    ASSERT_EQ(set.shaft_speed_rpm.size(), set.size());
    EXPECT_THAT(set.defect_size_mm, IsEmpty());
    for (std::size_t i = 0; i < set.size(); ++i) {
      const Record& record = recordings.records[static_cast<std::size_t>(set.record[i])];
      ASSERT_EQ(set.condition[i], record.condition);
      ASSERT_EQ(set.shaft_speed_rpm[i], record.shaft_speed_rpm);
      ASSERT_EQ(set.window(i)[0],
                static_cast<float>(record.signal[static_cast<std::size_t>(set.first_sample[i])]));
    }
  }
}

TEST_P(Protocols, GiveDefectSizesIfAClassHasSeveral) {
  Recordings recordings = counting_transfer(80000);
  recordings.records[2].defect_size_mm = 0.1;
  const Split s = split(recordings, options_of(GetParam()));
  ASSERT_EQ(s.sets[C].defect_size_mm.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(s.sets[C].defect_size_mm[i], s.sets[C].labels[i] == 1 ? 0.1 : 0.5);
  }
}

TEST_P(Protocols, CutWindowsAtTheirStoredPlaces) {
  const Recordings recordings = counting_recordings(80000);
  const Split s = split(recordings, options_of(GetParam()));
  for (const WindowSet& set : s.sets) {
    for (std::size_t i = 0; i < set.size(); ++i) {
      const Record& record = recordings.records[static_cast<std::size_t>(set.record[i])];
      const auto first = static_cast<std::size_t>(set.first_sample[i]);
      ASSERT_EQ(set.record_names[static_cast<std::size_t>(set.record[i])], record.name);
      ASSERT_EQ(set.labels[i], record.label);
      ASSERT_EQ(set.window(i)[0], static_cast<float>(record.signal[first]));
      ASSERT_EQ(set.window(i)[1023], static_cast<float>(record.signal.at(first + 1023)));
    }
  }
}

TEST_P(Protocols, DependOnlyOnTheSeed) {
  const Recordings recordings = counting_recordings(80000);
  const Split one = split(recordings, options_of(GetParam(), 3));
  const Split same = split(recordings, options_of(GetParam(), 3));
  const Split other = split(recordings, options_of(GetParam(), 4));
  EXPECT_EQ(one.sets[C].first_sample, same.sets[C].first_sample);
  EXPECT_EQ(one.sets[C].record, same.sets[C].record);
  EXPECT_NE(one.sets[C].first_sample, other.sets[C].first_sample);
}

TEST_P(Protocols, SplitEachClassIndependently) {
  const Recordings all = counting_recordings(80000);
  Recordings fewer = all;
  fewer.info.classes.erase(fewer.info.classes.begin() + 1);
  std::erase_if(fewer.records, [](const Record& r) { return r.label == 1; });
  for (Record& r : fewer.records) r.label = r.label == 2 ? 1 : 0;
  const auto places_of = [](const WindowSet& set, int label) {
    std::vector<std::int64_t> places;
    for (const std::size_t i : set.indices_of(label)) places.push_back(set.first_sample[i]);
    return places;
  };
  EXPECT_EQ(places_of(split(all, options_of(GetParam())).sets[D], 2),
            places_of(split(fewer, options_of(GetParam())).sets[D], 1));
}

TEST_P(Protocols, KeepTrueParametersIfAllRecordsHaveThem) {
  Recordings recordings = counting_recordings(80000);
  EXPECT_THAT(split(recordings, options_of(GetParam())).sets[C].parameters, IsEmpty());
  for (std::size_t i = 0; i < recordings.records.size(); ++i) {
    recordings.records[i].parameters = DynamicParameters{1e8 + static_cast<double>(i), 500};
  }
  const WindowSet c = split(recordings, options_of(GetParam())).sets[C];
  ASSERT_EQ(c.parameters.size(), c.size());
  for (std::size_t i = 0; i < c.size(); ++i) {
    EXPECT_EQ(c.parameters[i].stiffness_n_per_m, 1e8 + c.record[i]);
    EXPECT_EQ(c.parameters[i].damping_ns_per_m, 500);
  }
}

TEST_P(Protocols, RefuseShortRecords) {
  EXPECT_ERROR(split(counting_recordings(1500), options_of(GetParam())), Exit::bad_input,
               "data set counting, class N: 600 windows of 1024 samples do not fit");
}

INSTANTIATE_TEST_SUITE_P(Both, Protocols, testing::Values(Protocol::random, Protocol::blocked),
                         [](const auto& info) { return to_string(info.param); });

TEST(SplitRandom, UsesTheLargestStrideOverAllRecordsOfAClass) {
  // N and R: (80000 - 1024) / 599 = 131.8. I: two records of 40000, 300 windows each at
  // (40000 - 1024) / 299 = 130.4.
  const Split s = split(counting_recordings(80000), options_of(Protocol::random));
  EXPECT_THAT(s.strides, ElementsAre(131, 130, 131));
}

TEST(SplitBlocked, KeepsARoleInOneStretchOfTime) {
  const Split s = split(counting_recordings(80000), options_of(Protocol::blocked));
  const WindowSet& c = s.sets[C];
  const auto indices = c.indices_of(2);
  const std::int64_t stride = s.strides[2];
  int jumps = 0;
  for (std::size_t i = 1; i < indices.size(); ++i) {
    jumps += c.first_sample[indices[i]] - c.first_sample[indices[i - 1]] == stride ? 0 : 1;
  }
  EXPECT_LE(jumps, 1);  // one if the block wraps at the end of the record
}

TEST(SplitBlocked, KeepsAWiderGuardIfRequested) {
  SplitOptions options = options_of(Protocol::blocked);
  options.guard_windows = 3;
  const Split s = split(counting_recordings(80000), options);
  for (const std::size_t one : {std::size_t{A}, std::size_t{C}}) {
    for (std::size_t other = one + 1; other < s.sets.size(); ++other) {
      for (std::size_t i = 0; i < s.sets[one].size(); ++i) {
        for (std::size_t j = 0; j < s.sets[other].size(); ++j) {
          if (s.sets[one].record[i] != s.sets[other].record[j]) continue;
          const auto apart =
              std::abs(s.sets[one].first_sample[i] - s.sets[other].first_sample[j]) - 1024;
          ASSERT_GE(apart, 3 * 1024);
        }
      }
    }
  }
}

/// Two roles of 10 windows, with a gap of one window length between them and after the last, need
/// 22 window lengths without overlap. A third role would need one more gap.
TEST(SplitBlocked, HasNoGapNextToAnEmptyRole) {
  SplitOptions options = options_of(Protocol::blocked);
  options.window = options.max_stride = 100;
  options.windows_per_class = 20;
  options.test_per_class = 10;
  options.known_per_class = 0;
  Recordings recordings = counting_recordings(1);
  recordings.records = {counting_record("I", 1, 0, 2200), counting_record("N", 0, 0, 2200),
                        counting_record("R", 2, 0, 2200)};
  EXPECT_THAT(split(recordings, options).strides, ElementsAre(100, 100, 100));
  options.test_per_class = 9;
  options.known_per_class = 1;
  EXPECT_LT(split(recordings, options).strides[1], 100);
}

TEST(SplitOptionsCheck, RefusesContradictions) {
  const Recordings recordings = counting_recordings(80000);
  const auto with = [&](const auto& change) {
    SplitOptions options;
    change(options);
    return split(recordings, options);
  };
  EXPECT_ERROR(with([](auto& o) { o.windows_per_class = 105; }), Exit::usage, "must exceed");
  EXPECT_ERROR(with([](auto& o) { o.test_per_class = 0; }), Exit::usage, "at least 1");
  EXPECT_ERROR(with([](auto& o) { o.max_stride = 0; }), Exit::usage, "at least 1");
  EXPECT_ERROR(with([](auto& o) { o.seed = -1; }), Exit::usage, "seed");
}

TEST(SplitDataset, NeedsAHealthyAndAFaultClass) {
  Recordings healthy = counting_recordings(80000);
  healthy.info.classes.resize(1);
  std::erase_if(healthy.records, [](const Record& r) { return r.label != 0; });
  EXPECT_ERROR(split(healthy, {}), Exit::bad_input, "has no fault class");
  Recordings faulty = counting_recordings(80000);
  faulty.info.classes[0].defect = Defect::outer;
  EXPECT_ERROR(split(faulty, {}), Exit::bad_input, "no class has defect 'none'");
}

}  // namespace
}  // namespace piae::signal
