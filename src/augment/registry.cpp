#include <utility>

#include "augment/dynamics.hpp"
#include "augment/method.hpp"
#include "augment/oracle.hpp"
#include "augment/physics.hpp"
#include "augment/piae_dt.hpp"
#include "augment/piae_dt_phase.hpp"
#include "augment/repetition.hpp"
#include "augment/smote.hpp"
#include "augment/vae.hpp"
#include "augment/wgan_gp.hpp"
#include "base/error.hpp"

namespace piae::augment {

namespace {

using Factory = std::unique_ptr<Method> (*)();

#ifdef PIAE_WITH_LIBTORCH
constexpr bool has_libtorch = true;
#else
constexpr bool has_libtorch = false;
#endif

/// A method of class M, made of these arguments.
template <class M, auto... arguments>
std::unique_ptr<Method> make() {
  if constexpr (has_libtorch || !M::needs_libtorch) return std::make_unique<M>(arguments...);
  return nullptr;
}

// The comments keep one on a line, as pipeline/grid.mk reads them.
const std::pair<const char*, Factory> registry[] = {
    {"dynamics", make<Dynamics>},                               // paper 4.5.3
    {"smote", make<Smote>},                                     // 4.5.3
    {"vae", make<Vae>},                                         // 4.5.3
    {"wgan-gp", make<WganGp>},                                  // 4.5.3
    {"piae-dt", make<PiaeDt, twin::full_model>},                // the method; Model 1 of 4.5.4
    {"ae", make<PiaeDt, twin::without_physics>},                // Model 2
    {"physics", make<Physics>},                                 // Model 3
    {"piae-dt-cnn", make<PiaeDt, twin::convolutional_model>},   // Model 4
    {"piae-dt-rnn", make<PiaeDt, twin::recurrent_model>},       // Model 5
    {"piae-dt-phase", make<PiaeDtPhase>},                       // ours: src/phase
    {"oversample", make<Repetition, Repetition::Shift::none>},  // honest company
    {"shift", make<Repetition, Repetition::Shift::circular>},   // honest company
    {"oracle", make<Oracle>},                                   // a ceiling, not a method
};

}  // namespace

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const auto& [name, factory] : registry) names.emplace_back(name);
  return names;
}

std::unique_ptr<Method> make_method(const std::string& name) {
  std::string known;
  for (const auto& [each, factory] : registry) {
    if (name == each) return factory();
    known += std::string(known.empty() ? "" : ", ") + each;
  }
  throw Error(Exit::usage, name.empty()
                               ? "--method is missing; known are " + known
                               : "--method: unknown method '" + name + "'; known are " + known);
}

}  // namespace piae::augment
