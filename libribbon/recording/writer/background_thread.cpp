// The thread of BackgroundWriter, and what is waiting for it.
#include <algorithm>
#include <utility>

#include "recording/writer/background_writer.h"
#include "result/caught.h"

namespace ribbon {

namespace {

constexpr std::chrono::seconds longest_unsynced{1};

// Between frames the caches are taken by the simulation: of tasks that are done together all but
// the first find their program and tables still there, which saves a third of their time.
constexpr std::chrono::milliseconds gathering{100};
constexpr std::size_t most_gathered = 8;

}  // namespace

BackgroundWriter::BackgroundWriter(RecordingWriter writer)
    : writer_(std::move(writer)), bytes_(writer_.bytes_written()), thread_([this] { run(); }) {}

BackgroundWriter::~BackgroundWriter() {
  end();
}

void BackgroundWriter::add(Task task) {
  std::size_t waiting = 0;
  {
    const std::lock_guard lock(mutex_);
    queue_.push_back(std::move(task));
    waiting = queue_.size();
    figures_.longest_queue = std::max(figures_.longest_queue, waiting);
  }
  if (waiting == 1 || waiting == most_gathered) changed_.notify_one();
}

// The next task, once there is one and others had time to gather behind it; nothing when it is time
// to sync, or when all is done.
std::optional<BackgroundWriter::Task> BackgroundWriter::next(
    std::optional<Clock::time_point> sync_at) {
  std::unique_lock lock(mutex_);
  if (queue_.empty()) {
    const auto has_news = [this] { return !queue_.empty() || closing_; };
    if (sync_at)
      changed_.wait_until(lock, *sync_at, has_news);
    else
      changed_.wait(lock, has_news);
    const auto gathered_at = Clock::now() + gathering;
    changed_.wait_until(lock, sync_at ? std::min(*sync_at, gathered_at) : gathered_at,
                        [this] { return closing_ || queue_.size() >= most_gathered; });
  }
  if (queue_.empty() || (sync_at && Clock::now() >= *sync_at)) return std::nullopt;
  Task task = std::move(queue_.front());
  queue_.pop_front();
  return task;
}

// Until end() is called and the queue is empty.
void BackgroundWriter::run() {
  std::optional<Clock::time_point> sync_at;  // set while something is not on the disk yet
  bool broken = false;
  const auto attempt = [&](const auto& work) {
    auto outcome = caught(work);
    broken = !outcome;
    note(std::move(outcome));
  };
  while (true) {
    const auto task = next(sync_at);
    if (task) {
      if (broken) continue;
      attempt([&] { return (*task)(writer_); });
      if (!sync_at) sync_at = Clock::now() + longest_unsynced;
      continue;
    }
    if (std::exchange(sync_at, std::nullopt) && !broken) attempt([&] { return writer_.sync(); });
    const std::lock_guard lock(mutex_);
    if (closing_ && queue_.empty()) return;
  }
}

void BackgroundWriter::end() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

}  // namespace ribbon
