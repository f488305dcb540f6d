// Gathers what the index records of a recording tell, while it is written.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "recording/records/directory_record.h"
#include "recording/records/index_record.h"

namespace ribbon {

class IndexBuilder {
 public:
  // indices: those that the file has. waiting: what lies in the file and in none of them.
  explicit IndexBuilder(std::vector<IndexLocation> indices = {}, Index waiting = {});

  void add(const IndexedFrame& frame) { waiting_.frames.push_back(frame); }
  void add(const IndexedOther& other) { waiting_.others.push_back(other); }

  // Is it time for an index record?
  [[nodiscard]] bool is_due() const { return waiting_.frames.size() >= frames_in_index; }
  [[nodiscard]] bool is_waiting() const {
    return !waiting_.frames.empty() || !waiting_.others.empty();
  }

  // The record that tells of all that waits, and, once it has been written at `offset`, that it is
  // there.
  [[nodiscard]] std::string record(std::uint32_t recording_id) const;
  void written(std::uint64_t offset, std::uint32_t record_bytes);

  [[nodiscard]] const std::vector<IndexLocation>& indices() const { return indices_; }

 private:
  std::vector<IndexLocation> indices_;
  Index waiting_;
};

}  // namespace ribbon
