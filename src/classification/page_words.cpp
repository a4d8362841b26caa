#include "classification/page_words.hpp"

#include <spdlog/fmt/fmt.h>

#include <stdexcept>

#include "bearing/defect.hpp"

namespace piae::classification {

namespace {

using signal::DatasetInfo;
using signal::Defect;

Defect predicted_defect(const Verdict& verdict, const DatasetInfo& info) {
  return verdict.unknown ? Defect::none : info.class_of(verdict.label).defect;
}

/// True if the verdict names a fault of the bearing whose place has a line.
bool names_a_line(const Verdict& verdict, const DatasetInfo& info) {
  return info.has_bearing && bearing::causes_impacts(predicted_defect(verdict, info));
}

/// Returns text such as "BPFI (162.2 Hz, 5.42 orders)".
std::string named_line(const LineEvidence& found, double shaft_hz) {
  return fmt::format("{} ({:.1f} Hz, {:.2f} orders)", inspection::line_name(found.line.fault_type),
                     found.found_hz, found.found_hz / shaft_hz);
}

std::string harmonics_sentence(const LineEvidence& found) {
  const auto one = [&](int number) {
    return fmt::format(
        "{} {} ({:+.1f} dB)", number,
        found.has_harmonic(number) ? "is present" : "is not above the limit of noise",
        found.harmonics_db.at(static_cast<std::size_t>(number - 1)));
  };
  return fmt::format("Harmonic {}; harmonic {}.", one(2), one(3));
}

/// Empty for a line that is not modulated.
std::string side_bands_sentence(const LineEvidence& found) {
  if (!found.side_bands) return "";
  const SideBands& bands = *found.side_bands;
  const bool inner = found.line.fault_type == Defect::inner;
  const std::string rate = inner ? "shaft speed" : "cage speed";
  const std::string heights = fmt::format("\u00b1{:.2f} Hz: {:+.1f} dB below, {:+.1f} dB above",
                                          bands.spacing_hz, bands.below_db, bands.above_db);
  if (bands.present() == 0) {
    return fmt::format(
        "Side bands at the {} are not above the limit of noise ({}), so amplitude modulation by "
        "the load zone is not visible.",
        rate, heights);
  }
  return fmt::format(
      "{} at the {} ({}): amplitude modulation, because the fault passes the load zone once a turn "
      "of the {}.",
      bands.present() == 2 ? "Side bands are present" : "One side band is present", rate, heights,
      inner ? "shaft" : "cage");
}

const LineEvidence& evidence_for(const std::array<LineEvidence, 3>& evidence, Defect fault_type) {
  for (const LineEvidence& each : evidence) {
    if (each.line.fault_type == fault_type) return each;
  }
  throw std::logic_error("only defects of the bearing have a line");
}

/// Returns a sentence about the line that stands out farthest; empty without one.
std::string farthest_sentence(const Verdict& verdict, const std::array<LineEvidence, 3>& evidence) {
  const inspection::FaultLine* const farthest = inspection::farthest(verdict.lines);
  if (farthest == nullptr) return "";
  return fmt::format("The line of the {} stands out: {}, {:+.1f} dB above the floor.",
                     place_of(farthest->fault_type),
                     named_line(evidence_for(evidence, farthest->fault_type),
                                verdict.recording.shaft_speed_rpm / 60),
                     farthest->db.value_or(0));
}

std::vector<std::string> reasons_for_fault(const Verdict& verdict, Defect named,
                                           const std::array<LineEvidence, 3>& evidence) {
  const LineEvidence& own = evidence_for(evidence, named);
  if (!own.line.db) {
    return {
        fmt::format("The recording is too short to measure {}: the verdict rests on the "
                    "classifier alone.",
                    inspection::line_name(named))};
  }
  const std::string line = named_line(own, verdict.recording.shaft_speed_rpm / 60);
  if (own.line.stands_out) {
    std::vector<std::string> reasons{
        fmt::format("The envelope (demodulated) spectrum supports the verdict. The characteristic "
                    "frequency of the {}, {}, stands {:.1f} dB above the floor, as a mean over the "
                    "line and its harmonics 2 and 3.",
                    place_of(named), line, *own.line.db),
        harmonics_sentence(own)};
    const std::string bands = side_bands_sentence(own);
    if (!bands.empty()) reasons.push_back(bands);
    return reasons;
  }
  const std::string other = farthest_sentence(verdict, evidence);
  return {
      fmt::format("The envelope (demodulated) spectrum does not support the verdict. The "
                  "characteristic frequency of the {}, {}, is only {:+.1f} dB above the floor. {}",
                  place_of(named), line, *own.line.db,
                  other.empty() ? "No other line stands out, either." : other)};
}

}  // namespace

std::string place_of(Defect fault_type) {
  switch (fault_type) {
    case Defect::outer:
      return "outer race";
    case Defect::inner:
      return "inner race";
    case Defect::roller:
      return "ball";
    case Defect::none:
    case Defect::other:
      break;
  }
  throw std::logic_error("only defects of the bearing have a place");
}

std::string verdict_heading(const Verdict& verdict, const DatasetInfo& info) {
  if (verdict.unknown) return "Unknown: most windows resemble no trained class";
  const signal::ClassInfo& named = info.class_of(verdict.label);
  if (named.defect == Defect::none) return fmt::format("No fault (class {})", named.name);
  if (named.defect == Defect::other) return fmt::format("Fault (class {})", named.name);
  return fmt::format("Fault of the {} (class {})", place_of(named.defect), named.name);
}

std::string certainty_sentences(const Verdict& verdict, bool is_calibrated) {
  const std::string unknown =
      verdict.can_refuse ? fmt::format("{:.0f} % of the windows differ from all trained classes.",
                                       100 * verdict.share_unknown)
                         : "Unknown faults are not detected.";
  if (verdict.unknown) {
    return unknown + " Possible causes: another fault, another machine or load, a loose sensor.";
  }
  return fmt::format(
      "Probability {:.0f} % ({}), a mean over {} windows. {:.0f} % of the windows "
      "agree. {}",
      100 * verdict.probability, is_calibrated ? "calibrated" : "not calibrated",
      verdict.start_s.size(), 100 * verdict.share, unknown);
}

std::vector<std::string> reasons_of(const Verdict& verdict, const DatasetInfo& info,
                                    const std::array<LineEvidence, 3>& evidence) {
  if (!info.has_bearing) {
    return {
        "The bearing is not described, so its characteristic frequencies are not known: the "
        "verdict rests on the classifier alone."};
  }
  const Defect named = predicted_defect(verdict, info);
  if (bearing::causes_impacts(named)) return reasons_for_fault(verdict, named, evidence);
  const std::string other = farthest_sentence(verdict, evidence);
  if (other.empty()) {
    return {
        "No characteristic bearing frequency stands out of the envelope (demodulated) "
        "spectrum."};
  }
  const bool is_healthy = !verdict.unknown && named == Defect::none;
  return {other + (is_healthy ? " This contradicts the verdict." : "")};
}

std::vector<std::string> next_steps_of(const Verdict& verdict, const DatasetInfo& info) {
  const bool any_line = inspection::farthest(verdict.lines) != nullptr;
  if (verdict.unknown) {
    return {
        "Check the sensor's mounting, the cable and the given speed, and repeat the "
        "measurement.",
        "Compare the spectra with those of a healthy record. New multiples of the shaft speed "
        "point to imbalance, misalignment or looseness; new lines with side bands point to a "
        "bearing or a gear.",
        "If the change stays, plan an inspection."};
  }
  if (names_a_line(verdict, info)) {
    const inspection::FaultLine& own =
        inspection::line_of(verdict.lines, predicted_defect(verdict, info));
    if (own.stands_out) {
      return {
          "Compare the envelope spectrum with that of a healthy record at the same speed and "
          "load: the line must be missing there.",
          "Repeat the measurement at the same point. At another speed the line must keep its "
          "order.",
          "Plan an inspection of the bearing, and follow the trend at shorter intervals until "
          "then."};
    }
    return {
        "Check the given speed and the dimensions of the bearing, which decide where its lines "
        "are.",
        "Repeat the measurement: longer, at a steady speed, with the sensor close to the "
        "bearing.",
        "Compare with a healthy record. Do not open the machine because of this verdict alone."};
  }
  if (info.class_of(verdict.label).defect == Defect::none) {
    if (any_line) {
      return {
          "Repeat the measurement, and compare the envelope spectrum with that of a healthy "
          "record.",
          "If the line stays, follow its trend at shorter intervals."};
    }
    return {"Keep this recording as a baseline for this speed and load.",
            "Continue to measure at the usual interval."};
  }
  return {
      "Compare the spectra with those of a healthy record: harmonics of the shaft speed show "
      "imbalance, misalignment and looseness.",
      "Repeat the measurement, also in other directions.",
      "If the change stays, plan an inspection."};
}

}  // namespace piae::classification
