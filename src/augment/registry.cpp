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
#include "twin/libtorch_backend.hpp"
#include "twin/native_backend.hpp"

namespace piae::augment {

namespace {

using Factory = std::unique_ptr<Method> (*)();

#ifdef PIAE_WITH_LIBTORCH
#define LIBTORCH(back_end) back_end
#else
#define LIBTORCH(back_end) nullptr
#endif

template <class M, class... Arguments>
std::unique_ptr<Method> make(Arguments... arguments) {
  return std::make_unique<M>(arguments...);
}

// How each back end computes.
constexpr Backends<MakeVae> vae{native_vae, LIBTORCH(libtorch_vae)};
constexpr Backends<MakeWganGp> wgan_gp{native_wgan_gp, LIBTORCH(libtorch_wgan_gp)};
constexpr Backends<OpenGenerator> generator{open_native_generator,
                                            LIBTORCH(open_generator_with_libtorch)};
constexpr Backends<twin::MakeEngine> dense{twin::native_engine, LIBTORCH(twin::libtorch_engine)};
constexpr Backends<twin::MakeEngine> layered{nullptr, LIBTORCH(twin::libtorch_engine)};

// The comments keep one on a line, as pipeline/grid.mk reads them.
const std::pair<const char*, Factory> registry[] = {
    {"dynamics", make<Dynamics>},                                       // paper 4.5.3
    {"smote", make<Smote>},                                             // 4.5.3
    {"vae", [] { return make<Vae>(vae, generator); }},                  // 4.5.3
    {"wgan-gp", [] { return make<WganGp>(wgan_gp, generator); }},       // 4.5.3
    {"piae-dt", [] { return make<PiaeDt>(twin::full_model, dense); }},  // the method
    {"ae", [] { return make<PiaeDt>(twin::without_physics, dense); }},  // 4.5.4, Model 2
    {"physics", make<Physics>},                                         // Model 3
    {"piae-dt-cnn", [] { return make<PiaeDt>(twin::convolutional_model, layered); }},  // Model 4
    {"piae-dt-rnn", [] { return make<PiaeDt>(twin::recurrent_model, layered); }},      // Model 5
    {"piae-dt-phase", [] { return make<PiaeDtPhase>(dense); }},                // ours: src/phase
    {"oversample", [] { return make<Repetition>(Repetition::Shift::none); }},  // honest company
    {"shift", [] { return make<Repetition>(Repetition::Shift::circular); }},   // honest company
    {"oracle", make<Oracle>},                                                  // a ceiling
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
