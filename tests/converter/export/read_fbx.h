// A whole FBX file at once.
#pragma once

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "converter/read_back/fbx_records.h"
#include "converter/read_back/written_motion.h"
#include "files/temporary_folder.h"
#include "recording/coding/bytes.h"

namespace ribbon {

// What stands behind the last record, the first byte of which is at `begin` in the file.
inline void demand_fbx_end(std::string_view bytes, std::size_t begin) {
  ByteTaker taker(bytes);
  const auto demand_zeros = [&](std::size_t count) {
    demand(taker.take_bytes(count) == std::string(count, '\0'), "no zeros where some should be");
  };
  demand_zeros(13);      // the null record
  taker.take_bytes(16);  // an identifier
  demand_zeros(16 - (begin + 13 + 16) % 16 + 4);
  demand(taker.take<std::uint32_t>() == 7400, "another version at the end");
  demand_zeros(120);
  demand(taker.rest().size() == 16, "a wrong length");
}

// The file's records, nested in one without a name. Throws Spoiled, also where the end of the file
// is not as it should be.
inline ReadFbxRecord read_fbx(std::string_view bytes) {
  const auto path = temporary_file("read.fbx");
  std::ofstream(path, std::ios::binary) << bytes;
  const FbxFileRecords records(path);
  ReadFbxRecord root;
  std::size_t end = 27;
  records.for_each([&](const FbxSpan& span) {
    root.nested.push_back(records.read(span));
    end = span.end;
  });
  demand_fbx_end(bytes.substr(end), end);
  return root;
}

// All records in `parent` with a name whose last property is `kind`.
inline std::vector<const ReadFbxRecord*> all_in(const ReadFbxRecord& parent, std::string_view name,
                                                std::string_view kind) {
  std::vector<const ReadFbxRecord*> records;
  for (const ReadFbxRecord& record : parent.nested)
    if (record.name == name && record.text(record.properties.size() - 1) == kind)
      records.push_back(&record);
  return records;
}

}  // namespace ribbon
