#pragma once

#include <torch/types.h>

#include <string>

namespace piae::nets {

/// The device of `--device`: "cpu" or "cuda". Throws Error(usage) for another word, and for "cuda"
/// where LibTorch finds no such device. Also holds LibTorch to one thread and to deterministic
/// algorithms: parallelism comes from make and the scheduler, and results must not depend on it.
torch::Device prepare_device(const std::string& name);

}  // namespace piae::nets
