#include "cli/stage.hpp"

#include <fcntl.h>
#include <malloc.h>
#include <spdlog/fmt/ranges.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <new>

#include "artefact/journal.hpp"
#include "base/error.hpp"
#include "base/one_line.hpp"
#include "base/sha256.hpp"
#include "cli/toml_config.hpp"
#include "cli/usage.hpp"

namespace piae::cli {

namespace {

const std::string files_group = "Files";

/// Keeps up to 256 MB of freed memory. Matrices of some MB come and go, and each new page would
/// cost a system call.
void keep_freed_memory() {
  ::mallopt(M_MMAP_THRESHOLD, 32 << 20);
  ::mallopt(M_TRIM_THRESHOLD, 256 << 20);
}

void log_to_stderr(const std::string& name) {
  if (spdlog::get(name)) return;
  spdlog::set_default_logger(spdlog::stderr_color_mt(name));
  spdlog::set_pattern("%n: %v");
}

/// Drops the second line that some messages of CLI11 have.
std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Describes the problem in a file of options. CLI11 calls every such file an INI file.
std::string about_config(const std::string& file, const std::string& text) {
  const std::string theirs = "INI was not able to parse ";
  if (text.starts_with(theirs)) return file + ": unknown option " + text.substr(theirs.size());
  return file + (text.starts_with("line ") ? ", " : ": ") + text;
}

/// True if a line begins with the name of a file, such as a recording of a description, or with
/// that of the stream, as monitor names it.
bool names_its_file(const std::string& line) {
  if (line.starts_with("standard input: ") || line.starts_with("standard input, line "))
    return true;
  return std::ranges::any_of(std::array{": ", ", line ", " (record "}, [&](const char* behind) {
    std::error_code ignored;
    const std::size_t end = line.find(behind);
    return end != std::string::npos && std::filesystem::exists(line.substr(0, end), ignored);
  });
}

/// Refuses a pipe, because reading it may block.
std::string require_file(const std::string& path) {
  std::error_code ignored;
  const auto there = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(there) || std::filesystem::is_regular_file(there)) return {};
  throw CLI::FileError(path + ": is not a file");
}

CLI::Option* add_config(CLI::App& app, const std::string& help) {
  return app.set_config("--config", "", help)->check(CLI::Validator(require_file, ""));
}

/// Returns what is wrong with the file of a given --config; empty if it can be read. From 2.5 on
/// CLI11 reports a missing option before a missing file, although the file may hold the option.
std::string refusal_of_config(const CLI::App& app) {
  const std::vector<std::string> given = app.get_config_ptr()->results();
  if (given.empty()) return {};
  const std::string& path = given.front();
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path, ignored)) return {};
  return std::filesystem::exists(path, ignored) ? path + ": is not a file"
                                                : path + " was not readable (missing?)";
}

/// Keeps the lines of the footer as they are: from 2.5 on CLI11 joins and breaks them.
template <class Formatter>
void keep_footer(Formatter& formatter) {
  if constexpr (requires { formatter.enable_footer_formatting(false); }) {
    formatter.enable_footer_formatting(false);
  }
}

int fail(const std::string& name, Exit exit, const std::string& line) {
  std::cerr << name << ": " << one_line(line) << '\n';
  return static_cast<int>(exit);
}

/// True unless the caller has closed standard output, because it does not want what is printed.
bool is_output_wanted() { return ::fcntl(STDOUT_FILENO, F_GETFD) != -1; }

/// Returns the exit code of a program that has done its work. What it printed must have been
/// written, too: a caller would take a part of it for the whole.
int ended_well(const std::string& name, bool is_output_wanted) {
  if (std::cout.flush() || !is_output_wanted) return static_cast<int>(Exit::done);
  return fail(name, Exit::failed,
              "standard output: cannot be written completely; is the disk full?");
}

/// Reports the start and the resources used if this stage is a step of a run (pipeline/step.sh). On
/// a cluster it may start long after it was submitted.
class UsageForStep {
 public:
  UsageForStep() {
    if (requested()) std::cerr << "step: started\n";
  }
  UsageForStep(const UsageForStep&) = delete;
  UsageForStep& operator=(const UsageForStep&) = delete;
  ~UsageForStep() {
    if (!requested()) return;
    std::cout.flush();  // the stage's own line comes first
    std::cerr << usage_line() + '\n';
  }

 private:
  static bool requested() { return std::getenv("PIAE_STEP") != nullptr; }
};

}  // namespace

void release_freed_memory() { ::mallopt(M_MMAP_THRESHOLD, 1 << 20); }

Stage::Stage(std::string name, const std::string& summary, const std::string& example)
    : name_(std::move(name)), app_(std::make_unique<CLI::App>(summary, name_)) {
  app_->footer("Example:\n  " + example +
               "\n\nExit codes: 0 done, 1 failed, 2 usage, 65 bad input data, 66 input missing,\n"
               "75 interrupted after a checkpoint (run the same command again)\n");
  app_->option_defaults()->always_capture_default();
  app_->get_formatter()->column_width(38);
  keep_footer(*app_->get_formatter());
  app_->set_version_flag("--version", "piae-dt " + name_ + " " + artefact::build_version(),
                         "Print the version and exit")
      ->configurable(false);
  add_config(*app_, "TOML file to read options from, table [" + name_ + "]")->group(files_group);
  app_->config_formatter(std::make_shared<TomlConfig>(name_, ""));
  app_->allow_config_extras(CLI::config_extras_mode::error);
}

Stage::~Stage() = default;

Option Stage::input_file(const std::string& option, std::filesystem::path& path,
                         const std::string& help) {
  return options().in_group(files_group).add(option, path, help).required().type_name("FILE");
}

Option Stage::output_file(const std::string& option, std::filesystem::path& path,
                          const std::string& help) {
  return options().in_group(files_group).add(option, path, help).required().type_name("PATH");
}

Option Stage::file_flag(const std::string& option, bool& value, const std::string& help) {
  return options().in_group(files_group).flag(option, value, help);
}

void Stage::record_unless_default(const std::string& option) {
  recorded_unless_default_.push_back(app_->get_option(option)->get_lnames().front());
}

std::string Stage::choose_variant(int argc, char** argv, const std::string& option) {
  CLI::App first;
  first.set_help_flag();
  first.allow_extras();
  first.allow_config_extras(CLI::config_extras_mode::ignore_all);
  std::string variant;
  first.add_option(option, variant);
  add_config(first, "");
  first.config_formatter(std::make_shared<TomlConfig>(name_, ""));
  try {
    first.parse(argc, argv);
  } catch (const CLI::Error&) {
    return {};  // run() meets the same error and reports it
  }
  app_->config_formatter(std::make_shared<TomlConfig>(name_, variant));
  return variant;
}

int Stage::run(int argc, char** argv, const std::function<void()>& body) {
  keep_freed_memory();
  log_to_stderr(name_);
  const UsageForStep usage;
  const bool prints = is_output_wanted();
  try {
    app_->parse(argc, argv);
    body();
    return ended_well(name_, prints);
  } catch (const CLI::CallForHelp&) {
    std::cout << app_->help();
    return ended_well(name_, prints);
  } catch (const CLI::CallForVersion&) {
    std::cout << app_->version() << '\n';
    return ended_well(name_, prints);
  } catch (const CLI::FileError& error) {
    return fail(name_, Exit::input_missing, first_line(error.what()));
  } catch (const CLI::ConfigError& error) {
    return fail(name_, Exit::usage,
                about_config(app_->get_config_ptr()->as<std::string>(), first_line(error.what())) +
                    " (see " + name_ + " --help)");
  } catch (const CLI::Error& error) {
    const std::string refusal = refusal_of_config(*app_);
    if (!refusal.empty()) return fail(name_, Exit::input_missing, refusal);
    return fail(name_, Exit::usage, first_line(error.what()) + " (see " + name_ + " --help)");
  } catch (const Error& error) {
    return fail(name_, error.exit(), with_input_names(error));
  } catch (const std::bad_alloc&) {
    return fail(name_, Exit::failed, "out of memory");
  } catch (const std::exception& error) {
    return fail(name_, Exit::failed, first_line(error.what()));
  }
}

std::string Stage::with_input_names(const Error& error) const {
  std::string line = error.what();
  if (names_its_file(line)) return line;
  std::string names;
  for (const std::filesystem::path& path : input_paths_) {
    if (line.find(path.string()) != std::string::npos) return line;
    names += (names.empty() ? "" : ", ") + path.string();
  }
  const bool is_about_content = error.exit() == Exit::bad_input && !names.empty();
  return is_about_content ? names + ": " + line : line;
}

artefact::Reader Stage::open(const std::string& role, const std::filesystem::path& path,
                             const std::string& kind) {
  artefact::Reader reader(path, kind);
  inputs_.push_back({role, path.filename().string(), reader.digest()});
  input_paths_.push_back(path);
  note_read(path);
  return reader;
}

void Stage::note_input(const std::string& role, const std::filesystem::path& path) {
  inputs_.push_back({role, path.filename().string(), sha256_of_file(path)});
  input_paths_.push_back(path);
  note_read(path);
}

void Stage::note_input(const std::string& role, const std::string& name,
                       const std::string& digest) {
  if (named_inputs_.emplace(role, name).second) inputs_.push_back({role, name, digest});
}

void Stage::note_read(const std::filesystem::path& path) { read_paths_.push_back(path); }

artefact::Provenance Stage::provenance() const { return {name_, resolved_options(), inputs_}; }

void Stage::require_no_input(const std::filesystem::path& path) const {
  for (const std::filesystem::path& input : read_paths_) {
    std::error_code none_there;
    if (std::filesystem::equivalent(input, path, none_there)) {
      throw Error(Exit::usage, path.string() + ": is an input; choose another output");
    }
  }
}

void Stage::require_free(std::vector<std::filesystem::path> outputs) const {
  std::erase(outputs, std::filesystem::path());
  for (std::filesystem::path& path : outputs) {
    require_no_input(path);
    path = std::filesystem::absolute(path).lexically_normal();
  }
  std::ranges::sort(outputs);
  const auto twice = std::ranges::adjacent_find(outputs);
  if (twice == outputs.end()) return;
  throw Error(Exit::usage,
              twice->string() + ": is named by two options; choose another file for one");
}

void Stage::save(artefact::Writer& writer, const std::filesystem::path& path) const {
  require_no_input(path);
  const artefact::Written written = writer.save(path, provenance());
  const char* const run = std::getenv("PIAE_RUN");
  if (run != nullptr) artefact::add_to_journal(run, path, written, provenance());
}

std::string Stage::resolved_options() const {
  std::string text;
  for (const CLI::Option* option : app_->get_options()) {
    const bool asks = option == app_->get_help_ptr() || option == app_->get_version_ptr();
    if (asks || option->get_lnames().empty() || option->get_group() == files_group) continue;
    std::string value = option->get_default_str();
    if (option->count() > 0) {
      value = fmt::format("{}", fmt::join(option->reduced_results(), ", "));
    }
    if (value == option->get_default_str() &&
        std::ranges::count(recorded_unless_default_, option->get_lnames().front()) > 0) {
      continue;
    }
    text += option->get_lnames().front() + " = \"" + value + "\"\n";
  }
  return text;
}

}  // namespace piae::cli
