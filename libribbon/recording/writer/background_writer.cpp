#include "recording/writer/background_writer.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace ribbon {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds longest_unsynced{1};

}  // namespace

struct BackgroundWriter::State {
  explicit State(RecordingWriter target)
      : writer(std::move(target)), bytes(writer.bytes_written()) {}

  using Task = std::function<Result<void>(RecordingWriter&)>;

  RecordingWriter writer;  // of the thread alone

  mutable std::mutex mutex;  // guards everything below
  std::condition_variable changed;
  std::deque<Task> queue;
  bool closing = false;
  Result<void> problem;
  BackgroundFigures figures;
  std::uint64_t bytes = 0;

  std::thread thread;

  void add(Task task, Clock::time_point called);
  std::optional<Task> next(std::optional<Clock::time_point> sync_at);
  void run();
  void note(Result<void> outcome);
  void end();
};

void BackgroundWriter::State::add(Task task, Clock::time_point called) {
  {
    const std::lock_guard lock(mutex);
    queue.push_back(std::move(task));
    figures.longest_queue = std::max(figures.longest_queue, queue.size());
  }
  changed.notify_one();
  const double blocked_s = std::chrono::duration<double>(Clock::now() - called).count();
  const std::lock_guard lock(mutex);
  figures.blocked_s += blocked_s;
}

// The next task, once there is one; nothing when it is time to sync, or when all is done.
std::optional<BackgroundWriter::State::Task> BackgroundWriter::State::next(
    std::optional<Clock::time_point> sync_at) {
  std::unique_lock lock(mutex);
  const auto has_news = [this] { return !queue.empty() || closing; };
  if (sync_at)
    changed.wait_until(lock, *sync_at, has_news);
  else
    changed.wait(lock, has_news);
  if (queue.empty() || (sync_at && Clock::now() >= *sync_at)) return std::nullopt;
  Task task = std::move(queue.front());
  queue.pop_front();
  return task;
}

void BackgroundWriter::State::note(Result<void> outcome) {
  const std::lock_guard lock(mutex);
  if (problem && !outcome) problem = std::move(outcome);
  figures.writer = writer.figures();
  bytes = writer.bytes_written();
}

// Until end() is called and the queue is empty.
void BackgroundWriter::State::run() {
  std::optional<Clock::time_point> sync_at;  // set while something is not on the disk yet
  bool broken = false;
  while (true) {
    const auto task = next(sync_at);
    if (task) {
      if (broken) continue;
      auto outcome = (*task)(writer);
      broken = !outcome;
      note(std::move(outcome));
      if (!sync_at) sync_at = Clock::now() + longest_unsynced;
      continue;
    }
    if (std::exchange(sync_at, std::nullopt) && !broken) {
      auto outcome = writer.sync();
      broken = !outcome;
      note(std::move(outcome));
    }
    const std::lock_guard lock(mutex);
    if (closing && queue.empty()) return;
  }
}

void BackgroundWriter::State::end() {
  {
    const std::lock_guard lock(mutex);
    closing = true;
  }
  changed.notify_one();
  if (thread.joinable()) thread.join();
}

BackgroundWriter::BackgroundWriter(RecordingWriter writer)
    : state_(std::make_unique<State>(std::move(writer))) {
  state_->thread = std::thread([state = state_.get()] { state->run(); });
}

BackgroundWriter::~BackgroundWriter() {
  state_->end();
}

void BackgroundWriter::append(const FrameNumbers& numbers, const Eigen::Matrix3Xd& positions) {
  const auto called = Clock::now();
  state_->add(
      [numbers, positions](RecordingWriter& writer) { return writer.append(numbers, positions); },
      called);
}

void BackgroundWriter::append_checkpoint(std::uint64_t steps, std::string state) {
  const auto called = Clock::now();
  state_->add([steps, state = std::move(state)](
                  RecordingWriter& writer) { return writer.append_checkpoint(steps, state); },
              called);
}

void BackgroundWriter::append_session(const SessionNote& note) {
  const auto called = Clock::now();
  state_->add([note](RecordingWriter& writer) { return writer.append_session(note); }, called);
}

Result<void> BackgroundWriter::problem() const {
  const std::lock_guard lock(state_->mutex);
  return state_->problem;
}

Result<void> BackgroundWriter::finish(RunEnding ending) {
  state_->end();
  if (!state_->problem) return state_->problem;
  state_->note(state_->writer.finish(ending));
  return state_->problem;
}

BackgroundFigures BackgroundWriter::figures() const {
  const std::lock_guard lock(state_->mutex);
  return state_->figures;
}

std::uint64_t BackgroundWriter::bytes_written() const {
  const std::lock_guard lock(state_->mutex);
  return state_->bytes;
}

}  // namespace ribbon
