#include "results/provenance.hpp"

#include "results/study_document.hpp"
#include "results/study_entries.hpp"

namespace breccia {

void write_provenance(const std::filesystem::path& directory, const Study& study, const StudyResult& result,
                      const StageRecords& records) {
  write_study_document(directory, document_of(study, result, records));
}

}  // namespace breccia
