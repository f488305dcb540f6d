#include "benchmarks/heap_use.h"

#include <malloc.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

extern "C" {

// What the C library calls its own functions when others have taken their names.
void* libc_malloc(std::size_t bytes) noexcept asm("__libc_malloc");
void* libc_calloc(std::size_t count, std::size_t bytes) noexcept asm("__libc_calloc");
void* libc_realloc(void* memory, std::size_t bytes) noexcept asm("__libc_realloc");
void* libc_memalign(std::size_t alignment, std::size_t bytes) noexcept asm("__libc_memalign");
void libc_free(void* memory) noexcept asm("__libc_free");

}  // extern "C"

namespace {

std::atomic<std::size_t> held_bytes = 0;
std::atomic<std::size_t> most_held_bytes = 0;
std::atomic<std::size_t> made = 0;

void* counted(void* memory) {
  if (memory == nullptr) return nullptr;
  made.fetch_add(1, std::memory_order_relaxed);
  const std::size_t bytes = malloc_usable_size(memory);
  const std::size_t now = held_bytes.fetch_add(bytes, std::memory_order_relaxed) + bytes;
  std::size_t most = most_held_bytes.load(std::memory_order_relaxed);
  while (most < now && !most_held_bytes.compare_exchange_weak(most, now, std::memory_order_relaxed))
    ;
  return memory;
}

void discount(void* memory) {
  if (memory != nullptr)
    held_bytes.fetch_sub(malloc_usable_size(memory), std::memory_order_relaxed);
}

}  // namespace

extern "C" {

void* malloc(std::size_t bytes) noexcept {
  return counted(libc_malloc(bytes));
}

void* calloc(std::size_t count, std::size_t bytes) noexcept {
  return counted(libc_calloc(count, bytes));
}

void* realloc(void* memory, std::size_t bytes) noexcept {
  discount(memory);
  void* moved = libc_realloc(memory, bytes);
  if (moved != nullptr || bytes == 0) return counted(moved);
  if (memory != nullptr) held_bytes += malloc_usable_size(memory);  // it was left as it was
  return nullptr;
}

void* memalign(std::size_t alignment, std::size_t bytes) noexcept {
  return counted(libc_memalign(alignment, bytes));
}

void* aligned_alloc(std::size_t alignment, std::size_t bytes) noexcept {
  return counted(libc_memalign(alignment, bytes));
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes) noexcept {
  void* made_here = counted(libc_memalign(alignment, bytes));
  if (made_here == nullptr) return ENOMEM;
  *memory = made_here;
  return 0;
}

void free(void* memory) noexcept {
  discount(memory);
  libc_free(memory);
}

}  // extern "C"

namespace benchmark {

HeapUse heap_use() {
  return {held_bytes, most_held_bytes, made};
}

void restart_heap_use() {
  most_held_bytes = held_bytes.load();
  made = 0;
}

}  // namespace benchmark
