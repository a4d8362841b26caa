#include "plan/settings_files.hpp"

#include <set>

#include "base/error.hpp"
#include "text/file.hpp"

namespace piae::plan {

namespace fs = std::filesystem;

namespace {

void require_no_link(const fs::path& folder) {
  std::error_code none;
  if (!fs::is_symlink(folder, none)) return;
  throw Error(
      Exit::failed,
      folder.string() + ": is a link, and settings are not written through links; remove it");
}

}  // namespace

void write_settings(Plan& plan) {
  std::set<const Settings*> written;
  for (const StepId id : plan.to_run()) {
    const Step& step = plan.graph().at(id);
    for (const Settings* settings : {step.settings.get(), step.description.get()}) {
      if (settings == nullptr || !written.insert(settings).second) continue;
      const fs::path file = settings->file;
      fs::path folder = file;
      while (folder.filename() != ".settings") require_no_link(folder = folder.parent_path());
      text::save_if_changed({file, settings->text});
    }
  }
}

}  // namespace piae::plan
