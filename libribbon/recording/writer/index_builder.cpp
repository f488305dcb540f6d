#include "recording/writer/index_builder.h"

#include <utility>

#include "recording/records/record_head.h"

namespace ribbon {

IndexBuilder::IndexBuilder(std::vector<IndexLocation> indices, Index waiting)
    : indices_(std::move(indices)), waiting_(std::move(waiting)) {
  waiting_.previous = indices_.empty() ? 0 : indices_.back().offset;
}

std::string IndexBuilder::record(std::uint32_t recording_id) const {
  return make_record(RecordType::index, index_payload(recording_id, waiting_));
}

void IndexBuilder::written(std::uint64_t offset, std::uint32_t record_bytes) {
  indices_.push_back(location_of(waiting_, offset, record_bytes));
  waiting_ = {};
  waiting_.previous = offset;
}

}  // namespace ribbon
