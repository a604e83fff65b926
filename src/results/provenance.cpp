#include "breccia/results/provenance.hpp"

#include "study_document.hpp"
#include "study_entries.hpp"

namespace breccia {

void write_provenance(const std::filesystem::path& directory, const Study& study, const StudyResult& result,
                      const StageRecords& records) {
  write_study_document(directory, document_of(study, result, records));
}

}  // namespace breccia
