#include "results/provenance.hpp"

#include "results/study_entries.hpp"

namespace breccia {

StudyDocument write_provenance(const std::filesystem::path& directory, const Study& study, const StudyResult& result,
                               const StageRecords& records) {
  auto document = document_of(study, result, records);
  write_study_document(directory, document);
  return document;
}

}  // namespace breccia
