#include "commandline/interrupt.h"

#include <atomic>
#include <cassert>

namespace ribbon {

namespace {

// A signal handler can reach nothing else.
std::atomic<bool> interrupt_requested = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void request(int);

// Unless it is ignored.
void let_the_next_one_end_the_process(int signal) {
  struct sigaction now {};
  ::sigaction(signal, nullptr, &now);
  if (now.sa_handler != request) return;
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  ::sigaction(signal, &usual, nullptr);
}

void request(int) {
  interrupt_requested = true;
  let_the_next_one_end_the_process(SIGINT);
  let_the_next_one_end_the_process(SIGTERM);
}

struct sigaction handle(int signal) {
  struct sigaction handler {};
  handler.sa_handler = request;
  handler.sa_flags = SA_RESTART;
  struct sigaction old {};
  ::sigaction(signal, nullptr, &old);
  if (old.sa_handler != SIG_IGN) ::sigaction(signal, &handler, nullptr);
  return old;
}

}  // namespace

Interrupt::Interrupt() {
  interrupt_requested = false;
  for (std::size_t i = 0; i < signals.size(); ++i) old_[i] = handle(signals[i]);
  assert(old_[0].sa_handler != request);
}

Interrupt::~Interrupt() {
  for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &old_[i], nullptr);
}

bool Interrupt::requested() const {
  return interrupt_requested;
}

}  // namespace ribbon
