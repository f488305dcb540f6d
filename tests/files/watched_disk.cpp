#include "files/watched_disk.h"

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>

namespace ribbon {

namespace {

struct Watch {
  bool is_on = false;
  std::vector<std::string> calls;
  std::string refused;
  int error = 0;
  int times = 0;
  bool dawdles = false;
  int writes = 0;

  void note(const std::string& call, const std::filesystem::path& file) {
    std::string name = file.filename().string();
    if (const auto mark = name.rfind(".part"); mark != std::string::npos)
      name.erase(name.find_last_not_of("0123456789") + 1);
    if (is_on) calls.push_back(call + " " + name);
  }
  bool refuses(const std::string& call) {
    if (!is_on || times == 0 || call != refused) return false;
    --times;
    errno = error;
    return true;
  }
  // How many of so many bytes are written; 0: none, by an interruption.
  std::size_t taken(std::size_t count) {
    constexpr std::size_t a_few = 5;
    if (!is_on || !dawdles) return count;
    if (++writes % 2 == 0) return std::min(count, a_few);
    errno = EINTR;
    return 0;
  }
};

Watch watch;

int synced(int file, long call) {
  std::error_code code;
  watch.note("sync", std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(file), code));
  return watch.refuses("sync") ? -1 : static_cast<int>(::syscall(call, file));
}

}  // namespace

WatchedDisk::WatchedDisk() {
  watch = {};
  watch.is_on = true;
}

WatchedDisk::~WatchedDisk() {
  watch = {};
}

std::vector<std::string> WatchedDisk::calls() const {
  return watch.calls;
}

void WatchedDisk::refuse(const std::string& call, int error, int times) {
  watch.refused = call;
  watch.error = error;
  watch.times = times;
}

void WatchedDisk::dawdle() {
  watch.dawdles = true;
}

}  // namespace ribbon

extern "C" {

int fsync(int file) {
  return ribbon::synced(file, SYS_fsync);
}

int fdatasync(int file) {
  return ribbon::synced(file, SYS_fdatasync);
}

int link(const char* from, const char* to) {
  ribbon::watch.note("link", to);
  if (ribbon::watch.refuses("link")) return -1;
  return static_cast<int>(::syscall(SYS_linkat, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int rename(const char* from, const char* to) {
  ribbon::watch.note("rename", to);
  if (ribbon::watch.refuses("rename")) return -1;
  return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int close(int file) {
  const auto answer = static_cast<int>(::syscall(SYS_close, file));
  return ribbon::watch.refuses("close") ? -1 : answer;
}

ssize_t write(int file, const void* bytes, size_t count) {
  if (ribbon::watch.refuses("write")) return -1;
  const size_t taken = ribbon::watch.taken(count);
  return taken == 0 && count > 0 ? -1 : ::syscall(SYS_write, file, bytes, taken);
}

ssize_t pwrite(int file, const void* bytes, size_t count, off_t offset) {
  if (ribbon::watch.refuses("write")) return -1;
  const size_t taken = ribbon::watch.taken(count);
  return taken == 0 && count > 0 ? -1 : ::syscall(SYS_pwrite64, file, bytes, taken, offset);
}
}
