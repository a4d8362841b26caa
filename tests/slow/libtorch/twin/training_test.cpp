#include "libtorch/twin/backend.hpp"
#include "twin/one_core_backend.hpp"
#include "twin/training_cases.hpp"

namespace piae::twin {
namespace {

const NamedVariant variants[] = {{"Full", full_model, libtorch::twin_engine},
                                 {"WithoutPhysics", without_physics, libtorch::twin_engine},
                                 {"Convolutional", convolutional_model, libtorch::twin_engine},
                                 {"Recurrent", recurrent_model, libtorch::twin_engine},
                                 {"Temporal", temporal_model, libtorch::twin_engine},
                                 {"Transformer", transformer_model, libtorch::twin_engine}};
INSTANTIATE_TEST_SUITE_P(Libtorch, TwinVariantTraining, testing::ValuesIn(variants), name_of);

TEST(TwinGenerationByLibtorch, RefusesAModelWithoutTheNetworksOfTheVariant) {
  for (const auto& [name, variant, engine] : variants) {
    if (variant.physics && variant.coder == CoderKind::dense) continue;
    const artefact::Reader model(
        train(checkpoint_at("v.ckpt"), quick_options(), "v.h5", variant, engine), "model");
    for (const MakeEngine other : {one_core_engine, libtorch::twin_engine}) {
      EXPECT_THROW(generate(model, full_model, 1, Stream("g"), other(Device::cpu)),
                   artefact::Refusal)
          << name;
    }
  }
}

}  // namespace
}  // namespace piae::twin
