#include "player/output/background_sink.h"

#include <utility>

#include "result/caught.h"

namespace ribbon {

namespace {

// One that is rendered, these, and one that is written are in memory at the same time.
constexpr std::size_t most_waiting = 2;

}  // namespace

BackgroundSink::BackgroundSink(std::unique_ptr<PictureSink> sink)
    : sink_(std::move(sink)), thread_([this] { run(); }) {}

BackgroundSink::~BackgroundSink() {
  end();
}

Result<void> BackgroundSink::put(OutputPicture picture) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return waiting_.size() < most_waiting || !problem_; });
  if (!problem_) return problem_;
  waiting_.push_back(std::move(picture));
  changed_.notify_all();
  return {};
}

Result<void> BackgroundSink::finish() {
  end();
  if (!problem_) return problem_;
  return sink_->finish();
}

// Until end() is called and nothing waits, or something has gone wrong.
void BackgroundSink::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return !waiting_.empty() || closing_; });
    if (waiting_.empty()) return;
    OutputPicture picture = std::move(waiting_.front());
    waiting_.pop_front();
    changed_.notify_all();
    lock.unlock();
    Result<void> written = caught([&] { return sink_->put(std::move(picture)); });
    lock.lock();
    if (written) continue;
    problem_ = std::move(written);
    changed_.notify_all();
    return;
  }
}

void BackgroundSink::end() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

}  // namespace ribbon
