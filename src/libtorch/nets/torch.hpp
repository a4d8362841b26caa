#pragma once

// What we use of LibTorch: tensors, their derivatives, threads and devices. <torch/torch.h>, which
// has modules, data loaders and more, takes twice as long to compile.
#include <torch/csrc/autograd/autograd.h>
#include <torch/cuda.h>
#include <torch/types.h>
#include <torch/utils.h>
