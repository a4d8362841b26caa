#include "augment/inference_cases.hpp"

namespace piae::augment {
namespace {

INSTANTIATE_TEST_SUITE_P(MethodsOfLibtorch, Inferring, testing::Values("piae-dt-cnn"), test_name);

}  // namespace
}  // namespace piae::augment
