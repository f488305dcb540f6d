// Which pictures of a sequence are complete, kept in a text file beside them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "commandline/frame_pattern.h"
#include "files/descriptor.h"
#include "player/output/play_order.h"
#include "result/result.h"

namespace ribbon {

// What makes a picture what it is, in words of one line: the recording, the program, the settings.
// Pictures made of others are rendered anew.
using MadeOf = std::string;

// Each shard appends to a file of its own and reads those of all. There are no locks, which not
// every network file system keeps: no picture belongs to two shards. A line is on the disk before
// its picture gets its name, so that a picture without a line is never one of ours.
class Manifest {
 public:
  // Reads what is there. Fails where the file of this shard is there and cannot be written; it
  // begins with the first picture, so that a job that is refused before leaves none behind.
  static Result<Manifest> open(const FramePattern& pattern, const MadeOf& made_of,
                               const Shard& shard);

  // Is picture `number` there, with the bytes that it was written with, shows this frame, or
  // what lies between two, and was made of the same?
  [[nodiscard]] bool is_complete(int number, double frame) const;
  // Was a picture written under its name at all? Then it may be replaced.
  [[nodiscard]] bool is_known(int number) const {
    return pictures_.contains(pattern_.digits_of(number));
  }

  // Tells what is about to be written as picture `number`.
  Result<void> note(int number, double frame, std::string_view bytes);

 private:
  struct Entry {
    double frame = 0;
    std::uint64_t bytes = 0;
    std::uint32_t checksum = 0;
    bool is_current = false;  // made of what is asked for now
  };

  Manifest(FramePattern pattern, MadeOf made_of);
  void read(std::string_view text);
  void read_picture(std::string_view line, bool is_current);
  Result<void> begin();
  Result<void> append(const std::string& line);

  FramePattern pattern_;
  MadeOf made_of_;
  std::filesystem::path path_;
  FileDescriptor file_;
  bool is_begun_ = false;  // what is made now is told
  // By the digits in their names, of which other patterns have more or fewer; of several lines the
  // last, but current ones win.
  std::map<std::string, Entry, std::less<>> pictures_;
};

}  // namespace ribbon
