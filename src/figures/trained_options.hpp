#pragma once

#include <toml++/toml.h>

#include <string>

#include "artefact/reader.hpp"

namespace piae::figures {

/// Returns the options that a model was trained with. The model stores them as TOML, each as text.
toml::table options_of_training(const artefact::Reader& model);

/// Returns 0.0005 even if a settings file has 0.00050000000000000001.
std::string shown_value(const std::string& value);

}  // namespace piae::figures
