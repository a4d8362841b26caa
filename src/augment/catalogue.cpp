#include "augment/catalogue.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "augment/diffusion.hpp"
#include "augment/dynamics.hpp"
#include "augment/healthy_plus_impulses.hpp"
#include "augment/mixup.hpp"
#include "augment/oracle.hpp"
#include "augment/physics.hpp"
#include "augment/piae_dt.hpp"
#include "augment/piae_dt_phase.hpp"
#include "augment/piae_dt_zero.hpp"
#include "augment/playback.hpp"
#include "augment/repetition.hpp"
#include "augment/smote.hpp"
#include "augment/spectral.hpp"
#include "augment/strike_twin.hpp"
#include "augment/vae.hpp"
#include "augment/wgan_gp.hpp"
#include "base/error.hpp"

namespace piae::augment {

namespace {

using Shift = Repetition::Shift;
using Speed = Playback::Speed;
using Start = Smote::Start;
using Partner = Mixup::Partner;
using diffusion::Angle;
using diffusion::Path;
using From = Diffusion::From;

template <class M, auto... arguments>
std::unique_ptr<Method> make() {
  return std::make_unique<M>(arguments...);
}

constexpr CatalogueEntry entries[] = {
    {.name = "none", .kind = Kind::baseline, .what = "no generated windows"},
    {.name = "dynamics",
     .kind = Kind::published,
     .what = "a bearing simulated with nominal parameters",
     .make = make<Dynamics>,
     .needs = Needs::size},
    {.name = "smote",
     .kind = Kind::published,
     .what = "points between known windows",
     .make = make<Smote, Start::every>},
    {.name = "vae",
     .kind = Kind::published,
     .what = "a conditional variational auto-encoder",
     .make = make<Vae>,
     .trains = true},
    {.name = "wgan-gp",
     .kind = Kind::published,
     .what = "a conditional Wasserstein GAN",
     .make = make<WganGp>,
     .trains = true},
    {.name = "piae-dt",
     .kind = Kind::published,
     .what = "the full model",
     .make = make<PiaeDt, twin::full_model>,
     .model = 1,
     .infers = true,
     .trains = true,
     .needs = Needs::size},
    {.name = "ae",
     .kind = Kind::ablation,
     .what = "without the physics",
     .make = make<PiaeDt, twin::without_physics>,
     .model = 2,
     .infers = true,
     .trains = true,
     .needs = Needs::bearing},
    {.name = "physics",
     .kind = Kind::ablation,
     .what = "without the auto-encoder",
     .make = make<Physics>,
     .model = 3,
     .trains = true,
     .needs = Needs::size},
    {.name = "piae-dt-cnn",
     .kind = Kind::ablation,
     .what = "with a convolutional auto-encoder",
     .make = make<PiaeDt, twin::convolutional_model>,
     .model = 4,
     .infers = true,
     .trains = true,
     .needs = Needs::size},
    {.name = "piae-dt-rnn",
     .kind = Kind::ablation,
     .what = "with a recurrent auto-encoder",
     .make = make<PiaeDt, twin::recurrent_model>,
     .model = 5,
     .infers = true,
     .trains = true,
     .needs = Needs::size},
    {.name = "piae-dt-tcn",
     .kind = Kind::outlook,
     .what = "with a temporal convolutional auto-encoder",
     .make = make<PiaeDt, twin::temporal_model>,
     .infers = true,
     .trains = true,
     .needs = Needs::size},
    {.name = "piae-dt-transformer",
     .kind = Kind::outlook,
     .what = "with an auto-encoder of Transformer blocks",
     .make = make<PiaeDt, twin::transformer_model>,
     .infers = true,
     .trains = true,
     .needs = Needs::size},
    {.name = "piae-dt-phase",
     .kind = Kind::ours,
     .what = "the twin with the shaft angle as a coordinate of its space",
     .make = make<PiaeDtPhase>,
     .infers = true,
     .trains = true,
     .needs = Needs::size,
     .recommended = true},
    {.name = "strike-twin",
     .kind = Kind::ours,
     .what = "known windows with the impacts of the tested condition",
     .make = make<StrikeTwin>,
     .healthy = Healthy::optional,
     .carries = true,
     .needs = Needs::impact_rate},
    {.name = "piae-dt-zero",
     .kind = Kind::ours,
     .what = "healthy windows with impacts drawn from a prior of faults",
     .make = make<PiaeDtZero>,
     .healthy = Healthy::required,
     .without_known = true,
     .needs = Needs::impact_rate},
    {.name = "oversample",
     .kind = Kind::control,
     .what = "known windows repeated",
     .make = make<Repetition, Shift::none>},
    {.name = "shift",
     .kind = Kind::control,
     .what = "known windows, circularly shifted",
     .make = make<Repetition, Shift::circular>,
     .recommended = true},
    {.name = "mixup",
     .kind = Kind::control,
     .what = "weighted means of two known windows",
     .make = make<Mixup, Partner::as_known>},
    {.name = "aligned-mixup",
     .kind = Kind::control,
     .what = "the same after alignment by cross-correlation and with equal levels",
     .make = make<Mixup, Partner::aligned>},
    {.name = "spectral",
     .kind = Kind::control,
     .what = "known windows with random phases through random transfer paths",
     .make = make<Spectral>},
    {.name = "adasyn",
     .kind = Kind::control,
     .what = "smote, more often from windows near other classes",
     .make = make<Smote, Start::foreign_share>,
     .healthy = Healthy::required},
    {.name = "borderline-smote",
     .kind = Kind::control,
     .what = "smote, only from windows at the border to other classes",
     .make = make<Smote, Start::in_danger>,
     .healthy = Healthy::required},
    {.name = "resample",
     .kind = Kind::control,
     .what = "known windows played at the tested speed",
     .make = make<Playback, Speed::tested>},
    {.name = "randomise",
     .kind = Kind::control,
     .what = "known windows played at random speeds through random transfer paths",
     .make = make<Playback, Speed::random>},
    {.name = "healthy-plus-impulses",
     .kind = Kind::control,
     .what = "healthy windows with the impulses of one damped resonance",
     .make = make<HealthyPlusImpulses>,
     .healthy = Healthy::required,
     .without_known = true,
     .needs = Needs::impact_rate},
    {.name = "ddpm",
     .kind = Kind::control,
     .what = "a conditional denoising diffusion model",
     .make = make<Diffusion, Path::diffusion, From::known, Angle::known>,
     .trains = true},
    {.name = "ddpm-angle",
     .kind = Kind::control,
     .what = "the same, of known windows from random angles of their fault cycle",
     .make = make<Diffusion, Path::diffusion, From::known, Angle::drawn>,
     .trains = true,
     .needs = Needs::impact_rate},
    {.name = "ddpm-healthy",
     .kind = Kind::control,
     .what = "ddpm of healthy windows, and a second network of what a fault changes",
     .make = make<Diffusion, Path::diffusion, From::healthy, Angle::known>,
     .healthy = Healthy::required,
     .trains = true},
    {.name = "ddpm-healthy-angle",
     .kind = Kind::control,
     .what = "the same, of known windows from random angles",
     .make = make<Diffusion, Path::diffusion, From::healthy, Angle::drawn>,
     .healthy = Healthy::required,
     .trains = true,
     .needs = Needs::impact_rate},
    {.name = "flow",
     .kind = Kind::control,
     .what = "a conditional flow from noise to windows",
     .make = make<Diffusion, Path::flow, From::known, Angle::known>,
     .trains = true},
    {.name = "flow-angle",
     .kind = Kind::control,
     .what = "the same, of known windows from random angles",
     .make = make<Diffusion, Path::flow, From::known, Angle::drawn>,
     .trains = true,
     .needs = Needs::impact_rate},
    {.name = "oracle",
     .kind = Kind::ceiling,
     .what = "real windows instead of generated ones",
     .make = make<Oracle>},
};

}  // namespace

std::span<const CatalogueEntry> catalogue() { return entries; }

const CatalogueEntry* find_entry(const std::string& name) {
  const auto* const found = std::ranges::find(entries, name, &CatalogueEntry::name);
  return found == std::end(entries) ? nullptr : found;
}

const std::string& paper_method() {
  static const std::string name = std::ranges::find(entries, 1, &CatalogueEntry::model)->name;
  return name;
}

bool is_ablation(const CatalogueEntry& entry) {
  return entry.kind == Kind::ablation || entry.kind == Kind::outlook;
}

bool is_ceiling(const std::string& name) {
  const CatalogueEntry* const entry = find_entry(name);
  return entry != nullptr && entry->kind == Kind::ceiling;
}

bool works_without_known(const CatalogueEntry& entry) {
  return entry.without_known || entry.kind == Kind::ceiling;
}

std::vector<std::string> methods_without_known() {
  std::vector<std::string> names;
  for (const CatalogueEntry& entry : entries) {
    if (works_without_known(entry)) names.emplace_back(entry.name);
  }
  return names;
}

void require_known_windows(const CatalogueEntry& entry, const signal::WindowSet& known,
                           const std::string& file) {
  if (known.size() > 0 || works_without_known(entry)) return;
  throw Error(Exit::bad_input,
              fmt::format("{}: has no known fault windows (known-per-class = 0), but {} learns "
                          "from them; use a method that does not: {}",
                          file, entry.name, fmt::join(methods_without_known(), ", ")));
}

namespace {

/// Returns the missing fact about a class that such a method needs; empty if nothing is missing.
std::string lack(Needs needs, const signal::DatasetInfo& info, const signal::ClassInfo& c) {
  const bool causes_impacts = bearing::causes_impacts(c.defect);
  if (needs >= Needs::bearing && !info.has_bearing) return "the bearing geometry, table [bearing]";
  if (needs >= Needs::impact_rate && !causes_impacts) {
    return "the impact rate of class " + c.name + ", whose defect is 'other'";
  }
  if (needs >= Needs::size && c.defect_size_mm == 0) return "defect_size_mm of class " + c.name;
  return {};
}

std::string lack(Needs needs, const signal::DatasetInfo& info) {
  for (const Label label : info.fault_labels()) {
    std::string of_class = lack(needs, info, info.class_of(label));
    if (!of_class.empty()) return of_class;
  }
  return {};
}

}  // namespace

void require_described_faults(const CatalogueEntry& entry, const signal::DatasetInfo& info,
                              const std::string& file) {
  const std::string lacking = lack(entry.needs, info);
  if (lacking.empty()) return;
  std::vector<std::string> others;
  for (const CatalogueEntry& other : entries) {
    if (other.make != nullptr && lack(other.needs, info).empty()) others.emplace_back(other.name);
  }
  throw Error(
      Exit::bad_input,
      fmt::format("{}: {} needs {}, which the description of {} does not give; use a method "
                  "that does not need it: {}",
                  file, entry.name, lacking, info.name, fmt::join(others, ", ")));
}

std::string counted_faults(const signal::WindowSet& known) {
  if (known.size() == 0) return "no fault window";
  return fmt::format("{} windows of {} fault classes", known.size(), known.info.classes.size() - 1);
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const CatalogueEntry& entry : entries) {
    if (entry.make != nullptr) names.emplace_back(entry.name);
  }
  return names;
}

std::unique_ptr<Method> make_method(const std::string& name) {
  const CatalogueEntry* const entry = find_entry(name);
  if (entry != nullptr && entry->make != nullptr) return entry->make();
  const std::string known = fmt::format("{}", fmt::join(method_names(), ", "));
  if (name == no_method) {
    throw Error(Exit::usage,
                "--method: none generates no window and is not trained; known: " + known);
  }
  throw Error(Exit::usage, name.empty()
                               ? "--method is missing; known: " + known
                               : "--method: unknown method '" + name + "'; known: " + known);
}

}  // namespace piae::augment
