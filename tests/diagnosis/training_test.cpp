#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/training_cases.hpp"

namespace piae::diagnosis {
namespace {

INSTANTIATE_TEST_SUITE_P(OneCore, WdcnnTraining,
                         testing::Values(TrainedBy{"OneCore", make_one_core_backend}), name_of);

}  // namespace
}  // namespace piae::diagnosis
