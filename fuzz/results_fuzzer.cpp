// Files of results that a later command reads: study.json, sweep.json and curves.csv. Files in HDF5 are left out: the
// library itself, 1.10 of Debian 12, is known to crash on hostile files, so that its input must be checked before.

#include "campaign/result_transaction.hpp"
#include "input_folder.hpp"
#include "page/study_report.hpp"
#include "page/sweep_report.hpp"
#include "refusal.hpp"
#include "results/sweep_result.hpp"
#include "study/identity.hpp"

namespace {

using namespace breccia;

void read_json(const fuzz::InputFolder& folder, std::string_view text) {
  folder.write("study.json", text);
  folder.write("sweep.json", text);
  Study study;
  study.provenance.hash = "0123456789abcdef";
  study.provenance.content = content_of(study);
  fuzz::allow_refusal([&] { static_cast<void>(ResultTransaction(study, folder.path(), {}).take_over()); });
  fuzz::allow_refusal([&] { static_cast<void>(study_page_data(folder.path())); });
  fuzz::allow_refusal([&] { static_cast<void>(sweep_page_data(folder.path())); });
}

void read_table(const fuzz::InputFolder& folder, std::string_view text) {
  folder.write("curves.csv", text);
  fuzz::allow_refusal([&] {
    const auto shown =
        last_stage_of({{.state = TaskState::done, .curves = read_task_curves(folder.path(), Abscissa::frequency)}});
    for (const auto& curve : shown.front().curves) static_cast<void>(name_of(curve.test.boundary));
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {  // NOLINT(*-naming)
  static const fuzz::InputFolder folder;
  const auto text = fuzz::text_of(data, size);
  if (text.starts_with('{')) {
    read_json(folder, text);
  } else {
    read_table(folder, text);
  }
  return 0;
}
