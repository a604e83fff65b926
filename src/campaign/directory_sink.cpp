#include "directory_sink.hpp"

#include "breccia/io/text_file.hpp"
#include "breccia/results/comparison_file.hpp"
#include "breccia/results/curves.hpp"
#include "breccia/results/field_files.hpp"
#include "breccia/results/history_file.hpp"
#include "breccia/results/microstructure_files.hpp"
#include "breccia/results/provenance.hpp"
#include "breccia/results/response_file.hpp"
#include "breccia/results/stage_plot.hpp"

#include "first_process.hpp"

namespace breccia {

std::optional<Checkpoint> DirectorySink::packing_checkpoint(const Stage& stage) {
  write_once([&] { make_directory(directory_ / stage.name); });
  return checkpoints_.of_packing(stage);
}

std::optional<Checkpoint> DirectorySink::quasistatic_checkpoint(const Stage& stage, Boundary boundary, TestGrid grid) {
  return checkpoints_.of_quasistatic(stage, boundary, grid);
}

std::optional<Checkpoint> DirectorySink::dynamic_checkpoint(const Stage& stage, const TestId& test) {
  return checkpoints_.of_dynamic(stage, test);
}

void DirectorySink::packed(const Stage& stage, const StudyResult& result) {
  write_once([&] { write_microstructure(directory_ / stage.name, stage, result.stages.back().microstructure); });
}

void DirectorySink::domain_finished(const Stage& stage, const TestId& test, std::size_t number,
                                    const TimeDomain& domain) {
  write_once([&] { write_history(directory_ / stage.name, study_, stage, test, number, domain); });
}

std::optional<std::vector<FieldRecord>> DirectorySink::fields(const Stage& stage, const TestId& test,
                                                              const Discretisation<2>& discretisation,
                                                              const std::vector<TimedFields<2>>& fields) {
  std::vector<FieldRecord> records;
  write_once([&] { records = write_fields(directory_ / stage.name, study_, stage, test, discretisation, fields); });
  return records;
}

void DirectorySink::tested(const Stage& /*stage*/, const StudyResult& result) {
  write_once([&] {
    write_curves(directory_, result);
    write_provenance(directory_, study_, result);
  });
}

void DirectorySink::all_loads_tested(const Stage& stage, const StudyResult& result) {
  write_once([&] { write_responses(directory_ / stage.name, responses_of(study_, stage, result.stages.back())); });
}

void DirectorySink::stage_finished(const Stage& stage, const StudyResult& result) {
  write_once([&] {
    write_comparisons(directory_, result);
    write_provenance(directory_, study_, result);
    write_plots(directory_ / stage.name, study_, stage, result);
  });
}

void DirectorySink::take_over(const Stage& stage, const std::filesystem::path& files, const StudyResult& result) {
  write_once([&] {
    const auto directory = directory_ / stage.name;
    const auto& done = result.stages.back();
    make_directory(directory);
    write_microstructure(directory, stage, done.microstructure);
    write_responses(directory, responses_of(study_, stage, done));
    write_histories(directory, study_, stage, done.tests);
    copy_fields(files, directory, done.tests);
    write_curves(directory_, result);
  });
  stage_finished(stage, result);
}

}  // namespace breccia
