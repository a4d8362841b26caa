#pragma once

// The parts of LibTorch that we use: tensors, their derivatives, threads and devices.
// <torch/torch.h> would add modules, data loaders and more, and compile twice as long.
#include <torch/csrc/autograd/autograd.h>
#include <torch/cuda.h>
#include <torch/types.h>
#include <torch/utils.h>
