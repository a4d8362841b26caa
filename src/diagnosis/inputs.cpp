#include "diagnosis/inputs.hpp"

#include "signal/roles.hpp"

namespace piae::diagnosis {

namespace {

signal::RoleSet read_role(const artefact::Reader& reader, signal::Role role) {
  signal::require_role(reader, role);
  return signal::read_role_set(reader);
}

}  // namespace

Inputs read_inputs(const artefact::Reader& test, const artefact::Reader& normal,
                   const artefact::Reader& known, const artefact::Reader* generated,
                   const artefact::Reader* unlabelled) {
  std::vector<signal::RoleSet> split{read_role(test, signal::Role::test),
                                     read_role(normal, signal::Role::healthy),
                                     read_role(known, signal::Role::known)};
  if (unlabelled != nullptr) split.push_back(read_role(*unlabelled, signal::Role::hidden));
  signal::require_one_split(split);
  Inputs inputs;
  inputs.protocol = split[0].protocol;
  if (generated != nullptr) {
    signal::require_role(*generated, signal::Role::generated);
    signal::require_learned_from(*generated, known);
    inputs.generated = signal::read_window_set(*generated);
    inputs.method = signal::read_method(*generated);
  }
  inputs.test = std::move(split[0].windows);
  inputs.normal = std::move(split[1].windows);
  inputs.known = std::move(split[2].windows);
  if (unlabelled != nullptr) inputs.unlabelled = std::move(split[3].windows);
  return inputs;
}

void bind(cli::Stage& stage, InputFiles& files) {
  stage.input_file("--test", files.test, "test windows, A.h5 of split");
  stage.input_file("--normal", files.normal, "healthy windows, B.h5 of split");
  stage.input_file("--known", files.known, "known fault windows, C.h5 of split");
  stage
      .input_file("--generated", files.generated,
                  "generated windows, E.h5 of generate; not with 100to1")
      .required(false);
  stage
      .input_file("--unlabelled", files.unlabelled,
                  "windows of the tested condition, D.h5 of split, whose labels are not used; only "
                  "for dann and cdan")
      .required(false);
}

Inputs read_inputs(cli::Stage& stage, const InputFiles& files) {
  const artefact::Reader test = stage.open("test", files.test, "windows");
  const artefact::Reader normal = stage.open("normal", files.normal, "windows");
  const artefact::Reader known = stage.open("known", files.known, "windows");
  const auto open = [&](const std::string& role, const std::filesystem::path& file) {
    return file.empty() ? std::nullopt : std::optional(stage.open(role, file, "windows"));
  };
  const auto generated = open("generated", files.generated);
  const auto unlabelled = open("unlabelled", files.unlabelled);
  return read_inputs(test, normal, known, generated ? &*generated : nullptr,
                     unlabelled ? &*unlabelled : nullptr);
}

}  // namespace piae::diagnosis
