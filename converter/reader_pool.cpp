#include "converter/reader_pool.h"

#include <utility>

namespace ribbon {

ReaderPool::ReaderPool(std::filesystem::path recording, RecordingReader first)
    : recording_(std::move(recording)) {
  idle_.push_back(std::move(first));
}

Result<RecordingReader> ReaderPool::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      RecordingReader reader = std::move(idle_.back());
      idle_.pop_back();
      return reader;
    }
  }
  return RecordingReader::open(recording_);
}

void ReaderPool::give_back(RecordingReader reader) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(reader));
}

std::vector<Damage> ReaderPool::damage() {
  const std::lock_guard lock(mutex_);
  std::vector<Damage> most;  // one that has met damage has scanned the whole file for more
  for (const RecordingReader& reader : idle_)
    if (reader.damage().size() > most.size()) most = reader.damage();
  return most;
}

}  // namespace ribbon
